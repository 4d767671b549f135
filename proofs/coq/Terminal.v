(** * Terminal problems: definitions, and what is proved of them

    A terminal problem (Definition 6 of the paper) is camera-minimal, and does without the features
    Pa/P/a and Pab/a/b: it has P/P/a and P/a/b instead, in which a pin dangles. So each of its
    features is one of the list [terminal_features]. That problems of these features are reduced,
    and that a reduced camera-minimal problem has no others than these and those it does without, is
    Theorem 5 of the paper; it is not proved here. *)
From Coq Require Import NArith.
From mathcomp Require Import all_ssreflect all_algebra.
From PL1P Require Import Statement Reductions Problems CameraMinimal.
Set Implicit Arguments.
Unset Strict Implicit.
Unset Printing Implicit Defensive.
Import GRing.Theory.

(** The 27 features, with P/P/a for both Pa/P/a and P/Pa/a (12 to 17), and P/a/b for Pab/a/b. *)
Definition terminal_features := take 12 features ++ [::
  feat 1 a P P; feat 1 a P P; feat 1 P a P; feat 1 P a P; feat 1 P P a; feat 1 P P a;  (* 12 .. 17 *)
  feat 0 o P P; feat 0 P o P; feat 0 P P o;                                            (* 18 .. 20 *)
  feat 1 P a a; feat 1 a P a; feat 1 a a P;                                            (* 21 .. 23 *)
  feat 2 P b a; feat 2 b P a; feat 2 b a P].                                           (* 24 .. 26 *)
Definition terminal_index f := find (same f) terminal_features.
Definition terminal (F : fieldType) (A : problem) :=
  [/\ is_problem A, camera_minimal F A & all (fun f => terminal_index f < 27) A].
Definition one_pin_each (A : problem) := all (fun f => pins f <= 1) A.

(** ** What is proved, over every field F of characteristic 0 *)
Definition terminality : Prop := forall F : fieldType, [char F]%R =i pred0 ->
  problem_classes label_same (terminal F) 74575 /\
  problem_classes label_same (fun A => terminal F A /\ one_pin_each A) 9533.
