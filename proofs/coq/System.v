(** * A homogeneous linear system with more unknowns than equations has a nonzero solution

    over any integral domain, and the same for systems assembled from one block for each placed
    feature. Unknowns are functions nat -> R of which a form reads the first n; a block's forms read
    global unknowns z and its own y. *)
From Coq Require List.
From mathcomp Require Import all_ssreflect all_algebra.
From PL1P Require Import Statement Rigid.
Set Implicit Arguments.
Unset Strict Implicit.
Unset Printing Implicit Defensive.
Import GRing.Theory.
Local Open Scope ring_scope.

Section System.
Variable R : idomainType.
Implicit Types (x y z : nat -> R).
Notation Forall := List.Forall.
Notation Vec := (@Vec R).

Definition sum n (c x : nat -> R) := \sum_(i < n) c i * x i.
Definition lin n (f : (nat -> R) -> R) := exists c, forall x, f x = sum n c x.

Lemma Forall_nth A (Q : A -> Prop) d (l : seq A) : (forall k, (k < size l)%N -> Q (nth d l k)) -> Forall Q l.
Proof.
elim: l => [|a l IH] h; first by constructor.
constructor; first exact: (h 0%N).
by apply: IH => k kl; apply: (h k.+1).
Qed.

Lemma more_unknowns n (fs : seq ((nat -> R) -> R)) : (size fs < n)%N -> Forall (lin n) fs ->
  exists2 x, exists2 i, (i < n)%N & x i != 0 & Forall (fun f => f x = 0) fs.
Proof.
move=> lt fl.
have [cs sc ce] : exists2 cs : seq (nat -> R), size cs = size fs &
    forall k x, (k < size fs)%N -> nth (fun _ => 0) fs k x = sum n (nth (fun _ => 0) cs k) x.
  elim: fs fl {lt} => [|f fs IH] fl; first by exists [::].
  have [c ec] : lin n f by inversion fl.
  have [cs sc ce] : exists2 cs : seq (nat -> R), size cs = size fs &
    forall k x, (k < size fs)%N -> nth (fun _ => 0) fs k x = sum n (nth (fun _ => 0) cs k) x.
    by apply: IH; inversion fl.
  by exists (c :: cs) => [|[|k] x] /=; rewrite ?sc // => /ce.
case: n => // n in lt fl ce *.
pose A : 'M[R]_n.+1 := \matrix_(i, k) (if (k < size fs)%N then nth (fun _ => 0) cs k i else 0).
have : \det A == 0.
  rewrite (expand_det_col A ord_max) big1 // => i _; rewrite mxE /= ifF ?mul0r //.
  by apply/negbTE; rewrite -leqNgt -ltnS.
move/det0P => [v v0 vA]; pose x i := v 0 (inord i).
exists x.
  have /rV0Pn[i vi] := v0; exists i; first exact: ltn_ord.
  by rewrite /x inord_val.
apply: (Forall_nth (d := fun _ => 0)) => k kl; rewrite ce //.
have kn : (k < n.+1)%N by exact: ltn_trans kl lt.
transitivity ((v *m A) 0 (Ordinal kn)); last by rewrite vA mxE.
rewrite mxE /sum; apply: eq_bigr => i _.
by rewrite [RHS]mulrC mxE /= kl /x inord_val.
Qed.

(** ** Linear in z (n0 unknowns) and y (u unknowns) *)
Definition lin2 n0 u (f : (nat -> R) -> (nat -> R) -> R) := exists c d, forall z y, f z y =
  sum n0 c z + sum u d y.

Section Closure.
Variables n0 u : nat.
Notation L := (lin2 n0 u).
Lemma lin2_ext f g : (forall z y, f z y = g z y) -> L f -> L g.
Proof. by move=> e [c [d h]]; exists c, d => z y; rewrite -e. Qed.
Lemma lin2_0 : L (fun _ _ => 0).
Proof. by exists (fun _ => 0), (fun _ => 0) => z y; rewrite /sum !big1 ?addr0 // => i _; rewrite mul0r. Qed.
Lemma lin2_add f g : L f -> L g -> L (fun z y => f z y + g z y).
Proof.
case=> c [d h] [c' [d' h']]; exists (fun i => c i + c' i), (fun i => d i + d' i) => z y.
rewrite h h' /sum addrACA -!big_split; congr (_ + _); apply: eq_bigr => i _; by rewrite mulrDl.
Qed.
Lemma lin2_mul k f : L f -> L (fun z y => k * f z y).
Proof.
case=> c [d h]; exists (fun i => k * c i), (fun i => k * d i) => z y.
rewrite h /sum mulrDr !mulr_sumr; congr (_ + _); apply: eq_bigr => i _; by rewrite mulrA.
Qed.
Lemma lin2_mulr k f : L f -> L (fun z y => f z y * k).
Proof. by move/(lin2_mul k); apply: lin2_ext => z y; rewrite mulrC. Qed.
Lemma lin2_opp f : L f -> L (fun z y => - f z y).
Proof. by move/(lin2_mul (-1)); apply: lin2_ext => z y; rewrite mulN1r. Qed.
Lemma lin2_sub f g : L f -> L g -> L (fun z y => f z y - g z y).
Proof. by move=> lf /lin2_opp; apply: lin2_add. Qed.
Lemma sum_delta n i x : (i < n)%N -> sum n (fun k => if k == i then 1 else 0) x = x i.
Proof.
move=> lt; rewrite /sum (bigD1 (Ordinal lt)) //= eqxx mul1r big1 ?addr0 // => k.
by rewrite -val_eqE /= => /negbTE ->; rewrite mul0r.
Qed.
Lemma sum0 n x : sum n (fun _ => 0) x = 0.
Proof. by rewrite /sum big1 // => i _; rewrite mul0r. Qed.
Lemma lin2_z i : (i < n0)%N -> L (fun z _ => z i).
Proof. by move=> lt; exists (fun k => if k == i then 1 else 0), (fun _ => 0) => z y;
  rewrite sum_delta // sum0 addr0. Qed.
Lemma lin2_y i : (i < u)%N -> L (fun _ y => y i).
Proof. by move=> lt; exists (fun _ => 0), (fun k => if k == i then 1 else 0) => z y;
  rewrite sum_delta // sum0 add0r. Qed.

Definition vlin (F : (nat -> R) -> (nat -> R) -> vec R) :=
  [/\ L (fun z y => x1 (F z y)), L (fun z y => x2 (F z y)) & L (fun z y => x3 (F z y))].
Lemma vlin_0 : vlin (fun _ _ => vec0 R).
Proof. by split; apply: lin2_0. Qed.
Lemma vlin_add F G : vlin F -> vlin G -> vlin (fun z y => add (F z y) (G z y)).
Proof. by case=> ? ? ? [? ? ?]; split; apply: lin2_add. Qed.
Lemma vlin_scale k F : vlin F -> vlin (fun z y => scale k (F z y)).
Proof. by case=> ? ? ?; split; apply: lin2_mul. Qed.
Lemma vlin_scaler f w : L f -> vlin (fun z y => scale (f z y) w).
Proof. by move=> lf; split; apply: lin2_mulr. Qed.
Lemma lin2_dot l F : vlin F -> L (fun z y => dot l (F z y)).
Proof. by case=> ? ? ?; rewrite /dot; do 2?apply: lin2_add; apply: lin2_mul. Qed.
Lemma vlin_cross F w : vlin F -> vlin (fun z y => cross (F z y) w).
Proof. by case=> ? ? ?; split; apply: lin2_sub; apply: lin2_mulr. Qed.
Lemma vlin_rot q F : vlin F -> vlin (fun z y => rot q (F z y)).
Proof. by case: q => a b c d lF; split; rewrite /rot /=; apply: lin2_dot. Qed.
End Closure.

(** ** Systems with one block for each element of a list *)
Section Assembly.
Variables (A : Type) (n0 : nat) (globals : seq ((nat -> R) -> R)) (own : A -> nat).
Variable forms : A -> seq ((nat -> R) -> (nat -> R) -> R).
Hypothesis globals_lin : Forall (lin n0) globals.
Hypothesis forms_lin : forall a, Forall (lin2 n0 (own a)) (forms a).

Definition shift o x : nat -> R := fun i => x (o + i)%N.
Fixpoint assemble o (l : seq A) : seq ((nat -> R) -> R) :=
  if l is a :: l' then [seq (fun x => f x (shift o x)) | f <- forms a] ++ assemble (o + own a)%N l' else [::].
Fixpoint parts o (l : seq A) x (n : nat) : nat -> R :=
  if l is a :: l' then if n is n'.+1 then parts (o + own a)%N l' x n' else shift o x else x.
Definition unknowns_of (l : seq A) := sumn (map own l).

Lemma size_assemble o l : size (assemble o l) = sumn [seq size (forms a) | a <- l].
Proof. by elim: l o => //= a l IH o; rewrite size_cat size_map IH. Qed.

Lemma lin_shift n o u f : (n0 <= n)%N -> (o + u <= n)%N -> lin2 n0 u f -> lin n (fun x => f x (shift o x)).
Proof.
move=> h1 h2 [c [d e]].
exists (fun i => (if (i < n0)%N then c i else 0) + (if (o <= i < o + u)%N then d (i - o)%N else 0)) => x.
rewrite e /sum [RHS](eq_bigr (fun i : 'I_n => (if (i < n0)%N then c i else 0) * x i +
  (if (o <= i < o + u)%N then d (i - o)%N else 0) * x i)) => [|i _]; last by rewrite mulrDl.
rewrite big_split; congr (_ + _).
  rewrite (big_ord_widen _ (fun i => c i * x i) h1) [LHS]big_mkcond; apply: eq_bigr => i _ /=.
  by case: ifP; rewrite ?mul0r.
pose F i := (if (o <= i < o + u)%N then d (i - o)%N else 0) * x i.
have z1 : \sum_(0 <= i < o) F i = 0.
  by rewrite big_nat_cond big1 // => i /andP[/andP[_ lt] _]; rewrite /F leqNgt lt mul0r.
have z2 : \sum_(o + u <= i < n) F i = 0.
  by rewrite big_nat_cond big1 // => i /andP[/andP[le _] _]; rewrite /F ltnNge le andbF mul0r.
have split3 : \sum_(0 <= i < n) F i =
  \sum_(0 <= i < o) F i + (\sum_(o <= i < o + u) F i + \sum_(o + u <= i < n) F i).
  by rewrite -big_cat_nat ?leq_addr // -big_cat_nat // (leq_trans (leq_addr _ _) h2).
rewrite -(big_mkord (fun _ => true) F) split3 z1 z2 add0r addr0.
rewrite -[X in \sum_(X <= i < _) F i]add0n big_addn addKn big_mkord; apply: eq_bigr => i _.
by rewrite /F leq_addl addnC ltn_add2l ltn_ord addKn.
Qed.

Lemma Forall_cat B (Q : B -> Prop) (s t : seq B) : Forall Q (s ++ t) <-> Forall Q s /\ Forall Q t.
Proof. exact: List.Forall_app. Qed.
Lemma Forall_map B D (Q : D -> Prop) (g : B -> D) (s : seq B) : Forall Q (map g s) <->
  Forall (fun b => Q (g b)) s.
Proof. exact: List.Forall_map. Qed.

Lemma assemble_lin n o l : (n0 <= n)%N -> (o + unknowns_of l <= n)%N -> Forall (lin n) (assemble o l).
Proof.
move=> h1; elim: l o => [|a l IH] o h2; first by constructor.
apply/Forall_cat; rewrite /unknowns_of /= addnA in h2; split; last exact: IH.
apply/Forall_map; apply: List.Forall_impl (forms_lin a) => f; apply: lin_shift => //.
exact: leq_trans (leq_addr _ _) h2.
Qed.

Lemma assemble_zero o l x : Forall (fun f => f x = 0) (assemble o l) ->
  forall d n, (n < size l)%N -> Forall (fun f => f x (parts o l x n) = 0) (forms (nth d l n)).
Proof.
elim: l o => //= a l IH o /Forall_cat[/Forall_map h1 h2] d [|n] nl //.
exact: IH.
Qed.

Lemma find_part o l x i : (o <= i < o + unknowns_of l)%N -> forall d,
  exists n j, [/\ (n < size l)%N, (j < own (nth d l n))%N & parts o l x n j = x i].
Proof.
elim: l o => [|a l IH] o; rewrite /unknowns_of /=; first by rewrite addn0 ltnNge; case: leqP.
rewrite addnA => /andP[le lt] d; case: (ltnP i (o + own a)) => [lta|lea].
  by exists 0%N, (i - o)%N; rewrite /shift subnKC // ltn_subLR.
have [|n [j [h1 h2 h3]]] := IH (o + own a)%N _ d; first by rewrite lea lt.
by exists n.+1, j.
Qed.

Theorem assembled d (l : seq A) : (size globals + sumn [seq size (forms a) | a <- l] < n0 + unknowns_of l)%N
  ->
  exists z ys, [/\ (exists2 i, (i < n0)%N & z i != 0) \/
    (exists n j, [/\ (n < size l)%N, (j < own (nth d l n))%N & ys n j != 0]),
    Forall (fun g => g z = 0) globals & forall n, (n < size l)%N ->
      Forall (fun f => f z (ys n) = 0) (forms (nth d l n))].
Proof.
move=> lt.
have [||x [i il xi] /Forall_cat[zg zf]] := @more_unknowns (n0 + unknowns_of l) (globals ++ assemble n0 l).
- by rewrite size_cat size_assemble.
- apply/Forall_cat; split; last by apply: assemble_lin; rewrite ?leq_addr.
  apply: List.Forall_impl globals_lin => f [c e].
  have : lin2 n0 0 (fun z _ => f z) by exists c, (fun _ => 0) => z y; rewrite e /sum big_ord0 addr0.
  by move/(@lin_shift (n0 + unknowns_of l) 0 0); apply; rewrite ?leq_addr.
exists x, (parts n0 l x); split=> // [|n nl]; last exact: assemble_zero.
case: (ltnP i n0) => [lti|lei]; first by left; exists i.
have [|n [j [h1 h2 h3]]] := @find_part n0 l x i _ d; first by rewrite lei.
by right; exists n, j; split=> //; rewrite h3.
Qed.
End Assembly.
End System.
