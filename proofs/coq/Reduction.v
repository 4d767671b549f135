(** * The reduced minimal problems consist of the 27 features

    In a minimal problem only the zero derivation kills the images. Let a feasible selection take at
    least as many degrees of freedom from space as from the images. A derivation that kills what is
    kept and the images of what is forgotten kills all images, so it is zero. Hence these elements
    are independent: the problem is reducible. *)
From mathcomp Require Import all_ssreflect all_algebra.
From mathcomp.zify Require Import zify.
From SsrMultinomials Require Import mpoly.
From PL1P Require Import Statement Reducible Forget Derivations RationalFunctions Independence Generic
  Lifting.
Set Implicit Arguments.
Unset Strict Implicit.
Unset Printing Implicit Defensive.
Import GRing.Theory.

(** ** Sizes *)
Definition cost f c := space (keep f c) + (lost_seen f c V1 + lost_seen f c V2 + lost_seen f c V3).

Lemma lost_dim2 f c : proper f -> feasible f c ->
  (lost_seen f c V1 + lost_seen f c V2 + lost_seen f c V3) + dim2 (keep f c) = dim2 f.
Proof.
move=> pf fc; rewrite !dim2E -(seen_split V1 pf fc) -(seen_split V2 pf fc) -(seen_split V3 pf fc).
by move: (lost_seen f c V1) (lost_seen f c V2) (lost_seen f c V3) => n1 n2 n3; lia.
Qed.
Lemma cost_strict f c : proper f -> feasible f c -> strict f c = (dim3 f < cost f c).
Proof.
move=> pf fc; rewrite /strict /cost -(lost_dim2 pf fc).
by move: (_ + _ + lost_seen f c V3) (dim2 _) (dim3 f) (space _) => n1 n2 n3 n4; lia.
Qed.
Lemma cost_whole f c : proper f -> whole f c -> dim3 f <= cost f c.
Proof.
move=> pf /andP[fc /eqP sz]; apply: leq_trans (leq_addr _ _); rewrite /space /nothing /dim3 /= sz.
move: fc; have [fr|fr] := boolP (free f); rewrite /= => h; first by rewrite (free_pins pf fr).
by rewrite h.
Qed.
Definition everything f : selection := (true, iota 0 (pins f)).
Lemma everything_ok f : proper f ->
  [/\ feasible f (everything f), whole f (everything f) & cost f (everything f) <= dim3 f].
Proof.
move=> pf; have fe : feasible f (everything f).
  by rewrite /feasible /= iota_uniq /= andbT; apply/allP => j; rewrite mem_iota.
have we : whole f (everything f) by rewrite /whole /= orbT size_iota /=.
split=> //; rewrite /cost; have lv v : lost_seen f (everything f) v = 0.
  have [_ le _] := properP v pf; rewrite /lost_seen /= andbF add0n.
  rewrite (_ : [seq j <- _ | _] = [::]) ?muln0 //; apply/eqP; rewrite -[_ == _]negbK -has_filter.
  by apply/hasPn => j jl; rewrite negbK mem_iota; exact: (allP le).
by rewrite !lv !addn0 /space /dim3 /= orbF size_iota; case: ifP.
Qed.

Section Sizes.
Variables (K : fieldType) (C : view -> camera K) (x : nat -> K).
Local Notation views_of g := (flatten [seq g (C v) v | v <- views]).
Lemma size_flatten_const T (g : T -> seq K) k l : (forall i, size (g i) = k) ->
  size (flatten [seq g i | i <- l]) = k * size l.
Proof. by move=> h; elim: l => [|i l IH]; rewrite ?muln0 //= size_cat IH h mulnS. Qed.
Lemma size_line p (n : vec K) : size (line_image p n) = if p then 1 else 2.
Proof. by case: p. Qed.
Lemma size_lines p (g : nat -> vec K) js : size (flatten [seq line_image p (g j) | j <- js]) =
  (if p then 1 else 2) * size js.
Proof. by apply: size_flatten_const => j; exact: size_line. Qed.
Lemma size_image (fx : feature * (nat -> K)) D v : size (image fx D (looks fx.1 v)) = seen_by fx.1 v.
Proof.
rewrite /image size_cat size_lines /seen_by /sees_point /sees_pins.
by case: (looks fx.1 v).1; rewrite ?mul1n.
Qed.
Lemma size_lost (fx : feature * (nat -> K)) c D v : size (lost_image fx c D (looks fx.1 v)) =
  lost_seen fx.1 c v.
Proof.
rewrite /lost_image size_cat size_lines /lost_seen /sees_point /sees_pins; congr (_ + _).
by case: (looks fx.1 v).1; case: c.1; case: (has _ _).
Qed.
Lemma size_kept (fx : feature * (nat -> K)) c : size (kept_parameters fx c) = dim3 (keep fx.1 c).
Proof.
rewrite /kept_parameters size_cat (size_flatten_const (k := 2)) //.
by rewrite /dim3; case: (free (keep fx.1 c)).
Qed.
Lemma size_views (g : camera K -> view -> seq K) (m : view -> nat) : (forall v, size (g (C v) v) = m v) ->
  size (views_of g) = m V1 + m V2 + m V3.
Proof. by move=> h; rewrite /= !size_cat !h addn0 addnA. Qed.
Lemma size_images_at o A :
  size (flatten [seq views_of (fun D v => image fx D (looks fx.1 v)) | fx <- scene x o A]) =
    sumn [seq dim2 f | f <- A].
Proof.
elim: A o => // f A IH o; rewrite -[scene _ _ _]/((f, fun k => x (o + k)) :: scene x (o + dim3 f) A).
rewrite 2!map_cons -[flatten (_ :: _)]/(_ ++ _) size_cat IH -[sumn (_ :: _)]/(_ + _); congr (_ + _).
rewrite dim2E; set fx := (f, _).
exact: (@size_views (fun D v => image fx D (looks f v)) (seen_by f) (fun v => size_image fx (C v) v)).
Qed.
Lemma size_lifting_at o A cs : size cs = size A ->
  size (flatten [seq kept_parameters fxc.1 fxc.2 | fxc <- zip (scene x o A) cs & ~~ nothing
    (keep fxc.1.1 fxc.2)]) +
  size (flatten [seq views_of (fun D v => lost_image fxc.1 fxc.2 D (looks fxc.1.1 v)) | fxc <- zip
    (scene x o A) cs]) =
  sumn [seq cost fc.1 fc.2 | fc <- zip A cs].
Proof.
elim: A o cs => [|f A IH] o [|c cs] // [sz].
rewrite -[scene _ _ _]/((f, fun k => x (o + k)) :: scene x (o + dim3 f) A); set fx := (f, _).
rewrite -[zip (fx :: _) _]/((fx, c) :: zip (scene x (o + dim3 f) A) cs)
  -[zip (f :: A) _]/((f, c) :: zip A cs).
rewrite 2!map_cons -[flatten (_ :: _)]/(_ ++ _) -[sumn (_ :: _)]/(cost f c + sumn _) -(IH (o + dim3 f) _ sz).
have e := @size_views (fun D v => lost_image fx c D (looks f v)) (lost_seen f c)
  (fun v => size_lost fx c (C v) v).
cbv beta in e; rewrite size_cat e.
have -> (l : seq (feature * (nat -> K) * selection)) :
    size (flatten [seq kept_parameters fxc.1 fxc.2 | fxc <- (fx, c) :: l & ~~ nothing (keep fxc.1.1 fxc.2)]) =
    space (keep f c) + size (flatten [seq kept_parameters fxc.1 fxc.2 | fxc <- l & ~~ nothing
      (keep fxc.1.1 fxc.2)]).
  rewrite /space -[filter _ (_ :: _)]/(if ~~ nothing (keep f c) then (fx, c) :: filter _ l else filter _ l).
  by case: (nothing (keep f c)) => //; rewrite map_cons -[flatten (_ :: _)]/(_ ++ _) size_cat (size_kept fx).
by rewrite addnACA.
Qed.
End Sizes.

(** ** Over a field F of characteristic 0 *)
Section Over.
Variable F : fieldType.
Hypothesis char0 : [char F]%R =i pred0.
Local Open Scope ring_scope.
Notation K n := [fieldType of {fraction {mpoly F[n]}}].
Definition to n : {rmorphism {mpoly F[n]} -> K n} := [rmorphism of @FracField.tofrac _].
Lemma to0 n p : (to n p == 0) = (p == 0). Proof. exact: tofrac_eq0. Qed.

Lemma minimalP A : minimal F A <->
  size (images F (parameters A) A) = parameters A /\ unmoved (to (parameters A)) (images F (parameters A) A).
Proof. exact: (criterion (@den_neq0 _) (@fractionE _) (@to0 _) char0). Qed.

Lemma size_images A n : size (images F n A) = sumn [seq dim2 f | f <- A].
Proof. exact: (size_images_at (cameras_at (K n) (generic F n))). Qed.

(** What is kept and the images of what is lost. *)
Definition lifted n A cs := mkseq (generic F n) 11 ++
  flatten [seq kept_parameters fxc.1 fxc.2 | fxc <- zip (scene_of F n A) cs & ~~ nothing (keep fxc.1.1 fxc.2)]
    ++
  flatten [seq each_view (fun C v => lost_image fxc.1 fxc.2 C (looks fxc.1.1 v)) | fxc <- zip
    (scene_of F n A) cs].
Lemma size_lifted n A cs : size cs = size A -> size (lifted n A cs) =
  (11 + sumn [seq cost fc.1 fc.2 | fc <- zip A cs])%N.
Proof. by move=> sz; rewrite !size_cat size_mkseq (size_lifting_at (cameras_at (K n) (generic F n))). Qed.

(** ** A problem of final features is reduced *)
Lemma final_reduced A : is_problem A -> all final A -> reduced F A.
Proof.
move=> pA fA cs [/and3P[/eqP sz fs nw] li].
have := ind_size (to := to (parameters A)) (@den_neq0 _) (@fractionE _) (y := lifted (parameters A) A cs) li.
rewrite size_lifted // /parameters leq_add2l leqNgt => /negP; apply.
elim: A cs pA fA sz fs nw {li} => [|f A IH] [|c cs] // /andP[pf pA] /andP[ff fA] [sz] /= /andP[fc fs].
have le (B : problem) ds : is_problem B -> all final B -> size ds = size B ->
  all (fun fc => feasible fc.1 fc.2) (zip B ds) ->
    (sumn [seq dim3 f | f <- B] <= sumn [seq cost fc.1 fc.2 | fc <- zip B ds])%N.
  elim: B ds => [|g B IHB] [|d ds] // /andP[pg pB] /andP[fg fB] [sd] /= /andP[fd fds]; apply: leq_add;
    last exact: IHB.
  have [wd|nwd] := boolP (whole g d); first exact: cost_whole.
  by apply: ltnW; rewrite -cost_strict //; exact: final_strict.
have [wc|nwc _] := boolP (whole f c).
  by move=> /= nw; rewrite -addnS leq_add //; [exact: cost_whole | exact: IH].
by rewrite -addSn leq_add //; [rewrite -cost_strict //; exact: final_strict | exact: le].
Qed.

(** ** A minimal problem with another feature is reducible *)
Section Killed.
Variables (K' : fieldType) (c0 : {rmorphism F -> K'}) (D : K' -> K') (C : view -> camera K') (x : nat -> K')
  (n : nat).
Hypothesis hD : derivation c0 D.
Hypothesis hC : forall v, dead_camera D (C v).
Local Notation own o := (fun k => x (o + k)%N).
Hypothesis points : forall f o v, (11 <= o)%N -> (o + dim3 f <= n)%N -> free f = false ->
  x3 (project (C v) (point_at f (own o))) != 0.
Hypothesis lines : forall f o v j, (11 <= o)%N -> (o + dim3 f <= n)%N -> free f = false -> (j < pins f)%N ->
  x2 (normal (C v) (point_at f (own o)) (dir_at f (own o) j)) != 0.
Local Notation views_of g := (flatten [seq g (C v) v | v <- views]).

Lemma killed_views (g : camera K' -> view -> seq K') : killed D (views_of g) =
  all (fun v => killed D (g (C v) v)) views.
Proof. exact: killed_flatten. Qed.

Lemma scene_killed A o cs : (11 <= o)%N -> (o + sumn [seq dim3 f | f <- A] <= n)%N -> is_problem A ->
  size cs = size A ->
  all (fun fc => feasible fc.1 fc.2) (zip A cs) ->
  killed D (flatten [seq kept_parameters fxc.1 fxc.2 | fxc <- zip (scene x o A) cs & ~~ nothing
    (keep fxc.1.1 fxc.2)]) ->
  killed D (flatten [seq views_of (fun E v => lost_image fxc.1 fxc.2 E (looks fxc.1.1 v)) | fxc <- zip
    (scene x o A) cs]) ->
  killed D (flatten [seq views_of (fun E v => image fx E (looks fx.1 v)) | fx <- scene x o A]).
Proof.
rewrite !killed_flatten; elim: A o cs => [|f A IH] o [|c cs] // o11 room /andP[pf pA] [sz] /andP[fc fs].
rewrite -[scene _ _ _]/((f, own o) :: scene x (o + dim3 f) A).
have room1 : (o + dim3 f <= n)%N by apply: leq_trans room; rewrite leq_add2l leq_addr.
have room2 : (o + dim3 f + sumn [seq dim3 g | g <- A] <= n)%N by rewrite -addnA.
set fx := (f, own o); rewrite -[zip (fx :: _) _]/((fx, c) :: zip (scene x (o + dim3 f) A) cs).
rewrite all_filter -![all _ (_ :: _)]/(_ && all _ _) -all_filter => /andP[hk hks] /andP[hl hls].
apply/andP; split; last by apply: (IH _ cs) => //; exact: leq_trans o11 (leq_addr _ _).
rewrite (killed_views (fun E v => image fx E (looks f v))); move: hl.
rewrite (killed_views (fun E v => lost_image fx c E (looks f v))); apply: sub_all => v.
apply: (local_killed hD pf fc (hC v)) => [/negbTE nf _|/negbTE nf j jp|].
- exact: points.
- exact: lines.
- exact/implyP.
Qed.
End Killed.

Lemma minimal_lifting A cs : is_problem A -> minimal F A -> size cs = size A ->
  all (fun fc => feasible fc.1 fc.2) (zip A cs) ->
  (sumn [seq cost fc.1 fc.2 | fc <- zip A cs] <= sumn [seq dim3 f | f <- A])%N ->
    lifting F (parameters A) A cs.
Proof.
move=> pA /minimalP[_ un] sz fs le.
apply: (@unmoved_ind _ _ _ (to (parameters A)) _ _ (@den_neq0 _) (@fractionE _) (@to0 _) char0
  (lifted (parameters A) A cs)).
  by rewrite size_lifted // leq_add2l.
move=> D hD; rewrite /lifted !killed_cat => /and3P[kc kk kl]; apply: un => //.
have g k : (k < 11)%N -> D (generic F (parameters A) k) = 0.
  by move=> h; have /(all_nthP 0)/(_ k) := kc; rewrite size_mkseq nth_mkseq // => /(_ h)/eqP.
have D0 := der0 hD; have D1 := der1 hD.
have hC v : dead_camera D (cameras_at (K (parameters A)) (generic F (parameters A)) v).
  by case: v; split=> //; try split; rewrite ?[in LHS]/= ?g ?D0 ?D1.
have h1 f o v : (11 <= o)%N -> (o + dim3 f <= parameters A)%N -> free f = false ->
    x3 (project (cameras_at (K (parameters A)) (generic F (parameters A)) v)
      (point_at f (fun k => generic F (parameters A) (o + k)))) != 0.
  by move=> o11 room nf; exact: (generic_point F o11 room nf).
have h2 f o v j : (11 <= o)%N -> (o + dim3 f <= parameters A)%N -> free f = false -> (j < pins f)%N ->
    x2 (normal (cameras_at (K (parameters A)) (generic F (parameters A)) v)
      (point_at f (fun k => generic F (parameters A) (o + k)))
      (dir_at f (fun k => generic F (parameters A) (o + k)) j)) != 0.
  by move=> o11 room nf jp; case: (generic_line char0 o11 room nf v jp).
exact: (scene_killed hD hC h1 h2 (leqnn 11) (leqnn _) pA sz fs kk kl).
Qed.

Lemma minimal_reducible A cs : is_problem A -> minimal F A -> forgets A cs ->
  (sumn [seq cost fc.1 fc.2 | fc <- zip A cs] <= sumn [seq dim3 f | f <- A])%N -> reducible F A cs.
Proof. by move=> pA mA fo le; split=> //; case/and3P: (fo) => /eqP sz fs _; exact: minimal_lifting. Qed.

Lemma find_reduction A : is_problem A -> ~~ all final A -> exists2 cs, forgets A cs &
  (sumn [seq cost fc.1 fc.2 | fc <- zip A cs] <= sumn [seq dim3 f | f <- A])%N.
Proof.
elim: A => // f A IH /andP[pf pA]; rewrite [all _ _]/=.
case: (not_final pf) => [ff|[c /andP[fc nw] ns] _].
  rewrite ff => /= /IH[//|cs /and3P[sz fs nw] le]; have [e1 e2 e3] := everything_ok pf.
  exists (everything f :: cs); last by rewrite /= leq_add.
  by rewrite /forgets /= eqSS sz e1 e2 fs nw.
have [e1 e2] : all (fun fc => feasible fc.1 fc.2) (zip A (map everything A)) /\
    (sumn [seq cost fc.1 fc.2 | fc <- zip A (map everything A)] <= sumn [seq dim3 f | f <- A])%N.
  elim: A pA {IH} => // g A IH /andP[pg /IH[h1 h2]] /=; have [e1 _ e3] := everything_ok pg.
  by rewrite e1 h1 leq_add.
exists (c :: map everything A); first by rewrite /forgets /= size_map eqxx fc e1 /= (negbTE nw).
by rewrite /= leq_add //; rewrite cost_strict // -leqNgt in ns.
Qed.

(** ** One point that all views see: camera 3 slides along its ray *)
Section Slide.
Variables (K' : fieldType) (c0 : {rmorphism F -> K'}) (D : K' -> K') (C : view -> camera K')
  (fx : feature * (nat -> K')).
Hypothesis hD : derivation c0 D.
Notation X := (point_at fx.1 fx.2).
Notation p := (project (C V3) X).
Notation C0 := (Camera (quat_of (C V3)) (vec0 K')).
Hypothesis h1 : dead_camera D (C V1).
Hypothesis h2 : dead_camera D (C V2).
Hypothesis h3 : dead_camera D C0.
Hypothesis t1 : D (x1 (trans (C V3))) = x1 p.
Hypothesis t2 : D (x2 (trans (C V3))) = x2 p.
Hypothesis t3 : D (x3 (trans (C V3))) = x3 p.
Hypothesis hX : dead D X.
Hypothesis hd : forall j, dead D (dir_at fx.1 fx.2 j).
Hypothesis seen : sees_point fx.1 V3.

Lemma same_growth a b : D a = a -> D b = b -> D (a / b) = 0.
Proof.
move=> ha hb; have [->|b0] := eqVneq b 0; first by rewrite invr0 mulr0 (der0 hD).
by rewrite (der_div hD) // ha hb subrr mul0r.
Qed.
Lemma turn_dead u : dead D u -> dead D (turn (C V3) u). Proof. exact: (dead_turn hD h3). Qed.
Lemma point_grows : [/\ D (x1 p) = x1 p, D (x2 p) = x2 p & D (x3 p) = x3 p].
Proof.
have [e1 e2 e3] := turn_dead hX; split.
- by rewrite {1}[x1 p]/(x1 (turn (C V3) X) + x1 (trans (C V3))) (derD hD) e1 t1 add0r.
- by rewrite {1}[x2 p]/(x2 (turn (C V3) X) + x2 (trans (C V3))) (derD hD) e2 t2 add0r.
- by rewrite {1}[x3 p]/(x3 (turn (C V3) X) + x3 (trans (C V3))) (derD hD) e3 t3 add0r.
Qed.
Lemma slope_still j : let n := normal (C V3) X (dir_at fx.1 fx.2 j) in D (x1 n / x2 n) = 0.
Proof.
have [p1 p2 p3] := point_grows; have [e1 e2 e3] := turn_dead (hd j).
rewrite /normal; move: (turn _ _) e1 e2 e3 (p) p1 p2 p3 => e e1 e2 e3 q p1 p2 p3.
apply: same_growth; rewrite /cross /= !(derB hD) !(derM hD).
  by rewrite p2 p3 e2 e3 !mulr0 !addr0.
by rewrite p1 p3 e1 e3 !mulr0 !addr0.
Qed.
Lemma slide_killed : killed D (flatten [seq image fx (C v) (looks fx.1 v) | v <- views]).
Proof.
have dead_view v : dead_camera D (C v) -> killed D (image fx (C v) (looks fx.1 v)).
  by move=> hC; apply: (dead_image hD hC hX) => j _.
rewrite killed_flatten; apply/and4P; split=> //; [exact: dead_view | exact: dead_view |].
rewrite /image killed_cat killed_flatten; move: seen; rewrite /sees_point => ->; have [p1 p2 p3] :=
  point_grows.
apply/andP; split; first by rewrite /killed /= !same_growth // eqxx.
by apply/allP => j _; rewrite /killed /= slope_still eqxx.
Qed.
End Slide.

Lemma single_not_minimal f : proper f -> full f -> ~ minimal F [:: f].
Proof.
move=> pf ff /minimalP[_ un]; set n := parameters _ in un; have nf : free f = false
  by case/andP: ff => /negbTE.
have room : (11 + dim3 f <= n)%N by rewrite /n /parameters /= addn0.
pose gx := generic F n; pose x k := gx (11 + k)%N; pose C := cameras_at (K n) gx.
pose p := project (C V3) (point_at f x).
pose d (i : 'I_n) := if val i == 8%N then x1 p else if val i == 9%N then x2 p else if val i == 10%N then x3 p
  else 0.
pose D := extension (to n) (@numerator _) (@denominator _) d.
have hD : derivation (const (to n)) D by exact: (extension_derivation (@den_neq0 _) (@fractionE _) (@to0 n)).
have DX i : D (to n 'X_i) = d i by exact: (extension_param (@den_neq0 _) (@fractionE _) (@to0 n)).
clearbody D.
have Dg k (kn : (k < n)%N) : D (gx k) = d (Ordinal kn) by rewrite -DX /gx /generic insubT.
have small k : (k < 11)%N -> (k < n)%N by move=> h; apply: leq_trans room; exact: ltn_addr.
have D0 := der0 hD; have D1 := der1 hD.
have rest k : (k < 8)%N || (10 < k)%N -> D (gx k) = 0.
  move=> k8; case: (ltnP k n) => kn; last by rewrite /gx /generic insubF // ltnNge kn.
  by rewrite (Dg k kn) /d [val _]/=; case: eqP k8 => [->//|_]; case: eqP => [->//|_]; case: eqP => [->//|].
have own k : D (x k) = 0 by apply: rest.
have hX : dead D (point_at f x) by rewrite /point_at nf; split; exact: own.
have hd j : dead D (dir_at f x j) by split; [exact: own | exact: own | exact: D1].
have h1 : dead_camera D (C V1) by split=> //; split.
have h2 : dead_camera D (C V2) by split=> //; first [exact: rest | split=> //; exact: rest].
have h3 : dead_camera D (Camera (quat_of (C V3)) (vec0 (K n))) by split=> //; first [exact: rest | split].
have [e1 e2 e3] : [/\ D (gx 8%N) = x1 p, D (gx 9%N) = x2 p & D (gx 10%N) = x3 p].
  by split; [rewrite (Dg _ (small 8%N isT)) | rewrite (Dg _ (small 9%N isT)) | rewrite
    (Dg _ (small 10%N isT))].
have kill : killed D (images F n [:: f]).
  rewrite /images -[flatten _]/(_ ++ [::]) cats0.
  exact: (@slide_killed _ _ D C (f, x) hD h1 h2 h3 e1 e2 e3 hX hd (full_point V3 ff)).
have := un D hD kill (Ordinal (small 10%N isT)); rewrite DX => p30.
by have := generic_point F (leqnn 11) room nf V3;
  rewrite -[x3 _]/(x3 p) -[x3 p]/(d (Ordinal (small 10%N isT))) p30 eqxx.
Qed.

(** ** The theorem *)
Lemma unknown_weight A : is_problem A -> all final A -> ~~ known A ->
  (11 + sumn [seq dim3 f | f <- A] <= sumn [seq dim2 f | f <- A])%N /\
  ((sumn [seq dim2 f | f <- A] <= 11 + sumn [seq dim3 f | f <- A])%N -> exists2 f, A = [:: f] & full f).
Proof.
have le B : is_problem B -> all final B ->
    (size B + sumn [seq dim3 f | f <- B] <= sumn [seq dim2 f | f <- B])%N.
  elim: B => //= g B IH /andP[pg pB] /andP[fg fB]; have := final_weight pg fg; have := IH pB fB.
  by move: (dim2 g) (dim3 g) (sumn _) (sumn _) => n1 n2 n3 n4; lia.
elim: A => // f A IH /andP[pf pA] /andP[ff fA]; rewrite [known _]/= negb_and => /orP[nk|nk].
  have [fu p8 e] := final_unknown pf ff nk; have := le A pA fA; rewrite /= e.
  case: A {IH pA fA} => [|g A] /=; last by move: (dim2 g) (dim3 g) (sumn _) (sumn _) => n1 n2 n3 n4; lia.
  by move=> _; split; [lia | move=> _; exists f].
have [h _] := IH pA fA nk; have := final_weight pf ff; move: h => /=.
by move: (dim2 f) (dim3 f) (sumn _) (sumn _) => n1 n2 n3 n4; lia.
Qed.

Lemma reduced_known A : is_problem A -> minimal F A -> reduced F A -> known A.
Proof.
move=> pA mA rA; have fA : all final A.
  apply/negPn/negP => /(find_reduction pA)[cs fo le]; exact: rA cs (minimal_reducible pA mA fo le).
apply/negPn/negP => /(unknown_weight pA fA)[_ one].
have [sz _] := (minimalP A).1 mA; rewrite size_images in sz.
have [|f e fu] := one; first by rewrite sz.
by move: pA mA; rewrite e => /andP[pf _]; exact: single_not_minimal.
Qed.
End Over.

Theorem reduction_theorem : reduction.
Proof.
move=> F char0 A pA; split=> [kA|]; last exact: reduced_known.
by apply: final_reduced => //; apply: sub_all kA => f kf; apply/orP; left.
Qed.
