(** * Two views that share more than five points: never rigid

    Keep the relative pose of views i and j up to the length mu of the baseline: 6 conditions on the
    11 camera unknowns and mu. Then a point that both views see gives 4 equations of which one
    follows from the other three ([epipolar]), so that each shared point saves an equation. With six
    of them, unknowns outnumber equations. *)
From Coq Require List.
From mathcomp Require Import all_ssreflect all_algebra.
From mathcomp.algebra_tactics Require Import ring.
From PL1P Require Import Statement Rigid Walk System Blocks.
Set Implicit Arguments.
Unset Strict Implicit.
Unset Printing Implicit Defensive.
Import GRing.Theory.
Local Open Scope ring_scope.

(** ** Vectors and homogeneous rotations *)
Section Vectors.
Variable R : idomainType.
Implicit Types (u w l : vec R) (q : quat R).
Notation Vec := (@Vec R).

Lemma vec_ext u w : x1 u = x1 w -> x2 u = x2 w -> x3 u = x3 w -> u = w.
Proof. by case: u => ? ? ?; case: w => ? ? ? /= -> -> ->. Qed.
Lemma rot_add q u w : rot q (add u w) = add (rot q u) (rot q w).
Proof. by case: q => a b c d; apply: vec_ext; rewrite /rot /dot /add /=; ring. Qed.
Lemma rot_scale q k u : rot q (scale k u) = scale k (rot q u).
Proof. by case: q => a b c d; apply: vec_ext; rewrite /rot /dot /scale /=; ring. Qed.
Lemma rot_conj q u : rot (conj q) (rot q u) = scale (norm q ^+ 2) u.
Proof. by case: q => a b c d; apply: vec_ext; rewrite /rot /conj /norm /dot /scale /=; ring. Qed.
Lemma rot_cross q u w : cross (rot q u) (rot q w) = scale (norm q) (rot q (cross u w)).
Proof. by case: q => a b c d; apply: vec_ext; rewrite /rot /norm /dot /scale /cross /=; ring. Qed.
Lemma norm_conj q : norm (conj q) = norm q.
Proof. case: q => a b c d; rewrite /norm /conj /=; ring. Qed.
Lemma scaleA k k' u : scale k (scale k' u) = scale (k * k') u.
Proof. by apply: vec_ext; rewrite /scale /= mulrA. Qed.
Lemma scale_inj k u w : k <> 0 -> scale k u = scale k w -> u = w.
Proof. by move=> /eqP k0 [] /(mulfI k0) ? /(mulfI k0) ? /(mulfI k0) ?; apply: vec_ext. Qed.
Lemma scale_zero k : scale k (vec0 R) = vec0 R.
Proof. by apply: vec_ext; rewrite /= mulr0. Qed.
Lemma dot_addr l u w : dot l (add u w) = dot l u + dot l w.
Proof. rewrite /dot /add /=; ring. Qed.
Lemma dot_scale l k u : dot l (scale k u) = k * dot l u.
Proof. rewrite /dot /scale /=; ring. Qed.
Lemma cross_scale k k' u w : cross (scale k u) (scale k' w) = scale (k * k') (cross u w).
Proof. apply: vec_ext; rewrite /cross /scale /=; ring. Qed.
Lemma add_zero2 u w : add u (scale (-1) w) = vec0 R -> u = w.
Proof. by case=> h1 h2 h3; apply: vec_ext; apply: subr0_eq; rewrite -mulN1r. Qed.
Lemma add_zero3 u w t k : add (add u (scale (-1) w)) (scale (- k) t) = vec0 R -> u = add w (scale k t).
Proof.
by case=> h1 h2 h3; apply: vec_ext; apply: subr0_eq; [rewrite -h1|rewrite -h2|rewrite -h3]; rewrite /=; ring.
Qed.
End Vectors.

Definition same_view u v := match u, v with V1, V1 | V2, V2 | V3, V3 => true | _, _ => false end.
Lemma same_viewP u v : reflect (u = v) (same_view u v).
Proof. by case: u; case: v; constructor. Qed.

Section Epipolar.
Variable R : idomainType.
Notation Vec := (@Vec R).
Notation Forall := List.Forall.
Implicit Types (z y : nat -> R).
Variables (C : view -> camera R) (i j : view).
Hypothesis ij : i <> j.
Hypothesis norms : forall v, norm (quat_of (C v)) <> 0.
Hypothesis centres : scale (norm (quat_of (C j)) ^+ 2) (centre (C i)) <> scale (norm (quat_of (C i)) ^+ 2)
  (centre (C j)).

(** The 11 camera unknowns in the gauge, and mu, the twelfth. *)
Definition twists z (v : view) : twist R := match v with
  | V1 => Twist (vec0 R) (vec0 R)
  | V2 => Twist (Vec (z 0%N) (z 1%N) (z 2%N)) (Vec 0 (z 3%N) (z 4%N))
  | V3 => Twist (Vec (z 5%N) (z 6%N) (z 7%N)) (Vec (z 8%N) (z 9%N) (z 10%N))
  end.
Notation mu z := (z 11%N).

Lemma twists_gauge z : gauge (twists z). Proof. by []. Qed.
Lemma omega_lin u v : vlin 12 u (fun z _ => omega (twists z v)).
Proof. by case: v; split=> /=; do [exact: lin2_0 | exact: lin2_z]. Qed.
Lemma dt_lin u v : vlin 12 u (fun z _ => dt (twists z v)).
Proof. by case: v; split=> /=; do [exact: lin2_0 | exact: lin2_z]. Qed.

(** The relative pose: N_i^2 x_j = A x_i + t for the images of any point. *)
Let Ni := norm (quat_of (C i)).
Let Nj := norm (quat_of (C j)).
Definition A u := rot (quat_of (C j)) (rot (conj (quat_of (C i))) u).
Definition baseline := add (scale (Ni ^+ 2) (trans (C j))) (scale (-1) (A (trans (C i)))).
Definition rotation_kept z := add (scale (Ni * Nj) (omega (twists z j)))
  (scale (-1) (A (omega (twists z i)))).
Definition baseline_kept z := add (add (scale (Ni ^+ 2) (dt (twists z j))) (scale (-1) (A (dt (twists z i)))))
  (scale (- mu z) baseline).
Definition globals := [:: (fun z => x1 (rotation_kept z)); (fun z => x2 (rotation_kept z));
  (fun z => x3 (rotation_kept z));
                          (fun z => x1 (baseline_kept z)); (fun z => x2 (baseline_kept z));
                            (fun z => x3 (baseline_kept z))].

Lemma lin_of_lin2 n f : lin2 n 0 (fun z _ => f z : R) -> lin n f.
Proof. by case=> c [d e]; exists c => z; rewrite (e z z) /sum big_ord0 addr0. Qed.

Lemma globals_lin : Forall (lin 12) globals.
Proof.
have [r1 r2 r3] : vlin 12 0 (fun z _ => rotation_kept z).
  apply: vlin_add; apply: vlin_scale; first exact: omega_lin.
  by do 2!apply: vlin_rot; exact: omega_lin.
have [b1 b2 b3] : vlin 12 0 (fun z _ => baseline_kept z).
  apply: vlin_add; last by apply: vlin_scaler; apply: lin2_opp; exact: lin2_z.
  apply: vlin_add; apply: vlin_scale; first exact: dt_lin.
  by do 2!apply: vlin_rot; exact: dt_lin.
by do 6!(constructor; first exact: lin_of_lin2).
Qed.

Lemma A_add u w : A (add u w) = add (A u) (A w).
Proof. by rewrite /A !rot_add. Qed.
Lemma A_scale k u : A (scale k u) = scale k (A u).
Proof. by rewrite /A !rot_scale. Qed.
Lemma A_zero : A (vec0 R) = vec0 R.
Proof. by rewrite -{1}(scale_zero (0 : R)) A_scale; apply: vec_ext; rewrite /= mul0r. Qed.
Lemma A_turn u : A (turn (C i) u) = scale (Ni ^+ 2) (turn (C j) u).
Proof. by rewrite /A rot_conj rot_scale. Qed.
Lemma A_cross u w : cross (A u) (A w) = scale (Ni * Nj) (A (cross u w)).
Proof. by rewrite /A !rot_cross norm_conj rot_scale scaleA mulrC. Qed.

Lemma baseline_nonzero : baseline <> vec0 R.
Proof.
move=> e; apply: centres; rewrite -/Ni -/Nj /centre.
have e1 : scale (Ni ^+ 2) (trans (C j)) = A (trans (C i)).
  exact: add_zero2 e.
by rewrite -rot_conj -/(A _) -e1 rot_scale.
Qed.

Lemma image_pose X : scale (Ni ^+ 2) (project (C j) X) = add (A (project (C i) X)) baseline.
Proof.
rewrite /project A_add A_turn /baseline; apply: vec_ext; rewrite /add /scale /=; ring.
Qed.

Lemma motion_pose z X d : rotation_kept z = vec0 R -> baseline_kept z = vec0 R ->
  scale (Ni ^+ 2) (d_project (C j) (twists z j) X d) = add (A (d_project (C i) (twists z i) X d))
    (scale (mu z) baseline).
Proof.
move=> r0 b0.
have e1 : scale (Ni * Nj) (omega (twists z j)) = A (omega (twists z i)).
  exact: add_zero2 r0.
have e2 : scale (Ni ^+ 2) (cross (omega (twists z j)) (turn (C j) X)) =
  A (cross (omega (twists z i)) (turn (C i) X)).
  apply: (@scale_inj _ (Ni * Nj)); first by move/eqP; rewrite mulf_eq0 => /orP[] /eqP; exact: norms.
  by rewrite -A_cross A_turn -e1 cross_scale scaleA.
have e3 : scale (Ni ^+ 2) (dt (twists z j)) = add (A (dt (twists z i))) (scale (mu z) baseline).
  exact: add_zero3 b0.
rewrite /d_project /d_turn !A_add A_turn -e2.
have -> (u w t : vec R) k : scale k (add (add u w) t) = add (add (scale k u) (scale k w)) (scale k t).
  by apply: vec_ext; rewrite /= !mulrDr.
by rewrite e3; apply: vec_ext; rewrite /= !addrA.
Qed.

Definition line1 (x : vec R) := Vec 0 (x3 x) (- x2 x).
Definition line2 (x : vec R) := Vec (- x3 x) 0 (x1 x).

(** If the image in view i is kept and one suitable equation in view j holds, so does the other. *)
Lemma epipolar z X d : rotation_kept z = vec0 R -> baseline_kept z = vec0 R ->
  let xi := project (C i) X in let xj := project (C j) X in
  let yi := d_project (C i) (twists z i) X d in let yj := d_project (C j) (twists z j) X d in
  x3 xi <> 0 -> dot (line1 xi) yi = 0 -> dot (line2 xi) yi = 0 ->
  dot (if dot (line1 xj) baseline == 0 then line2 xj else line1 xj) yj = 0 ->
  dot (line1 xj) yj = 0 /\ dot (line2 xj) yj = 0.
Proof.
move=> r0 b0 xi xj yi yj /eqP x30 h1 h2.
have N0 : Ni ^+ 2 != 0 by rewrite expf_neq0 //; apply/eqP; exact: norms.
have eq1 : scale (x3 xi) yi = scale (x3 yi) xi.
  apply: vec_ext; rewrite /=.
  - by apply/eqP; rewrite -subr_eq0 -[_ - _]opprK oppr_eq0 -h2 /line2 /dot /=; apply/eqP; ring.
  - by apply/eqP; rewrite -subr_eq0 -h1 /line1 /dot /=; apply/eqP; ring.
  - by rewrite mulrC.
have key l : dot l xj = 0 -> x3 xi * Ni ^+ 2 * dot l yj = (x3 xi * mu z - x3 yi) * dot l baseline.
  move=> lx; rewrite -mulrA -dot_scale motion_pose // -/yi dot_addr !dot_scale mulrDr.
  have -> : x3 xi * dot l (A yi) = - (x3 yi * dot l baseline).
    rewrite -dot_scale -A_scale eq1 A_scale dot_scale -mulrN; congr (_ * _).
    have : dot l (scale (Ni ^+ 2) xj) = 0 by rewrite dot_scale lx mulr0.
    by rewrite image_pose dot_addr => /eqP; rewrite addr_eq0 => /eqP.
  by ring.
have l1 : dot (line1 xj) xj = 0 by rewrite /line1 /dot /=; ring.
have l2 : dot (line2 xj) xj = 0 by rewrite /line2 /dot /=; ring.
have nz : x3 xi * Ni ^+ 2 != 0 by rewrite mulf_neq0.
case: eqP => [t0|/eqP t0] c.
  split=> //; apply: (mulfI nz); rewrite mulr0 key // t0 mulr0 //.
split=> //; apply: (mulfI nz); rewrite mulr0 key //.
have : (x3 xi * mu z - x3 yi) * dot (line1 xj) baseline == 0 by rewrite -key // c mulr0.
by rewrite mulf_eq0 (negbTE t0) orbF => /eqP ->; rewrite mul0r.
Qed.

(** ** The blocks *)
Definition moved (p : placed R) (_ : nat -> R) y : motion R := free_motion (kind p) y.
Definition both (k : nat) := sees_point (ft k) i && sees_point (ft k) j.
Definition chosen (p : placed R) v : (nat -> R) -> (nat -> R) -> R := let x := project (C v) (point p) in
  fun z y => dot (if dot (line1 x) baseline == 0 then line2 x else line1 x) (dx twists (moved p) C p v z y).
Definition view_forms (p : placed R) v := let l := looks (ft (kind p)) v in
  if same_view v j && both (kind p) then chosen p v :: pin_forms twists (moved p) C p v l
  else image_forms twists (moved p) C p v l.
Definition forms (p : placed R) := view_forms p V1 ++ view_forms p V2 ++ view_forms p V3.
Definition own (p : placed R) := dim3 (ft (kind p)).

Lemma view_forms_lin p v : Forall (lin2 12 (own p)) (view_forms p v).
Proof.
have h1 := @free_motion_dX_lin R 12 (kind p); have h2 := @free_motion_dD_lin R 12 (kind p).
rewrite /view_forms; case: ifP => _; last by apply: image_forms_lin => // v';
  [exact: omega_lin | exact: dt_lin].
constructor; last by apply: pin_forms_lin => // v'; [exact: omega_lin | exact: dt_lin].
by apply: lin2_dot; apply: dx_lin => // v'; [exact: omega_lin | exact: dt_lin].
Qed.

Lemma forms_lin p : Forall (lin2 12 (own p)) (forms p).
Proof. by apply/Forall_cat; split; [|apply/Forall_cat; split]; exact: view_forms_lin. Qed.

Lemma size_view_forms p v : (size (view_forms p v) + (same_view v j && both (kind p)) =
  if (looks (ft (kind p)) v).1 then 2 + size (looks (ft (kind p)) v).2
    else 2 * size (looks (ft (kind p)) v).2)%N.
Proof.
rewrite -(size_image_forms twists (moved p) C p v) /view_forms.
case: ifP => [/andP[/same_viewP -> /andP[_ sj]]|_]; last by rewrite addn0.
by rewrite /image_forms -/(sees_point _ _) sj addn1.
Qed.

Lemma size_forms p : (size (forms p) + both (kind p) = dim2 (ft (kind p)))%N.
Proof.
rewrite /dim2 /sees_point /sees_pins [LHS]/= [sumn _]/= addn0 -!size_view_forms /forms size_cat
  [X in (_ + X + _)%N]size_cat.
by move: (size _) (size _) (size _) => a1 a2 a3; case: (j); rewrite /= ?addn0;
  [rewrite addnAC|rewrite -addnA addnAC|]; rewrite -!addnA.
Qed.
End Epipolar.
