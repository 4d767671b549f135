(** * What is computed for the point in normal form (NormalPool.v): all that Tree.v asks for *)
From Coq Require Import ZArith Uint63.
From mathcomp Require Import all_ssreflect all_algebra.
From mathcomp.zify Require Import ssrZ.
From PL1P Require Import Statement Rigid Walk Elimination Forms Tree NormalPool.
Local Notation ZR := [idomainType of Z].

Definition normal_cameras : view -> camera ZR :=
  by_view (Camera (@Quat ZR 1%R 0%R 0%R 0%R) (vec0 ZR)) camera2 camera3.
Definition normal_table := Eval vm_compute in rows_table (PointData normal_cameras pool [::]).
Definition normal_point := PointData normal_cameras pool normal_table.

Lemma normal_checked : checked normal_point.
Proof.
split; [by [] | by vm_compute | by vm_compute | by vm_compute | by vm_compute | by vm_compute |].
vm_cast_no_check (erefl true).
Qed.
