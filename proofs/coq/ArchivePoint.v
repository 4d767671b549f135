(** * What is computed for the point of the classification archive (Pool.v): all that Tree.v asks
    for *)
From Coq Require Import ZArith Uint63.
From mathcomp Require Import all_ssreflect all_algebra.
From mathcomp.zify Require Import ssrZ.
From PL1P Require Import Statement Rigid Walk Elimination Forms Tree Pool.
Local Notation ZR := [idomainType of Z].

Definition archive_cameras : view -> camera ZR :=
  by_view (Camera (@Quat ZR 1%R 0%R 0%R 0%R) (vec0 ZR)) camera2 camera3.
Definition archive_table := Eval vm_compute in rows_table (PointData archive_cameras pool [::]).
Definition archive_point := PointData archive_cameras pool archive_table.

Lemma archive_checked : checked archive_point.
Proof.
split; [by [] | by vm_compute | by vm_compute | by vm_compute | by vm_compute | by vm_compute |].
vm_cast_no_check (erefl true).
Qed.
