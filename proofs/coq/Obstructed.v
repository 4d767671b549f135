(** * Obstructed implies not rigid, at every admissible configuration over every integral domain *)
From Coq Require List.
From mathcomp Require Import all_ssreflect all_algebra.
From mathcomp.zify Require Import zify.
From mathcomp.algebra_tactics Require Import ring.
From PL1P Require Import Statement Rigid Walk System Blocks Epipolar Crowded.
Set Implicit Arguments.
Unset Strict Implicit.
Unset Printing Implicit Defensive.
Import GRing.Theory.
Local Open Scope ring_scope.

Section NotRigid.
Variable R : idomainType.
Notation Vec := (@Vec R).
Notation Forall := List.Forall.
Implicit Types (z y : nat -> R) (s : signature).
Variables (C : view -> camera R) (scene : seq (placed R)) (s : signature).
Hypothesis sh : shape scene s.
Hypothesis ad : admissible C scene.

Notation place n := (nth (p0 R) scene n).

(** ** Slides along a star *)
Lemma still_parallel (K : camera R) (T : twist R) p m l k :
  d_project K T (point p) (dX m) = scale k (project K (point p)) ->
  (forall j, j \in l.2 -> d_turn K T (dir p j) (dD m j) = vec0 R) -> all (pred1 0) (image_change K T p m l).
Proof.
move=> hp hd; rewrite /image_change hp all_cat; apply/andP; split.
  by case: l.1 => //=; rewrite /dot /scale /=; apply/and3P; split=> //; apply/eqP; ring.
elim: l.2 hd => // j js IH hd; rewrite map_cons -[flatten (_ :: _)]/(_ :: _ ++ flatten _).
rewrite -[all _ _]/(pred1 0 _ && all (pred1 0) (_ ++ flatten _)) all_cat; apply/and3P; split.
- by rewrite /d_line hd ?inE ?eqxx //= /dot /= !mulr0 !addr0.
- case: l.1 => //=; rewrite andbT /dot /line /cross /scale /=; apply/eqP; ring.
- by apply: IH => j' j'js; apply: hd; rewrite inE j'js orbT.
Qed.

Lemma scale_eq0 k (u : vec R) : scale k u = vec0 R -> x3 u <> 0 -> k = 0.
Proof. by case=> _ _ /eqP; rewrite mulf_eq0 => /orP[/eqP //|/eqP e /(_ e)]. Qed.

Lemma turn1 u : turn (C V1) u = u.
Proof. by case: ad => -> _ _ _ _; apply: vec_ext; rewrite /turn /rot /dot /=; ring. Qed.
Lemma project1 u : project (C V1) u = u.
Proof. by rewrite /project turn1; case: ad => -> _ _ _ _; apply: vec_ext; rewrite /= addr0. Qed.
Lemma trans1 : trans (C V1) = vec0 R.
Proof. by case: ad => ->. Qed.

Lemma only_one (h : nat -> nat) n1 n2 : (sumn [seq h (kind p) | p <- scene] <= 1)%N ->
  (n1 < size scene)%N -> (n2 < size scene)%N -> (0 < h (kind (place n1)))%N -> (0 < h (kind (place n2)))%N ->
    n1 = n2.
Proof.
have pos (l : seq (placed R)) n : (n < size l)%N ->
  (h (kind (nth (p0 R) l n)) <= sumn [seq h (kind p) | p <- l])%N.
  by elim: l n => [|p l IH] [|n] //= nl; [exact: leq_addr | exact: leq_trans (IH n nl) (leq_addl _ _)].
elim: scene n1 n2 => [|p l IH] [|n1] [|n2] //= le n1l n2l h1 h2.
- by have := pos l n2 n2l; lia.
- by have := pos l n1 n1l; lia.
- by congr S; apply: IH => //; lia.
Qed.

Lemma star_facts i : (i < 27)%N -> (3 <= pins (ft i))%N ->
  [/\ forall v, sees_point (ft i) v, free (ft i) = false, (6 <= weight i)%N & i != 11%N].
Proof.
move=> i27 p3.
have h : all (fun i => (3 <= pins (ft i)) ==> [&& all (sees_point (ft i)) views, ~~ free (ft i),
  6 <= weight i & i != 11])%N (iota 0 27) by vm_compute.
have := allP h i; rewrite mem_iota i27 p3 => /(_ isT) /and4P[/and4P[h1 h2 h3 _] /negbTE h4 h5 h6].
by split=> //; case.
Qed.

Lemma total_but i (g : nat -> nat) : (i < 27)%N ->
  total s g = (nth 0%N s i * g i + total s (fun k => if k == i then 0 else g k))%N.
Proof.
move=> i27; rewrite /total.
have : count (pred1 i) (iota 0 27) = 1%N by rewrite count_uniq_mem ?iota_uniq // mem_iota i27.
have key l : (sumn [seq nth 0 s k * g k | k <- l] =
  nth 0 s i * g i * count (pred1 i) l + sumn [seq nth 0 s k * (if k == i then 0 else g k) | k <- l])%N.
  elim: l => [|k l IH]; first by rewrite muln0.
  rewrite [LHS]/= [count _ _]/= [X in (_ + X)%N]/= IH mulnDr.
  by case: (eqVneq k i) => [->|/negbTE ne] /=; rewrite ?eqxx ?ne ?muln1 ?muln0; lia.
by rewrite key => ->; rewrite muln1.
Qed.

Section Star.
Variables (i0 ns : nat).
Hypotheses (i27 : (i0 < 27)%N) (p3 : (3 <= pins (ft i0))%N) (nsl : (ns < size scene)%N)
  (ks : kind (place ns) = i0).
Hypothesis bs : balanced s.
Let X := point (place ns).

Lemma star_image v : x3 (project (C v) X) <> 0.
Proof. by apply: (point_seen ad nsl erefl); rewrite ks; case: (star_facts i27 p3). Qed.
Lemma star_point : x3 X <> 0.
Proof. by rewrite -{1}(project1 X); exact: star_image. Qed.

Lemma one_star : nth 0%N s i0 = 1%N.
Proof.
have /andP[_ /eqP b] := bs; have [_ _ w _] := star_facts i27 p3.
have pos : (0 < nth 0 s i0)%N.
  rewrite (count_scene sh i27) -has_count; apply/(has_nthP (p0 R)); exists ns => //; by rewrite ks.
by have := total_but weight i27; rewrite b; nia.
Qed.

(** *** Case 1: some view shows nothing but the star *)
Section OneView.
Variable v : view.
Hypothesis only_star : shown s v = 1%N.

Definition push z (u : view) : vec R :=
  if same_view v V1 then scale (z 0%N) (turn (C u) X) else if same_view v u
    then scale (z 0%N) (project (C u) X) else vec0 R.
Definition slide1 z (u : view) : twist R :=
  if same_view u V1 then Twist (vec0 R) (vec0 R)
    else Twist (vec0 R) (add (push z u) (scale (z 1%N) (trans (C u)))).
Definition follow1 (p : placed R) z (_ : nat -> R) : motion R :=
  Motion (add (scale (if same_view v V1 then - z 0%N else 0) X) (scale (z 1%N) (point p))) (fun _ => vec0 R).

Lemma slide_one_view : ~ rigid C scene.
Proof.
have hid n : (n < size scene)%N ->
  n = ns \/ (~~ sees_point (ft (kind (place n))) v /\ sees_pins (ft (kind (place n))) v = [::]).
  move=> nl; pose h k : nat := sees_point (ft k) v || (0 < size (sees_pins (ft k) v))%N.
  case e: (h (kind (place n))) => [|k]; last first.
    left; apply: (@only_one h) => //; rewrite ?e //.
      by rewrite (sumn_scene h sh) -/(shown s v) only_star.
    by rewrite /h ks; case: (star_facts i27 p3) => ->.
  right; move: e; rewrite /h; case: (sees_point _ _) => //=.
  by case: (sees_pins _ _).
apply: (@not_rigid R C scene 2 [:: (fun z => x1 (dt (slide1 z V2)))] (fun _ => 0%N)
  (fun _ => [::]) slide1 follow1).
- constructor; last by constructor.
  apply: lin_of_lin2; rewrite /slide1 /=; apply: lin2_add.
    rewrite /push; case: (same_view _ _); last case: (same_view _ _); last exact: lin2_0;
      by apply: lin2_mulr; exact: lin2_z.
  by apply: lin2_mulr; exact: lin2_z.
- by move=> p; constructor.
- by rewrite /=; elim: scene => //= p l; rewrite !addn0.
- by move=> z /List.Forall_cons_iff[h _]; split.
- move=> z _ n nl y _; split.
    split=> // fr; case: (hid n nl) => [e|[e1 e2]].
      by move: fr; rewrite e ks; case: (star_facts i27 p3) => _ ->.
    have := scene_kind sh nl; move: fr e1 e2; move: (kind _) => k fr _ e2 k27.
    have h : all (fun k => free (ft k) ==> all (fun v => 0 < size (sees_pins (ft k) v))%N views) (iota 0 27)
      by vm_compute.
    have := allP h k; rewrite mem_iota k27 fr => /(_ isT) /and4P[h1 h2 h3 _].
    by move: e2 h1 h2 h3; case: (v) => ->.
  move=> u; rewrite /still.
  have turned q : d_turn (C u) (slide1 z u) q (vec0 R) = vec0 R.
    have r0 (w : quat R) : rot w (vec0 R) = vec0 R by case: w => *; apply: vec_ext;
      rewrite /rot /dot /= !mulr0 !addr0.
    rewrite /d_turn /turn r0 /slide1; case: ifP => _; apply: vec_ext; rewrite /= ?mul0r ?subrr ?addr0 //.
  have unseen : n <> ns -> u = v ->
    all (pred1 0) (image_change (C u) (slide1 z u) (place n) (follow1 (place n) z y)
      (looks (ft (kind (place n))) u)).
    move=> ne ->; case: (hid n nl) => [//|[/negbTE e1 e2]].
    by rewrite /image_change -/(sees_point _ _) e1 -/(sees_pins _ _) e2.
  have moves : d_project (C u) (slide1 z u) (point (place n)) (dX (follow1 (place n) z y)) =
      if same_view v V1 then if same_view u V1 then add (scale (- z 0%N) X) (scale (z 1%N) (point (place n)))
        else scale (z 1%N) (project (C u) (point (place n)))
      else add (if same_view v u then scale (z 0%N) (project (C u) X) else vec0 R)
        (scale (z 1%N) (project (C u) (point (place n)))).
    rewrite /d_project /d_turn /follow1 /slide1 /push.
    case: (same_viewP v V1) => [vv|vv].
      case: (same_viewP u V1) => [->|uu]; first by rewrite !turn1; apply: vec_ext; rewrite /=; ring.
      by rewrite /turn rot_add !rot_scale /project /turn; apply: vec_ext; rewrite /=; ring.
    rewrite /turn rot_add !rot_scale.
    case: (same_viewP u V1) => [uu|uu].
      rewrite uu; case: (same_viewP v V1) => [e|_]; first by case: vv.
      by rewrite project1 -/(turn _ _) turn1; apply: vec_ext; rewrite /= -/(turn _ _) ?turn1; ring.
    by rewrite /project /turn; case: (same_view v u); apply: vec_ext; rewrite /=; ring.
  case: (same_viewP u v) => [uv|uv].
    case: (eqVneq n ns) => [en|/eqP ne]; last exact: unseen.
    apply: (@still_parallel _ _ _ _ _ (if same_view v V1 then z 1%N - z 0%N else z 0%N + z 1%N)) => //.
    rewrite moves uv en -/X; case: (same_viewP v V1) => [->|vv].
      by rewrite project1; apply: vec_ext; rewrite /=; ring.
    by rewrite (introT (same_viewP v v) erefl); apply: vec_ext; rewrite /=; ring.
  apply: (@still_parallel _ _ _ _ _ (z 1%N)) => //.
  rewrite moves; case: (same_viewP v V1) => [vv|vv].
    by case: (same_viewP u V1) => [uu|//]; case: uv; rewrite uu vv.
  case: (same_viewP v u) => [e|_]; first by case: uv.
  by apply: vec_ext; rewrite /= add0r.
- move=> z _ T0 m0; have [y hX] := m0 ns nsl; move: hX; rewrite /follow1 /= -/X => hX.
  have t2 : dt (slide1 z V2) = vec0 R by rewrite T0.
  have t3 : dt (slide1 z V3) = vec0 R by rewrite T0.
  have [a0 c0] : z 0%N = 0 /\ z 1%N = 0.
    move: hX t2 t3; rewrite /slide1 /push /=; case: (v) => /= hX t2 t3.
    + have e : z 1%N - z 0%N = 0.
        by apply: (scale_eq0 (u := X)) star_point; rewrite -hX; apply: vec_ext; rewrite /=; ring.
      move/subr0_eq: e => e; have c0 : z 1%N = 0.
        apply: (@scale_eq0 _ (project (C V2) X) _ (@star_image V2)).
        by rewrite -t2 -e /project; apply: vec_ext; rewrite /=; ring.
      by rewrite -e.
    + have c0 : z 1%N = 0.
        by apply: (scale_eq0 (u := X)) star_point; rewrite -hX; apply: vec_ext; rewrite /=; ring.
      split=> //; apply: (@scale_eq0 _ (project (C V2) X) _ (@star_image V2)).
      by rewrite -t2 c0; apply: vec_ext; rewrite /=; ring.
    + have c0 : z 1%N = 0.
        by apply: (scale_eq0 (u := X)) star_point; rewrite -hX; apply: vec_ext; rewrite /=; ring.
      split=> //; apply: (@scale_eq0 _ (project (C V3) X) _ (@star_image V3)).
      by rewrite -t3 c0; apply: vec_ext; rewrite /=; ring.
  by case=> [|[|]].
- by move=> z _ n nl y _ _ j.
Qed.
End OneView.

(** *** Case 2: all three cameras slide; a free line, or one more feature, does not stop them *)
Section ThreeSlides.
Variable fl : bool.     (* use the short block for free lines? *)
Hypothesis enough : if fl then weight i0 = 9%N /\ nth 0%N s 11 = 1%N else weight i0 = 10%N.

Definition slide3 z (u : view) : twist R := match u with
  | V1 => Twist (vec0 R) (vec0 R)
  | V2 => Twist (vec0 R) (add (scale (z 0%N) (project (C V2) X)) (scale (z 2%N) (trans (C V2))))
  | V3 => Twist (vec0 R) (add (scale (z 1%N) (project (C V3) X)) (scale (z 2%N) (trans (C V3))))
  end.
Definition short k := fl && (k == 11%N).
Definition follow3 (p : placed R) z y : motion R :=
  if kind p == i0 then Motion (scale (z 2%N) X) (fun _ => vec0 R)
  else if short (kind p) then Motion (Vec (y 0%N) (y 1%N) 0) (fun _ => vec0 R)
  else free_motion (kind p) y.
Definition own3 (k : nat) : nat := if k == i0 then 0%N else if short k then 2%N else dim3 (ft k).
Definition forms3 (p : placed R) : seq ((nat -> R) -> (nat -> R) -> R) :=
  if kind p == i0 then [::]
  else if short (kind p) then [seq (fun z y => dot (line (C v) p 0) (dx slide3 (follow3 p) C p v z y)) | v <-
    views]
  else all_forms slide3 (follow3 p) C p.
Definition size3 (k : nat) : nat := if k == i0 then 0%N else if short k then 3%N else dim2 (ft k).

Lemma slide3_omega u v : vlin 3 u (fun z _ => omega (slide3 z v)).
Proof. by case: v; exact: vlin_0. Qed.
Lemma slide3_dt u v : vlin 3 u (fun z _ => dt (slide3 z v)).
Proof. by case: v; [exact: vlin_0| |]; apply: vlin_add; apply: vlin_scaler; exact: lin2_z. Qed.

Lemma follow3_dX p : vlin 3 (own3 (kind p)) (fun z y => dX (follow3 p z y)).
Proof.
rewrite /follow3 /own3; case: ifP => _; first by apply: vlin_scaler; exact: lin2_z.
case: ifP => _; last exact: free_motion_dX_lin.
by split=> /=; [exact: lin2_y|exact: lin2_y|exact: lin2_0].
Qed.
Lemma follow3_dD p j : vlin 3 (own3 (kind p)) (fun z y => dD (follow3 p z y) j).
Proof.
rewrite /follow3 /own3; case: ifP => _; first exact: vlin_0.
by case: ifP => _; [exact: vlin_0 | exact: free_motion_dD_lin].
Qed.

Lemma forms3_lin p : Forall (lin2 3 (own3 (kind p))) (forms3 p).
Proof.
rewrite /forms3; case: ifP => _; first by constructor.
have h v : vlin 3 (own3 (kind p)) (dx slide3 (follow3 p) C p v).
  by apply: dx_lin; [exact: slide3_omega|exact: slide3_dt|exact: follow3_dX].
case: ifP => _; first by do 3!(constructor; first by apply: lin2_dot; exact: h).
by apply: all_forms_lin; [exact: slide3_omega|exact: slide3_dt|exact: follow3_dX|exact: follow3_dD].
Qed.

Lemma size_forms3 p : size (forms3 p) = size3 (kind p).
Proof. by rewrite /forms3 /size3; case: ifP => // _; case: ifP => // _; rewrite size_all_forms. Qed.

Lemma count3 : (1 + total s size3 < 3 + total s own3)%N.
Proof.
have /andP[_ /eqP b] := bs.
have [_ _ _ i11] := star_facts i27 p3.
have split11 (g : nat -> nat) : total s (fun k => if k == i0 then 0 else g k)%N =
    (nth 0 s 11 * g 11 + total s (fun k => if k == i0 then 0 else if k == 11 then 0 else g k))%N.
  rewrite (@total_but 11%N) // eq_sym (negbTE i11); congr addn; apply: total_eq => k _.
  by case: eqP => //; case: eqP.
have w11 : weight 11 = 2%N by vm_compute.
have s3 : total s size3 = (nth 0 s 11 * (if fl then 3 else dim2 (ft 11)) + total s (fun k => if k == i0 then 0
  else if k == 11 then 0 else dim2 (ft k)))%N.
  rewrite (@total_but i0) // [in size3 i0]/size3 eqxx muln0 add0n.
  rewrite (@total_eq _ _ (fun k => if k == i0 then 0 else if short k then 3 else dim2 (ft k))%N); last first.
    by move=> k _; rewrite /size3; case: eqP.
  rewrite split11 /short eqxx andbT; congr addn; apply: total_eq => k _.
  by case: eqP => // _; case: eqP => //; rewrite andbF.
have o3 : total s own3 = (nth 0 s 11 * (if fl then 2 else dim3 (ft 11)) + total s (fun k => if k == i0 then 0
  else if k == 11 then 0 else dim3 (ft k)))%N.
  rewrite (@total_but i0) // [in own3 i0]/own3 eqxx muln0 add0n.
  rewrite (@total_eq _ _ (fun k => if k == i0 then 0 else if short k then 2 else dim3 (ft k))%N); last first.
    by move=> k _; rewrite /own3; case: eqP.
  rewrite split11 /short eqxx andbT; congr addn; apply: total_eq => k _.
  by case: eqP => // _; case: eqP => //; rewrite andbF.
have bb : total s weight = (weight i0 +
  (nth 0 s 11 * 2 + total s (fun k => if k == i0 then 0 else if k == 11 then 0 else weight k)))%N.
  by rewrite (@total_but i0) // one_star mul1n split11 w11.
have dd : total s (fun k => if k == i0 then 0 else if k == 11 then 0 else dim2 (ft k))%N =
    (total s (fun k => if k == i0 then 0 else if k == 11 then 0 else weight k) + total s
      (fun k => if k == i0 then 0 else if k == 11 then 0 else dim3 (ft k)))%N.
  rewrite -total_add; apply: total_eq => k k27.
  by case: eqP => // _; case: eqP => // _; rewrite dim2E.
have [d2 d3] : dim2 (ft 11) = 6%N /\ dim3 (ft 11) = 4%N by split; vm_compute.
rewrite s3 o3 dd d2 d3; rewrite b in bb; move: enough bb.
by case: (fl) => [[-> ->]| ->]; lia.
Qed.

Lemma slide_three : ~ rigid C scene.
Proof.
have [seen nfree w6 i11] := star_facts i27 p3.
have r0 (w : quat R) : rot w (vec0 R) = vec0 R by case: w => *; apply: vec_ext;
  rewrite /rot /dot /= !mulr0 !addr0.
have turned u z q : d_turn (C u) (slide3 z u) q (vec0 R) = vec0 R.
  by rewrite /d_turn /turn r0; case: u; apply: vec_ext; rewrite /= ?mul0r ?subrr ?addr0.
apply: (@not_rigid R C scene 3 [:: (fun z => x1 (dt (slide3 z V2)))] (fun p => own3 (kind p)) forms3 slide3
  follow3).
- constructor; last by constructor.
  by apply: lin_of_lin2; have [] := slide3_dt 0 V2.
- exact: forms3_lin.
- rewrite (eq_map size_forms3) (sumn_scene size3 sh) (sumn_scene own3 sh); exact: count3.
- by move=> z /List.Forall_cons_iff[h _]; split.
- move=> z _ n nl y; rewrite /forms3; case: (eqVneq (kind (place n)) i0) => [e _|ne].
    have -> : n = ns.
      apply: (@only_one (fun k => k == i0 : nat)) => //; rewrite ?e ?ks ?eqxx //.
      rewrite (sumn_scene (fun k => k == i0 : nat) sh) (@total_but i0) // one_star eqxx muln1.
      rewrite (@total_eq _ _ (fun _ => 0%N)); last by move=> k _; case: eqP.
      by rewrite /total; elim: (iota 0 27) => //= k l; rewrite muln0.
    rewrite /follow3 ks eqxx; split; first by split=> //; rewrite ks nfree.
    move=> v; rewrite /still; apply:
      (@still_parallel _ _ _ _ _ (match v with V1 => z 2%N | V2 => z 0%N + z 2%N | V3 => z 1%N + z 2%N end)).
      rewrite /= -/X /d_project /d_turn /turn rot_scale /project /turn.
      case: v; apply: vec_ext; rewrite /= ?trans1 /turn /=; ring.
    by move=> j _; exact: turned.
  rewrite /follow3 (negbTE ne); case: ifP => sk.
    move=> hf; split; first by split.
    move: hf => /List.Forall_cons_iff[h1 /List.Forall_cons_iff[h2 /List.Forall_cons_iff[h3 _]]].
    rewrite sk in h1 h2 h3; move: (sk) => /andP[_ /eqP k11] v; rewrite /still /image_change k11.
    have -> : looks (ft 11) v = (false, [:: 0%N]) by case: v.
    rewrite /= andbT; apply/andP; split.
      by rewrite /d_line turned /dot /= !mulr0 !addr0.
    by case: v; apply/eqP; [exact: h1 | exact: h2 | exact: h3].
  move=> hf; split; first exact: free_motion_gauge.
  move=> v; have := all_forms_still hf v.
  by rewrite /still sk.
- move=> z _ T0 m0; have [y hX] := m0 ns nsl; move: hX; rewrite /follow3 ks eqxx /= => hX.
  have c0 : z 2%N = 0 := scale_eq0 hX star_point.
  have t2 : dt (slide3 z V2) = vec0 R by rewrite T0.
  have t3 : dt (slide3 z V3) = vec0 R by rewrite T0.
  have a0 : z 0%N = 0.
    apply: (@scale_eq0 _ (project (C V2) X) _ (@star_image V2)).
    by rewrite -t2 /= c0; apply: vec_ext; rewrite /=; ring.
  have b0 : z 1%N = 0.
    apply: (@scale_eq0 _ (project (C V3) X) _ (@star_image V3)).
    by rewrite -t3 /= c0; apply: vec_ext; rewrite /=; ring.
  by case=> [|[|[|]]].
- move=> z _ n nl y; rewrite /follow3 /own3; case: ifP => // ne; case: ifP => sk.
    by case/vec_eq0 => h1 h2 _ _ [|[|]].
  by move=> d1 d2 k kl; exact: free_motion_zero d1 d2 k kl.
Qed.
End ThreeSlides.
End Star.

Theorem obstructed_not_rigid : balanced s -> obstructed s -> ~ rigid C scene.
Proof.
move=> bs /orP[|].
  by rewrite /crowded /= orbF => /or3P[]; exact: (crowded_pair sh ad).
case/hasP=> i; rewrite mem_iota => /andP[_ i27] /and3P[si p3 why].
have [ns nsl ks] : exists2 n, (n < size scene)%N & kind (place n) = i.
  move: si; rewrite (count_scene sh i27) -has_count => /(has_nthP (p0 R))[n nl /eqP e].
  by exists n.
have /andP[_ /eqP b] := bs.
have one := one_star i27 p3 nsl ks bs.
case/or3P: why => [/eqP p7|/andP[/eqP p6 fr]|].
- apply: (@slide_three i ns i27 p3 nsl ks bs false).
  have h : all (fun i => (pins (ft i) == 7) ==> (weight i == 10))%N (iota 0 27) by vm_compute.
  by have := allP h i; rewrite mem_iota i27 p7 => /(_ isT) /eqP.
- apply: (@slide_three i ns i27 p3 nsl ks bs true).
  have h : all (fun i => (pins (ft i) == 6) ==> (weight i == 9))%N (iota 0 27) by vm_compute.
  have := allP h i; rewrite mem_iota i27 p6 => /(_ isT) /eqP w9; split=> //.
  have hf : all (fun k => free (ft k) == (k == 11))%N (iota 0 27) by vm_compute.
  move: fr; rewrite (@total_but 11%N) // (@total_eq _ _ (fun _ => 0%N)); last first.
    move=> k k27; have := allP hf k; rewrite mem_iota k27 => /(_ isT) /eqP ->.
    by case: eqP.
  have -> : total s (fun _ => 0%N) = 0%N by rewrite /total; elim: (iota 0 27) => //= k l; rewrite muln0.
  rewrite addn0 muln1 => f0.
  have [_ _ _ i11] := star_facts i27 p3.
  move: b; rewrite (@total_but i) // (@total_but 11%N) // one w9 eq_sym (negbTE i11).
  by rewrite -[weight 11]/2%N; lia.
- have hv v : shown s v == 1%N -> ~ rigid C scene by move=> /eqP only;
    exact: (slide_one_view i27 p3 nsl ks only).
  by rewrite /= orbF => /or3P[]; exact: hv.
Qed.
End NotRigid.
