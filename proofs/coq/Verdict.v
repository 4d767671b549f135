(** * A verdict that is computed, and proved

    [verdict A] is None if A has a feature that is not one of the 27; else it says whether A is
    minimal, by counting features. *)
From mathcomp Require Import all_ssreflect all_algebra.
From PL1P Require Import Statement Rigid Reducible Problems SameProblem Minimal ProblemClasses.
Set Implicit Arguments.
Unset Strict Implicit.
Unset Printing Implicit Defensive.

Definition verdict (A : problem) : option bool :=
  if is_problem A && known A
  then Some (balanced (signature_of A) && ~~ obstructed (signature_of A)) else None.
Definition verdicts : Prop := forall F : fieldType, [char F]%R =i pred0 ->
  forall A b, verdict A = Some b -> minimal F A <-> b.

Theorem verdicts_theorem : verdicts.
Proof.
move=> F char0 A b; rewrite /verdict; case pk: (is_problem A && known A) => // -[<-].
case/andP: pk => pA kA; split=> [mA|/andP[bs us]].
  have [bs mS] := minimal_signature char0 pA mA kA.
  by rewrite bs; exact/(minimal_iff char0 bs).
have mS := (minimal_iff char0 bs).2 us.
exact: (same_minimal char0 pA (problem_of_proper _) (known_same kA)).2 mS.
Qed.
