(** * Not obstructed implies rigid: from the walk to rigid integer configurations

    A full state says that p divides the camera part of every integer motion that changes no image;
    the pivots of the blocks say that p divides the rest; dividing by p again and again, the motion
    is zero. *)
From Coq Require Import ZArith Uint63 List.
From mathcomp Require Import all_ssreflect all_algebra.
From mathcomp.zify Require Import ssrZ.
From PL1P Require Import Statement Rigid Walk Elimination Forms Tree.
Set Implicit Arguments.
Unset Strict Implicit.
Unset Printing Implicit Defensive.
Local Notation ZR := [idomainType of Z].
Local Delimit Scope Z_scope with Z.

(** ** The scene of a signature: the first s_i instances of feature i *)
Definition places s := [seq (i, k) | i <- iota 0 27, k <- iota 0 (nth 0 s i)].

Lemma mem_places s i k : ((i, k) \in places s) = (i < 27) && (k < nth 0 s i).
Proof.
apply/allpairsPdep/andP => [[i' [k' []]]|[i27 ks]].
  by rewrite !mem_iota => /andP[_ h1] /andP[_ h2] [-> ->].
by exists i, k; rewrite !mem_iota.
Qed.

Section Point.
Variable pt : point_data.
Hypothesis ok : checked pt.
Local Notation cams := (Tree.cams pt).
Local Notation instance := (Tree.instance pt).
Local Notation capacity := (Tree.capacity pt).
Local Notation block_state := (Tree.block_state pt).
Local Notation camera_rows := (Tree.camera_rows pt).
Local Notation step := (Tree.step pt).
Definition scene_of s := [seq instance ik.1 ik.2 | ik <- places s].

Lemma kind_instance i k : kind (instance i k) = i.
Proof. by rewrite /Tree.instance; case: (nth _ _ _). Qed.

Lemma shape_scene s : size s = 27 -> shape (scene_of s) s.
Proof.
move=> ss; split.
  by rewrite /scene_of all_map; apply/allP => -[i k]; rewrite mem_places /= kind_instance => /andP[].
rewrite -{1}(mkseq_nth 0 s) ss; apply/eq_in_map => i; rewrite mem_iota => /andP[_ i27].
rewrite /scene_of count_map (eq_count (a2 := fun ik => ik.1 == i)); last by move=> [j k] /=;
  rewrite kind_instance.
rewrite /places count_flatten -map_comp.
have h l : uniq l -> sumn [seq count (fun ik => ik.1 == i) [seq (j, k) | k <- iota 0 (nth 0 s j)] | j <- l] =
    if i \in l then nth 0 s i else 0.
  elim: l => // j l IH /= /andP[jl ul]; rewrite IH // inE count_map.
  rewrite (eq_count (a2 := fun _ => j == i)) //.
  case: (eqVneq j i) jl => [->|ne] jl; first by rewrite (negbTE jl) addn0 count_predT size_iota.
  by rewrite count_pred0.
by rewrite h ?iota_uniq // mem_iota i27.
Qed.

Lemma balanced_capacity s i : balanced s -> i < 27 -> nth 0 s i <= capacity i.
Proof.
move=> /andP[/eqP ss /eqP b] i27.
have := allP (capacity_check ok) i; rewrite mem_iota => /(_ i27) c.
have w_i : nth 0 ws i = weight i by rewrite wsE (nth_map 0) ?size_iota // nth_iota.
have h l : i \in l -> nth 0 s i * weight i <= sumn [seq nth 0 s j * weight j | j <- l].
  elim: l => // j l IH; rewrite inE => /orP[/eqP ->|/IH le] /=; first exact: leq_addr.
  exact: leq_trans le (leq_addl _ _).
have {h} : nth 0 s i * weight i <= 11 by rewrite -b; apply: h; rewrite mem_iota.
move=> h; rewrite leqNgt; apply/negP => lt.
have := leq_trans c (leq_mul lt (leqnn (nth 0 ws i))).
by rewrite w_i => /leq_trans /(_ h); rewrite ltnn.
Qed.

(** ** Motions as lists of integers *)
Lemma evE f x : evZ f x = @ev ZR f x.
Proof. by elim: f x => [|a f IH] [|y x] //=; rewrite IH. Qed.

Lemma mem_views (A : eqType) (g : view -> seq A) f : f \in flatten [seq g v | v <- views] ->
  exists v, f \in g v.
Proof. by rewrite /= cats0 !mem_cat => /or3P[] fr; [exists V1|exists V2|exists V3]. Qed.

Section Descent.
Variable s : signature.
Hypothesis bs : balanced s.
Hypothesis us : ~~ obstructed s.

Definition place n := nth (0, 0) (places s) n.
Definition solution (c : list Z) (ms : nat -> list Z) :=
  size c = 11 /\ forall n, n < size (places s) ->
    size (ms n) = own (place n).1 /\
    forall f, f \in block cams (instance (place n).1 (place n).2) -> evZ f (ms n ++ c) = 0%Z.

Lemma insert_length st r : size (insert st r) = size st.
Proof.
elim: st r => [|o st IH] [|a r] //=.
by case: ifP => _; [rewrite /= IH | case: o => [q|] /=; [rewrite IH | case: ifP]].
Qed.
Lemma insert_all_length rows st : size (insert_all st rows) = size st.
Proof. by elim: rows st => //= r rows IH st; rewrite /insert_all /= -/(insert_all _ _) IH insert_length. Qed.
Lemma size_empty n : size (empty n) = n.
Proof. by elim: n => //= n ->. Qed.
Lemma size_block_state i k : size (block_state i k) = own i + 11.
Proof. by rewrite /Tree.block_state insert_all_length size_empty. Qed.

Lemma ForallP (A : eqType) (Q : A -> Prop) (l : seq A) : (forall a, a \in l -> Q a) -> Forall Q l.
Proof.
elim: l => [|a l IH] h; constructor; first by apply: h; rewrite inE eqxx.
by apply: IH => b bl; apply: h; rewrite inE bl orbT.
Qed.

Lemma block_holds c ms n : solution c ms -> n < size (places s) ->
  let st := block_state (place n).1 (place n).2 in small_st st /\ holds st (ms n ++ c).
Proof.
move=> [_ sol] /sol[sz eqs]; apply: insert_all_ok.
- exact: small_empty.
- by apply/Forall_map/Forall_forall => f _; exact: reduce_small.
- exact: holds_empty.
- apply/Forall_map/ForallP => f /eqs e.
  by apply: eqm_divide (reduce_ev _ _) _; rewrite e; exact: Z.divide_0_r.
Qed.

Lemma small_drop n st : small_st st -> small_st (drop n st).
Proof. by elim: n st => [|n IH] [|o st] h //; inversion h; apply: IH. Qed.

Lemma take_dropE A n (l : list A) : app (take n l) (drop n l) = l.
Proof. exact: cat_take_drop. Qed.

Lemma rows_hold c ms n : solution c ms -> n < size (places s) ->
  Forall (fun r => small r /\ (pZ | Elimination.ev r c)%Z) (camera_rows (place n).1 (place n).2).
Proof.
move=> sol lt; have [sm ho] := block_holds sol lt.
have [sc /(_ n lt)[sz _]] := sol.
move: sm ho (size_block_state (place n).1 (place n).2); rewrite /Tree.camera_rows; set st := block_state _ _;
  set o := own _ => sm ho szst.
apply: rows_of_ok.
- by rewrite -[length c]/(size c) -[length _]/(size (drop o st)) size_drop szst addKn.
- exact: small_drop.
- apply: (@holds_app (take o st) _ (ms n)); last by rewrite take_dropE.
  rewrite -[length (ms n)]/(size (ms n)) -[length _]/(size (take o st)) size_take szst sz -/o;
    by case: ifP => //; rewrite -{1}(addn0 o) ltn_add2l.
Qed.

Lemma run_holds c i l st : small_st st -> holds st c -> size st = 11 ->
  (forall j k, k < nth 0 l j -> Forall (fun r => small r /\ (pZ | Elimination.ev r c)%Z)
    (nth [::] (nth [::] (table pt) (i + j)) k)) ->
  [/\ small_st (run step i l st), holds (run step i l st) c & size (run step i l st) = 11].
Proof.
elim: l i st => //= x l IH i st sm ho sz hr.
have copies k y st' : small_st st' -> holds st' c -> size st' = 11 -> k + y <= x ->
    [/\ small_st (take_copies step i k y st'), holds (take_copies step i k y st') c & size
      (take_copies step i k y st') = 11].
  elim: y k st' => //= y IHy k st' sm' ho' sz'; rewrite addnS => lt.
  have := hr 0 k; rewrite addn0 => /(_ (leq_ltn_trans (leq_addr y k) lt)) rows.
  have [s1 h1] : small_st (step i k st') /\ holds (step i k st') c.
    apply: insert_all_ok => //; first by apply: Forall_impl rows => r [].
    by apply: Forall_impl rows => r [].
  by apply: IHy => //; rewrite ?addSn // insert_all_length.
have [s1 h1 z1] := copies 0 x st sm ho sz (leqnn _).
by apply: IH => // j k lt; rewrite addSnnS; apply: hr.
Qed.

Lemma table_nth i k : i < 27 -> k < capacity i -> nth [::] (nth [::] (table pt) i) k = camera_rows i k.
Proof.
move=> i27 kc; rewrite (tableE ok) (nth_map 0) ?size_iota // nth_iota // add0n (nth_map 0) ?size_iota //.
by rewrite nth_iota.
Qed.

Lemma place_of i k : i < 27 -> k < nth 0 s i -> exists2 n, n < size (places s) & place n = (i, k).
Proof.
move=> i27 ks; have ik : (i, k) \in places s by rewrite mem_places i27.
by exists (index (i, k) (places s)); rewrite ?index_mem // /place nth_index.
Qed.

Lemma solution_divisible c ms : solution c ms ->
  Forall (Z.divide pZ) c /\ forall n, n < size (places s) -> Forall (Z.divide pZ) (ms n).
Proof.
move=> sol; have [sc eqs] := sol.
have ss : size s = 27 by case/andP: bs => /eqP.
have [|_ ho sz] := @run_holds c 0 s (empty 11) (small_empty _) (holds_empty _ _) (size_empty _).
  move=> j k lt; rewrite add0n.
  have j27 : j < 27 by case: (ltnP j 27) => // j27; rewrite nth_default ?ss in lt.
  have [n ln e] := place_of j27 lt.
  rewrite table_nth //; last exact: leq_trans lt (balanced_capacity bs j27).
  by have := rows_hold sol ln; rewrite e.
have fu := regular_full ok bs us.
have dc : Forall (Z.divide pZ) c.
  apply: (@full_zero (run step 0 s (empty 11)) [::] c [::]) => //;
    first by rewrite -[length c]/(size c) -[length _]/(size (run step 0 s (empty 11))) sz sc.
  by rewrite !List.app_nil_r.
split=> // n ln; have [smb hob] := block_holds sol ln.
have [sz1 _] := eqs n ln.
have pn : place n \in places s by exact: mem_nth.
move: pn sz1 smb hob; case: (place n) => i k; rewrite mem_places => /andP[i27 ks] /= sz1 smb hob.
apply: (@full_zero (take (own i) (block_state i k)) (drop (own i) (block_state i k)) (ms n) c) => //.
- rewrite -[length (ms n)]/(size (ms n)) -[length _]/(size (take (own i) (block_state i k))) size_take
    size_block_state sz1; by case: ifP => //; rewrite -{1}(addn0 (own i)) ltn_add2l.
- have := allP (blocks_check ok) i; rewrite mem_iota => /(_ i27) /allP /(_ k); apply.
  by rewrite mem_iota; exact: leq_trans ks (balanced_capacity bs i27).
- by rewrite take_dropE.
Qed.

Definition quotient (x : list Z) := map (fun z => (z / pZ)%Z) x.
Lemma quotientK x : Forall (Z.divide pZ) x -> x = map (Z.mul pZ) (quotient x).
Proof.
elim: x => //= z x IH h; inversion h as [|? ? hz hx]; subst; rewrite -IH //; congr (_ :: _).
by case: hz => k ->; rewrite Z.div_mul // Z.mul_comm.
Qed.

Lemma solution_power k c ms : solution c ms ->
  Forall (Z.divide (pZ ^ Z.of_nat k)) c /\ forall n, n < size (places s) ->
    Forall (Z.divide (pZ ^ Z.of_nat k)) (ms n).
Proof.
elim: k c ms => [|k IH] c ms sol.
  by split=> [|n _]; apply/Forall_forall => z _; exact: Z.divide_1_l.
have [d1 d2] := solution_divisible sol.
have [sc eqs] := sol.
have sol' : solution (quotient c) (fun n => quotient (ms n)).
  split=> [|n ln]; first by rewrite size_map.
  have [sz e] := eqs n ln; split=> [|f fb]; first by rewrite size_map.
  have := e f fb; rewrite {1}(quotientK (d2 n ln)) {1}(quotientK d1) -map_cat evZ_scale.
  by move=> /Z.mul_eq_0[].
have times x : Forall (Z.divide (pZ ^ Z.of_nat k)) x ->
  Forall (Z.divide (pZ ^ Z.of_nat k.+1)) (map (Z.mul pZ) x).
  move=> h; apply/Forall_map; apply: Forall_impl h => z hz.
  by rewrite Nat2Z.inj_succ Z.pow_succ_r; [exact: Z.mul_divide_mono_l | exact: Nat2Z.is_nonneg].
have [h1 h2] := IH _ _ sol'.
split=> [|n ln]; first by rewrite (quotientK d1); exact: times.
by rewrite (quotientK (d2 n ln)); apply: times; exact: h2.
Qed.

Lemma solution_zero c ms : solution c ms ->
  Forall (eq 0%Z) c /\ forall n, n < size (places s) -> Forall (eq 0%Z) (ms n).
Proof.
move=> sol.
have zero x : (forall k, Forall (Z.divide (pZ ^ Z.of_nat k)) x) -> Forall (eq 0%Z) x.
  move=> h; apply/Forall_forall => z zx; apply/esym/infinitely_divisible => k k0.
  by have := h (Z.to_nat k); rewrite Z2Nat.id // => /Forall_forall; apply.
split=> [|n ln]; apply: zero => k; first by have [h _] := solution_power k sol.
by have [_ h] := solution_power k sol; apply: h.
Qed.
Lemma scene_nth n : n < size (places s) -> nth (p0 ZR) (scene_of s) n = instance (place n).1 (place n).2.
Proof. by move=> ln; rewrite /scene_of (nth_map (0, 0)). Qed.

Lemma size_scene : size (scene_of s) = size (places s).
Proof. by rewrite size_map. Qed.

Lemma scene_rigid : rigid cams (scene_of s).
Proof.
move=> T m gT; rewrite size_scene => still.
have sol : solution (camera_unknowns T) (fun n => own_unknowns (ft (place n).1) (m n)).
  split=> // n ln; have := still n ln; rewrite scene_nth //; case: (place n) => i k /=.
  rewrite kind_instance => -[gm st]; split.
    by rewrite /own_unknowns size_cat size_own_point size_pairs size_iota.
  move=> f /mem_views[v fr].
  have := st v; have := @view_blockE ZR cams T (m n) (instance i k) v gT gm (pins_okP _).
  rewrite kind_instance => <-.
  by rewrite all_map => /allP /(_ f fr) /eqP e; rewrite evE.
have [zc zm] := solution_zero sol.
have zc' x : x \in camera_unknowns T -> x = 0%R.
  move=> xc; apply/esym; move/Forall_forall: zc; apply.
  by move: xc; elim: (camera_unknowns T) => //= y l IH; rewrite inE => /orP[/eqP ->|/IH]; [left|right].
have vecE (u w : vec ZR) : x1 u = x1 w -> x2 u = x2 w -> x3 u = x3 w -> u = w.
  by case: u => ? ? ?; case: w => ? ? ? /= -> -> ->.
split.
  case: gT => e1 e2; case=> //.
    move: e2 zc'; rewrite /camera_unknowns; case: (T V2) => w t /= e2 zc'.
    by congr Twist; apply: vecE => //; apply: zc'; rewrite !inE eqxx ?orbT.
  move: zc'; rewrite /camera_unknowns; case: (T V3) => w t /= zc'.
  by congr Twist; apply: vecE; apply: zc'; rewrite !inE eqxx ?orbT.
move=> n ln; have := zm n ln; have [[gD gX] _] := still n ln; move: gD gX; rewrite scene_nth //.
case: (place n) => i k /=; rewrite kind_instance => gD gX z.
have {}z x : x \in own_unknowns (ft i) (m n) -> x = 0%R.
  move=> xc; apply/esym; move/Forall_forall: z; apply.
  by move: xc; elim: (own_unknowns _ _) => //= y l IH; rewrite inE => /orP[/eqP ->|/IH]; [left|right].
split=> [|j jk].
  have {}z x : x \in own_point (free (ft i)) (dX (m n)) -> x = 0%R by move=> xi; apply: z; rewrite mem_cat xi.
  by move: gX z; case: (free _) => gX z; apply: vecE; rewrite /= ?(gX isT) //; apply: z;
    rewrite !inE eqxx ?orbT.
apply: vecE; rewrite /= ?gD //; apply: z; rewrite /own_unknowns mem_cat; apply/orP; right;
  apply/flattenP; exists [:: x1 (dD (m n) j); x2 (dD (m n) j)]; rewrite ?inE ?eqxx ?orbT //;
  by apply/mapP; exists j => //; rewrite mem_iota.
Qed.
End Descent.

(** ** The point is admissible *)
Lemma nonzeroP u : nonzero u -> u <> vec0 ZR.
Proof. by move=> nz e; move: nz; rewrite e. Qed.
Lemma differP u w : differ u w -> u <> w.
Proof. by move=> d e; move: d; rewrite e /differ !eqxx. Qed.

Lemma scene_admissible s : balanced s -> admissible cams (scene_of s).
Proof.
move=> bs; have /and3P[n1 n2 n3] := cams_okE ok.
split.
- exact: first_camera ok.
- by case/and4P: n1 => /eqP h1 /eqP h2 /eqP h3 _ [].
- by apply/eqP.
- by case/and5P: n3 => /differP h1 /differP h2 /differP h3 /differP h4 /and3P[/differP h5 /differP h6 _] []
    [].
rewrite size_map => n ln; rewrite scene_nth // /=.
have : place s n \in places s by exact: mem_nth.
case: (place s n) => i k; rewrite mem_places => /andP[i27 ks] /=; rewrite kind_instance.
have := allP (instances_ok ok) i; rewrite mem_iota => /(_ i27) /allP /(_ k).
rewrite mem_iota => /(_ (leq_trans ks (balanced_capacity bs i27))).
move=> /andP[/and4P[/andP[a1 b1] /andP[a2 b2] /andP[a3 b3] _] /allP hd]; split.
- by case=> sp; apply/eqP; [move: a1|move: a2|move: a3]; rewrite sp.
- by case=> j jv; apply: nonzeroP; [apply: (allP b1)|apply: (allP b2)|apply: (allP b3)].
- by move=> j jk; apply/eqP/hd; rewrite mem_iota.
Qed.

Theorem regular_rigid s : balanced s -> ~~ obstructed s -> rigid_somewhere s.
Proof.
move=> bs us; exists cams, (scene_of s); split.
- by apply: shape_scene; case/andP: bs => /eqP.
- exact: scene_admissible.
- exact: scene_rigid.
Qed.
End Point.
