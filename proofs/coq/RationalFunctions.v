(** * The field K of rational functions in n parameters over F

    K has a derivation with any given values at the parameters. And n independent elements y of K
    make every u in K algebraic over F(y) ([exchange]). This is by counting. Take all monomials in y
    and u up to a high degree, and clear denominators: these are polynomials in the parameters. They
    outnumber their coefficients, so some linear combination of them is zero.

    The Jacobian criterion follows ([jacobian_criterion]). For n elements y these are equivalent:
    they are independent; their Jacobian matrix is invertible; K is algebraic over F(y); every
    derivation of K that kills y is zero. *)
From mathcomp Require Import all_ssreflect all_algebra.
From mathcomp.algebra_tactics Require Import ring.
From SsrMultinomials Require Import mpoly.
From PL1P Require Import Derivations.
Set Implicit Arguments.
Unset Strict Implicit.
Unset Printing Implicit Defensive.
Import GRing.Theory.
Local Open Scope ring_scope.

(** Fewer columns than rows: a combination of the rows is zero. *)
Lemma more_rows (F : fieldType) (A B : finType) (w : A -> B -> F) : (#|B| < #|A|)%N ->
  exists2 v : A -> F, exists a, v a != 0 & forall b, \sum_a v a * w a b = 0.
Proof.
move=> lt; pose M : 'M[F]_(#|A|, #|B|) := \matrix_(i, j) w (enum_val i) (enum_val j).
have : kermx M != 0.
  rewrite kermx_eq0 /row_free; apply: contraTneq (rank_leq_col M) => ->.
  by rewrite -ltnNge.
case/rowV0Pn=> x /sub_kermxP xM x0; exists (fun a => x 0 (enum_rank a)).
  have /rV0Pn[i xi] := x0; exists (enum_val i); by rewrite enum_valK.
move=> b; have := congr1 (fun M : 'rV_ _ => M 0 (enum_rank b)) xM; rewrite mxE [RHS]mxE; apply: etrans.
rewrite (reindex (fun i : 'I_#|A| => enum_val i)); last by apply: onW_bij; exact: enum_val_bij.
by apply: eq_bigr => i _; rewrite enum_valK mxE !enum_rankK.
Qed.

Section Functions.
Variables (F : fieldType) (n : nat).
Notation P := {mpoly F[n]}.
Variables (K : fieldType) (to : {rmorphism P -> K}) (num den : K -> P).
Hypothesis den0 : forall u, to (den u) != 0.
Hypothesis fracE : forall u, u = to (num u) / to (den u).
Hypothesis to0 : forall p, (to p == 0) = (p == 0).
Implicit Types (p q : P) (u w : K).

Definition const : {rmorphism F -> K} := [rmorphism of to \o mpolyC n (R := F)].
Notation derivation := (derivation const).

(** ** The derivation with values d at the parameters *)
Section Extension.
Variable d : 'I_n -> K.
Definition on_poly p := \sum_i to p^`M(i) * d i.
Definition extension u := (on_poly (num u) * to (den u) - to (num u) * on_poly (den u)) / to (den u) ^+ 2.

Lemma on_polyD p q : on_poly (p + q) = on_poly p + on_poly q.
Proof. by rewrite /on_poly -big_split; apply: eq_bigr => i _; rewrite mderivD rmorphD mulrDl. Qed.
Lemma on_polyM p q : on_poly (p * q) = on_poly p * to q + to p * on_poly q.
Proof.
rewrite /on_poly mulr_suml mulr_sumr -big_split; apply: eq_bigr => i _.
by rewrite mderivM rmorphD !rmorphM /=; ring.
Qed.
Lemma on_polyC a : on_poly a%:MP = 0.
Proof. by rewrite /on_poly big1 // => i _; rewrite mderivC rmorph0 mul0r. Qed.

Lemma extensionE p q : to q != 0 -> extension (to p / to q) =
  (on_poly p * to q - to p * on_poly q) / to q ^+ 2.
Proof.
move=> q0; rewrite /extension; set u := to p / to q; have b0 := den0 u.
have e : num u * q = p * den u.
  apply/eqP; rewrite -subr_eq0 -to0 rmorphB !rmorphM subr_eq0 /=.
  by rewrite -eqr_div // -fracE.
have := congr1 on_poly e; rewrite !on_polyM => e'.
have := congr1 to e; rewrite !rmorphM /= => e0.
apply/eqP; rewrite eqr_div ?expf_neq0 //; apply/eqP.
move: (on_poly (num u)) (on_poly (den u)) (on_poly p) (on_poly q) e' => da db dp dq e'.
have {}e' : da * to q = dp * to (den u) + to p * db - to (num u) * dq by rewrite -e' addrK.
have -> : (da * to (den u) - to (num u) * db) * to q ^+ 2 =
  (da * to q) * to (den u) * to q - (to (num u) * to q) * db * to q by ring.
rewrite e'; transitivity (dp * to q * to (den u) ^+ 2 - (to (num u) * to q) * dq * to (den u));
  last by rewrite e0; ring.
transitivity (dp * to q * to (den u) ^+ 2 + (to p * to (den u)) * db * to q - (to (num u) * to q) * dq * to
  (den u) -
  (to (num u) * to q) * db * to q); [ring | rewrite e0; ring].
Qed.

Lemma extension_poly p : extension (to p) = on_poly p.
Proof.
have := @extensionE p 1; rewrite rmorph1 divr1 => -> //; last exact: oner_neq0.
by rewrite -mpolyC1 on_polyC mulr0 subr0 mulr1 expr1n divr1.
Qed.

Lemma extension_derivation : derivation extension.
Proof.
split=> [u w|u w|a].
- have e : u + w = to (num u * den w + num w * den u) / to (den u * den w).
    by rewrite rmorphD !rmorphM /= {1}(fracE u) {1}(fracE w) addf_div.
  rewrite e extensionE; last by rewrite rmorphM mulf_neq0.
  rewrite /extension on_polyD !on_polyM rmorphD !rmorphM /=.
  have := den0 u; have := den0 w; move=> h1 h2; field; by rewrite h1.
- have e : u * w = to (num u * num w) / to (den u * den w).
    by rewrite !rmorphM /= {1}(fracE u) {1}(fracE w) mulf_div.
  rewrite e extensionE; last by rewrite rmorphM mulf_neq0.
  rewrite /extension !on_polyM !rmorphM /= [X in _ = _ * X + _](fracE w) [X in _ = _ + X * _](fracE u).
  have := den0 u; have := den0 w; move=> h1 h2; field; by rewrite h1.
- by rewrite extension_poly on_polyC.
Qed.

Lemma extension_param i : extension (to 'X_i) = d i.
Proof.
rewrite extension_poly /on_poly (bigD1 i) //= big1 => [|j ji]; rewrite mderivX mnm1E.
  by rewrite eqxx scale1r -{1}(addm0 U_(i)%MM) addmC addmK mpolyX0 rmorph1 mul1r addr0.
by rewrite eq_sym (negbTE ji) scale0r rmorph0 mul0r.
Qed.
End Extension.

(** A derivation is determined by its values at the parameters. *)
Lemma derivation_param D : derivation D -> (forall i, D (to 'X_i) = 0) -> forall u, D u = 0.
Proof.
move=> dD z; have zp p : D (to p) = 0.
  have -> : to p = value const (fun i => to 'X_i) p.
    rewrite /value {1}(mpolyE p) /mmap rmorph_sum; apply: eq_bigr => M _.
    rewrite -mul_mpolyC rmorphM /= mpolyXE_id rmorph_prod; congr (_ * _).
    by apply: eq_bigr => i _; rewrite rmorphX.
  by rewrite (der_value dD) big1 // => i _; rewrite z mulr0.
by move=> u; rewrite (fracE u) (der_div dD) // !zp mul0r mulr0 subrr mul0r.
Qed.

(** ** Degrees *)
Lemma degM p q a b : (msize p <= a.+1)%N -> (msize q <= b.+1)%N -> (msize (p * q) <= (a + b).+1)%N.
Proof.
have [->|p0] := eqVneq p 0; first by rewrite mul0r msize0.
have [->|q0] := eqVneq q 0; first by rewrite mulr0 msize0.
rewrite msizeM // => h1 h2; rewrite -subn1 leq_subLR add1n.
by apply: leq_trans (leq_add h1 h2) _; rewrite addSn addnS.
Qed.
Lemma degX p a k : (msize p <= a.+1)%N -> (msize (p ^+ k) <= (a * k).+1)%N.
Proof.
move=> h; elim: k => [|k IH]; first by rewrite expr0 msize1.
by rewrite exprS mulnS degM.
Qed.
Lemma deg_prod I (r : seq I) (G : I -> P) a : (forall i, (msize (G i) <= a.+1)%N) ->
  (msize (\prod_(i <- r) G i) <= (size r * a).+1)%N.
Proof.
move=> h; elim: r => [|i r IH]; first by rewrite big_nil msize1.
by rewrite big_cons mulSn degM.
Qed.
Lemma bound_card N : (#|{: 'X_{1..n < N.+1}}| <= N.+1 ^ n)%N.
Proof.
pose f (M : 'X_{1..n < N.+1}) := [ffun i : 'I_n => inord (M i) : 'I_N.+1].
have fi : injective f.
  have small (M : 'X_{1..n < N.+1}) i : (M i < N.+1)%N.
    by apply: leq_ltn_trans (bmdeg M); rewrite mdegE (bigD1 i) //= leq_addr.
  move=> M M' /ffunP e; apply/val_inj/mnmP => i; have := congr1 val (e i).
  by rewrite !ffunE /= !inordK.
by have := leq_card f fi; rewrite card_ffun !card_ord.
Qed.

(** ** Exchange *)
Section Counting.
Variable z : 'I_n.+1 -> K.
Definition g : P := \prod_i den (z i).
Definition numer i : P := num (z i) * \prod_(j | j != i) den (z j).
Lemma g0 : to g != 0.
Proof. by rewrite rmorph_prod; apply/prodf_neq0 => i _; exact: den0. Qed.
Lemma numerE i : to (numer i) = z i * to g.
Proof. by rewrite /g (bigD1 i) //= !rmorphM /= mulrA [X in _ = X * _ * _]fracE divfK. Qed.

Definition deg := (msize g + \max_i msize (numer i))%N.
Definition big := ((n.+1 * deg).+1 ^ n).+1%N.
Notation exponents := {ffun 'I_n.+1 -> 'I_big}.
Definition word (e : exponents) : P := \prod_i (numer i ^+ e i * g ^+ (big - e i)).
Definition bound := (n.+1 * (deg * big))%N.
Lemma size_word e : (msize (word e) <= bound.+1)%N.
Proof.
have -> : bound = (size (index_enum [finType of 'I_n.+1]) * (deg * big))%N.
  by rewrite -[index_enum _]enumT size_enum_ord.
apply: deg_prod => i; have -> : (deg * big = deg * e i + deg * (big - e i))%N.
  by rewrite -mulnDr subnKC // ltnW.
apply: degM; apply: degX; apply: leqW; rewrite /deg.
  by apply: leq_trans (leq_addl _ _); exact: (leq_bigmax i).
exact: leq_addr.
Qed.
Lemma wordE e : to (word e) = (\prod_i z i ^+ e i) * to g ^+ (n.+1 * big).
Proof.
rewrite rmorph_prod; transitivity (\prod_i (z i ^+ e i * to g ^+ big)).
  apply: eq_bigr => i _; rewrite rmorphM !rmorphX /= numerE exprMn -mulrA -exprD subnKC //.
  exact: ltnW.
by rewrite big_split /= prodr_const card_ord -exprM mulnC.
Qed.

Lemma more_words : (#|{: 'X_{1..n < bound.+1}}| < #|{: exponents}|)%N.
Proof.
apply: leq_ltn_trans (bound_card _) _; rewrite card_ffun !card_ord expnSr.
have h : (bound.+1 <= big * (n.+1 * deg).+1)%N.
  by rewrite mulnS -add1n leq_add // /bound mulnA mulnC.
apply: leq_ltn_trans (_ : (big * (n.+1 * deg).+1) ^ n < _)%N; first by case: (n) h => // k h;
  rewrite leq_exp2r.
by rewrite expnMn ltn_mul2l expn_gt0 /= ltnS leqnn.
Qed.

(** So n+1 elements of K are not independent. *)
Lemma dependent : exists2 Q : {mpoly F[n.+1]}, Q != 0 & value const z Q = 0.
Proof.
have [v [a va] vz] := more_rows (fun e (M : 'X_{1..n < bound.+1}) => (word e)@_M) more_words.
have vw : \sum_e v e *: word e = 0.
  apply/mpolyP => M; rewrite mcoeff0 raddf_sum /=; case: (ltnP (mdeg M) bound.+1) => lt.
    by rewrite -[RHS](vz (BMultinom lt)); apply: eq_bigr => e _; rewrite mcoeffZ.
  rewrite big1 // => e _; rewrite mcoeffZ memN_msupp_eq0 ?mulr0 //.
  by apply: msize_mdeg_ge; exact: leq_trans (size_word e) lt.
pose mon (e : exponents) : 'X_{1..n.+1} := [multinom (e i : nat) | i < n.+1].
have mon_inj e e' : mon e = mon e' -> e = e'.
  by move=> /mnmP em; apply/ffunP => i; apply/val_inj; have := em i; rewrite !mnmE.
exists (\sum_e v e *: 'X_[mon e]).
  have : (\sum_e v e *: 'X_[mon e])@_(mon a) != 0.
    rewrite raddf_sum (bigD1 a) //= mcoeffZ mcoeffX eqxx mulr1 big1 ?addr0 // => e ea.
    by rewrite mcoeffZ mcoeffX; case: eqP => [/mon_inj em|]; rewrite ?mulr0 //; rewrite em eqxx in ea.
  by apply: contraNneq => ->; rewrite mcoeff0.
have G0 : to g ^+ (n.+1 * big) != 0 by rewrite expf_neq0 ?g0.
apply/eqP; rewrite -(inj_eq (mulIf G0)) mul0r; apply/eqP.
transitivity (to (\sum_e v e *: word e)); last by rewrite vw rmorph0.
rewrite /value (rmorph_sum (mmap_rmorphism z const)) mulr_suml rmorph_sum; apply: eq_bigr => e _.
rewrite /= mmapZ -mul_mpolyC rmorphM /= wordE mulrA; congr (_ * _ * _).
by rewrite mmapX; apply: eq_bigr => i _; rewrite mnmE.
Qed.
End Counting.

Section Exchange.
Variables (y : 'I_n -> K) (u : K).
Hypothesis free_y : independent const y.
Definition z (i : 'I_n.+1) : K := if unlift ord_max i is Some j then y j else u.
Notation big := (big z).
Notation exponents := {ffun 'I_n.+1 -> 'I_big}.
Notation bound := (bound z).
Notation word := (word (z := z)).
Notation g := (g z).

Definition mono (e : exponents) : 'X_{1..n} := [multinom (e (lift ord_max j) : nat) | j < n].
Lemma mono_inj e e' : mono e = mono e' -> (e ord_max : nat) = e' ord_max -> e = e'.
Proof.
move=> /mnmP em el; apply/ffunP => i; apply/val_inj.
by case: (unliftP ord_max i) => [j|] -> //; have := em j; rewrite !mnmE.
Qed.

Lemma monoE (e : exponents) : \prod_i z i ^+ e i = value const y 'X_[mono e] * u ^+ e ord_max.
Proof.
rewrite /value mmapX (bigD1_ord ord_max) //= {1}/z unlift_none mulrC; congr (_ * _).
by apply: eq_bigr => j _; rewrite /z liftK mnmE.
Qed.

Theorem exchange : algebraic const y u.
Proof.
have [v [a va] vz] := more_rows (fun e (M : 'X_{1..n < bound.+1}) => (word e)@_M) (@more_words z).
have vw : \sum_e v e *: word e = 0.
  apply/mpolyP => M; rewrite mcoeff0 raddf_sum /=; case: (ltnP (mdeg M) bound.+1) => lt.
    by rewrite -[RHS](vz (BMultinom lt)); apply: eq_bigr => e _; rewrite mcoeffZ.
  rewrite big1 // => e _; rewrite mcoeffZ memN_msupp_eq0 ?mulr0 //.
  by apply: msize_mdeg_ge; exact: leq_trans (size_word e) lt.
pose p : {poly P} := \sum_e (v e *: 'X_[mono e]) *: 'X^(e ord_max).
have pE k M : (p`_k)@_M = \sum_e v e * ((mono e == M) && (e ord_max == k :> nat))%:R.
  rewrite /p coef_sum raddf_sum; apply: eq_bigr => e _.
  rewrite coefZ coefXn eq_sym /=; case: (_ == k); last by rewrite andbF !mulr0 mcoeff0.
  by rewrite andbT mulr1 mcoeffZ mcoeffX.
exists p.
  have : (p`_(a ord_max))@_(mono a) != 0.
    rewrite pE (bigD1 a) //= !eqxx mulr1 big1 ?addr0 // => e ea.
    by case: eqP => [em|]; rewrite ?mulr0 //; case: eqP => [el|]; rewrite ?mulr0 //; case/eqP: ea;
      exact: mono_inj.
  apply: contraNneq => /(congr1 (fun q : {poly K} => q`_(a ord_max))).
  by rewrite coef_map_id0 ?coef0; [move/free_y => ->; rewrite mcoeff0 | rewrite /value mmap0].
have -> : values const y p = \sum_e value const y (v e *: 'X_[mono e]) *: 'X^(e ord_max).
  rewrite -[values _ _ _]/(map_poly (mmap_rmorphism y const) p) rmorph_sum; apply: eq_bigr => e _.
  by rewrite /= map_polyZ map_polyXn.
rewrite /root horner_sum; have G0 : to g ^+ (n.+1 * big) != 0 by rewrite expf_neq0 ?g0.
rewrite -(inj_eq (mulIf G0)) mul0r; apply/eqP.
transitivity (to (\sum_e v e *: word e)); last by rewrite vw rmorph0.
rewrite mulr_suml rmorph_sum; apply: eq_bigr => e _.
have -> : to (v e *: word e) = const (v e) * to (word e) by rewrite -mul_mpolyC rmorphM.
have -> : value const y (v e *: 'X_[mono e]) = const (v e) * value const y 'X_[mono e]
  by rewrite /value mmapZ.
by rewrite hornerZ hornerXn wordE monoE !mulrA.
Qed.
End Exchange.

(** ** The Jacobian criterion, for as many elements as parameters *)
Definition unmoved (y : 'I_n -> K) := forall D, derivation D -> (forall j, D (y j) = 0) -> forall u, D u = 0.

Lemma extension_sum d u : extension d u = \sum_i d i * extension (fun k => (k == i)%:R) u.
Proof.
have onE p : on_poly d p = \sum_i d i * on_poly (fun k => (k == i)%:R) p.
  apply: eq_bigr => i _; rewrite mulrC /on_poly (bigD1 i) //= eqxx mulr1 big1 ?addr0 // => k ki.
  by rewrite (negbTE ki) mulr0.
rewrite /extension !onE mulr_suml mulr_sumr -sumrB mulr_suml; apply: eq_bigr => i _.
by rewrite !mulrA [_ * d i]mulrC -!mulrA -mulrBr -mulrA.
Qed.

Hypothesis char0 : [char F] =i pred0.

(** The partial derivatives of y. *)
Definition jacobian (y : 'I_n -> K) := \matrix_(i, j) extension (fun k => (k == i)%:R) (y j).

Lemma unmoved_jacobian (y : 'I_n -> K) : unmoved y -> \det (jacobian y) != 0.
Proof.
move=> un; apply/det0P => -[d d0 dJ]; case/rV0Pn: d0 => i /eqP; apply.
rewrite -(extension_param (d 0)); apply: un; first exact: extension_derivation.
move=> j; rewrite extension_sum; have := congr1 (fun M : 'rV_n => M 0 j) dJ; rewrite mxE [RHS]mxE => e.
by apply: etrans e; apply: eq_bigr => k _; rewrite mxE.
Qed.

Lemma jacobian_free (y : 'I_n -> K) : \det (jacobian y) != 0 -> independent const y.
Proof.
move=> J0; apply: (jacobian_independent char0 (Ds := fun i => extension (fun k => (k == i)%:R))) =>
  [i|h hJ j].
  exact: extension_derivation.
apply/eqP; apply: contraNT J0 => hj; rewrite -det_tr; apply/det0P; exists (\row_k h k).
  by apply/rV0Pn; exists j; rewrite mxE.
by apply/rowP => i; rewrite !mxE; apply: etrans (hJ i); apply: eq_bigr => k _; rewrite !mxE.
Qed.

Lemma finite_unmoved (y : 'I_n -> K) : (forall u, algebraic const y u) -> unmoved y.
Proof. by move=> fin D dD Dy u; exact: algebraic_killed (fin u). Qed.

Theorem jacobian_criterion (y : 'I_n -> K) :
  [/\ independent const y <-> \det (jacobian y) != 0,
      independent const y <-> (forall u, algebraic const y u) &
      independent const y <-> unmoved y].
Proof.
have ex : independent const y -> forall u, algebraic const y u by move=> ind u; exact: exchange.
have un : independent const y -> unmoved y by move=> /ex; exact: finite_unmoved.
split; split=> //; first by move=> /un; exact: unmoved_jacobian.
- exact: jacobian_free.
- by move=> /finite_unmoved /unmoved_jacobian; exact: jacobian_free.
- by move=> /unmoved_jacobian; exact: jacobian_free.
Qed.
End Functions.
