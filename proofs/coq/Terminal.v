(** * Terminal problems: definitions, and what is proved of them

    Theorem 5 of the paper: a camera-minimal problem is reduced if and only if each of its features
    is one of the 27, or P/P/a, P/a/b, Pa/a/b, in which a pin dangles. A terminal problem
    (Definition 6) is camera-minimal, reduced, and does without Pa/P/a, Pa/a/b and Pab/a/b: it has
    P/P/a and P/a/b instead. All this up to the names of views and pins.

    Corollary 2: let each dangling pin have one more view. This makes a reduced minimal problem of a
    terminal one, with the same camera-degree. So label classes of terminal problems and swap&label
    classes of reduced minimal problems correspond. *)
From Coq Require Import NArith.
From mathcomp Require Import all_ssreflect all_algebra.
From PL1P Require Import Statement Reducible Reductions Problems CameraMinimal Replacements Degree.
Set Implicit Arguments.
Unset Strict Implicit.
Unset Printing Implicit Defensive.
Import GRing.Theory.

(** A pin that one view sees dangles: it can turn in the plane of its image. *)
Definition dangling_features := [::
  feat 1 a P P; feat 1 P a P; feat 1 P P a;                                    (* P/P/a *)
  feat 2 P a b; feat 2 a P b; feat 2 a b P;                                    (* P/a/b *)
  feat 2 Pa a b; feat 2 Pa b a; feat 2 a Pa b; feat 2 b Pa a; feat 2 a b Pa; feat 2 b a Pa].
Definition listed f := has (same f) (features ++ dangling_features).
(** Pa/P/a, Pa/a/b and Pab/a/b. *)
Definition replaced f := has (same f) (drop 6 dangling_features ++ [::
  feat 1 a P Pa; feat 1 a Pa P; feat 1 P a Pa; feat 1 Pa a P; feat 1 P Pa a; feat 1 Pa P a;
  feat 2 Pab b a; feat 2 b Pab a; feat 2 b a Pab]).
Definition terminal (F : fieldType) (A : problem) :=
  [/\ is_problem A, camera_minimal F A, reduced F A & ~~ has replaced A].

(** ** The lift: one more view of each dangling pin *)
Definition pins_seen f j := count (fun v => j \in sees_pins f v) views.
Definition loose f := [seq j <- iota 0 (pins f) | pins_seen f j == 1].
(** The last view that sees the point of pin j, but not the pin. *)
Definition mate f j := let p v := sees_point f v && (j \notin sees_pins f v) in
  if p V3 then V3 else if p V2 then V2 else V1.
Definition mates f := [seq (j, mate f j) | j <- loose f].
Fixpoint reveals f (js : seq (nat * view)) :=
  if js is (j, v) :: js' then reveals (reveal f j v) js' else f.
Definition lift f := reveals f (mates f).
(** The same up to swaps and the names of views, for problems of the 27 features. *)
Definition swap_same (A B : problem) := exists s t : signature,
  [/\ balanced s /\ balanced t, same_problem A (problem_of s), same_problem B (problem_of t) &
      swap_equiv s t].

(** ** What is proved, over every field F of characteristic 0 *)
Definition one_pin_each (A : problem) := all (fun f => pins f <= 1) A.
Definition dangling_pins : Prop := forall F : fieldType, [char F]%R =i pred0 ->
  forall A, is_problem A ->
  (all listed A -> reduced F A) /\ (camera_minimal F A -> reduced F A -> all listed A).
Definition terminality : Prop := forall F : fieldType, [char F]%R =i pred0 ->
  problem_classes label_same (terminal F) 74575 /\
  problem_classes label_same (fun A => terminal F A /\ one_pin_each A) 9533.
Definition correspondence : Prop := forall F : fieldType, [char F]%R =i pred0 ->
  [/\ forall A, terminal F A -> minimal_and_reduced F (map lift A) /\
        forall d, camera_degree F A d <-> degree F (map lift A) d,
      forall A B, terminal F A -> terminal F B ->
        label_same A B <-> swap_same (map lift A) (map lift B) &
      forall B, minimal_and_reduced F B -> exists2 A, terminal F A & swap_same (map lift A) B].
