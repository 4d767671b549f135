(** * Camera-minimal problems: the definition, and how it differs from minimal

    Of a camera-minimal problem, generic images have finitely many solutions for the cameras, and at
    least one; points and lines may stay open. So a problem is minimal if and only if it is
    camera-minimal and balanced. *)
From mathcomp Require Import all_ssreflect all_algebra.
From SsrMultinomials Require Import mpoly.
From PL1P Require Import Statement Problems Reductions Embedding Scenes.
Set Implicit Arguments.
Unset Strict Implicit.
Unset Printing Implicit Defensive.
Import GRing.Theory.

Section Definitions.
Local Open Scope ring_scope.
(** u is a root of a polynomial that is not zero and has its coefficients in F[y]. *)
Definition determined (F : fieldType) n (y : seq [fieldType of {fraction {mpoly F[n]}}]) u :=
  exists2 p, map_poly (@at_y F n y) p != 0 & root (map_poly (at_y y) p) u.
(** The joint camera map is dominant, and the 11 parameters of the cameras are algebraic over the
    coordinates of the images. *)
Definition camera_minimal (F : fieldType) (A : problem) :=
  let n := parameters A in let y := images F n A in
  independent y /\ forall k, (k < 11)%N -> determined y (generic F n k).
End Definitions.

Definition camera_minimality : Prop := forall F : fieldType, [char F]%R =i pred0 -> forall A,
  minimal F A <-> camera_minimal F A /\ is_balanced A.

Theorem camera_minimal_theorem : camera_minimality.
Proof.
move=> F char0 A; split=> [mA|[[iA _] bA]]; last exact/(balanced_dominant char0).
have [bA iA] := (balanced_dominant char0 A).1 mA; split=> //; split=> // k _; exact: (proj2 mA).
Qed.
