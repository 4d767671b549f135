(** Prints the axioms on which the theorems rest; the Makefile compares them with those expected. *)
From PL1P Require Import Statement Rigid Reducible FivePoints Main Reduction GenericImages.
Definition proved : (classification /\ rigidity) /\ reduction /\ five_points :=
  Logic.conj (Logic.conj main_theorem rigidity_theorem) (Logic.conj reduction_theorem five_points_theorem).
Print Assumptions proved.
