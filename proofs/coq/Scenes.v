(** * Scenes made of pieces

    A list of features, each with parameters of its own in K, is a scene. If all these parameters
    and those of the cameras are independent, the images of the problem are independent if and only
    if those of the scene are. *)
From mathcomp Require Import all_ssreflect all_algebra.
From SsrMultinomials Require Import mpoly.
From PL1P Require Import Statement Reducible Forget Derivations RationalFunctions Independence Generic
  Reduction.
From PL1P Require Import Embedding.
Set Implicit Arguments.
Unset Strict Implicit.
Unset Printing Implicit Defensive.
Import GRing.Theory.
Local Open Scope ring_scope.

(** ** Parts of independent lists *)
Section Parts.
Variables (F K : fieldType) (c : {rmorphism F -> K}).
Implicit Types y z : seq K.
Lemma ind_sub y z Is : z = [seq nth 0 y i | i <- Is] -> uniq Is -> all (fun i => i < size y)%N Is ->
  ind c y -> ind c z.
Proof.
move=> -> u /allP le iy; set w := map _ _; have sw : size w = size Is by exact: size_map.
have lt (j : 'I_(size w)) : (nth 0%N Is j < size y)%N by apply: le; rewrite mem_nth // -sw.
apply: (@independent_sub F K c _ _ _ _ (fun j => Ordinal (lt j)) _ _ iy) => [i j /(congr1 val)/= e|j].
  apply/val_inj/eqP; rewrite -(nth_uniq 0%N (s := Is)) -?sw;
    [by rewrite e eqxx | exact: ltn_ord | exact: ltn_ord | exact: u].
by rewrite (nth_map 0%N) // -sw.
Qed.
Lemma ind_perm y z : perm_eq y z -> ind c y -> ind c z.
Proof.
rewrite perm_sym => /(perm_iotaP 0)[Is p e]; apply: (ind_sub e); first by rewrite (perm_uniq p) iota_uniq.
by apply/allP => i; rewrite (perm_mem p) mem_iota.
Qed.
Lemma ind_catl y z : ind c (y ++ z) -> ind c y.
Proof.
apply: (@ind_sub _ _ (iota 0 (size y))); rewrite ?iota_uniq //.
  rewrite -[LHS](mkseq_nth 0); apply/eq_in_map => i; rewrite mem_iota => /= lt.
  by rewrite nth_cat lt.
by apply/allP => i; rewrite mem_iota size_cat => /= lt; rewrite (leq_trans lt) ?leq_addr.
Qed.
End Parts.

(** ** The scene *)
Section Pieces.
Variable K : fieldType.
Notation placed := (feature * (nat -> K))%type.
Implicit Types (f : feature) (fx : placed) (x : nat -> K) (sc : seq placed).
Definition own fx := mkseq fx.2 (dim3 fx.1).
Definition owns sc := flatten [seq own fx | fx <- sc].
Definition seen C sc := flatten [seq views_of C fx | fx <- sc].

Lemma size_owns sc : size (owns sc) = sumn [seq dim3 f | f <- map fst sc].
Proof. by elim: sc => //= fx sc IH; rewrite size_cat IH size_mkseq. Qed.
Lemma size_seen C sc : size (seen C sc) = sumn [seq dim2 f | f <- map fst sc].
Proof.
elim: sc => // fx sc IH; rewrite [LHS]size_cat -/(seen C sc) IH; congr (_ + _)%N; rewrite dim2E.
exact: (@size_views _ C (fun D v => image fx D (looks fx.1 v)) (seen_by fx.1)
  (fun v => size_image fx (C v) v)).
Qed.

Lemma pin_own f j : (j < pins f)%N -> (((if free f then 2 else 3) + 2 * j).+1 < dim3 f)%N.
Proof. by move=> jp; rewrite /dim3 -addnS ltn_add2l -[(2 * j).+2]/(2 + 2 * j)%N -mulnS leq_mul2l. Qed.
(** An image depends on the feature's own parameters. *)
Lemma image_own f x x' C v : proper f -> (forall k, (k < dim3 f)%N -> x k = x' k) ->
  image (f, x) C (looks f v) = image (f, x') C (looks f v).
Proof.
move=> pf e; have [_ /allP le _] := properP v pf.
have eX : point_at f x = point_at f x'.
  by rewrite /point_at; case fr: (free f); rewrite !e // /dim3 fr.
rewrite /image /= eX; congr (_ ++ flatten _); apply/eq_in_map => j /le jp.
by have lt := pin_own jp; rewrite /dir_at (e _ lt) (e _ (ltnW lt)).
Qed.

Lemma scene_pieces T (G : placed -> T) :
  (forall f x x', proper f -> (forall k, (k < dim3 f)%N -> x k = x' k) -> G (f, x) = G (f, x')) ->
  forall sc pre, all proper (map fst sc) ->
    [seq G fx | fx <- scene (nth 0 (pre ++ owns sc)) (size pre) (map fst sc)] = map G sc.
Proof.
move=> ext; elim=> // -[f x] sc IH pre /andP[pf ps].
rewrite -[map fst _]/(f :: map fst sc) -[scene _ _ (f :: _)]/((f, _) :: scene _ _ _).
rewrite [LHS]/= [RHS]/=; congr (_ :: _).
  apply: ext => // k kd; rewrite nth_cat ltnNge leq_addr /= addKn.
  by rewrite /owns /= nth_cat size_mkseq kd nth_mkseq.
by have := IH (pre ++ own (f, x)) ps; rewrite size_cat size_mkseq -catA.
Qed.
Lemma cameras_pieces s s' v : size s = 11%N -> cameras_at K (nth 0 (s ++ s')) v = cameras_at K (nth 0 s) v.
Proof. by move=> sz; case: v; rewrite /= ?nth_cat ?sz. Qed.
Lemma images_pieces s sc : size s = 11%N -> is_problem (map fst sc) ->
  images_at (nth 0 (s ++ owns sc)) (map fst sc) = seen (cameras_at K (nth 0 s)) sc.
Proof.
move=> sz ps; rewrite /images_at -[in scene _ _]sz scene_pieces //.
  rewrite /seen; congr flatten; apply: eq_map => fx; rewrite /views_of; congr flatten.
  by apply: eq_map => v; rewrite cameras_pieces.
move=> f x x' pf e; rewrite /views_of; congr flatten; apply: eq_map => v; exact: image_own.
Qed.

(** ** A feature's own parameters, one by one *)
Lemma mkseq_pairs x (k : nat) : mkseq x (2 * k)%N =
  flatten [seq [:: x (2 * j)%N; x (2 * j).+1] | j <- iota 0 k].
Proof.
elim: k => // k IH; rewrite -[k.+1]addn1 mulnDr /mkseq (iotaD 0 (2 * k)) map_cat (iotaD 0 k) map_cat.
by rewrite flatten_cat -IH add0n.
Qed.
Lemma ownE f x : own (f, x) = kept_parameters (f, x) (everything f).
Proof.
rewrite /own /kept_parameters /dim3 /= orbF /mkseq iotaD map_cat; congr (_ ++ _); first by case: (free f).
set o := (if free f then 2 else 3)%N; rewrite add0n -[o in iota o]addn0 iotaDl -map_comp; set y := (x \o _);
  rewrite -[map y _]/(mkseq y _) mkseq_pairs; congr flatten.
by apply: eq_map => j; rewrite /y /= addnS.
Qed.
Lemma own_kept fx c : own (keep fx.1 c, nth 0 (kept_parameters fx c)) = kept_parameters fx c.
Proof. by rewrite /own -size_kept mkseq_nth. Qed.
Lemma fst_scene x o A : map fst (scene x o A) = A.
Proof. by elim: A o => //= f A IH o; rewrite IH. Qed.
End Pieces.

(** ** Over a field of characteristic 0 *)
Section Over.
Variable F : fieldType.
Hypothesis char0 : [char F] =i pred0.
Notation K n := [fieldType of {fraction {mpoly F[n]}}].
Notation to := (to F).
Implicit Types A B : problem.

(** Lemma 2 of the paper: minimal is balanced and dominant. *)
Theorem balanced_dominant A : minimal F A <->
  sumn [seq dim2 f | f <- A] = parameters A /\ Statement.independent (images F (parameters A) A).
Proof.
split=> [mA|[sz iy]].
  by have [s _] := (minimalP char0 A).1 mA; rewrite -(size_images F A (parameters A)); case: mA.
split=> // u; have sz' : size (images F (parameters A) A) = parameters A by rewrite size_images.
have iy' := (indE (const (to (parameters A))) sz').1 iy.
exact: (algE (const (to (parameters A))) u sz').2 (exchange (@den_neq0 _) (@fractionE _) u iy').
Qed.

Lemma generic_ind n : ind (const (to n)) (mkseq (generic F n) n).
Proof.
apply/(indE _ (size_mkseq _ _)) => Q v0; apply/eqP; rewrite -(to0 Q) -v0; apply/eqP.
set y := (fun i : 'I_n => _); rewrite -[RHS]/(mmap_rmorphism y (const (to n)) Q);
  apply: morphism_eq => [a|i] /=.
  by rewrite mmapC.
by rewrite mmapX mmap1U /y nth_mkseq // /generic valK.
Qed.
Lemma owns_scene n A : mkseq (generic F n) 11 ++ owns (scene_of F n A) = mkseq (generic F n) (parameters A).
Proof.
have h o : owns (scene (generic F n) o A) = [seq generic F n k | k <- iota o (sumn [seq dim3 f | f <- A])].
  elim: A o => // f A IH o.
  rewrite -[owns _]/(own (f, fun k => generic F n (o + k)) ++ owns (scene (generic F n) (o + dim3 f) A)) IH.
  rewrite -[sumn _ in RHS]/(dim3 f + sumn [seq dim3 g | g <- A])%N iotaD map_cat; congr (_ ++ _).
  by rewrite -[o in RHS]addn0 iotaDl -map_comp.
by rewrite h /mkseq -map_cat -iotaD.
Qed.

Lemma pieces n B (sc : seq (feature * (nat -> K n))) : map fst sc = B -> is_problem B ->
  ind (const (to n)) (mkseq (generic F n) 11 ++ owns sc) ->
  ind (const (to n)) (seen (cameras_at (K n) (generic F n)) sc) <->
    Statement.independent (images F (parameters B) B).
Proof.
move=> <- ps hs; have := anywhere (map fst sc) hs.
by rewrite size_cat size_mkseq size_owns -/(parameters _) images_pieces.
Qed.

(** Scenes with the same parameters and the same images, up to order. *)
Definition alike (K : fieldType) (sc sc' : seq (feature * (nat -> K))) :=
  perm_eq (owns sc) (owns sc') /\ forall C, perm_eq (seen C sc) (seen C sc').
Lemma alike_trans (L : fieldType) (s t u : seq (feature * (nat -> L))) : alike s t -> alike t u -> alike s u.
Proof. by case=> a1 a2 [b1 b2]; split=> [|C];
  [exact: perm_trans a1 b1 | exact: perm_trans (a2 C) (b2 C)]. Qed.
Theorem alike_minimal A B sc : is_problem B -> map fst sc = B -> alike (scene_of F (parameters A) A) sc ->
  minimal F A -> minimal F B.
Proof.
move=> pB e [po ps] /balanced_dominant[sz iA]; apply/balanced_dominant.
have pAB : parameters A = parameters B.
  by rewrite /parameters -e -size_owns -(perm_size po) size_owns fst_scene.
split.
  by rewrite -pAB -sz -e -(size_seen (cameras_at _ (generic F (parameters A)))) -(perm_size (ps _)) size_seen
    fst_scene.
apply/(pieces e pB).
  apply: (ind_perm (y := mkseq (generic F (parameters A)) 11 ++ owns (scene_of F (parameters A) A))).
    by rewrite perm_cat2l.
  by rewrite owns_scene; exact: generic_ind.
apply: (ind_perm (ps _)); exact: iA.
Qed.
End Over.
