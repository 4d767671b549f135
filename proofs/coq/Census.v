(** * The census: all counts of the claim in one walk over the balanced signatures *)
From Coq Require Import NArith.
From mathcomp Require Import all_ssreflect.
From mathcomp.zify Require Import zify.
From PL1P Require Import Statement Rigid Walk Predicates Orbits.
Set Implicit Arguments.
Unset Strict Implicit.
Unset Printing Implicit Defensive.

(** ** They are constant on classes *)
Definition closed (cs : seq (seq nat)) := all (fun pi => perm_eq [seq act c pi | c <- cs] cs) perms.
Lemma closed_shared : closed c_shared. Proof. by vm_compute. Qed.
Lemma closed_shown : closed c_shown. Proof. by vm_compute. Qed.
Lemma closed_singles : all (fun c => all (fun pi => act c pi == c) perms) singles. Proof. by vm_compute. Qed.
Definition mergeable c := [&& nth 0 c 12 == nth 0 c 13, nth 0 c 14 == nth 0 c 15 & nth 0 c 16 == nth 0 c 17].
Lemma all_mergeable : all mergeable (c_shared ++ c_shown ++ singles). Proof. by vm_compute. Qed.

Lemma tot_act s pi c : pi \in perms -> tot (act s pi) (act c pi) = tot s c.
Proof. by move=> pin; apply: total_act => // i i27; rewrite /act (nth_map 0) // perm_size. Qed.
Lemma tot_act_single s pi c : pi \in perms -> c \in singles -> tot (act s pi) c = tot s c.
Proof.
by move=> pin cin; rewrite -[RHS](tot_act s c pin); have /allP/(_ _ pin)/eqP -> := allP closed_singles c cin.
Qed.
Lemma has_act s pi cs (q : nat -> bool) : pi \in perms -> closed cs ->
  has (fun c => q (tot (act s pi) c)) cs = has (fun c => q (tot s c)) cs.
Proof.
move=> pin /allP/(_ _ pin) cl; rewrite -(perm_has _ cl) has_map; apply: eq_has => c /=.
by rewrite tot_act.
Qed.
Lemma tot_merge s c : c \in c_shared ++ c_shown ++ singles -> tot (merge s) c = tot s c.
Proof. by move=> cin; have /and3P[/eqP h1 /eqP h2 /eqP h3] := allP all_mergeable c cin;
  exact: total_merge. Qed.

(** The four predicates, and the weight, survive relabeling and merging. *)
Definition portrait s := (tot s c_weight, obstructed_by tot s, (pl0p_by tot s, one_pin_by tot s),
  five_by tot s).
Lemma portrait_act s pi : pi \in perms -> portrait (act s pi) = portrait s.
Proof.
move=> pin; rewrite /portrait /obstructed_by /pl0p_by /one_pin_by /five_by.
rewrite (has_act s (fun n => 5 < n) pin closed_shared) (has_act s (fun n => n == 5) pin closed_shared)
  (has_act s (fun n => n == 1) pin closed_shown).
by do ![rewrite (tot_act_single s pin) //].
Qed.
Lemma portrait_merge s : portrait (merge s) = portrait s.
Proof.
have e1 : has (fun c => 5 < tot (merge s) c) c_shared = has (fun c => 5 < tot s c) c_shared.
  by apply: eq_in_has => c cin; rewrite tot_merge //; apply: in_cat3; apply/or3P; constructor 1; exact: cin.
have e2 : has (fun c => tot (merge s) c == 5) c_shared = has (fun c => tot s c == 5) c_shared.
  by apply: eq_in_has => c cin; rewrite tot_merge //; apply: in_cat3; apply/or3P; constructor 1; exact: cin.
have e3 : has (fun c => tot (merge s) c == 1) c_shown = has (fun c => tot s c == 1) c_shown.
  by apply: eq_in_has => c cin; rewrite tot_merge //; apply: in_cat3; apply/or3P; constructor 2; exact: cin.
have es c : c \in singles -> tot (merge s) c = tot s c by move=> cin; rewrite tot_merge //; apply: in_cat3;
  apply/or3P; constructor 3; exact: cin.
rewrite /portrait /obstructed_by /pl0p_by /one_pin_by /five_by e1 e2 e3.
by rewrite (es c_weight) // (es c_star) // (es c_seven) // (es c_six) // (es c_free) // (es c_more0) //
  (es c_more1).
Qed.

Lemma portrait_label s t : t \in label_orbit s -> portrait t = portrait s.
Proof. by case/mapP => pi pin ->; exact: portrait_act. Qed.
Lemma portrait_swap s t : t \in merge_orbit s -> portrait t = portrait s.
Proof. by case/mapP => pi pin ->; rewrite portrait_merge portrait_act. Qed.

Lemma balancedE s : balanced s = (size s == 27) && (tot s c_weight == 11).
Proof. by rewrite /balanced -totE. Qed.

(** ** The walk *)
Fixpoint all_lazy (A : Type) (q : A -> bool) (l : seq A) := if l is a :: l' then if q a then all_lazy q l'
  else false else true.
Lemma all_lazyE A (q : A -> bool) l : all_lazy q l = all q l.
Proof. by elim: l => //= a l ->. Qed.

(** [beats s pi] is [lexge s (act s pi)], but computes no more of [act s pi] than it compares, and
    does not compare the first eight entries, which no relabeling moves. *)
Fixpoint beats_from (s t pi : seq nat) : bool :=
  match t, pi with
  | x :: t', j :: pi' => let y := nth 0 s j in if y < x then true else if x < y then false
    else beats_from s t' pi'
  | _, _ => true
  end.
Definition beats s pi := beats_from s (drop 8 s) (drop 8 pi).
Lemma beatsE s pi : 8 <= size s -> take 8 pi = iota 0 8 -> beats s pi = lexge s (act s pi).
Proof.
have h t pi' : beats_from s t pi' = lexge t (act s pi') by elim: t pi' => [|x t IH] [|j pi'] //=; rewrite IH.
rewrite /beats h => sz e; rewrite -{2}(cat_take_drop 8 pi) e; move: (drop 8 pi) => pi' {h}.
rewrite /act map_cat; move: [seq _ | j <- pi'] => u.
have -> : [seq nth 0 s j | j <- iota 0 8] = take 8 s by rewrite map_nth_iota0.
rewrite -{2}(cat_take_drop 8 s); move: (take 8 s) (drop 8 s) => a b.
by elim: a => //= x a ->; rewrite ltnn.
Qed.

(** The relabelings other than the identity; and how they act where 13, 15, 17 are empty, followed
    by [merge]. *)
Definition others := Eval vm_compute in behead perms.
Definition merged (pi : seq nat) :=
  [seq if k \in [:: 12; 14; 16] then (nth 0 pi k)./2.*2 else if k \in [:: 13; 15; 17] then 13
    else nth 0 pi k | k <- iota 0 27].
Definition others_merged := Eval vm_compute in map merged others.
Lemma perms_cons : perms = iota 0 27 :: others. Proof. by []. Qed.

Definition no_mates s := nth 0 s 13 + nth 0 s 15 + nth 0 s 17 == 0.
Lemma act_merged s pi : no_mates s -> pi \in others -> act s (merged pi) = merge (act s pi).
Proof.
rewrite /no_mates !addn_eq0 => /andP[/andP[/eqP z13 /eqP z15] /eqP z17].
rewrite !inE => h; do 4?[case/orP: h => h]; move/eqP: h => ->; rewrite /act /merge /merged /=;
  by rewrite ?z13 ?z15 ?z17 ?addn0 ?add0n.
Qed.
Lemma merge_fixed s : size s = 27 -> no_mates s -> merge s = s.
Proof.
move=> ss; rewrite /no_mates !addn_eq0 => /andP[/andP[/eqP z1 /eqP z2] /eqP z3].
by rewrite -{2}(mkseq_nth 0 s) ss /merge z1 z2 z3 !addn0 /mkseq /= z1 z2 z3.
Qed.

Lemma others_keep pi : pi \in others -> take 8 pi = iota 0 8.
Proof. by have /allP h : all (fun pi => take 8 pi == iota 0 8) others by []; move/h/eqP. Qed.
Lemma merged_keep pi : pi \in others -> take 8 (merged pi) = iota 0 8.
Proof. by have /allP h : all (fun pi => take 8 (merged pi) == iota 0 8) others by []; move/h/eqP. Qed.

Definition label_top s := all_lazy (beats s) others.
Definition swap_top s := if nth 0 s 13 + nth 0 s 15 + nth 0 s 17 is 0 then all_lazy (beats s) others_merged
  else false.

Lemma label_topE s : size s = 27 -> label_top s = representative label_orbit s.
Proof.
move=> ss; rewrite /representative label_orbit_self // /label_top all_lazyE /label_orbit perms_cons.
rewrite -[all (lexge s) _]/(lexge s (act s (iota 0 27)) && all (lexge s) (map (act s) others)) act_id //
  lexge_refl all_map.
by apply: eq_in_all => pi /others_keep keep; rewrite beatsE ?ss.
Qed.
Lemma swap_topE s : size s = 27 -> swap_top s = representative merge_orbit s.
Proof.
move=> ss; have -> : swap_top s = no_mates s && all (beats s) others_merged.
  by rewrite /swap_top /no_mates all_lazyE; case: (_ + _).
rewrite /representative.
have -> : (s \in merge_orbit s) = no_mates s.
  apply/mapP/idP => [[pi _ ->] //|z].
  by exists (iota 0 27); rewrite ?perms_cons ?mem_head // act_id // merge_fixed.
case z : (no_mates s); last by [].
rewrite 2!andTb /merge_orbit perms_cons.
rewrite -[all (lexge s) _]/(lexge s (merge (act s (iota 0 27))) &&
  all (lexge s) [seq merge (act s pi) | pi <- others]).
rewrite act_id // merge_fixed // lexge_refl (_ : others_merged = map merged others) // !all_map.
apply: eq_in_all => pi pin; have keep := merged_keep pin.
by rewrite -[preim _ _ pi]/(beats s (merged pi)) beatsE ?act_merged ?ss.
Qed.

(** The largest of the swap&label class is the largest of its label class. *)
Lemma lexge_pair x y u v : lexge u v -> lexge [:: x + y, 0 & u] [:: x, y & v].
Proof. by case: y => [|y] h; rewrite !lexge_cons ?addn0 ?eqxx ?h ?orbT // -[X in X < _]addn0 ltn_add2l. Qed.
Lemma lexge_merge t : size t = 27 -> lexge (merge t) t.
Proof.
move=> st; have [x ->] : exists x, t = mkseq x 27 by exists (nth 0 t); rewrite -st mkseq_nth.
have keep p u v : lexge u v -> lexge (p ++ u) (p ++ v) by elim: p => //= y p IH /IH; rewrite ltnn.
have h := lexge_pair _ _ (lexge_pair _ _ (lexge_pair _ _ (lexge_refl (map x (iota 18 9))))).
exact: (keep (map x (iota 0 12)) _ _ (h (x 12) (x 13) (x 14) (x 15) (x 16) (x 17))).
Qed.
Lemma swap_label_top s : size s = 27 -> swap_top s -> label_top s.
Proof.
move=> ss; rewrite (swap_topE ss) (label_topE ss) => /andP[_ /allP h].
apply/andP; split; first exact: label_orbit_self.
apply/allP => _ /mapP[pi pin ->]; have st : size (act s pi) = 27 by rewrite size_map perm_size.
apply: (@lexge_trans (merge (act s pi))); first by rewrite ss.
- by rewrite st.
- by apply: h; exact: (map_f (fun pi => merge (act s pi))).
- exact: lexge_merge.
Qed.

Definition flags s : seq bool :=
  let l := label_top s in let w := if l then swap_top s else false in
  if l then
    let b := obstructed_by dotn s in let g := ~~ b in let f := five_by dotn s in
    [:: l; w; l && g; l && b; w && g; w && b; l && g && pl0p_by dotn s; w && g && one_pin_by dotn s;
      l && g && f; w && g && f]
  else nseq 10 false.

Definition census := walk (fun _ _ st => st) (fun pre (_ : unit) acc => bump (flags (rev pre)) acc) ws 0 11 tt
  [::] (nseq 10 N0).
Definition counts : seq N := [:: 143494; 76446; 140616; 2878; 74575; 1871; 51; 9533; 6413; 3615]%num.

Lemma censusE : census = counts.
Proof. vm_cast_no_check (erefl counts). Qed.
