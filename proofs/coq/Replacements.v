(** * One more view of a pin: definitions, and what is proved

    A pin dangles if at most one view sees it. Another view sees its point. If it sees the pin too, it
    learns nothing about the cameras. Lemma 11 of the paper: the problem with that view is
    camera-minimal if and only if the problem without it is. Corollary 1: which of two views sees the
    pin does not matter, so Pa/P/a and P/Pa/a can be swapped in any problem. *)
From mathcomp Require Import all_ssreflect all_algebra.
From PL1P Require Import Statement Problems CameraMinimal.
Set Implicit Arguments.
Unset Strict Implicit.
Unset Printing Implicit Defensive.
Import GRing.Theory.

Definition same_view v w := match v, w with V1, V1 | V2, V2 | V3, V3 => true | _, _ => false end.
(** View v of feature f sees pin j too. *)
Definition reveal f j v := Feature (free f) (pins f) (fun w =>
  if same_view w v then (sees_point f w, j :: sees_pins f w) else looks f w).
(** View v sees the point of pin j, but not pin j; no view does but perhaps u. *)
Definition dangles f j u v := [&& ~~ free f, j < pins f, sees_point f v, j \notin sees_pins f v,
  ~~ same_view u v & all (fun w => (j \in sees_pins f w) ==> same_view w u) views].

Definition replacements : Prop := forall F : fieldType, [char F]%R =i pred0 ->
  forall A f B j u, is_problem (A ++ f :: B) ->
  (forall v, dangles f j u v ->
     camera_minimal F (A ++ f :: B) <-> camera_minimal F (A ++ reveal f j v :: B)) /\
  (forall v w, dangles f j u v -> dangles f j u w ->
     minimal F (A ++ reveal f j v :: B) <-> minimal F (A ++ reveal f j w :: B)).
