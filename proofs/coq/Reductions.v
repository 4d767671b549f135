(** * Theorems 1 and 2 of the paper: definitions, and what is proved

    A problem reduces to what is kept of it if images can be lifted. Theorem 1, for *minimal*: what a
    minimal problem reduces to is minimal. Theorem 2: it reduces to a reduced problem, and to one
    only. Conversely, a balanced problem that reduces to a minimal one is minimal. *)
From mathcomp Require Import all_ssreflect all_algebra.
From PL1P Require Import Statement Reducible Problems.
Set Implicit Arguments.
Import GRing.Theory.

(** What is kept of A, if cs says what of each feature. [reduces]: perhaps nothing is forgotten. *)
Definition selects (A : problem) (cs : seq selection) :=
  (size cs == size A) && all (fun fc => feasible fc.1 fc.2) (zip A cs).
Definition kept (A : problem) (cs : seq selection) : problem :=
  [seq keep fc.1 fc.2 | fc <- zip A cs & ~~ nothing (keep fc.1 fc.2)].
Definition reduces F A cs := selects A cs /\ lifting F (parameters A) A cs.
(** As many degrees of freedom in the images as those of cameras and scene. *)
Definition is_balanced A := sumn [seq dim2 f | f <- A] = parameters A.

Definition reductions : Prop := forall F : fieldType, [char F]%R =i pred0 -> forall A, is_problem A ->
  [/\ forall cs, minimal F A -> reduces F A cs -> minimal F (kept A cs),
      forall cs, minimal F (kept A cs) -> reduces F A cs -> is_balanced A -> minimal F A,
      minimal F A -> (exists2 cs, reduces F A cs & reduced F (kept A cs)) &
      forall cs ds, minimal F A -> reduces F A cs -> reduced F (kept A cs) ->
        reduces F A ds -> reduced F (kept A ds) -> same_problem (kept A cs) (kept A ds)].
