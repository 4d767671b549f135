(** * Derivations of a field, and polynomials that vanish

    K is a field over F. A derivation of K over F kills F. By the chain rule it acts on polynomials
    in elements y of K as differentiation in y does. Two consequences in characteristic 0: elements
    whose derivatives are independent satisfy no polynomial equation; and a derivation that kills y
    kills what is algebraic over F(y). *)
From Coq Require Import ZArith.
From mathcomp Require Import all_ssreflect all_algebra.
From mathcomp.algebra_tactics Require Import ring.
From mathcomp.zify Require Import ssrZ.
From SsrMultinomials Require Import mpoly.
Set Implicit Arguments.
Unset Strict Implicit.
Unset Printing Implicit Defensive.
Import GRing.Theory.
Local Open Scope ring_scope.

Section Derivations.
Variables (F K : fieldType) (c : {rmorphism F -> K}).
Hypothesis char0 : [char F] =i pred0.
Implicit Types (u w : K) (D : K -> K).

Definition derivation D :=
  [/\ forall u w, D (u + w) = D u + D w, forall u w, D (u * w) = D u * w + u * D w & forall a, D (c a) = 0].

(** The value of a polynomial at y. *)
Definition value m (y : 'I_m -> K) (Q : {mpoly F[m]}) : K := mmap c y Q.

Section Rules.
Variable D : K -> K.
Hypothesis dD : derivation D.
Lemma derD u w : D (u + w) = D u + D w. Proof. by case: dD. Qed.
Lemma derM u w : D (u * w) = D u * w + u * D w. Proof. by case: dD. Qed.
Lemma derC a : D (c a) = 0. Proof. by case: dD. Qed.
Lemma der0 : D 0 = 0. Proof. by have := derC 0; rewrite rmorph0. Qed.
Lemma der1 : D 1 = 0. Proof. by have := derC 1; rewrite rmorph1. Qed.
Lemma derN u : D (- u) = - D u.
Proof. by apply/eqP; rewrite -addr_eq0 -derD addNr der0. Qed.
Lemma derB u w : D (u - w) = D u - D w. Proof. by rewrite derD derN. Qed.
Lemma der_sum I r (P : pred I) G : D (\sum_(i <- r | P i) G i) = \sum_(i <- r | P i) D (G i).
Proof. by apply: (big_morph D derD der0). Qed.
Lemma der_exp u k : D (u ^+ k) = u ^+ k.-1 *+ k * D u.
Proof.
elim: k => [|k IH]; first by rewrite expr0 der1 mulr0n mul0r.
rewrite exprS derM IH /=; case: k {IH} => [|k]; first by rewrite expr0 mulr0n; ring.
by rewrite /= -mulr_natr -[X in _ = X * _]mulr_natr !exprS [k.+2%:R]mulrS; ring.
Qed.
Lemma der_div u w : w != 0 -> D (u / w) = (D u * w - u * D w) / w ^+ 2.
Proof.
move=> w0; have e : D u = D (u / w) * w + u / w * D w by rewrite -derM divfK.
by rewrite e; field.
Qed.

Lemma der_value m (y : 'I_m -> K) Q : D (value y Q) = \sum_j value y Q^`M(j) * D (y j).
Proof.
rewrite /value; have mmapM := rmorphM (mmap_rmorphism y c); rewrite /= in mmapM.
have clC a : D (mmap c y a%:MP) = \sum_j mmap c y (mderiv j a%:MP) * D (y j).
  by rewrite mmapC derC big1 // => j _; rewrite mderivC mmap0 mul0r.
have cl1 : D (mmap c y 1) = \sum_j mmap c y (mderiv j 1) * D (y j) by rewrite -mpolyC1; exact: clC.
have clD P R : D (mmap c y P) = \sum_j mmap c y P^`M(j) * D (y j) ->
    D (mmap c y R) = \sum_j mmap c y R^`M(j) * D (y j) -> D (mmap c y (P + R)) =
      \sum_j mmap c y (P + R)^`M(j) * D (y j).
  move=> eP eR; rewrite mmapD derD eP eR -big_split /=; apply: eq_bigr => j _.
  by rewrite mderivD mmapD mulrDl.
have clM P R : D (mmap c y P) = \sum_j mmap c y P^`M(j) * D (y j) ->
    D (mmap c y R) = \sum_j mmap c y R^`M(j) * D (y j) -> D (mmap c y (P * R)) =
      \sum_j mmap c y (P * R)^`M(j) * D (y j).
  move=> eP eR; rewrite mmapM derM eP eR mulr_suml mulr_sumr -big_split /=; apply: eq_bigr => j _.
  by rewrite mderivM mmapD !mmapM; ring.
have clX i : D (mmap c y 'X_i) = \sum_j mmap c y ('X_i)^`M(j) * D (y j).
  rewrite mmapX mmap1U (bigD1 i) //= big1 => [|j ji]; rewrite mderivX.
    by rewrite mnm1E eqxx scale1r -{1}(addm0 U_(i)%MM) addmC addmK mpolyX0 rmorph1 mul1r addr0.
  by rewrite mnm1E eq_sym (negbTE ji) scale0r mmap0 mul0r.
elim/mpolyind: Q => [|a M p _ _ IH]; first by rewrite -mpolyC0; exact: clC.
apply: (clD) => //; rewrite -mul_mpolyC; apply: (clM); first exact: clC.
pose chain R := D (mmap c y R) = \sum_j mmap c y R^`M(j) * D (y j).
rewrite mpolyXE_id; apply: (big_ind chain) => [||i _]; [exact: cl1 | exact: clM | rewrite /chain].
by elim: (M i) => [|k IHk]; [exact: cl1 | rewrite exprS; apply: (clM)].
Qed.
End Rules.

Lemma natr0 k : (k.+1%:R == 0 :> F) = false.
Proof. by have /charf0P -> := char0. Qed.

(** ** Independent derivatives: no equation *)
Definition independent m (y : 'I_m -> K) := forall Q : {mpoly F[m]}, value y Q = 0 -> Q = 0.

Lemma msize_mderiv m (Q : {mpoly F[m]}) k j : (msize Q <= k.+1)%N -> (msize Q^`M(j) <= k)%N.
Proof.
move=> le; rewrite msizeE; apply/bigmax_leqP_seq => M; rewrite mcoeff_msupp mcoeff_mderiv => nz _.
have : (M + U_(j))%MM \in msupp Q by rewrite mcoeff_msupp; apply: contraNneq nz => ->; rewrite mul0rn.
by move/msize_mdeg_lt/leq_trans/(_ le); rewrite mdegD mdeg1 addn1 ltnS.
Qed.

Lemma mderiv_eq0 m (Q : {mpoly F[m]}) : (forall j, Q^`M(j) = 0) -> exists a, Q = a%:MP.
Proof.
move=> z; exists (Q@_0); apply/mpolyP => M; rewrite mcoeffC; case: (eqVneq 0%MM M) => [<-|nz];
  first by rewrite mulr1.
rewrite mulr0; have [j Mj] : exists j, (0 < M j)%N.
  apply/existsP; apply: contraNT nz; rewrite negb_exists => /forallP h; apply/eqP/mnmP => j.
  by rewrite mnm0E; have := h j; rewrite -eqn0Ngt => /eqP.
have := congr1 (mcoeff (M - U_(j))%MM) (z j).
rewrite mcoeff_mderiv mcoeff0 submK; last by apply/mnm_lepP => i; rewrite mnm1E; case: eqP => // <-.
by move/eqP; rewrite -mulr_natr mulf_eq0 natr0 orbF => /eqP.
Qed.

Theorem jacobian_independent m (y : 'I_m -> K) I (Ds : I -> K -> K) : (forall i, derivation (Ds i)) ->
  (forall g : 'I_m -> K, (forall i, \sum_j g j * Ds i (y j) = 0) -> forall j, g j = 0) -> independent y.
Proof.
move=> dD inj Q; have [k] := ubnP (msize Q); elim: k Q => // k IH Q; rewrite ltnS => le v0.
have [z|nz] := posnP k; first by apply/eqP; rewrite -msize_poly_eq0 -leqn0 -z.
have d0 j : value y Q^`M(j) = 0.
  by move: j; apply: inj => i; rewrite -der_value // v0 der0.
have [|a e] := @mderiv_eq0 _ Q.
  by move=> j; apply: IH (d0 j); rewrite -[X in (_ < X)%N](prednK nz) ltnS msize_mderiv ?prednK.
move: v0; rewrite e /value mmapC => /eqP; rewrite fmorph_eq0 => /eqP ->; exact: mpolyC0.
Qed.

(** ** A derivation that kills y kills what is algebraic over F(y) *)
Definition values m (y : 'I_m -> K) (p : {poly {mpoly F[m]}}) := map_poly (value y) p.
Definition algebraic m (y : 'I_m -> K) u := exists2 p, values y p != 0 & root (values y p) u.

Theorem algebraic_killed m (y : 'I_m -> K) u D : derivation D ->
  (forall j, D (y j) = 0) -> algebraic y u -> D u = 0.
Proof.
move=> dD Dy [p]; have [k] := ubnP (size p); elim: k p => // k IH p; rewrite ltnS => le p0 rt.
have coefE (q : {poly {mpoly F[m]}}) i : (values y q)`_i = value y q`_i
  by rewrite coef_map_id0 // /value mmap0.
have e : values y p^`() = (values y p)^`().
  by apply/polyP => i; rewrite coefE !coef_deriv coefE /value mmapMn.
have sle : (size (values y p) <= size p)%N by exact: size_poly.
have s1 : (1 < size (values y p))%N by exact: root_size_gt1 rt.
have d0 : (values y p)^`() != 0.
  have : ((values y p)^`())`_(size (values y p)).-2 != 0.
    rewrite coef_deriv -mulr_natr mulf_neq0 //.
      by rewrite prednK ?ltn_predRL // -lead_coefE lead_coef_eq0.
    by rewrite -[X in X != 0](rmorph_nat c) fmorph_eq0 natr0.
  by apply: contraNneq => ->; rewrite coef0.
have Dp : D (values y p).[u] = (values y p)^`().[u] * D u.
  rewrite horner_coef der_sum // (horner_coef_wide (n := (size (values y p)).-1)); last first.
    by rewrite -ltnS prednK ?lt_size_deriv // ltnW.
  have [n en] : exists n, size (values y p) = n.+1 by exists (size (values y p)).-1; rewrite prednK // ltnW.
  rewrite en big_ord_recl expr0 mulr1 (_ : D (values y p)`_0 = 0) ?add0r; last first.
    by rewrite coefE der_value // big1 // => j _; rewrite Dy mulr0.
  rewrite mulr_suml; apply: eq_bigr => i _.
  rewrite (derM dD) (der_exp dD u) /= coef_deriv (_ : D (values y p)`_(bump 0 i) = 0); last first.
    by rewrite coefE der_value // big1 // => j _; rewrite Dy mulr0.
  rewrite mul0r add0r /bump leq0n add1n /= -mulr_natr -[in RHS]mulr_natr !mulrA; congr (_ * _).
  by rewrite -!mulrA [_%:R * _]mulrC.
move: Dp; rewrite (rootP rt) der0 // => /esym/eqP; rewrite mulf_eq0 => /orP[r0|/eqP //].
apply: (IH p^`()); rewrite ?e //.
by apply: leq_trans le; apply: lt_size_deriv; apply: contraNneq p0 => ->; rewrite /values map_poly0.
Qed.
End Derivations.

(** ** Characteristic 0: two is not zero, and integers are not *)
Lemma two_neq0 (F K : fieldType) (c : {rmorphism F -> K}) : [char F] =i pred0 -> 2%:R != 0 :> K.
Proof. by move=> char0; rewrite -(rmorph_nat c) fmorph_eq0; have /charf0P -> := char0. Qed.
Section Integers.
Variable F : fieldType.
Hypothesis char0 : [char F] =i pred0.
Definition integers : {rmorphism Z -> F} := [rmorphism of intr \o int_of_Z].
Lemma integers0 z : (integers z == 0) = (z == 0).
Proof.
have nat0 := (charf0P F).1 char0.
have int0 (k : int) : (k%:~R == 0 :> F) = (k == 0).
  by case: k => k; rewrite ?NegzE ?rmorphN /= ?oppr_eq0 ?nat0.
by rewrite /= int0 -(inj_eq (can_inj Z_of_intK)) int_of_ZK.
Qed.
End Integers.
