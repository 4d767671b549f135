(** * Problems, not signatures: definitions, and what is proved of them

    Two problems are the same if they differ only in the order of their features and in the names of
    the pins, or in the order in which a look lists its pins. *)
From Coq Require Import NArith Permutation.
From mathcomp Require Import all_ssreflect all_algebra.
From PL1P Require Import Statement Rigid Reducible.
Set Implicit Arguments.
Import GRing.Theory.

Definition same_problem (A B : problem) := exists2 A', Permutation A A' & all2 same A' B.
(** The same up to the names of the views, too. *)
Definition relabel_problem g (A : problem) := [seq relabel_feature g f | f <- A].
Definition label_same (A B : problem) :=
  exists2 g : view -> view, injective g & same_problem (relabel_problem g A) B.
(** The problems with property Q form n classes of E: there are n representatives, they have Q, no
    two of them are equivalent, and whatever has Q is equivalent to one of them. *)
Definition problem_classes (E : problem -> problem -> Prop) (Q : problem -> Prop) (n : N) :=
  exists reps : seq problem, let r := nth [::] reps in
  [/\ N.of_nat (size reps) = n, forall i, i < size reps -> Q (r i),
      forall i j, i < size reps -> j < size reps -> E (r i) (r j) -> i = j &
      forall A, Q A -> exists2 i, i < size reps & E A (r i)].

(** ** What is proved, over every field F of characteristic 0 *)
Definition minimal_and_reduced F A := [/\ is_problem A, minimal F A & reduced F A].
Definition problems : Prop := forall F : fieldType, [char F]%R =i pred0 ->
  (forall A, is_problem A -> minimal F A <->
     sumn [seq dim2 f | f <- A] = parameters A /\ independent (images F (parameters A) A)) /\
  (forall A, is_problem A -> minimal F A /\ reduced F A <->
     exists s, [/\ balanced s, ~~ obstructed s & same_problem A (problem_of s)]) /\
  problem_classes label_same (minimal_and_reduced F) 140616.
