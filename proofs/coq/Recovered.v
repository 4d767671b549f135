(** * A camera-minimal problem of the 27 features is minimal

    Given the cameras, the images of the 27 features determine them. *)
From mathcomp Require Import all_ssreflect all_algebra.
From SsrMultinomials Require Import mpoly.
From PL1P Require Import Statement Reducible Reductions Forget Derivations RationalFunctions
  Independence Generic Lifting Reduction Embedding Scenes Keeps Theorem1 Replacements Terminal
  Dangling Placed CameraMinimal Lifts.
Set Implicit Arguments.
Unset Strict Implicit.
Unset Printing Implicit Defensive.
Import GRing.Theory.
Local Open Scope ring_scope.

Lemma two_views (p : view -> bool) : (2 <= count p views)%N -> exists u w, [/\ u <> w, p u & p w].
Proof.
case p1: (p V1); case p2: (p V2); case p3: (p V3); rewrite /= ?p1 ?p2 ?p3 // => _.
- by exists V1, V2. - by exists V1, V2. - by exists V1, V3. - by exists V2, V3.
Qed.
Lemma has_view (p : view -> bool) : has p views -> exists v, p v.
Proof. by case/or4P=> // h; eexists; exact: h. Qed.

Section Recovered.
Variables (F : fieldType) (n : nat).
Hypothesis char0 : [char F] =i pred0.
Notation K := [fieldType of {fraction {mpoly F[n]}}].
Notation gx := (generic F n).
Notation C := (cameras_at K gx).
Variable D : K -> K.
Hypothesis hD : derivation (const (to F n)) D.
Hypothesis hC : forall v, dead_camera D (C v).
Lemma feature_recovered f o : (11 <= o)%N -> (o + dim3 f <= n)%N -> proper f -> located f ->
  (forall w, killed D (image (f, fun k => gx (o + k)%N) (C w) (looks f w))) ->
  killed D (own (f, fun k => gx (o + k)%N)).
Proof.
move=> o11 room pf /andP[/allP two lo] ki.
have fl w i := @image_flat F n o f char0 o11 room pf D hD hC w i (ki w).
have ry w := image_rayed o11 room pf hD hC (ki w).
have pair i : (i < pins f)%N -> exists u w, [/\ u <> w, i \in sees_pins f u & i \in sees_pins f w].
  by move=> ip; apply: two_views; apply: (two i); rewrite mem_iota.
apply: own_stays => //; last first.
  by move=> i ip; have [u [w [uw iu iw]]] := pair i ip;
    exact: (pin_stays char0 o11 room pf hD uw ip (fl _ _ iu) (fl _ _ iw)).
case fr: (free f) lo => lo.
  have ip : (0 < pins f)%N by rewrite (free_pins pf fr).
  by have [u [w [uw iu iw]]] := pair _ ip;
    exact: (free_stays char0 o11 room pf hD fr uw ip (fl _ _ iu) (fl _ _ iw)).
move: lo; rewrite orFb;
  case/orP=> [/two_views[u [w [uw pu pw]]]|/has_view[u /andP[pu /has_view[w /andP[/same_viewP uw h]]]]].
  exact: (rays_stay char0 o11 room fr uw (ry u pu) (ry w pw)).
have [i i3 iw] : exists2 i, (i < 3)%N & i \in sees_pins f w by case/orP: h => h; [exists 0%N | exists 1%N].
have ip : (i < pins f)%N by have [_ /allP le _] := properP w pf; exact: le.
exact: (plane_stays char0 o11 room fr uw ip i3 (ry u pu) (fl w i iw)).
Qed.
Lemma scene_recovered A o : (11 <= o)%N -> (o + sumn [seq dim3 f | f <- A] <= n)%N ->
  is_problem A -> all located A ->
  killed D (seen C (scene gx o A)) -> killed D (owns (scene gx o A)).
Proof.
elim: A o => // f A IH o o11 room /andP[pf pA] /andP[lf lA].
have room1 : (o + dim3 f <= n)%N by apply: leq_trans room; rewrite leq_add2l leq_addr.
have room2 : (o + dim3 f + sumn [seq dim3 g | g <- A] <= n)%N by rewrite -addnA.
pose fx := (f, fun k => gx (o + k)%N).
have -> : seen C (scene gx o (f :: A)) = views_of C fx ++ seen C (scene gx (o + dim3 f) A) by [].
have -> : owns (scene gx o (f :: A)) = own fx ++ owns (scene gx (o + dim3 f) A) by [].
have both s t : killed D (s ++ t) = killed D s && killed D t by exact: all_cat.
rewrite (both (views_of C fx)) (both (own fx)) => /andP[k1].
move=> /(IH _ (leq_trans o11 (leq_addr _ _)) room2 pA lA) ->; rewrite andbT.
have ki w : killed D (image fx (C w) (looks f w)).
  by move: k1; rewrite /views_of killed_flatten => /and4P[h1 h2 h3 _]; case: w.
exact: (feature_recovered o11 room1 pf lf ki).
Qed.
End Recovered.

Theorem located_minimal (F : fieldType) A : [char F] =i pred0 -> is_problem A -> all located A ->
  camera_minimal F A -> minimal F A.
Proof.
move=> char0 pA lA [iy cy]; set n := parameters A in iy cy *; set y := images F n A in iy cy *.
have un : unmoved (to F n) y.
  move=> D hD kD; have g k : (k < 11)%N -> D (generic F n k) = 0.
    by move=> k11; apply: (algebraic_killed char0 hD _ (cy k k11)); exact/(killedP D erefl).
  have D0 := der0 hD; have D1 := der1 hD.
  have hC v : dead_camera D (cameras_at _ (generic F n) v).
    by case: v; split=> //; try split; rewrite ?[in LHS]/= ?g ?D0 ?D1.
  have ko := scene_recovered char0 hD hC (leqnn 11) (leqnn _) pA lA kD.
  have all_killed : killed D (mkseq (generic F n) n).
    rewrite -owns_scene /killed all_cat; apply/andP; split; last exact: ko.
    by apply/(all_nthP 0) => k; rewrite size_mkseq => k11; rewrite nth_mkseq // g.
  move=> i; have /(all_nthP 0)/(_ i) := all_killed; rewrite size_mkseq nth_mkseq ?ltn_ord // => /(_ isT)/eqP.
  by rewrite /generic valK.
apply/(minimalP char0); split=> //; apply/eqP; rewrite eqn_leq.
rewrite (ind_size (@den_neq0 _) (@fractionE _) (iy : ind (const (to F n)) y)).
exact: (unmoved_size (@den_neq0 _) (@fractionE _) (@to0 F n) un).
Qed.
Lemma all_located A : is_problem A -> known A -> all located A.
Proof.
elim: A => //= f A IH /andP[pf pA] /andP[kf kA]; rewrite (IH pA kA) andbT; exact: known_located.
Qed.
