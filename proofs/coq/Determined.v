(** * Pins that two views determine

    A pin is droppable if it has two image coordinates, and two views see it and its point. It is the
    line in which two planes meet, so the rest of the problem is minimal if and only if the problem
    is ([minimal_lighter]). *)
From mathcomp Require Import all_ssreflect all_algebra.
From mathcomp.algebra_tactics Require Import ring.
From mathcomp.zify Require Import zify.
From SsrMultinomials Require Import mpoly.
From PL1P Require Import Statement Reducible Problems Reductions Forget Derivations RationalFunctions
  Independence Generic Motion Lifting Reduction Embedding Scenes Keeps Theorem1.
Set Implicit Arguments.
Unset Strict Implicit.
Unset Printing Implicit Defensive.
Import GRing.Theory.

Definition pairs_of_views := [:: (V1, V2); (V1, V3); (V2, V3)].
Definition sees_both f j v := sees_point f v && (j \in sees_pins f v).
Definition droppable f j := [&& ~~ free f, share f j == 2 &
  has (fun uv => sees_both f j uv.1 && sees_both f j uv.2) pairs_of_views].
Definition lighter f : selection := (true, [seq j <- iota 0 (pins f) | ~~ droppable f j]).
(** What is left without the droppable pins, if that costs nothing. (It never does.) *)
Definition lighten (A : problem) : problem := let cs := map lighter A in
  if sumn [seq cost fc.1 fc.2 | fc <- zip A cs] <= sumn [seq dim3 f | f <- A] then kept A cs else A.

Lemma lighter_selects A : selects A (map lighter A).
Proof.
elim: A => // f A IH; rewrite [map _ _]/= selects_cons IH andbT /feasible /= filter_uniq ?iota_uniq // andbT.
by apply/allP => j; rewrite mem_filter mem_iota => /andP[].
Qed.
Lemma lighter_remains f : proper f -> ~~ nothing (keep f (lighter f)).
Proof.
move=> pf; rewrite /nothing /= orbF; case fr: (free f) => //=.
by rewrite size_filter (free_pins pf fr) /= /droppable fr.
Qed.

Local Open Scope ring_scope.
Section Killed.
Variables (F K : fieldType) (c0 : {rmorphism F -> K}) (D : K -> K).
Hypothesis hD : derivation c0 D.
Ltac kill := repeat first [assumption | exact: (der0 hD) | exact: (der1 hD) | apply: (zD hD) |
  apply: (zN hD) | apply: (zM hD) | apply: (zMn hD) | apply: (zX hD)].
Lemma turn_still (C : camera K) u : dead_camera D C -> dvec D (turn C u) = turn C (dvec D u).
Proof.
have dm m w : dead D m -> D (dot m w) = dot m (dvec D w).
  by case=> e1 e2 e3; rewrite (d_dot hD) /dvec e1 e2 e3 /dot /= !mul0r !add0r.
by case: C => -[a b c d] t [/= ? ? ? ? _]; rewrite /turn /rot /dvec /=; congr Vec; apply: dm;
  split; rewrite /=; kill.
Qed.
Lemma plane_still (C : camera K) X d : dead_camera D C -> dead D X -> x3 (project C X) != 0 ->
  x2 (normal C X d) != 0 -> D (x1 (normal C X d) / x2 (normal C X d)) = 0 ->
  dot (normal C X d) (turn C (dvec D d)) = 0.
Proof.
move=> hC hX x30 n20 z; rewrite -(turn_still d hC).
have [e1 e2 e3] := dead_project hD hC hX.
have dx : dvec D (project C X) = vec0 K by rewrite /dvec e1 e2 e3.
have add0 (w w0 : vec K) : add w (scale 0 w0) = w by case: w => ? ? ?; rewrite /add /scale /= !mul0r !addr0.
have := @slope_killed _ _ _ _ hD (project C X) (turn C d) 0 0 x30 n20.
have z0 w : dot w (vec0 K) == 0 by rewrite /dot /= !mulr0 !addr0.
rewrite !add0 dx !z0 => /(_ isT) h; by apply/eqP; rewrite -h; apply/eqP.
Qed.
Lemma plane_sum (C : camera K) (n : vec K) a b :
  dot n (turn C (@Vec K a b 0)) = a * dot n (turn C (@Vec K 1 0 0)) + b * dot n (turn C (@Vec K 0 1 0)).
Proof. by case: C => -[q1 q2 q3 q4] t; case: n => n1 n2 n3; rewrite /turn /rot /dot /=; ring. Qed.
Lemma two_planes (a b au bu av bv : K) : au * bv - av * bu != 0 -> a * au + b * bu = 0 ->
  a * av + b * bv = 0 -> a = 0 /\ b = 0.
Proof.
move=> d0 e1 e2; split; apply: (mulIf d0); rewrite mul0r.
  by transitivity (bv * (a * au + b * bu) - bu * (a * av + b * bv)); [ring | rewrite e1 e2 !mulr0 subr0].
by transitivity (au * (a * av + b * bv) - av * (a * au + b * bu)); [ring | rewrite e1 e2 !mulr0 subr0].
Qed.

(** ** One feature *)
Variables (f : feature) (x : nat -> K) (C : view -> camera K).
Notation X := (point_at f x).
Notation d j := (dir_at f x j).
Hypothesis hC : forall v, dead_camera D (C v).
Hypothesis points : free f = false -> forall v, x3 (project (C v) X) != 0.
Hypothesis lines : free f = false -> forall v j, (j < pins f)%N -> x2 (normal (C v) X (d j)) != 0.
Hypothesis meet : free f = false -> forall u v j, u <> v -> (j < pins f)%N ->
  dot (normal (C u) X (d j)) (turn (C u) (@Vec K 1 0 0)) *
  dot (normal (C v) X (d j)) (turn (C v) (@Vec K 0 1 0)) -
  dot (normal (C v) X (d j)) (turn (C v) (@Vec K 1 0 0)) *
  dot (normal (C u) X (d j)) (turn (C u) (@Vec K 0 1 0)) != 0.
Lemma own_killed : killed D (kept_parameters (f, x) (lighter f)) ->
  (forall v, killed D (lost_image (f, x) (lighter f) (C v) (looks f v))) -> killed D (own (f, x)).
Proof.
move=> hk hl; rewrite ownE; move: hk; rewrite /kept_parameters !killed_cat !killed_flatten.
have -> : free (keep (f, x).1 (lighter f)) = free (keep (f, x).1 (everything f)) by [].
case/andP=> hX hd; apply/andP; split; first exact: hX.
apply/allP => j; rewrite mem_iota add0n => /= jp; have [dj|ndj] := boolP (droppable f j); last first.
  by apply: (allP hd); rewrite mem_filter ndj mem_iota.
case/and3P: (dj) => nf _ hs; have fr := negbTE nf.
have hX' : dead D X.
  by move: hX; rewrite /= fr /= => /and4P[/eqP ? /eqP ? /eqP ? _]; split; rewrite /= ?fr.
have still v : sees_both f j v ->
    D (x1 (d j)) * dot (normal (C v) X (d j)) (turn (C v) (@Vec K 1 0 0)) +
    D (x2 (d j)) * dot (normal (C v) X (d j)) (turn (C v) (@Vec K 0 1 0)) = 0.
  case/andP=> pv jv; rewrite -plane_sum; have -> : @Vec K (D (x1 (d j))) (D (x2 (d j))) 0 = dvec D (d j).
    by rewrite /dvec /dir_at /= (der1 hD).
  apply: plane_still => //; [exact: points | exact: lines |].
  have := hl v; rewrite /lost_image killed_cat killed_flatten => /andP[_ /allP/(_ j)].
  rewrite mem_filter mem_filter dj /= -/(sees_pins f v) jv -/(sees_point f v) pv => /(_ isT).
  by rewrite /= andbT => /eqP.
have [u [v [uv su sv]]] : exists u v, [/\ u <> v, sees_both f j u & sees_both f j v].
  by case/or4P: hs => // /andP[h1 h2]; [exists V1, V2 | exists V1, V3 | exists V2, V3].
have [e1 e2] := two_planes (meet fr uv jp) (still u su) (still v sv).
by rewrite /= e1 e2 eqxx.
Qed.
End Killed.

(** ** All features *)
Section Scene.
Variables (F K : fieldType) (c0 : {rmorphism F -> K}) (D : K -> K) (C : view -> camera K) (x : nat -> K)
  (n : nat).
Hypothesis hD : derivation c0 D.
Hypothesis hC : forall v, dead_camera D (C v).
Local Notation own_at o := (fun k => x (o + k)%N).
Hypothesis points : forall f o v, (11 <= o)%N -> (o + dim3 f <= n)%N -> free f = false ->
  x3 (project (C v) (point_at f (own_at o))) != 0.
Hypothesis lines : forall f o v j, (11 <= o)%N -> (o + dim3 f <= n)%N -> free f = false -> (j < pins f)%N ->
  x2 (normal (C v) (point_at f (own_at o)) (dir_at f (own_at o) j)) != 0.
Hypothesis meet : forall f o u v j, (11 <= o)%N -> (o + dim3 f <= n)%N -> free f = false -> u <> v ->
  (j < pins f)%N -> let n v := normal (C v) (point_at f (own_at o)) (dir_at f (own_at o) j) in
  dot (n u) (turn (C u) (@Vec K 1 0 0)) * dot (n v) (turn (C v) (@Vec K 0 1 0)) -
  dot (n v) (turn (C v) (@Vec K 1 0 0)) * dot (n u) (turn (C u) (@Vec K 0 1 0)) != 0.
Lemma scene_own A o : (11 <= o)%N -> (o + sumn [seq dim3 f | f <- A] <= n)%N -> is_problem A ->
  killed D (owns (kept_scene (scene x o A) (map lighter A))) ->
  killed D (lost C (scene x o A) (map lighter A)) -> killed D (owns (scene x o A)).
Proof.
elim: A o => // f A IH o o11 room /andP[pf pA].
have room1 : (o + dim3 f <= n)%N by apply: leq_trans room; rewrite leq_add2l leq_addr.
have room2 : (o + dim3 f + sumn [seq dim3 g | g <- A] <= n)%N by rewrite -addnA.
have -> : kept_scene (scene x o (f :: A)) (map lighter (f :: A)) =
    kept_feature (f, own_at o) (lighter f) :: kept_scene (scene x (o + dim3 f) A) (map lighter A).
  rewrite /kept_scene [scene _ _ _]/= [map lighter _]/= [zip _ _]/= [filter _ _]/= /remains [(_, _).1]/=.
  by rewrite lighter_remains.
have -> : lost C (scene x o (f :: A)) (map lighter (f :: A)) =
  flatten [seq lost_image (f, own_at o) (lighter f) (C v) (looks f v) | v <- views] ++
  lost C (scene x (o + dim3 f) A) (map lighter A) by [].
have -> : owns (scene x o (f :: A)) = own (f, own_at o) ++ owns (scene x (o + dim3 f) A) by [].
have oc (fx : feature * (nat -> K)) sc : owns (fx :: sc) = own fx ++ owns sc by [].
have split_killed s t : killed D (s ++ t) = killed D s && killed D t := killed_cat D s t.
rewrite oc (split_killed (own (kept_feature _ _))) own_kept.
rewrite (split_killed (flatten _)) (split_killed (own (f, _))).
move=> /andP[k1 k2] /andP[l1 l2]; apply/andP; split;
  last exact: (IH _ (leq_trans o11 (leq_addr _ _)) room2 pA k2 l2).
apply: (own_killed hD hC) k1 _.
- by move=> fr v; exact: points.
- by move=> fr v j; exact: lines.
- by move=> fr u v j; exact: meet.
- by move=> v; move: l1; rewrite killed_flatten => /and4P[h1 h2 h3 _]; case: v.
Qed.
End Scene.

Section Over.
Variable F : fieldType.
Hypothesis char0 : [char F] =i pred0.
Lemma lighter_lifting A : is_problem A ->
  (sumn [seq cost fc.1 fc.2 | fc <- zip A (map lighter A)] <= sumn [seq dim3 f | f <- A])%N ->
  lifting F (parameters A) A (map lighter A).
Proof.
move=> pA le; set n := parameters A; pose gx := generic F n.
apply: (@unmoved_ind _ _ _ (to F n) _ _ (@den_neq0 _) (@fractionE _) (@to0 F n) char0
  (lifted F n A (map lighter A))); first by rewrite size_lifted ?size_map // leq_add2l.
move=> D hD; rewrite liftedE !killed_cat => /andP[/andP[kc kk] kl].
have g k : (k < 11)%N -> D (gx k) = 0.
  by move=> h; have /(all_nthP 0)/(_ k) := kc; rewrite size_mkseq nth_mkseq // => /(_ h)/eqP.
have D0 := der0 hD; have D1 := der1 hD.
have hC v : dead_camera D (cameras_at _ gx v).
  by case: v; split=> //; try split; rewrite ?[in LHS]/= ?g ?D0 ?D1.
have ko : killed D (owns (scene_of F n A)).
  apply: (scene_own hD hC (n := n)) kk kl => //
    [f o v o11 room nf|f o v j o11 room nf jp|f o u v j o11 room nf uv jp].
  - exact: (generic_point F o11 room nf).
  - by case: (generic_line char0 o11 room nf v jp).
  - exact: (generic_meeting char0 o11 room nf uv jp).
have all_killed : killed D (mkseq gx n) by rewrite -owns_scene killed_cat kc.
move=> i; have /(all_nthP 0)/(_ i) := all_killed; rewrite size_mkseq nth_mkseq ?ltn_ord //.
move=> /(_ isT)/eqP.
by rewrite /gx /generic; case: insubP => [k _ /val_inj -> //|]; rewrite ltn_ord.
Qed.
Theorem minimal_lighter A : is_problem A -> is_balanced A -> minimal F A <-> minimal F (lighten A).
Proof.
move=> pA bA; rewrite /lighten; case: ifP => // le.
have red : reduces F A (map lighter A) by split; [exact: lighter_selects | exact: lighter_lifting].
split; [exact: (minimal_kept char0 pA red) | exact: (kept_minimal char0 pA red)].
Qed.
End Over.
Lemma lighten_proper A : is_problem A -> is_problem (lighten A).
Proof. by move=> pA; rewrite /lighten; case: ifP => // _; exact: kept_proper (lighter_selects A). Qed.
