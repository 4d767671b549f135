(** * A derivation moves a configuration, and every motion is that of a derivation

    Let D be a derivation of K, and let cameras and scene have coordinates in K. Where D changes the
    quaternion q = (1, r) by (0, dr), it changes the rotation times its norm by a twist omega and a
    factor rho; the factor moves no image point. So D gives a motion in the sense of Rigid.v, and D
    kills the image coordinates if and only if the motion changes no image ([image_killed]). *)
From mathcomp Require Import all_ssreflect all_algebra.
From mathcomp.algebra_tactics Require Import ring.
From PL1P Require Import Statement Rigid Derivations Epipolar.
Set Implicit Arguments.
Unset Strict Implicit.
Unset Printing Implicit Defensive.
Import GRing.Theory.
Local Open Scope ring_scope.

Lemma all_flatten A (q : pred A) ss : all q (flatten ss) = all (all q) ss.
Proof. by elim: ss => //= s ss IH; rewrite all_cat IH. Qed.

(** The image of a placed feature, as in Statement.v. *)
Definition placed_image (K : fieldType) (C : camera K) p (l : look) : seq K :=
  let x := project C (point p) in
  (if l.1 then [:: x1 x / x3 x; x2 x / x3 x] else [::]) ++
  flatten [seq let n := line C p j in
    if l.1 then [:: x1 n / x2 n] else [:: x1 n / x3 n; x2 n / x3 n] | j <- l.2].

Section Motion.
Variables (F K : fieldType) (c : {rmorphism F -> K}) (D : K -> K).
Hypothesis hD : derivation c D.
Notation Vec := (@Vec K).
Implicit Types (u w x e l : vec K).

Definition dvec u := Vec (D (x1 u)) (D (x2 u)) (D (x3 u)).

Lemma dot_sym u w : dot u w = dot w u. Proof.
by rewrite /dot ![_ * x1 w]mulrC ![_ * x2 w]mulrC ![_ * x3 w]mulrC. Qed.
Lemma proportional l u : D (x1 l) * x3 l - x1 l * D (x3 l) = 0 -> D (x2 l) * x3 l - x2 l * D (x3 l) = 0 ->
  x3 l * dot (dvec l) u = D (x3 l) * dot l u.
Proof.
case: l => a b f; case: u => u v w /= h1 h2; apply/eqP; rewrite -subr_eq0; apply/eqP.
transitivity ((D a * f - a * D f) * u + (D b * f - b * D f) * v); first by rewrite /dot /dvec /=; ring.
by rewrite h1 h2 !mul0r addr0.
Qed.
Lemma parallel l : cross l (dvec l) = vec0 K -> 
  [/\ D (x1 l) * x3 l - x1 l * D (x3 l) = 0, D (x2 l) * x3 l - x2 l * D (x3 l) = 0 &
      D (x1 l) * x2 l - x1 l * D (x2 l) = 0].
Proof.
case: l => a b f; rewrite /cross /dvec /= => -[z1 z2 z3]; split.
- by apply: etrans z2; ring.
- by rewrite -[LHS]opprK -[X in - X = _](_ : b * D f - f * D b = _); [rewrite z1 oppr0 | ring].
- by rewrite -[LHS]opprK -[X in - X = _](_ : a * D b - b * D a = _); [rewrite z3 oppr0 | ring].
Qed.

Lemma slope_identity l x e : D (x1 l) * x2 l - x1 l * D (x2 l) = 0 -> dot (dvec l) x = 0 -> dot l x = 0 ->
  dot l e = 0 ->
  x3 x * (x2 l * dot (dvec l) e) = 0.
Proof.
case: l => l1 l2 l3; case: x => a b f; case: e => u v w /= h hx lx le.
transitivity ((D l1 * l2 - l1 * D l2) * (f * u - a * w) + w * (l2 * dot (dvec (Vec l1 l2 l3)) (Vec a b f) -
  D l2 * dot (Vec l1 l2 l3) (Vec a b f)) + f * D l2 * dot (Vec l1 l2 l3) (Vec u v w)).
  rewrite /dot /dvec /=; ring.
by rewrite h hx lx le !mulr0 mul0r subr0 mulr0 !addr0.
Qed.

(** ** One view: x is the point in the frame of the camera, e a direction *)
Section View.
Variables (x e : vec K) (al be : K).
Let dx := add (dvec x) (scale al x).
Let de := add (dvec e) (scale be e).
Let l := cross x e.

Lemma div_killed (a b : K) : b != 0 -> (D (a / b) == 0) = (D a * b - a * D b == 0).
Proof. by move=> b0; rewrite (der_div hD) // mulf_eq0 invr_eq0 expf_eq0 /= (negbTE b0) orbF. Qed.

Lemma point_killed : x3 x != 0 ->
  (D (x1 x / x3 x) == 0) && (D (x2 x / x3 x) == 0) =
  (dot (Vec 0 (x3 x) (- x2 x)) dx == 0) && (dot (Vec (- x3 x) 0 (x1 x)) dx == 0).
Proof.
move=> x30; rewrite !div_killed // andbC; congr (_ && _).
  by congr (_ == 0); rewrite /dot /=; ring.
by rewrite -[LHS]oppr_eq0; congr (_ == 0); rewrite /dot /=; ring.
Qed.

Lemma l_x : dot l x = 0. Proof. rewrite /l /dot /=; ring. Qed.
Lemma l_e : dot l e = 0. Proof. rewrite /l /dot /=; ring. Qed.
Lemma d_dot u w : D (dot u w) = dot (dvec u) w + dot u (dvec w).
Proof. by rewrite /dot /= !(derD hD) !(derM hD); ring. Qed.
Lemma dl_x : dot (dvec l) x = - dot l (dvec x).
Proof. by apply/eqP; rewrite -addr_eq0 -d_dot l_x (der0 hD). Qed.
Lemma dl_e : dot (dvec l) e = - dot l (dvec e).
Proof. by apply/eqP; rewrite -addr_eq0 -d_dot l_e (der0 hD). Qed.
Lemma l_dx : dot l dx = dot l (dvec x).
Proof.
by rewrite -[RHS]addr0 -(mulr0 al) -l_x /dx /dot /=; ring.
Qed.
Lemma l_de : dot l de = dot l (dvec e).
Proof.
by rewrite -[RHS]addr0 -(mulr0 be) -l_e /de /dot /=; ring.
Qed.

(** l x Dl, coordinate by coordinate, by the two conditions on the motion. *)
Lemma cross_dl : cross l (dvec l) =
  add (scale (- dot l (dvec x)) e) (scale (dot l (dvec e)) x).
Proof.
have -> : dvec l = add (cross (dvec x) e) (cross x (dvec e)).
  by rewrite /dvec /l /cross /add /= !(derB hD) !(derM hD); congr Vec; ring.
rewrite /l /cross /add /scale /dot /=; congr Vec; ring.
Qed.

Lemma line_killed : x3 l != 0 ->
  (D (x1 l / x3 l) == 0) && (D (x2 l / x3 l) == 0) = (dot l de == 0) && (dot l dx == 0).
Proof.
move=> l30; rewrite !div_killed // l_dx l_de; apply/andP/andP => -[/eqP h1 /eqP h2].
  split; rewrite -oppr_eq0 -?dl_x -?dl_e.
    by have := proportional e h1 h2; rewrite l_e mulr0 => /eqP; rewrite mulf_eq0 (negbTE l30).
  by have := proportional x h1 h2; rewrite l_x mulr0 => /eqP; rewrite mulf_eq0 (negbTE l30).
have [|h3 h4 _] := @parallel l; last by rewrite h3 h4.
by rewrite cross_dl h1 h2 /add /scale /vec0 /= oppr0 !mul0r addr0.
Qed.

(** The line through a point that the motion keeps. *)
Lemma slope_killed : x3 x != 0 -> x2 l != 0 ->
  (dot (Vec 0 (x3 x) (- x2 x)) dx == 0) && (dot (Vec (- x3 x) 0 (x1 x)) dx == 0) ->
  (D (x1 l / x2 l) == 0) = (dot l de == 0).
Proof.
move=> x30 l20; rewrite -point_killed // !div_killed // => /andP[/eqP h1 /eqP h2].
have lx : dot l (dvec x) = 0.
  by apply/eqP; have := proportional l h1 h2; rewrite dot_sym (dot_sym x) l_x mulr0 => /eqP;
    rewrite mulf_eq0 (negbTE x30).
rewrite l_de; apply/eqP/eqP => h; last first.
  by have [|_ _ ->] := @parallel l; rewrite // cross_dl lx h /add /scale /vec0 /= oppr0 !mul0r addr0.
apply/eqP; rewrite -oppr_eq0 -dl_e; have dlx : dot (dvec l) x = 0 by rewrite dl_x lx oppr0.
have /eqP := slope_identity h dlx l_x l_e.
by rewrite !mulf_eq0 (negbTE x30) (negbTE l20).
Qed.
End View.

(** ** A placed feature in one view *)
Section Feature.
Variables (C : camera K) (T : twist K) (p : placed K) (m : motion K) (al be : K).
Variable x : vec K.
Hypothesis xE : x = project C (point p).
Hypothesis x_moved : d_project C T (point p) (dX m) = add (dvec x) (scale al x).
Variable l : look.
Hypothesis dir_moved : forall j, j \in l.2 ->
  d_turn C T (dir p j) (dD m j) = add (dvec (turn C (dir p j))) (scale be (turn C (dir p j))).
Hypothesis x_seen : l.1 -> x3 x != 0.
Hypothesis n_seen : forall j, j \in l.2 -> (x2 (line C p j) != 0) && (x3 (line C p j) != 0).

Lemma image_killed : all (fun a => D a == 0) (placed_image C p l) = all (pred1 0) (image_change C T p m l).
Proof.
rewrite /placed_image /image_change !all_cat x_moved -xE !all_flatten !all_map.
have lE j : line C p j = cross x (turn C (dir p j)) by rewrite /line -xE.
have [seen|_] := boolP l.1.
  rewrite /= !andbT (point_killed al (x_seen seen)).
  set g := (dot _ _ == 0) && (dot _ _ == 0); case e: g => //=; apply: eq_in_all => j jl.
  transitivity (D (x1 (line C p j) / x2 (line C p j)) == 0); first exact: andbT.
  transitivity (d_line C T p m j == 0); last exact/esym/andbT.
  by rewrite /d_line dir_moved // lE; apply: slope_killed (x_seen seen) _ e; have /andP[] := n_seen jl;
    rewrite lE.
apply: eq_in_all => j jl; set n := line C p j.
transitivity ((D (x1 n / x3 n) == 0) && (D (x2 n / x3 n) == 0)); first by rewrite /= andbT.
transitivity ((d_line C T p m j == 0) && (dot n (add (dvec x) (scale al x)) == 0)); last by rewrite /= andbT.
by rewrite /d_line dir_moved // /n lE; apply: line_killed; have /andP[] := n_seen jl; rewrite lE.
Qed.
End Feature.

(** ** The motion of a derivation *)
Definition cayley (r : vec K) := @Quat K 1 (x1 r) (x2 r) (x3 r).
Definition size2 r := norm (cayley r).
Definition spin r := scale (2%:R / size2 r) (add (dvec r) (cross r (dvec r))).
Definition stretch r := D (size2 r) / size2 r.
Lemma size2E r : size2 r = 1 + dot r r.
Proof. by rewrite /size2 /norm /dot /=; ring. Qed.

Lemma turn_moved r u : size2 r != 0 ->
  add (cross (spin r) (rot (cayley r) u)) (rot (cayley r) (dvec u)) =
  add (dvec (rot (cayley r) u)) (scale (- stretch r) (rot (cayley r) u)).
Proof.
move=> n0; have D1 := der1 hD.
have e : D (size2 r) = (dot r (dvec r)) *+ 2.
  by rewrite size2E (derD hD) d_dot D1 /dot /=; ring.
rewrite /spin /stretch e; move: n0; rewrite size2E.
case: r {e} => b f g; case: u => u v w.
rewrite /add /scale /cross /dvec /rot /cayley /dot /= !(derD hD, derB hD, derN hD, derM hD, D1) => n0.
by congr Vec; field.
Qed.

Hypothesis two : 2%:R != 0 :> K.
Lemma spin_zero r : size2 r != 0 -> spin r = vec0 K -> dvec r = vec0 K.
Proof.
move=> n0 e; apply: (scale_inj (k := size2 r)); first exact/eqP.
set w := add (dvec r) (cross r (dvec r)).
have -> : scale (size2 r) (dvec r) = add (add w (scale (-1) (cross r w))) (scale (dot r w) r).
  rewrite /w size2E; case: r {n0 e w} => b f g; case: (dvec _) => u v z.
  by rewrite /add /scale /cross /dot /=; congr Vec; ring.
have -> : w = vec0 K.
  apply: (scale_inj (k := 2%:R / size2 r)); last by rewrite scale_zero.
  by apply/eqP; rewrite mulf_neq0 ?invr_eq0.
by rewrite /add /scale /cross /dot /vec0 /=; congr Vec; ring.
Qed.

Lemma stretch_zero r : dvec r = vec0 K -> stretch r = 0.
Proof.
move=> e; rewrite /stretch size2E (derD hD) d_dot e (der1 hD).
by rewrite (_ : dot (vec0 K) r + dot r (vec0 K) = 0) ?addr0 ?mul0r // /dot /vec0 /=; ring.
Qed.

(** The change of r that gives the twist om. *)
Definition unspin (om r : vec K) := scale 2%:R^-1 (add (add om (cross om r)) (scale (dot om r) r)).
Lemma spin_unspin (om r : vec K) : size2 r != 0 -> dvec r = unspin om r -> spin r = om.
Proof.
rewrite /spin => n0 ->; move: n0; rewrite size2E /unspin; case: r => b f g; case: om => u v z.
rewrite /add /scale /cross /dot /= => n0; congr Vec; field; by rewrite n0 two.
Qed.
Lemma stretch_unspin (om r : vec K) : size2 r != 0 -> dvec r = unspin om r -> stretch r = dot om r.
Proof.
rewrite /stretch => n0; rewrite [in D _]size2E (derD hD) (der1 hD) d_dot => ->.
move: n0; rewrite size2E /unspin; case: r => b f g; case: om => u v z.
rewrite /add /scale /cross /dot /= => n0; field; by rewrite n0 two.
Qed.
End Motion.
