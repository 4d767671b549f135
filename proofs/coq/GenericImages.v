(** * Five generic pairs of image points

    The two determinants that the bound needs are polynomials in the coordinates of the images. They
    are not zero at one integer point, so they are not zero at independent coordinates. *)
From Coq Require Import ZArith.
From mathcomp Require Import all_ssreflect all_algebra.
From mathcomp.algebra_tactics Require Import ring.
From mathcomp.zify Require Import ssrZ.
From SsrMultinomials Require Import mpoly.
From PL1P Require Import Statement Derivations Template FivePoints.
Set Implicit Arguments.
Unset Strict Implicit.
Unset Printing Implicit Defensive.
Import GRing.Theory.
Local Open Scope ring_scope.
Local Delimit Scope Z_scope with Z.
Local Notation ZR := [idomainType of Z].
Local Notation ZC := [comRingType of Z].

(** ** An integer point *)
Definition point : seq Z := [:: -1; 0; 0; 0;  0; 1; 1; 1;  0; 0; 0; 2;  -1; -1; 0; 1;  0; 0; 1; 1]%Z.
Definition yZ (k : nat) : ZC := nth 0%Z point k.
Definition table (rows : seq (seq Z)) (i j : nat) : ZC := nth 0%Z (nth [::] rows i) j.
Definition bound_inverse := table [:: [:: -1; 1; -1; 1; 0]; [:: -1; 1; 0; 1; -1]; [:: 1; -2; 1; -2; 2];
  [:: 0; 1; 0; 0; -1]; [:: 2; -2; 1; -2; 2]]%Z.
Definition space_table := table [:: [:: 1; 0; 0; 0; 0; 0; 0; 0; 0]; [:: 0; 1; -1; 0; 0; -1; 2; -1; 2];
  [:: 0; 0; 1; 1; 0; 1; -2; 0; -2]; [:: 0; 0; 0; 0; 1; 0; 0; -1; 0]]%Z.
(** 48 times the inverse of the leading coefficients. *)
Definition leading_inverse := table [:: [:: 48; 0; 5; 85; 32; -124; 56; -85; -51; -262];
  [:: 0; 24; 0; -168; -84; 280; -84; 192; 140; 280]; [:: 0; 24; -1; -197; -112; 328; -112; 221; 175; 358];
  [:: 0; 0; 0; 240; 144; -384; 120; -240; -192; -480]; [:: 0; 0; 0; 312; 180; -488; 156; -312; -244; -584];
  [:: 0; 0; 5; 397; 224; -612; 200; -397; -307; -726]; [:: 0; 24; 0; -432; -216; 624; -216; 408; 312; 720];
  [:: 0; 24; 0; -528; -264; 768; -264; 504; 384; 912]; [:: 0; 24; 0; -648; -324; 952; -324; 624; 476; 1144];
  [:: 0; 24; -1; -797; -400; 1184; -400; 773; 591; 1430]]%Z.

Definition product n (f g : nat -> nat -> ZC) i j := foldr (fun k a => f i k * g k j + a) 0 (iota 0 n).
Lemma productE n (f g : nat -> nat -> ZC) i j : \sum_(k < n) f i k * g k j = product n f g i j.
Proof.
rewrite /product -(big_mkord xpredT (fun k => f i k * g k j)) /index_iota subn0.
by elim: (iota 0 n) => [|k l IH]; rewrite ?big_nil // big_cons IH.
Qed.
Definition agree m n (f g : nat -> nat -> ZC) := all (fun i => all (fun j => f i j == g i j) (iota 0 n))
  (iota 0 m).
Lemma agreeP m n f g i j : agree m n f g -> (i < m)%N -> (j < n)%N -> f i j = g i j.
Proof.
move=> h im jn; have /allP/(_ i) := h; rewrite mem_iota => /(_ im)/allP/(_ j);
  rewrite mem_iota => /(_ jn)/eqP.
exact.
Qed.
Definition scalar (z : Z) (i j : nat) : ZC := if i == j then z else 0%Z.

Definition bound_entry i j := @coefficient ZC yZ i (nth 0%N bound_entries j).
Definition free_entry i j := @coefficient ZC yZ i (nth 0%N free_entries j).
Lemma bound_checked : agree 5 5 (product 5 bound_inverse bound_entry) (scalar 1%Z).
Proof. by vm_compute. Qed.
Definition space_entry (i e : nat) : ZC := if e \in free_entries then scalar 1%Z (index e free_entries) i
  else - product 5 bound_inverse free_entry (index e bound_entries) i.
Lemma space_checked : agree 4 9 space_entry space_table.
Proof. by vm_compute. Qed.
Definition leading_entry k j := @coef ZC space_table k (nth [::] cubic_monomials j).
Lemma leading_checked : agree 10 10 (product 10 leading_inverse leading_entry) (scalar 48%Z).
Proof. by vm_compute. Qed.

Notation B := (@bound_block ZC yZ).
Definition B' : 'M[ZC]_5 := \matrix_(i, j) bound_inverse i j.
Lemma B'B : B' *m B = 1%:M.
Proof.
apply/matrixP => i j; rewrite !mxE; transitivity (product 5 bound_inverse bound_entry i j).
  by rewrite -productE; apply: eq_bigr => k _; rewrite !mxE.
by rewrite (agreeP bound_checked) // /scalar -(inj_eq val_inj); case: eqP.
Qed.
Lemma detB : \det B != 0.
Proof.
have := congr1 (fun M : 'M[ZC]_5 => \det M) B'B; rewrite det_mulmx det1; apply: contra_eqN => /eqP ->.
by rewrite mulr0 eq_sym oner_eq0.
Qed.
Lemma adjB : \adj B = \det B *: B'.
Proof. by rewrite -[LHS]mul1mx -B'B -mulmxA mul_mx_adj mul_mx_scalar. Qed.

Lemma spaceE i e : (i < 4)%N -> (e < 9)%N -> @space ZC yZ i e = \det B * space_table i e.
Proof.
move=> i4 e9; rewrite -(agreeP space_checked) // /space /space_entry /scalar; case: ifP => ef.
  by case: ifP => _; rewrite ?mulr1 ?mulr0.
have lt : (index e bound_entries < 5)%N by case: e e9 ef => [|[|[|[|[|[|[|[|[|e]]]]]]]]].
rewrite /solved adjB -scalemxAl !mxE mulrN; congr (- (_ * _)); rewrite -productE.
by apply: eq_bigr => k _; rewrite !mxE !inordK.
Qed.

(** Computes the arguments of f. *)
Ltac numbers f := repeat match goal with |- context [f ?n] =>
  let m := eval vm_compute in n in progress change (f n) with (f m) end.
Lemma form_scale (R : comRingType) (d : R) k (A A' C C' D D' : nat -> R) : (k < 10)%N ->
  (forall e, (e < 9)%N -> A e = d * A' e) ->
  (forall e, (e < 9)%N -> C e = d * C' e) -> (forall e, (e < 9)%N -> D e = d * D' e) ->
  form k A C D = d ^+ 3 * form k A' C' D'.
Proof.
by move=> k10 hA hC hD; rewrite /form; case: k k10 => [|[|[|[|[|[|[|[|[|[|k]]]]]]]]]] // _;
  rewrite /= !hA // !hC // !hD //;
  numbers A'; numbers C'; numbers D'; ring.
Qed.
Lemma leadingE : leading (@space ZC yZ) = \det B ^+ 3 *: \matrix_(k, j) leading_entry k j.
Proof.
apply/matrixP => k j; rewrite !mxE /leading_entry /coef.
have small : all (all (fun i => i < 4)%N) cubic_monomials by [].
have : all (fun i => i < 4)%N (nth [::] cubic_monomials j) by apply: (allP small); rewrite mem_nth.
set m := nth _ _ _ => m4; have : {subset permutations m <= permutations m} by [].
elim: {1 3 4}(permutations m) => [|r l IH] sub /=; first by rewrite mulr0.
rewrite IH => [|r' rl]; last by apply: sub; rewrite inE rl orbT.
have r4 i : (nth 0%N r i < 4)%N.
  have : perm_eq r m by rewrite -mem_permutations sub ?mem_head.
  move=> rm; case: (ltnP i (size r)) => ir; last by rewrite nth_default.
  by apply: (allP m4); rewrite -(perm_mem rm) mem_nth.
by rewrite mulrDr; congr (_ + _); apply: form_scale => // e e9; exact: spaceE.
Qed.
Lemma det_leading : \det (leading (@space ZC yZ)) != 0.
Proof.
rewrite leadingE detZ mulf_neq0 //; first by rewrite !expf_neq0 // detB.
have e : (\matrix_(i < 10, j < 10) leading_inverse i j) *m (\matrix_(k < 10, j < 10) leading_entry k j) =
  (48%Z : ZC)%:M.
  apply/matrixP => i j; rewrite !mxE; transitivity (product 10 leading_inverse leading_entry i j).
    by rewrite -productE; apply: eq_bigr => k _; rewrite !mxE.
  by rewrite (agreeP leading_checked) // /scalar -(inj_eq val_inj); case: eqP => _; rewrite ?mulr1n ?mulr0n.
have := congr1 (fun M : 'M[ZC]_10 => \det M) e; rewrite det_mulmx det_scalar; apply: contra_eqN => /eqP ->.
by rewrite mulr0 eq_sym expf_neq0.
Qed.

(** ** Independent coordinates *)
Section Generic.
Variables (F L : fieldType) (c : {rmorphism F -> L}) (y : nat -> L).
Hypothesis char0 : [char F] =i pred0.
Hypothesis ind : independent c (fun j : 'I_20 => y j).
Notation MP := [comRingType of {mpoly F[20]}].
Notation LC := [comRingType of L].
Notation FC := [comRingType of F].

Definition unknown (k : nat) : MP := if insub k is Some i then 'X_(i : 'I_20) else 0.
Definition at_images : {rmorphism MP -> LC} := [rmorphism of mmap_rmorphism (fun j : 'I_20 => y j) c].
Definition integers : {rmorphism ZC -> FC} := Derivations.integers F.
Definition at_integers : {rmorphism MP -> FC} := [rmorphism of meval (fun j : 'I_20 => integers (yZ j))].
Definition trimmed k := if (k < 20)%N then y k else 0.

Lemma at_imagesE k : trimmed k = at_images (unknown k).
Proof.
rewrite /trimmed /unknown; case: insubP => [i -> <-|/negbTE ->]; last by rewrite rmorph0.
by rewrite /at_images /= mmapX mmap1U.
Qed.
Lemma at_integersE k : integers (yZ k) = at_integers (unknown k).
Proof.
rewrite /unknown; case: insubP => [i _ <-|]; first by rewrite /at_integers /= mevalXU.
by rewrite -leqNgt => k20; rewrite rmorph0 /yZ nth_default // rmorph0.
Qed.

(** A polynomial that is not zero at the integers is not zero at the images. *)
Lemma transfer (p : MP) (z : ZC) : at_integers p = integers z -> z != 0 -> at_images p != 0.
Proof.
move=> e z0; apply: contra_neq z0 => p0; apply/eqP; rewrite -(integers0 char0) -e.
by rewrite (_ : p = 0) ?rmorph0 //; exact: (ind p0).
Qed.
Lemma generic_block : \det (@bound_block LC trimmed) != 0.
Proof.
rewrite (bound_block_map at_imagesE) det_map_mx; apply: (transfer (z := \det B)); last exact: detB.
by rewrite -!det_map_mx -(bound_block_map at_integersE) -(bound_block_map (g := integers) (fun k => erefl)).
Qed.
Lemma generic_leading : \det (@leading LC (@space LC trimmed)) != 0.
Proof.
rewrite (leading_map (space_map at_imagesE)) det_map_mx;
  apply: (transfer (z := \det (leading (@space ZC yZ)))); last exact: det_leading.
by rewrite -!det_map_mx -(leading_map (space_map at_integersE))
  -(leading_map (space_map (g := integers) (fun k => erefl))).
Qed.
Lemma trimmed_solution p : solution y p -> solution trimmed p.
Proof.
case=> h1 h2 h3; split=> // i i5; have [X hX] := h3 i i5; exists X.
have small k : (k < 4)%N -> trimmed (4 * i + k)%N = y (4 * i + k)%N.
  move=> k4; rewrite /trimmed (leq_trans (_ : _ < 4 * i + 4)%N) ?ltn_add2l //.
  by rewrite -[(_ + 4)%N]/(4 * i + 4 * 1)%N -mulnDr addn1 (leq_mul2l 4 _ 5).
have small0 : trimmed (4 * i)%N = y (4 * i)%N by have := small 0%N isT; rewrite addn0.
by rewrite small0 !small.
Qed.
End Generic.

Theorem five_points_theorem : five_points.
Proof.
move=> F L c char0 y ind n C sol.
apply: (at_most_twenty (two_neq0 c char0) (generic_block char0 ind) (generic_leading char0 ind)) => i /sol.
exact: trimmed_solution.
Qed.
