(** * Theorem 1 of the paper, and its converse

    A is minimal and reduces to B: then B is minimal. B is minimal, A is balanced and reduces to B:
    then A is minimal. *)
From mathcomp Require Import all_ssreflect all_algebra.
From mathcomp.zify Require Import zify.
From SsrMultinomials Require Import mpoly.
From PL1P Require Import Statement Reducible Problems Reductions Forget Derivations RationalFunctions
  Independence Generic.
From PL1P Require Import Lifting Reduction Embedding Scenes Keeps.
Set Implicit Arguments.
Unset Strict Implicit.
Unset Printing Implicit Defensive.
Import GRing.Theory.
Local Open Scope ring_scope.

Lemma selects_cons f A c cs : selects (f :: A) (c :: cs) = feasible f c && selects A cs.
Proof. by rewrite /selects [size _ == _]eqSS andbCA. Qed.
Lemma kept_cons f A c cs : kept (f :: A) (c :: cs) =
  if nothing (keep f c) then kept A cs else keep f c :: kept A cs.
Proof. by rewrite /kept [zip _ _]/= [filter _ _]/=; case: (nothing _). Qed.
Lemma sum_kept (h : feature -> nat) f A c cs : sumn [seq h g | g <- kept (f :: A) (c :: cs)] =
  ((if nothing (keep f c) then 0 else h (keep f c)) + sumn [seq h g | g <- kept A cs])%N.
Proof. by rewrite kept_cons; case: (nothing _). Qed.

(** ** The scene of what is kept *)
Section Scene.
Variable K : fieldType.
Notation placed := (feature * (nat -> K))%type.
Implicit Types (x : nat -> K) (sc : seq placed) (cs : seq selection).
Definition remains (fxc : placed * selection) := ~~ nothing (keep fxc.1.1 fxc.2).
Definition kept_scene sc cs := [seq kept_feature fxc.1 fxc.2 | fxc <- zip sc cs & remains fxc].
Definition lost (C : view -> camera K) sc cs := flatten
  [seq flatten [seq lost_image fxc.1 fxc.2 (C v) (looks fxc.1.1 v) | v <- views] | fxc <- zip sc cs].

Lemma fst_kept x o A cs : map fst (kept_scene (scene x o A) cs) = kept A cs.
Proof.
rewrite /kept_scene; elim: A o cs => [|f A IH] o [|c cs] //; rewrite kept_cons -(IH (o + dim3 f)%N).
by rewrite [scene _ _ _]/= [zip _ _]/= [filter _ _]/= /remains [(_, _).1]/=; case: (nothing _).
Qed.
Lemma owns_kept sc cs : owns (kept_scene sc cs) =
  flatten [seq kept_parameters fxc.1 fxc.2 | fxc <- zip sc cs & remains fxc].
Proof. by rewrite /owns /kept_scene -map_comp; congr flatten; apply: eq_map => fxc; exact: own_kept. Qed.

Lemma kept_proper A cs : is_problem A -> selects A cs -> is_problem (kept A cs).
Proof.
elim: A cs => [|f A IH] [|c cs] // /andP[pf pA]; rewrite selects_cons kept_cons => /andP[fc /(IH cs pA) h].
by case n: (nothing _) => //; apply/andP; split=> //; apply: keep_proper; rewrite ?n.
Qed.
Lemma nothing_dim2 f c : proper f -> nothing (keep f c) -> dim2 (keep f c) = 0%N.
Proof.
move=> pf; rewrite /nothing /= => /andP[fr /eqP/size0nil e].
have z v : seen_by (keep f c) v = 0%N.
  have [_ _ sp] := properP v pf; have -> : seen_by (keep f c) v =
    let n := size [seq index j c.2 | j <- sees_pins f v & j \in c.2] in
    (if sees_point f v && c.1 then 2 + n else 2 * n)%N by [].
  rewrite e.
  rewrite [X in map _ X](_ : _ = [::]); last first.
    by rewrite -[RHS](filter_pred0 (sees_pins f v)); apply: eq_filter => j; rewrite in_nil.
  by case: (free f) fr sp => /= [_ /negbTE ->|/negbTE ->] //; rewrite andbF.
by rewrite dim2E !z.
Qed.
Lemma size_lost_kept C x o A cs : is_problem A -> selects A cs ->
  (sumn [seq dim2 f | f <- kept A cs] + size (lost C (scene x o A) cs))%N = sumn [seq dim2 f | f <- A].
Proof.
elim: A o cs => [|f A IH] o [|c cs] // /andP[pf pA]; rewrite selects_cons sum_kept => /andP[fc h].
set fx := (f, fun k => x (o + k)%N).
have -> : lost C (scene x o (f :: A)) (c :: cs) =
    flatten [seq lost_image fx c (C v) (looks f v) | v <- views] ++ lost C (scene x (o + dim3 f) A) cs by [].
have e := @size_views _ C (fun D v => lost_image fx c D (looks f v)) (lost_seen f c)
  (fun v => size_lost fx c (C v) v).
rewrite size_cat [X in (_ + (X + _))%N]e -[sumn [seq _ | g <- f :: A]]/(dim2 f + sumn
  [seq dim2 g | g <- A])%N.
rewrite -(IH (o + dim3 f)%N cs pA h) -(lost_dim2 pf fc).
have -> : (if nothing (keep f c) then 0 else dim2 (keep f c))%N = dim2 (keep f c).
  by case n: (nothing _) => //; rewrite nothing_dim2.
move: (size (lost _ _ _)) (sumn _) (dim2 _) (lost_seen f c V1) (lost_seen f c V2) (lost_seen f c V3).
by move=> n1 n2 n3 n4 n5 n6; lia.
Qed.

(** A derivation kills the images of what is kept and of what is lost if and only if it kills all
    images. *)
Section Killed.
Variables (F : fieldType) (c0 : {rmorphism F -> K}) (D : K -> K) (C : view -> camera K) (x : nat -> K)
  (n : nat).
Hypothesis hD : derivation c0 D.
Local Notation own o := (fun k => x (o + k)%N).
Hypothesis regular : forall f o, (11 <= o)%N -> (o + dim3 f <= n)%N -> regular_at f (own o) C.
Lemma scene_kept A o cs : (11 <= o)%N -> (o + sumn [seq dim3 f | f <- A] <= n)%N -> is_problem A ->
  selects A cs ->
  killed D (seen C (scene x o A)) =
  killed D (seen C (kept_scene (scene x o A) cs)) && killed D (lost C (scene x o A) cs).
Proof.
elim: A o cs => [|f A IH] o [|c cs] // o11 room /andP[pf pA]; rewrite selects_cons => /andP[fc h].
have room1 : (o + dim3 f <= n)%N by apply: leq_trans room; rewrite leq_add2l leq_addr.
have room2 : (o + dim3 f + sumn [seq dim3 g | g <- A] <= n)%N by rewrite -addnA.
have {}IH := IH (o + dim3 f)%N cs (leq_trans o11 (leq_addr _ _)) room2 pA h.
set sc := scene x (o + dim3 f) A in IH; set fx := (f, own o).
have -> : seen C (scene x o (f :: A)) = views_of C fx ++ seen C sc by [].
have -> : lost C (scene x o (f :: A)) (c :: cs) =
  flatten [seq lost_image fx c (C v) (looks f v) | v <- views] ++ lost C sc cs by [].
have -> : seen C (kept_scene (scene x o (f :: A)) (c :: cs)) =
    (if nothing (keep f c) then [::] else views_of C (kept_feature fx c)) ++ seen C (kept_scene sc cs).
  rewrite /kept_scene -[zip _ (c :: cs)]/((fx, c) :: zip sc cs) [filter _ _]/= /remains [(_, _).1]/=.
  by case: (nothing _).
rewrite (killed_cat D (views_of C fx)) (killed_cat D (if _ then _ else _))
  (killed_cat D (flatten _) (lost C sc cs)) IH.
rewrite [RHS]andbACA; congr (_ && _).
have -> : killed D (if nothing (keep f c) then [::] else views_of C (kept_feature fx c)) =
    killed D (flatten [seq kept_image fx c (C v) (looks f v) | v <- views]).
  case nt: (nothing _); first by rewrite /= !nothing_kept.
  by rewrite /views_of; congr (killed D (flatten _)); apply: eq_map => v; exact: image_kept.
have kv (g : view -> seq K) : killed D (flatten [seq g v | v <- views]) =
    [&& killed D (g V1), killed D (g V2) & killed D (g V3)] by rewrite killed_flatten [all _ _]/= andbT.
have one v : killed D (image fx (C v) (looks fx.1 v)) =
    killed D (kept_image fx c (C v) (looks f v)) && killed D (lost_image fx c (C v) (looks f v)).
  exact: (kept_lost hD v pf fc (regular o11 room1)).
rewrite /views_of !kv; rewrite !one; move: (killed D (kept_image _ _ _ _)) (killed D (lost_image _ _ _ _)) =>
  b1 l1.
move: (killed D (kept_image _ _ _ _)) (killed D (lost_image _ _ _ _)) => b2 l2.
move: (killed D (kept_image _ _ _ _)) (killed D (lost_image _ _ _ _)) => b3 l3.
by case: b1; case: b2; case: b3; case: l1; case: l2; case: l3.
Qed.
End Killed.
End Scene.

(** ** Over a field of characteristic 0 *)
Section Over.
Variable F : fieldType.
Hypothesis char0 : [char F] =i pred0.
Variables (A : problem) (cs : seq selection).
Hypothesis pA : is_problem A.
Hypothesis red : reduces F A cs.
Notation n := (parameters A).
Notation K := [fieldType of {fraction {mpoly F[n]}}].
Notation c := (const (to F n)).
Local Notation C := (cameras_at K (generic F n)).
Local Notation sc := (scene_of F n A).
Local Notation B := (kept A cs).
Let sel : selects A cs := proj1 red.
Let pB : is_problem B := kept_proper pA sel.
Let eB : map fst (kept_scene sc cs) = B := fst_kept (generic F n) 11 A cs.

Lemma liftedE : lifted F n A cs = (mkseq (generic F n) 11 ++ owns (kept_scene sc cs)) ++ lost C sc cs.
Proof. by rewrite /lifted owns_kept -catA. Qed.
Lemma lifted_ind : ind c (lifted F n A cs). Proof. exact: (proj2 red). Qed.
Lemma kept_ind : ind c (mkseq (generic F n) 11 ++ owns (kept_scene sc cs)).
Proof. by have := lifted_ind; rewrite liftedE => /ind_catl. Qed.
Lemma size_all : (sumn [seq dim2 f | f <- B] + size (lost C sc cs))%N = sumn [seq dim2 f | f <- A].
Proof. exact: size_lost_kept. Qed.
Lemma size_lifting : size (lifted F n A cs) = (parameters B + size (lost C sc cs))%N.
Proof. by rewrite liftedE !size_cat size_mkseq size_owns eB. Qed.
Lemma all_killed D : derivation c D -> killed D (images F n A) =
  killed D (seen C (kept_scene sc cs)) && killed D (lost C sc cs).
Proof.
move=> hD; apply: (scene_kept hD (n := n)) => // f o o11 room nf v.
split=> [|j jp]; first exact: (generic_point F o11 room nf).
exact: (generic_line char0 o11 room nf).
Qed.

Theorem minimal_kept : minimal F A -> minimal F B.
Proof.
move=> mA; have [sz un] := (minimalP char0 A).1 mA; rewrite size_images in sz.
pose w := seen C (kept_scene sc cs) ++ lost C sc cs.
have sw : size w = n by rewrite size_cat size_seen eB size_all.
have iw : ind c w.
  apply: (unmoved_ind (@den_neq0 _) (@fractionE _) (@to0 F n) char0); first by rewrite sw.
  by move=> D hD; rewrite killed_cat -all_killed //; exact: un.
have iB := (pieces eB pB kept_ind).1 (ind_catl iw); apply/(balanced_dominant char0); split=> //.
apply/eqP; rewrite eqn_leq; apply/andP; split.
  by have := ind_size (@den_neq0 _) (@fractionE _) (to := to F (parameters B)) iB; rewrite size_images.
have := ind_size (@den_neq0 _) (@fractionE _) lifted_ind.
by rewrite size_lifting -[X in (_ <= X)%N]sz -size_all leq_add2r.
Qed.

(** An independent list of n elements: a derivation that kills it is zero. *)
Lemma ind_unmoved m (y : seq [fieldType of {fraction {mpoly F[m]}}]) : size y = m ->
  ind (const (to F m)) y -> unmoved (to F m) y.
Proof.
move=> sy iy; apply: (finite_unmoved_list char0) => u; apply/(algE _ _ sy).
exact: (exchange (@den_neq0 _) (@fractionE _) u ((indE _ sy).1 iy)).
Qed.

Section Parameters.
Variables (D : K -> K) (s : seq K).
Hypothesis hD : derivation c D.
Hypothesis hs : ind c s.
Lemma embed_alg (y : seq [fieldType of {fraction {mpoly F[size s]}}]) u :
  alg (const (to F (size s))) y u -> alg c (map (embed hs) y) (embed hs u).
Proof.
case=> p p0 rt; have vE : values c (fun i : 'I_(size y) => nth 0 (map (embed hs) y) i) p =
    map_poly (embed hs) (values (const (to F (size s))) (fun i : 'I_(size y) => nth 0 y i) p).
  have cE (L : fieldType) (b : {rmorphism F -> L}) m (w : 'I_m -> L) q i : (values b w q)`_i = value b w q`_i.
    by rewrite /values coef_map_id0 // /value mmap0.
  apply/polyP => i; rewrite [RHS](coef_map (embed hs)) !cE -[RHS](embed_value hs); apply: value_ext => j.
  by rewrite (nth_map 0).
apply/(algE c _ (size_map (embed hs) y)); exists p.
  by rewrite vE map_poly_eq0.
by rewrite vE fmorph_root.
Qed.
Lemma parameters_killed (Q : problem) : (forall u, alg (const (to F (size s))) (images F (size s) Q) u) ->
  killed D (images_at (nth 0 s) Q) -> killed D s.
Proof.
move=> fin kD; apply/(all_nthP 0) => k ks; apply/eqP; rewrite -(embed_param hs).
apply: (algebraic_killed char0 hD _ (embed_alg (fin _))); apply/(killedP D erefl).
by rewrite -(@images_map _ _ (embed hs) _ (nth 0 s)) // => j; rewrite embed_param.
Qed.
End Parameters.

Theorem kept_minimal : is_balanced A -> minimal F B -> minimal F A.
Proof.
move=> sz mB; have [sB _] := (balanced_dominant char0 B).1 mB.
have sl : size (lifted F n A cs) = n by rewrite size_lifting -sB size_all.
apply/(minimalP char0); split; first by rewrite size_images.
move=> D hD; rewrite all_killed // => /andP[ks kl]; apply: (ind_unmoved sl lifted_ind) => //.
rewrite liftedE killed_cat kl andbT; set s := mkseq _ _ ++ _.
have ss : size s = parameters B by rewrite size_cat size_mkseq size_owns eB.
have fin : forall u, alg (const (to F (parameters B))) (images F (parameters B) B) u := proj2 mB.
rewrite -ss in fin; apply: (parameters_killed hD kept_ind fin).
rewrite -[B in images_at _ B]eB images_pieces ?size_mkseq ?eB //; exact: ks.
Qed.
End Over.
