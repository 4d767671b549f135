(** * Subfields of a field, and bases over them

    A subring, or a subfield, of a field K is given by a predicate. A basis over a subfield has a
    fixed number of elements ([basis_unique]); a subring that finitely many elements span is a field
    ([span_field]); so finitely many algebraic elements generate a field that has a basis
    ([basis_exists]: to say that there is none leads to a contradiction; nothing here decides which
    elements are dependent). Let E contain L, and let s be transcendental over E. Then E(s) has d
    elements in a basis over L(s) if and only if E has over L ([basis_up], [basis_down]). *)
From mathcomp Require Import all_ssreflect all_algebra.
From PL1P Require Import Derivations.
Set Implicit Arguments.
Unset Strict Implicit.
Unset Printing Implicit Defensive.
Import GRing.Theory.
Local Open Scope ring_scope.

(** ** Subrings, given by predicates *)
Definition subring (R : ringType) (S : R -> Prop) := [/\ S 1, forall u w, S u -> S w -> S (u - w) &
  forall u w, S u -> S w -> S (u * w)].
(** The coefficients of p are in S. *)
Definition over (R : ringType) (S : R -> Prop) (p : {poly R}) := forall i, S p`_i.
Section Subrings.
Variables (R : comRingType) (S : R -> Prop).
Hypothesis hS : subring S.
Lemma sr1 : S 1. Proof. by case: hS. Qed.
Lemma srB u w : S u -> S w -> S (u - w). Proof. by case: hS => _ h _; exact: h. Qed.
Lemma srM u w : S u -> S w -> S (u * w). Proof. by case: hS => _ _ h; exact: h. Qed.
Lemma sr0 : S 0. Proof. by rewrite -(subrr 1); apply: srB; exact: sr1. Qed.
Lemma srN u : S u -> S (- u). Proof. by rewrite -sub0r; apply: srB; exact: sr0. Qed.
Lemma srD u w : S u -> S w -> S (u + w).
Proof. by move=> hu hw; rewrite -[w]opprK; apply: srB => //; exact: srN. Qed.
Lemma srn k : S k%:R.
Proof. by elim: k => [|k IH]; [exact: sr0 | rewrite mulrS; apply: srD => //; exact: sr1]. Qed.
Lemma srX u k : S u -> S (u ^+ k).
Proof. by move=> h; elim: k => [|k IH]; [exact: sr1 | rewrite exprS; exact: srM]. Qed.
Lemma sr_sum I r (P : pred I) G : (forall i, P i -> S (G i)) -> S (\sum_(i <- r | P i) G i).
Proof. by move=> h; apply: big_ind => //; [exact: sr0 | exact: srD]. Qed.
Lemma sr_prod I r (P : pred I) G : (forall i, P i -> S (G i)) -> S (\prod_(i <- r | P i) G i).
Proof. by move=> h; apply: big_ind => //; [exact: sr1 | exact: srM]. Qed.
Lemma sr_det m (B : 'M[R]_m) : (forall i j, S (B i j)) -> S (\det B).
Proof.
move=> h; apply: sr_sum => s _; apply: srM; last by apply: sr_prod => i _; exact: h.
by apply: srX; apply: srN; exact: sr1.
Qed.
Lemma overC c : S c -> over S c%:P.
Proof. by move=> h i; rewrite coefC; case: ifP => _ //; exact: sr0. Qed.
Lemma overX : over S 'X. Proof. by move=> i; rewrite coefX; exact: srn. Qed.
Lemma over_ring : subring (over S).
Proof.
split=> [|p q hp hq i|p q hp hq i]; first by apply: overC; exact: sr1.
  by rewrite coefB; exact: srB.
by rewrite coefM; apply: sr_sum => j _; exact: srM.
Qed.
Lemma over_cons p c : over S (p * 'X + c%:P) -> over S p /\ S c.
Proof.
move=> h; split=> [i|]; first by have := h i.+1; rewrite coefD coefMX coefC /= addr0.
by have := h 0%N; rewrite coefD coefMX coefC /= add0r.
Qed.
Lemma sr_horner p u : over S p -> S u -> S p.[u].
Proof. by move=> h hu; rewrite horner_coef; apply: sr_sum => i _; apply: srM => //; exact: srX. Qed.
End Subrings.

(** ** Subfields, and what a list spans over them *)
Section Subfields.
Variable K : fieldType.
Implicit Types (L M E S : K -> Prop) (I J : finType) (p : {poly K}).
Definition subfield L := subring L /\ forall u, L u -> L u^-1.
Definition spanned L I (b : I -> K) u := exists2 a, forall i, L (a i) & u = \sum_i a i * b i.
Definition free_over L I (b : I -> K) := forall a, (forall i, L (a i)) ->
  \sum_i a i * b i = 0 -> forall i, a i = 0.
Definition has_basis L E d := exists b : 'I_d -> K,
  [/\ forall i, E (b i), forall u, E u -> spanned L b u & free_over L b].
Lemma sum_delta I (c : I -> K) i : \sum_j (i == j)%:R * c j = c i.
Proof.
rewrite (bigD1 i) //= eqxx mul1r big1 ?addr0 // => j.
by rewrite eq_sym => /negbTE ->; rewrite mul0r.
Qed.
Lemma sum_sum I J (a : I -> K) (C : I -> J -> K) c :
  \sum_p a p * (\sum_j C p j * c j) = \sum_j (\sum_p a p * C p j) * c j.
Proof.
under eq_bigr do rewrite mulr_sumr; rewrite exchange_big; apply: eq_bigr => j _.
by rewrite mulr_suml; apply: eq_bigr => p _; rewrite mulrA.
Qed.
Lemma sum_enum I (G : I -> K) : \sum_i G i = \sum_(p < #|I|) G (enum_val p).
Proof. by rewrite (reindex (@enum_val I I)) //; apply: onW_bij; exact: enum_val_bij. Qed.

Section Span.
Variables (L : K -> Prop) (I : finType) (b : I -> K).
Hypothesis hL : subring L.
Lemma spanB u w : spanned L b u -> spanned L b w -> spanned L b (u - w).
Proof.
case=> a ha -> [c hc ->]; exists (fun i => a i - c i) => [i|]; first exact: srB.
by rewrite -sumrB; apply: eq_bigr => i _; rewrite mulrBl.
Qed.
Lemma spanZ u w : L u -> spanned L b w -> spanned L b (u * w).
Proof.
move=> hu [a ha ->]; exists (fun i => u * a i) => [i|]; first exact: srM.
by rewrite mulr_sumr; apply: eq_bigr => i _; rewrite mulrA.
Qed.
Lemma span_sum J r (P : pred J) G : (forall j, P j -> spanned L b (G j)) ->
  spanned L b (\sum_(j <- r | P j) G j).
Proof.
have z : spanned L b 0.
  by exists (fun=> 0) => [i|]; [exact: sr0 | rewrite big1 // => i _; rewrite mul0r].
move=> h; apply: big_ind => // u w hu hw; rewrite -[w]opprK; apply: spanB => //.
by rewrite -sub0r; exact: spanB.
Qed.
Lemma span_mem i : spanned L b (b i).
Proof. by exists (fun j => (i == j)%:R) => [j|]; [exact: srn | rewrite sum_delta]. Qed.
Lemma span_trans J (c : J -> K) u : (forall j, spanned L b (c j)) -> spanned L c u -> spanned L b u.
Proof. by move=> h [a ha ->]; apply: span_sum => j _; exact: spanZ. Qed.
Lemma span_ring : spanned L b 1 -> (forall i j, spanned L b (b i * b j)) -> subring (spanned L b).
Proof.
move=> h1 hb; split=> // [u w|_ _ [a ha ->] [c hc ->]]; first exact: spanB.
rewrite mulr_suml; apply: span_sum => i _; rewrite mulr_sumr; apply: span_sum => j _.
by rewrite mulrACA; apply: spanZ => //; exact: srM.
Qed.
End Span.

(** *** Two bases have as many elements *)
Lemma change_of_basis L I d (c : 'I_d -> K) (e : I -> K) A C : subring L -> free_over L c ->
  (forall i k, L (A i k)) -> (forall k j, L (C k j)) -> (forall i, c i = \sum_k A i k * e k) ->
  (forall k, e k = \sum_j C k j * c j) -> forall i j, \sum_k A i k * C k j = (i == j)%:R.
Proof.
move=> hL f hA hC cA eC i j; apply/eqP; rewrite -subr_eq0; apply/eqP; move: j; apply: f => [j|].
  by apply: srB => //; [apply: sr_sum => // k _; exact: srM | exact: srn].
under eq_bigr do rewrite mulrBl; rewrite sumrB sum_delta -sum_sum.
by under eq_bigr do rewrite -eC; rewrite -cA subrr.
Qed.
Lemma basis_le L E d d' : subring L -> has_basis L E d -> has_basis L E d' -> (d <= d')%N.
Proof.
move=> hL [b [b1 b2 b3]] [c [c1 c2 _]].
have [A hA eA] := fin_all_exists2 (fun i => c2 _ (b1 i)).
have [B hB eB] := fin_all_exists2 (fun i => b2 _ (c1 i)).
apply: (@mulmx1_min K _ _ (\matrix_(i, j) A i j) (\matrix_(i, j) B i j)); apply/matrixP => i k.
by rewrite !mxE -(change_of_basis hL b3 hA hB eA eB); apply: eq_bigr => j _; rewrite !mxE.
Qed.
Lemma basis_unique L E d d' : subring L -> has_basis L E d -> has_basis L E d' -> d = d'.
Proof. by move=> hL h h'; apply/eqP; rewrite eqn_leq !(@basis_le L E). Qed.

(** *** A subring that finitely many elements span is a field *)
Lemma root_inverse M S p v : subfield M -> subring S -> (forall u w, M u -> S w -> S (u * w)) ->
  over M p -> p != 0 -> root p v -> S v -> v != 0 -> S v^-1.
Proof.
move=> [hM iM] hS MS; have M1 a : M a -> S a by move=> h; rewrite -[a]mulr1; apply: MS (sr1 hS).
elim/poly_ind: p => [|q c IH]; first by rewrite eqxx.
move=> /over_cons[hq hc] p0; rewrite rootE !hornerE => /eqP e hv v0.
have [c0|c0] := eqVneq c 0.
  apply: IH => //; first by apply: contraNneq p0 => ->; rewrite c0 mul0r addr0.
  by rewrite rootE; move/eqP: e; rewrite c0 addr0 mulf_eq0 (negbTE v0) orbF.
have -> : v^-1 = - c^-1 * q.[v].
  by apply: (mulIf v0); rewrite mulVf // -mulrA (canRL (addrK _) e) sub0r mulrNN mulVf.
apply: MS; first by apply: srN => //; exact: iM.
by apply: sr_horner => // i; exact: M1.
Qed.
Lemma span_field M I (b : I -> K) : subfield M -> spanned M b 1 ->
  (forall i j, spanned M b (b i * b j)) -> subfield (spanned M b).
Proof.
move=> hM h1 hb; have hS := span_ring hM.1 h1 hb; split=> // v hv.
have [->|v0] := eqVneq v 0; first by rewrite invr0; exact: sr0.
have [A hA eA] := fin_all_exists2 (fun i => srM hS hv (span_mem b hM.1 i)).
pose B : 'M[K]_#|I| := \matrix_(j, i) A (enum_val i) (enum_val j).
apply: (root_inverse (p := char_poly B) hM) => //; first by move=> u w; exact: (spanZ hM.1).
- have hR := over_ring hM.1; apply: (sr_det hR) => i j; rewrite !mxE; apply: (srB hR).
    by case: (i == j); [exact: overX hM.1 | exact: sr0].
  exact/(overC hM.1)/hA.
- by rewrite monic_neq0 // char_poly_monic.
rewrite -eigenvalue_root_char; apply/eigenvalueP; exists (\row_i b (enum_val i)).
  by apply/rowP => i; rewrite !mxE eA [RHS]sum_enum; apply: eq_bigr => j _; rewrite !mxE mulrC.
apply/negP => /eqP z; case: h1 => a _ e; have /eqP[] := oner_neq0 K.
rewrite e big1 // => i _; have := congr1 (fun r : 'rV_#|I| => r 0 (enum_rank i)) z.
by rewrite !mxE enum_rankK => ->; rewrite mulr0.
Qed.

(** ** Bases exist *)
Section Existence.
Variables (L E : K -> Prop).
Hypotheses (hL : subfield L) (hE : subfield E) (LE : forall u, L u -> E u).
Lemma finite_basis N (w : 'I_N -> K) : (forall i, E (w i)) -> (forall u, E u -> spanned L w u) ->
  ~ ~ exists d, has_basis L E d.
Proof.
elim: N w => [|N IH] w wE sp no; first by apply: no; exists 0%N, w; split=> // a _ _ [].
apply: (no); exists N.+1, w; split=> // a ha e i; apply/eqP; apply: contraT => ai; exfalso.
apply: (IH (fun j => w (lift i j)) _ _ no) => // u /sp; apply: (span_trans hL.1) => j.
case: (unliftP i j) => [k ->|->]; first exact: (span_mem (fun k => w (lift i k)) hL.1).
exists (fun k => - (a (lift i k) / a i)) => [k|].
  by apply: (srN hL.1); apply: (srM hL.1) => //; exact: hL.2.
apply: (mulfI ai); rewrite (bigD1_ord i) //= in e; rewrite (canRL (addrK _) e) sub0r.
rewrite -sumrN mulr_sumr.
by apply: eq_bigr => k _; rewrite !mulNr mulrN mulrA mulrCA divff // mulr1.
Qed.

(** S is a field between, spanned over L by finitely many elements. So it is with a root z too. *)
Definition root_over S z := exists p, [/\ p != 0, over S p & root p z].
Definition between S := [/\ subfield S, forall u, L u -> S u, forall u, S u -> E u &
  exists (I : finType) (w : I -> K), (forall i, S (w i)) /\ forall u, S u -> spanned L w u].
Lemma between_root S z : between S -> E z -> root_over L z ->
  exists T, [/\ between T, T z & forall u, S u -> T u].
Proof.
move=> [hS LS SE [I [w [wS spw]]]] Ez [p [p0 oL rt]]; have rS := hS.1.
have [k sp] : exists k, size p = k.+2.
  by have := root_size_gt1 p0 rt; case: (size p) => [|[|k]] // _; exists k.
pose b (j : 'I_k.+1) := z ^+ j; have top : spanned S b (z ^+ k.+1).
  have lc : lead_coef p != 0 by rewrite lead_coef_eq0.
  exists (fun j : 'I_k.+1 => - (p`_j / lead_coef p)) => [j|].
    by apply: srN => //; apply: srM => //; [|apply: hS.2]; apply: LS; exact: oL.
  have := rootP rt; rewrite horner_coef sp big_ord_recr /= addrC => /eqP; rewrite addr_eq0.
  move=> /eqP e; apply: (mulfI lc); rewrite lead_coefE sp e -sumrN mulr_sumr.
  apply: eq_bigr => j _.
  by rewrite !mulNr mulrN mulrA mulrCA divff ?mulr1 // -[k.+1]/(k.+2.-1) -sp -lead_coefE.
have pow i : spanned S b (z ^+ i).
  elim: i => [|i [a ha e]]; first exact: (span_mem b rS ord0).
  rewrite exprS e mulr_sumr; apply: span_sum => // j _; rewrite mulrCA -exprS; apply: spanZ => //.
  have [lt|ge] := ltnP j.+1 k.+1; first exact: (span_mem b rS (Ordinal lt)).
  by have -> : j.+1 = k.+1 by apply/eqP; rewrite eqn_leq ge ltn_ord.
have ST u : S u -> spanned S b u by move=> hu; rewrite -[u]mulr1; apply: spanZ (pow 0%N).
exists (spanned S b); split=> //; last exact: (pow 1%N); split.
- by apply: span_field => //; [exact: (pow 0%N) | move=> i j; rewrite /b -exprD].
- by move=> u /LS/ST.
- move=> _ [a ha ->]; apply: (sr_sum hE.1) => j _; apply: (srM hE.1); first exact: SE.
  exact: (srX hE.1).
exists [finType of I * 'I_k.+1], (fun q => w q.1 * b q.2); split=> [q|_ [a ha ->]].
  by apply: spanZ => //; exact: span_mem.
apply: (span_sum hL.1) => j _; have [c hc ->] := spw _ (ha j); rewrite mulr_suml.
apply: (span_sum hL.1) => i _; rewrite -mulrA; apply: (spanZ hL.1) => //.
exact: (span_mem (fun q => w q.1 * b q.2) hL.1 (i, j)).
Qed.
(** A field that finitely many algebraic elements generate has a basis. *)
Theorem basis_exists (zs : seq K) : (forall z, z \in zs -> E z /\ root_over L z) ->
  (forall S, subfield S -> (forall u, L u -> S u) -> (forall z, z \in zs -> S z) ->
    forall u, E u -> S u) -> ~ ~ exists2 d, (0 < d)%N & has_basis L E d.
Proof.
move=> hz gen; have [S [bS Sz]] : exists S, between S /\ forall z, z \in zs -> S z.
  elim: zs hz {gen} => [|z zs IH] hz.
    exists L; split=> //; split=> //; exists [finType of unit], (fun=> 1).
    split=> [_|u hu]; first exact: (sr1 hL.1).
    by rewrite -[u]mulr1; apply: (spanZ hL.1) => //; exact: (span_mem (fun=> 1) hL.1 tt).
  have [|S [bS Sz]] := IH; first by move=> u uz; apply: hz; rewrite inE uz orbT.
  have [||T [bT Tz ST]] := between_root (z := z) bS; [by case: (hz z (mem_head _ _)).. |].
  by exists T; split=> // u; rewrite inE => /predU1P[->|/Sz/ST].
case: bS => hS LS SE [I [w [wS sp]]] no; have all := gen S hS LS Sz.
apply: (@finite_basis _ (fun i : 'I_#|I| => w (enum_val i))) => [i|u hu|[d h]].
- by apply: SE; exact: wS.
- have [a ha ->] := sp u (all u hu); exists (fun i : 'I_#|I| => a (enum_val i)) => [i|] //.
  exact: sum_enum.
apply: no; exists d => //; case: d h => // -[b [_ h _]].
by have [a _] := h 1 (sr1 hE.1); rewrite big_ord0 => /eqP; rewrite oner_eq0.
Qed.
End Existence.

(** ** One more element *)
(** Quotients of polynomials in s over L; a common denominator. *)
Definition quotient L s u := exists P Q, [/\ over L P, over L Q, Q.[s] != 0 & u * Q.[s] = P.[s]].
Lemma common L s d (a : 'I_d -> K) : subring L -> (forall i, quotient L s (a i)) ->
  exists Q (R : 'I_d -> {poly K}), [/\ over L Q, Q.[s] != 0, forall i, over L (R i) &
    forall i, a i * Q.[s] = (R i).[s]].
Proof.
move=> /over_ring hL /fin_all_exists[P /fin_all_exists[Q h]].
exists (\prod_i Q i), (fun i => P i * \prod_(j | j != i) Q j); split=> [||i|i].
- by apply: (sr_prod hL) => i _; case: (h i).
- by rewrite horner_prod; apply/prodf_neq0 => i _; case: (h i).
- by apply: (srM hL); [case: (h i) | apply: (sr_prod hL) => j _; case: (h j)].
- by rewrite (bigD1 i) //= !hornerM mulrA; have [_ _ _ ->] := h i.
Qed.

(** A derivation kills E and moves s: no polynomial over E but 0 vanishes at s. *)
Lemma moved_root (F : fieldType) (c : {rmorphism F -> K}) D E s : [char F] =i pred0 ->
  derivation c D -> subring E -> (forall u, E u -> D u = 0) -> D s != 0 ->
  forall p, over E p -> root p s -> p = 0.
Proof.
move=> char0 hD hE DE Ds p; have [k] := ubnP (size p); elim: k p => // k IH p.
rewrite ltnS => le hp rt; have chain q : over E q -> D q.[s] = q^`().[s] * D s.
  elim/poly_ind: q => [|q a IHq]; first by rewrite deriv0 !horner0 (der0 hD) mul0r.
  move=> /over_cons[hq ha]; rewrite derivD derivM derivX derivC addr0 mulr1 !hornerE.
  by rewrite (derD hD) (derM hD) (DE a) // IHq // addr0 mulrDl mulrAC.
have [->//|p0] := eqVneq p 0; have dp : p^`() = 0.
  apply: IH => //; first by apply: leq_trans le; exact: lt_size_deriv.
    by move=> i; rewrite coef_deriv -mulr_natr; apply: srM => //; exact: srn.
  have := chain p hp; rewrite (rootP rt) (der0 hD) => /esym/eqP.
  by rewrite mulf_eq0 (negbTE Ds) orbF rootE.
have ep : p = (p`_0)%:P.
  apply/polyP => -[|i]; rewrite coefC //=; have := congr1 (fun r : {poly K} => r`_i) dp.
  rewrite coef_deriv coef0 => /eqP; rewrite -mulr_natr mulf_eq0 -(rmorph_nat c) fmorph_eq0.
  by rewrite natr0 // orbF => /eqP.
by move: rt; rewrite ep rootE hornerC => /eqP ->; rewrite polyC0.
Qed.

(** L lies in E, and s is transcendental over E; M is L(s), and E' is E(s). *)
Section Transcendental.
Variables (L M E E' : K -> Prop) (s : K).
Hypotheses (hL : subfield L) (hM : subfield M) (hE : subfield E) (hE' : subfield E').
Hypotheses (LE : forall u, L u -> E u) (LM : forall u, L u -> M u) (EE' : forall u, E u -> E' u).
Hypotheses (ME' : forall u, M u -> E' u) (Ms : M s).
Hypotheses (fM : forall u, M u -> quotient L s u) (fE : forall u, E' u -> quotient E s u).
Hypothesis tr : forall p, over E p -> root p s -> p = 0.
Lemma coefficients d (b : 'I_d -> K) (R : 'I_d -> {poly K}) u Q k : (forall i, E (b i)) ->
  (forall i, over L (R i)) -> E u -> over L Q -> u * Q.[s] = \sum_i (R i).[s] * b i ->
  u * Q`_k = \sum_i (R i)`_k * b i.
Proof.
have rE := over_ring hE.1; have LEp q : over L q -> over E q by move=> hq i; exact: LE.
move=> hb hR hu hQ e; have z : u%:P * Q - \sum_i (b i)%:P * R i = 0.
  apply: tr; last first.
    rewrite rootE !hornerE horner_sum e subr_eq0; apply/eqP.
    by apply: eq_bigr => i _; rewrite !hornerE mulrC.
  apply: (srB rE); first by apply: (srM rE); [exact: (overC hE.1) | exact: LEp].
  by apply: (sr_sum rE) => i _; apply: (srM rE); [exact: (overC hE.1) | apply: LEp; exact: hR].
have := congr1 (fun p : {poly K} => p`_k) z; rewrite coefB coefCM coef_sum coef0 => /eqP.
by rewrite subr_eq0 => /eqP ->; apply: eq_bigr => i _; rewrite coefCM mulrC.
Qed.
Lemma free_up d (b : 'I_d -> K) : (forall i, E (b i)) -> free_over L b -> free_over M b.
Proof.
move=> hb f a ha e; have [Q [R [oQ Q0 oR eR]]] := common hL.1 (fun i => fM (ha i)).
suff z i : R i = 0 by move=> i; apply: (mulIf Q0); rewrite eR z horner0 mul0r.
apply/polyP => k; rewrite coef0; move: i; apply: f => [i|]; first exact: oR.
rewrite -(@coefficients d b R 0 Q) ?mul0r //; first exact: (sr0 hE.1).
by under eq_bigr do rewrite -eR mulrAC; rewrite -mulr_suml e mul0r.
Qed.
Lemma basis_up d : has_basis L E d -> has_basis M E' d.
Proof.
move=> [b [b1 b2 b3]]; exists b; split=> [i|u|]; [exact: EE' | | exact: free_up].
have up w : E w -> spanned M b w by move=> /b2[a ha ->]; exists a => // i; exact: LM.
have hS : subfield (spanned M b).
  by apply: span_field => // [|i j]; apply: up; [exact: (sr1 hE.1) | exact: (srM hE.1)].
have Ss : spanned M b s by rewrite -[s]mulr1; apply: (spanZ hM.1) => //; exact/up/(sr1 hE.1).
have hor p : over E p -> spanned M b p.[s] by move=> h; apply: (sr_horner hS.1) => // i; exact: up.
case/fE => P [Q [oP oQ Q0 e]]; rewrite -[u](mulfK Q0) e.
by apply: (srM hS.1); [exact: hor | apply: hS.2; exact: hor].
Qed.

(** Conversely: d of finitely many elements of E that span E' over M are a basis. *)
Lemma basis_pick (I : finType) (e : I -> K) d : (forall i, E (e i)) ->
  (forall u, E' u -> spanned M e u) -> has_basis M E' d ->
  exists b : 'I_d -> K, [/\ forall i, E (b i), forall u, E' u -> spanned M b u & free_over M b].
Proof.
move=> he sp [c [c1 c2 c3]]; have [rM iM] := hM.
have [C hC eC] := fin_all_exists2 (fun k => c2 _ (EE' (he k))).
have [A hA eA] := fin_all_exists2 (fun i => sp _ (c1 i)).
pose B : 'M[K]_(#|I|, d) := \matrix_(k, j) C (enum_val k) j; have full : row_full B.
  apply/row_fullP; exists (\matrix_(i, k) A i (enum_val k)); apply/matrixP => i j.
  rewrite !mxE -(change_of_basis rM c3 hA hC eA eC) [RHS]sum_enum.
  by apply: eq_bigr => k _; rewrite !mxE.
set g := fullrankfun full; have un := fullrowsub_unit full; rewrite -/g in un.
set T := rowsub g B in un; pose b i := e (enum_val (g i)).
have hT i j : M (T i j) by rewrite !mxE.
have hV i j : M (invmx T i j).
  rewrite /invmx; case: ifP => // _; rewrite !mxE /cofactor.
  apply: srM => //; first by apply: iM; exact: sr_det.
  apply: srM => //; first by apply: srX => //; apply: srN => //; exact: sr1.
  by apply: sr_det => // k l; rewrite !mxE.
have eb i : b i = \sum_j T i j * c j by rewrite /b eC; apply: eq_bigr => j _; rewrite !mxE.
exists b; split=> [i|u /c2|a ha z i]; first exact: he.
  apply: span_trans => // j; exists (invmx T j) => //.
  under eq_bigr do rewrite eb; rewrite sum_sum -[LHS]sum_delta; apply: eq_bigr => k _.
  by have := congr1 (fun m : 'M_d => m j k) (mulVmx un); rewrite !mxE => <-.
have aT : \row_i a i *m T = 0.
  apply/rowP => j; rewrite [RHS]mxE; move: j; apply: c3 => [j|].
    by rewrite mxE; apply: sr_sum => // k _; apply: srM => //; rewrite mxE.
  rewrite -[RHS]z; under [RHS]eq_bigr do rewrite eb; rewrite [RHS]sum_sum; apply: eq_bigr => j _.
  by rewrite mxE; congr (_ * _); apply: eq_bigr => k _; rewrite mxE.
by have := congr1 (fun r => (r *m invmx T) 0 i) aT; rewrite mulmxK // mul0mx !mxE.
Qed.
Lemma basis_down d : has_basis M E' d -> has_basis L E d.
Proof.
move=> h; have [c [c1 c2 c3]] := h.
have [Q [R [oQ Q0 oR eR]]] := common hE.1 (fun i => fE (c1 i)).
pose N := \max_i size (R i); pose e (q : 'I_d * 'I_N) := (R q.1)`_q.2.
have [||b [b1 b2 b3]] := basis_pick (e := e) _ _ h; first by move=> q; exact: oR.
  move=> u hu; have : E' (u / Q.[s]).
    apply: (srM hE'.1) => //; apply: hE'.2; apply: (sr_horner hE'.1); last exact: ME'.
    by move=> i; apply: EE'; exact: oQ.
  move=> /c2[a ha eu]; rewrite -[u](divfK Q0) eu mulr_suml; apply: (span_sum hM.1) => i _.
  rewrite -mulrA eR (horner_coef_wide (n := N)) ?(leq_bigmax i) //; apply: (spanZ hM.1) => //.
  apply: (span_sum hM.1) => k _; rewrite mulrC; apply: (spanZ hM.1); first exact: (srX hM.1).
  exact: (span_mem e hM.1 (i, k)).
exists b; split=> // [u hu|a ha]; last by apply: b3 => i; exact: LM.
have [a ha eu] := b2 u (EE' hu); have [P [T [oP P0 oT eT]]] := common hL.1 (fun i => fM (ha i)).
have lc : lead_coef P != 0 by rewrite lead_coef_eq0; apply: contraNneq P0 => ->; rewrite horner0.
exists (fun i : 'I_d => (T i)`_(size P).-1 / lead_coef P) => [i|].
  by apply: (srM hL.1); [exact: oT | apply: hL.2; exact: oP].
rewrite -[LHS](mulfK lc) lead_coefE (@coefficients d b T u P) ?mulr_suml //.
  by apply: eq_bigr => i _; rewrite mulrAC.
by rewrite {1}eu mulr_suml; apply: eq_bigr => i _; rewrite mulrAC eT.
Qed.
End Transcendental.
End Subfields.
