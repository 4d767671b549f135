(** * Forgetting points and lines: what it costs, feature by feature

    A feature is final if it is one of the 27, or a point with any number of pins that all views see
    in full. Whatever is forgotten of a final feature takes more degrees of freedom from the images
    than from space ([final_strict]). Of any other feature something can be forgotten that takes at
    least as many from space ([not_final]). *)
From mathcomp Require Import all_ssreflect.
From mathcomp.zify Require Import zify.
From PL1P Require Import Statement Reducible.
Set Implicit Arguments.
Unset Strict Implicit.
Unset Printing Implicit Defensive.

Implicit Types (f : feature) (c : selection).

(** A point that all views see with all its pins; [final]: that, or one of the 27 features. *)
Definition full f := ~~ free f && all (fun v => sees_point f v && (size (sees_pins f v) == pins f)) views.
Definition final f := (index_of f < 27) || full f.
(** Nothing has no parameters. *)
Definition space f := if nothing f then 0 else dim3 f.
Definition seen_by f v := let n := size (sees_pins f v) in if sees_point f v then 2 + n else 2 * n.
Lemma dim2E f : dim2 f = seen_by f V1 + seen_by f V2 + seen_by f V3.
Proof. by rewrite /dim2 /= addn0 addnA. Qed.

Lemma properP f v : proper f -> [/\ uniq (sees_pins f v), all (fun j => j < pins f) (sees_pins f v) &
  if free f then ~~ sees_point f v else sees_point f v || (size (sees_pins f v) <= 1)].
Proof.
case/andP=> _; rewrite /sees_point /sees_pins => /and4P[h1 h2 h3 _].
by case: v; [move: h1 | move: h2 | move: h3]; case: (looks f _) => p js /and3P[].
Qed.
Lemma free_pins f : proper f -> free f -> pins f = 1.
Proof. by case/andP=> /implyP h _ /h /eqP. Qed.

(** ** What is kept is a feature *)
Lemma keep_proper f c : proper f -> feasible f c -> ~~ nothing (keep f c) -> proper (keep f c).
Proof.
move=> pf /and3P[uc ac fc] nn; apply/andP; split.
  apply/implyP => /= fr; rewrite eqn_leq lt0n; move: nn; rewrite /nothing /= fr /= => ->; rewrite andbT.
  case/orP: fr => [fr|nc]; last by move: fc; rewrite (negbTE nc).
  rewrite -(free_pins pf fr) -[X in _ <= X](size_iota 0); apply: uniq_leq_size => // j jc.
  by rewrite mem_iota; exact: (allP ac).
have h v : let: (point, js) := looks (keep f c) v in [&& uniq js, all (fun j => j < pins (keep f c)) js &
      if free (keep f c) then ~~ point else point || (size js <= 1)].
  have [u _ s] := properP v pf; rewrite /=; apply/and3P; split.
  - rewrite map_inj_in_uniq ?filter_uniq // => i j; rewrite !mem_filter => /andP[ic _] /andP[jc _] e.
    by rewrite -(nth_index 0 ic) e nth_index.
  - by apply/allP => i /mapP[j]; rewrite mem_filter => /andP[jc _] ->; rewrite index_mem.
  - case fr: (free f) s => /= s; first by rewrite (negbTE s).
    case: (c.1) => /=; last by rewrite andbF.
    rewrite andbT size_map; case/orP: s => [->//|le]; rewrite (leq_trans _ le) ?orbT // size_filter.
    exact: count_size.
by rewrite /= !h.
Qed.

(** ** What the images lose *)
Definition lost_seen f c v :=
  (if sees_point f v && ~~ c.1 then if has (mem c.2) (sees_pins f v) then 1 else 2 else 0) +
  (if sees_point f v then 1 else 2) * size [seq j <- sees_pins f v | j \notin c.2].

Lemma seen_split f c v : proper f -> feasible f c -> lost_seen f c v + seen_by (keep f c) v = seen_by f v.
Proof.
move=> pf /and3P[uc _ fc]; have [u _ _] := properP v pf.
rewrite /lost_seen /seen_by /sees_point /sees_pins /= size_map -/(sees_pins f v) -/(sees_point f v).
have : size [seq j <- sees_pins f v | j \notin c.2] + size [seq j <- sees_pins f v | j \in c.2] =
  size (sees_pins f v).
  by rewrite !size_filter addnC -(count_predC (mem c.2)).
have : ~~ c.1 -> size [seq j <- sees_pins f v | j \in c.2] = has (mem c.2) (sees_pins f v).
  move=> nc; have : size [seq j <- sees_pins f v | j \in c.2] <= 1.
    move: fc; rewrite (negbTE nc) /=; apply: leq_trans; apply: uniq_leq_size; first exact: filter_uniq.
    by move=> j; rewrite mem_filter => /andP[].
  by rewrite has_filter; case: (filter _ _) => [|j [|]].
move: (size _) (size _) (size _) (has _ _) => n0 n1 n2 h; case: (sees_point f v); case: (c.1); case: h => /=;
  lia.
Qed.

(** ** Small features: a computation *)
Definition strict f c := dim2 (keep f c) + dim3 f < dim2 f + space (keep f c).

Definition lists k : seq (seq nat) := match k with
  | 0 => [:: [::]] | 1 => [:: [::]; [:: 0]] | _ => [:: [::]; [:: 0]; [:: 1]; [:: 0; 1]; [:: 1; 0]] end.
Lemma listsP k js : k <= 2 -> uniq js -> all (fun j => j < k) js -> js \in lists k.
Proof.
move=> k2 u le; have : size js <= k.
  by rewrite -[k](size_iota 0); apply: uniq_leq_size => // j jl; rewrite mem_iota; exact: (allP le).
by case: k k2 le => [|[|[|k]]] // _; case: js u => [|[|[|i]] [|[|[|j]] [|l js]]] //=; rewrite ?andbF.
Qed.
Definition pairs k : seq (bool * seq nat) := [seq (b, js) | b <- [:: true; false], js <- lists k].
Lemma pairsP k (l : bool * seq nat) : k <= 2 -> uniq l.2 -> all (fun j => j < k) l.2 -> l \in pairs k.
Proof. by case: l => b js /= k2 u le; apply: allpairs_f; [case: (b) | exact: listsP]. Qed.

Definition small_ok f := let c_ok c := feasible f c ==> (whole f c || strict f c) in
  proper f ==> (final f == all c_ok (pairs (pins f))).
Lemma small_checked : all (fun k => all (fun fr => all (fun l1 => all (fun l2 => all (fun l3 =>
  small_ok (Feature fr k (by_view l1 l2 l3))) (pairs k)) (pairs k)) (pairs k)) [:: true; false]) (iota 0 3).
Proof. vm_cast_no_check (erefl true). Qed.

Lemma small f : proper f -> pins f <= 2 ->
  final f = all (fun c => feasible f c ==> (whole f c || strict f c)) (pairs (pins f)).
Proof.
move=> pf k2; have in_pairs v : looks f v \in pairs (pins f).
  by have [u le _] := properP v pf; exact: pairsP.
have /allP/(_ (pins f)) := small_checked; rewrite mem_iota add0n ltnS => /(_ k2).
move=> /allP/(_ (free f)); rewrite !inE; have -> : (free f == true) || (free f == false) by case: (free f).
move=> /(_ isT) /allP/(_ _ (in_pairs V1)) /allP/(_ _ (in_pairs V2)) /allP/(_ _ (in_pairs V3)).
by rewrite /small_ok; case: f pf k2 {in_pairs} => fr k L /= pf _ /implyP/(_ pf)/eqP.
Qed.

(** ** Large ones *)
Lemma full_pins f v : proper f -> full f -> perm_eq (sees_pins f v) (iota 0 (pins f)).
Proof.
move=> pf /andP[_ /and4P[h1 h2 h3 _]]; have [u le _] := properP v pf.
have : size (sees_pins f v) = pins f by case: v {u le}; apply/eqP;
  [case/andP: h1|case/andP: h2|case/andP: h3].
move=> sz; apply: uniq_perm; rewrite ?iota_uniq //.
have sub : {subset sees_pins f v <= iota 0 (pins f)} by move=> j jl; rewrite mem_iota; exact: (allP le).
by have [|_ e] := uniq_min_size u sub; [rewrite size_iota sz | exact: e].
Qed.
Lemma full_point f v : full f -> sees_point f v.
Proof. by case/andP=> _ /and4P[/andP[h1 _] /andP[h2 _] /andP[h3 _] _]; case: v. Qed.

Lemma full_strict f c : proper f -> full f -> feasible f c -> ~~ whole f c -> strict f c.
Proof.
move=> pf ff /and3P[uc ac fc]; have nf : free f = false by case/andP: ff => /negbTE.
have sz v : size [seq j <- sees_pins f v | j \in c.2] = size c.2.
  rewrite size_filter (seq.permP (full_pins v pf ff)) -size_filter.
  apply/eqP; rewrite eqn_leq; apply/andP; split; apply: uniq_leq_size => //;
    first exact: filter_uniq (iota_uniq _ _).
    by move=> j; rewrite mem_filter => /andP[].
  by move=> j jc; rewrite mem_filter jc mem_iota; exact: (allP ac).
have sf v : seen_by f v = 2 + pins f.
  by rewrite /seen_by full_point // (perm_size (full_pins v pf ff)) size_iota.
have sk v : seen_by (keep f c) v = if c.1 then 2 + size c.2 else 2 * size c.2.
  by rewrite /seen_by /sees_point /sees_pins /= size_map -/(sees_pins f v) sz -/(sees_point f v) full_point.
rewrite /whole /strict /space /nothing nf /= !dim2E !sf !sk /dim3 /= nf /=.
have : size c.2 <= pins f.
  by rewrite -[pins f](size_iota 0); apply: uniq_leq_size => // j jc; rewrite mem_iota; exact: (allP ac).
case: (c.1) fc => /=; first by move=> _; lia.
by case: (size c.2) => [|[|n]] //=; lia.
Qed.

(** A known feature with three pins or more is a star. *)
Lemma known_full f : 3 <= pins f -> index_of f < 27 -> full f.
Proof.
move=> k3 h; have sf : same f (ft (index_of f)) by apply: (nth_find (feat 0 o o o)); rewrite has_find.
have /and3P[/eqP fr /eqP kp /hasP[r _ /and4P[s1 s2 s3 _]]] := sf.
have big : all (fun i => (3 <= pins (ft i)) ==> full (ft i)) (iota 0 27) by vm_compute.
have := allP big (index_of f); rewrite mem_iota => /(_ h); rewrite -kp k3 /= => /andP[nf /and4P[g1 g2 g3 _]].
have one v : same_look r (looks f v) (looks (ft (index_of f)) v) ->
    sees_point (ft (index_of f)) v && (size (sees_pins (ft (index_of f)) v) == pins (ft (index_of f))) ->
    sees_point f v && (size (sees_pins f v) == pins f).
  rewrite /same_look /sees_point /sees_pins kp => /andP[/eqP -> /perm_size]; rewrite size_map => -> //.
by rewrite /full fr nf /= !one.
Qed.

Lemma final_strict f c : proper f -> final f -> feasible f c -> ~~ whole f c -> strict f c.
Proof.
move=> pf ff fc nw; case: (leqP (pins f) 2) => [k2|k3].
  move: ff; rewrite small // => /allP/(_ c); rewrite fc (negbTE nw) /=; apply.
  by case/and3P: fc => u le _; exact: pairsP.
by apply: full_strict => //; case/orP: ff => //; exact: known_full.
Qed.

(** The image coordinates that pin j has. *)
Definition share f j := sumn [seq (if sees_point f v then 1 else 2) * (j \in sees_pins f v) | v <- views].
Lemma forget_pin f j : proper f -> ~~ free f -> j < pins f -> let c := (true, rem j (iota 0 (pins f))) in
  [/\ feasible f c, ~~ whole f c & dim2 (keep f c) + share f j = dim2 f].
Proof.
move=> pf nf jp c; have ji : j \in iota 0 (pins f) by rewrite mem_iota.
split.
- by rewrite /feasible /= rem_uniq ?iota_uniq //=; apply/andP; split=> //; apply/allP => i /mem_rem;
    rewrite mem_iota.
- rewrite /whole (negbTE nf) /= size_rem // size_iota; case: (pins f) jp => // k _;
    by rewrite neq_ltn /= ltnSn.
have one v : seen_by (keep f c) v + (if sees_point f v then 1 else 2) * (j \in sees_pins f v) = seen_by f v.
  have [u le _] := properP v pf.
  rewrite /seen_by /sees_point /sees_pins /= size_map -/(sees_pins f v) -/(sees_point f v) andbT.
  have -> : [seq i <- sees_pins f v | i \in rem j (iota 0 (pins f))] = rem j (sees_pins f v).
    rewrite (rem_filter j u); apply: eq_in_filter => i il; rewrite mem_rem_uniq ?iota_uniq //.
    by rewrite !inE mem_iota (allP le) ?andbT.
  case: (boolP (j \in _)) => jv; last by rewrite rem_id // muln0 addn0.
  rewrite size_rem //; have : 0 < size (sees_pins f v) by case: (sees_pins f v) jv.
  by case: (sees_point f v) => /=; lia.
rewrite !dim2E /share /= -(one V1) -(one V2) -(one V3).
by move: (_ * _) (_ * _) (_ * _) => n1 n2 n3; lia.
Qed.

Lemma not_final f : proper f -> final f \/ exists2 c, feasible f c && ~~ whole f c & ~~ strict f c.
Proof.
move=> pf; have [ff|nf] := boolP (final f); [by left | right].
case: (leqP (pins f) 2) => [k2|k3].
  move: nf; rewrite small // => /allPn[c _]; rewrite negb_imply negb_or => /and3P[h1 h2 h3].
  by exists c; rewrite ?h1.
have fr : ~~ free f by apply/negP => /(free_pins pf) e; rewrite e in k3.
have [/hasP[j]|/hasPn big] := boolP (has (fun j => share f j <= 2) (iota 0 (pins f))).
  rewrite mem_iota => jp le; have [h1 h2 h3] := forget_pin pf fr jp.
  exists (true, rem j (iota 0 (pins f))); first by rewrite h1.
  rewrite /strict -h3 /space /nothing /dim3 /= (negbTE fr) /= size_rem ?mem_iota // size_iota.
  by move: (dim2 _) => d; rewrite -leqNgt; lia.
case/negP: nf; apply/orP; right.
have b j : j < pins f -> 2 < share f j by move=> jp; rewrite ltnNge; apply: big; rewrite mem_iota.
have few v : sees_point f v || ((0 \in sees_pins f v) + (1 \in sees_pins f v) + (2 \in sees_pins f v) <= 1).
  have [_ _] := properP v pf; rewrite (negbTE fr); case: (sees_point f v) => //=.
  by case: (sees_pins f v) => [|i [|i' js]] //= _; rewrite !inE; case: i => [|[|[|i]]].
pose w v := if sees_point f v then 1 else 2; pose a v j : nat := j \in sees_pins f v.
have cap v : w v * a v 0 + w v * a v 1 + w v * a v 2 <= if sees_point f v then 3 else 2.
  have := few v; rewrite /w /a; case: (sees_point f v) => /=; by case: (_ \in _); case: (_ \in _);
    case: (_ \in _).
have e j : share f j = w V1 * a V1 j + (w V2 * a V2 j + w V3 * a V3 j) by rewrite /share /= addn0.
have all_points v : sees_point f v.
  have := b 0 (ltn_trans (isT : 0 < 2) k3); have := b 1 (ltn_trans (isT : 1 < 2) k3); have := b 2 k3.
  have := cap V1; have := cap V2; have := cap V3; rewrite !e.
  move: (w V1 * a V1 0) (w V1 * a V1 1) (w V1 * a V1 2) (w V2 * a V2 0) (w V2 * a V2 1) (w V2 * a V2 2).
  move: (w V3 * a V3 0) (w V3 * a V3 1) (w V3 * a V3 2) => n1 n2 n3 n4 n5 n6 n7 n8 n9.
  case e1: (sees_point f V1); case e2: (sees_point f V2); case e3: (sees_point f V3); case: v;
    rewrite ?e1 ?e2 ?e3 //=; lia.
apply/andP; split=> //.
have one v : size (sees_pins f v) == pins f.
  have [u le _] := properP v pf; rewrite eqn_leq; apply/andP; split; rewrite -[pins f](size_iota 0).
    by apply: uniq_leq_size => // j jl; rewrite mem_iota; exact: (allP le).
  apply: uniq_leq_size; first exact: iota_uniq.
  move=> j; rewrite mem_iota => /b; rewrite /share /= !all_points.
  by case: v {u le} => /=; do 3![case: (_ \in _)].
by rewrite /= !all_points !one.
Qed.

(** ** Consequences *)
Lemma final_weight f : proper f -> final f -> dim3 f < dim2 f.
Proof.
move=> pf ff; have nw : ~~ whole f (false, [::]).
  by apply/negP; rewrite /whole /= orbF => /andP[fr]; rewrite (free_pins pf fr).
have := final_strict pf ff (isT : feasible f (false, [::])) nw.
by rewrite /strict /space /nothing /= orbT /= addn0; apply: leq_trans; rewrite ltnS leq_addl.
Qed.

Lemma full_known f : proper f -> full f -> pins f <= 7 -> index_of f < 27.
Proof.
move=> pf ff k7; rewrite -[27]/(size features) -has_find.
have sf : same f (star (pins f)).
  apply/and3P; split; [by case/andP: ff => /negbTE -> | by [] | apply/hasP; exists (iota 0 (pins f))].
    by rewrite mem_permutations.
  have one v : same_look (iota 0 (pins f)) (looks f v) (true, iota 0 (pins f)).
    apply/andP; split; first by apply/eqP; exact: full_point.
    have [_ le _] := properP v pf; rewrite (_ : map _ _ = sees_pins f v); first exact: full_pins.
    rewrite -[RHS]map_id; apply/eq_in_map => j jl; rewrite nth_iota ?add0n //; exact: (allP le).
  by rewrite /= !one.
move: sf k7; case: (pins f) => [|[|[|[|[|[|[|[|k]]]]]]]] // sf _; apply/(has_nthP (feat 0 o o o)).
- by exists 7. - by exists 6. - by exists 5. - by exists 4. - by exists 3. - by exists 2. - by exists 1.
  - by exists 0.
Qed.
Lemma final_unknown f : proper f -> final f -> ~~ (index_of f < 27) ->
  [/\ full f, 8 <= pins f & dim2 f = dim3 f + 3 + pins f].
Proof.
move=> pf /orP[->//|ff] nk; split=> //; first by rewrite ltnNge; apply: contra nk; exact: full_known.
have sf v : seen_by f v = 2 + pins f
  by rewrite /seen_by full_point // (perm_size (full_pins v pf ff)) size_iota.
by rewrite dim2E !sf /dim3; case/andP: ff => /negbTE -> _; lia.
Qed.
