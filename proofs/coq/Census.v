(** * The census: all counts of the claim in one walk over the balanced signatures *)
From Coq Require Import NArith.
From mathcomp Require Import all_ssreflect.
From mathcomp.zify Require Import zify.
From PL1P Require Import Statement Walk Orbits.
Set Implicit Arguments.
Unset Strict Implicit.
Unset Printing Implicit Defensive.

(** ** The predicates as totals with fixed coefficients *)
Definition tot (s c : seq nat) := total s (nth 0 c).
Lemma totE s h : tot s (coefs h) = total s h.
Proof.
rewrite /tot /total; apply: (congr1 sumn); apply/eq_in_map => i; rewrite mem_iota => i27.
by rewrite (nth_map 0) ?size_iota // nth_iota.
Qed.
Lemma tot_dotn s c : size s = 27 -> size c = 27 -> tot s c = dotn s c.
Proof. by move=> ss sc; rewrite /tot totalE // /coefs -{2}(mkseq_nth 0 c) sc. Qed.

Definition c_weight := Eval vm_compute in coefs weight.
Definition c_shared := Eval vm_compute in
  [seq coefs (fun i => sees_point (ft i) uv.1 && sees_point (ft i) uv.2 : nat) | uv <- [:: (V1, V2); (V1, V3); (V2, V3)]].
Definition c_shown := Eval vm_compute in
  [seq coefs (fun i => sees_point (ft i) v || (0 < size (sees_pins (ft i) v)) : nat) | v <- views].
Definition c_of (c : feature -> bool) := coefs (fun i => c (ft i) : nat).
Definition c_star := Eval vm_compute in c_of (fun f => 3 <= pins f).
Definition c_seven := Eval vm_compute in c_of (fun f => pins f == 7).
Definition c_six := Eval vm_compute in c_of (fun f => pins f == 6).
Definition c_free := Eval vm_compute in c_of free.
Definition c_more0 := Eval vm_compute in c_of (fun f => ~~ ((pins f == 0) || free f)).
Definition c_more1 := Eval vm_compute in c_of (fun f => ~~ (pins f <= 1)).

(** Any evaluation ev of totals gives the predicates; ev = tot is exact, ev = dotn is fast. *)
Section Predicates.
Variable ev : seq nat -> seq nat -> nat.
Variable s : seq nat.
Definition obstructed_by := 
  if has (fun c => 5 < ev s c) c_shared then true
  else if ev s c_star is 0 then false
  else if 0 < ev s c_seven then true
  else if (if 0 < ev s c_six then 0 < ev s c_free else false) then true
  else has (fun c => ev s c == 1) c_shown.
Definition pl0p_by := ev s c_more0 == 0.
Definition one_pin_by := ev s c_more1 == 0.
Definition five_by := has (fun c => ev s c == 5) c_shared.
End Predicates.

Lemma total_pos s (q : nat -> bool) : (0 < total s (fun i => q i)) = has (fun i => (0 < nth 0 s i) && q i) (iota 0 27).
Proof.
rewrite /total; elim: (iota 0 27) => //= i l IH; rewrite addn_gt0 IH muln_gt0; congr (_ && _ || _).
by case: (q i).
Qed.

Lemma only_total c s : reflect (only c s) (total s (fun i => ~~ c (ft i)) == 0).
Proof.
rewrite -leqn0 leqNgt total_pos; apply: (iffP hasPn) => h i.
  by move=> i27 pos; have := h i; rewrite mem_iota => /(_ i27); rewrite pos negbK.
by rewrite mem_iota => i27; apply/negP => /andP[pos]; rewrite h.
Qed.

Lemma obstructedE s : obstructed s = obstructed_by tot s.
Proof.
have e1 : crowded s = has (fun c => 5 < tot s c) c_shared.
  rewrite (_ : c_shared = [seq coefs (fun i => sees_point (ft i) uv.1 && sees_point (ft i) uv.2 : nat) | uv <- [:: (V1, V2); (V1, V3); (V2, V3)]]); last by vm_compute.
  by rewrite has_map; apply: eq_has => uv /=; rewrite totE.
have e2 : has (fun v => shown s v == 1) views = has (fun c => tot s c == 1) c_shown.
  rewrite (_ : c_shown = [seq coefs (fun i => sees_point (ft i) v || (0 < size (sees_pins (ft i) v)) : nat) | v <- views]); last by vm_compute.
  by rewrite has_map; apply: eq_has => v /=; rewrite totE.
have e3 (c : feature -> bool) : tot s (c_of c) = total s (fun i => c (ft i)) by rewrite /c_of totE.
rewrite /obstructed /obstructed_by -e1 -e2; case: (crowded s); first by [].
rewrite orFb /sliding; set G := has _ views; move: G => G {e1 e2}.
rewrite (_ : c_star = c_of (fun f => 3 <= pins f)); last by vm_compute.
rewrite (_ : c_seven = c_of (fun f => pins f == 7)); last by vm_compute.
rewrite (_ : c_six = c_of (fun f => pins f == 6)); last by vm_compute.
rewrite (_ : c_free = c_of free); last by vm_compute.
rewrite !e3; set F := 0 < total s (fun i => free (ft i)); move: F => F.
rewrite !total_pos.
set star := total s (fun i => 3 <= pins (ft i)).
have st : (0 < star) = has (fun i => (0 < nth 0 s i) && (3 <= pins (ft i))) (iota 0 27) by rewrite /star total_pos.
transitivity ((0 < star) && [|| has (fun i => (0 < nth 0 s i) && (pins (ft i) == 7)) (iota 0 27),
   has (fun i => (0 < nth 0 s i) && (pins (ft i) == 6)) (iota 0 27) && F | G]); last first.
  by case: star {st} => //= _; do 2?case: ifP => //=.
rewrite st; apply/hasP/andP.
  case=> i i27 /and3P[h1 h2 h3]; split; first by apply/hasP; exists i; rewrite ?h1.
  case/or3P: h3 => [h|/andP[h ->]|->]; last by rewrite !orbT.
    by apply/orP; left; apply/hasP; exists i; rewrite ?h1.
  by apply/orP; right; apply/orP; left; rewrite andbT; apply/hasP; exists i; rewrite ?h1.
case=> /hasP[i i27 /andP[h1 h2]] /or3P[/hasP[j j27 /andP[h3 h4]]|/andP[/hasP[j j27 /andP[h3 h4]] hF]|hG].
- by exists j => //; rewrite h3 h4 (eqP h4).
- by exists j => //; rewrite h3 h4 (eqP h4) hF orbT.
- by exists i => //; rewrite h1 h2 hG !orbT.
Qed.

Lemma five_byE s : reflect [\/ shared s V1 V2 = 5, shared s V1 V3 = 5 | shared s V2 V3 = 5] (five_by tot s).
Proof.
rewrite /five_by (_ : c_shared = [seq coefs (fun i => sees_point (ft i) uv.1 && sees_point (ft i) uv.2 : nat) | uv <- [:: (V1, V2); (V1, V3); (V2, V3)]]); last by vm_compute.
rewrite has_map /= !totE orbF; apply: (iffP or3P) => [[/eqP h|/eqP h|/eqP h]|[h|h|h]];
  by [constructor 1 | constructor 2 | constructor 3 | constructor 1; apply/eqP | constructor 2; apply/eqP | constructor 3; apply/eqP].
Qed.

Lemma pl0p_byE s : reflect (only (fun f => (pins f == 0) || free f) s) (pl0p_by tot s).
Proof.
rewrite /pl0p_by (_ : c_more0 = c_of (fun f => ~~ ((pins f == 0) || free f))); last by vm_compute.
by rewrite /c_of totE; exact: only_total.
Qed.
Lemma one_pin_byE s : reflect (only (fun f => pins f <= 1) s) (one_pin_by tot s).
Proof.
rewrite /one_pin_by (_ : c_more1 = c_of (fun f => ~~ (pins f <= 1))); last by vm_compute.
by rewrite /c_of totE; exact: only_total.
Qed.

(** ** They are constant on classes *)
Definition closed (cs : seq (seq nat)) := all (fun pi => perm_eq [seq act c pi | c <- cs] cs) perms.
Lemma closed_shared : closed c_shared. Proof. by vm_compute. Qed.
Lemma closed_shown : closed c_shown. Proof. by vm_compute. Qed.
Definition singles := [:: c_weight; c_star; c_seven; c_six; c_free; c_more0; c_more1].
Lemma closed_singles : all (fun c => all (fun pi => act c pi == c) perms) singles. Proof. by vm_compute. Qed.
Definition mergeable c := [&& nth 0 c 12 == nth 0 c 13, nth 0 c 14 == nth 0 c 15 & nth 0 c 16 == nth 0 c 17].
Lemma all_mergeable : all mergeable (c_shared ++ c_shown ++ singles). Proof. by vm_compute. Qed.

Lemma tot_act s pi c : pi \in perms -> tot (act s pi) (act c pi) = tot s c.
Proof. by move=> pin; apply: total_act => // i i27; rewrite /act (nth_map 0) // perm_size. Qed.
Lemma tot_act_single s pi c : pi \in perms -> c \in singles -> tot (act s pi) c = tot s c.
Proof.
by move=> pin cin; rewrite -[RHS](tot_act s c pin); have /allP/(_ _ pin)/eqP -> := allP closed_singles c cin.
Qed.
Lemma has_act s pi cs (q : nat -> bool) : pi \in perms -> closed cs -> has (fun c => q (tot (act s pi) c)) cs = has (fun c => q (tot s c)) cs.
Proof.
move=> pin /allP/(_ _ pin) cl; rewrite -(perm_has _ cl) has_map; apply: eq_has => c /=.
by rewrite tot_act.
Qed.
Lemma tot_merge s c : c \in c_shared ++ c_shown ++ singles -> tot (merge s) c = tot s c.
Proof. by move=> cin; have /and3P[/eqP h1 /eqP h2 /eqP h3] := allP all_mergeable c cin; exact: total_merge. Qed.

(** The four predicates, and the weight, survive relabeling and merging. *)
Definition portrait s := (tot s c_weight, obstructed_by tot s, (pl0p_by tot s, one_pin_by tot s), five_by tot s).
Lemma portrait_act s pi : pi \in perms -> portrait (act s pi) = portrait s.
Proof.
move=> pin; rewrite /portrait /obstructed_by /pl0p_by /one_pin_by /five_by.
rewrite (has_act s (fun n => 5 < n) pin closed_shared) (has_act s (fun n => n == 5) pin closed_shared) (has_act s (fun n => n == 1) pin closed_shown).
by do ![rewrite (tot_act_single s pin) //].
Qed.
Lemma in_cat3 (A : eqType) (x : A) (l m n : seq A) : [|| x \in l, x \in m | x \in n] -> x \in l ++ m ++ n.
Proof. by rewrite !mem_cat. Qed.

Lemma portrait_merge s : portrait (merge s) = portrait s.
Proof.
have e1 : has (fun c => 5 < tot (merge s) c) c_shared = has (fun c => 5 < tot s c) c_shared.
  by apply: eq_in_has => c cin; rewrite tot_merge //; apply: in_cat3; apply/or3P; constructor 1; exact: cin.
have e2 : has (fun c => tot (merge s) c == 5) c_shared = has (fun c => tot s c == 5) c_shared.
  by apply: eq_in_has => c cin; rewrite tot_merge //; apply: in_cat3; apply/or3P; constructor 1; exact: cin.
have e3 : has (fun c => tot (merge s) c == 1) c_shown = has (fun c => tot s c == 1) c_shown.
  by apply: eq_in_has => c cin; rewrite tot_merge //; apply: in_cat3; apply/or3P; constructor 2; exact: cin.
have es c : c \in singles -> tot (merge s) c = tot s c by move=> cin; rewrite tot_merge //; apply: in_cat3; apply/or3P; constructor 3; exact: cin.
rewrite /portrait /obstructed_by /pl0p_by /one_pin_by /five_by e1 e2 e3.
by rewrite (es c_weight) // (es c_star) // (es c_seven) // (es c_six) // (es c_free) // (es c_more0) // (es c_more1).
Qed.

Lemma portrait_label s t : t \in label_orbit s -> portrait t = portrait s.
Proof. by case/mapP => pi pin ->; exact: portrait_act. Qed.
Lemma portrait_swap s t : t \in merge_orbit s -> portrait t = portrait s.
Proof. by case/mapP => pi pin ->; rewrite portrait_merge portrait_act. Qed.

Lemma balancedE s : balanced s = (size s == 27) && (tot s c_weight == 11).
Proof. by rewrite /balanced -totE. Qed.

(** ** The walk *)
Fixpoint all_lazy (A : Type) (q : A -> bool) (l : seq A) := if l is a :: l' then if q a then all_lazy q l' else false else true.
Lemma all_lazyE A (q : A -> bool) l : all_lazy q l = all q l.
Proof. by elim: l => //= a l ->. Qed.

Definition label_top s := all_lazy (fun pi => lexge s (act s pi)) perms.
Definition swap_top s := if nth 0 s 13 + nth 0 s 15 + nth 0 s 17 is 0 then all_lazy (fun pi => lexge s (merge (act s pi))) perms else false.

Lemma label_topE s : size s = 27 -> label_top s = representative label_orbit s.
Proof. by move=> ss; rewrite /representative label_orbit_self // /label_top all_lazyE /label_orbit all_map. Qed.
Lemma swap_topE s : size s = 27 -> swap_top s = representative merge_orbit s.
Proof.
move=> ss; rewrite /swap_top /representative all_lazyE /merge_orbit all_map.
have -> : (s \in [seq merge (act s pi) | pi <- perms]) = (nth 0 s 13 + nth 0 s 15 + nth 0 s 17 == 0).
  apply/mapP/eqP => [[pi _ ->] //|z].
  have [z1 [z2 z3]] : nth 0 s 13 = 0 /\ nth 0 s 15 = 0 /\ nth 0 s 17 = 0 by lia.
  exists (iota 0 27) => //; rewrite act_id // -{1}(mkseq_nth 0 s) ss /merge z1 z2 z3 !addn0.
  by rewrite /mkseq /= z1 z2 z3.
by case: (_ + _).
Qed.

Definition flags s : seq bool :=
  let l := label_top s in let w := swap_top s in
  if l || w then
    let b := obstructed_by dotn s in let g := ~~ b in let f := five_by dotn s in
    [:: l; w; l && g; l && b; w && g; w && b; l && g && pl0p_by dotn s; w && g && one_pin_by dotn s; l && g && f; w && g && f]
  else nseq 10 false.

Definition census := walk (fun _ _ st => st) (fun pre (_ : unit) acc => bump (flags (rev pre)) acc) ws 0 11 tt [::] (nseq 10 N0).
Definition counts : seq N := [:: 143494; 76446; 140616; 2878; 74575; 1871; 51; 9533; 6413; 3615]%num.

Lemma censusE : census = counts.
Proof. vm_cast_no_check (erefl counts). Qed.
