(** Prints the axioms on which the theorems rest; the Makefile compares them with those expected. *)
From PL1P Require Import Statement Rigid Main.
Definition proved : classification /\ rigidity := Logic.conj main_theorem rigidity_theorem.
Print Assumptions proved.
