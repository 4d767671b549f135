(** * Reducible problems: definitions, and what is proved of them

    A problem is reduced if nothing can be forgotten that images can lift. By [reduction], a minimal
    problem is reduced if and only if it consists of the 27 features: Theorem 3 of the paper. *)
From mathcomp Require Import all_ssreflect all_algebra.
From SsrMultinomials Require Import mpoly.
From PL1P Require Import Statement.
Set Implicit Arguments.
Import GRing.Theory.

(** ** Forgetting points and lines (section 3 of the paper)

    A selection says what is kept of a feature: (the point?, which pins, in their new order). A pin
    that loses its point is a free line. [feasible]: a point that is forgotten keeps at most one of
    its pins. [forgets]: of each feature a feasible selection, and not all of everything. *)
Definition selection := (bool * seq nat)%type.
Definition keep f (c : selection) := Feature (free f || ~~ c.1) (size c.2) (fun v =>
  (sees_point f v && c.1, [seq index j c.2 | j <- sees_pins f v & j \in c.2])).
Definition nothing f := free f && (pins f == 0).
Definition feasible f (c : selection) :=
  [&& uniq c.2, all (fun j => j < pins f) c.2 & c.1 || (size c.2 <= 1)].
Definition whole f (c : selection) := (free f || c.1) && (size c.2 == pins f).
Definition forgets (A : problem) (cs : seq selection) := [&& size cs == size A,
  all (fun fc => feasible fc.1 fc.2) (zip A cs) & ~~ all (fun fc => whole fc.1 fc.2) (zip A cs)].

(** ** The lifting property (Definition 5) *)
Section Kept.
Variable R : idomainType.
Local Open Scope ring_scope.
(** The parameters of what is kept. Where a pin loses its point, its new point has x3 = 0. *)
Definition kept_parameters (fx : feature * (nat -> R)) (c : selection) :=
  let X := point_at fx.1 fx.2 in let d := dir_at fx.1 fx.2 in
  let Y := if c.1 then X else add X (scale (- x3 X) (d (head 0%N c.2))) in
  (if free (keep fx.1 c) then [:: x1 Y; x2 Y] else [:: x1 Y; x2 Y; x3 Y]) ++
  flatten [seq [:: x1 (d j); x2 (d j)] | j <- c.2].
End Kept.
Arguments kept_parameters {R}.
Section Lost.
Variable K : fieldType.
Local Open Scope ring_scope.
(** The images of what is forgotten. A point on the image of a pin that is kept has one coordinate.
    *)
Definition lost_image (fx : feature * (nat -> K)) (c : selection) (C : camera K) (l : look) : seq K :=
  let X := point_at fx.1 fx.2 in let x := project C X in
  (if l.1 && ~~ c.1 then if has (mem c.2) l.2 then [:: x1 x / x3 x] else point_image x else [::]) ++
  flatten [seq line_image l.1 (normal C X (dir_at fx.1 fx.2 j)) | j <- l.2 & j \notin c.2].
End Lost.
Section Lifting.
Variables (F : fieldType) (n : nat) (A : problem).
Local Notation generic := (generic F n).
Local Notation scene_of := (scene_of F n A).
(** The lifting property: generic S' and, for what is forgotten, generic images in the fibre come
    from a common S. So their coordinates are independent. *)
Definition lifting (cs : seq selection) := independent (mkseq generic 11 ++
  flatten [seq kept_parameters fxc.1 fxc.2 | fxc <- zip scene_of cs & ~~ nothing (keep fxc.1.1 fxc.2)] ++
  flatten [seq each_view (fun C v => lost_image fxc.1 fxc.2 C (looks fxc.1.1 v)) | fxc <- zip scene_of cs]).
End Lifting.
Section Reduced.
Variable F : fieldType.
Definition reducible A cs := forgets A cs /\ lifting F (parameters A) A cs.
Definition reduced A := forall cs, ~ reducible A cs.
End Reduced.

(** ** What is proved *)
Definition known (A : problem) := all (fun f => index_of f < 27) A.
(** A minimal problem that is reduced consists of the 27 features. All problems of the 27 features
    are reduced. *)
Definition reduction : Prop := forall F : fieldType, [char F]%R =i pred0 ->
  forall A, is_problem A -> (known A -> reduced F A) /\ (minimal F A -> reduced F A -> known A).
