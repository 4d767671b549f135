(** * Theorem 5 of the paper: the features of reduced camera-minimal problems

    A feature that images and cameras cannot place can be forgotten, in full or in part. In every
    other problem each dangling pin gets one more view. If the problem is camera-minimal, it becomes
    minimal. What can then be forgotten could be forgotten before. So the features are known. *)
From mathcomp Require Import all_ssreflect all_algebra.
From mathcomp.zify Require Import zify.
From SsrMultinomials Require Import mpoly.
From PL1P Require Import Statement Reducible Reductions Forget Reduction Replacements Terminal.
From PL1P Require Import Dangling CameraMinimal RevealLifting Lifts Recovered Forgettable.
Set Implicit Arguments.
Unset Strict Implicit.
Unset Printing Implicit Defensive.
Import GRing.Theory.

(** ** Small features: a computation

    [compatible]: what can be forgotten after the lift, and could be before. *)
Definition compatible f c := [&& feasible f c, ~~ whole f c, ~~ strict (lift f) c &
  c.1 || all (fun j => j \notin c.2) (loose f)].
(** The lift of a listed feature is known. Terminal features are the listed ones that are not
    replaced. What is not forgettable is located after the lift; then it is listed, or something of
    it can be forgotten. *)
Definition judged f := [&&
  if listed f then all_dangle f (mates f) && (index_of (lift f) < 27) else true,
  (terminal_index f < 27) == listed f && ~~ replaced f &
  if forgettable f then true else [&& all_dangle f (mates f), located (lift f) &
    if index_of (lift f) < 27 then listed f else has (compatible f) (pairs (pins f))]].
Lemma small_judged : on_small judged. Proof. vm_cast_no_check (erefl true). Qed.
Lemma forgettable_alike g f : alike g f -> forgettable g = forgettable f.
Proof.
move=> gf; have [e e'] := seen_alike gf; have [e1 e2 _] := gf.
rewrite /forgettable e1 e2 /points_seen /pins_seen /count /views !e !e'.
congr (if _ then _ else _ || _).
by apply: eq_has => j; rewrite /superfluous /pins_seen /count /views /all !e !e'.
Qed.
Lemma judged_small f : proper f -> pins f <= 2 -> judged f.
Proof.
move=> pf k2; have [g gf] := on_smallP small_judged pf k2.
have [e1 e2 _] := gf; have [el em] := mates_alike gf.
have [er ed] := reveals_alike gf (mates f).
have [i1 i2 _ i3] := listed_alike gf; have [_ _ i4 _] := listed_alike er.
have ec : compatible g =1 compatible f.
  by move=> c; rewrite /compatible /feasible /whole e1 e2 el /lift em (strict_alike er).
rewrite /judged (forgettable_alike gf) i1 i2 i3 /lift em i4 (located_alike er) ed e2 (eq_has ec).
exact.
Qed.

(** ** Large ones *)
Lemma three_views (p s0 s1 s2 : view -> bool) :
  (forall v, p v || (s0 v + s1 v + s2 v <= 1)) -> p V1 || p V2 || p V3 ->
  (forall s, s = s0 \/ s = s1 \/ s = s2 -> ~~ ((s V1 + s V2 + s V3 <= 2) &&
     [&& s V1 ==> p V1, s V2 ==> p V2 & s V3 ==> p V3])) -> forall v, p v.
Proof.
move=> one p0 ns; suff : [&& p V1, p V2 & p V3] by case/and3P=> h1 h2 h3 [].
apply: contraLR p0 => np; pose t (s : view -> bool) v : nat := s v && ~~ p v.
have hits s : s = s0 \/ s = s1 \/ s = s2 -> 1 <= t s V1 + t s V2 + t s V3.
  by move=> /ns; move: np; rewrite /t; do 3![case: (p _)]; do 3![case: (s _)].
have {}one v : t s0 v + t s1 v + t s2 v + p v <= 1.
  by have := one v; rewrite /t; case: (p v); case: (s0 v); case: (s1 v); case: (s2 v).
have := hits s0 (or_introl erefl); have := hits s1 (or_intror (or_introl erefl)).
have := hits s2 (or_intror (or_intror erefl)); have := one V1; have := one V2; have := one V3.
by case: (p V1); case: (p V2); case: (p V3) => //=; lia.
Qed.
Lemma large_judged f : proper f -> 3 <= pins f -> forgettable f \/ full f.
Proof.
move=> pf k3; have fr : free f = false by apply/negP => /(free_pins pf) e; rewrite e in k3.
have [bf|] := boolP (forgettable f); first by left.
rewrite /forgettable fr !negb_or -all_predC => /and3P[/allP ns p0 _].
pose s j v := j \in sees_pins f v.
have {}ns j : j < pins f -> ~~ ((s j V1 + s j V2 + s j V3 <= 2) &&
    [&& s j V1 ==> sees_point f V1, s j V2 ==> sees_point f V2 & s j V3 ==> sees_point f V3]).
  move=> jp; have /= := ns j; rewrite mem_iota => /(_ jp).
  by rewrite /superfluous /pins_seen /= addn0 addnA andbT.
have all_points v : sees_point f v.
  move: v; apply: (@three_views _ (s 0) (s 1) (s 2)) => [v||t [->|[->|->]]].
  - have [_ _] := properP v pf; rewrite fr /s; case: (sees_point f v) => //=.
    by case: (sees_pins f v) => [|i [|i' js]] //= _; rewrite !inE; case: i => [|[|[|i]]].
  - by move: p0; rewrite /points_seen /=; do 3![case: (sees_point f _)].
  - exact: ns (ltn_trans (isT : 0 < 2) k3).
  - exact: ns (ltn_trans (isT : 1 < 2) k3).
  - exact: ns k3.
right; rewrite /full fr; have all_pins v j : j < pins f -> j \in sees_pins f v.
  move=> /ns; rewrite !all_points !implybT /= andbT -/(s j v).
  by case: v; do 3![case: (s j _)].
have one v : size (sees_pins f v) == pins f.
  have [u le _] := properP v pf; rewrite eqn_leq; apply/andP; split; rewrite -[pins f](size_iota 0).
    by apply: uniq_leq_size => // j jl; rewrite mem_iota; exact: (allP le).
  by apply: uniq_leq_size; [exact: iota_uniq | move=> j; rewrite mem_iota; exact: all_pins].
by rewrite /= !all_points !one.
Qed.

(** ** The lift *)
Lemma listed_many f : 3 <= pins f -> listed f = (index_of f < 27).
Proof.
move=> k3; rewrite -[27]/(size features) -has_find /listed has_cat.
by rewrite (negbTE (fewer_pins (s := dangling_features) k3 isT)) orbF.
Qed.
Lemma lift_known f : proper f -> 3 <= pins f -> index_of f < 27 ->
  all_dangle f (mates f) /\ lift f = f.
Proof. by move=> pf k3 kf; have [_ l0 e] := full_seen pf (known_full k3 kf); rewrite /mates l0. Qed.
Lemma listed_lift f : proper f -> listed f -> all_dangle f (mates f) /\ index_of (lift f) < 27.
Proof.
move=> pf lf; case: (leqP (pins f) 2) => [k2|k3].
  by have /and3P[] := judged_small pf k2; rewrite lf => /andP[].
by move: lf; rewrite listed_many // => kf; have [ad ->] := lift_known pf k3 kf.
Qed.
(** What is not forgettable has its place after the lift. *)
Lemma placed_lift f : proper f -> ~~ forgettable f -> all_dangle f (mates f) /\ located (lift f).
Proof.
move=> pf nb; case: (leqP (pins f) 2) => [k2|k3].
  by have /and3P[_ _] := judged_small pf k2; rewrite (negbTE nb) => /and3P[].
have [bf|ff] := large_judged pf k3; first by rewrite bf in nb.
by have [lo l0 ->] := full_seen pf ff; rewrite /mates l0.
Qed.
Lemma final_listed f : proper f -> ~~ forgettable f ->
  if index_of (lift f) < 27 then listed f : Prop else final (lift f) \/ exists c, compatible f c.
Proof.
move=> pf nb; case: (leqP (pins f) 2) => [k2|k3].
  have /and3P[_ _] := judged_small pf k2; rewrite (negbTE nb) => /and3P[_ _]; case: ifP => // _ h.
  by right; elim: (pairs _) h => //= c s IH /orP[h|/IH//]; exists c.
have [bf|ff] := large_judged pf k3; first by rewrite bf in nb.
have [_ _ ->] := full_seen pf ff; rewrite -(listed_many k3); case: ifP => // _.
by left; rewrite /final ff orbT.
Qed.
Lemma reveals_same f js : [/\ free (reveals f js) = free f, pins (reveals f js) = pins f &
  dim3 (reveals f js) = dim3 f].
Proof. by elim: js f => [|[j v] js IH] f //=; have [-> -> ->] := IH (reveal f j v). Qed.
Lemma lift_same f : [/\ free (lift f) = free f, pins (lift f) = pins f & dim3 (lift f) = dim3 f].
Proof. exact: reveals_same. Qed.

(** ** Terminal problems by their features *)
Definition terminal_known (A : problem) := all (fun f => terminal_index f < 27) A.
Lemma terminal_listed f : proper f -> (terminal_index f < 27) = listed f && ~~ replaced f.
Proof.
move=> pf; case: (leqP (pins f) 2) => [k2|k3]; first by have /and3P[_ /eqP] := judged_small pf k2.
by rewrite many_pins // listed_many // /replaced (negbTE (fewer_pins _ _)) // andbT.
Qed.

Section Over.
Variable F : fieldType.
Hypothesis char0 : [char F]%R =i pred0.
Notation lifts A cs := (lifting F (parameters A) A cs).

Lemma reveals_reduced A f B js : is_problem (A ++ f :: B) -> all_dangle f js ->
  reduced F (A ++ reveals f js :: B) -> reduced F (A ++ f :: B).
Proof.
elim: js f => [|[j v] js IH] f pA //= /andP[h ad] r; have [pr [u du]] := reveal_problem pA h.
apply: (reveal_reduced char0 pA du); exact: IH.
Qed.
Lemma lift_reduced A B : is_problem (A ++ B) -> all (fun f => all_dangle f (mates f)) B ->
  reduced F (A ++ map lift B) -> reduced F (A ++ B).
Proof.
elim: B A => [|f B IH] A pA //= /andP[ad aB] r.
apply: (reveals_reduced pA ad); rewrite -cat_rcons; apply: IH => //; last by rewrite cat_rcons.
by rewrite cat_rcons; exact: reveals_problem.
Qed.
Lemma reveals_down A f B js cs1 c cs2 : is_problem (A ++ f :: B) -> all_dangle f js ->
  size cs1 = size A -> size cs2 = size B ->
  all (fun fc => feasible fc.1 fc.2) (zip (A ++ f :: B) (cs1 ++ c :: cs2)) ->
  c.1 || all (fun jv => jv.1 \notin c.2) js ->
  lifts (A ++ reveals f js :: B) (cs1 ++ c :: cs2) -> lifts (A ++ f :: B) (cs1 ++ c :: cs2).
Proof.
elim: js f => [|[j v] js IH] f pA //= /andP[h ad] s1 s2 fe cc r.
have [pr [u du]] := reveal_problem pA h.
have [c1 c2] : c.1 || (j \notin c.2) /\ c.1 || all (fun jv => jv.1 \notin c.2) js.
  by move: cc; case: (c.1) => //= /andP[-> ->].
apply: (reveal_lifting_down du s1 fe c1); rewrite -(reveal_parameters A B f j v); apply: IH => //.
by move: fe; rewrite !zip_cat //= !all_cat.
Qed.
Lemma lift_down A B cs1 cs2 : is_problem (A ++ B) -> all (fun f => all_dangle f (mates f)) B ->
  size cs1 = size A -> size cs2 = size B ->
  all (fun fc => feasible fc.1 fc.2) (zip (A ++ B) (cs1 ++ cs2)) ->
  all (fun fc => fc.2.1 || all (fun j => j \notin fc.2.2) (loose fc.1)) (zip B cs2) ->
  lifts (A ++ map lift B) (cs1 ++ cs2) -> lifts (A ++ B) (cs1 ++ cs2).
Proof.
elim: B A cs1 cs2 => [|f B IH] A cs1 [|c cs2] pA //= /andP[ad aB] s1 [s2] fe /andP[co cB] r.
apply: (reveals_down pA ad) => //; first by move: co; rewrite /mates all_map.
rewrite -!cat_rcons; apply: IH => //; rewrite ?cat_rcons ?size_rcons ?s1 //.
- exact: reveals_problem.
- move: fe; rewrite !zip_cat //= !all_cat /=; have [e1 e2 _] := reveals_same f (mates f).
  by rewrite /lift /feasible e2.
Qed.

Lemma split_problem (p : pred feature) A : ~~ all p A ->
  exists pre f post, A = pre ++ f :: post /\ ~~ p f.
Proof.
elim: A => //= f A IH; case: (boolP (p f)) => [pf /= /IH[pre [g [post [-> h]]]]|h _].
  by exists (f :: pre), g, post.
by exists [::], f, A.
Qed.
Lemma everything_compatible A :
  all (fun fc => fc.2.1 || all (fun j => j \notin fc.2.2) (loose fc.1)) (zip A (map everything A)).
Proof. by elim: A. Qed.
Lemma compatible_reducible pre f post c (A := pre ++ f :: post) : is_problem A ->
  all (fun f => all_dangle f (mates f)) A -> minimal F (map lift A) -> compatible f c ->
  exists cs, reducible F A cs.
Proof.
move=> pA aA mA /and4P[fc nw ns co]; exists (instead pre post c).
have := pA; rewrite /is_problem all_cat => /and3P[p1 pf p2].
have [a1 _] := everything_all p1; have [a2 _] := everything_all p2.
have z := zip_instead post f post c (erefl (size pre)).
have fe : all (fun fc => feasible fc.1 fc.2) (zip A (instead pre post c)).
  by rewrite z all_cat a1 /= fc a2.
split.
  rewrite /forgets fe size_cat /= !size_map size_cat eqxx /= z all_cat /= negb_and.
  by rewrite (negbTE nw) /= orbT.
apply: (@lift_down [::] A [::]) => //; first by rewrite /= size_cat /= !size_map size_cat.
  by rewrite z all_cat everything_compatible /= co everything_compatible.
rewrite [[::] ++ _]/=; have pL : is_problem (map lift A).
  have [] := @lift_problem F char0 [::] A pA aA; by [].
have eE (B : problem) : map everything B = map everything (map lift B).
  by rewrite -map_comp; apply: eq_map => g /=; have [_ e _] := lift_same g; rewrite /everything e.
have [q1 qf q2] : [/\ is_problem (map lift pre), proper (lift f) & is_problem (map lift post)].
  by move: pL; rewrite /A map_cat /is_problem all_cat => /and3P[].
have [d1 e1] := everything_all q1; have [d2 e2] := everything_all q2.
have fl : feasible (lift f) c by move: fc; rewrite /feasible; have [_ -> _] := lift_same f.
have zL : zip (map lift A) (instead pre post c) =
    zip (map lift pre) (map everything (map lift pre)) ++
    (lift f, c) :: zip (map lift post) (map everything (map lift post)).
  by rewrite /A /instead map_cat zip_cat ?size_map // -!eE.
apply: (minimal_lifting char0 pL mA).
- by rewrite /= size_map /A !size_cat /= !size_map.
- by rewrite /= zL all_cat d1 /= fl d2.
rewrite [[::] ++ _]/= zL /A !map_cat !sumn_cat /= leq_add // leq_add //.
by rewrite leqNgt -cost_strict.
Qed.

Theorem reduced_listed A : is_problem A -> camera_minimal F A -> reduced F A -> all listed A.
Proof.
move=> pA cA rA; have nb : all (fun f => ~~ forgettable f) A.
  apply/negPn/negP => /split_problem[pre [f [post [e /negPn bf]]]]; rewrite e in pA rA.
  by have [cs h] := forgettable_reducible char0 pA bf; exact: rA h.
have both : all (fun f => proper f && ~~ forgettable f) A.
  by elim: A pA nb {cA rA} => //= f A IH /andP[-> pA] /andP[-> /(IH pA)].
have aA : all (fun f => all_dangle f (mates f)) A.
  by apply: sub_all both => f /andP[pf /(placed_lift pf)[]].
have [pL e] := @lift_problem F char0 [::] A pA aA; rewrite /= in pL e.
have mL : minimal F (map lift A).
  apply: (located_minimal char0 pL); last exact/e.
  by rewrite all_map; apply: sub_all both => f /andP[pf /(placed_lift pf)[]].
have [fin|/split_problem[pre [f [post [eA nf]]]]] := boolP (all (fun f => final (lift f)) A).
  have kL : known (map lift A).
    by apply: (reduced_known char0 pL mL); apply: (final_reduced pL); rewrite all_map.
  elim: A both kL {pA cA rA nb aA pL e mL fin} => //= f A IH /andP[/andP[pf nb] bA] /andP[kf kA].
  by rewrite (IH bA kA) andbT; have := final_listed pf nb; rewrite kf.
rewrite eA in pA rA aA mL both; have /andP[pf nbf] : proper f && ~~ forgettable f.
  by move: both; rewrite all_cat /= => /and3P[].
have := final_listed pf nbf; rewrite ifN; last by apply: contra nf => kf; rewrite /final kf.
case=> [ff|[c hc]]; first by rewrite ff in nf.
by have [cs h] := compatible_reducible pA aA mL hc; case: (rA cs h).
Qed.
Theorem listed_reduced A : is_problem A -> all listed A -> reduced F A.
Proof.
move=> pA lA; have both : all (fun f => all_dangle f (mates f) && (index_of (lift f) < 27)) A.
  elim: A pA lA => //= f A IH /andP[pf pA] /andP[lf lA]; rewrite (IH pA lA) andbT.
  by have [-> ->] := listed_lift pf lf.
have aA : all (fun f => all_dangle f (mates f)) A by apply: sub_all both => f /andP[].
have [pL _] := @lift_problem F char0 [::] A pA aA.
apply: (@lift_reduced [::] A pA aA); apply: final_reduced => //=.
by rewrite all_map; apply: sub_all both => f /andP[_ kf]; rewrite /= /final kf.
Qed.
Lemma terminalP A : terminal F A <-> [/\ is_problem A, camera_minimal F A & terminal_known A].
Proof.
split=> [[pA cA rA nA]|[pA cA kA]].
  split=> //; have := reduced_listed pA cA rA; move: nA; rewrite -all_predC.
  elim: A pA {cA rA} => //= f A IH /andP[pf pA] /andP[nf nA] /andP[lf lA].
  by rewrite terminal_listed // lf nf; exact: IH.
have both : all (fun f => listed f && ~~ replaced f) A.
  elim: A pA kA {cA} => //= f A IH /andP[pf pA] /andP[].
  by rewrite terminal_listed // => -> /(IH pA).
split=> //; last by rewrite -all_predC; apply: sub_all both => f /andP[].
by apply: (listed_reduced pA); apply: sub_all both => f /andP[].
Qed.
End Over.

Theorem dangling_pins_theorem : dangling_pins.
Proof. by move=> F char0 A pA; split; [exact: listed_reduced | exact: reduced_listed]. Qed.
