(** * Classes of signatures and their representatives

    Relabeling permutes the entries of a signature; every swap&label class contains its merged
    forms, in which 12, 14, 16 took all of 13, 15, 17. In both cases the class of s is told by a
    finite set of signatures ([label_orbit], [merge_orbit]), and its representative is the largest
    element of that set. *)
From Coq Require Import NArith.
From mathcomp Require Import all_ssreflect.
From mathcomp.zify Require Import zify.
From PL1P Require Import Statement Walk.
Set Implicit Arguments.
Unset Strict Implicit.
Unset Printing Implicit Defensive.

(** ** Lexicographic order on lists of the same length *)
Fixpoint lexge (s t : seq nat) : bool :=
  match s, t with x :: s', y :: t' => if y < x then true else if x < y then false else lexge s' t' | _,
    _ => true end.
Lemma lexge_refl s : lexge s s. Proof. by elim: s => //= x s IH; rewrite ltnn. Qed.
Lemma lexge_anti s t : size s = size t -> lexge s t -> lexge t s -> s = t.
Proof. by elim: s t => [|x s IH] [|y t] //= [e]; case: ltngtP => // -> h1 h2; rewrite (IH t). Qed.
Lemma lexge_total s t : lexge s t || lexge t s.
Proof. by elim: s t => [|x s IH] [|y t] //=; case: ltngtP. Qed.
Lemma lexge_cons x y s t : lexge (x :: s) (y :: t) = (y < x) || (x == y) && lexge s t.
Proof. by rewrite /=; case: ltngtP. Qed.
Lemma lexge_trans t s u : size s = size t -> size t = size u -> lexge s t -> lexge t u -> lexge s u.
Proof.
elim: t s u => [|y t IH] [|x s] [|z u] // [e1] [e2]; rewrite !lexge_cons.
case/orP=> [yx|/andP[/eqP -> h1]] /orP[zy|/andP[/eqP <- h2]]; first by rewrite (ltn_trans zy yx).
- by rewrite yx.
- by rewrite zy.
- by rewrite eqxx (IH s u) ?orbT.
Qed.

(** ** Counting classes by representatives *)
Section Representatives.
Variable orbit : seq nat -> seq (seq nat).
Hypothesis orbit_size : forall s t, t \in orbit s -> size t = 27.
Hypothesis orbit_inhabited : forall s, orbit s != [::].
Hypothesis orbit_same : forall s t, t \in orbit s -> orbit t =i orbit s.

Definition representative s := (s \in orbit s) && all (lexge s) (orbit s).

Lemma orbit_max s : exists2 r, r \in orbit s & all (lexge r) (orbit s).
Proof.
have := orbit_inhabited s; have := @orbit_size s.
elim: (orbit s) => [//|a l IH] sz _; case: l IH sz => [|b l] IH sz.
  by exists a; rewrite ?inE //= lexge_refl.
have [||r rl rm] := IH; rewrite //; first by move=> t tl; apply: sz; rewrite inE tl orbT.
have sr : size r = 27 by apply: sz; rewrite inE rl orbT.
have sa : size a = 27 by apply: sz; rewrite inE eqxx.
case/orP: (lexge_total r a) => ra.
  exists r; first by rewrite inE rl orbT.
  by rewrite -[all _ _]/(lexge r a && all (lexge r) (b :: l)) ra.
exists a; first by rewrite inE eqxx.
rewrite -[all _ _]/(lexge a a && all (lexge a) (b :: l)) lexge_refl; apply/allP => t tl;
  apply: (@lexge_trans r) => //; rewrite ?sa ?sr //.
  by apply/esym/sz; rewrite inE tl orbT.
exact: (allP rm).
Qed.

Lemma classesP (E : signature -> signature -> Prop) (Q : signature -> Prop) (q : seq nat -> bool) (n : N) :
  (forall s, reflect (balanced s /\ Q s) (balanced s && q s)) ->
  (forall s t, balanced s -> balanced t -> E s t <-> orbit s =i orbit t) ->
  (forall s t, t \in orbit s -> balanced s && q s -> balanced t && q t) ->
  N.of_nat (count (fun s => representative s && q s) balanced_list) = n ->
  classes E (fun s => balanced s /\ Q s) n.
Proof.
move=> qP Eo stable cn; exists [seq s <- balanced_list | representative s && q s].
have mem s : (s \in [seq s <- balanced_list | representative s && q s]) =
  [&& representative s, q s & balanced s].
  by rewrite mem_filter balanced_mem andbA.
split; first by rewrite size_filter.
- by rewrite filter_uniq ?balanced_uniq.
- by move=> s; rewrite mem => /and3P[_ h1 h2]; apply/qP; rewrite h1 h2.
- move=> s t; rewrite !mem => /and3P[/andP[s1 s2] _ bs] /and3P[/andP[t1 t2] _ bt] /(Eo _ _ bs bt) e.
  apply: lexge_anti.
  + by case/andP: bs => /eqP -> _; case/andP: bt => /eqP ->.
  + by apply: (allP s2); rewrite e.
  + by apply: (allP t2); rewrite -e.
- move=> s /qP bq; have bs : balanced s by case/andP: bq.
  have [r ro rm] := orbit_max s; have e := orbit_same ro.
  have /andP[br qr] := stable _ _ ro bq.
  exists r; last by apply/(Eo _ _ bs br) => t; rewrite e.
  rewrite mem br qr /representative e ro /= andbT.
  by apply/allP => t; rewrite e; exact: (allP rm).
Qed.
End Representatives.

(** ** Relabeling *)
Definition perms := Eval vm_compute in
  [seq [seq index_of (relabel_feature g (ft i)) | i <- iota 0 27] | g <- view_perms].
Lemma permsE : perms = [seq [seq index_of (relabel_feature g (ft i)) | i <- iota 0 27] | g <- view_perms].
Proof. vm_cast_no_check (erefl perms). Qed.

Definition act (s : seq nat) (pi : seq nat) := [seq nth 0 s j | j <- pi].
Definition label_orbit s := map (act s) perms.

Lemma relabelE s : [seq relabel g s | g <- view_perms] = label_orbit s.
Proof.
rewrite /label_orbit permsE -map_comp; apply: eq_map => g.
by rewrite /relabel /mkseq /comp /act -map_comp.
Qed.

Lemma label_equivE s t : label_equiv s t <-> t \in label_orbit s.
Proof. by rewrite /label_equiv relabelE. Qed.

Lemma perms_group : all (fun pi => perm_eq [seq act pi pi' | pi' <- perms] perms) perms.
Proof. by vm_compute. Qed.
Lemma perms_perm : all (fun pi => perm_eq pi (iota 0 27)) perms.
Proof. by vm_compute. Qed.
Lemma perms_id : head [::] perms = iota 0 27. Proof. by []. Qed.
Lemma perms_head : head [::] perms \in perms. Proof. exact: mem_head. Qed.

Definition merge (s : seq nat) := let x := nth 0 s in
  [:: x 0; x 1; x 2; x 3; x 4; x 5; x 6; x 7; x 8; x 9; x 10; x 11; x 12 + x 13; 0; x 14 + x 15; 0;
    x 16 + x 17; 0;
      x 18; x 19; x 20; x 21; x 22; x 23; x 24; x 25; x 26].
Definition merge_orbit s := [seq merge (act s pi) | pi <- perms].

Lemma merge_act s pi : pi \in perms -> merge (act (merge s) pi) = merge (act s pi).
Proof.
rewrite !inE => h; do 5?[case/orP: h => h]; move/eqP: h => ->; rewrite /act /merge /=;
  by rewrite ?addn0 ?add0n; do ?congr cons; rewrite // addnC.
Qed.

Local Opaque perms.

Lemma perm_bound pi j : pi \in perms -> j \in pi -> j < 27.
Proof. by move/(allP perms_perm)/perm_mem => -> ; rewrite mem_iota. Qed.
Lemma perm_size pi : pi \in perms -> size pi = 27.
Proof. by move/(allP perms_perm)/perm_size => ->. Qed.

Lemma act_act s pi pi' : pi \in perms -> pi' \in perms -> act (act s pi) pi' = act s (act pi pi').
Proof.
move=> p1 p2; rewrite /act -map_comp; apply/eq_in_map => j /(perm_bound p2) j27 /=.
by rewrite (nth_map 0) // perm_size.
Qed.

Lemma label_orbit_same s t : t \in label_orbit s -> label_orbit t =i label_orbit s.
Proof.
move=> /mapP[pi pin ->] u; rewrite /label_orbit.
have -> : map (act (act s pi)) perms = map (act s) [seq act pi pi' | pi' <- perms].
  by rewrite -map_comp; apply/eq_in_map => pi' p2; rewrite /= act_act.
by apply: perm_mem; apply: perm_map; exact: (allP perms_group).
Qed.

Lemma act_id s : size s = 27 -> act s (iota 0 27) = s.
Proof. by move=> ss; rewrite -{2}(mkseq_nth 0 s) ss. Qed.

Lemma label_orbit_self s : size s = 27 -> s \in label_orbit s.
Proof. by move=> ss; rewrite -{1}(act_id ss); apply: map_f; rewrite -perms_id; exact: perms_head. Qed.

Lemma label_orbit_size s t : t \in label_orbit s -> size t = 27.
Proof. by case/mapP => pi pin ->; rewrite size_map perm_size. Qed.

Lemma label_equiv_orbit s t : balanced s -> balanced t -> label_equiv s t <-> label_orbit s =i label_orbit t.
Proof.
move=> _ /andP[/eqP st _]; split=> [/label_equivE h u|h]; first exact: (esym (label_orbit_same h u)).
by apply/label_equivE; rewrite (h t) label_orbit_self.
Qed.

(** Totals are permuted along. *)
Lemma total_act s pi h h' : pi \in perms -> (forall i, i < 27 -> h i = h' (nth 0 pi i)) ->
  total (act s pi) h = total s h'.
Proof.
move=> pin e; rewrite /total.
have -> : [seq nth 0 (act s pi) i * h i | i <- iota 0 27] = [seq nth 0 s j * h' j | j <- pi].
  rewrite -{2}(mkseq_nth 0 pi) perm_size // /mkseq -map_comp; apply/eq_in_map => i;
    rewrite mem_iota => i27 /=.
  by rewrite e // (nth_map 0) // perm_size.
by apply: perm_sumn; apply: perm_map; exact: (allP perms_perm).
Qed.

(** ** Swaps *)
Definition mates := Eval vm_compute in [seq index_of (swap_feature (ft i)) | i <- iota 0 27].
Lemma matesE i : i < 27 -> index_of (swap_feature (ft i)) = nth 0 mates i.
Proof.
move=> i27; have -> : mates = [seq index_of (swap_feature (ft i)) | i <- iota 0 27] by vm_compute.
by rewrite (nth_map 0) ?size_iota // nth_iota.
Qed.


Lemma merge_orbit_merge s : merge_orbit (merge s) = merge_orbit s.
Proof. by apply/eq_in_map => pi; exact: merge_act. Qed.

Lemma merge_orbit_act s pi : pi \in perms -> merge_orbit (act s pi) =i merge_orbit s.
Proof.
move=> pin u; rewrite /merge_orbit.
have -> : [seq merge (act (act s pi) pi') | pi' <- perms] =
  map (merge \o act s) [seq act pi pi' | pi' <- perms].
  by rewrite -map_comp; apply/eq_in_map => pi' p2; rewrite /= act_act.
exact: (perm_mem (perm_map (merge \o act s) (allP perms_group _ pin)) u).
Qed.

Lemma merge_orbit_same s t : t \in merge_orbit s -> merge_orbit t =i merge_orbit s.
Proof.
case/mapP => pi pin -> u.
have -> : merge_orbit (merge (act s pi)) = merge_orbit (act s pi) := merge_orbit_merge (act s pi).
exact: (merge_orbit_act s pin u).
Qed.

Lemma merge_orbit_size s t : t \in merge_orbit s -> size t = 27.
Proof. by case/mapP => pi pin ->. Qed.

Lemma nth_swap i s k : i < 27 -> k < 27 -> nth 0 (swap i s) k = nth 0 s k - (k == i) + (k == nth 0 mates i).
Proof. by move=> i27 k27; rewrite /swap matesE // nth_mkseq. Qed.

Lemma merge_ext s t : (forall k, k < 27 -> nth 0 s k = nth 0 t k) -> merge s = merge t.
Proof. by move=> e; rewrite /merge !e. Qed.

Lemma mates_fixed i : i < 27 -> i \notin [:: 12; 13; 14; 15; 16; 17] -> nth 0 mates i = i.
Proof.
move=> i27 ni; have h : all (fun i => (i \notin [:: 12; 13; 14; 15; 16; 17]) ==> (nth 0 mates i == i))
  (iota 0 27) by [].
by have := allP h i; rewrite mem_iota i27 ni => /(_ isT) /eqP.
Qed.

Lemma merge_swap i s : i < 27 -> 0 < nth 0 s i -> merge (swap i s) = merge s.
Proof.
move=> i27; case: (boolP (i \in [:: 12; 13; 14; 15; 16; 17])) => [|ni pos]; last first.
  apply: merge_ext => k k27; rewrite nth_swap // mates_fixed //.
  by case: eqP => [->|_] /=; rewrite ?subn0 ?addn0 // subnK.
rewrite !inE /merge; do 5?[case/orP]; move/eqP=> e; move: i27; rewrite {}e => i27 pos;
  by rewrite !(nth_swap _ i27) //= ?subn0 ?addn0; do 27?[congr cons]; rewrite //; lia.
Qed.

Lemma swap_equiv_orbit s t : swap_equiv s t -> merge_orbit s =i merge_orbit t.
Proof.
elim=> {s t} [s t h|s i i27 pos|s t _ IH|s t u _ IH1 _ IH2] w.
- by case/mapP: (proj1 (label_equivE s t) h) => pi pin ->; exact: (esym (merge_orbit_act s pin w)).
- have e : merge_orbit (swap i s) = merge_orbit s.
    transitivity (merge_orbit (merge (swap i s))); first exact: (esym (merge_orbit_merge (swap i s))).
    by rewrite (merge_swap i27 pos); exact: merge_orbit_merge.
  by rewrite e.
- exact: (esym (IH w)).
- exact: (etrans (IH1 w) (IH2 w)).
Qed.

(** Conversely, swaps merge: move the copies of b to its mate a one by one. *)
Definition collect a b (s : seq nat) :=
  [seq if k == a then nth 0 s a + nth 0 s b else if k == b then 0 else nth 0 s k | k <- iota 0 27].

Lemma swap_equiv_refl s : size s = 27 -> swap_equiv s s.
Proof. by move=> ss; apply/sw_label/label_equivE/label_orbit_self. Qed.

Lemma collect_equiv a b s : a < 27 -> b < 27 -> a != b -> nth 0 mates b = a -> size s = 27 ->
  swap_equiv s (collect a b s).
Proof.
move=> a27 b27 ab ba; move e: (nth 0 s b) => n; elim: n s e => [|n IH] s e ss.
  have -> : collect a b s = s; last exact: swap_equiv_refl.
  rewrite -{2}(mkseq_nth 0 s) ss; apply/eq_in_map => k _.
  by case: eqP => [->|_]; [rewrite e addn0 | case: eqP => [->|]].
have pos : 0 < nth 0 s b by rewrite e.
apply: (@sw_trans _ _ _ (@sw_swap s b b27 pos)).
have -> : collect a b s = collect a b (swap b s).
  apply/eq_in_map => k; rewrite mem_iota => k27.
  rewrite !nth_swap // ba !eqxx [b == a]eq_sym (negbTE ab).
  case: eqP => [_|/eqP ka]; first by rewrite e; lia.
  by case: eqP => [//|/eqP kb]; rewrite subn0 addn0.
apply: IH; last by rewrite size_mkseq.
by rewrite nth_swap // ba eqxx [b == a]eq_sym (negbTE ab) e subn1 addn0.
Qed.

Lemma merge_equiv s : size s = 27 -> swap_equiv s (merge s).
Proof.
move=> ss.
have h12 : swap_equiv s (collect 12 13 s) by apply: collect_equiv.
have h14 : swap_equiv (collect 12 13 s) (collect 14 15 (collect 12 13 s)) by apply: collect_equiv.
have h16 u : size u = 27 -> swap_equiv u (collect 16 17 u) by move=> su; apply: collect_equiv.
have h := @sw_trans _ _ _ h12 (@sw_trans _ _ _ h14 (h16 (collect 14 15 (collect 12 13 s)) erefl)).
by have -> : merge s = collect 16 17 (collect 14 15 (collect 12 13 s)) by [].
Qed.

Lemma swap_equivE s t : balanced s -> balanced t -> swap_equiv s t <-> merge_orbit s =i merge_orbit t.
Proof.
move=> /andP[/eqP ss _] /andP[/eqP st _]; split; first exact: swap_equiv_orbit.
move=> e; have : merge t \in merge_orbit s.
  rewrite (e _) /merge_orbit -{1}(act_id st); apply: (map_f (fun pi => merge (act t pi))); rewrite -perms_id;
    exact: perms_head.
case/mapP => pi pin et.
have h1 : swap_equiv s (act s pi) by apply: sw_label; apply/label_equivE; exact: map_f.
have h2 : swap_equiv (act s pi) (merge (act s pi)) by apply: merge_equiv; rewrite size_map perm_size.
have h3 : swap_equiv (merge (act s pi)) t by rewrite -et; apply: sw_sym; exact: merge_equiv.
exact: (@sw_trans _ _ _ h1 (@sw_trans _ _ _ h2 h3)).
Qed.

(** ** Totals under merging *)
Lemma total_merge s h : h 12 = h 13 -> h 14 = h 15 -> h 16 = h 17 -> total (merge s) h = total s h.
Proof. by move=> h1 h2 h3; rewrite /total /merge /= h1 h2 h3; lia. Qed.
