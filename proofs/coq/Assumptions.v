(** Prints the axioms on which the main theorem rests; the Makefile compares them with those expected. *)
From PL1P Require Import Statement Main.
Definition proved : classification := main_theorem.
Print Assumptions proved.
