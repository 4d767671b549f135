(** Prints the axioms on which the theorems rest; the Makefile compares them with those expected. *)
From PL1P Require Import Statement Rigid Reducible Main Reduction.
Definition proved : classification /\ rigidity /\ reduction :=
  Logic.conj main_theorem (Logic.conj rigidity_theorem reduction_theorem).
Print Assumptions proved.
