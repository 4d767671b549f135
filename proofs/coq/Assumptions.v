(** Prints the axioms of each theorem; the Makefile compares them with those expected. *)
From PL1P Require Import Main Reduction GenericImages ProblemClasses OneReduction Reader Verdict
  CameraMinimal Dangling TerminalClasses Listed Lemma1 DegreeKept.
Print Assumptions main_theorem.
Print Assumptions rigidity_theorem.
Print Assumptions reduction_theorem.
Print Assumptions five_points_theorem.
Print Assumptions problems_theorem.
Print Assumptions reductions_theorem.
Print Assumptions camera_minimal_theorem.
Print Assumptions replacements_theorem.
Print Assumptions dangling_pins_theorem.
Print Assumptions terminal_theorem.
Print Assumptions correspondence_theorem.
Print Assumptions reader_theorem.
Print Assumptions verdicts_theorem.
Print Assumptions lemma1_theorem.
Print Assumptions degrees_theorem.
