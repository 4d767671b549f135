(** * One more view of a dangling pin

    A pin dangles if at most one view sees it. Let another view see the point of the pin, and let it
    see the pin too: the problem stays camera-minimal, or not camera-minimal, as it was ([reveal_minimal]).
    For the pin can turn, in the plane of its image, while all else stays. That view alone sees it
    turn. So the new coordinate is independent of all others, and says nothing on the cameras. *)
From mathcomp Require Import all_ssreflect all_algebra.
From mathcomp.algebra_tactics Require Import ring.
From mathcomp.zify Require Import zify.
From SsrMultinomials Require Import mpoly.
From PL1P Require Import Statement Reducible Problems Reductions Forget Derivations RationalFunctions
  Independence Generic Motion Lifting Reduction Embedding Scenes Keeps Theorem1 Determined Moved CameraMinimal
  Replacements.
Set Implicit Arguments.
Unset Strict Implicit.
Unset Printing Implicit Defensive.
Import GRing.Theory.

Lemma scene_cat (R : idomainType) (x : nat -> R) o A B :
  scene x o (A ++ B) = scene x o A ++ scene x (o + sumn [seq dim3 f | f <- A]) B.
Proof. by elim: A o => [|f A IH] o /=; rewrite ?addn0 // IH addnA. Qed.

Local Open Scope ring_scope.

Lemma all_views (p : view -> bool) : (forall v, p v) -> all p views. Proof. by move=> h; rewrite /= !h. Qed.
Lemma normal_dot (K : fieldType) (C : camera K) X d : dot (normal C X d) (project C X) = 0.
Proof. by rewrite /normal /dot /cross /=; ring. Qed.

(** ** The pin turns *)
Section Move.
Variables (F : fieldType) (n o : nat) (f : feature) (j : nat) (u v : view).
Hypothesis char0 : [char F] =i pred0.
Hypothesis o11 : (11 <= o)%N.
Hypothesis room : (o + dim3 f <= n)%N.
Hypothesis nf : free f = false.
Hypothesis jp : (j < pins f)%N.
Hypothesis uv : u <> v.
Notation K := [fieldType of {fraction {mpoly F[n]}}].
Notation gx := (generic F n).
Notation C := (cameras_at K gx).
Notation at_ o := (fun k => gx (o + k)%N).
Notation X := (point_at f (at_ o)).
Notation d := (dir_at f (at_ o)).
Notation c := (const (to F n)).
Definition slope w := x1 (normal (C w) X (d j)) / x2 (normal (C w) X (d j)).
Definition turning := (o + (3 + 2 * j))%N.
Definition spares (D : K -> K) := forall k, k != turning -> k != turning.+1 -> D (gx k) = 0.
Lemma turning_own : (turning.+1 < o + dim3 f)%N.
Proof. by rewrite /turning -addnS ltn_add2l; have := pin_own jp; rewrite nf. Qed.
(** The cameras stay. *)
Lemma spared_first D k : spares D -> (k < 11)%N -> D (gx k) = 0.
Proof.
move=> sD k11; have lt : (k < turning)%N by rewrite (leq_trans k11) // (leq_trans o11) ?leq_addr.
by apply: sD; rewrite neq_ltn ?ltnS ?lt // (ltnW lt).
Qed.

Section Spared.
Variable D : K -> K.
Hypothesis hD : derivation c D.
Hypothesis sD : spares D.
Lemma spared_camera w : dead_camera D (C w).
Proof.
have D0 := der0 hD; have D1 := der1 hD; have s k := @spared_first D k sD.
by case: w; split=> //; try split; rewrite ?[in LHS]/= ?s ?D0 ?D1.
Qed.
Lemma spared_other g o' : (o' + dim3 g <= o)%N \/ (o + dim3 f <= o')%N ->
  dead D (point_at g (at_ o')) /\ forall i, (i < pins g)%N -> dead D (dir_at g (at_ o') i).
Proof.
move=> out; have s k : (k < dim3 g)%N -> D (gx (o' + k)) = 0.
  move=> kd; have lt := turning_own; have le : (o <= turning)%N by exact: leq_addr.
  by apply: sD; rewrite neq_ltn; move: turning lt le => t; case: out; lia.
split; last by move=> i /pin_own ip; split; rewrite /=; [exact: s (ltnW ip) | exact: s ip | exact: (der1 hD)].
have k0 : (1 < dim3 g)%N by rewrite /dim3; case: (free g).
split; rewrite /=; [exact: s (ltnW k0) | exact: s k0 |].
by case fr: (free g); [exact: (der0 hD) | apply: s; rewrite /dim3 fr].
Qed.
Lemma spared_point : dead D X.
Proof.
have s k : (k < 3)%N -> D (gx (o + k)) = 0.
  by move=> k3; apply: sD; rewrite /turning -?addnS eqn_add2l neq_ltn ltn_addr // ltnW // ltn_addr.
by split; rewrite /= ?nf; exact: s.
Qed.
Lemma spared_pin i : i != j -> dead D (d i).
Proof.
move=> ij; have s b : (b <= 1)%N -> D (gx (o + (3 + 2 * i + b))) = 0.
  by move=> b1; apply: sD; rewrite /turning -?addnS eqn_add2l; move: ij; lia.
by split; [have := s 0%N isT | have := s 1%N isT | exact: (der1 hD)]; rewrite ?addn0 ?addn1 /= nf.
Qed.
Lemma spared_line w p i : (i < pins f)%N -> (i = j -> D (slope w) = 0) ->
  killed D (line_image p (normal (C w) X (d i))).
Proof.
move=> ip; have [->|ij _] := eqVneq i j; last first.
  exact: (dead_line hD _ (dead_normal hD (spared_camera w) spared_point (spared_pin ij))).
move=> /(_ erefl) z; have [n2 n3] := generic_line char0 o11 room nf w jp.
have := dead_point hD (dead_project hD (spared_camera w) spared_point); rewrite killed_two => -[z1 z2].
have e := normal_dot (C w) X (d j).
case: p; first exact/killed_one.
exact/killed_two/(line_other hD n2 n3 (generic_point F o11 room nf w) e z1).1.
Qed.
Lemma spared_image w : proper f -> (j \in sees_pins f w -> D (slope w) = 0) ->
  killed D (image (f, at_ o) (C w) (looks f w)).
Proof.
move=> pf z; have [_ /allP le _] := properP w pf; rewrite /image killed_cat killed_flatten; apply/andP; split.
  by case: ifP => // _; exact: (dead_point hD (dead_project hD (spared_camera w) spared_point)).
by apply/allP => i il; apply: spared_line; [exact: le | move=> e; apply: z; rewrite -e].
Qed.
End Spared.

Lemma move : exists D, [/\ derivation c D, spares D, D (slope u) = 0 & D (slope v) != 0].
Proof.
have lt : (turning.+1 < n)%N by exact: leq_trans turning_own room.
pose y := [seq gx k | k <- iota 0 turning ++ iota turning.+2 (n - turning.+2)] ++ [:: slope u].
have sy : (size y < n)%N by rewrite size_cat size_map size_cat !size_iota /=; move: turning lt => t; lia.
have [D [hD kD] [i Di]] := mover (@den_neq0 _) (@fractionE _) (@to0 F n) sy.
move: kD; rewrite killed_cat => /andP[/allP k1 /killed_one k2].
have sD : spares D.
  move=> k h1 h2; case: (ltnP k n) => kn; last first.
    by rewrite /generic insubF ?(der0 hD) // ltnNge kn.
  apply/eqP; apply: (k1 (gx k)); apply: map_f; rewrite mem_cat !mem_iota.
  by move: turning h1 h2 lt => t; lia.
exists D; split=> //; apply/negP => /eqP z.
have plane w : D (slope w) = 0 -> D (x1 (d j)) * dot (normal (C w) X (d j)) (turn (C w) (@Vec K 1 0 0)) +
    D (x2 (d j)) * dot (normal (C w) X (d j)) (turn (C w) (@Vec K 0 1 0)) = 0.
  move=> zw; rewrite -plane_sum; have -> : @Vec K (D (x1 (d j))) (D (x2 (d j))) 0 = dvec D (d j).
    by rewrite /dvec /dir_at /= (der1 hD).
  apply: (plane_still hD) zw;
    [exact: spared_camera | exact: spared_point | exact: (generic_point F o11 room nf w) |].
  by case: (generic_line char0 o11 room nf w jp).
have [e1 e2] := two_planes (generic_meeting char0 o11 room nf uv jp) (plane u k2) (plane v z).
move: Di; have -> : to F n 'X_i = gx i by rewrite /generic valK.
rewrite /= nf in e1 e2; have [ei|i1] := eqVneq (val i) turning; first by rewrite ei e1 eqxx.
have [ei|i2] := eqVneq (val i) turning.+1; first by rewrite ei /turning -addnS e2 eqxx.
by rewrite sD // eqxx.
Qed.
End Move.

(** ** The view that gains the pin *)
Lemma same_viewP v w : reflect (v = w) (same_view v w).
Proof. by apply: (iffP idP); case: v; case: w. Qed.
Lemma reveal_proper f j u v : proper f -> dangles f j u v -> proper (reveal f j v).
Proof.
move=> pf /and5P[nf jp pv jv _].
have h w : (let: (point, js) := looks (reveal f j v) w in [&& uniq js, all (fun j => j < pins f)%N js &
    if free f then ~~ point else point || (size js <= 1)%N]) = true.
  have [u1 le sp] := properP w pf; rewrite [looks _ w]/=; case: same_viewP => [e|_]; last first.
    by move: u1 le sp; rewrite /sees_pins /sees_point; case: (looks f w) => p js /= -> -> ->.
  by rewrite /= e jv jp (negbTE nf) pv -e u1 le.
apply/andP; split; first by rewrite /= (negbTE nf).
by apply/and4P; split; [exact: (h V1) | exact: (h V2) | exact: (h V3) |].
Qed.

Section All.
Variables (R : idomainType) (x : nat -> R).
Lemma scene_all (G : feature * (nat -> R) -> bool) o A : is_problem A ->
  (forall g o', proper g -> (o <= o')%N -> (o' + dim3 g <= o + sumn [seq dim3 f | f <- A])%N ->
    G (g, fun k => x (o' + k)%N)) -> all G (scene x o A).
Proof.
elim: A o => //= f A IH o /andP[pf pA] h; apply/andP; split.
  by apply: h => //; rewrite leq_add2l leq_addr.
apply: IH => // g o' pg le le'; apply: h => //; last by rewrite addnA.
by apply: leq_trans le; exact: leq_addr.
Qed.
End All.
Lemma perm_insert (T : eqType) (p V V' s r : seq T) : perm_eq V (V' ++ r) ->
  perm_eq (p ++ V ++ s) ((p ++ V' ++ s) ++ r).
Proof. by move=> /seq.permP e; apply/seq.permP => q; rewrite !count_cat e count_cat; lia. Qed.

Lemma perm_views (T : eqType) (g g' : view -> seq T) s v :
  (forall w, perm_eq (g' w) (g w ++ (if same_view w v then s else [::]))) ->
  perm_eq (flatten [seq g' w | w <- views]) (flatten [seq g w | w <- views] ++ s).
Proof.
move=> e; apply/seq.permP => q; rewrite /= !count_cat !(seq.permP (e _)) !count_cat.
by case: v {e}; rewrite /= ?addn0; lia.
Qed.

Lemma image_more (K : fieldType) (fx : feature * (nat -> K)) C j js
  (N := normal C (point_at fx.1 fx.2) (dir_at fx.1 fx.2 j)) :
  perm_eq (image fx C (true, j :: js)) (image fx C (true, js) ++ [:: x1 N / x2 N]).
Proof. by apply/seq.permP => q; rewrite /image /= !count_cat /= -/N; lia. Qed.

Section Step.
Variables (F : fieldType) (pre post : problem) (f : feature) (j : nat) (u v : view).
Hypothesis char0 : [char F] =i pred0.
Notation A := (pre ++ f :: post).
Notation A' := (pre ++ reveal f j v :: post).
Hypothesis pA : is_problem A.
Hypothesis hj : dangles f j u v.
Notation n := (parameters A).
Notation o := (11 + sumn [seq dim3 g | g <- pre])%N.
Notation K := [fieldType of {fraction {mpoly F[n]}}].
Notation gx := (generic F n).
Notation C := (cameras_at K gx).
Notation at_ o := (fun k => gx (o + k)%N).
Notation c := (const (to F n)).
Notation w0 := (slope F n o f j v).
Let nf : free f = false. Proof. by case/andP: hj => /negbTE. Qed.
Let jp : (j < pins f)%N. Proof. by case/and3P: hj. Qed.
Let pv : sees_point f v. Proof. by case/and4P: hj. Qed.
Let jv : j \notin sees_pins f v. Proof. by case/and5P: hj. Qed.
Let uv : u <> v. Proof. by case/and5P: hj => _ _ _ _ /andP[/same_viewP]. Qed.
Let only w : j \in sees_pins f w -> w = u.
Proof.
case/and5P: hj => _ _ _ _ /andP[_ /and4P[h1 h2 h3 _]] jw.
by apply/same_viewP; case: w jw; exact/implyP.
Qed.
Let parts : [/\ is_problem pre, proper f & is_problem post].
Proof. by move: pA; rewrite /is_problem all_cat => /and3P[]. Qed.
Let room : (o + dim3 f <= n)%N.
Proof. by rewrite /parameters map_cat sumn_cat /= -addnA !leq_add2l leq_addr. Qed.
Let o11 : (11 <= o)%N. Proof. exact: leq_addr. Qed.
Lemma sceneE g : dim3 g = dim3 f -> scene gx 11 (pre ++ g :: post) =
  scene gx 11 pre ++ (g, at_ o) :: scene gx (o + dim3 f) post.
Proof. by move=> e; rewrite scene_cat /= e. Qed.

Lemma reveal_image w : perm_eq (image (reveal f j v, at_ o) (C w) (looks (reveal f j v) w))
  (image (f, at_ o) (C w) (looks f w) ++ (if same_view w v then [:: w0] else [::])).
Proof.
rewrite [looks _ w]/=; case: same_viewP => [->|_]; last by rewrite cats0.
have -> : looks f v = (true, sees_pins f v) by rewrite -pv /sees_point /sees_pins -surjective_pairing.
rewrite pv; exact: (@image_more K (f, at_ o)).
Qed.
Lemma reveal_images : perm_eq (rcons (images F n A) w0) (images F n A').
Proof.
rewrite perm_sym -cats1 !images_atE /images_at !sceneE // !map_cat !flatten_cat.
by apply: perm_insert; apply: perm_views; exact: reveal_image.
Qed.

(** The pin turns: what then stays. *)
Variable D : K -> K.
Hypothesis hD : derivation c D.
Hypothesis sD : spares o j D.
Hypothesis uD : D (slope F n o f j u) = 0.
Lemma turning_images : killed D (images F n A).
Proof.
have [p1 p2 p3] := parts.
have cat s t : killed D s -> killed D t -> killed D (s ++ t) by rewrite /killed all_cat => -> ->.
have -> : images F n A = seen C (scene gx 11 pre) ++ views_of C (f, at_ o) ++
    seen C (scene gx (o + dim3 f) post).
  by rewrite images_atE /images_at sceneE // map_cat flatten_cat.
have out A0 o0 : is_problem A0 -> (o0 + sumn [seq dim3 g | g <- A0] <= o)%N \/ (o + dim3 f <= o0)%N ->
    killed D (seen C (scene gx o0 A0)).
  move=> pA0 h; rewrite killed_flatten; apply: scene_all => // g o' pg le le'.
  have [|hX hd] := spared_other o11 room nf jp hD sD (g := g) (o' := o').
    by case: h => h; [left; exact: leq_trans le' h | right; exact: leq_trans h le].
  rewrite /views_of killed_flatten; apply: all_views => w; apply: (dead_image hD) => //.
    exact: (spared_camera o11 hD sD).
  by move=> i il; apply: hd; have [_ /allP le0 _] := properP w pg; exact: le0.
apply: (cat); first by apply: out => //; left.
apply: (cat); last by apply: out => //; right.
rewrite /views_of killed_flatten; apply: all_views => w.
by apply: (spared_image char0 o11 room nf jp hD sD p2) => /only ->.
Qed.
End Step.

Section StepTheorem.
Variables (F : fieldType) (pre post : problem) (f : feature) (j : nat) (u v : view).
Hypothesis char0 : [char F] =i pred0.
Notation A := (pre ++ f :: post).
Notation A' := (pre ++ reveal f j v :: post).
Hypothesis pA : is_problem A.
Hypothesis hj : dangles f j u v.
Notation n := (parameters A).
Notation o := (11 + sumn [seq dim3 g | g <- pre])%N.
Notation c := (const (to F n)).
Lemma reveal_parameters : parameters A' = n.
Proof. by rewrite /parameters !map_cat. Qed.
Lemma turning_derivation : exists D, [/\ derivation c D, spares o j D, D (slope F n o f j u) = 0,
  D (slope F n o f j v) != 0 & killed D (images F n A)].
Proof.
have room : (o + dim3 f <= n)%N by rewrite /parameters map_cat sumn_cat /= -addnA !leq_add2l leq_addr.
have /and5P[/negbTE nf jp _ _ /andP[/same_viewP uv _]] := hj.
have [D [hD sD uD vD]] := move char0 (leq_addr _ _ : (11 <= o)%N) room nf jp uv.
by exists D; split=> //; exact: (turning_images char0 pA hj hD sD uD).
Qed.
Theorem reveal_minimal : camera_minimal F A <-> camera_minimal F A'.
Proof.
have [D [hD sD uD vD kD]] := turning_derivation; rewrite /camera_minimal reveal_parameters.
have p := reveal_images F pre post hj; set w := slope _ _ _ _ _ _ in vD p.
have zD k : (k < 11)%N -> D (generic F n k) = 0 by exact: (spared_first (leq_addr _ _) sD).
split=> -[iy cy].
  split; first exact: (ind_perm p (moved_ind char0 hD kD vD iy)).
  move=> k /cy; apply: (@alg_sub _ _ c) => a ay; by rewrite -(perm_mem p) mem_rcons inE ay orbT.
have iw : ind c (rcons (images F n A) w) by apply: ind_perm (iy : ind c _); rewrite perm_sym.
split; first by move: (iw); rewrite -cats1 => /ind_catl.
move=> k k11; apply: (moved_alg char0 hD kD vD iw (zD k k11)).
by apply: alg_sub (cy k k11 : alg c _ _) => a; rewrite (perm_mem p).
Qed.
End StepTheorem.

Theorem replacements_theorem : replacements.
Proof.
move=> F char0 A f B j u pA; have cm v : dangles f j u v ->
    camera_minimal F (A ++ f :: B) <-> camera_minimal F (A ++ reveal f j v :: B).
  by move=> dv; exact: (reveal_minimal char0 pA dv).
split=> // v w dv dw; have pf : proper f by move: pA; rewrite /is_problem all_cat => /and3P[].
have dims t : dangles f j u t -> dim2 (reveal f j t) = (dim2 f).+1.
  case/and5P=> _ _ pt jt _; have one z : seen_by (reveal f j t) z = (seen_by f z + same_view z t)%N.
    rewrite /seen_by /sees_point /sees_pins /=; case: same_viewP => [->|_]; rewrite ?addn0 //.
    by rewrite -/(sees_point f t) pt /= addn1 !addnS.
  by rewrite !dim2E !one; case: (t) => /=; lia.
have balanced : is_balanced (A ++ reveal f j v :: B) <-> is_balanced (A ++ reveal f j w :: B).
  by rewrite /is_balanced /parameters !map_cat !sumn_cat /= (dims v dv) (dims w dw).
rewrite !(camera_minimal_theorem char0); have := cm v dv; have := cm w dw; tauto.
Qed.
