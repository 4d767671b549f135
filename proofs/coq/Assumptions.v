From PL1P Require Import Main.
Print Assumptions main_theorem.
