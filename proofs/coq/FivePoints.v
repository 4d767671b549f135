(** * The five-point problem has at most 20 solutions

    Two calibrated views see five points. The first camera is [1 | 0]; the second is any rotation
    and any translation but 0, which are known up to a factor. The claim is [five_points];
    GenericImages.v ends its proof. Template.v, Pose.v and SamePose.v say why there are at most ten
    essential matrices, and two cameras for each. *)
From Coq Require Import ZArith.
From mathcomp Require Import all_ssreflect all_algebra.
From mathcomp.algebra_tactics Require Import ring.
From mathcomp.zify Require Import ssrZ.
From SsrMultinomials Require Import mpoly.
From PL1P Require Import Statement Rigid Derivations Epipolar Template Pose SamePose.
Set Implicit Arguments.
Unset Strict Implicit.
Unset Printing Implicit Defensive.
Import GRing.Theory.
Local Open Scope ring_scope.

Section Definitions.
Variable L : fieldType.
Definition first_camera := @Camera L (@Quat L 1 0 0 0) (vec0 L).
(** Points i = 0..4: views 1 and 2 see them at (y_4i, y_4i+1) and (y_4i+2, y_4i+3). A solution is a
    camera of view 2 that is not degenerate, such that there are five points with these images. *)
Definition image_in (C : camera L) (X : vec L) (a b : L) :=
  let x := project C X in x3 x != 0 /\ point_image x = [:: a; b].
Definition solution (y : nat -> L) (C : camera L) :=
  [/\ norm (quat_of C) != 0, trans C <> vec0 L &
  forall i, (i < 5)%N -> exists X, image_in first_camera X (y (4 * i)%N) (y (4 * i + 1)%N) /\
    image_in C X (y (4 * i + 2)%N) (y (4 * i + 3)%N)].
(** One camera: quaternion and translation are the same up to factors. (The images fix no length.) *)
Definition one_camera (C C' : camera L) :=
  (exists2 m, m != 0 & trans C' = scale m (trans C)) /\
  exists2 b, b != 0 & quat_of C' = factor b (quat_of C).
End Definitions.

(** Let the 20 coordinates of the images be independent over a field F of characteristic 0, in any
    field L over F. Then there are at most 20 solutions in L: of n solutions, any two of which are
    different cameras, n is at most 20. *)
Definition five_points : Prop := forall (F L : fieldType) (c : {rmorphism F -> L}), [char F] =i pred0 ->
  forall y : nat -> L, independent c (fun j : 'I_20 => y j) ->
  forall n (C : nat -> camera L), (forall i, (i < n)%N -> solution y (C i)) ->
    (forall i j, (i < n)%N -> (j < n)%N -> one_camera (C i) (C j) -> i = j) -> (n <= 20)%N.

(** ** The space of matrices that the five equations leave *)
Section Space.
Variable R : comRingType.
Implicit Types y : nat -> R.
Definition bound_entries := [:: 2; 5; 6; 7; 8]%N.
Definition free_entries := [:: 0; 1; 3; 4]%N.
(** The coefficient of E_e in the equation of point i. *)
Definition seen y i (w : bool) a : R :=
  nth 1 (if w then [:: y (4 * i + 2)%N; y (4 * i + 3)%N] else [:: y (4 * i)%N; y (4 * i + 1)%N]) a.
Definition coefficient y i e := seen y i true (e %/ 3)%N * seen y i false (e %% 3)%N.
Definition bound_block y : 'M[R]_5 := \matrix_(i, j) coefficient y i (nth 0%N bound_entries j).
Definition free_block y : 'M[R]_(5, 4) := \matrix_(i, j) coefficient y i (nth 0%N free_entries j).
Definition solved y : 'M[R]_(5, 4) := - (\adj (bound_block y) *m free_block y).
(** A basis of the matrices that satisfy them. *)
Definition space y (i e : nat) : R :=
  if e \in free_entries then (if index e free_entries == i then \det (bound_block y) else 0)
  else solved y (inord (index e bound_entries)) (inord i).
End Space.

(** ** Nothing here depends on the field *)
Section Natural.
Variables (R R' : comRingType) (g : {rmorphism R -> R'}) (y : nat -> R) (y' : nat -> R').
Hypothesis gy : forall k, y' k = g (y k).
Lemma coefficient_map i e : coefficient y' i e = g (coefficient y i e).
Proof.
have s w a : seen y' i w a = g (seen y i w a).
  by rewrite /seen; case: w; case: a => [|[|a]] //=; rewrite ?nth_nil ?rmorph1 // gy.
by rewrite /coefficient !s rmorphM.
Qed.
Lemma bound_block_map : bound_block y' = map_mx g (bound_block y).
Proof. by apply/matrixP => i j; rewrite !mxE coefficient_map. Qed.
Lemma space_map i e : space y' i e = g (space y i e).
Proof.
rewrite /space bound_block_map det_map_mx; case: ifP => _; first by case: ifP; rewrite ?rmorph0.
rewrite /solved bound_block_map -map_mx_adj; set A := \adj (bound_block y).
rewrite (_ : free_block y' = map_mx g (free_block y)) -?map_mxM; first by rewrite !mxE rmorphN.
by apply/matrixP => k l; rewrite !mxE coefficient_map.
Qed.
End Natural.

Lemma form_map (R R' : comRingType) (g : {rmorphism R -> R'}) k (A B C : nat -> R) (A' B' C' : nat -> R') :
  (forall e, A' e = g (A e)) -> (forall e, B' e = g (B e)) -> (forall e, C' e = g (C e)) -> form k A' B' C' =
    g (form k A B C).
Proof.
move=> eA eB eC; rewrite /form; case: eqP => _; rewrite !eA !eB !eC.
  by rewrite !(rmorphN, rmorphD, rmorphM).
by rewrite !(rmorphN, rmorphD, rmorphM, rmorphMn).
Qed.
Lemma leading_map (R R' : comRingType) (g : {rmorphism R -> R'}) (P : nat -> nat -> R) (P' : nat -> nat ->
  R') :
  (forall i e, P' i e = g (P i e)) -> leading P' = map_mx g (leading P).
Proof.
move=> gP; apply/matrixP => k j; rewrite !mxE /coef; elim: (permutations _) => [|r l IH] /=;
  first by rewrite rmorph0.
by rewrite IH rmorphD; congr (_ + _); apply: form_map => e; exact: gP.
Qed.

(** ** The solutions for given images *)
Section Bound.
Variables (L : fieldType) (y : nat -> L).
Hypothesis two : 2%:R != 0 :> L.
Notation det := (\det (bound_block (y : nat -> [comRingType of L]))).
Notation P := (@space [comRingType of L] y).
Hypothesis det0 : det != 0.
Hypothesis regular : \det (@leading [comRingType of L] P) != 0.
Notation Vec := (@Vec L).
Notation first_camera := (first_camera L).
Implicit Types p q r : camera L.
Definition E p := essential (trans p) (quat_of p).

Lemma image_in_E p X a b : image_in p X a b -> let x := project p X in
  [/\ x3 x != 0, x1 x / x3 x = a & x2 x / x3 x = b].
Proof. by case=> h [h1 h2]. Qed.
Lemma equations p : solution y p -> forall i, (i < 5)%N ->
  \sum_(e < 9) E p e * @coefficient [comRingType of L] y i e = 0.
Proof.
case=> _ _ h i /h[X [/image_in_E[a1 a2 a3] /image_in_E[b1 b2 b3]]].
have eX : project first_camera X = X.
  by case: (X) => u1 u2 u3; apply: vec_ext; rewrite /project /turn /rot /dot /add /=; ring.
rewrite eX in a1 a2 a3.
rewrite -[RHS](@epipolar_sum L p X (Vec (y (4 * i)%N) (y (4 * i + 1)%N) 1)
  (Vec (y (4 * i + 2)%N) (y (4 * i + 3)%N) 1)) //.
rewrite essential_dot; apply: eq_bigr => e _; congr (_ * _).
by case: e => -[|[|[|[|[|[|[|[|[|e]]]]]]]]].
Qed.

Lemma regroup (f g : nat -> L) :
  f 2%N * g 2%N + (f 5%N * g 5%N + (f 6%N * g 6%N + (f 7%N * g 7%N + (f 8%N * g 8%N + 0)))) +
    (f 0%N * g 0%N + (f 1%N * g 1%N + (f 3%N * g 3%N + (f 4%N * g 4%N + 0)))) =
  g 0%N * f 0%N + (g 1%N * f 1%N + (g 2%N * f 2%N + (g 3%N * f 3%N + (g 4%N * f 4%N + (g 5%N * f 5%N +
    (g 6%N * f 6%N + (g 7%N * f 7%N + (g 8%N * f 8%N + 0)))))))).
Proof. ring. Qed.
Lemma regroup4 (m s0 s1 s2 s3 : L) (g : nat -> L) :
  m * g 0%N * s0 + m * g 1%N * s1 + m * g 3%N * s2 + m * g 4%N * s3 =
  m * (s0 * g 0%N + (s1 * g 1%N + (s2 * g 3%N + (s3 * g 4%N + 0)))).
Proof. ring. Qed.
Definition free_z (m : L) p (i : nat) := m * E p (nth 0%N free_entries i).
Lemma in_space m p e : solution y p -> (e < 9)%N -> at_z P (free_z m p) e = m * det * E p e.
Proof.
move=> /equations eq e9; pose Eb : 'cV[L]_5 := \col_j E p (nth 0%N bound_entries j).
pose Ef : 'cV[L]_4 := \col_j E p (nth 0%N free_entries j).
have lin : bound_block (y : nat -> [comRingType of L]) *m Eb =
  - (free_block (y : nat -> [comRingType of L]) *m Ef).
  apply/eqP; rewrite -addr_eq0; apply/eqP/colP => i; rewrite !mxE -[RHS](eq i (ltn_ord i)).
  rewrite !big_ord_recl !big_ord0 !mxE; exact: regroup.
have sol : @solved [comRingType of L] y *m Ef = det *: Eb.
  by rewrite /solved mulNmx -mulmxA -[_ *m Ef]opprK -lin mulmxN opprK mulmxA mul_adj_mx mul_scalar_mx.
have [S SE] : exists S, @solved [comRingType of L] y = S by exists (@solved [comRingType of L] y).
rewrite SE in sol.
have bound j : (j < 5)%N -> at_z P (free_z m p) (nth 0%N bound_entries j) =
  m * det * E p (nth 0%N bound_entries j).
  move=> j5; have := congr1 (fun v : 'cV_5 => v (inord j) 0) sol;
    rewrite !mxE !big_ord_recl big_ord0 !mxE inordK // => es.
  rewrite -mulrA -[X in m * X]es /at_z /space /free_z SE.
  have -> : (nth 0%N bound_entries j \in free_entries) = false by case: j j5 {es} => [|[|[|[|[|j]]]]].
  have -> : index (nth 0%N bound_entries j) bound_entries = j by case: j j5 {es} => [|[|[|[|[|j]]]]].
  have e0 : inord 0 = ord0 :> 'I_4 by apply/val_inj; rewrite /= inordK.
  have e1 : inord 1 = lift ord0 ord0 :> 'I_4 by apply/val_inj; rewrite /= inordK.
  have e2 : inord 2 = lift ord0 (lift ord0 ord0) :> 'I_4 by apply/val_inj; rewrite /= inordK.
  have e3 : inord 3 = lift ord0 (lift ord0 (lift ord0 ord0)) :> 'I_4 by apply/val_inj; rewrite /= inordK.
  rewrite e0 e1 e2 e3; exact: (regroup4 m (S (inord j) ord0) _ _ _ (E p)).
have free i : (i < 4)%N -> at_z P (free_z m p) (nth 0%N free_entries i) =
  m * det * E p (nth 0%N free_entries i).
  by case: i => [|[|[|[|i]]]] // _; rewrite /at_z /space /free_z /= !mulr0 ?addr0 ?add0r; exact: mulrAC.
by case: e e9 => [|[|[|[|[|[|[|[|[|e]]]]]]]]] // _;
  [exact: (free 0%N) | exact: (free 1%N) | exact: (bound 0%N) |
  exact: (free 2%N) | exact: (free 3%N) | exact: (bound 1%N) | exact: (bound 2%N) | exact:
    (bound 3%N) | exact: (bound 4%N)].
Qed.

(** The solution, with translation times m det, is a point of the space. *)
Lemma form_ext k (A B : nat -> L) : (k < 10)%N -> (forall e, (e < 9)%N -> A e = B e) ->
  @form [comRingType of L] k A A A = @form [comRingType of L] k B B B.
Proof.
move=> k10 h; have := h 0%N isT; have := h 1%N isT; have := h 2%N isT; have := h 3%N isT; have := h 4%N isT.
have := h 5%N isT; have := h 6%N isT; have := h 7%N isT; have := h 8%N isT.
by rewrite /form; do 10?[case: k k10 => [|k] k10 //=]; move=> -> -> -> -> -> -> -> -> ->.
Qed.
Lemma scaled_essential m (t : vec L) (q : quat L) e : essential (scale m t) q e = m * essential t q e.
Proof.
rewrite /essential; move: (rot _ _) => u; case: (e %/ 3)%N => [|[|a]]; by rewrite /cross /scale /=; ring.
Qed.
Lemma free_z_solves m p : solution y p -> @solves L P (free_z m p).
Proof.
move=> sp k k10; rewrite (@form_ext k _ (essential (scale (m * det) (trans p)) (quat_of p))) //.
  exact: essential_cubics.
by move=> e e9; rewrite scaled_essential; exact: in_space.
Qed.
Lemma chart_nonzero p : solution y p -> E p 4 != 0.
Proof.
move=> sp; apply/negP => /eqP E4; have z3 : free_z 1 p 3 = 0 by rewrite /free_z /= E4 mulr0.
have zero := chart regular (free_z_solves 1 sp) z3; have [n0 t0 _] := sp.
apply: t0; apply: (essential_nonzero n0) => e e9; have := zero e; rewrite (in_space 1 sp e9) mul1r.
by move/eqP; rewrite mulf_eq0 (negbTE det0) => /eqP.
Qed.
Definition normal_z p := free_z (E p 4)^-1 p.
Lemma normal_z3 p : solution y p -> normal_z p 3 = 1.
Proof. by move=> sp; rewrite /normal_z /free_z /= mulVf // chart_nonzero. Qed.

(** Solutions with the same point have the same E up to scale. *)
Lemma same_point p q : solution y p -> solution y q -> (forall i, (i < 4)%N -> normal_z p i = normal_z q i) ->
  exists2 k, k != 0 & forall e, (e < 9)%N -> E q e = k * E p e.
Proof.
move=> sp sq h; have p4 := chart_nonzero sp; have q4 := chart_nonzero sq.
exists (E q 4 / E p 4) => [|e e9]; first by rewrite mulf_neq0 ?invr_eq0.
have : (E p 4)^-1 * det * E p e = (E q 4)^-1 * det * E q e.
  by rewrite -!in_space // /at_z -!/(normal_z _ _) !h.
move=> e1; apply: (mulfI (x := (E q 4)^-1 * det)); first by rewrite mulf_neq0 ?invr_eq0.
rewrite -e1; move: det => dd; field; by rewrite p4 q4.
Qed.
Definition point_of p : L * L * L := (normal_z p 0, normal_z p 1, normal_z p 2)%N.
Definition coordinates_of (v : L * L * L) (i : nat) : L := nth 1 [:: v.1.1; v.1.2; v.2] i.
Lemma point_ofE p i : solution y p -> (i < 4)%N -> coordinates_of (point_of p) i = normal_z p i.
Proof. by move=> sp; case: i => [|[|[|[|i]]]] // _; rewrite normal_z3. Qed.

Lemma at_most_two p q r : solution y p -> solution y q -> solution y r -> point_of p = point_of q ->
  point_of p = point_of r -> [\/ one_camera p q, one_camera p r | one_camera q r].
Proof.
have other u : solution y p -> solution y u -> point_of p = point_of u ->
    (exists2 m, m != 0 & trans u = scale m (trans p)) /\ exists2 b, b != 0 &
    quat_of u = factor b (quat_of p) \/ quat_of u = factor b (turned (trans p) (quat_of p)).
  move=> sp su e; have [|k k0 h] := same_point sp su.
    by move=> i i4; rewrite -!point_ofE // e.
  by have [np tp _] := sp; have [nu tu _] := su; exact: (same_essential two tp tu np nu k0 h).
move=> sp sq sr e1 e2; have [[m m0 tq] [b b0 cq]] := other q sp sq e1.
have [[m' m0' tr] [b' b0' cr]] := other r sp sr e2.
case: cq => cq; first by constructor 1; split; [exists m | exists b].
case: cr => cr; first by constructor 2; split; [exists m' | exists b'].
constructor 3; split.
  exists (m' / m); first by rewrite mulf_neq0 ?invr_eq0.
  by rewrite tq tr /scale /=; congr Vec; rewrite mulrA divfK.
exists (b' / b); first by rewrite mulf_neq0 ?invr_eq0.
by rewrite cq cr /factor /=; congr Quat; rewrite mulrA divfK.
Qed.

Lemma fibres (T U : eqType) (f : T -> U) m (s : seq T) (V : seq U) : uniq V -> {subset map f s <= V} ->
  (forall v, (count (fun i => f i == v) s <= m)%N) -> (size s <= m * size V)%N.
Proof.
elim: V s => [|v V IH] s; first by case: s => // i s _ /(_ (f i)); rewrite mem_head => /(_ isT).
case/andP=> vV uV sub le; rewrite -(count_predC (fun i => f i == v)) mulnS leq_add // -size_filter.
apply: IH => // [w|w]; last first.
  by apply: leq_trans (le w); rewrite count_filter; apply: sub_count => i /andP[].
case/mapP=> i; rewrite mem_filter => /andP[/= ne si] ->; have := sub _ (map_f f si).
by rewrite inE (negbTE ne).
Qed.

Theorem at_most_twenty n (C : nat -> camera L) : (forall i, (i < n)%N -> solution y (C i)) ->
  (forall i j, (i < n)%N -> (j < n)%N -> one_camera (C i) (C j) -> i = j) -> (n <= 20)%N.
Proof.
move=> sol different; pose f i := point_of (C i); pose s := iota 0 n; pose V := undup (map f s).
have sn i : i \in s -> solution y (C i) by rewrite mem_iota => /sol.
have ten : (size V <= 10)%N.
  apply: (@at_most_ten L P regular _ coordinates_of V (undup_uniq _)) => [v|v|v w].
  - rewrite mem_undup => /mapP[i /sn si ->] k k10; rewrite -[RHS](free_z_solves (E (C i) 4)^-1 si k10).
    by apply: form_ext => // e _; rewrite /at_z !point_ofE.
  - by rewrite mem_undup => /mapP[i /sn si ->].
  - move=> _ _ ne; have [e|] := eqVneq v.1.1 w.1.1; last by exists ord0.
    have [e'|] := eqVneq v.1.2 w.1.2; last by exists (inord 1); rewrite inordK.
    exists ord_max; apply: contraNneq ne; move: e e'; rewrite /coordinates_of /=.
    by case: (v) => -[? ?] ?; case: (w) => -[? ?] ? /= -> -> ->.
rewrite -[n](size_iota 0) -/s; apply: leq_trans (_ : 2 * size V <= 20)%N;
  last by rewrite -[20%N]/(2 * 10)%N leq_mul2l.
apply: (fibres (f := f)) => [|w|v]; [exact: undup_uniq | by rewrite mem_undup |].
rewrite -size_filter leqNgt; apply/negP => lt.
have : uniq [seq i <- s | f i == v] by rewrite filter_uniq ?iota_uniq.
have : forall i, i \in [seq i <- s | f i == v] -> [/\ (i < n)%N, solution y (C i) & f i = v].
  by move=> i; rewrite mem_filter mem_iota => /andP[/eqP -> lti]; split=> //; exact: sol.
case: filter lt => [|i [|j [|k l]]] // _ h /= /and3P[];
  rewrite !inE !negb_or => /and3P[ij ik _] /andP[jk _] _.
have [ni si ei] := h i (mem_head _ _).
have [|nj sj ej] := h j; first by rewrite !inE eqxx orbT.
have [|nk sk ek] := h k; first by rewrite !inE eqxx !orbT.
have [||/(different _ _ ni nj)/eqP|/(different _ _ ni nk)/eqP|/(different _ _ nj nk)/eqP] :=
  at_most_two si sj sk; rewrite ?(negbTE ij) ?(negbTE ik) ?(negbTE jk) //.
- by rewrite -!/(f _) ei ej.
- by rewrite -!/(f _) ei ek.
Qed.
End Bound.
