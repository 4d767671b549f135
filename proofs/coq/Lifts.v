(** * From terminal problems to minimal ones

    In a terminal problem each dangling pin gets one more view. Then it consists of the 27 features,
    and their images determine them, given the cameras. So it is minimal. *)
From mathcomp Require Import all_ssreflect all_algebra.
From SsrMultinomials Require Import mpoly.
From PL1P Require Import Statement Reducible Reductions Forget Derivations RationalFunctions
  Independence Generic Lifting Reduction Embedding Scenes Keeps Theorem1 Replacements Terminal
  Dangling Placed CameraMinimal.
Set Implicit Arguments.
Unset Strict Implicit.
Unset Printing Implicit Defensive.
Import GRing.Theory.

(** ** The lift of a feature

    The 27 features, with P/P/a for both Pa/P/a and P/Pa/a (12 to 17), and P/a/b for Pab/a/b. *)
Definition terminal_features := take 12 features ++ [::
  feat 1 a P P; feat 1 a P P; feat 1 P a P; feat 1 P a P; feat 1 P P a; feat 1 P P a;  (* 12 .. 17 *)
  feat 0 o P P; feat 0 P o P; feat 0 P P o;                                            (* 18 .. 20 *)
  feat 1 P a a; feat 1 a P a; feat 1 a a P;                                            (* 21 .. 23 *)
  feat 2 P b a; feat 2 b P a; feat 2 b a P].                                           (* 24 .. 26 *)
Definition terminal_index f := find (same f) terminal_features.
Definition points_seen f := count (sees_point f) views.
Fixpoint all_dangle f (js : seq (nat * view)) := if js is (j, v) :: js' then
  has (fun u => dangles f j u v) views && all_dangle (reveal f j v) js' else true.
(** Given the cameras, the images determine the feature. *)
Definition located f := all (fun j => 2 <= pins_seen f j) (iota 0 (pins f)) && [|| free f,
  2 <= points_seen f |
  has (fun u => sees_point f u && has (fun w => ~~ same_view u w &&
    ((0 \in sees_pins f w) || (1 \in sees_pins f w))) views) views].

(** ** A computation for all features with at most two pins *)
Definition on_small (check : pred feature) := all (fun k => all (fun fr => all (fun l1 =>
  all (fun l2 => all (fun l3 => let f := Feature fr k (by_view l1 l2 l3) in
    if proper f then check f else true)
  (pairs k)) (pairs k)) (pairs k)) [:: true; false]) (iota 0 3).
(** The same looks. *)
Definition alike g f := [/\ free g = free f, pins g = pins f & forall v, looks g v = looks f v].
Section Alike.
Variables g f : feature.
Hypothesis gf : alike g f.
Let same_alike : same g =1 same f.
Proof.
case: gf => e1 e2 e3 h; rewrite /same e1 e2; congr [&& _, _ & _]; apply: eq_has => r.
by rewrite /views [LHS]/all [RHS]/all !e3.
Qed.
Lemma seen_alike : (forall v, sees_point g v = sees_point f v) /\
  forall v, sees_pins g v = sees_pins f v.
Proof. by case: gf => _ _ e; split=> v; rewrite /sees_point /sees_pins e. Qed.
Lemma reveals_alike js : alike (reveals g js) (reveals f js) /\ all_dangle g js = all_dangle f js.
Proof.
elim: js g f gf => [|[j v] js IH] g0 f0 [e1 e2 e3] //=.
have [] := IH (reveal g0 j v) (reveal f0 j v).
  by split=> // w /=; rewrite /sees_point /sees_pins !e3.
by move=> h ->; split=> //; rewrite /dangles /sees_point /sees_pins /= !e3 e1 e2.
Qed.
Lemma mates_alike : loose g = loose f /\ mates g = mates f.
Proof.
have [e e'] := seen_alike; have [_ e2 _] := gf.
have el : loose g = loose f.
  by rewrite /loose e2; apply: eq_filter => j; rewrite /pins_seen /count /views !e'.
by split=> //; rewrite /mates el; apply: eq_map => j; rewrite /mate !e !e'.
Qed.
Lemma strict_alike c : strict g c = strict f c.
Proof.
have [e1 e2 e3] := gf.
rewrite /strict /space /nothing /dim3 !dim2E /seen_by /keep /sees_point /sees_pins /=.
by rewrite /sees_point /sees_pins !e3 e1 e2.
Qed.
Lemma listed_alike : [/\ listed g = listed f, replaced g = replaced f, index_of g = index_of f &
  terminal_index g = terminal_index f].
Proof. by split; first [exact: (eq_has same_alike) | exact: (eq_find same_alike)]. Qed.
Lemma located_alike : located g = located f.
Proof.
have [e e'] := seen_alike; have [e1 e2 _] := gf.
rewrite /located /points_seen /count /has /views !e !e' e1 e2; congr (_ && _); apply: eq_all => j.
by rewrite /pins_seen /count /views !e'.
Qed.
End Alike.
Lemma on_smallP check f : on_small check -> proper f -> pins f <= 2 -> exists2 g, alike g f & check g.
Proof.
move=> all_ok pf k2; have in_pairs v : looks f v \in pairs (pins f).
  by have [u le _] := properP v pf; exact: pairsP.
move: all_ok => /allP/(_ (pins f)); rewrite mem_iota add0n ltnS => /(_ k2).
move=> /allP/(_ (free f)); rewrite !inE.
have -> : (free f == true) || (free f == false) by case: (free f).
move=> /(_ isT) /allP/(_ _ (in_pairs V1)) /allP/(_ _ (in_pairs V2)) /allP/(_ _ (in_pairs V3)).
set g := Feature _ _ _; have pg : proper g by move: pf; rewrite /proper /=.
by move=> ok; exists g; [split=> //; case | move: ok; rewrite /= pg].
Qed.

(** The 27 features are located; the lifts of terminal ones are known. *)
Definition checks f := (if index_of f < 27 then located f else true) &&
  (if terminal_index f < 27 then [&& all_dangle f (mates f),
     index_of (lift f) == terminal_index f & terminal_index f \notin [:: 13; 15; 17]] else true).
Lemma small_checks : on_small checks. Proof. vm_cast_no_check (erefl true). Qed.
Lemma small_check f : proper f -> pins f <= 2 ->
  (index_of f < 27 -> located f) /\ (terminal_index f < 27 ->
  [/\ all_dangle f (mates f), index_of (lift f) = terminal_index f &
      terminal_index f \notin [:: 13; 15; 17]]).
Proof.
move=> pf k2; have [g gf] := on_smallP small_checks pf k2.
have [_ em] := mates_alike gf; have [er ed] := reveals_alike gf (mates f).
have [_ _ i1 i2] := listed_alike gf; have [_ _ i3 _] := listed_alike er.
rewrite /checks i1 i2 (located_alike gf) /lift em ed i3 => /andP[h1 h2].
split=> h; first by move: h1; rewrite h; exact.
by move: h2; rewrite h => /and3P[a1 /eqP a2 a3]; split; [exact: a1 | exact: a2 | exact: a3].
Qed.

Lemma full_seen f : proper f -> full f -> [/\ located f, loose f = [::] & lift f = f].
Proof.
move=> pf ff; have s j : j < pins f -> pins_seen f j = 3.
  move=> jp; have h v : j \in sees_pins f v by rewrite (perm_mem (full_pins v pf ff)) mem_iota.
  by rewrite /pins_seen /= !h.
have l0 : loose f = [::].
  rewrite /loose (@eq_in_filter _ _ pred0) ?filter_pred0 // => j; rewrite mem_iota => /s -> //.
split=> //; last by rewrite /lift /mates l0.
rewrite /located /points_seen /= !full_point // orbT andbT.
by apply/allP => j; rewrite mem_iota => /s ->.
Qed.
Lemma find_cat_same (p : pred feature) s t t' : ~~ has p t -> ~~ has p t' -> size t = size t' ->
  find p (s ++ t) = find p (s ++ t').
Proof. by move=> h h' e; rewrite !find_cat; case: ifP => // _; rewrite !hasNfind // e. Qed.
Lemma fewer_pins f s : 3 <= pins f -> all (fun g => pins g <= 2) s -> ~~ has (same f) s.
Proof.
move=> k3; elim: s => //= g s IH /andP[le /IH h]; rewrite negb_or h andbT.
by apply/negP => /and3P[_ /eqP e _]; move: k3; rewrite e ltnNge le.
Qed.
Lemma many_pins f : 3 <= pins f -> terminal_index f = index_of f.
Proof.
move=> k3; have none t : all (fun g => pins g <= 2) t -> ~~ has (same f) t := fewer_pins k3.
by apply: (@find_cat_same (same f) (take 5 features) (drop 5 terminal_features) (drop 5 features));
  first [exact: none | done].
Qed.
Lemma known_located f : proper f -> index_of f < 27 -> located f.
Proof.
move=> pf kf; case: (leqP (pins f) 2) => [k2|k3]; first exact: (small_check pf k2).1.
by have [] := full_seen pf (known_full k3 kf).
Qed.
Lemma many_place : all (fun i => (3 <= pins (ft i)) ==> (i \notin [:: 13; 15; 17])) (iota 0 27).
Proof. by vm_compute. Qed.
Lemma terminal_lift f : proper f -> terminal_index f < 27 ->
  [/\ all_dangle f (mates f), index_of (lift f) = terminal_index f &
      terminal_index f \notin [:: 13; 15; 17]].
Proof.
move=> pf kf; case: (leqP (pins f) 2) => [k2|k3]; first exact: (small_check pf k2).2.
have e := many_pins k3; rewrite e in kf *; have [_ l0 lf] := full_seen pf (known_full k3 kf).
have sf : same f (ft (index_of f)) by apply: (nth_find (feat 0 o o o)); rewrite has_find.
have n : index_of f \notin [:: 13; 15; 17].
  have h := allP many_place (index_of f); rewrite mem_iota add0n in h; have /implyP := h kf.
  by apply; case/and3P: sf => _ /eqP <- _.
rewrite /mates l0 lf; split; [exact: isT | exact: erefl | exact: n].
Qed.

(** ** Problems *)
Lemma reveal_problem A f B j v : is_problem (A ++ f :: B) -> has (fun u => dangles f j u v) views ->
  is_problem (A ++ reveal f j v :: B) /\ exists u, dangles f j u v.
Proof.
move=> pA h; have [u du] : exists u, dangles f j u v by case/or4P: h => // d; eexists; exact: d.
split; last by exists u.
move: pA; rewrite /is_problem !all_cat /= => /and3P[-> pf ->]; by rewrite (reveal_proper pf du).
Qed.
Lemma reveals_problem A f B js : is_problem (A ++ f :: B) -> all_dangle f js ->
  is_problem (A ++ reveals f js :: B).
Proof.
elim: js f => [|[j v] js IH] f pA //= /andP[h ad]; have [pr _] := reveal_problem pA h; exact: IH.
Qed.
Section Over.
Variable F : fieldType.
Hypothesis char0 : [char F]%R =i pred0.
Lemma reveals_minimal A f B js : is_problem (A ++ f :: B) -> all_dangle f js ->
  is_problem (A ++ reveals f js :: B) /\
  (camera_minimal F (A ++ f :: B) <-> camera_minimal F (A ++ reveals f js :: B)).
Proof.
elim: js f => [|[j v] js IH] f pA //= /andP[h ad]; have [pr [u du]] := reveal_problem pA h.
have [pl e] := IH _ pr ad; split=> //; exact: iff_trans (reveal_minimal char0 pA du) e.
Qed.
Lemma lift_problem A B : is_problem (A ++ B) -> all (fun f => all_dangle f (mates f)) B ->
  is_problem (A ++ map lift B) /\ (camera_minimal F (A ++ B) <-> camera_minimal F (A ++ map lift B)).
Proof.
elim: B A => [|f B IH] A pA //= /andP[ad kB].
have [p1 e1] := reveals_minimal pA ad.
have := IH (rcons A (lift f)); rewrite !cat_rcons => /(_ p1 kB)[p2 e2]; split=> //; exact: iff_trans e1 e2.
Qed.
End Over.
