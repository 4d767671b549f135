(** * Independent lists of rational functions

    K is the field of rational functions in n parameters. At most n elements are independent, at
    least n are needed to make K algebraic; so both hold for a list y if and only if y has n
    elements and only the zero derivation kills it ([criterion]). *)
From mathcomp Require Import all_ssreflect all_algebra generic_quotient.
From SsrMultinomials Require Import mpoly.
From PL1P Require Import Derivations RationalFunctions.
Set Implicit Arguments.
Unset Strict Implicit.
Unset Printing Implicit Defensive.
Import GRing.Theory.
Local Open Scope ring_scope.

(** Ring morphisms from polynomials agree if they agree on constants and unknowns. *)
Lemma morphism_eq (F : fieldType) m (R : ringType) (f g : {rmorphism {mpoly F[m]} -> R}) :
  (forall a, f a%:MP = g a%:MP) -> (forall i, f 'X_i = g 'X_i) -> f =1 g.
Proof.
move=> ec ex Q; rewrite (mpolyE Q) !rmorph_sum; apply: eq_bigr => M _.
rewrite -mul_mpolyC !rmorphM ec mpolyXE_id !rmorph_prod; congr (_ * _).
by apply: eq_bigr => i _; rewrite !rmorphX ex.
Qed.

(** ** A list is independent over F *)
Section Lists.
Variables (F K : fieldType) (c : {rmorphism F -> K}).
Definition ind (y : seq K) := independent c (fun j : 'I_(size y) => nth 0 y j).
Definition alg (y : seq K) u := algebraic c (fun j : 'I_(size y) => nth 0 y j) u.
Lemma indE m y : size y = m -> ind y <-> independent c (fun j : 'I_m => nth 0 y j).
Proof. by case: m /. Qed.
Lemma algE m y u : size y = m -> alg y u <-> algebraic c (fun j : 'I_m => nth 0 y j) u.
Proof. by case: m /. Qed.

Lemma independent_sub m k (y : 'I_m -> K) (y' : 'I_k -> K) (e : 'I_k -> 'I_m) : injective e ->
  (forall j, y' j = y (e j)) -> independent c y -> independent c y'.
Proof.
move=> ei ye iy Q v0; pose up := [rmorphism of mmap (@mpolyC m F) (fun j : 'I_k => 'X_(e j))].
pose down := [rmorphism of mmap (@mpolyC k F) (fun i : 'I_m => if [pick j | e j == i] is Some j then 'X_j
  else 0)].
have e1 : (mmap_rmorphism y c \o up)%FUN =1 mmap_rmorphism y' c.
  apply: (morphism_eq (f := [rmorphism of mmap_rmorphism y c \o up])) => [a|i] /=; first by rewrite !mmapC.
  by rewrite !(mmapX, mmap1U) ye.
have u0 : up Q = 0 by apply: iy; rewrite -[LHS]e1 in v0 *; exact: v0.
have e2 : (down \o up)%FUN =1 idfun.
  apply: (morphism_eq (f := [rmorphism of down \o up]) (g := [rmorphism of idfun])) => [a|i] /=;
    first by rewrite !mmapC.
  rewrite !(mmapX, mmap1U); case: pickP => [j /eqP /ei -> //|/(_ i)]; by rewrite eqxx.
by rewrite -[Q]e2 /= u0 mmap0.
Qed.

Lemma ind_take n y : (n <= size y)%N -> ind y -> independent c (fun j : 'I_n => nth 0 y j).
Proof.
move=> le; have ei : injective (widen_ord le) by move=> i j /(congr1 val) /= /val_inj.
exact: independent_sub ei _.
Qed.
End Lists.

(** ** K in n parameters *)
Section Functions.
Variables (F : fieldType) (n : nat).
Notation P := {mpoly F[n]}.
Variables (K : fieldType) (to : {rmorphism P -> K}) (num den : K -> P).
Hypothesis den0 : forall u, to (den u) != 0.
Hypothesis fracE : forall u, u = to (num u) / to (den u).
Hypothesis to0 : forall p, (to p == 0) = (p == 0).
Hypothesis char0 : [char F] =i pred0.
Notation c := (const to).
Implicit Types y : seq K.

Lemma ind_size y : ind c y -> (size y <= n)%N.
Proof.
move=> iy; rewrite leqNgt; apply/negP => lt.
have [Q Q0 v0] := dependent den0 fracE (fun j : 'I_n.+1 => nth 0 y j).
by case/eqP: Q0; exact: (ind_take lt iy).
Qed.

Definition killed (D : K -> K) y := all (fun a => D a == 0) y.
Lemma killedP (D : K -> K) y m : size y = m -> killed D y <-> forall j : 'I_m, D (nth 0 y j) = 0.
Proof.
case: m /; split=> [/(all_nthP 0) h j|h]; first by apply/eqP/h.
by apply/(all_nthP 0) => j jl; have := h (Ordinal jl) => /= ->.
Qed.
Definition unmoved y := forall D, derivation c D -> killed D y -> forall i, D (to 'X_i) = 0.

Lemma unmoved_size y : unmoved y -> (n <= size y)%N.
Proof.
move=> un; rewrite leqNgt; apply/negP => lt.
have [|v [a va] vz] := @more_rows K [finType of 'I_n] [finType of 'I_(size y)]
    (fun a b => extension to num den (fun k => (k == a)%:R) (nth 0 y b)).
  by rewrite !card_ord.
have dv := extension_derivation den0 fracE to0 v.
have kill : killed (extension to num den v) y.
  by apply/(killedP _ erefl) => j; rewrite extension_sum; exact: vz.
by move: va; rewrite -(extension_param den0 fracE to0 v a) un ?eqxx.
Qed.
Lemma finite_unmoved_list y : (forall u, alg c y u) -> unmoved y.
Proof.
by move=> fin D dD kD i; apply: (algebraic_killed char0 dD _ (fin _)); exact/(killedP D erefl).
Qed.

Theorem criterion y : ind c y /\ (forall u, alg c y u) <-> size y = n /\ unmoved y.
Proof.
split=> [[iy /finite_unmoved_list un]|[sy un]].
  by split=> //; apply/eqP; rewrite eqn_leq ind_size ?unmoved_size.
have [_ [fin _] [_ back]] := jacobian_criterion den0 fracE to0 char0 (fun j : 'I_n => nth 0 y j).
have iy : independent c (fun j : 'I_n => nth 0 y j).
  apply: back => D dD kD u; apply: (derivation_param den0 fracE dD); apply: un => //; exact/(killedP D sy).
by split=> [|u]; [apply/(indE c sy) | apply/(algE c u sy); exact: fin].
Qed.
Lemma unmoved_ind y : (size y <= n)%N -> unmoved y -> ind c y.
Proof.
move=> le un; have sy : size y = n by apply/eqP; rewrite eqn_leq le unmoved_size.
by have [_ h] := criterion y; case: h.
Qed.
End Functions.

(** ** Fractions *)
Section Quotients.
Local Open Scope quotient_scope.
Lemma quotient_repr (R : idomainType) (u : {fraction R}) : u = FracField.tofrac (repr u).1 / FracField.tofrac
  (repr u).2.
Proof.
have d0 : (repr u).2 != 0 by exact: denom_ratioP.
apply: (mulIf (x := FracField.tofrac (repr u).2)); first by rewrite tofrac_eq0.
rewrite divfK ?tofrac_eq0 // -{1}[u]reprK; move: (repr u) d0 => x d0.
have t a : FracField.tofrac a = \pi_(FracField.type R) (Ratio a 1) by rewrite piE.
rewrite -[LHS]/(FracField.mul (\pi_(FracField.type R) x) (FracField.tofrac x.2)) !t -FracField.pi_mul.
apply/eqmodP; rewrite /= FracField.equivfE /FracField.mulf.
by rewrite !numden_Ratio ?mulf_neq0 ?oner_neq0 // !mulr1 mulrC.
Qed.
End Quotients.


Section Fractions.
Variable R : idomainType.
Definition numerator (u : {fraction R}) : R := (repr u).1.
Definition denominator (u : {fraction R}) : R := (repr u).2.
Lemma den_neq0 u : FracField.tofrac (denominator u) != 0.
Proof. by rewrite tofrac_eq0; exact: denom_ratioP. Qed.
Lemma fractionE (u : {fraction R}) : u = FracField.tofrac (numerator u) / FracField.tofrac (denominator u).
Proof. exact: quotient_repr. Qed.
End Fractions.
