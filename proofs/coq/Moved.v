(** * One more element

    A derivation D kills the elements y and moves w. Then w is independent of y ([moved_ind]), and
    what D kills is algebraic over F(y) if it is over F(y, w) ([moved_alg]). *)
From mathcomp Require Import all_ssreflect all_algebra.
From SsrMultinomials Require Import mpoly.
From PL1P Require Import Derivations RationalFunctions Independence.
Set Implicit Arguments.
Unset Strict Implicit.
Unset Printing Implicit Defensive.
Import GRing.Theory.
Local Open Scope ring_scope.

(** ** Polynomials in which the last unknown does not occur *)
Section Last.
Variables (F : fieldType) (m : nat).
Hypothesis char0 : [char F] =i pred0.
Notation P := {mpoly F[m.+1]}.
Definition up : {rmorphism {mpoly F[m]} -> P} :=
  [rmorphism of mmap (@mpolyC m.+1 F) (fun j : 'I_m => 'X_(lift ord_max j))].
Definition down : {rmorphism P -> {mpoly F[m]}} :=
  [rmorphism of mmap (@mpolyC m F) (fun i : 'I_m.+1 => if unlift ord_max i is Some j then 'X_j else 0)].
Lemma last_const (Q : P) : Q^`M(ord_max) = 0 -> up (down Q) = Q.
Proof.
move=> dQ; rewrite [RHS]mpolyE [in LHS](mpolyE Q) (rmorph_sum down) (rmorph_sum up);
  apply: eq_big_seq => M Mq.
have M0 : M ord_max = 0%N.
  apply/eqP; rewrite -leqn0 leqNgt; apply/negP => lt; move: Mq; rewrite mcoeff_msupp => /negP; apply.
  have := congr1 (mcoeff (M - U_(ord_max))%MM) dQ; rewrite mcoeff_mderiv mcoeff0 submK; last first.
    by apply/mnm_lepP => i; rewrite mnm1E; case: eqP => // <-.
  by move/eqP; rewrite -mulr_natr mulf_eq0 ((charf0P F).1 char0) orbF.
rewrite -mul_mpolyC (rmorphM down) (rmorphM up) /= !mmapC; congr (_ * _).
rewrite -[mmap _ _ _]/(up (down _)) mpolyXE_id (rmorph_prod down) (rmorph_prod up); apply: eq_bigr => i _.
rewrite (rmorphX down) (rmorphX up) /= !(mmapX, mmap1U); case: unliftP => [j ->|->];
  last by rewrite M0 !expr0.
by rewrite mmapX mmap1U.
Qed.
End Last.
Arguments up {F m}.
Arguments down {F m}.

Section Moved.
Variables (F K : fieldType) (c : {rmorphism F -> K}) (D : K -> K) (y : seq K) (w : K).
Hypothesis char0 : [char F] =i pred0.
Hypothesis hD : derivation c D.
Hypothesis Dy : killed D y.
Hypothesis Dw : D w != 0.
Notation m := (size y).
Notation P := {mpoly F[m.+1]}.
Definition more (i : 'I_m.+1) : K := nth 0 (rcons y w) i.
Notation yy := (fun j : 'I_m => nth 0 y j).
Lemma more_lift j : more (lift ord_max j) = nth 0 y j.
Proof. by rewrite /more nth_rcons lift_max ltn_ord. Qed.
Lemma value_up R : value c more (up R) = value c yy R.
Proof.
apply: (@morphism_eq F _ K [rmorphism of mmap_rmorphism more c \o @up F (size y)]
  (mmap_rmorphism yy c)) => [a|i] /=.
  by rewrite !mmapC.
by rewrite !(mmapX, mmap1U) more_lift.
Qed.
Lemma moved_value (Q : P) : D (value c more Q) = value c more Q^`M(ord_max) * D w.
Proof.
rewrite (der_value hD) (bigD1_ord ord_max) //= big1 ?addr0 => [|j _].
  by rewrite /more nth_rcons ltnn eqxx.
by rewrite more_lift ((killedP D erefl).1 Dy) mulr0.
Qed.

Theorem moved_ind : ind c y -> ind c (rcons y w).
Proof.
move=> iy; apply/(indE c (size_rcons y w)) => Q.
have [k] := ubnP (msize Q); elim: k Q => // k IH Q; rewrite ltnS => le v0.
have [z|nz] := posnP k; first by apply/eqP; rewrite -msize_poly_eq0 -leqn0 -z.
have d0 : Q^`M(ord_max) = 0.
  apply: IH; first by rewrite -[X in (_ < X)%N](prednK nz) ltnS msize_mderiv ?prednK.
  have := moved_value Q; rewrite v0 (der0 hD) => /esym/eqP; rewrite mulf_eq0 (negbTE Dw) orbF.
  by move/eqP.
rewrite -(last_const char0 d0) (iy (down Q)) ?rmorph0 // -value_up last_const //.
Qed.

Theorem moved_alg u : ind c (rcons y w) -> D u = 0 -> alg c (rcons y w) u -> alg c y u.
Proof.
move=> /(indE c (size_rcons y w)) iw Du /(algE c u (size_rcons y w))[p].
have vE k (z : 'I_k -> K) q i : (values c z q)`_i = value c z q`_i.
  by rewrite /values coef_map_id0 // /value mmap0.
have [k] := ubnP (\max_(i < size p) msize p`_i); elim: k p => // k IH p; rewrite ltnS => le p0 rt.
have small i : (msize p`_i <= k)%N.
  case: (ltnP i (size p)) => [lt|ge]; last by rewrite nth_default // msize0.
  by apply: leq_trans le; exact: (leq_bigmax (Ordinal lt)).
pose q := map_poly (mderiv ord_max) p.
have qE i : q`_i = (p`_i)^`M(ord_max) by rewrite /q coef_map_id0 // mderiv0.
have rq : root (values c more q) u.
  have e : D (values c more p).[u] = (values c more q).[u] * D w.
    rewrite (horner_coef_wide (n := size p)) ?size_poly // (der_sum hD).
    rewrite (horner_coef_wide (n := size p)); last by apply: leq_trans (size_poly _ _) (size_poly _ _).
    rewrite mulr_suml; apply: eq_bigr => i _; rewrite (derM hD) (der_exp hD) Du !mulr0 addr0.
    by rewrite !vE moved_value qE mulrAC.
  move: e; rewrite (rootP rt) (der0 hD) => /esym/eqP; rewrite mulf_eq0 (negbTE Dw) orbF.
  exact.
have [q0|q0] := eqVneq (values c more q) 0; last first.
  apply: (IH q) => //; apply: leq_ltn_trans (_ : k.-1 < k)%N; last first.
    rewrite prednK // lt0n; apply: contraNneq p0 => k0; apply/eqP/polyP => i; rewrite coef0 vE.
    by have := small i; rewrite k0 leqn0 msize_poly_eq0 => /eqP ->; rewrite /value mmap0.
  by apply/bigmax_leqP => i _; rewrite qE msize_mderiv // (leq_trans (small i)) // leqSpred.
exists (map_poly down p).
  apply: contraNneq p0 => e; apply/eqP/polyP => i; have := congr1 (fun r : {poly K} => r`_i) e.
  rewrite !coef0 !vE coef_map -value_up last_const // -qE; apply: iw.
  by rewrite -vE q0 coef0.
rewrite (_ : values c yy _ = values c more p) //; apply/polyP => i.
rewrite !vE coef_map -value_up last_const // -qE; apply: iw.
by rewrite -vE q0 coef0.
Qed.
End Moved.

(** ** More elements, in another order *)
Section More.
Variables (F K : fieldType) (c : {rmorphism F -> K}).
Lemma alg_sub (y z : seq K) u : {subset y <= z} -> alg c y u -> alg c z u.
Proof.
move=> sub [p p0 rt].
have lt (j : 'I_(size y)) : (index (nth 0%R y j) z < size z)%N by rewrite index_mem sub ?mem_nth.
pose ren := [rmorphism of mmap (@mpolyC (size z) F) (fun j : 'I_(size y) => 'X_(Ordinal (lt j)))].
have e q : value c (fun i : 'I_(size z) => nth 0 z i) (ren q) = value c (fun j : 'I_(size y) => nth 0 y j) q.
  apply: (@morphism_eq F _ K [rmorphism of mmap_rmorphism (fun i : 'I_(size z) => nth 0 z i) c \o ren]
    (mmap_rmorphism (fun j : 'I_(size y) => nth 0 y j) c)) => [a|i] /=; first by rewrite !mmapC.
  by rewrite !(mmapX, mmap1U) /= nth_index ?sub ?mem_nth.
have pe : values c (fun i : 'I_(size z) => nth 0 z i) (map_poly ren p) =
    values c (fun j : 'I_(size y) => nth 0 y j) p.
  apply/polyP => i; rewrite /values !coef_map_id0 ?[value _ _ 0]mmap0 ?rmorph0 //; exact: e.
by exists (map_poly ren p); rewrite pe.
Qed.
End More.

(** ** Fewer elements than parameters: some derivation kills them, and is not zero *)
Section Mover.
Variables (F : fieldType) (n : nat).
Variables (K : fieldType) (to : {rmorphism {mpoly F[n]} -> K}) (num den : K -> {mpoly F[n]}).
Hypothesis den0 : forall u, to (den u) != 0.
Hypothesis fracE : forall u, u = to (num u) / to (den u).
Hypothesis to0 : forall p, (to p == 0) = (p == 0).
Lemma mover (y : seq K) : (size y < n)%N ->
  exists2 D, derivation (const to) D /\ killed D y & exists i, D (to 'X_i) != 0.
Proof.
move=> lt; have [|v [a va] vz] := @more_rows K [finType of 'I_n] [finType of 'I_(size y)]
    (fun a b => extension to num den (fun k => (k == a)%:R) (nth 0 y b)).
  by rewrite !card_ord.
exists (extension to num den v); last by exists a; rewrite extension_param.
split; first exact: extension_derivation.
by apply/(killedP _ erefl) => j; rewrite extension_sum; exact: vz.
Qed.
End Mover.
