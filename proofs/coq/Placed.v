(** * What the images of a feature say of its place

    The cameras are fixed, in terms of derivations: D kills them. If D kills the image of a line, its
    point and its direction stay in a plane. If D kills the image of a point, it stays on a ray. Rays
    and planes of different views meet at one point or line only. *)
From Coq Require Import ZArith.
From mathcomp Require Import all_ssreflect all_algebra.
From mathcomp.algebra_tactics Require Import ring.
From mathcomp.zify Require Import ssrZ.
From SsrMultinomials Require Import mpoly.
From PL1P Require Import Statement Rigid Reducible Forget Derivations RationalFunctions Independence
  Generic Motion Lifting Reduction Scenes Keeps Determined Dangling.
Set Implicit Arguments.
Unset Strict Implicit.
Unset Printing Implicit Defensive.
Import GRing.Theory.
Local Open Scope ring_scope.

(** ** What is not zero at an integer point is not zero at generic parameters *)
Lemma rot_conj (R : idomainType) (q : quat R) u : rot (conj q) (rot q u) = scale (norm q ^+ 2) u.
Proof. by case: q => a b c d; case: u => u1 u2 u3; rewrite /rot /dot /scale /norm /=; congr Vec; ring. Qed.
Section Integers.
Variables (F : fieldType) (n o : nat) (f : feature).
Hypothesis char0 : [char F] =i pred0.
Hypothesis o11 : (11 <= o)%N.
Hypothesis room : (o + dim3 f <= n)%N.
Notation K := [fieldType of {fraction {mpoly F[n]}}].
Notation P := [idomainType of {mpoly F[n]}].
Definition integer_at k : Z := if (k < 11)%N then (if k == 9%N then Zpos 1 else Z0)
  else nth Z0 [:: Zpos 1; Zpos 3; Zpos 2; Zpos 1; Zneg 1; Zpos 2; Zpos 5; Zneg 3; Zpos 1] (k - o).
Let to_ : {rmorphism P -> K} := [rmorphism of @FracField.tofrac _].
Let ev : {rmorphism P -> F} := [rmorphism of meval (fun i : 'I_n => integers F (integer_at i))].
Notation xP := (xP F n).
Definition integer_own k : Z := nth Z0 [:: Zpos 1; Zpos 3; Zpos 2; Zpos 1; Zneg 1; Zpos 2; Zpos 5;
  Zneg 3; Zpos 1] k.
Variable e : forall R : idomainType, (view -> camera R) -> (nat -> R) -> R.
Hypothesis natural : forall (R R' : idomainType) (g : {rmorphism R -> R'}) C C' x x',
  (forall v, C' v = gcamera g (C v)) -> (forall k, (k < dim3 f)%N -> x' k = g (x k)) -> e C' x' = g (e C x).
Lemma not_zero : e (fun v => cameras_at [idomainType of Z]
    (fun k => if k == 9%N then Zpos 1 else Z0) v) integer_own != 0 ->
  e (fun v => cameras_at K (generic F n) v) (fun k => generic F n (o + k)) != 0.
Proof.
move=> z0; rewrite (@natural P K to_ (fun v => cameras_at P xP v) _ (fun k => xP (o + k)%N)); first last.
- by move=> k _; exact: genericE.
- by move=> v; apply: gcameras; exact: genericE.
have e1 := @natural P F ev (fun v => cameras_at P xP v) _ (fun k => xP (o + k)%N) _
  (fun=> gcameras (fun=> erefl) _)
  (fun _ _ => erefl).
have e2 := @natural [idomainType of Z] F (integers F) (fun v => cameras_at [idomainType of Z] integer_at v) _
  integer_own _ (fun=> gcameras (fun=> erefl) _) (fun _ _ => erefl).
have lt k : (k < 11)%N -> (k < n)%N by move=> h; apply: leq_trans room; rewrite ltn_addr // (leq_trans h).
have evE k : (k < n)%N -> ev (xP k) = integers F (integer_at k).
  by move=> kn; rewrite /Generic.xP insubT /= mevalXU.
have small k : (k < 11)%N -> integer_at k = (if k == 9%N then Zpos 1 else Z0) by rewrite /integer_at => ->.
rewrite /to_ /= tofrac_eq0; apply: contraNneq z0 => p0; rewrite -(integers0 char0) -e2.
have same : e (fun v => cameras_at F (fun k => integers F (integer_at k)) v)
    (fun k => integers F (integer_own k)) =
    e (fun v => cameras_at F (fun k => ev (xP k)) v) (fun k => ev (xP (o + k)%N)).
  have c k : (k < 11)%N -> integers F (integer_at k) = ev (xP k) by move=> /lt kn; rewrite evE.
  apply: (@natural F F [rmorphism of idfun]) => [v|k kd]; last first.
    transitivity (ev (xP (o + k)%N)) => //; rewrite evE ?(leq_trans _ room) ?ltn_add2l //.
    by rewrite /integer_at ltnNge (leq_trans o11) ?leq_addr //= addKn.
  have -> : cameras_at F (fun k => integers F (integer_at k)) v = cameras_at F (fun k => ev (xP k)) v.
    by case: v => //; congr Camera; first [congr Quat | congr Vec]; exact: c.
  have id (E : camera F) : E = gcamera [rmorphism of idfun] E by case: E => -[? ? ? ?] [].
  exact: id.
by apply/eqP; apply: etrans same _; apply: etrans e1 _; rewrite p0 rmorph0.
Qed.
End Integers.

Section Natural.
Variables (R R' : idomainType) (g : {rmorphism R -> R'}).
Lemma gdot u w : dot (gvec g u) (gvec g w) = g (dot u w).
Proof. by rewrite /dot /gvec /= !(rmorphD, rmorphM). Qed.
Lemma gcross u w : cross (gvec g u) (gvec g w) = gvec g (cross u w).
Proof. by rewrite /cross /gvec /= !(rmorphB, rmorphM). Qed.
Lemma grot_conj C u : rot (conj (quat_of (gcamera g C))) (gvec g u) = gvec g (rot (conj (quat_of C)) u).
Proof.
have := gturn g (Camera (conj (quat_of C)) (vec0 R)) u; rewrite /turn /= => ->.
by case: C => -[a b c d] t; rewrite /conj /= !rmorphN.
Qed.
Lemma gnorm C : norm (quat_of (gcamera g C)) = g (norm (quat_of C)).
Proof. by case: C => -[a b c d] t; rewrite /norm /= !(rmorphD, rmorphX). Qed.
Variables (f : feature) (x : nat -> R) (x' : nat -> R').
Hypothesis gx : forall k, (k < dim3 f)%N -> x' k = g (x k).
Lemma gpoint : point_at f x' = gvec g (point_at f x).
Proof. by rewrite /point_at /gvec /=; case fr: (free f); rewrite !gx ?rmorph0 // /dim3 fr. Qed.
Lemma gdir i : (i < pins f)%N -> dir_at f x' i = gvec g (dir_at f x i).
Proof. by move/pin_own => lt; rewrite /dir_at /gvec /= !gx ?rmorph1 // ltnW. Qed.
End Natural.

(** The plane of the line through X with direction d, as a vector in space; the ray of X. *)
Section Planes.
Variable R : idomainType.
Implicit Types (C : camera R) (X d : vec R).
Definition plane_of C X d : vec R := let n := normal C X d in
  @Vec R (dot n (turn C (@Vec R 1 0 0))) (dot n (turn C (@Vec R 0 1 0))) (dot n (turn C (@Vec R 0 0 1))).
Definition ray_of C X : vec R := rot (conj (quat_of C)) (project C X).
Lemma plane_ofE C X d i : dot (normal C X d) (turn C i) = dot (plane_of C X d) i.
Proof.
rewrite /plane_of; move: (normal C X d) => l; case: C => -[q1 q2 q3 q4] t; case: i => i1 i2 i3;
  case: l => l1 l2 l3.
by rewrite /turn /rot /dot /=; ring.
Qed.
End Planes.
Section NaturalPlanes.
Variables (R R' : idomainType) (g : {rmorphism R -> R'}).
Lemma gplane C X d : plane_of (gcamera g C) (gvec g X) (gvec g d) = gvec g (plane_of C X d).
Proof.
have e1 : @Vec R' 1 0 0 = gvec g (@Vec R 1 0 0) by rewrite /gvec /= rmorph1 rmorph0.
have e2 : @Vec R' 0 1 0 = gvec g (@Vec R 0 1 0) by rewrite /gvec /= rmorph1 rmorph0.
have e3 : @Vec R' 0 0 1 = gvec g (@Vec R 0 0 1) by rewrite /gvec /= rmorph1 rmorph0.
by rewrite /plane_of e1 e2 e3 -gnormal -!gturn !gdot.
Qed.
Lemma gray C X : ray_of (gcamera g C) (gvec g X) = gvec g (ray_of C X).
Proof. by rewrite /ray_of -gproject grot_conj. Qed.
End NaturalPlanes.

(** ** At generic parameters *)
Section Generic.
Variables (F : fieldType) (n o : nat) (f : feature).
Hypothesis char0 : [char F] =i pred0.
Hypothesis o11 : (11 <= o)%N.
Hypothesis room : (o + dim3 f <= n)%N.
Notation K := [fieldType of {fraction {mpoly F[n]}}].
Notation C := (cameras_at K (generic F n)).
Notation x := (fun k => generic F n (o + k)%N).
Notation X := (point_at f x).
Notation d := (dir_at f x).
Notation pl w i := (plane_of (C w) X (d i)).
Lemma norm_generic w : norm (quat_of (C w)) != 0.
Proof.
apply: (not_zero char0 o11 room (e := fun R C (x : nat -> R) => norm (quat_of (C w)))).
  by move=> R R' g C0 C' x0 x' hC hx; rewrite hC gnorm.
by case: w; vm_compute.
Qed.
Lemma rays_differ u w : free f = false -> u <> w -> cross (ray_of (C w) X) (ray_of (C u) X) <> vec0 K.
Proof.
move=> nf uw; suff : dot (@Vec K 1 1 1) (cross (ray_of (C w) X) (ray_of (C u) X)) != 0.
  by move=> h e; move: h; rewrite e /dot /= !mulr0 !addr0 eqxx.
apply: (not_zero char0 o11 room (e := fun R C (x : nat -> R) =>
  dot (@Vec R 1 1 1) (cross (ray_of (C w) (point_at f x)) (ray_of (C u) (point_at f x))))).
  move=> R R' g C0 C' x0 x' hC hx; rewrite !hC (gpoint hx) !gray gcross -gdot; congr (dot _ _).
  by rewrite /gvec /= rmorph1.
by rewrite /point_at nf; case: u uw; case: w => // _; vm_compute.
Qed.
Lemma ray_off_plane u w i : free f = false -> u <> w -> (i < pins f)%N -> (i < 3)%N ->
  dot (pl w i) (ray_of (C u) X) != 0.
Proof.
move=> nf uw ip i3; apply: (not_zero char0 o11 room (e := fun R C (x : nat -> R) =>
  dot (plane_of (C w) (point_at f x) (dir_at f x i)) (ray_of (C u) (point_at f x)))).
  by move=> R R' g C0 C' x0 x' hC hx; rewrite !hC (gpoint hx) (gdir hx) // gplane gray gdot.
by rewrite /point_at /dir_at nf; case: i i3 {ip} => [|[|[|]]] // _; case: u uw; case: w => // _; vm_compute.
Qed.
Lemma free_line_third w : free f -> pins f = 1%N -> x3 (normal (C w) X (d 0%N)) != 0.
Proof.
move=> fr p1; apply: (not_zero char0 o11 room (e := fun R C (x : nat -> R) =>
  x3 (normal (C w) (point_at f x) (dir_at f x 0%N)))).
  by move=> R R' g C0 C' x0 x' hC hx; rewrite !hC (gpoint hx) (gdir hx) ?p1 // -gnormal.
by rewrite /point_at /dir_at fr; case: w; vm_compute.
Qed.
(** Two planes of a pin, or of a free line. *)
Lemma planes_differ u w i : proper f -> u <> w -> (i < pins f)%N ->
  x1 (pl u i) * x2 (pl w i) - x1 (pl w i) * x2 (pl u i) != 0.
Proof.
move=> pf uw ip; case fr: (free f); last exact: (generic_meeting char0 o11 room fr uw ip).
move: ip; rewrite (free_pins pf fr); case: i => // _.
pose q R (C : view -> camera R) (x : nat -> R) v := plane_of (C v) (point_at f x) (dir_at f x 0%N).
apply: (not_zero char0 o11 room (e :=
  fun R C x => x1 (q R C x u) * x2 (q R C x w) - x1 (q R C x w) * x2 (q R C x u))).
  move=> R R' g C0 C' x0 x' hC hx; rewrite /q !hC (gpoint hx) (gdir hx) ?(free_pins pf fr) //.
  by rewrite !gplane rmorphB !rmorphM.
by rewrite /q /point_at /dir_at fr; case: u uw; case: w => // _; vm_compute.
Qed.
End Generic.

(** ** What stays *)
Section Algebra.
Variables (F K : fieldType) (c0 : {rmorphism F -> K}) (D : K -> K).
Hypothesis hD : derivation c0 D.
Variables (C : camera K) (X d : vec K).
Hypothesis hC : dead_camera D C.
Lemma ratio_dvec (l : vec K) : x3 l != 0 -> D (x1 l / x3 l) = 0 -> D (x2 l / x3 l) = 0 ->
  dvec D l = scale (D (x3 l) / x3 l) l.
Proof.
move=> l3 z1 z2; have one a : D (a / x3 l) = 0 -> D a = D (x3 l) / x3 l * a.
  by move=> z; rewrite -{1}(divfK l3 a) (derM hD) z mul0r add0r mulrAC [a * _]mulrC mulrAC.
by rewrite /dvec /scale (one _ z1) (one _ z2) divfK.
Qed.
Lemma dot_still (l u w : vec K) k : dot l u = 0 -> dvec D l = scale k l -> dvec D u = w -> dot l w = 0.
Proof.
move=> e el <-; have := der0 hD; rewrite -[in LHS]e (d_dot hD) el => z.
transitivity (k * dot l u + dot l (dvec D u)); first by rewrite e mulr0 add0r.
by rewrite -[RHS]z /dot /=; ring.
Qed.
Lemma dvec_project : dvec D (project C X) = turn C (dvec D X).
Proof.
rewrite -(turn_still hD _ hC) /project; have [_ _ _ _ [t1 t2 t3]] := hC.
by rewrite /dvec /add /=; congr Vec; rewrite (derD hD) ?t1 ?t2 ?t3 addr0.
Qed.
Lemma line_still (l := normal C X d) : x3 l != 0 -> D (x1 l / x3 l) = 0 -> D (x2 l / x3 l) = 0 ->
  dot (plane_of C X d) (dvec D X) = 0 /\ dot (plane_of C X d) (dvec D d) = 0.
Proof.
move=> l3 z1 z2; have el := ratio_dvec l3 z1 z2; rewrite -!plane_ofE; split.
  by apply: dot_still el dvec_project; exact: normal_dot.
apply: dot_still el (turn_still hD d hC); rewrite /l /normal.
by move: (project _ _) (turn _ _) => p q; rewrite /dot /cross /=; ring.
Qed.
Lemma point_still (p := project C X) : x3 p != 0 -> D (x1 p / x3 p) = 0 -> D (x2 p / x3 p) = 0 ->
  exists k, scale (norm (quat_of C) ^+ 2) (dvec D X) = scale k (ray_of C X).
Proof.
move=> p3 z1 z2; exists (D (x3 p) / x3 p); have ep := ratio_dvec p3 z1 z2.
rewrite -rot_conj -/(turn C (dvec D X)) -dvec_project ep /ray_of -/p.
move: (Rigid.conj (quat_of C)) (D (x3 p) / x3 p) (p) => [a b e h] k [p1 p2 q3].
by rewrite /rot /dot /scale /=; congr Vec; ring.
Qed.
End Algebra.
Section Solve.
Variable K : fieldType.
Implicit Types (v r l : vec K).
Lemma two_solve (p q v : vec K) : x1 p * x2 q - x1 q * x2 p != 0 -> x3 v = 0 -> dot p v = 0 -> dot q v = 0 ->
  v = vec0 K.
Proof.
case: v => v1 v2 v3 /= d0 -> e1 e2; have [] := @two_planes _ v1 v2 _ _ _ _ d0.
- by apply: etrans e1; rewrite /dot /= mulr0 addr0 ![v1 * _]mulrC ![v2 * _]mulrC.
- by apply: etrans e2; rewrite /dot /= mulr0 addr0 ![v1 * _]mulrC ![v2 * _]mulrC.
by move=> -> ->.
Qed.
Lemma scale_solve (k : K) v : k != 0 -> scale k v = vec0 K -> v = vec0 K.
Proof. by case: v => a b c k0 [e1 e2 e3]; congr Vec; apply: (mulfI k0); rewrite ?e1 ?e2 ?e3 mulr0. Qed.
Lemma ray_solve (m k : K) v r l : m != 0 -> scale m v = scale k r -> dot l v = 0 -> dot l r != 0 ->
  v = vec0 K.
Proof.
move=> m0 e z l0; apply: (scale_solve m0); rewrite e; have -> : k = 0.
  apply: (mulIf l0); rewrite mul0r; transitivity (dot l (scale k r)); first by rewrite /dot /=; ring.
  by rewrite -e; transitivity (m * dot l v); [rewrite /dot /=; ring | rewrite z mulr0].
by rewrite /scale /vec0 !mul0r.
Qed.
Lemma rays_solve (m m' k k' : K) v r r' : m != 0 -> m' != 0 -> cross r' r <> vec0 K ->
  scale m v = scale k r ->
  scale m' v = scale k' r' -> v = vec0 K.
Proof.
move=> m0 m0' cr e e'; apply: (scale_solve m0); rewrite e; have [->|k0] := eqVneq k 0.
  by rewrite /scale /vec0 !mul0r.
case: cr; apply: (scale_solve (mulf_neq0 m0' k0)).
transitivity (scale m' (cross r' (scale k r))); first by rewrite /cross /scale /=; congr Vec; ring.
rewrite -e; transitivity (scale m (cross r' (scale m' v))).
  by rewrite /cross /scale /=; congr Vec; ring.
by rewrite e' /cross /scale /vec0 /=; congr Vec; ring.
Qed.
Lemma dvec_dead (D : K -> K) v : dvec D v = vec0 K -> dead D v. Proof. by case. Qed.
End Solve.

Section Stays.
Variables (F : fieldType) (n o : nat) (f : feature).
Hypothesis char0 : [char F] =i pred0.
Hypothesis o11 : (11 <= o)%N.
Hypothesis room : (o + dim3 f <= n)%N.
Hypothesis pf : proper f.
Notation K := [fieldType of {fraction {mpoly F[n]}}].
Notation C := (cameras_at K (generic F n)).
Notation x := (fun k => generic F n (o + k)%N).
Notation X := (point_at f x).
Notation d := (dir_at f x).
Notation pl w i := (plane_of (C w) X (d i)).
Variable D : K -> K.
Hypothesis hD : derivation (const (to F n)) D.
Hypothesis hC : forall v, dead_camera D (C v).
Definition flat w i := dot (pl w i) (dvec D X) = 0 /\ dot (pl w i) (dvec D (d i)) = 0.
Definition rayed u := exists k, scale (norm (quat_of (C u)) ^+ 2) (dvec D X) = scale k (ray_of (C u) X).

(** From images. *)
Lemma line_flat w i : (i < pins f)%N -> killed D (line_image false (normal (C w) X (d i))) -> flat w i.
Proof.
move=> ip /killed_two[z1 z2]; apply: (line_still hD (hC w)) z1 z2; case fr: (free f).
  move: ip; rewrite (free_pins pf fr); case: (i) => // _; apply: free_line_third => //; exact: free_pins.
by case: (generic_line char0 o11 room fr w ip).
Qed.
Lemma image_rayed u : killed D (image (f, x) (C u) (looks f u)) -> sees_point f u -> rayed u.
Proof.
move=> k pu; have [_ _ sp] := properP u pf; have nf : free f = false by move: sp; rewrite pu; case: (free f).
move: k; rewrite /image killed_cat -/(sees_point f u) pu => /andP[/killed_two[z1 z2] _].
exact: (point_still hD (hC u) (generic_point F o11 room nf u) z1 z2).
Qed.
Lemma slope_flat w i : free f = false -> (i < pins f)%N -> killed D (point_image (project (C w) X)) ->
  D (slope F n o f i w) = 0 -> flat w i.
Proof.
move=> nf ip /killed_two[z1 z2] z; have [n2 n3] := generic_line char0 o11 room nf w ip.
apply: line_flat => //; apply/killed_two.
exact: (line_other hD n2 n3 (generic_point F o11 room nf w) (normal_dot _ _ _) z1).1 (Logic.conj z2 z).
Qed.
Lemma image_flat w i : killed D (image (f, x) (C w) (looks f w)) -> i \in sees_pins f w -> flat w i.
Proof.
have [_ /allP le sp] := properP w pf; rewrite /image killed_cat killed_flatten => /andP[kp /allP kl] iw.
have ip := le i iw; have := kl i iw; rewrite -/(sees_point f w); case pw: (sees_point f w) => kl';
  last exact: line_flat.
have nf : free f = false by move: sp; rewrite pw; case: (free f).
by apply: slope_flat => //; [move: kp; rewrite -/(sees_point f w) pw | move/killed_one: kl'].
Qed.

(** The conclusions. *)
Lemma pin_stays u w i : u <> w -> (i < pins f)%N -> flat u i -> flat w i -> dead D (d i).
Proof.
move=> uw ip [_ fu] [_ fw]; apply: dvec_dead; apply: two_solve fu fw; last exact: (der1 hD).
exact: planes_differ.
Qed.
Lemma free_stays u w i : free f -> u <> w -> (i < pins f)%N -> flat u i -> flat w i -> dead D X.
Proof.
move=> fr uw ip [fu _] [fw _]; apply: dvec_dead; apply: two_solve fu fw; last by rewrite /= fr (der0 hD).
exact: planes_differ.
Qed.
Lemma norm2 u : norm (quat_of (C u)) ^+ 2 != 0.
Proof. by rewrite expf_neq0 // (norm_generic char0 o11 room). Qed.
Lemma plane_stays u w i : free f = false -> u <> w -> (i < pins f)%N -> (i < 3)%N -> rayed u ->
  flat w i -> dead D X.
Proof.
move=> nf uw ip i3 [k e] [fw _]; apply: dvec_dead; apply: (ray_solve (norm2 u) e fw).
exact: ray_off_plane.
Qed.
Lemma rays_stay u w : free f = false -> u <> w -> rayed u -> rayed w -> dead D X.
Proof.
move=> nf uw [k e] [k' e']; apply: dvec_dead; apply: (rays_solve (norm2 u) (norm2 w)) e e'.
exact: rays_differ.
Qed.
(** All own parameters. *)
Lemma own_stays : dead D X -> (forall i, (i < pins f)%N -> dead D (d i)) -> killed D (own (f, x)).
Proof.
move=> [z1 z2 z3] hd; rewrite ownE /kept_parameters killed_cat killed_flatten; apply/andP; split.
  by case: ifP => _; rewrite /killed /= ?z1 ?z2 ?z3 !eqxx.
by apply/allP => i; rewrite mem_iota => /hd[e1 e2 _]; apply/killed_two.
Qed.
End Stays.
