(** * Minimal is what is not obstructed

    The point of NormalPool.v is a configuration with integer parameters. If the signature is not
    obstructed it is rigid there, hence at the generic point, and the Jacobian criterion says that
    the images are independent. Conversely, if the fibres are finite, every motion at the generic
    point is zero, and the signature is not obstructed. *)
From Coq Require Import ZArith.
From mathcomp Require Import all_ssreflect all_algebra.
From mathcomp.zify Require Import ssrZ.
From SsrMultinomials Require Import mpoly.
From PL1P Require Import Statement Rigid Walk Forms Blocks Epipolar Tree NormalPoint Regular Obstructed.
From PL1P Require Import Derivations RationalFunctions Independence Motion Moves Specialize Point.
Set Implicit Arguments.
Unset Strict Implicit.
Unset Printing Implicit Defensive.
Import GRing.Theory.
Local Open Scope ring_scope.
Local Notation ZR := [idomainType of Z].

(** ** Points, lines and centres are natural *)
Section Natural.
Variables (R R' : idomainType) (f : {rmorphism R -> R'}) (s : signature) (x : nat -> R) (x' : nat -> R').
Hypothesis fx : forall k, x' k = f (x k).
Lemma norm_map w : norm (quat_of (cameras_at R' x' w)) = f (norm (quat_of (cameras_at R x w))).
Proof. by rewrite (cameras_map fx) fnorm. Qed.
Lemma project_map w n : project (cameras_at R' x' w) (point (place_of s x' n)) =
  fvec f (project (cameras_at R x w) (point (place_of s x n))).
Proof. by rewrite (cameras_map fx) (point_map s fx) fproject. Qed.
Lemma line_map w n j : line (cameras_at R' x' w) (place_of s x' n) j =
  fvec f (line (cameras_at R x w) (place_of s x n) j).
Proof. by rewrite (cameras_map fx) (fline (point_map s fx n) (dir_map s fx n)). Qed.
Definition scaled (S : idomainType) (y : nat -> S) u w :=
  scale (norm (quat_of (cameras_at S y w)) ^+ 2) (centre (cameras_at S y u)).
Lemma scaled_map u w : scaled x' u w = fvec f (scaled x u w).
Proof. by rewrite /scaled fscale rmorphX fcentre norm_map (cameras_map fx). Qed.
End Natural.

(** ** The generic point: K over polynomials P over F *)
Section Generic.
Variables (F : fieldType) (s : signature).
Hypothesis char0 : [char F] =i pred0.
Hypothesis bs : balanced s.
Notation N := (unknowns_count s).
Notation P := {mpoly F[N]}.
Variables (K : fieldType) (to : {rmorphism P -> K}) (num den : K -> P).
Hypothesis den0 : forall u, to (den u) != 0.
Hypothesis fracE : forall u, u = to (num u) / to (den u).
Hypothesis to0 : forall p, (to p == 0) = (p == 0).
Notation c := (const to).

Definition xP k : P := if insub k is Some i then 'X_i else 0.
Variable xK : nat -> K.
Hypothesis xKE : forall k, xK k = to (xP k).

Notation ZF := (integers F).
Definition xF k : F := ZF (xZ s k).
Definition at_point : {rmorphism P -> F} := [rmorphism of meval (fun i : 'I_N => xF i)].
Lemma xFE k : xF k = at_point (xP k).
Proof.
rewrite /xP; case: insubP => [i _ <-|]; first by rewrite /= mevalXU.
rewrite -leqNgt /= meval0 /xF /xZ => kN; rewrite nth_default ?rmorph0 //.
rewrite /assembled size_cat /= size_flatten /seq.shape -map_comp; apply: leq_trans kN; rewrite leq_add2l.
rewrite -[sizes s](mkseq_nth 0%N) /mkseq size_map; apply/eq_leq; congr sumn; apply/eq_in_map => n.
by rewrite mem_iota => nl; exact: point_own_size.
Qed.

(** What is not zero at the integer point is not zero at the generic point. *)
Lemma generic_nonzero (z : Z) (p : P) (u : K) : u = to p -> at_point p = ZF z -> z != 0 -> u != 0.
Proof. by move=> -> e z0; rewrite to0; apply: contraNneq z0 => p0;
  rewrite -(integers0 char0) -e p0 rmorph0. Qed.

Lemma generic_det : ~~ obstructed s -> \det (system s xK) != 0.
Proof.
move=> us; have e1 := det_map (f := to) s xKE; have e2 := det_map (f := at_point) s xFE.
rewrite (det_map (f := ZF) s (x := xZ s) (fun => erefl)) in e2.
exact: (generic_nonzero e1 (esym e2) (xZ_det bs us)).
Qed.

Lemma generic_rigid : ~~ obstructed s -> rigid (cameras_at K xK) (scene_at K xK s).
Proof.
move=> /generic_det /(det_kernel (square bs)) ker T m gT; rewrite size_mkseq => still.
pose own n := own_unknowns (ft (nth 0%N (kinds s) n)) (m n).
pose v : nat -> K := nth 0 (assembled s (camera_unknowns T) own).
have sc n : (n < size (kinds s))%N -> nth (p0 K) (scene_at K xK s) n = place_of s xK n by move=> nl;
  rewrite nth_mkseq.
have so n : (n < size (kinds s))%N -> size (own n) = nth 0%N (sizes s) n.
  by move=> nl; rewrite (nth_map 0%N) // /own /own_unknowns size_own.
have [g1 g2] := gT.
have tw w : twist_of v w = T w.
  case: w; rewrite ?g1 //= /v !assembled_camera //=.
    by case: (T V2) g2 => ? [? ? ?] /= ->; congr Twist; apply: vec_ext.
  by case: (T V3) => [[? ? ?] [? ? ?]].
have loc n o : (n < size (kinds s))%N -> (o < dim3 (ft (nth 0%N (kinds s) n)))%N -> part s v n o =
  nth 0 (own n) o.
  by move=> nl ol; apply: assembled_part => //; rewrite (nth_map 0%N).
clearbody v.
have mo n : (n < size (kinds s))%N -> dX (motion_of s v n) = dX (m n) /\
    forall j, (j < pins (ft (nth 0%N (kinds s) n)))%N -> dD (motion_of s v n) j = dD (m n) j.
  move=> nl; have {}loc := loc n _ nl; rewrite /motion_of /free_motion /=.
  have [[gD gX] _] := still n nl; rewrite sc // [kind _]/= in gD gX.
  set f := ft _ in loc gD gX *; have [q0 q1 q2] := own_pointN f (dX (m n)) (dD (m n)); split.
    apply: vec_ext => /=.
    - by rewrite loc ?q0 // /dim3; case: (free _).
    - by rewrite loc ?q1 // /dim3; case: (free _).
    - have [fr|nf] := boolP (free f); first by rewrite gX.
      by rewrite loc; [exact: q2 | rewrite /dim3 (negbTE nf)].
  move=> j jp; rewrite jp; have [d1 d2] := @own_dirN K f (dX (m n)) (dD (m n)) j jp.
  have lt : ((2 * j).+1 < 2 * pins f)%N by rewrite -[(2 * j).+2]/(2 + 2 * j)%N -mulnS leq_mul2l.
  apply: vec_ext => /=.
  - by rewrite loc ?d1 // /dim3 ltn_add2l ltnW.
  - by rewrite loc ?d2 // /dim3 -addnS ltn_add2l.
  - by rewrite gD.
have z : forall k, (k < N)%N -> v k = 0.
  apply: ker; apply/all_changes => n nl w; have [_ /(_ w)] := still n nl.
  rewrite sc // [kind _]/=; congr (is_true (all _ _)); rewrite /change tw.
  have [e1 e2] := mo n nl; apply: image_change_eq (esym e1) _ => j js; rewrite e2 //; exact: pins_seen js.
have small k (h : (k < 11)%N) : (k < N)%N := ltn_addr _ h.
split=> [w|n nl]; first by rewrite -tw; case: w; rewrite /= ?z ?small.
have zl o : (o < dim3 (ft (nth 0%N (kinds s) n)))%N -> part s v n o = 0.
  by move=> ol; apply: z; exact: part_bound.
have [<- e2] := mo n nl; rewrite sc // [kind _]/=; split=> [|j jp].
  rewrite /motion_of /free_motion; apply: vec_ext => /=.
  - by rewrite zl // /dim3; case: (free _).
  - by rewrite zl // /dim3; case: (free _).
  - by case: ifP => fr //; rewrite zl // /dim3 fr.
have lt : ((2 * j).+1 < 2 * pins (ft (nth 0%N (kinds s) n)))%N
  by rewrite -[(2 * j).+2]/(2 + 2 * j)%N -mulnS leq_mul2l.
rewrite -e2 // /motion_of /free_motion /= jp; apply: vec_ext => //=.
- by rewrite zl // /dim3 ltn_add2l ltnW.
- by rewrite zl // /dim3 -addnS ltn_add2l.
Qed.

Lemma generic_norm w : norm (quat_of (cameras_at K xK w)) != 0.
Proof.
have e1 := norm_map (f := to) xKE w; have e2 := norm_map (f := at_point) xFE w.
rewrite (norm_map (f := ZF) (x := xZ s) (fun => erefl)) in e2.
apply: (generic_nonzero e1 (esym e2)); rewrite xZ_cameras.
by have /and3P[/and4P[n1 n2 n3 _] _ _] := cams_okE normal_checked; case: w {e1 e2}.
Qed.

Lemma generic_point w n : (n < size (kinds s))%N -> sees_point (ft (nth 0%N (kinds s) n)) w ->
  x3 (project (cameras_at K xK w) (point (place_of s xK n))) != 0.
Proof.
move=> nl sp; have e1 := congr1 (@x3 _) (project_map (f := to) s xKE w n).
have e2 := congr1 (@x3 _) (project_map (f := at_point) s xFE w n).
rewrite (project_map (f := ZF) s (x := xZ s) (fun => erefl)) in e2.
apply: (generic_nonzero e1 (esym e2)); rewrite xZ_cameras xZ_point //; move: sp.
rewrite -kind_place //; have /andP[/and4P[/andP[a1 _] /andP[a2 _] /andP[a3 _] _] _] :=
  place_ok bs (instances_ok normal_checked) nl.
by move=> sp; case: w {e1 e2} sp => sp; [move: a1|move: a2|move: a3]; rewrite sp.
Qed.

Lemma generic_line w n j : (n < size (kinds s))%N -> j \in sees_pins (ft (nth 0%N (kinds s) n)) w ->
  let l := line (cameras_at K xK w) (place_of s xK n) j in (x2 l != 0) && (x3 l != 0).
Proof.
move=> nl js /=; have [_ _ /(_ w j js)/andP[l2 l3]] := place_normal bs nl; rewrite -xZ_line // in l2 l3.
have e1 := line_map (f := to) s xKE w n j; have e2 := line_map (f := at_point) s xFE w n j.
rewrite (line_map (f := ZF) s (x := xZ s) (fun => erefl)) in e2.
apply/andP; split.
  exact: (generic_nonzero (congr1 (@x2 _) e1) (esym (congr1 (@x2 _) e2)) l2).
exact: (generic_nonzero (congr1 (@x3 _) e1) (esym (congr1 (@x3 _) e2)) l3).
Qed.

Lemma generic_centres u w : u <> w -> scaled xK u w <> scaled xK w u.
Proof.
move=> uw; have eK a b := scaled_map (f := to) xKE a b; have eF a b := scaled_map (f := at_point) xFE a b.
have eZ a b := scaled_map (f := ZF) (x := xZ s) (x' := xF) (fun => erefl) a b.
have inj (R R' : idomainType) (f : {rmorphism R -> R'}) : (forall a, (f a == 0) = (a == 0)) ->
  injective (fvec f).
  move=> f0 [a1 a2 a3] [b1 b2 b3] [h1 h2 h3].
  have i a b : f a = f b -> a = b by move=> e; apply/eqP; rewrite -subr_eq0 -f0 rmorphB e subrr.
  by rewrite (i _ _ h1) (i _ _ h2) (i _ _ h3).
rewrite !eK => /(inj _ _ _ to0) /(congr1 (fvec at_point)); rewrite -!eF !eZ => /(inj _ _ _ (integers0 char0)).
have [_ _ _ h _] := scene_admissible normal_checked bs; rewrite /scaled !xZ_cameras; exact: h uw.
Qed.

Lemma scene_place n : (n < size (kinds s))%N -> nth (p0 K) (scene_at K xK s) n = place_of s xK n.
Proof. by move=> nl; rewrite nth_mkseq. Qed.

Lemma generic_regular : regular s xK.
Proof.
split; [exact: (generic_norm V2) | exact: (generic_norm V3) | move=> n nl p w].
have -> : p = place_of s xK n by exact: scene_place.
by split=> [|j]; [exact: generic_point | exact: generic_line].
Qed.

Lemma generic_admissible : admissible (cameras_at K xK) (scene_at K xK s).
Proof.
split=> [//|w|||].
- by apply/eqP; exact: generic_norm.
- by apply/eqP; exact: oner_neq0.
- exact: generic_centres.
rewrite size_mkseq => n nl p; have -> : p = place_of s xK n by exact: scene_place.
split=> [w sp|w j js|j _]; last by apply/eqP; exact: oner_neq0.
  by apply/eqP; exact: generic_point.
by have /andP[l2 _] := generic_line nl js; move=> e; rewrite e eqxx in l2.
Qed.

Lemma generic_shape : shape (scene_at K xK s) s.
Proof.
have ss : size s = 27%N by case/andP: bs => /eqP.
have [k27 sE] := shape_scene normal_point ss.
have kE : [seq kind p | p <- scene_at K xK s] = kinds s.
  by rewrite /scene_at /mkseq -map_comp -[RHS](mkseq_nth 0%N).
have kZ : [seq kind p | p <- scene_of normal_point s] = kinds s.
  rewrite kindsE /scene_of -map_comp; apply: eq_map => -[i k]; exact: kind_instance.
split.
  rewrite (eq_all (a2 := preim (@kind K) (fun i => i < 27)%N)) // -all_map kE -kZ all_map; exact: k27.
rewrite {1}sE; apply/eq_in_map => i _.
by rewrite -[LHS](count_map (@kind _) (pred1 i)) -[RHS](count_map (@kind _) (pred1 i)) kE kZ.
Qed.

(** ** The criterion, for images y at the generic point *)
Lemma size_coordinates : size (coordinates s xK) = N.
Proof.
rewrite -(square bs) /coordinates size_flatten /seq.shape -map_comp /scene_at /mkseq -map_comp
  -[in RHS](mkseq_nth 0%N (kinds s)) /mkseq -map_comp.
congr sumn; apply: eq_map => n; set f := ft (nth 0%N (kinds s) n); pose p := place_of s xK n.
have sz w : size (placed_image (cameras_at K xK w) p (looks f w)) =
  (if (looks f w).1 then 2 + size (looks f w).2 else 2 * size (looks f w).2)%N.
  have fl (h : nat -> seq K) k js : (forall j, size (h j) = k) -> size (flatten (map h js)) = (k * size js)%N.
    by move=> e; elim: js => [|j js IH]; rewrite ?muln0 // [flatten _]/= size_cat IH e mulnS.
  rewrite /placed_image size_cat; case: (looks f w) => -[] js; first by rewrite (fl _ 1%N) // mul1n.
  by rewrite (fl _ 2%N).
rewrite -[LHS]/(size (placed_image (cameras_at K xK V1) p (looks f V1) ++
  placed_image (cameras_at K xK V2) p (looks f V2) ++
  placed_image (cameras_at K xK V3) p (looks f V3) ++ [::])) -[RHS]/(dim2 f).
by rewrite size_cat sz size_cat sz size_cat sz.
Qed.

Lemma xK_param (i : 'I_N) : xK i = to 'X_i.
Proof. by rewrite xKE /xP valK. Qed.

Lemma square_criterion m (y : 'I_m -> K) : m = N ->
  (forall D, derivation c D -> (forall j, D (y j) = 0) -> forall u, D u = 0) ->
  independent c y /\ forall u, algebraic c y u.
Proof.
move=> e; move: y; rewrite e => y un.
have [_ [fin _] [_ ind]] := jacobian_criterion den0 fracE to0 char0 y.
by split; [exact: ind | apply: fin; exact: ind].
Qed.

Section Criterion.
Variable y : 'I_(size (coordinates s xK)) -> K.
Hypothesis yE : forall j, y j = nth 0 (coordinates s xK) j.

Lemma killed_all (D : K -> K) : (forall j, D (y j) = 0) <-> all (fun a => D a == 0) (coordinates s xK).
Proof.
split=> [h|/(all_nthP 0) h j]; last by rewrite yE; apply/eqP/h/ltn_ord.
by apply/(all_nthP 0) => j jl; have := h (Ordinal jl); rewrite yE => ->.
Qed.

Lemma regular_minimal : ~~ obstructed s -> independent c y /\ forall u, algebraic c y u.
Proof.
move=> us; have rg := generic_rigid us.
have un : forall D, derivation c D -> (forall j, D (y j) = 0) -> forall u, D u = 0.
  move=> D hD /killed_all kd; apply: (derivation_param den0 fracE hD) => i.
  rewrite -xK_param; exact: (rigid_kills char0 generic_regular hD rg kd (ltn_ord i)).
exact: square_criterion size_coordinates un.
Qed.

Lemma finite_unobstructed : (forall u, algebraic c y u) -> ~~ obstructed s.
Proof.
move=> fin; apply/negP => ob.
apply: (obstructed_not_rigid generic_shape generic_admissible bs ob).
apply: (kills_rigid (c := c) char0 generic_regular) => [d|D hD /killed_all kd k _].
  exists (extension to num den (fun i : 'I_N => d i)); first exact: extension_derivation.
  by move=> k kN; rewrite -[k]/(val (Ordinal kN)) xK_param extension_param.
exact: (algebraic_killed char0 hD kd (fin _)).
Qed.
End Criterion.
End Generic.

(** ** The problem of a signature *)
Lemma problem_ofE s : problem_of s = [seq ft i | i <- kinds s].
Proof. by rewrite /problem_of /kinds map_flatten -map_comp; congr flatten; apply: eq_map => i;
  rewrite /= map_nseq. Qed.
Lemma parametersE s : parameters (problem_of s) = unknowns_count s.
Proof. by rewrite /parameters problem_ofE -map_comp. Qed.
Lemma image_ext (K : fieldType) (f : feature) (x x' : nat -> K) C l : x =1 x' -> image (f, x) C l =
  image (f, x') C l.
Proof.
move=> e; rewrite /image /= (_ : point_at f x = point_at f x') ?/point_at ?e //; congr (_ ++ flatten _).
by apply: eq_map => j; congr (line_image _ (normal _ _ _)); rewrite /dir_at !e.
Qed.
(** The scene of a list of kinds, feature by feature. *)
Lemma scene_map (R : idomainType) (x : nat -> R) T (G : feature * (nat -> R) -> T) (H : placed R -> T) :
  (forall f y y', y =1 y' -> G (f, y) = G (f, y')) -> (forall y i, G (ft i, y) = H (@place_at R y i)) ->
  forall l o, [seq G fx | fx <- scene x o [seq ft i | i <- l]] =
    [seq H (@place_at R (fun k => x (o + (sumn (take n [seq dim3 (ft i) | i <- l]) + k))%N) (nth 0%N l n)) | n
      <- iota 0 (size l)].
Proof.
move=> ext GH; elim=> // i l IH o.
rewrite -[scene _ _ _]/((ft i, fun k => x (o + k)%N) :: scene x (o + dim3 (ft i)) [seq ft i | i <- l]).
rewrite [LHS]/= IH -[size (i :: l)]/(size l).+1 -[iota 0 _.+1]/(0%N :: iota 1 (size l)) [RHS]map_cons;
  congr (_ :: _).
  by rewrite GH.
have h y y' m : y =1 y' -> H (@place_at R y m) = H (@place_at R y' m) by move=> e; rewrite -!GH; exact: ext.
rewrite (iotaDl 1 0) -map_comp; apply: eq_map => k.
rewrite -[RHS]/(H (@place_at R
  (fun r => x (o + (dim3 (ft i) + sumn (take k [seq dim3 (ft i) | i <- l]) + r))%N) (nth 0%N l k))).
by apply: h => r; rewrite !addnA.
Qed.
Lemma imagesE (F : fieldType) n s : images F n (problem_of s) = coordinates s (generic F n).
Proof.
rewrite problem_ofE /images /scene_of /coordinates /scene_at /sizes /mkseq -map_comp; congr flatten.
apply: (@scene_map _ _ _ _ (fun p =>
  flatten [seq placed_image (cameras_at _ (generic F n) v) p (looks (ft (kind p)) v) | v <- views])) => //.
by move=> f y y' e; rewrite /each_view; congr flatten; apply: eq_map => v; exact: image_ext.
Qed.

Theorem minimal_iff (F : fieldType) s : [char F] =i pred0 -> balanced s -> minimal F (problem_of s) <->
  ~~ obstructed s.
Proof.
move=> char0 bs; rewrite /minimal parametersE imagesE.
pose K := [fieldType of {fraction {mpoly F[unknowns_count s]}}].
pose to : {rmorphism {mpoly F[unknowns_count s]} -> K} := [rmorphism of @FracField.tofrac _].
have to0 p : (to p == 0) = (p == 0) by exact: tofrac_eq0.
have xKE k : generic F (unknowns_count s) k = to (@xP F s k).
  by rewrite /generic /xP; case: insub => [i|] //; rewrite rmorph0.
pose y (j : 'I_(size (coordinates s (generic F (unknowns_count s))))) :=
  nth 0 (coordinates s (generic F (unknowns_count s))) j.
split=> [[_ fin]|us].
  exact: (finite_unobstructed char0 bs (@den_neq0 _) (@fractionE _) to0 xKE (y := y)).
exact: (regular_minimal char0 bs (@den_neq0 _) (@fractionE _) to0 xKE (y := y)).
Qed.
