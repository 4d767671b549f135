(** * Degree and camera-degree: definitions

    The degree of a minimal problem is the number of solutions of generic images over an algebraic
    closure, which is the dimension of K over F(y). The camera-degree counts their cameras: it is
    the dimension over F(y) of the field that y and the 11 parameters of the cameras generate.
    Lemma 1 of the paper says that they are equal (Lemma1.v). What else is proved of them is below
    ([degrees]; DegreeKept.v).

    Below: sums, products, quotients of quotients of polynomials are such quotients, and so is the
    solution of a system of linear equations with one solution only. *)
From mathcomp Require Import all_ssreflect all_algebra.
From mathcomp.algebra_tactics Require Import ring.
From SsrMultinomials Require Import mpoly.
From PL1P Require Import Statement Reducible Derivations RationalFunctions Independence.
From PL1P Require Import Generic Reduction CameraMinimal Replacements.
Set Implicit Arguments.
Unset Strict Implicit.
Unset Printing Implicit Defensive.
Import GRing.Theory.
Local Open Scope ring_scope.

Section Definitions.
Variables (F : fieldType) (n : nat).
Notation K := [fieldType of {fraction {mpoly F[n]}}].
(** u is in F(y): a quotient of two polynomials in y. *)
Definition rational (y : seq K) (u : K) := exists p q, at_y y q != 0 /\ u * at_y y q = at_y y p.
(** E has a basis of d elements over F(y). *)
Definition dimension (y : seq K) (E : K -> Prop) (d : nat) := exists b : 'I_d -> K,
  [/\ forall i, E (b i),
      forall u, E u -> exists2 a : 'I_d -> K, forall i, rational y (a i) & u = \sum_i a i * b i &
      forall a : 'I_d -> K, (forall i, rational y (a i)) -> \sum_i a i * b i = 0 ->
        forall i, a i = 0].
(** The images, and the parameters of the cameras. *)
Definition with_cameras (A : problem) : seq K := images F n A ++ mkseq (generic F n) 11.
End Definitions.
Definition degree (F : fieldType) A d :=
  let n := parameters A in dimension (images F n A) (fun=> True) d.
Definition camera_degree (F : fieldType) A d :=
  let n := parameters A in dimension (images F n A) (rational (with_cameras F n A)) d.

Definition lemma1 : Prop := forall F : fieldType, [char F] =i pred0 -> forall A, is_problem A ->
  minimal F A -> (forall u, rational (with_cameras F (parameters A) A) u) /\
  forall d, degree F A d <-> camera_degree F A d.
(** A problem has at most one degree, and a minimal one has a degree: the proof refutes that there
    is none, without finding it. One more view of a dangling pin keeps the camera-degree (Lemma 11).
    So which of two views sees the pin does not matter (Corollary 1). *)
Definition degrees : Prop := forall F : fieldType, [char F] =i pred0 ->
  [/\ forall A d d', degree F A d -> degree F A d' -> d = d',
      forall A d d', camera_degree F A d -> camera_degree F A d' -> d = d',
      forall A, minimal F A -> ~ ~ exists2 d, (0 < d)%N & degree F A d &
      forall A, camera_minimal F A -> ~ ~ exists2 d, (0 < d)%N & camera_degree F A d] /\
  forall A f B j u, is_problem (A ++ f :: B) ->
  (forall v d, dangles f j u v ->
     camera_degree F (A ++ f :: B) d <-> camera_degree F (A ++ reveal f j v :: B) d) /\
  (forall v w d, dangles f j u v -> dangles f j u w -> minimal F (A ++ reveal f j v :: B) ->
     degree F (A ++ reveal f j v :: B) d <-> degree F (A ++ reveal f j w :: B) d).

(** ** The fractions of a ring of elements of K *)
Section Fractions.
Variables (R : comRingType) (K : fieldType) (ev : {rmorphism R -> K}).
Definition fraction u := exists p q, ev q != 0 /\ u * ev q = ev p.
Lemma fr_of p : fraction (ev p).
Proof. by exists p, 1; rewrite rmorph1 oner_neq0 mulr1. Qed.
Lemma fr0 : fraction 0. Proof. by rewrite -(rmorph0 ev); exact: fr_of. Qed.
Lemma fr1 : fraction 1. Proof. by rewrite -(rmorph1 ev); exact: fr_of. Qed.
Lemma frD u w : fraction u -> fraction w -> fraction (u + w).
Proof.
case=> p [q [q0 e]] [s [t [t0 e']]]; exists (p * t + s * q), (q * t).
by rewrite rmorphM mulf_neq0 // rmorphD !rmorphM -e -e'; split=> //=; ring.
Qed.
Lemma frM u w : fraction u -> fraction w -> fraction (u * w).
Proof.
case=> p [q [q0 e]] [s [t [t0 e']]]; exists (p * s), (q * t).
by rewrite !rmorphM mulf_neq0 // -e -e'; split=> //=; ring.
Qed.
Lemma frN u : fraction u -> fraction (- u).
Proof. by case=> p [q [q0 e]]; exists (- p), q; rewrite rmorphN -e mulNr. Qed.
Lemma frB u w : fraction u -> fraction w -> fraction (u - w).
Proof. by move=> hu hw; apply: frD => //; exact: frN. Qed.
Lemma frV u : fraction u -> fraction u^-1.
Proof.
case=> p [q [q0 e]]; have [->|u0] := eqVneq u 0; first by rewrite invr0; exact: fr0.
by exists q, p; rewrite -e mulf_neq0 // mulKf.
Qed.
Lemma frMn u k : fraction u -> fraction (u *+ k).
Proof.
by move=> hu; rewrite -mulr_natr; apply: frM => //; rewrite -(rmorph_nat ev); exact: fr_of.
Qed.
Lemma frX u k : fraction u -> fraction (u ^+ k).
Proof.
by move=> hu; elim: k => [|k IH]; [rewrite expr0; exact: fr1 | rewrite exprS; exact: frM].
Qed.

(** A system of linear equations with one solution only. *)
Lemma fr_det m (B : 'M[K]_m) : (forall i j, fraction (B i j)) -> fraction (\det B).
Proof.
move=> hB; apply: (big_ind fraction) => [||s _]; [exact: fr0 | exact: frD | apply: frM].
  by apply: frX; apply: frN; exact: fr1.
by apply: (big_ind fraction) => [||i _]; [exact: fr1 | exact: frM | exact: hB].
Qed.
Lemma fr_inv m (B : 'M[K]_m) : (forall i j, fraction (B i j)) -> forall i j, fraction (invmx B i j).
Proof.
move=> hB i j; rewrite /invmx; case: ifP => _; last exact: hB.
rewrite !mxE; apply: frM; first by apply: frV; exact: fr_det.
rewrite /cofactor; apply: frM; first by apply: frX; apply: frN; exact: fr1.
by apply: fr_det => k l; rewrite !mxE.
Qed.
Lemma fr_solve k m (M : 'M[K]_(k, m)) (b : 'cV_k) (x : 'cV_m) : (forall i j, fraction (M i j)) ->
  (forall i, fraction (b i 0)) -> M *m x = b -> (forall v : 'cV_m, M *m v = 0 -> v = 0) ->
  forall i, fraction (x i 0).
Proof.
move=> hM hb e ker; have full : row_full M.
  rewrite /row_full -mxrank_tr -/(row_free M^T) -kermx_eq0;
    apply: contraT => /rowV0Pn[v /sub_kermxP vM v0].
  case/eqP: v0; apply: trmx_inj; rewrite trmx0; apply: ker; apply: trmx_inj.
  by rewrite trmx_mul trmxK vM trmx0.
set g := fullrankfun full; have u := fullrowsub_unit full.
have -> : x = invmx (rowsub g M) *m rowsub g b.
  by rewrite -e (rowsubE g (M *m x)) mulmxA -rowsubE mulKmx.
move=> i; rewrite mxE; apply: (big_ind fraction) => [||l _]; [exact: fr0 | exact: frD | apply: frM].
  by apply: fr_inv => a b'; rewrite mxE.
by rewrite mxE.
Qed.

(** The same for a vector in space, with equations numbered by a view and by k < m. *)
Definition fr3 (u : vec K) := [/\ fraction (x1 u), fraction (x2 u) & fraction (x3 u)].
Lemma fr_vec m (r : view -> nat -> vec K) (b : view -> nat -> K) X :
  (forall v k, (k < m)%N -> [/\ fr3 (r v k), fraction (b v k) & dot (r v k) X = b v k]) ->
  (forall u, (forall v k, (k < m)%N -> dot (r v k) u = 0) -> u = vec0 K) -> fr3 X.
Proof.
move=> h ker; pose co (u : vec K) := \col_(j < 3) nth 0 [:: x1 u; x2 u; x3 u] j.
pose at_ (t : 'I_(#|{: 'I_3 * 'I_m}|)) := let p := enum_val t in (nth V1 views p.1, val p.2).
have lt t : ((at_ t).2 < m)%N by exact: ltn_ord.
pose M := \matrix_(t < #|{: 'I_3 * 'I_m}|, j < 3) co (r (at_ t).1 (at_ t).2) j 0.
have Mdot t u : (M *m co u) t 0 = dot (r (at_ t).1 (at_ t).2) u.
  by rewrite mxE !big_ord_recl big_ord0 !mxE /= addr0 addrA.
suff s i : fraction (co X i 0).
  have e k (k3 : (k < 3)%N) := s (Ordinal k3).
  by split; [have := e 0%N isT | have := e 1%N isT | have := e 2%N isT]; rewrite mxE.
apply: (@fr_solve _ _ M (\col_t b (at_ t).1 (at_ t).2)) i => [t j|t||v vM].
- have [[f1 f2 f3] _ _] := h (at_ t).1 _ (lt t); rewrite !mxE.
  by case: j => -[|[|[|]]].
- by rewrite mxE; have [] := h (at_ t).1 _ (lt t).
- by apply/colP => t; rewrite Mdot mxE; have [] := h (at_ t).1 _ (lt t).
have e : v = co (@Vec K (v 0 0) (v 1 0) (v 2%:R 0)).
  apply/colP => j; rewrite mxE; case: j => -[|[|[|]]] //= j3; congr (v _ 0); exact: val_inj.
rewrite e in vM *; rewrite (ker (@Vec K (v 0 0) (v 1 0) (v 2%:R 0))) => [|w k km].
  by apply/colP => -[[|[|[|]]] //= j3]; rewrite !mxE.
have [i wi] : exists i : 'I_3, nth V1 views i = w by case: w; [exists 0 | exists 1 | exists 2%:R].
have := Mdot (enum_rank (i, Ordinal km)) (@Vec K (v 0 0) (v 1 0) (v 2%:R 0)).
by rewrite vM mxE /at_ enum_rankK /= wi.
Qed.
Lemma fr_dot u w : fr3 u -> fr3 w -> fraction (dot u w).
Proof. by case=> a1 a2 a3 [b1 b2 b3]; rewrite /dot; do 2?[apply: frD]; exact: frM. Qed.
Lemma fr_turn (C : camera K) u : [/\ fraction (qa (quat_of C)), fraction (qb (quat_of C)),
  fraction (qc (quat_of C)) & fraction (qd (quat_of C))] -> fr3 u -> fr3 (turn C u).
Proof.
case: C => -[a b c d] t [/= ha hb hc hd] hu; split; apply: fr_dot => //; split=> /=;
  repeat first [assumption | apply: frB | apply: frD | apply: frMn | apply: frX | apply: frM].
Qed.
End Fractions.

(** ** The field that a list z generates *)
Section Generated.
Variables (F : fieldType) (n : nat).
Notation K := [fieldType of {fraction {mpoly F[n]}}].
Notation c := (const (to F n)).
Variable z : seq K.
Definition ev_of : {rmorphism {mpoly F[size z]} -> K} :=
  mmap_rmorphism (fun j : 'I_(size z) => nth 0 z j) c.
Lemma fr_mem a : a \in z -> fraction ev_of a.
Proof.
move=> az; have lt : (index a z < size z)%N by rewrite index_mem.
have <- : ev_of 'X_(Ordinal lt) = a; last exact: fr_of.
by rewrite /= mmapX mmap1U nth_index.
Qed.
(** With all parameters it is K. *)
Lemma fr_all : (forall k, (k < n)%N -> fraction ev_of (generic F n k)) ->
  forall u, fraction ev_of u.
Proof.
move=> g; have p0 p : fraction ev_of (to F n p).
  rewrite (mpolyE p) rmorph_sum; apply: (big_ind (fraction ev_of)) => [||M _];
    [exact: fr0 | exact: frD |].
  rewrite -mul_mpolyC rmorphM /=; apply: frM.
    by have := fr_of ev_of (p@_M)%:MP; rewrite /= mmapC.
  rewrite mpolyXE_id -[FracField.tofrac _]/(to F n _) rmorph_prod.
  apply: (big_ind (fraction ev_of)) => [||i _]; [exact: fr1 | exact: frM |].
  by rewrite rmorphX; apply: frX; have := g i (ltn_ord i); rewrite /generic valK.
by move=> u; rewrite (fractionE u); apply: frM; [exact: p0 | apply: frV; exact: p0].
Qed.
End Generated.
