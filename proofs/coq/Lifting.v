(** * What is kept and the images of what is forgotten determine all images

    Here in terms of derivations: one that kills the cameras, what is kept, and the images of what
    is forgotten kills all images ([local_killed], for one feature). *)
From mathcomp Require Import all_ssreflect all_algebra.
From mathcomp.algebra_tactics Require Import ring.
From mathcomp.zify Require Import zify.
From SsrMultinomials Require Import mpoly.
From PL1P Require Import Statement Reducible Forget Derivations RationalFunctions Independence.
Set Implicit Arguments.
Unset Strict Implicit.
Unset Printing Implicit Defensive.
Import GRing.Theory.
Local Open Scope ring_scope.

(** ** What a derivation kills *)
Section Killed.
Variables (F K : fieldType) (c0 : {rmorphism F -> K}) (D : K -> K).
Hypothesis hD : derivation c0 D.
Notation Z a := (D a = 0).
Lemma zN a : Z a -> Z (- a). Proof. by move=> h; rewrite (derN hD) h oppr0. Qed.
Lemma zD a b : Z a -> Z b -> Z (a + b). Proof. by move=> h1 h2; rewrite (derD hD) h1 h2 addr0. Qed.
Lemma zM a b : Z a -> Z b -> Z (a * b). Proof.
by move=> h1 h2; rewrite (derM hD) h1 h2 mulr0 mul0r addr0. Qed.
Lemma zMn a : Z a -> Z (a *+ 2). Proof. by move=> h; rewrite mulr2n; exact: zD. Qed.
Lemma zX a : Z a -> Z (a ^+ 2). Proof. by move=> h; rewrite expr2; exact: zM. Qed.
Lemma zV a : Z a -> Z a^-1.
Proof.
move=> h; have [->|a0] := eqVneq a 0; first by rewrite invr0 (der0 hD).
by rewrite -div1r (der_div hD) // (der1 hD) h mul0r mulr0 subrr mul0r.
Qed.
Ltac kill := repeat first [assumption | exact: (der0 hD) | exact: (der1 hD) |
  apply: zD | apply: zN | apply: zM | apply: zMn | apply: zX | apply: zV].

Definition dead (u : vec K) := [/\ Z (x1 u), Z (x2 u) & Z (x3 u)].
Definition dead_camera (C : camera K) :=
  [/\ Z (qa (quat_of C)), Z (qb (quat_of C)), Z (qc (quat_of C)), Z (qd (quat_of C)) & dead (trans C)].
Lemma dead_add u w : dead u -> dead w -> dead (add u w).
Proof. by case=> ? ? ? [? ? ?]; split; rewrite /=; kill. Qed.
Lemma dead_cross u w : dead u -> dead w -> dead (cross u w).
Proof. by case=> ? ? ? [? ? ?]; split; rewrite /=; kill. Qed.
Lemma dead_turn C u : dead_camera C -> dead u -> dead (turn C u).
Proof.
case: C => [[a b c d] t] [/= ? ? ? ? _] [? ? ?]; rewrite /turn /rot /dot /=; split; rewrite /=; kill.
Qed.
Lemma dead_project C u : dead_camera C -> dead u -> dead (project C u).
Proof. by move=> hC hu; apply: dead_add; [exact: dead_turn | case: hC]. Qed.
Lemma dead_normal C X d : dead_camera C -> dead X -> dead d -> dead (normal C X d).
Proof. by move=> hC hX hd; apply: dead_cross; [exact: dead_project | exact: dead_turn]. Qed.
Lemma dead_point x : dead x -> killed D (point_image x).
Proof. by case=> h1 h2 h3; rewrite /killed /= !(introT eqP) //; kill. Qed.
Lemma dead_line p n : dead n -> killed D (line_image p n).
Proof. by case=> h1 h2 h3; case: p; rewrite /killed /= !(introT eqP) //; kill. Qed.
Lemma killed_cat s t : killed D (s ++ t) = killed D s && killed D t.
Proof. exact: all_cat. Qed.
Lemma killed_flatten T (g : T -> seq K) (l : seq T) : killed D (flatten [seq g i | i <- l]) =
  all (fun i => killed D (g i)) l.
Proof. by elim: l => //= i l IH; rewrite killed_cat IH. Qed.

Lemma dead_image fx C l : dead_camera C -> dead (point_at fx.1 fx.2) ->
  (forall j, j \in l.2 -> dead (dir_at fx.1 fx.2 j)) -> killed D (image fx C l).
Proof.
move=> hC hX hd; rewrite /image killed_cat; apply/andP; split.
  by case: (l.1) => //; apply: dead_point; exact: dead_project.
by rewrite killed_flatten; apply/allP => j jl; apply: dead_line; apply: dead_normal => //; exact: hd.
Qed.

(** The other coordinate of a point on a line. *)
Lemma on_line (n x : vec K) : dead n -> x2 n != 0 -> x3 x != 0 -> dot n x = 0 -> Z (x1 x / x3 x) ->
  Z (x2 x / x3 x).
Proof.
case=> h1 h2 h3 n2 x30 e h.
have -> : x2 x / x3 x = - (x3 n + x1 n * (x1 x / x3 x)) / x2 n.
  apply/eqP; rewrite eq_sym -subr_eq0; apply/eqP.
  transitivity (- dot n x / (x2 n * x3 x)); last by rewrite e oppr0 mul0r.
  by rewrite /dot; field; rewrite n2 x30.
by kill.
Qed.

(** The image of a line does not depend on its point. *)
Lemma normal_slide (C : camera K) X d k : normal C X d = normal C (add X (scale k d)) d.
Proof.
case: C => [[q1 q2 q3 q4] [t1 t2 t3]]; case: X => a b e; case: d => a' b' e'.
by rewrite /normal /project /turn /cross /add /scale /rot /dot /=; congr Vec; ring.
Qed.

(** ** One feature: what is kept and the images of what is lost give all images *)
Lemma local_killed f x c v (C : camera K) : let X := point_at f x in proper f -> feasible f c ->
  dead_camera C ->
  (~~ free f -> sees_point f v -> x3 (project C X) != 0) ->
  (~~ free f -> forall j, (j < pins f)%N -> x2 (normal C X (dir_at f x j)) != 0) ->
  (~~ nothing (keep f c) -> killed D (kept_parameters (f, x) c)) ->
  killed D (lost_image (f, x) c C (looks f v)) -> killed D (image (f, x) C (looks f v)).
Proof.
move=> X pf /and3P[uc ac fc] hC rx rn hk; have [u le sp] := properP v pf.
rewrite /lost_image /image !killed_cat !killed_flatten /= -/X => /andP[lp ll].
have kept j : j \in c.2 -> dead (dir_at f x j) /\ dead (normal C X (dir_at f x j)) /\ (c.1 -> dead X).
  move=> jc; have {}hk : killed D (kept_parameters (f, x) c).
    by apply: hk; rewrite /nothing /= negb_and; apply/orP; right; case: (c.2) jc.
  move: hk; rewrite /kept_parameters killed_cat killed_flatten /= -/X => /andP[hY /allP/(_ j jc)].
  rewrite /= andbT => /andP[/eqP d1 /eqP d2].
  have hd : dead (dir_at f x j) by split=> //=; exact: (der1 hD).
  have hX : (c.1 -> dead X) /\ dead (if c.1 then X else add X (scale (- x3 X) (dir_at f x (head 0%N c.2)))).
    move: hY; set Y := if c.1 then X else _ => hY.
    have y3 : D (x3 Y) = 0.
      move: hY; case fr: (free f || ~~ c.1) => /= /andP[_ /andP[_ hY]]; last by move: hY;
        rewrite andbT => /eqP.
      rewrite /Y; case c1: (c.1) fr; first by rewrite orbF => fr; rewrite /X /= fr (der0 hD).
      by move=> _; rewrite /= mulr1 subrr (der0 hD).
    have hY' : dead Y by split=> //; move: hY; case: ifP => _ /= /and3P[/eqP ? /eqP].
    by split=> //; move: hY'; rewrite /Y; case: (c.1).
  case: hX => hX hY'; split=> //; split=> //.
  case c1: (c.1) hY' fc => hY' /= fc; first by apply: dead_normal.
  have -> : normal C X (dir_at f x j) = normal C (add X (scale (- x3 X) (dir_at f x (head 0%N c.2))))
    (dir_at f x j).
    have -> : head 0%N c.2 = j by move: jc fc; case: (c.2) => [|i [|]] //=; rewrite inE => /eqP ->.
    exact: normal_slide.
  exact: dead_normal.
have lines : all (fun j => killed D (line_image (looks f v).1 (normal C X (dir_at f x j)))) (looks f v).2.
  apply/allP => j jl; have [jc|jc] := boolP (j \in c.2); first by apply: dead_line; case: (kept j jc) => _ [].
  by apply: (allP ll); rewrite mem_filter jc.
rewrite lines andbT; move: lp rx; rewrite -/(sees_point f v); case p: (sees_point f v) sp => //=.
case fr: (free f) => //= _; case c1: (c.1) fc => /= fc; last first.
  case: ifP => // /hasP[j jl jc]; rewrite /killed /= !andbT => /eqP lp /(_ isT isT) x30; rewrite lp eqxx /=;
    apply/eqP.
  have [_ [hn _]] := kept j jc; apply: (on_line (x := project C X) hn _ x30 _ lp).
    by apply: rn; rewrite ?fr //; exact: (allP le).
  by rewrite /normal /dot /cross /=; ring.
move=> _ _; have : killed D (kept_parameters (f, x) c) by apply: hk; rewrite /nothing /= fr c1.
rewrite /kept_parameters killed_cat /= fr c1 /= -/X => /andP[/and4P[/eqP h1 /eqP h2 /eqP h3 _] _].
have hX : dead X by [].
exact: (dead_point (dead_project hC hX)).
Qed.
End Killed.
