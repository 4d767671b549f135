(** * At most ten essential matrices: an elimination template

    Let P be a space of dimension 4 of matrices E = z0 P0 + z1 P1 + z2 P2 + z3 P3. An essential
    matrix satisfies ten cubic equations: det E = 0 and 2 E E^T E = tr(E E^T) E. Let C be the matrix
    of their coefficients at the ten monomials of degree 3 in z0, z1, z2. If it is invertible, every
    monomial in z0, z1, z2 (where z3 = 1) is a combination of the ten of degree at most 2. So the
    equations have at most ten solutions ([at_most_ten]): their vectors of monomials are common
    eigenvectors of the three matrices of multiplication, with different eigenvalues. *)
From mathcomp Require Import all_ssreflect all_algebra.
From mathcomp.algebra_tactics Require Import ring.
From PL1P Require Import RationalFunctions.
Set Implicit Arguments.
Unset Strict Implicit.
Unset Printing Implicit Defensive.
Import GRing.Theory.
Local Open Scope ring_scope.

(** ** Common eigenvectors with different eigenvalues are independent *)
Section Eigenvectors.
Variables (L : fieldType) (T : eqType) (I : Type) (d : nat).
Variables (u : T -> 'I_d -> L) (x : I -> T -> L) (A : I -> 'I_d -> 'I_d -> L).
Implicit Types (s : seq T) (c : T -> L).

Definition eigenvector p := (forall i m, x i p * u p m = \sum_k A i m k * u p k) /\ exists m, u p m != 0.
Definition different p q := exists i, x i p != x i q.

Lemma eigenvectors_free s : uniq s -> {in s, forall p, eigenvector p} ->
  {in s &, forall p q, p != q -> different p q} ->
  forall c, (forall m, \sum_(p <- s) c p * u p m = 0) -> {in s, forall p, c p = 0}.
Proof.
elim: s => // q s IH /andP[qs us] es ds c z.
have eq0 := es q (mem_head q s); have es' : {in s, forall p, eigenvector p} by move=> p ps; apply: es;
  rewrite inE ps orbT.
have rest p : p \in s -> c p = 0.
  move=> ps; have [i xi] : different p q.
    by apply: ds; rewrite ?mem_head ?inE ?ps ?orbT //; apply: contraNneq qs => <-.
  have zi m : \sum_(p <- s) (c p * (x i p - x i q)) * u p m = 0.
    transitivity (\sum_(p <- q :: s) (c p * (x i p - x i q)) * u p m);
      first by rewrite big_cons subrr mulr0 mul0r add0r.
    transitivity (\sum_k A i m k * (\sum_(p <- q :: s) c p * u p k) - x i q * \sum_(p <- q :: s) c p * u p m);
      last first.
      by rewrite z mulr0 subr0 big1 // => k _; rewrite z mulr0.
    under [X in _ = X - _]eq_bigr do rewrite mulr_sumr.
    rewrite exchange_big /= mulr_sumr -sumrB; apply: eq_big_seq => p' /es [/(_ i m) e _].
    by rewrite mulrBr mulrBl -mulrA e mulr_sumr; congr (_ - _); [apply: eq_bigr => k _ |]; ring.
  have ds' : {in s &, forall p q, p != q -> different p q} by move=> a b al bl; apply: ds;
    rewrite inE ?al ?bl orbT.
  by have /eqP := IH us es' ds' _ zi p ps; rewrite mulf_eq0 subr_eq0 (negbTE xi) orbF => /eqP.
move=> p; rewrite inE => /orP[/eqP -> | /rest //].
case: eq0 => _ [m um]; have := z m; rewrite big_cons big1_seq ?addr0 => [|p' /andP[_ /rest ->]];
  last by rewrite mul0r.
by move/eqP; rewrite mulf_eq0 (negbTE um) orbF => /eqP.
Qed.

Lemma eigenvectors_few s : uniq s -> {in s, forall p, eigenvector p} ->
  {in s &, forall p q, p != q -> different p q} ->
  (size s <= d)%N.
Proof.
move=> us es ds; rewrite leqNgt; apply/negP => lt.
have [|v [a va] vz] := @more_rows L [finType of 'I_(size s)] [finType of 'I_d]
  (fun a m => u (tnth (in_tuple s) a) m).
  by rewrite !card_ord.
pose c p := if insub (index p s) is Some a then v a else 0.
have cE b : c (tnth (in_tuple s) b) = v b.
  have bs := ltn_ord b; rewrite /c (tnth_nth (tnth (in_tuple s) b)) /= index_uniq //.
  by rewrite (insubT (fun k => k < size s)%N bs); congr v; apply/val_inj.
case/negP: va; rewrite -cE; apply/eqP; apply: (eigenvectors_free us es ds) => [m|]; last exact: mem_tnth.
by rewrite (big_tnth _ _ s); apply: etrans (vz m); apply: eq_bigr => b _; rewrite cE.
Qed.
End Eigenvectors.

(** ** The ten cubic equations, as trilinear forms; E_ab is entry 3 a + b *)
Section Cubics.
Variable R : comRingType.
Implicit Types (A B C E : nat -> R) (z : nat -> R) (P : nat -> nat -> R).

Definition form k A B C : R := if k == 9%N then
    A 0%N * (B 4%N * C 8%N - B 5%N * C 7%N) + A 1%N * (B 5%N * C 6%N - B 3%N * C 8%N) + A 2%N *
      (B 3%N * C 7%N - B 4%N * C 6%N)
  else let a := (k %/ 3)%N in let b := (k %% 3)%N in
    let row i := A (3 * a)%N * B (3 * i)%N + A (3 * a + 1)%N * B (3 * i + 1)%N + A (3 * a + 2)%N * B
      (3 * i + 2)%N in
    (row 0%N * C b + row 1%N * C (3 + b)%N + row 2%N * C (6 + b)%N) *+ 2 -
    (A 0%N * B 0%N + A 1%N * B 1%N + A 2%N * B 2%N + A 3%N * B 3%N + A 4%N * B 4%N + A 5%N * B 5%N + A 6%N * B
      6%N +
     A 7%N * B 7%N + A 8%N * B 8%N) * C k.

(** The coefficient of a monomial, and its value. *)
Definition at_z P z e := z 0%N * P 0%N e + z 1%N * P 1%N e + z 2%N * P 2%N e + z 3%N * P 3%N e.
Definition coef P k m := foldr (fun r a => form k (P (nth 0%N r 0)) (P (nth 0%N r 1)) (P (nth 0%N r 2)) + a) 0
  (permutations m).
Definition monomial z m : R := foldr (fun i a => z i * a) 1 m.
Definition cubic_monomials := [:: [:: 0; 0; 0]; [:: 0; 0; 1]; [:: 0; 0; 2]; [:: 0; 1; 1]; [:: 0; 1; 2];
  [:: 0; 2; 2]; [:: 1; 1; 1]; [:: 1; 1; 2]; [:: 1; 2; 2]; [:: 2; 2; 2]]%N.
Definition basis := [:: [:: 0; 0]; [:: 0; 1]; [:: 0; 2]; [:: 1; 1]; [:: 1; 2]; [:: 2; 2]; [:: 0; 3];
  [:: 1; 3];
  [:: 2; 3]; [:: 3; 3]]%N.
Definition leading P : 'M[R]_10 := \matrix_(k, j) coef P k (nth [::] cubic_monomials j).
Definition sum_of (s : seq (seq nat)) (f : seq nat -> R) := foldr (fun m a => f m + a) 0 s.

Lemma form1 k P z B C : form k (at_z P z) B C =
  z 0%N * form k (P 0%N) B C + z 1%N * form k (P 1%N) B C + z 2%N * form k (P 2%N) B C + z 3%N * form k
    (P 3%N) B C.
Proof. by rewrite /form; case: eqP => _ /=; rewrite /at_z; ring. Qed.
Lemma form2 k P z A C : form k A (at_z P z) C =
  z 0%N * form k A (P 0%N) C + z 1%N * form k A (P 1%N) C + z 2%N * form k A (P 2%N) C + z 3%N * form k A
    (P 3%N) C.
Proof. by rewrite /form; case: eqP => _ /=; rewrite /at_z; ring. Qed.
Lemma form3 k P z A B : form k A B (at_z P z) =
  z 0%N * form k A B (P 0%N) + z 1%N * form k A B (P 1%N) + z 2%N * form k A B (P 2%N) + z 3%N * form k A B
    (P 3%N).
Proof. by rewrite /form; case: eqP => _ /=; rewrite /at_z; ring. Qed.

Lemma form_monomials k P z : form k (at_z P z) (at_z P z) (at_z P z) =
  sum_of cubic_monomials (fun m => coef P k m * monomial z m) +
  sum_of basis (fun m => coef P k (rcons m 3%N) * monomial z (rcons m 3%N)).
Proof.
rewrite !(form1, form2, form3) /sum_of /coef /monomial.
move: (form k) => t; rewrite /=; ring.
Qed.
End Cubics.

(** ** If the coefficients of the cubic monomials form an invertible matrix, there are at most ten
    solutions *)
Section Template.
Variables (L : fieldType) (P : nat -> nat -> L).
Notation monom := (@monomial [comRingType of L]).
Notation lead := (@leading [comRingType of L] P).
Definition trailing : 'M[L]_10 := \matrix_(k, j) coef P k (rcons (nth [::] basis j) 3%N).
Hypothesis regular : \det (lead) != 0.
Definition solves (z : nat -> L) := forall k, (k < 10)%N -> form k (at_z P z) (at_z P z) (at_z P z) = 0.

Lemma sum_ofE (s : seq (seq nat)) n (f : seq nat -> L) : size s = n -> sum_of s f =
  \sum_(j < n) f (nth [::] s j).
Proof. by move=> <-; elim: s => [|m s IH]; rewrite ?big_ord0 // big_ord_recl /= IH. Qed.
Lemma monomialE z m : monom z m = \prod_(i <- m) z i.
Proof. by elim: m => [|i m IH]; rewrite ?big_nil // big_cons /= IH. Qed.
Lemma monomial_rcons z m i : monom z (rcons m i) = monom z m * z i.
Proof. by rewrite !monomialE -cats1 big_cat big_seq1. Qed.

Lemma solves_matrix z : solves z ->
  lead *m (\col_j monom z (nth [::] cubic_monomials j)) =
    - trailing *m \col_j monom z (rcons (nth [::] basis j) 3%N).
Proof.
move=> sz; apply/eqP; rewrite mulNmx -addr_eq0; apply/eqP/colP => k; rewrite !mxE; have := sz k (ltn_ord k).
rewrite form_monomials !(sum_ofE (n := 10)) // => e; apply: etrans e; congr (_ + _); by apply: eq_bigr => j _;
  rewrite !mxE.
Qed.

(** No solution has z3 = 0. *)
Lemma chart z : solves z -> z 3%N = 0 -> forall e, at_z P z e = 0.
Proof.
move=> /solves_matrix e z3 i; rewrite (_ : \col_j monom z (rcons _ _) = 0) ?mulmx0 in e; last first.
  by apply/colP => j; rewrite !mxE monomial_rcons z3 mulr0.
have v0 : \col_j monom z (nth [::] cubic_monomials j) = 0 :> 'cV[L]_10.
  by rewrite -[LHS](mulKmx (_ : lead \in unitmx)) ?e ?mulmx0 // unitmxE unitfE.
have cube (j : 'I_10) k : nth [::] cubic_monomials j = [:: k; k; k] -> z k = 0.
  move=> ej; have := congr1 (fun v : 'cV_10 => v j 0) v0; rewrite !mxE ej /= mulr1 => /eqP.
  by rewrite !mulf_eq0 !orbb => /eqP.
have z0 : z 0%N = 0 by apply: (cube ord0).
have z1 : z 1%N = 0 by apply: (cube (inord 6)); rewrite inordK.
have z2 : z 2%N = 0 by apply: (cube ord_max).
by rewrite /at_z z0 z1 z2 z3 !mul0r !addr0.
Qed.

Definition reduced_row j k : L := - (invmx (lead) *m trailing) (inord j) k.
Definition multiplication (i : 'I_3) (m k : 'I_10) : L := let s := sort leq (val i :: nth [::] basis m) in
  if s \in cubic_monomials then reduced_row (index s cubic_monomials) k
    else (val k == index (take 2 s) basis)%:R.

Definition monomials (z : nat -> L) (m : 'I_10) := monom z (nth [::] basis m).
Lemma multiplied z (i : 'I_3) m : solves z -> z 3%N = 1 ->
  z i * monomials z m = \sum_k multiplication i m k * monomials z k.
Proof.
move=> /solves_matrix e z3; have drop s : monom z (rcons s 3%N) = monom z s.
  by rewrite monomial_rcons z3 mulr1.
set s := sort leq (val i :: nth [::] basis m).
have -> : z i * monomials z m = monom z s.
  rewrite -[LHS]/(monom z (val i :: nth [::] basis m)) !monomialE; apply: perm_big;
    by rewrite perm_sym perm_sort.
rewrite /multiplication -/s; have [sc|sn] := boolP (s \in cubic_monomials).
  have lt : (index s cubic_monomials < 10)%N by move: sc; rewrite -index_mem.
  have : \col_j monom z (nth [::] cubic_monomials j) =
    - (invmx (lead) *m trailing) *m \col_j monomials z j :> 'cV[L]_10.
    rewrite -[LHS](mulKmx (_ : lead \in unitmx)); last by rewrite unitmxE unitfE.
    rewrite e !mulNmx mulmxN mulmxA; congr (- (_ *m _)); apply/colP => j; rewrite !mxE; exact: drop.
  move/(congr1 (fun v : 'cV_10 => v (inord (index s cubic_monomials)) 0));
    rewrite mxE inordK // nth_index // => ->.
  by rewrite mxE; apply: eq_bigr => k _; rewrite /reduced_row !mxE.
have h : all (fun i => all (fun m => let s := sort leq (i :: nth [::] basis m) in (s \in cubic_monomials) ||
    (index (take 2 s) basis < 10)%N && (s == rcons (take 2 s) 3%N)) (iota 0 10)) (iota 0 3) by vm_compute.
have /allP/(_ (val i)) := h; rewrite mem_iota ltn_ord => /(_ isT)/allP/(_ (val m));
  rewrite mem_iota ltn_ord => /(_ isT).
cbv zeta; rewrite -/s (negbTE sn) => /andP[lt /eqP es].
rewrite {1}es drop (bigD1 (Ordinal lt)) //= eqxx mul1r big1 => [|k /negbTE kn]; last first.
  by rewrite -(inj_eq val_inj) /= in kn; rewrite kn mul0r.
by rewrite addr0 /monomials /= nth_index // -index_mem.
Qed.

Theorem at_most_ten (T : eqType) (z : T -> nat -> L) s : uniq s -> {in s, forall p, solves (z p)} ->
  {in s, forall p, z p 3%N = 1} -> {in s &, forall p q, p != q -> exists i : 'I_3, z p i != z q i} ->
    (size s <= 10)%N.
Proof.
move=> us sol z3 ds; apply: (@eigenvectors_few L T [eqType of 'I_3] 10 (fun p => monomials (z p))
  (fun i p => z p i) multiplication s us) => //.
move=> p ps; split=> [i m|]; first exact: (multiplied i m (sol p ps) (z3 p ps)).
by exists ord_max; rewrite /monomials monomialE /= !big_cons big_nil (z3 p ps) !mulr1 oner_neq0.
Qed.
End Template.
