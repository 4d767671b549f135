(** * At generic parameters no denominator is zero

    A polynomial in the parameters is not zero if it is not zero at one point: all cameras are
    [1 | t], a point is (1, 0, 1) and its pins have direction (3, 1, 1). *)
From mathcomp Require Import all_ssreflect all_algebra.
From mathcomp.algebra_tactics Require Import ring.
From SsrMultinomials Require Import mpoly.
From PL1P Require Import Statement Reducible.
Set Implicit Arguments.
Unset Strict Implicit.
Unset Printing Implicit Defensive.
Import GRing.Theory.
Local Open Scope ring_scope.

Section Natural.
Variables (R R' : idomainType) (g : {rmorphism R -> R'}).
Definition gvec (u : vec R) := @Vec R' (g (x1 u)) (g (x2 u)) (g (x3 u)).
Definition gcamera (C : camera R) := let: Camera (Quat a b c d) t := C in
  Camera (@Quat R' (g a) (g b) (g c) (g d)) (gvec t).
Lemma gturn C u : gvec (turn C u) = turn (gcamera C) (gvec u).
Proof.
case: C => [[a b c d] t]; rewrite /turn /rot /gvec /dot /=.
by rewrite !(rmorphB, rmorphD, rmorphM, rmorphMn, rmorphX).
Qed.
Lemma gproject C u : gvec (project C u) = project (gcamera C) (gvec u).
Proof. by rewrite /project -gturn; case: C => [[a b c d] t]; rewrite /gvec /= !rmorphD. Qed.
Lemma gnormal C u d : gvec (normal C u d) = normal (gcamera C) (gvec u) (gvec d).
Proof. by rewrite /normal -gproject -gturn /cross /gvec /= !rmorphB !rmorphM. Qed.
Variables (x : nat -> R) (x' : nat -> R').
Hypothesis gx : forall k, x' k = g (x k).
Lemma gcameras v : cameras_at R' x' v = gcamera (cameras_at R x v).
Proof. by case: v; rewrite /= /gvec /= ?(rmorph0, rmorph1) // -!gx. Qed.
End Natural.

Section Generic.
Variables (F : fieldType) (n o : nat) (f : feature).
Hypothesis char0 : [char F] =i pred0.
Notation K := [fieldType of {fraction {mpoly F[n]}}].
Notation P := [idomainType of {mpoly F[n]}].
Hypothesis o11 : (11 <= o)%N.
Hypothesis room : (o + dim3 f <= n)%N.
Hypothesis nf : free f = false.
Let to : {rmorphism P -> K} := [rmorphism of @FracField.tofrac _].
Definition xP k : P := if insub k is Some i then 'X_i else 0.
Lemma genericE k : generic F n k = to (xP k).
Proof. by rewrite /generic /xP; case: insub => // ; rewrite rmorph0. Qed.
(** The point, in terms of the number of a parameter. Parameter 9 moves camera 3, so that the three
    centres differ. *)
Definition value_at k : F := if (k < o)%N then (k == 9%N)%:R else let i := (k - o)%N in
  if i == 1%N then 0 else if odd i then 3%:R else 1.
Let ev : {rmorphism P -> F} := [rmorphism of meval (fun i : 'I_n => value_at i)].
Lemma evE k : (k < n)%N -> ev (xP k) = value_at k.
Proof. by move=> kn; rewrite /xP insubT /= mevalXU. Qed.
Definition xF k : F := ev (xP k).
Let own (R : idomainType) (x : nat -> R) k := x (o + k)%N.

Lemma small_F k : (k < 11)%N -> xF k = (k == 9%N)%:R.
Proof. by move=> h; rewrite /xF evE /value_at ?(leq_trans h o11) //; apply: leq_trans room;
  rewrite ltn_addr // (leq_trans h). Qed.
Lemma own_F k : (k < dim3 f)%N -> xF (o + k) = if k == 1%N then 0 else if odd k then 3%:R else 1.
Proof.
move=> h; rewrite /xF evE ?(leq_trans _ room) ?ltn_add2l // /value_at ltnNge leq_addr /=.
by rewrite addKn.
Qed.

Lemma nonzero (p : P) : ev p != 0 -> to p != 0.
Proof. by apply: contraNneq => /eqP; rewrite tofrac_eq0 => /eqP ->; rewrite rmorph0. Qed.

Let CF v := cameras_at F xF v.
Let XF := point_at f (own xF).
Lemma XF_E : XF = @Vec F 1 0 1.
Proof. by rewrite /XF /point_at nf /own !own_F // /dim3 nf. Qed.
Lemma dF_E j : (j < pins f)%N -> dir_at f (own xF) j = @Vec F 3%:R 1 1.
Proof.
move=> jp; have h : ((3 + 2 * j).+1 < dim3 f)%N.
  by rewrite /dim3 nf -addnS ltn_add2l -[(2 * j).+2]/(2 + 2 * j)%N -mulnS leq_mul2l.
rewrite /dir_at nf /own -addnS !own_F //; last exact: ltn_trans h.
by rewrite !addnS !addSn !add0n /= mul2n odd_double.
Qed.

Lemma turn_F v u : turn (CF v) u = u.
Proof.
have q : quat_of (CF v) = @Quat F 1 0 0 0 by rewrite /CF; case: v; rewrite /= ?small_F.
by rewrite /turn q; case: u => a b e; rewrite /rot /dot /=; congr Vec; ring.
Qed.

Lemma generic_point v : x3 (project (cameras_at K (generic F n) v) (point_at f (own (generic F n)))) != 0.
Proof.
have e (x : nat -> P) (R' : idomainType) (g : {rmorphism P -> R'}) x' : (forall k, x' k = g (x k)) ->
    x3 (project (cameras_at R' x' v) (point_at f (own x'))) =
      g (x3 (project (cameras_at P x v) (point_at f (own x)))).
  move=> gx; rewrite (gcameras gx).
  have -> : point_at f (own x') = gvec g (point_at f (own x)) by rewrite /gvec /point_at nf /own /= -!gx.
  by rewrite -gproject.
rewrite (e _ _ _ _ genericE); apply: nonzero; rewrite -(e _ _ ev xF (fun=> erefl)).
rewrite /project turn_F -/XF XF_E; case: v {e}; rewrite /= ?small_F // addr0; exact: oner_neq0.
Qed.

Lemma generic_line v j : (j < pins f)%N ->
  let l := normal (cameras_at K (generic F n) v) (point_at f (own (generic F n)))
    (dir_at f (own (generic F n)) j) in x2 l != 0 /\ x3 l != 0.
Proof.
move=> jp l0; pose l (R : idomainType) (x : nat -> R) :=
  normal (cameras_at R x v) (point_at f (own x)) (dir_at f (own x) j).
have e (x : nat -> P) (R' : idomainType) (g : {rmorphism P -> R'}) x' : (forall k, x' k = g (x k)) ->
    l R' x' = gvec g (l P x).
  move=> gx; rewrite /l (gcameras gx).
  have -> : point_at f (own x') = gvec g (point_at f (own x)) by rewrite /gvec /point_at nf /own /= -!gx.
  have -> : dir_at f (own x') j = gvec g (dir_at f (own x) j)
    by rewrite /gvec /dir_at nf /own /= -!gx rmorph1.
  by rewrite -gnormal.
have eK := e _ _ to _ genericE; have eF := e _ _ ev xF (fun=> erefl).
have two : 2%:R != 0 :> F by have /charf0P -> := char0.
have e1 : (1 + 0) * 3%:R - (1 + 0) * 1 = 2%:R :> F by ring.
have e2 : (1 + 0) * 3%:R - (1 + 1) * 1 = 1 :> F by ring.
have e3 : (1 + 0) * 1 - (0 + 0) * 3%:R = 1 :> F by ring.
have e4 : (1 + 1) * 1 - (0 + 0) * 3%:R = 2%:R :> F by ring.
have e5 : (1 + 0) * 1 - (0 + 1) * 3%:R = - 2%:R :> F by ring.
have : x2 (l F xF) != 0 /\ x3 (l F xF) != 0.
  rewrite /l /normal /project !turn_F -/XF XF_E dF_E // /cross.
  by case: v {l0 l e eK eF}; rewrite /= ?small_F // /= ?e1 ?e2 ?e3 ?e4 ?e5 ?oppr_eq0 two ?oner_neq0.
rewrite -[l0]/(l K (generic F n)) eK eF /= => -[h2 h3]; split; exact: nonzero.
Qed.

(** The planes of two views through a pin meet in the pin only. *)
Section Planes.
Variables (u v : view) (j : nat).
Hypothesis uv : u <> v.
Hypothesis jp : (j < pins f)%N.
Definition plane (R : idomainType) (x : nat -> R) w (i : vec R) :=
  dot (normal (cameras_at R x w) (point_at f (own x)) (dir_at f (own x) j)) (turn (cameras_at R x w) i).
Definition meeting (R : idomainType) (x : nat -> R) :=
  plane x u (@Vec R 1 0 0) * plane x v (@Vec R 0 1 0) - plane x v (@Vec R 1 0 0) * plane x u (@Vec R 0 1 0).
Lemma meeting_map (R' : idomainType) (g : {rmorphism P -> R'}) (x : nat -> P) x' :
  (forall k, x' k = g (x k)) -> meeting x' = g (meeting x).
Proof.
move=> gx; have gdot (a b : vec P) : dot (gvec g a) (gvec g b) = g (dot a b).
  by rewrite /dot /gvec /= !(rmorphD, rmorphM).
have e w (i : vec P) : plane x' w (gvec g i) = g (plane x w i).
  rewrite /plane !(gcameras gx) -gturn -gdot; congr (dot _ _).
  have -> : point_at f (own x') = gvec g (point_at f (own x)) by rewrite /gvec /point_at nf /own /= -!gx.
  have -> : dir_at f (own x') j = gvec g (dir_at f (own x) j)
    by rewrite /gvec /dir_at nf /own /= -!gx rmorph1.
  by rewrite -gnormal.
have e1 : @Vec R' 1 0 0 = gvec g (@Vec P 1 0 0) by rewrite /gvec /= rmorph1 rmorph0.
have e2 : @Vec R' 0 1 0 = gvec g (@Vec P 0 1 0) by rewrite /gvec /= rmorph1 rmorph0.
by rewrite /meeting e1 e2 !e rmorphB !rmorphM.
Qed.
Lemma generic_meeting : meeting (generic F n) != 0.
Proof.
rewrite (meeting_map genericE); apply: nonzero; rewrite -(meeting_map (x' := xF) (fun=> erefl)).
have two : 2%:R != 0 :> F by have /charf0P -> := char0.
have lF w : normal (CF w) XF (dir_at f (own xF) j) =
    by_view (@Vec F (-1) 2%:R 1) (@Vec F (-1) 1 2%:R) (@Vec F 0 2%:R (- 2%:R)) w.
  rewrite /normal /project !turn_F XF_E dF_E // /cross; case: w; rewrite /= ?small_F // /=;
    congr Vec; ring.
have eF w i : plane xF w i =
    dot (by_view (@Vec F (-1) 2%:R 1) (@Vec F (-1) 1 2%:R) (@Vec F 0 2%:R (- 2%:R)) w) i.
  by rewrite /plane -/XF -/(CF w) lF turn_F.
rewrite /meeting !eF /dot; move: uv; case: u; case: v => //= _;
  rewrite !(mulr0, mul0r, mulr1, addr0, add0r, subr0, sub0r, mulN1r, opprK) -?opprD ?oppr_eq0 //.
- by rewrite oppr0 !add0r (_ : 2%:R = 1 + 1 :> F) // addKr oner_neq0.
- by rewrite oppr0 !add0r (_ : 2%:R = 1 + 1 :> F) // opprD addrNK oppr_eq0 oner_neq0.
Qed.
End Planes.
End Generic.
