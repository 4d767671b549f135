(** * The classes of terminal problems: the claims of Terminal.v, proved *)
From Coq Require Import NArith Permutation.
From mathcomp Require Import all_ssreflect all_algebra.
From mathcomp.zify Require Import zify.
From PL1P Require Import Statement Rigid Reducible Reductions Problems Forget Reduction Embedding.
From PL1P Require Import Scenes SameProblem.
From PL1P Require Import Orbits Census Minimal Main ProblemClasses CameraMinimal Replacements Terminal.
From PL1P Require Import Dangling Degree Lemma1 DegreeKept Lifts Recovered Listed.
Set Implicit Arguments.
Unset Strict Implicit.
Unset Printing Implicit Defensive.

(** ** The signature of a terminal problem *)
Definition tf i := nth (feat 0 o o o) terminal_features i.
Definition terminal_of (s : signature) : problem := flatten [seq nseq (nth 0 s i) (tf i) | i <- iota 0 27].
Lemma relabel_terminal_index (g g' : view -> view) f : g =1 g' ->
  terminal_index (relabel_feature g f) = terminal_index (relabel_feature g' f).
Proof.
move=> e; have gf : alike (relabel_feature g f) (relabel_feature g' f).
  by split=> // v; rewrite /relabel_feature [LHS]/= [RHS]/= e.
by case: (listed_alike gf).
Qed.
Local Opaque index_of terminal_index lift.
Lemma count_ext (p q b : pred feature) A : (forall f, b f -> p f = q f) -> all b A -> count p A = count q A.
Proof. by move=> e; elim: A => //= f A IH /andP[/e -> /IH ->]. Qed.

Lemma lifted_signature A : is_problem A -> terminal_known A ->
  known (map lift A) /\
    signature_of (map lift A) = mkseq (fun i => count (fun f => terminal_index f == i) A) 27.
Proof.
move=> pA kA; have e : all (fun f => index_of (lift f) == terminal_index f) A.
  by elim: A pA kA => //= f A IH /andP[pf pA] /andP[kf kA]; have [_ -> _] := terminal_lift pf kf;
    rewrite eqxx IH.
split.
  by elim: A e kA {pA} => //= f A IH /andP[/eqP -> e] /andP[-> /(IH e)].
rewrite /signature_of /mkseq; apply: eq_map => i.
apply: etrans (count_map lift (fun f => index_of f == i) A) _.
apply: (@count_ext _ _ (fun f => index_of (lift f) == terminal_index f)); last exact: e.
by move=> f /eqP ef; rewrite -ef.
Qed.
Lemma lifted_merged A : is_problem A -> terminal_known A ->
  merge (signature_of (map lift A)) = signature_of (map lift A).
Proof.
move=> pA kA; have [_ e] := lifted_signature pA kA; apply: merge_fixed; first by rewrite size_mkseq.
have z i : i \in [:: 13; 15; 17] -> nth 0 (signature_of (map lift A)) i = 0.
  move=> il; have i27 : i < 27 by move: il; rewrite !inE => /or3P[] /eqP ->.
  rewrite e nth_mkseq //; elim: A pA kA {e} => //= f A IH /andP[pf pA] /andP[kf kA]; rewrite IH // addn0.
  by have [_ _ n] := terminal_lift pf kf; case: eqP => // ei; rewrite ei il in n.
by rewrite /no_mates !z.
Qed.

(** Problems of the same signature are the same. *)
Lemma terminal_same f : terminal_index f < 27 -> same f (tf (terminal_index f)).
Proof. by move=> h; apply: (nth_find (feat 0 o o o)); rewrite has_find. Qed.
Lemma terminal_block A i : i < 27 ->
  all2 same [seq f <- A | terminal_index f == i] (nseq (count (fun f => terminal_index f == i) A) (tf i)).
Proof.
move=> lt; elim: A => //= f A IH; case: eqP => //= e; rewrite IH andbT -e; apply: terminal_same.
by rewrite e.
Qed.
Lemma terminal_known_same A : is_problem A -> terminal_known A ->
  same_problem A (terminal_of (signature_of (map lift A))).
Proof.
move=> pA kA; have [_ ->] := lifted_signature pA kA.
exists (flatten [seq [seq f <- A | terminal_index f == i] | i <- iota 0 27]).
  exact: (@sorted_permutation terminal_index 27 A kA).
rewrite /terminal_of; have : all (fun i => i < 27) (iota 0 27) by apply/allP => i; rewrite mem_iota.
elim: (iota 0 27) => // i l IH /andP[lt /IH h]; apply: all2_cat h; rewrite nth_mkseq //;
  exact: terminal_block.
Qed.

(** ** The terminal problem of a signature *)
Definition places := [:: 0; 1; 2; 3; 4; 5; 6; 7; 8; 9; 10; 11; 12; 12; 14; 14; 16; 16; 18; 19; 20;
  21; 22; 23; 24; 25; 26].
Definition place k := nth 0 places k.
Lemma placed_checks : all (fun k => (terminal_index (tf k) == place k) && proper (tf k)) (iota 0 27).
Proof. by vm_compute. Qed.
Lemma place_check k : k < 27 -> terminal_index (tf k) = place k /\ proper (tf k).
Proof. by move=> k27; have := allP placed_checks k; rewrite mem_iota => /(_ k27)/andP[/eqP]. Qed.
Lemma place_bound k : k < 27 -> place k < 27.
Proof. by do 27?[case: k => [|k] //]. Qed.

Lemma nth_merge s i : i < 27 -> nth 0 (merge s) i = if i \in [:: 12; 14; 16] then nth 0 s i + nth 0 s i.+1
  else if i \in [:: 13; 15; 17] then 0 else nth 0 s i.
Proof. by do 27?[case: i => [|i] //]. Qed.
Definition place_splits k i := if i \in [:: 12; 14; 16] then (k == i) + (k == i.+1)
  else if i \in [:: 13; 15; 17] then 0 else (k == i : nat).
Lemma place_checks : all (fun k => all (fun i => (place k == i) == place_splits k i :> nat)
  (iota 0 27)) (iota 0 27).
Proof. by vm_compute. Qed.
Lemma merge_count (l : seq nat) : all (fun k => k < 27) l ->
  merge (mkseq (fun i => count_mem i l) 27) = mkseq (fun i => count (fun k => place k == i) l) 27.
Proof.
move=> l27; apply: (@eq_from_nth _ 0) => // i; rewrite [size _]/= => i27;
  rewrite nth_merge // [RHS]nth_mkseq //.
have one k : k < 27 -> (place k == i : nat) = place_splits k i.
  move=> k27; have := allP place_checks k; rewrite mem_iota => /(_ k27)/allP/(_ i); rewrite mem_iota.
  by move=> /(_ i27)/eqP.
have i28 : i \in [:: 12; 14; 16] -> i.+1 < 27 by rewrite !inE => /or3P[] /eqP ->.
transitivity (sumn [seq place_splits k i | k <- l]); last first.
  by elim: l l27 => //= k l IH /andP[k27 /IH ->]; rewrite one.
rewrite /place_splits; case: ifP i28 => [_ /(_ isT) i28|_ _]; first rewrite !nth_mkseq //.
  by elim: l {l27} => //= k l <-; rewrite addnACA.
case: ifP => _; first by elim: l {l27} => //= k l <-.
by rewrite nth_mkseq //; elim: l {l27} => //= k l <-.
Qed.
Lemma all_terminal_of (p : pred feature) s : (forall k, k < 27 -> p (tf k)) -> all p (terminal_of s).
Proof.
move=> h; rewrite /terminal_of; have : all (fun k => k < 27) (iota 0 27) by apply/allP => k; rewrite mem_iota.
by elim: (iota 0 27) => //= i l IH /andP[/h pi /IH hl]; rewrite all_cat hl andbT all_nseq pi orbT.
Qed.
Lemma terminal_of_proper s : is_problem (terminal_of s).
Proof. by apply: all_terminal_of => k /place_check[]. Qed.
Lemma terminal_of_known s : terminal_known (terminal_of s).
Proof. by apply: all_terminal_of => k k27; have [-> _] := place_check k27; exact: place_bound. Qed.
Lemma count_nseqs (T : Type) (p : pred T) (q : pred nat) (g : nat -> T) (h : nat -> nat) l :
  (forall k, k \in l -> p (g k) = q k) ->
  count p (flatten [seq nseq (h k) (g k) | k <- l]) = count q (flatten [seq nseq (h k) k | k <- l]).
Proof.
elim: l => //= k l IH e; rewrite !count_cat !count_nseq e ?mem_head // IH // => j jl; apply: e.
by rewrite inE jl orbT.
Qed.
Lemma terminal_of_signature s : size s = 27 -> signature_of (map lift (terminal_of s)) = merge s.
Proof.
move=> ss; have [_ ->] := lifted_signature (terminal_of_proper s) (terminal_of_known s).
pose l := flatten [seq nseq (nth 0 s i) i | i <- iota 0 27].
have e i : count (fun f => terminal_index f == i) (terminal_of s) = count (fun k => place k == i) l.
  apply: count_nseqs => k; rewrite mem_iota => /andP[_ k27].
  by have [-> _] := place_check k27.
have -> : mkseq (fun i => count (fun f => terminal_index f == i) (terminal_of s)) 27 =
    mkseq (fun i => count (fun k => place k == i) l) 27 by apply/eq_in_map => i _; exact: e.
rewrite -merge_count; last first.
  rewrite /l; have : all (fun k => k < 27) (iota 0 27) by apply/allP => k; rewrite mem_iota.
  by elim: (iota 0 27) => //= k t IH /andP[k27 /IH h]; rewrite all_cat h andbT all_nseq k27 orbT.
congr merge; rewrite -[RHS](signature_problem_of ss) /signature_of /mkseq; apply: eq_map => i; apply: esym.
apply: count_nseqs => k; rewrite mem_iota => /andP[_ k27].
by rewrite index_ftE.
Qed.

(** ** Relabeling *)
Lemma terminal_index_relabel i k : i < 6 -> k < 27 ->
  terminal_index (relabel_feature (perm i) (tf k)) = place (index_of (relabel_feature (perm i) (ft k))).
Proof.
move=> i6 k27; case: (ltnP k 5) => k5.
  have ek : tf k = ft k by move: k5; case: k k27 => [|[|[|[|[|]]]]].
  rewrite ek many_pins; last by move: k5; case: k {k27 ek} => [|[|[|[|[|]]]]].
  rewrite [ft k]known_star // star_relabel -known_star // index_ftE //.
  by move: k5; case: k {k27 ek} => [|[|[|[|[|]]]]].
have /allP/(_ i) : all (fun i => all (fun k => terminal_index (relabel_feature (perm i) (tf k)) ==
  place (index_of (relabel_feature (perm i) (ft k)))) (iota 5 22)) (iota 0 6) by vm_compute.
by rewrite mem_iota => /(_ i6)/allP/(_ k); rewrite mem_iota k5 => /(_ k27)/eqP.
Qed.
Lemma terminal_same_index f g : proper f -> proper g -> same f g -> terminal_index f = terminal_index g.
Proof.
move=> pf pg fg; apply: eq_find => h; apply/idP/idP; last exact: same_trans.
by apply: same_trans pg (same_sym pf fg).
Qed.
Lemma terminal_relabel i A : i < 6 -> is_problem A -> terminal_known A ->
  terminal_known (relabel_problem (perm i) A) /\ signature_of (map lift (relabel_problem (perm i) A)) =
    merge (relabel (perm (inverse i)) (signature_of (map lift A))).
Proof.
move=> i6 pA kA; have pR := relabel_problem_proper (perm i) pA.
pose h f := index_of (relabel_feature (perm i) (ft (terminal_index f))).
have both : all (fun f => (terminal_index (relabel_feature (perm i) f) == place (h f)) && (h f < 27)) A.
  elim: A pA kA {pR} => //= f A IH /andP[pf pA] /andP[kf kA]; rewrite (IH pA kA) andbT.
  have [lt _] := tableP i6 kf; rewrite lt andbT -terminal_index_relabel //; apply/eqP.
  apply: terminal_same_index; [exact: relabel_proper | | exact: relabel_same (terminal_same kf)].
  by apply: relabel_proper; have [] := place_check kf.
have kR : terminal_known (relabel_problem (perm i) A).
  rewrite /terminal_known all_map; apply: sub_all both => f /andP[/eqP /= -> lt]; exact: place_bound.
split=> //; have [_ ->] := lifted_signature pR kR; have [_ ->] := lifted_signature pA kA.
pose l := map h A.
have -> : relabel (perm (inverse i)) (mkseq (fun k => count (fun f => terminal_index f == k) A) 27) =
    mkseq (fun k => count_mem k l) 27.
  apply/eq_in_map => j; rewrite mem_iota => /andP[_ j27].
  have [lt _] := tableP (proj1 (inverseK i6)) j27; rewrite nth_mkseq // /l count_map.
  elim: A kA {pA pR kR both l} => //= f A IH /andP[kf /IH ->]; congr (_ + _); rewrite /h table_swap //.
rewrite merge_count; last by rewrite /l all_map; apply: sub_all both => f /andP[].
apply/eq_in_map => j _; rewrite /l !count_map;
  elim: A both {pA kA pR kR l} => //= f A IH /andP[/andP[/eqP -> _] /IH ->].
by [].
Qed.

Lemma relabel_count (g g' : view -> view) m A : g =1 g' ->
  count (fun f => terminal_index f == m) (relabel_problem g A) =
  count (fun f => terminal_index f == m) (relabel_problem g' A).
Proof. by move=> e; elim: A => //= f A ->; rewrite (relabel_terminal_index f e). Qed.

Lemma permutation_same X Y Z : Permutation X Y -> all2 same Z X ->
  exists2 Z', Permutation Z Z' & all2 same Z' Y.
Proof.
move=> XY; elim: XY Z => {X Y} [|x X Y _ IH|x y X|X Y W _ IH1 _ IH2] Z.
- by case: Z => // _; exists [::].
- by case: Z => //= z Z /andP[zx /IH[Z' p h]]; exists (z :: Z') => /=; [exact: perm_skip | rewrite zx].
- by case: Z => [|z [|z' Z]] //=; rewrite ?andbF // => /and3P[h1 h2 h3]; exists (z' :: z :: Z);
    [exact: perm_swap | rewrite /= h1 h2].
by move=> /IH1[Z1 p1 /IH2[Z2 p2 h]]; exists Z2 => //; exact: Permutation_trans p1 p2.
Qed.
Lemma same_problem_join A B T : is_problem A -> is_problem B -> same_problem A T -> same_problem B T ->
  same_problem A B.
Proof.
move=> pA pB [A' AA AT] [B' BB BT].
have pA' : is_problem A' by rewrite /is_problem -(all_permutation _ AA).
have pB' : is_problem B' by rewrite /is_problem -(all_permutation _ BB).
have AB : all2 same A' B'.
  have TB := all2_same_sym pB' BT; elim: A' T B' AT TB pA' {AA BB BT pB'} => [|f A' IH] [|h T] [|g B'] //=.
  by move=> /andP[h1 AT] /andP[h2 TB] /andP[pf pA']; rewrite (same_trans pf h1 h2) (IH T).
have [Z p h] := permutation_same (Permutation_sym BB) AB; exists Z => //; exact: Permutation_trans AA p.
Qed.
Lemma terminal_dangles A : is_problem A -> terminal_known A -> all (fun f => all_dangle f (mates f)) A.
Proof.
elim: A => //= f A IH /andP[pf pA] /andP[kf /(IH pA) ->]; rewrite andbT.
by have [] := terminal_lift pf kf.
Qed.

(** ** The theorem *)
Section Over.
Variable F : fieldType.
Hypothesis char0 : [char F]%R =i pred0.
Lemma good_merge s : good F s -> good F (merge s).
Proof.
case=> bs ms; have sz : size s = 27 by case/andP: bs => /eqP.
have mm : merge s \in merge_orbit s.
  by rewrite /merge_orbit -{1}(act_id sz); apply: (map_f (fun pi => merge (act s pi)));
    rewrite -perms_id perms_head.
have := @stable merge_orbit (fun s => ~~ obstructed s) merge_orbit_size portrait_swap pp_min s _ mm.
rewrite bs ((minimal_iff char0 bs).1 ms) => /(_ isT)/andP[bm om]; split=> //; exact/(minimal_iff char0 bm).
Qed.
Lemma terminal_of_good s : good F s -> terminal F (terminal_of s).
Proof.
move=> gs; have [bs _] := gs; have sz : size s = 27 by case/andP: bs => /eqP.
have pT := terminal_of_proper s; have kT := terminal_of_known s; apply/(terminalP char0); split=> //.
have [pL /= e] := @lift_problem F char0 [::] _ pT (terminal_dangles pT kT); apply/e.
have [kL _] := lifted_signature pT kT; have [_ mS] := good_merge gs.
suff : minimal F (map lift (terminal_of s)) by case/(camera_minimal_theorem char0).
apply/(same_minimal char0 pL (problem_of_proper _) (known_same kL)); rewrite terminal_of_signature //.
Qed.
Lemma terminal_signature A : terminal F A -> good F (signature_of (map lift A)).
Proof.
case/(terminalP char0) => pA cA kA; have [kL _] := lifted_signature pA kA.
have [pL /= e] := @lift_problem F char0 [::] _ pA (terminal_dangles pA kA).
exact: (minimal_signature char0 pL (located_minimal char0 pL (all_located pL kL) (e.1 cA)) kL).
Qed.
Notation sig A := (signature_of (map lift A)).
Lemma swap_merge s : good F s -> swap_equiv s (merge s).
Proof.
move=> gs; have [bs _] := gs; have [bm _] := good_merge gs.
by apply/(swap_equivE bs bm) => w; rewrite merge_orbit_merge.
Qed.
Lemma terminal_sig s : good F s -> terminal F (terminal_of (merge s)) /\
  swap_equiv s (sig (terminal_of (merge s))).
Proof.
move=> gs; have gm := good_merge gs; split; first exact: terminal_of_good.
rewrite terminal_of_signature //; exact: sw_trans (swap_merge gs) (swap_merge gm).
Qed.
Lemma terminal_label A B : terminal F A -> terminal F B -> label_same A B <-> swap_equiv (sig A) (sig B).
Proof.
move=> tA tB; have [[pA _ kA] [pB _ kB]] := ((terminalP char0 A).1 tA, (terminalP char0 B).1 tB).
have [[gA _] [gB _]] := (terminal_signature tA, terminal_signature tB).
split=> [[g ig same_AB]|sw].
  have [k k6 e] := permP ig; have [kR sR] := terminal_relabel k6 pA kA.
  have eT : sig B = sig (relabel_problem (perm k) A).
    have [_ ->] := lifted_signature pB kB.
    have [_ ->] := lifted_signature (relabel_problem_proper (perm k) pA) kR.
    apply/eq_in_map => m0 _.
    rewrite -(@same_count (fun f => terminal_index f == m0) _ _ _ (relabel_problem_proper g pA) pB same_AB).
      exact: relabel_count.
    by move=> f h pf ph fh; rewrite (terminal_same_index pf ph fh).
  have [k6' _] := inverseK k6.
  have /label_equivE/mapP[pi pin er] : label_equiv (sig A) (relabel (perm (inverse k)) (sig A)).
    by apply/label_equiv_perm; exists (inverse k).
  apply/(swap_equivE gA gB) => w; rewrite eT sR er (merge_orbit_merge (act _ pi)).
  exact/esym/merge_orbit_act.
have : merge (sig B) \in merge_orbit (sig A).
  rewrite ((swap_equivE gA gB).1 sw) /merge_orbit -{1}(act_id (size_balanced gB)).
  by apply: (map_f (fun pi => merge (act (sig B) pi))); rewrite -perms_id perms_head.
rewrite (lifted_merged pB kB) => /mapP[pi pin et].
have /label_equiv_perm[i i6 ei] : label_equiv (sig A) (act (sig A) pi).
  by apply/label_equivE; exact: map_f.
have [i6' ii] := inverseK i6; have [kR sR] := terminal_relabel i6' pA kA.
rewrite ii -ei -et in sR; exists (perm (inverse i)); first exact: perm_inj.
have pR := relabel_problem_proper (perm (inverse i)) pA.
apply: (same_problem_join pR pB (terminal_known_same pR kR)); rewrite sR; exact: terminal_known_same.
Qed.
(** ** Corollary 2 of the paper *)
Lemma reveals_camera_degree A f B js d : is_problem (A ++ f :: B) -> all_dangle f js ->
  camera_degree F (A ++ f :: B) d <-> camera_degree F (A ++ reveals f js :: B) d.
Proof.
elim: js f => [|[j v] js IH] f pA //= /andP[h ad]; have [pr [u du]] := reveal_problem pA h.
exact: iff_trans (reveal_camera_degree char0 pA du d) (IH _ pr ad).
Qed.
Lemma lift_camera_degree A B d : is_problem (A ++ B) -> all (fun f => all_dangle f (mates f)) B ->
  camera_degree F (A ++ B) d <-> camera_degree F (A ++ map lift B) d.
Proof.
elim: B A => [|f B IH] A pA //= /andP[ad aB].
apply: iff_trans (reveals_camera_degree d pA ad) _; have := IH (rcons A (lift f)).
by rewrite !cat_rcons; apply=> //; exact: reveals_problem.
Qed.
Lemma lift_minimal A : terminal F A -> [/\ minimal_and_reduced F (map lift A),
  same_problem (map lift A) (problem_of (sig A)) & is_problem (map lift A)].
Proof.
move=> tA; have [pA cA kA] := (terminalP char0 A).1 tA; have [kL _] := lifted_signature pA kA.
have [pL /= e] := @lift_problem F char0 [::] _ pA (terminal_dangles pA kA).
split=> //; last exact: known_same; split=> //; last exact: (reduction_theorem char0 pL).1.
by apply: (located_minimal char0 pL (all_located pL kL)); exact/e.
Qed.
Lemma same_sig B s : is_problem B -> balanced s -> same_problem B (problem_of s) -> signature_of B = s.
Proof.
move=> pB bs e; rewrite (same_signature pB (problem_of_proper s) e).
exact: signature_problem_of (size_balanced bs).
Qed.

Lemma classes_of_terminals (Q : signature -> Prop) (R : problem -> Prop) m :
  classes swap_equiv (fun s => good F s /\ Q s) m ->
  (forall s, good F s -> Q s -> R (terminal_of (merge s))) ->
  (forall A, terminal F A -> R A -> Q (sig A)) ->
  problem_classes label_same (fun A => terminal F A /\ R A) m.
Proof.
case=> reps [sz u goods inj all_good] QR RQ; exists [seq terminal_of (merge s) | s <- reps]; rewrite size_map.
have r i : i < size reps ->
  nth [::] [seq terminal_of (merge s) | s <- reps] i = terminal_of (merge (nth [::] reps i)).
  by move=> lt; rewrite (nth_map [::]).
have rep i : i < size reps -> [/\ good F (nth [::] reps i), Q (nth [::] reps i) &
    terminal F (terminal_of (merge (nth [::] reps i))) /\
    swap_equiv (nth [::] reps i) (sig (terminal_of (merge (nth [::] reps i))))].
  by move=> lt; have [gs Qs] := goods _ (mem_nth [::] lt); split=> //; exact: terminal_sig.
split=> // [i lt|i j li lj|A [tA RA]].
- by have [gs Qs [tT _]] := rep i lt; rewrite r //; split=> //; exact: QR.
- have [_ _ [ti si]] := rep i li; have [_ _ [tj sj]] := rep j lj; rewrite !r // => /(terminal_label ti tj) sw.
  apply/eqP; rewrite -(nth_uniq [::] li lj u); apply/eqP; apply: inj; rewrite ?mem_nth //.
  exact: sw_trans si (sw_trans sw (sw_sym sj)).
have [_ /(nthP [::])[k0 lt <-] sw] := all_good _ (Logic.conj (terminal_signature tA) (RQ A tA RA)).
have [_ _ [tT sT]] := rep k0 lt; exists k0 => //; rewrite r //.
apply/(terminal_label tA tT); exact: sw_trans sw sT.
Qed.

Lemma same_pins k : k < 27 -> pins (tf k) = pins (ft k).
Proof. by do 27?[case: k => [|k] //]. Qed.
Lemma all_nseqs (T : Type) (p : pred T) (g : nat -> T) (h : nat -> nat) l :
  (forall k, k \in l -> (h k == 0) || p (g k)) -> all p (flatten [seq nseq (h k) (g k) | k <- l]).
Proof.
elim: l => //= k l IH e; rewrite all_cat all_nseq e ?mem_head // IH // => j jl; apply: e.
by rewrite inE jl orbT.
Qed.
Lemma one_pin_of s : only (fun f => pins f <= 1) s -> one_pin_each (terminal_of (merge s)).
Proof.
move=> h; apply: (@all_nseqs _ (fun f => pins f <= 1) tf (nth 0 (merge s)) (iota 0 27)) => k.
rewrite mem_iota => /andP[_ k27]; rewrite same_pins //.
apply/orP; have [z|pos] := posnP (nth 0 (merge s) k); [by left | right].
move: pos; rewrite nth_merge //; case: ifP => [|n1].
  by rewrite !inE => /or3P[] /eqP -> _.
by case: ifP => // n2 pos; exact: h k k27 pos.
Qed.
Lemma one_pin_signature A : is_problem A -> terminal_known A -> one_pin_each A ->
  only (fun f => pins f <= 1) (signature_of (map lift A)).
Proof.
move=> pA kA oA i i27; have [_ ->] := lifted_signature pA kA; rewrite nth_mkseq //.
elim: A {pA} kA oA => //= f A IH /andP[kf kA] /andP[of_ oA]; case: eqP => [e _|_];
  last by rewrite add0n; exact: IH.
by have /and3P[_ /eqP e' _] := terminal_same kf; rewrite -same_pins // -e -e'.
Qed.
End Over.

Theorem terminal_theorem : terminality.
Proof.
move=> F char0; have [[_ _ c1 _] [_ c2 _ _]] := classified char0; split.
  have c : classes swap_equiv (fun s => good F s /\ True) 74575 by apply: classes_iff c1 => s; tauto.
  have [reps [h1 h2 h3 h4]] :=
    @classes_of_terminals F char0 _ (fun=> True) _ c (fun _ _ _ => I) (fun _ _ _ => I).
  exists reps; split=> // [i lt|A tA]; first by case: (h2 i lt).
  exact: h4 A (Logic.conj tA I).
apply: (classes_of_terminals char0 c2) => [s _|A /(terminalP char0)[pA _ kA]];
  [exact: one_pin_of | exact: one_pin_signature].
Qed.
Theorem correspondence_theorem : correspondence.
Proof.
move=> F char0; split=> [A tA|A B tA tB|B [pB mB rB]].
- have [mr _ pL] := lift_minimal char0 tA; split=> // d; have [pA cA kA] := (terminalP char0 A).1 tA.
  have [_ mL _] := mr; have [_ e] := lemma1_theorem char0 pL mL.
  have := @lift_camera_degree F char0 [::] A d pA (terminal_dangles pA kA); have := e d; rewrite /=; tauto.
- have [_ sA pA] := lift_minimal char0 tA; have [_ sB pB] := lift_minimal char0 tB.
  have [bA _] := terminal_signature char0 tA; have [bB _] := terminal_signature char0 tB.
  apply: iff_trans (terminal_label char0 tA tB) _; split=> [sw|[s [t [[bs bt] es et sw]]]].
    by exists (signature_of (map lift A)), (signature_of (map lift B)).
  by rewrite (same_sig pA bs es) (same_sig pB bt et).
have [s [bs os e]] := (minimal_reduced_iff char0 pB).1 (Logic.conj mB rB).
have gs : good F s by split=> //; exact/(minimal_iff char0 bs).
have [tT sw] := terminal_sig char0 gs; exists (terminal_of (merge s)) => //.
have [_ eT _] := lift_minimal char0 tT; have [bT _] := terminal_signature char0 tT.
by exists (signature_of (map lift (terminal_of (merge s)))), s; split=> //; exact: sw_sym.
Qed.
