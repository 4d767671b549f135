(** * The stated predicates as totals with fixed coefficients, which are quick to compute

    The two walks (Tree.v, Census.v) judge signatures by them; here they are proved to be those of
    Statement.v. *)
From Coq Require Import NArith.
From mathcomp Require Import all_ssreflect.
From PL1P Require Import Statement Rigid Walk.
Set Implicit Arguments.
Unset Strict Implicit.
Unset Printing Implicit Defensive.

(** ** Totals with fixed coefficients *)
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
  [seq coefs (fun i => sees_point (ft i) uv.1 && sees_point (ft i) uv.2 : nat) | uv <- [:: (V1, V2); (V1, V3);
    (V2, V3)]].
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

Lemma total_pos s (q : nat -> bool) : (0 < total s (fun i => q i)) =
  has (fun i => (0 < nth 0 s i) && q i) (iota 0 27).
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
  rewrite (_ : c_shared = [seq coefs (fun i => sees_point (ft i) uv.1 && sees_point (ft i) uv.2 : nat) | uv <-
    [:: (V1, V2); (V1, V3); (V2, V3)]]); last by vm_compute.
  by rewrite has_map; apply: eq_has => uv /=; rewrite totE.
have e2 : has (fun v => shown s v == 1) views = has (fun c => tot s c == 1) c_shown.
  rewrite (_ : c_shown = [seq coefs (fun i => sees_point (ft i) v || (0 < size (sees_pins (ft i) v)) : nat) |
    v <- views]); last by vm_compute.
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
have st : (0 < star) = has (fun i => (0 < nth 0 s i) && (3 <= pins (ft i))) (iota 0 27)
  by rewrite /star total_pos.
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
rewrite /five_by (_ : c_shared =
  [seq coefs (fun i => sees_point (ft i) uv.1 && sees_point (ft i) uv.2 : nat) | uv <- [:: (V1, V2); (V1, V3);
    (V2, V3)]]); last by vm_compute.
rewrite has_map /= !totE orbF; apply: (iffP or3P) => [[/eqP h|/eqP h|/eqP h]|[h|h|h]];
  by [constructor 1 | constructor 2 | constructor 3 | constructor 1; apply/eqP | constructor 2;
    apply/eqP | constructor 3; apply/eqP].
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

(** ** Evaluated quickly, they are the same *)
Definition singles := [:: c_weight; c_star; c_seven; c_six; c_free; c_more0; c_more1].
Lemma in_cat3 (A : eqType) (x : A) (l m n : seq A) : [|| x \in l, x \in m | x \in n] -> x \in l ++ m ++ n.
Proof. by rewrite !mem_cat. Qed.
Section Fast.
Variable s : signature.
Hypothesis bs : balanced s.
Lemma fast_tot c : c \in c_shared ++ c_shown ++ singles -> dotn s c = tot s c.
Proof.
move=> cin; rewrite tot_dotn //; first by case/andP: bs => /eqP.
have h : all (fun c => size c == 27) (c_shared ++ c_shown ++ singles) by vm_compute.
exact: (eqP (allP h c cin)).
Qed.
Let shared_in c (h : c \in c_shared) : dotn s c = tot s c.
Proof. by apply: fast_tot; apply: in_cat3; apply/or3P; constructor 1; exact: h. Qed.
Let shown_in c (h : c \in c_shown) : dotn s c = tot s c.
Proof. by apply: fast_tot; apply: in_cat3; apply/or3P; constructor 2; exact: h. Qed.
Let single_in c (h : c \in singles) : dotn s c = tot s c.
Proof. by apply: fast_tot; apply: in_cat3; apply/or3P; constructor 3; exact: h. Qed.

Lemma obstructed_fast : obstructed_by dotn s = obstructed s.
Proof.
rewrite obstructedE /obstructed_by.
rewrite (eq_in_has (a2 := fun c => 5 < tot s c)); last by move=> c cin /=; rewrite shared_in.
rewrite (eq_in_has (a1 := fun c => dotn s c == 1) (a2 := fun c => tot s c == 1)); last by move=> c cin /=;
  rewrite shown_in.
by rewrite (@single_in c_star) // (@single_in c_seven) // (@single_in c_six) // (@single_in c_free).
Qed.
Lemma pl0p_fast : pl0p_by dotn s = pl0p_by tot s. Proof. by rewrite /pl0p_by single_in. Qed.
Lemma one_pin_fast : one_pin_by dotn s = one_pin_by tot s. Proof. by rewrite /one_pin_by single_in. Qed.
Lemma five_fast : five_by dotn s = five_by tot s.
Proof. by rewrite /five_by; apply: eq_in_has => c cin /=; rewrite shared_in. Qed.
End Fast.
