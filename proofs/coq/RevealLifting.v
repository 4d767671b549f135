(** * One more view of a dangling pin: what can be lifted

    A pin dangles. Let one more view see it, as in Dangling.v. What could be forgotten and lifted
    before, can be after ([reveal_lifting_up]). So if the problem with that view is reduced,
    the problem without it is ([reveal_reduced]). Conversely, what can be lifted after, could be
    before, unless the point is forgotten and the pin kept ([reveal_lifting_down]). *)
From mathcomp Require Import all_ssreflect all_algebra.
From mathcomp.zify Require Import zify.
From SsrMultinomials Require Import mpoly.
From PL1P Require Import Statement Reducible Problems Reductions Forget Derivations.
From PL1P Require Import RationalFunctions Independence Generic Motion Lifting Reduction Embedding.
From PL1P Require Import Scenes Keeps Theorem1 Determined Moved CameraMinimal Replacements Dangling.
Set Implicit Arguments.
Unset Strict Implicit.
Unset Printing Implicit Defensive.
Import GRing.Theory.
Local Open Scope ring_scope.

(** ** Lists, and scenes with selections *)
Lemma all_zip (T U : Type) (p : pred T) (q : pred (T * U)) (s : seq T) (t : seq U) :
  (forall a b, p a -> q (a, b)) -> all p s -> all q (zip s t).
Proof. by move=> h; elim: s t => [|a s IH] [|b t] //= /andP[/h -> /IH ->]. Qed.
Lemma regroup (T : Type) (a b c d e : seq T) : (a ++ b ++ c) ++ d ++ e = a ++ b ++ c ++ d ++ e.
Proof. by rewrite -!catA. Qed.
Section All.
Variables (K : fieldType) (x : nat -> K).
Lemma scene_zip_all (G : (feature * (nat -> K)) * selection -> bool) o A cs : is_problem A ->
  all (fun fc => feasible fc.1 fc.2) (zip A cs) ->
  (forall g o' c, proper g -> feasible g c -> (o <= o')%N ->
    (o' + dim3 g <= o + sumn [seq dim3 f | f <- A])%N -> G ((g, fun k => x (o' + k)%N), c)) ->
  all G (zip (scene x o A) cs).
Proof.
elim: A o cs => [|f A IH] o [|c cs] //= /andP[pf pA] /andP[fc fs] h; apply/andP; split.
  by apply: h => //; rewrite leq_add2l leq_addr.
apply: IH => // g o' d pg fd le le'; apply: h => //; last by rewrite addnA.
by apply: leq_trans le; exact: leq_addr.
Qed.
End All.

(** ** One feature *)
Section Feature.
Variables (F K : fieldType) (c0 : {rmorphism F -> K}) (D : K -> K).
Hypothesis hD : derivation c0 D.
Lemma dead_kept f x c : ~~ nothing (keep f c) -> dead D (point_at f x) ->
  (forall i, i \in c.2 -> dead D (dir_at f x i)) -> killed D (kept_parameters (f, x) c).
Proof.
move=> nn hX hd; rewrite /kept_parameters [(f, x).1]/= [(f, x).2]/=.
set Y := if c.1 then _ else _; have hY : dead D Y.
  rewrite /Y; case c1: (c.1); first exact: hX.
  have hh : dead D (dir_at f x (head 0%N c.2)).
    apply: hd; move: nn; rewrite /nothing /= c1 orbT /=.
    by case: (c.2) => [|i s] //= _; rewrite mem_head.
  apply: (dead_add hD) => //; case: hX hh => _ _ z3 [h1 h2 h3].
  have zN := zN hD z3; by split; rewrite /=; apply: (zM hD).
rewrite killed_cat killed_flatten; apply/andP; split.
  by case: hY => h1 h2 h3; case: ifP => _; rewrite /killed /= h1 h2 ?h3 eqxx.
by apply/allP => i /hd[h1 h2 _]; rewrite /killed /= h1 h2 eqxx.
Qed.
(** Lost images are among all images. *)
Lemma lost_killed fx c (C : camera K) l : killed D (image fx C l) -> killed D (lost_image fx c C l).
Proof.
rewrite /image /lost_image !killed_cat !killed_flatten => /andP[kp kl]; apply/andP; split.
  move: kp; case: (l.1); case: (c.1) => //=; case: ifP => //= _.
  by case/andP => h _; rewrite /killed /= h.
by apply/allP => i; rewrite mem_filter => /andP[_ il]; exact: (allP kl).
Qed.

(** The view that gains the pin: the pin is forgotten, or kept. [second]: the coordinate of the
    point that a view of the kept pin takes away. *)
Lemma lost_more fx c (C : camera K) j js (N := normal C (point_at fx.1 fx.2) (dir_at fx.1 fx.2 j)) :
  j \notin c.2 -> perm_eq (lost_image fx c C (true, j :: js))
    (lost_image fx c C (true, js) ++ [:: x1 N / x2 N]).
Proof.
move=> jc; rewrite /lost_image /= jc -/N (_ : (j \in mem c.2) = false) /=; last exact: negbTE.
by apply/seq.permP => q; rewrite !count_cat /= ?count_cat /=; lia.
Qed.
Definition second (fx : feature * (nat -> K)) (c : selection) (C : camera K) : seq K :=
  let y := project C (point_at fx.1 fx.2) in if c.1 then [::] else [:: x2 y / x3 y].
Lemma lost_less fx c (C : camera K) j js : feasible fx.1 c -> j \in c.2 -> j \notin js ->
  perm_eq (lost_image fx c C (true, js)) (lost_image fx c C (true, j :: js) ++ second fx c C).
Proof.
case/and3P=> uc _ fc jc jj; rewrite /lost_image /second /= jc /=.
case: (c.1) fc => /= fc; first by rewrite cats0.
have -> : has (mem c.2) js = false.
  apply/negbTE/hasPn => i il; apply: contraNN jj => /= ic.
  by move: jc ic fc; case: (c.2) => [|k [|]] //=; rewrite !inE => /eqP -> /eqP <-.
by apply/seq.permP => q; rewrite !count_cat /= ?count_cat /=; lia.
Qed.
End Feature.

(** ** The problem *)
Section Step.
Variables (F : fieldType) (pre post : problem) (f : feature) (j : nat) (u v : view).
Variables (cs1 cs2 : seq selection) (c : selection).
Notation A := (pre ++ f :: post).
Notation A' := (pre ++ reveal f j v :: post).
Notation cs := (cs1 ++ c :: cs2).
Hypothesis hj : dangles f j u v.
Hypothesis sz : size cs1 = size pre.
Notation n := (parameters A).
Notation o := (11 + sumn [seq dim3 g | g <- pre])%N.
Notation K := [fieldType of {fraction {mpoly F[n]}}].
Notation placed := (feature * (nat -> K))%type.
Notation gx := (generic F n).
Notation C := (cameras_at K gx).
Notation at_ := (fun k => gx (o + k)%N).
Notation c0 := (const (to F n)).
Notation w0 := (slope F n o f j v).
Let pv : sees_point f v. Proof. by case/and4P: hj. Qed.
Let jv : j \notin sees_pins f v. Proof. by case/and5P: hj. Qed.
Let lookv : looks f v = (true, sees_pins f v).
Proof. by rewrite -pv /sees_point /sees_pins -surjective_pairing. Qed.
Definition lost_views g := flatten [seq lost_image (g, at_) c (C w) (looks g w) | w <- views].

Lemma zip_split g : dim3 g = dim3 f -> zip (scene_of F n (pre ++ g :: post)) cs =
  zip (scene gx 11 pre) cs1 ++ ((g, at_), c) :: zip (scene gx (o + dim3 f) post) cs2.
Proof.
by move=> e; rewrite /scene_of sceneE // zip_cat // sz -[in RHS](fst_scene gx 11 pre) size_map.
Qed.
(** What is kept is the same. *)
Definition kept_part (sc : seq placed) :=
  flatten [seq kept_parameters fxc.1 fxc.2 | fxc <- zip sc cs & remains fxc].
Lemma kept_reveal : kept_part (scene_of F n A') = kept_part (scene_of F n A).
Proof.
have step (q : pred _) fxc (l : seq (placed * selection)) :
  filter q (fxc :: l) = if q fxc then fxc :: filter q l else filter q l by [].
rewrite /kept_part !zip_split // !filter_cat !map_cat !step.
rewrite -[remains (reveal f j v, at_, c)]/(remains (f, at_, c)).
by case: (remains _); exact: erefl.
Qed.
Lemma lost_split g : dim3 g = dim3 f -> lost C (scene_of F n (pre ++ g :: post)) cs =
  lost C (scene gx 11 pre) cs1 ++ lost_views g ++ lost C (scene gx (o + dim3 f) post) cs2.
Proof. by move=> e; rewrite /lost zip_split // map_cat flatten_cat. Qed.
(** The list, and all of it but what view by view is lost of f. *)
Definition front := mkseq gx 11 ++ kept_part (scene_of F n A) ++ lost C (scene gx 11 pre) cs1.
Definition back := lost C (scene gx (o + dim3 f) post) cs2.
Lemma lifted_split : lifted F n A cs = front ++ lost_views f ++ back.
Proof. by rewrite /front regroup /back -(lost_split (erefl (dim3 f))); exact: erefl. Qed.
Lemma lifted_reveal : lifted F n A' cs = front ++ lost_views (reveal f j v) ++ back.
Proof.
rewrite /front regroup /back -(lost_split (erefl : dim3 (reveal f j v) = dim3 f)) -kept_reveal.
exact: erefl.
Qed.

(** The pin is forgotten: one more element. The pin is kept: one less, or the same. *)
Lemma gains w : j \notin c.2 ->
  perm_eq (lost_image (reveal f j v, at_) c (C w) (looks (reveal f j v) w))
    (lost_image (f, at_) c (C w) (looks f w) ++ (if same_view w v then [:: w0] else [::])).
Proof.
move=> jc; rewrite [looks _ w]/=; case: same_viewP => [->|_]; last by rewrite cats0.
by rewrite pv lookv; exact: (@lost_more K (f, at_)).
Qed.
Lemma loses w : feasible f c -> j \in c.2 -> perm_eq (lost_image (f, at_) c (C w) (looks f w))
  (lost_image (reveal f j v, at_) c (C w) (looks (reveal f j v) w) ++
    (if same_view w v then second (f, at_) c (C v) else [::])).
Proof.
move=> fc jc; rewrite [looks (reveal _ _ _) w]/=; case: same_viewP => [->|_]; last by rewrite cats0.
by rewrite pv lookv; exact: (@lost_less K (f, at_)).
Qed.
Lemma lost_gains : j \notin c.2 -> perm_eq (lifted F n A' cs) (lifted F n A cs ++ [:: w0]).
Proof.
move=> jc; rewrite lifted_split lifted_reveal; apply: perm_insert.
by apply: perm_views => w; exact: gains.
Qed.
Lemma lost_loses : feasible f c -> j \in c.2 ->
  perm_eq (lifted F n A cs) (lifted F n A' cs ++ second (f, at_) c (C v)).
Proof.
move=> fc jc; rewrite lifted_split lifted_reveal; apply: perm_insert.
by apply: perm_views => w; exact: loses.
Qed.

(** The pin turns: what is kept of all else, and what is lost, stays. *)
Lemma turning_lifted D : is_problem A -> all (fun fc => feasible fc.1 fc.2) (zip A cs) ->
  derivation c0 D -> spares o j D -> killed D (images F n A) -> j \notin c.2 ->
  killed D (lifted F n A cs).
Proof.
move=> pA fs hD sD kD jc; have room : (o + dim3 f <= n)%N.
  by rewrite /parameters map_cat sumn_cat /= -addnA !leq_add2l leq_addr.
have o11 : (11 <= o)%N by exact: leq_addr.
have /and5P[/negbTE nf jp _ _ _] := hj.
have zD k : (k < 11)%N -> D (gx k) = 0 by exact: (spared_first o11 sD).
move: pA fs; rewrite /is_problem all_cat zip_cat // all_cat => /and3P[p1 _ p3] /and3P[f1 _ f3].
rewrite /lifted !killed_cat; apply/and3P; split.
- by apply/(all_nthP 0) => k; rewrite size_mkseq => k11; rewrite nth_mkseq // zD.
- have other o1 B ds : is_problem B -> all (fun fc => feasible fc.1 fc.2) (zip B ds) ->
      (o1 + sumn [seq dim3 g | g <- B] <= o)%N \/ (o + dim3 f <= o1)%N ->
      all (fun fxc => remains fxc ==> killed D (kept_parameters fxc.1 fxc.2))
        (zip (scene gx o1 B) ds).
    move=> pB fB h; apply: scene_zip_all => // g o' d pg /and3P[_ /allP le _] lo hi.
    apply/implyP => nn; have [|hX hd] := spared_other o11 room nf jp hD sD (g := g) (o' := o').
      by case: h => h; [left; exact: leq_trans hi h | right; exact: leq_trans h lo].
    by apply: (dead_kept hD nn hX) => i /le; exact: hd.
  rewrite killed_flatten all_filter -/(scene_of F n A) zip_split // all_cat.
  apply/and3P; split; [by apply: other => //; left | | by apply: other => //; right].
  apply/implyP => nn; apply: (dead_kept hD nn (spared_point nf sD)) => i ic.
  by apply: (spared_pin o11 room nf jp hD sD); apply: contraNneq jc => <-.
- move: kD; rewrite /images !killed_flatten; apply: all_zip => fx d.
  rewrite /each_view [(_, _).1]/= [(_, _).2]/= !killed_flatten; apply: sub_all => w.
  exact: lost_killed.
Qed.
End Step.

(** ** What can be lifted *)
Section Liftings.
Variables (F : fieldType) (pre post : problem) (f : feature) (j : nat) (u v : view).
Hypothesis char0 : [char F] =i pred0.
Notation A := (pre ++ f :: post).
Notation A' := (pre ++ reveal f j v :: post).
Hypothesis pA : is_problem A.
Hypothesis hj : dangles f j u v.
Notation n := (parameters A).
Notation allows cs := (all (fun fc => feasible fc.1 fc.2) (zip A cs)).

Let allowed cs1 c cs2 : size cs1 = size pre -> allows (cs1 ++ c :: cs2) -> feasible f c.
Proof. by move=> sz; rewrite zip_cat // all_cat => /and3P[]. Qed.
Lemma reveal_lifting_up cs1 c cs2 : size cs1 = size pre -> allows (cs1 ++ c :: cs2) ->
  lifting F n A (cs1 ++ c :: cs2) -> lifting F n A' (cs1 ++ c :: cs2).
Proof.
move=> sz fs li; have li' : ind (const (to F n)) (lifted F n A (cs1 ++ c :: cs2)) by exact: li.
have [jc|jc] := boolP (j \in c.2).
  exact: (ind_catl (ind_perm (lost_loses F post cs2 hj sz (allowed sz fs) jc) li')).
have [D [hD sD _ vD kD]] := turning_derivation char0 pA hj.
have kl := turning_lifted hj sz pA fs hD sD kD jc.
have p := lost_gains F post cs2 hj sz jc; rewrite cats1 perm_sym in p.
exact: (ind_perm p (moved_ind char0 hD kl vD li')).
Qed.
Lemma reveal_lifting_down cs1 c cs2 : size cs1 = size pre -> allows (cs1 ++ c :: cs2) ->
  c.1 || (j \notin c.2) -> lifting F n A' (cs1 ++ c :: cs2) -> lifting F n A (cs1 ++ c :: cs2).
Proof.
move=> sz fs cj li; have li' : ind (const (to F n)) (lifted F n A' (cs1 ++ c :: cs2)) by exact: li.
have [jc|jc] := boolP (j \in c.2).
  have := lost_loses F post cs2 hj sz (allowed sz fs) jc.
  move: cj; rewrite /second jc orbF => ->; rewrite cats0 perm_sym => p; exact: (ind_perm p li').
exact: (ind_catl (ind_perm (lost_gains F post cs2 hj sz jc) li')).
Qed.

(** The tests of a selection use only whether a feature is free, and the number of its pins. *)
Lemma reveal_zip (p : feature -> selection -> bool) cs : (forall d, p (reveal f j v) d = p f d) ->
  all (fun fc => p fc.1 fc.2) (zip A' cs) = all (fun fc => p fc.1 fc.2) (zip A cs).
Proof. by move=> e; elim: pre cs => [|g B IH] [|c cs] //=; rewrite ?e ?IH. Qed.
Lemma reveal_allows cs : all (fun fc => feasible fc.1 fc.2) (zip A' cs) = allows cs.
Proof. exact: (@reveal_zip feasible). Qed.
Lemma reveal_forgets cs : forgets A' cs = forgets A cs.
Proof. by rewrite /forgets reveal_allows (@reveal_zip whole) // !size_cat. Qed.

(** The same for a whole selection, with the parameters of the other problem. *)
Let split_cs (cs : seq selection) : size cs = size A ->
  exists cs1 c cs2, cs = cs1 ++ c :: cs2 /\ size cs1 = size pre.
Proof.
move=> sz; have lt : (size pre < size cs)%N by rewrite sz size_cat /= addnS ltnS leq_addr.
exists (take (size pre) cs), (nth (true, [::]) cs (size pre)), (drop (size pre).+1 cs).
by rewrite -drop_nth // cat_take_drop size_take lt.
Qed.
Lemma reveal_lifts cs : size cs = size A -> allows cs ->
  lifting F n A cs -> lifting F (parameters A') A' cs.
Proof.
rewrite reveal_parameters => /split_cs[cs1 [c [cs2 [-> sz]]]]; exact: reveal_lifting_up.
Qed.
Lemma reveal_reducible cs : reducible F A cs -> reducible F A' cs.
Proof.
case=> fo li; split; first by rewrite reveal_forgets.
by case/and3P: fo => /eqP sz fs _; exact: reveal_lifts.
Qed.
Corollary reveal_reduced : reduced F A' -> reduced F A.
Proof. by move=> r cs /reveal_reducible; exact: r. Qed.
End Liftings.
