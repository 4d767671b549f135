(** * Lemma 1 of the paper: the degree of a minimal problem is its camera-degree

    Given the cameras, the images determine the directions of pins and free lines by linear
    equations, and then the points. If such a system had two solutions, something could move, and
    all images stay; then the problem would not be minimal. So all parameters are quotients of
    polynomials in images and cameras. *)
From mathcomp Require Import all_ssreflect all_algebra.
From mathcomp.algebra_tactics Require Import ring.
From SsrMultinomials Require Import mpoly.
From PL1P Require Import Statement Rigid Reducible Problems Reductions Forget Derivations.
From PL1P Require Import RationalFunctions Independence Generic Motion Lifting Reduction Embedding.
From PL1P Require Import Scenes Keeps Theorem1 Determined Dangling Placed Degree.
Set Implicit Arguments.
Unset Strict Implicit.
Unset Printing Implicit Defensive.
Import GRing.Theory.
Local Open Scope ring_scope.

(** ** Equations of lines and points *)
Section Vectors.
Variable K : fieldType.
Implicit Types (C : camera K) (m u : vec K).
(** The normal m of a plane, in the frame of the camera, as a normal in the world. *)
Definition pull C m := @Vec K (dot m (turn C (@Vec K 1 0 0))) (dot m (turn C (@Vec K 0 1 0)))
  (dot m (turn C (@Vec K 0 0 1))).
Lemma pullE C m u : dot (pull C m) u = dot m (turn C u).
Proof.
case: C => -[q1 q2 q3 q4] t; case: u => i1 i2 i3; case: m => l1 l2 l3.
by rewrite /pull /turn /rot /dot /=; ring.
Qed.
Lemma dot_scale k m u : dot (scale k m) u = k * dot m u. Proof. by rewrite /dot /=; ring. Qed.
Lemma dot_add m u w : dot m (add u w) = dot m u + dot m w. Proof. by rewrite /dot /=; ring. Qed.
Lemma dot0 m : dot m (vec0 K) = 0. Proof. by rewrite /dot /=; ring. Qed.
Lemma dot0v m : dot (vec0 K) m = 0. Proof. by rewrite /dot /=; ring. Qed.
(** The equations of a seen point. *)
Definition eq1 (x : vec K) := @Vec K 0 1 (- (x2 x / x3 x)).
Definition eq2 (x : vec K) := @Vec K 1 0 (- (x1 x / x3 x)).
Lemma eq1E x u : x3 x != 0 -> dot (@Vec K 0 (x3 x) (- x2 x)) u = x3 x * dot (eq1 x) u.
Proof. by move=> h; rewrite /dot /=; field. Qed.
Lemma eq2E x u : x3 x != 0 -> dot (@Vec K (- x3 x) 0 (x1 x)) u = - x3 x * dot (eq2 x) u.
Proof. by move=> h; rewrite /dot /=; field. Qed.
End Vectors.
Lemma mem_views (T : eqType) (g : view -> seq T) v a :
  a \in g v -> a \in flatten [seq g w | w <- views].
Proof. by rewrite /= !mem_cat; case: v => ->; rewrite ?orbT. Qed.

(** ** A feature among others *)
Section Among.
Variables (F K : fieldType) (c : {rmorphism F -> K}) (pre post : problem) (f : feature).
Variables (x : nat -> K) (C : view -> camera K).
Notation o := (11 + sumn [seq dim3 g | g <- pre])%N.
Notation at_ := (fun k => x (o + k)%N).
Notation all_seen := (seen C (scene x 11 (pre ++ f :: post))).
Lemma all_seenE : all_seen =
  seen C (scene x 11 pre) ++ views_of C (f, at_) ++ seen C (scene x (o + dim3 f) post).
Proof. by rewrite /seen scene_cat map_cat flatten_cat. Qed.
Lemma mem_seen v a : a \in image (f, at_) (C v) (looks f v) -> a \in all_seen.
Proof.
move=> av; have h : a \in views_of C (f, at_) by exact: mem_views av.
by rewrite all_seenE 2!mem_cat h orbT.
Qed.
Definition outside (D : K -> K) := forall k, (k < o)%N || (o + dim3 f <= k)%N -> D (x k) = 0.
Lemma seen_killed D : derivation c D -> (forall v, dead_camera D (C v)) -> is_problem pre ->
  is_problem post -> outside D -> (forall v, killed D (image (f, at_) (C v) (looks f v))) ->
  killed D all_seen.
Proof.
move=> hD hC p1 p2 out ki.
have cat r t : killed D r -> killed D t -> killed D (r ++ t) by rewrite /killed all_cat => -> ->.
have other A0 o0 : is_problem A0 ->
    (o0 + sumn [seq dim3 g | g <- A0] <= o)%N \/ (o + dim3 f <= o0)%N ->
    killed D (seen C (scene x o0 A0)).
  move=> pA0 h; rewrite killed_flatten; apply: scene_all => // g o' pg le le'.
  have sg k : (k < dim3 g)%N -> D (x (o' + k)%N) = 0.
    move=> kd; apply: out; case: h => h; apply/orP; [left | right].
      by apply: leq_trans h; apply: leq_trans le'; rewrite ltn_add2l.
    by apply: leq_trans h _; apply: leq_trans le _; exact: leq_addr.
  have k1 : (1 < dim3 g)%N by rewrite /dim3; case: (free g).
  rewrite /views_of killed_flatten; apply: all_views => u; apply: (dead_image hD) => //.
    split; rewrite [LHS]/=; [exact: sg (ltnW k1) | exact: sg k1 |].
    by case fr: (free g); [exact: (der0 hD) | apply: sg; rewrite /dim3 fr].
  move=> i il; have [_ /allP le0 _] := properP u pg; have lt := pin_own (le0 i il).
  by split; rewrite [LHS]/=; [exact: sg (ltnW lt) | exact: sg lt | exact: (der1 hD)].
rewrite all_seenE; apply: (cat); first by apply: other => //; left.
apply: (cat); last by apply: other => //; right.
by rewrite /views_of killed_flatten; apply: all_views => u; exact: ki.
Qed.
End Among.

(** ** A feature with given cameras, over any field

    Derivations are given by what they do to the point, v, and to the directions, w. *)
Section Feature.
Variables (F K : fieldType) (c : {rmorphism F -> K}) (f : feature) (x : nat -> K).
Variable C : view -> camera K.
Notation X := (point_at f x).
Notation d := (dir_at f x).
Hypothesis pf : proper f.
Hypothesis point3 : forall v, sees_point f v -> x3 (project (C v) X) != 0.
Hypothesis line3 : forall v i, (i < pins f)%N -> x3 (normal (C v) X (d i)) != 0.
Hypothesis line2 : forall v i, sees_point f v -> (i < pins f)%N ->
  x2 (normal (C v) X (d i)) != 0.
Lemma pin_lt v i : i \in sees_pins f v -> (i < pins f)%N.
Proof. by have [_ /allP le _] := properP v pf => /le. Qed.
(** Only the last coordinate of a direction, and of the point of a free line, is fixed. *)
Definition allowed (v : vec K) (w : nat -> vec K) :=
  (free f -> x3 v = 0) /\ forall i, x3 (w i) = 0.
(** The images stay. *)
Definition still (v : vec K) (w : nat -> vec K) :=
  (forall u, sees_point f u -> dot (eq1 (project (C u) X)) (turn (C u) v) = 0 /\
     dot (eq2 (project (C u) X)) (turn (C u) v) = 0) /\
  (forall u i, i \in sees_pins f u -> dot (normal (C u) X (d i)) (turn (C u) v) = 0 /\
     dot (normal (C u) X (d i)) (turn (C u) (w i)) = 0).
(** What happens to the parameters. *)
Definition change (v : vec K) (w : nat -> vec K) k :=
  let off := (if free f then 2 else 3)%N in
  if (k < off)%N then nth 0 [:: x1 v; x2 v; x3 v] k else
  if odd (k - off) then x2 (w (k - off)./2) else x1 (w (k - off)./2).

Section Derivation.
Variable D : K -> K.
Hypothesis hD : derivation c D.
Lemma changes v w : allowed v w -> (forall k, (k < dim3 f)%N -> D (x k) = change v w k) ->
  dvec D X = v /\ forall i, (i < pins f)%N -> dvec D (d i) = w i.
Proof.
case=> v0 w0; rewrite /change; set off := (if free f then 2 else 3)%N => own; split=> [|i ip].
  have k1 : (1 < dim3 f)%N by rewrite /dim3; case: (free f).
  have o2 : (1 < off)%N by rewrite /off; case: (free f).
  case: v v0 own => v1 v2 v3 v0 own; rewrite /dvec /point_at /=.
  rewrite !own // ?(ltnW k1) // o2 (ltnW o2) /=; congr Vec.
  case fr: (free f); first by rewrite (der0 hD) [v3]v0.
  by rewrite own /off ?fr // /dim3 fr.
have lt := pin_own ip; rewrite /dvec /dir_at -/off /= in lt *.
have lo l : (off + l < off)%N = false by rewrite ltnNge leq_addr.
rewrite own ?(ltnW lt) // own // (der1 hD) lo -addnS lo !addKn.
rewrite mul2n /= odd_double uphalf_double doubleK;
  transitivity (@Vec K (x1 (w i)) (x2 (w i)) (x3 (w i))).
  by rewrite w0.
by case: (w i).
Qed.
Lemma at_rest : (forall k, D (x k) = 0) -> dvec D X = vec0 K /\ forall i, dvec D (d i) = vec0 K.
Proof.
move=> dead; split=> [|i]; last by rewrite /dvec /dir_at /= !dead (der1 hD).
by rewrite /dvec /point_at /= !dead; case: (free f); rewrite ?(der0 hD) ?dead.
Qed.
Lemma image_still v : (forall u, dead_camera D (C u)) -> still (dvec D X) (fun i => dvec D (d i)) ->
  killed D (image (f, x) (C v) (looks f v)).
Proof.
move=> hC [hp hl]; have add0 (u w : vec K) : add u (scale 0 w) = u.
  by case: u => u1 u2 u3; rewrite /add /scale /= !mul0r !addr0.
rewrite /image killed_cat killed_flatten -/(sees_point f v) -/(sees_pins f v).
rewrite [(_, _).1]/= [(_, _).2]/=.
have ep := dvec_project hD X (hC v); have ed i := turn_still hD (d i) (hC v).
pose y := project (C v) X.
have two : sees_point f v -> (dot (@Vec K 0 (x3 y) (- x2 y)) (add (dvec D y) (scale 0 y)) == 0) &&
    (dot (@Vec K (- x3 y) 0 (x1 y)) (add (dvec D y) (scale 0 y)) == 0).
  move=> pv; have [h1 h2] := hp v pv; have q3 := point3 pv.
  by rewrite add0 {2 4}/y ep (eq1E _ q3) (eq2E _ q3) h1 h2 !mulr0 eqxx.
apply/andP; split.
  case: ifP => // pv; have pk := @point_killed _ _ _ _ hD y 0 (point3 pv).
  have /andP[h1 h2] : _ && _ := etrans pk (two pv).
  by rewrite /killed /= h1 h2.
apply/allP => i iv; have ip := pin_lt iv; have [h1 h2] := hl v i iv.
have lk := @line_killed _ _ _ _ hD (project (C v) X) (turn (C v) (d i)) 0 0.
rewrite !add0 ep ed -/(normal (C v) X (d i)) h1 h2 eqxx in lk.
have /andP[k1 k2] := lk (line3 v ip).
case pv: (sees_point f v); last by rewrite /killed /= k1 k2.
have sk := @slope_killed _ _ _ _ hD (project (C v) X) (turn (C v) (d i)) 0 0 (point3 pv).
by rewrite /killed /= andbT (sk (line2 pv ip) (two pv)) add0 ed -/(normal (C v) X (d i)) h2.
Qed.
End Derivation.

(** *** If nothing can move, images and cameras determine the feature *)
Hypothesis rigid : forall v w, allowed v w -> still v w ->
  v = vec0 K /\ forall i, (i < pins f)%N -> w i = vec0 K.
Variables (R : comRingType) (ev : {rmorphism R -> K}).
Hypothesis fr_image : forall v a, a \in image (f, x) (C v) (looks f v) -> fraction ev a.
Hypothesis cam : forall v, [/\ fraction ev (qa (quat_of (C v))), fraction ev (qb (quat_of (C v))),
  fraction ev (qc (quat_of (C v))) & fraction ev (qd (quat_of (C v)))].
Hypothesis tr : forall v, fr3 ev (trans (C v)).
Let unit3 : [/\ fr3 ev (@Vec K 1 0 0), fr3 ev (@Vec K 0 1 0) & fr3 ev (@Vec K 0 0 1)].
Proof. by split; split; rewrite /=; first [exact: fr1 | exact: fr0]. Qed.
Let turn0 v : turn (C v) (vec0 K) = vec0 K.
Proof.
by case: (C v) => -[q1 q2 q3 q4] t; rewrite /turn /rot /dot /vec0 /=; congr Vec; ring.
Qed.
Let fr30 : fr3 ev (vec0 K). Proof. by split; exact: fr0. Qed.
Lemma fr_pull v m : fr3 ev m -> fr3 ev (pull (C v) m).
Proof. by case: unit3 => u1 u2 u3 hm; split; apply: fr_dot => //; exact: fr_turn. Qed.
Lemma fr_point v : sees_point f v -> let y := project (C v) X in
  fraction ev (x1 y / x3 y) /\ fraction ev (x2 y / x3 y).
Proof.
by move=> pv y; split; apply: (@fr_image v);
  rewrite /image mem_cat -/(sees_point f v) pv !inE eqxx ?orbT.
Qed.
(** The image of a pin, up to a factor. *)
Definition nu v i :=
  (if sees_point f v then x2 (normal (C v) X (d i)) else x3 (normal (C v) X (d i)))^-1.
Definition nn v i := scale (nu v i) (normal (C v) X (d i)).
Lemma nu0 v i : i \in sees_pins f v -> nu v i != 0.
Proof.
by move=> /pin_lt ip; rewrite invr_eq0; case: ifP => pv; [exact: line2 | exact: line3].
Qed.
Lemma fr_nn v i : i \in sees_pins f v -> fr3 ev (nn v i).
Proof.
move=> iv; have ip := pin_lt iv;
  have inl a : a \in line_image (sees_point f v) (normal (C v) X (d i)) ->
    fraction ev a.
  move=> al; apply: (@fr_image v); rewrite /image mem_cat; apply/orP; right.
  by apply/flatten_mapP; exists i.
rewrite /nn /nu; case pv: (sees_point f v) inl => inl.
  have l2 := line2 pv ip; have [e1 e2] := fr_point pv; have q3 := point3 pv.
  have g : fraction ev (x1 (normal (C v) X (d i)) / x2 (normal (C v) X (d i))) by apply: inl;
    rewrite inE.
  have := normal_dot (C v) X (d i); move: (normal _ _ _) (project _ _) l2 q3 e1 e2 g.
  move=> [l1 l2 l3] [q1 q2 q3] /= h2 h3 e1 e2 g; rewrite /dot /= => e.
  have h : l2^-1 * l3 = - (l1 / l2 * (q1 / q3) + q2 / q3).
    have -> : l3 = - (l1 * q1 + l2 * q2) / q3.
      by apply: (mulIf h3); rewrite divfK //; apply/eqP; rewrite -addr_eq0 addrC e.
    by field; rewrite h2 h3.
  split; rewrite /=; [by rewrite mulrC | by rewrite mulVf //; exact: fr1 | rewrite h].
  by apply: frN; apply: frD => //; exact: frM.
have l3 := line3 v ip; split; rewrite /= ?mulVf //; last exact: fr1.
  by rewrite mulrC; apply: inl; rewrite !inE eqxx.
by rewrite mulrC; apply: inl; rewrite !inE eqxx orbT.
Qed.

Lemma fr_dir i : (i < pins f)%N -> fr3 ev (d i).
Proof.
move=> ip; apply: (@fr_vec _ _ ev 2 (fun v k => if k == 0%N then
    pull (C v) (if i \in sees_pins f v then nn v i else vec0 K) else @Vec K 0 0 1)
  (fun v k => (k != 0%N)%:R)) => [v k k2|u hu].
  case: k k2 => [_|k _] /=; split; try by rewrite ?mulr0n ?mulr1n; first [exact: fr0 | exact: fr1].
  - by apply: fr_pull; case: ifP => // /fr_nn.
  - rewrite pullE; case: ifP => _; last exact: dot0v.
    by rewrite /nn dot_scale /normal /dot /cross /=; ring.
  - by case: unit3.
  - by rewrite /dot /=; ring.
have u3 : x3 u = 0 by apply: etrans (hu V1 1%N isT); rewrite /dot /=; ring.
have [||_ /(_ i ip)] := @rigid (vec0 K) (fun j => if j == i then u else vec0 K);
  last by rewrite eqxx.
  by split=> // j; case: (j == i).
split=> [v _|v j jv]; first by rewrite turn0 !dot0.
rewrite turn0 dot0; split=> //; case: eqP => [e|_]; last by rewrite turn0 dot0.
have := hu v 0%N isT; rewrite /= -e jv pullE /nn dot_scale => /eqP.
by rewrite mulf_eq0 (negbTE (nu0 jv)) => /eqP.
Qed.

(** The equations of X: one for each pin, and two for the point if view v sees it. *)
Definition mv v k :=
  if (k < pins f)%N then if k \in sees_pins f v then nn v k else vec0 K
  else if ~~ sees_point f v then vec0 K
  else if k == pins f then eq1 (project (C v) X) else eq2 (project (C v) X).
Lemma mvE v k : dot (mv v k) (project (C v) X) = 0.
Proof.
rewrite /mv; case: ifP => _; case: ifP => h; rewrite ?dot0v //.
  by rewrite /nn dot_scale normal_dot mulr0.
have := point3 (negbFE h); case: ifP => _; move: (project _ _) => [q1 q2 q3] /= q0; rewrite /dot /=;
  field; exact: q0.
Qed.
Lemma fr_mv v k : fr3 ev (mv v k).
Proof.
rewrite /mv; case: ifP => _; case: ifP => h //; first exact: fr_nn.
have [e1 e2] := fr_point (negbFE h); case: ifP => _; split; rewrite /=;
  first [exact: fr0 | exact: fr1 | exact: frN].
Qed.
Lemma fr_X : fr3 ev X.
Proof.
pose last_ := @Vec K 0 0 (free f)%:R.
apply: (@fr_vec _ _ ev (pins f).+3 (fun v k => if (k < (pins f).+2)%N then pull (C v) (mv v k)
  else last_)
  (fun v k => if (k < (pins f).+2)%N then - dot (mv v k) (trans (C v)) else 0)) => [v k _|u hu].
  case: ifP => _; split.
  - by apply: fr_pull; exact: fr_mv.
  - by apply: frN; apply: fr_dot; [exact: fr_mv | exact: tr].
  - by rewrite pullE; apply/eqP; rewrite -addr_eq0 -dot_add mvE.
  - by split; rewrite /=; [exact: fr0 | exact: fr0 | case: (free f); [exact: fr1 | exact: fr0]].
  - exact: fr0.
  - by rewrite /dot /last_ /=; case: (free f); rewrite /=; ring.
have u3 : free f -> x3 u = 0.
  move=> fr; have := hu V1 (pins f).+2 (leqnn _); rewrite ltnn /dot /last_ fr /= => e.
  by apply: etrans e; ring.
have row v k : (k < (pins f).+2)%N -> dot (mv v k) (turn (C v) u) = 0.
  by move=> lt; have := hu v k (leqW lt); rewrite lt pullE.
have [||-> _] // := @rigid u (fun=> vec0 K); split=> // [v pv|v j jv].
  have r1 := row v (pins f) (leqW (leqnn _)); have r2 := row v (pins f).+1 (leqnn _).
  by move: r1 r2; rewrite /mv pv ltnn eqxx ltnNge leqnSn /= gtn_eqF.
rewrite turn0 dot0; split=> //.
have := row v j (leqW (leqW (pin_lt jv))); rewrite /mv (pin_lt jv) jv /nn dot_scale => /eqP.
by rewrite mulf_eq0 (negbTE (nu0 jv)) => /eqP.
Qed.
Lemma fr_own k : (k < dim3 f)%N -> fraction ev (x k).
Proof.
move=> kd; have [f1 f2 f3] := fr_X; have : x k \in own (f, x).
  by apply/mapP; exists k; rewrite // mem_iota.
rewrite ownE /kept_parameters mem_cat => /orP[|/flatten_mapP[j]].
  by case: ifP => _; rewrite !inE; do ?[case/orP]; move/eqP=> ->.
by rewrite mem_iota => /fr_dir[g1 g2 _]; rewrite !inE => /orP[]/eqP ->.
Qed.
End Feature.

(** ** A feature of a minimal problem *)
Section Minimal.
Variables (F : fieldType) (pre post : problem) (f : feature).
Hypothesis char0 : [char F] =i pred0.
Notation A := (pre ++ f :: post).
Hypothesis pA : is_problem A.
Hypothesis mA : minimal F A.
Notation n := (parameters A).
Notation o := (11 + sumn [seq dim3 g | g <- pre])%N.
Notation K := [fieldType of {fraction {mpoly F[n]}}].
Notation gx := (generic F n).
Notation C := (cameras_at K gx).
Notation at_ := (fun k => gx (o + k)%N).
Notation X := (point_at f at_).
Notation d := (dir_at f at_).
Notation c := (const (to F n)).
Let parts : [/\ is_problem pre, proper f & is_problem post].
Proof. by move: pA; rewrite /is_problem all_cat => /and3P[]. Qed.
Let pf : proper f. Proof. by case: parts. Qed.
Let room : (o + dim3 f <= n)%N.
Proof. by rewrite /parameters map_cat sumn_cat /= -addnA !leq_add2l leq_addr. Qed.
Let o11 : (11 <= o)%N. Proof. exact: leq_addr. Qed.
Let seen_nf v : sees_point f v -> free f = false.
Proof. by move=> pv; have [_ _] := properP v pf; rewrite pv; case: (free f). Qed.
Let point3 v : sees_point f v -> x3 (project (C v) X) != 0.
Proof. by move=> pv; exact: (generic_point F o11 room (seen_nf pv)). Qed.
Let line3 v i : (i < pins f)%N -> x3 (normal (C v) X (d i)) != 0.
Proof.
move=> ip; case fr: (free f); last by case: (generic_line char0 o11 room fr v ip).
move: ip; rewrite (free_pins pf fr); case: i => // _.
by apply: free_line_third => //; exact: free_pins.
Qed.
Let line2 v i : sees_point f v -> (i < pins f)%N -> x2 (normal (C v) X (d i)) != 0.
Proof. by move=> /seen_nf nf ip; case: (generic_line char0 o11 room nf v ip). Qed.

(** A derivation has any values at the parameters. *)
Lemma derive (e : nat -> K) : exists2 D, derivation c D & forall k, (k < n)%N -> D (gx k) = e k.
Proof.
exists (extension (to F n) (@numerator _) (@denominator _) (fun i : 'I_n => e i)).
  exact: (extension_derivation (@den_neq0 _) (@fractionE _) (@to0 F n)).
move=> k kn; have := extension_param (@den_neq0 _) (@fractionE _) (@to0 F n) (fun i : 'I_n => e i)
  (Ordinal kn).
by rewrite /generic insubT.
Qed.
Lemma feature_rigid v w : allowed f v w -> still f at_ C v w ->
  v = vec0 K /\ forall i, (i < pins f)%N -> w i = vec0 K.
Proof.
move=> vw st; have [D hD e] := derive (fun k => if (o <= k < o + dim3 f)%N then
  change f v w (k - o) else 0).
have own k : (k < dim3 f)%N -> D (at_ k) = change f v w k.
  move=> lt; rewrite e; last by apply: leq_trans room; rewrite ltn_add2l.
  by rewrite leq_addr ltn_add2l lt /= addKn.
have out : outside pre f gx D.
  move=> k out; case: (ltnP k n) => kn; last first.
    by rewrite /generic insubF ?(der0 hD) // ltnNge kn.
  rewrite e //; have -> // : (o <= k < o + dim3 f)%N = false.
  by case/orP: out => h; [rewrite leqNgt h | rewrite andbC ltnNge h].
have [eX ed] := changes hD vw own.
have D0 := der0 hD; have D1 := der1 hD.
have s k : (k < 11)%N -> D (gx k) = 0 by move=> h; rewrite out // (leq_trans h).
have hC u : dead_camera D (C u).
  by case: u; split=> //; try split; rewrite ?[in LHS]/= ?s ?D0 ?D1.
have ki u : killed D (image (f, at_) (C u) (looks f u)).
  apply: (image_still pf point3 line3 line2 hD) => //; rewrite eX.
  case: st => sp sl; split=> // u' i iu; have [h1 h2] := sl u' i iu.
  by rewrite ed // (pin_lt pf iu).
have [p1 _ p3] := parts.
have kA : killed D (images F n A) by rewrite images_atE; exact: (seen_killed hD hC p1 p3 out ki).
have [_ un] := (minimalP char0 A).1 mA; have {un}dead k : D (gx k) = 0.
  by rewrite /generic; case: insubP => [i _ _|_]; [exact: un | exact: D0].
have [zX zd] := at_rest f hD (x := fun k => gx (o + k)%N) (fun k => dead (o + k)%N).
by rewrite -eX; split=> // i ip; rewrite -ed.
Qed.

Notation z := (with_cameras F n A).
Notation ev := (ev_of z).
Let fr_camera k : (k < 11)%N -> fraction ev (gx k).
Proof. by move=> k11; apply: fr_mem; rewrite mem_cat map_f ?orbT // mem_iota. Qed.
Lemma fr_image v a : a \in image (f, at_) (C v) (looks f v) -> fraction ev a.
Proof.
by move=> av; apply: fr_mem; rewrite mem_cat images_atE; apply/orP; left; exact: mem_seen av.
Qed.
Let cam v : [/\ fraction ev (qa (quat_of (C v))), fraction ev (qb (quat_of (C v))),
  fraction ev (qc (quat_of (C v))) & fraction ev (qd (quat_of (C v)))].
Proof. by case: v; split; rewrite /=; first [exact: fr1 | exact: fr0 | exact: fr_camera]. Qed.
Let tr v : fr3 ev (trans (C v)).
Proof. by case: v; split; rewrite /=; first [exact: fr1 | exact: fr0 | exact: fr_camera]. Qed.
Lemma fr_parameter k : (k < dim3 f)%N -> fraction ev (gx (o + k)%N).
Proof. exact: (fr_own pf point3 line3 line2 feature_rigid fr_image cam tr). Qed.
End Minimal.

(** ** Lemma 1 *)
Lemma find_feature A k : (11 <= k)%N -> (k < parameters A)%N -> exists pre f post i,
  [/\ A = pre ++ f :: post, k = (11 + sumn [seq dim3 g | g <- pre] + i)%N & (i < dim3 f)%N].
Proof.
rewrite /parameters => /subnK <-; rewrite addnC ltn_add2l; move: (k - 11)%N => {}k.
elim: A k => // f A IH k /=; case: (ltnP k (dim3 f)) => [lt _|le].
  by exists [::], f, A, k; rewrite addn0.
rewrite -{1}(subnKC le) ltn_add2l => /IH[pre [g [post [i [-> e lt]]]]].
exists (f :: pre), g, post, i; split=> //=; move/eqP: e; rewrite -addnA eqn_add2l => /eqP e.
by rewrite -{1}(subnKC le) e !addnA.
Qed.

Theorem lemma1_theorem : lemma1.
Proof.
move=> F char0 A pA mA; set n := parameters A; set z := with_cameras F n A.
suff all_rational u : rational z u.
  split=> // d; split=> -[b [b1 b2 b3]]; exists b; split=> // u; last by move=> _; exact: b2.
  by move=> _; exact: b2.
apply: (fr_all (z := z)) => k kn; case: (ltnP k 11) => k11.
  by apply: fr_mem; rewrite mem_cat map_f ?orbT // mem_iota.
have [pre [f [post [i [e -> lt]]]]] := find_feature k11 kn.
by move: pA mA; rewrite /z /n e => pA' mA'; exact: (fr_parameter char0 pA' mA' lt).
Qed.
