(** * The classification of problems: the claims of Problems.v, proved *)
From Coq Require Import NArith Permutation.
From mathcomp Require Import all_ssreflect all_algebra.
From PL1P Require Import Statement Rigid Reducible Problems Forget Reduction Embedding Scenes SameProblem.
From PL1P Require Import Minimal Main.
Set Implicit Arguments.
Unset Strict Implicit.
Unset Printing Implicit Defensive.

(** ** The signature of a problem of the 27 features *)
Definition signature_of (A : problem) : signature :=
  mkseq (fun i => count (fun f => index_of f == i) A) 27.

Lemma filter_permutation (p : pred feature) A : Permutation A (filter p A ++ filter (predC p) A).
Proof.
elim: A => [|f A IH] /=; first exact: perm_nil.
case: (p f) => /=; first exact: perm_skip.
by apply: Permutation_trans (perm_skip f IH) _; exact: Permutation_middle.
Qed.
Lemma sorted_permutation (idx : feature -> nat) n A : all (fun f => idx f < n) A ->
  Permutation A (flatten [seq [seq f <- A | idx f == i] | i <- iota 0 n]).
Proof.
elim: n A => [|n IH] A; first by case: A => // _; exact: perm_nil.
move=> lt; rewrite -addn1 iotaD map_cat flatten_cat /= cats0 add0n.
apply: Permutation_trans (filter_permutation (fun f => idx f < n) A) _.
have -> : filter (predC (fun f => idx f < n)) A = [seq f <- A | idx f == n].
  elim: A lt => //= f A IHA /andP[le /IHA ->]; rewrite ltnS in le.
  by rewrite ltn_neqAle le andbT negbK.
apply: Permutation_app; last exact: Permutation_refl.
have h : all (fun f => idx f < n) [seq f <- A | idx f < n] by exact: filter_all.
apply: Permutation_trans (IH _ h) _.
rewrite (_ : map _ _ = [seq [seq f <- A | idx f == i] | i <- iota 0 n]); first exact: Permutation_refl.
apply/eq_in_map => i; rewrite mem_iota add0n /= => lt'; rewrite -filter_predI; apply: eq_filter => f /=.
by case: eqP => // ->.
Qed.
Lemma all2_cat (a1 b1 a2 b2 : problem) : all2 same a1 b1 -> all2 same a2 b2 ->
  all2 same (a1 ++ a2) (b1 ++ b2).
Proof. by elim: a1 b1 => [|x a1 IH1] [|y b1] //= /andP[-> /IH1 h1] /h1. Qed.
Lemma same_block A i : i < 27 ->
  all2 same [seq f <- A | index_of f == i] (nseq (count (fun f => index_of f == i) A) (ft i)).
Proof.
by move=> lt; elim: A => //= f A IH; case: eqP => //= e; rewrite IH andbT -e index_same ?e.
Qed.
Lemma known_same A : known A -> same_problem A (problem_of (signature_of A)).
Proof.
move=> kA; exists (flatten [seq [seq f <- A | index_of f == i] | i <- iota 0 27]);
  first exact: sorted_permutation.
rewrite /problem_of; have : all (fun i => i < 27) (iota 0 27) by apply/allP => i; rewrite mem_iota.
elim: (iota 0 27) => // i l IH /andP[lt /IH h]; apply: all2_cat h; rewrite nth_mkseq //; exact: same_block.
Qed.

Lemma same_count (p : pred feature) A B : (forall f g, proper f -> proper g -> same f g -> p f = p g) ->
  is_problem A -> is_problem B -> same_problem A B -> count p A = count p B.
Proof.
move=> ph pA pB [A' AA']; have -> : count p A = count p A'.
  by elim: AA' {pA} => //= [f l l' _ ->|f g l|l l' l'' _ -> _ ->] //; rewrite addnCA.
move: pA; rewrite /is_problem (all_permutation _ AA').
elim: A' B pB {A AA'} => [|f A IH] [|g B] // /andP[pg pB] /andP[pf pA] /andP[fg AB].
by rewrite [LHS]/= [RHS]/= (ph f g) // (IH B).
Qed.
Lemma same_signature A B : is_problem A -> is_problem B -> same_problem A B -> signature_of A =
  signature_of B.
Proof.
move=> pA pB AB; apply/eq_in_map => i _; apply: (same_count _ pA pB AB) => f g pf pg fg.
by rewrite (same_index pf pg fg).
Qed.

(** ** The problem of a signature *)
Lemma all_problem_of (p : pred feature) s : all (fun i => p (ft i)) (iota 0 27) -> all p (problem_of s).
Proof.
rewrite /problem_of; elim: (iota 0 27) => //= i l IH /andP[pi /IH h]; rewrite all_cat h andbT.
by rewrite all_nseq pi orbT.
Qed.
Lemma problem_of_proper s : is_problem (problem_of s).
Proof. by apply: all_problem_of; vm_compute. Qed.
Lemma index_ft : all (fun i => index_of (ft i) == i) (iota 0 27). Proof. by vm_compute. Qed.
Lemma index_ftE i : i < 27 -> index_of (ft i) = i.
Proof. by move=> lt; apply/eqP; apply: (allP index_ft); rewrite mem_iota. Qed.
Lemma problem_of_known s : known (problem_of s).
Proof.
apply: all_problem_of; apply/allP => i; rewrite mem_iota add0n => /= lt; by rewrite index_ftE.
Qed.
Lemma sum_problem_of (h : feature -> nat) s : sumn [seq h f | f <- problem_of s] =
  total s (fun i => h (ft i)).
Proof.
rewrite /problem_of /total; elim: (iota 0 27) => //= i l IH; rewrite map_cat sumn_cat IH map_nseq.
by rewrite sumn_nseq mulnC.
Qed.
Lemma signature_problem_of s : size s = 27 -> signature_of (problem_of s) = s.
Proof.
move=> sz; apply: (@eq_from_nth _ 0); first by rewrite size_mkseq.
rewrite size_mkseq => i lt; rewrite nth_mkseq //.
have -> : count (fun f => index_of f == i) (problem_of s) = sumn [seq nth 0 s k * (k == i) | k <- iota 0 27].
  rewrite -sumn_count sum_problem_of /total; apply: (congr1 sumn); apply/eq_in_map => k.
  by rewrite mem_iota => /andP[_ k27]; rewrite index_ftE.
have : uniq (iota 0 27) by exact: iota_uniq.
have : i \in iota 0 27 by rewrite mem_iota.
elim: (iota 0 27) => // k l IH; rewrite inE /= => /orP[/eqP <-|il] /andP[kl u].
  rewrite eqxx muln1 -[RHS]addn0; congr (_ + _); elim: l kl {IH u} => //= j l IH.
  by rewrite inE negb_or eq_sym => /andP[/negbTE -> /IH ->]; rewrite muln0.
rewrite IH //; case: eqP => [e|_]; last by rewrite muln0.
by rewrite e il in kl.
Qed.
Lemma balancedP s : size s = 27 -> balanced s =
  (sumn [seq dim2 f | f <- problem_of s] == parameters (problem_of s)).
Proof.
move=> sz; rewrite /balanced sz eqxx /parameters !sum_problem_of /=.
have -> : total s (fun i => dim2 (ft i)) = total s weight + total s (fun i => dim3 (ft i)).
  have le : all (fun i => dim3 (ft i) <= dim2 (ft i)) (iota 0 27) by vm_compute.
  rewrite /total; elim: (iota 0 27) le => //= i l IH /andP[le /IH ->].
  by rewrite addnACA -mulnDr /weight subnK.
by rewrite eqn_add2r.
Qed.

(** ** Relabeling *)
Definition perm i := nth id view_perms i.
Definition inverse i := nth 0 [:: 0; 1; 2; 4; 3; 5] i.
Lemma star_relabel g m : index_of (relabel_feature g (star m)) = index_of (star m).
Proof.
apply: eq_find => h; have e v : looks (relabel_feature g (star m)) v = looks (star m) v.
  by rewrite /relabel_feature /star /feat; case: v; cbn [looks by_view]; case: (g _).
rewrite /same; congr [&& _, _ & _]; apply: eq_has => r; apply: eq_all => v; by rewrite e.
Qed.
Lemma known_star k : k < 5 -> ft k = star (7 - k).
Proof. by case: k => [|[|[|[|[|]]]]]. Qed.
Lemma tables : all (fun i => all (fun k => let t := index_of (relabel_feature (perm i) (ft k)) in
  (t < 27) && (index_of (relabel_feature (perm (inverse i)) (ft t)) == k)) (iota 5 22)) (iota 0 6).
Proof. by vm_compute. Qed.
Lemma tableP i k : i < 6 -> k < 27 -> let t := index_of (relabel_feature (perm i) (ft k)) in
  t < 27 /\ index_of (relabel_feature (perm (inverse i)) (ft t)) = k.
Proof.
move=> i6 k27; case: (ltnP k 5) => k5; first by
  cbv zeta; rewrite [ft k]known_star // star_relabel -known_star // index_ftE // known_star // star_relabel
    -known_star // index_ftE.
have /allP/(_ i) := tables; rewrite mem_iota => /(_ i6)/allP/(_ k).
by rewrite mem_iota k5 => /(_ k27)/andP[h1 /eqP].
Qed.
Lemma inverseK i : i < 6 -> inverse i < 6 /\ inverse (inverse i) = i.
Proof. by case: i => [|[|[|[|[|[|]]]]]]. Qed.
Lemma table_swap i k j : i < 6 -> k < 27 -> j < 27 ->
  (index_of (relabel_feature (perm i) (ft k)) == j) =
    (k == index_of (relabel_feature (perm (inverse i)) (ft j))).
Proof.
move=> i6 k27 j27; have [j6 e] := inverseK i6; have [_ h1] := tableP i6 k27; have [_ h2] := tableP j6 j27.
by rewrite e in h2; apply/eqP/eqP => [<-|->].
Qed.

(** A permutation of the views is one of the six. *)
Lemma permP (g : view -> view) : injective g -> exists2 i, i < 6 & g =1 perm i.
Proof.
move=> inj; have d a b : a <> b -> g a <> g b by move=> ab /inj.
have := d V1 V2; have := d V1 V3; have := d V2 V3.
case e1: (g V1); case e2: (g V2); case e3: (g V3) => h1 h2 h3;
  try (by case: (h1)); try (by case: (h2)); try (by case: (h3)).
- by exists 0 => // -[].
- by exists 1 => // -[].
- by exists 2 => // -[].
- by exists 3 => // -[].
- by exists 4 => // -[].
- by exists 5 => // -[].
Qed.
Lemma perm_inj i : i < 6 -> injective (perm i).
Proof. by case: i => [|[|[|[|[|[|]]]]]] // _ [] []. Qed.
Lemma relabel_same g f h : same f h -> same (relabel_feature g f) (relabel_feature g h).
Proof. by case/sameP=> e1 e2 [r p q]; apply/sameP; split=> //; exists r => // v; exact: q. Qed.
Lemma relabel_ext (g g' : view -> view) f : g =1 g' -> index_of (relabel_feature g f) =
  index_of (relabel_feature g' f).
Proof.
move=> e; apply: eq_find => h; rewrite /same /=; congr [&& _, _ & _]; apply: eq_has => r.
by rewrite !e.
Qed.
Lemma relabel_proper g f : proper f -> proper (relabel_feature g f).
Proof.
case/andP=> h0 /and4P[h1 h2 h3 _]; apply/andP; split=> //; apply/and4P; split=> //=.
- by case: (g V1).
- by case: (g V2).
- by case: (g V3).
Qed.
Lemma relabel_problem_proper g A : is_problem A -> is_problem (relabel_problem g A).
Proof. by move=> pA; rewrite /is_problem all_map; apply: sub_all pA => f; exact: relabel_proper. Qed.
Lemma relabel_index i f : i < 6 -> proper f -> index_of f < 27 ->
  index_of (relabel_feature (perm i) f) = index_of (relabel_feature (perm i) (ft (index_of f))).
Proof.
move=> i6 pf kf; apply: same_index; [exact: relabel_proper | | exact: relabel_same (index_same kf)].
by apply: relabel_proper; have /allP/(_ (index_of f)) : all (fun i => proper (ft i)) (iota 0 27) by [];
  rewrite mem_iota; apply.
Qed.
Lemma signature_ext (g h : feature -> feature) A : (forall f, index_of (g f) = index_of (h f)) ->
  signature_of [seq g f | f <- A] = signature_of [seq h f | f <- A].
Proof.
move=> e; rewrite /signature_of /mkseq; apply: eq_map => i; elim: A => // f A IH.
rewrite -[count _ [seq g f | f <- f :: A]]/((index_of (g f) == i) + count _ [seq g f | f <- A]) e IH.
by [].
Qed.
Lemma signature_relabel i A : i < 6 -> is_problem A -> known A ->
  known (relabel_problem (perm i) A) /\ signature_of (relabel_problem (perm i) A) =
    relabel (perm (inverse i)) (signature_of A).
Proof.
move=> i6 pA kA; pose r f := proper f && (index_of f < 27).
have rA : all r A by rewrite /r all_predI; apply/andP.
split.
  rewrite /known all_map; apply: sub_all rA => f /andP[pf kf] /=.
  by rewrite relabel_index //; case: (tableP i6 kf).
apply/eq_in_map => j; rewrite mem_iota => /andP[_ j27]; rewrite count_map.
have [lt _] := tableP (proj1 (inverseK i6)) j27; rewrite nth_mkseq //.
elim: A {pA kA} rA => // f A IH /andP[/andP[pf kf] /IH e]; rewrite [LHS]/= [RHS]/= e.
by rewrite relabel_index // table_swap.
Qed.

Lemma label_equiv_perm s t : label_equiv s t <-> exists2 i, i < 6 & t = relabel (perm i) s.
Proof.
split=> [/(nthP [::])[i i6 <-]|[i i6 ->]]; first by exists i => //; rewrite (nth_map id).
by rewrite -(nth_map id [::] (fun g => relabel g s)) //; exact: mem_nth.
Qed.

(** ** The theorems *)
Section Over.
Variable F : fieldType.
Hypothesis char0 : [char F]%R =i pred0.

Lemma minimal_signature A : is_problem A -> minimal F A -> known A ->
  balanced (signature_of A) /\ minimal F (problem_of (signature_of A)).
Proof.
move=> pA mA kA; have mS := (same_minimal char0 pA (problem_of_proper _) (known_same kA)).1 mA.
by split=> //; rewrite balancedP ?size_mkseq //; apply/eqP; case/(balanced_dominant char0): mS.
Qed.
Theorem minimal_reduced_iff A : is_problem A -> minimal F A /\ reduced F A <->
  exists s, [/\ balanced s, ~~ obstructed s & same_problem A (problem_of s)].
Proof.
move=> pA; have [red1 red2] := reduction_theorem char0 pA; split=> [[mA rA]|[s [bs us As]]].
  have kA := red2 mA rA; have [bs mS] := minimal_signature pA mA kA; exists (signature_of A).
  by split=> //; [exact/(minimal_iff char0 bs) | exact: known_same].
have mA := (same_minimal char0 pA (problem_of_proper s) As).2 ((minimal_iff char0 bs).2 us).
by split=> //; apply: red1; rewrite (same_known pA (problem_of_proper s) As) problem_of_known.
Qed.

Lemma size_balanced s : balanced s -> size s = 27. Proof. by case/andP=> /eqP. Qed.
Theorem label_classes_of_problems : problem_classes label_same (minimal_and_reduced F) 140616.
Proof.
have [[[reps [sz u good_reps inj all_good]] _ _ _] _] := classified char0.
exists [seq problem_of s | s <- reps]; have r i : i < size reps ->
    nth [::] [seq problem_of s | s <- reps] i = problem_of (nth [::] reps i).
  by move=> lt; rewrite (nth_map [::]).
rewrite size_map; split=> // [i lt|i j li lj|A [pA mA rA]].
- have [_ ms] := good_reps _ (mem_nth [::] lt); rewrite r //; split=> //; first exact: problem_of_proper.
  exact: (reduction_theorem char0 (problem_of_proper _)).1 (problem_of_known _).
- rewrite !r // => -[g ig same_ij]; have [k k6 e] := permP ig.
  have [bi _] := good_reps _ (mem_nth [::] li); have [bj _] := good_reps _ (mem_nth [::] lj).
  apply/eqP; rewrite -(nth_uniq [::] li lj u); apply/eqP; apply: inj; rewrite ?mem_nth //.
  have := same_signature (relabel_problem_proper g (problem_of_proper _)) (problem_of_proper _) same_ij.
  rewrite (signature_problem_of (size_balanced bj)) => <-.
  have -> : signature_of (relabel_problem g (problem_of (nth [::] reps i))) =
      signature_of (relabel_problem (perm k) (problem_of (nth [::] reps i))).
    by apply: signature_ext => f; exact: relabel_ext.
  have [_ ->] := signature_relabel k6 (problem_of_proper (nth [::] reps i)) (problem_of_known _).
  rewrite (signature_problem_of (size_balanced bi)); apply/label_equiv_perm.
  by exists (inverse k); [case: (inverseK k6) |].
- have [_ red2] := reduction_theorem char0 pA; have kA := red2 mA rA.
  have [bs mS] := minimal_signature pA mA kA.
  have [_ /(nthP [::])[k0 lt <-] /label_equiv_perm[i i6 e]] := all_good _ (Logic.conj bs mS).
  exists k0 => //; rewrite r // e; have [k6 ei] := inverseK i6; exists (perm (inverse i));
    first exact: perm_inj.
  have [kn sg] := signature_relabel k6 pA kA; rewrite -[in perm i]ei -sg.
  exact: known_same.
Qed.
End Over.

Theorem problems_theorem : problems.
Proof.
move=> F char0; split; [by move=> A _; exact: balanced_dominant | split].
  exact: minimal_reduced_iff.
exact: label_classes_of_problems.
Qed.
