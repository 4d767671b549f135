(** * A problem of the 27 features is reduced; anything else loses nothing that the images need *)
From mathcomp Require Import all_ssreflect all_algebra.
From mathcomp.zify Require Import zify.
From SsrMultinomials Require Import mpoly.
From PL1P Require Import Statement Reducible Forget Derivations RationalFunctions Independence.
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
Lemma everything_ok f : proper f -> [/\ feasible f (everything f), whole f (everything f) & cost f (everything f) <= dim3 f].
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
Lemma size_flatten_const T (g : T -> seq K) k l : (forall i, size (g i) = k) -> size (flatten [seq g i | i <- l]) = k * size l.
Proof. by move=> h; elim: l => [|i l IH]; rewrite ?muln0 //= size_cat IH h mulnS. Qed.
Lemma size_line p (n : vec K) : size (line_image p n) = if p then 1 else 2.
Proof. by case: p. Qed.
Lemma size_lines p (g : nat -> vec K) js : size (flatten [seq line_image p (g j) | j <- js]) = (if p then 1 else 2) * size js.
Proof. by apply: size_flatten_const => j; exact: size_line. Qed.
Lemma size_image (fx : feature * (nat -> K)) D v : size (image fx D (looks fx.1 v)) = seen_by fx.1 v.
Proof.
rewrite /image size_cat size_lines /seen_by /sees_point /sees_pins.
by case: (looks fx.1 v).1; rewrite ?mul1n.
Qed.
Lemma size_lost (fx : feature * (nat -> K)) c D v : size (lost_image fx c D (looks fx.1 v)) = lost_seen fx.1 c v.
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
  size (flatten [seq views_of (fun D v => image fx D (looks fx.1 v)) | fx <- scene x o A]) = sumn [seq dim2 f | f <- A].
Proof.
elim: A o => // f A IH o; rewrite -[scene _ _ _]/((f, fun k => x (o + k)) :: scene x (o + dim3 f) A).
rewrite 2!map_cons -[flatten (_ :: _)]/(_ ++ _) size_cat IH -[sumn (_ :: _)]/(_ + _); congr (_ + _).
rewrite dim2E; set fx := (f, _).
exact: (@size_views (fun D v => image fx D (looks f v)) (seen_by f) (fun v => size_image fx (C v) v)).
Qed.
Lemma size_lifting_at o A cs : size cs = size A ->
  size (flatten [seq kept_parameters fxc.1 fxc.2 | fxc <- zip (scene x o A) cs & ~~ nothing (keep fxc.1.1 fxc.2)]) +
  size (flatten [seq views_of (fun D v => lost_image fxc.1 fxc.2 D (looks fxc.1.1 v)) | fxc <- zip (scene x o A) cs]) =
  sumn [seq cost fc.1 fc.2 | fc <- zip A cs].
Proof.
elim: A o cs => [|f A IH] o [|c cs] // [sz].
rewrite -[scene _ _ _]/((f, fun k => x (o + k)) :: scene x (o + dim3 f) A); set fx := (f, _).
rewrite -[zip (fx :: _) _]/((fx, c) :: zip (scene x (o + dim3 f) A) cs) -[zip (f :: A) _]/((f, c) :: zip A cs).
rewrite 2!map_cons -[flatten (_ :: _)]/(_ ++ _) -[sumn (_ :: _)]/(cost f c + sumn _) -(IH (o + dim3 f) _ sz).
have e := @size_views (fun D v => lost_image fx c D (looks f v)) (lost_seen f c) (fun v => size_lost fx c (C v) v).
cbv beta in e; rewrite size_cat e.
have -> (l : seq (feature * (nat -> K) * selection)) :
    size (flatten [seq kept_parameters fxc.1 fxc.2 | fxc <- (fx, c) :: l & ~~ nothing (keep fxc.1.1 fxc.2)]) =
    space (keep f c) + size (flatten [seq kept_parameters fxc.1 fxc.2 | fxc <- l & ~~ nothing (keep fxc.1.1 fxc.2)]).
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
  flatten [seq kept_parameters fxc.1 fxc.2 | fxc <- zip (scene_of F n A) cs & ~~ nothing (keep fxc.1.1 fxc.2)] ++
  flatten [seq each_view (fun C v => lost_image fxc.1 fxc.2 C (looks fxc.1.1 v)) | fxc <- zip (scene_of F n A) cs].
Lemma size_lifted n A cs : size cs = size A -> size (lifted n A cs) = (11 + sumn [seq cost fc.1 fc.2 | fc <- zip A cs])%N.
Proof. by move=> sz; rewrite !size_cat size_mkseq (size_lifting_at (cameras_at (K n) (generic F n))). Qed.

(** ** A problem of final features is reduced *)
Lemma final_reduced A : is_problem A -> all final A -> reduced F A.
Proof.
move=> pA fA cs [/and3P[/eqP sz fs nw] li].
have := ind_size (to := to (parameters A)) (@den_neq0 _) (@fractionE _) (y := lifted (parameters A) A cs) li.
rewrite size_lifted // /parameters leq_add2l leqNgt => /negP; apply.
elim: A cs pA fA sz fs nw {li} => [|f A IH] [|c cs] // /andP[pf pA] /andP[ff fA] [sz] /= /andP[fc fs].
have le (B : problem) ds : is_problem B -> all final B -> size ds = size B -> all (fun fc => feasible fc.1 fc.2) (zip B ds) ->
    (sumn [seq dim3 f | f <- B] <= sumn [seq cost fc.1 fc.2 | fc <- zip B ds])%N.
  elim: B ds => [|g B IHB] [|d ds] // /andP[pg pB] /andP[fg fB] [sd] /= /andP[fd fds]; apply: leq_add; last exact: IHB.
  have [wd|nwd] := boolP (whole g d); first exact: cost_whole.
  by apply: ltnW; rewrite -cost_strict //; exact: final_strict.
have [wc|nwc _] := boolP (whole f c).
  by move=> /= nw; rewrite -addnS leq_add //; [exact: cost_whole | exact: IH].
by rewrite -addSn leq_add //; [rewrite -cost_strict //; exact: final_strict | exact: le].
Qed.

End Over.

Theorem reduction_theorem : reduction.
Proof.
split=> [F char0 A pA kA|f pf nf]; last first.
  have [|[c /andP[h1 h2] h3]] := not_final pf; first by rewrite (negbTE nf).
  by exists c; rewrite ?h1 // leqNgt.
by apply: final_reduced => //; apply: sub_all kA => f kf; apply/orP; left.
Qed.
