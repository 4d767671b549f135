(** * The equations of a motion as a matrix, and its specialisation

    The image changes at parameters x are linear in the unknowns v of a motion. Their matrix is
    natural in x under ring morphisms, so its determinant is nonzero at the generic point if it is
    nonzero at one integer point. *)
From Coq Require List.
From mathcomp Require Import all_ssreflect all_algebra.
From PL1P Require Import Statement Rigid Walk System Forms Blocks.
Set Implicit Arguments.
Unset Strict Implicit.
Unset Printing Implicit Defensive.
Import GRing.Theory.
Local Open Scope ring_scope.

(** ** Naturality *)
Section Naturality.
Variables (R R' : idomainType) (f : {rmorphism R -> R'}).
Implicit Types (u w : vec R).
Definition fvec u := @Vec R' (f (x1 u)) (f (x2 u)) (f (x3 u)).
Definition fquat (q : quat R) := @Quat R' (f (qa q)) (f (qb q)) (f (qc q)) (f (qd q)).
Definition fcamera (C : camera R) := Camera (fquat (quat_of C)) (fvec (trans C)).
Definition ftwist (T : twist R) := Twist (fvec (omega T)) (fvec (dt T)).

Lemma fadd u w : fvec (add u w) = add (fvec u) (fvec w). Proof. by rewrite /fvec /= !rmorphD. Qed.
Lemma fdot u w : f (dot u w) = dot (fvec u) (fvec w). Proof. by rewrite /dot !rmorphD !rmorphM. Qed.
Lemma fcross u w : fvec (cross u w) = cross (fvec u) (fvec w). Proof.
by rewrite /cross /fvec /= !rmorphB !rmorphM. Qed.
Lemma fscale k u : fvec (scale k u) = scale (f k) (fvec u). Proof. by rewrite /scale /fvec /= !rmorphM. Qed.
Lemma frot q u : fvec (rot q u) = rot (fquat q) (fvec u).
Proof. by case: q => a b c d; rewrite /fvec /= !fdot /fvec /= !(rmorphB, rmorphD, rmorphMn, rmorphX,
  rmorphM). Qed.
Lemma fnorm q : f (norm q) = norm (fquat q). Proof. by rewrite /norm !rmorphD !rmorphX. Qed.
Lemma fconj q : fquat (conj q) = conj (fquat q). Proof. by rewrite /fquat /conj /= !rmorphN. Qed.
Lemma fcentre C : fvec (centre C) = centre (fcamera C). Proof. by rewrite /centre frot fconj. Qed.
Lemma fturn C u : fvec (turn C u) = turn (fcamera C) (fvec u). Proof. exact: frot. Qed.
Lemma fproject C u : fvec (project C u) = project (fcamera C) (fvec u). Proof.
by rewrite /project fadd fturn. Qed.

Variables (p : placed R) (p' : placed R').
Hypothesis fpoint : point p' = fvec (point p).
Hypothesis fdir : forall j, dir p' j = fvec (dir p j).
Lemma fline C j : fvec (line C p j) = line (fcamera C) p' j.
Proof. by rewrite /line fcross fproject fturn fpoint fdir. Qed.

Variables (m : motion R) (m' : motion R').
Hypothesis fdX : dX m' = fvec (dX m).
Hypothesis fdD : forall j, dD m' j = fvec (dD m j).
Lemma fd_turn C T u w : fvec (d_turn C T u w) = d_turn (fcamera C) (ftwist T) (fvec u) (fvec w).
Proof. by rewrite /d_turn fadd fcross !fturn. Qed.
Lemma fd_project C T u w : fvec (d_project C T u w) = d_project (fcamera C) (ftwist T) (fvec u) (fvec w).
Proof. by rewrite /d_project fadd fd_turn. Qed.

Lemma image_change_map C T l :
  image_change (fcamera C) (ftwist T) p' m' l = map f (image_change C T p m l).
Proof.
rewrite /image_change map_cat map_flatten -map_comp fdX fpoint -fproject -fd_project; congr (_ ++ flatten _).
  case: l.1 => //; rewrite /= !fdot /fvec /= !rmorphN !rmorph0 //.
apply: eq_map => j /=; rewrite /d_line fdir fdD -fd_turn -fline -!fdot; by case: l.1.
Qed.
End Naturality.

(** ** The matrix *)
Section System.
Variables (R : idomainType) (s : signature).
Implicit Types (x v : nat -> R).
Notation Vec := (@Vec R).
Definition unknowns_count := (11 + sumn (sizes s))%N.
Notation N := unknowns_count.
Definition part v n k := v (11 + (sumn (take n (sizes s)) + k))%N.
Definition twist_of v w := by_view (Twist (vec0 R) (vec0 R))
  (Twist (Vec (v 0%N) (v 1%N) (v 2%N)) (Vec 0 (v 3%N) (v 4%N)))
  (Twist (Vec (v 5%N) (v 6%N) (v 7%N)) (Vec (v 8%N) (v 9%N) (v 10%N))) w.
Definition place_of x n := @place_at R (part x n) (nth 0%N (kinds s) n).
Definition motion_of v n := free_motion (nth 0%N (kinds s) n) (part v n).
Definition change x v n w :=
  image_change (cameras_at R x w) (twist_of v w) (place_of x n) (motion_of v n)
    (looks (ft (nth 0%N (kinds s) n)) w).
Definition changes x v := flatten [seq flatten [seq change x v n w | w <- views] | n <- iota 0
  (size (kinds s))].

Lemma part_bound n k : (n < size (kinds s))%N -> (k < dim3 (ft (nth 0%N (kinds s) n)))%N ->
  (11 + (sumn (take n (sizes s)) + k) < N)%N.
Proof.
move=> nl kl; rewrite ltn_add2l; apply: (@flatten_indexP (sizes s) n k).
by rewrite (nth_map 0%N).
Qed.

Lemma image_formsE z y T (m : (nat -> R) -> (nat -> R) -> motion R) C p w l :
  image_change (C w) (T z w) p (m z y) l = [seq g z y | g <- image_forms T m C p w l].
Proof.
rewrite /image_change /image_forms map_cat; congr (_ ++ _); first by case: l.1.
rewrite /pin_forms map_flatten -map_comp; congr flatten; apply: eq_map => j /=.
by congr (_ :: _); case: l.1.
Qed.

Definition forms_of x n w := image_forms (fun z => twist_of z) (fun z _ => motion_of z n) (cameras_at R x)
  (place_of x n) w
  (looks (ft (nth 0%N (kinds s) n)) w).

Lemma changeE x v n w : change x v n w = [seq g v v | g <- forms_of x n w].
Proof. exact: (@image_formsE v v (fun z => twist_of z) (fun z _ => motion_of z n)). Qed.

Lemma forms_lin x n w : (n < size (kinds s))%N -> List.Forall (lin2 N 0) (forms_of x n w).
Proof.
move=> nl; have small k (h : (k < 11)%N) : (k < N)%N := ltn_addr _ h.
have lz k : (k < dim3 (ft (nth 0%N (kinds s) n)))%N -> lin2 N 0 (fun z (_ : nat -> R) => part z n k).
  by move=> kl; apply: lin2_z; exact: part_bound.
apply: image_forms_lin.
- by case; split=> /=; try exact: lin2_0; apply: lin2_z; exact: small.
- by case; split=> /=; try exact: lin2_0; apply: lin2_z; exact: small.
- have [d1 d2 d3] := free_motion_dX_lin R 0 (nth 0%N (kinds s) n).
  split; rewrite /motion_of /free_motion /=;
    try (by apply: lz; rewrite /dim3; case: (free _); rewrite addnC ltn_addl).
  by case e: (free _); [exact: lin2_0 | apply: lz; rewrite /dim3 e addnC ltn_addl].
- move=> j; rewrite /motion_of /free_motion /=; case: (ltnP j (pins _)) => jk; last by split; exact: lin2_0.
  have h : ((2 * j).+1 < 2 * pins (ft (nth 0%N (kinds s) n)))%N
    by rewrite -[(2 * j).+2]/(2 + 2 * j)%N -mulnS leq_mul2l.
  split=> /=; last exact: lin2_0; apply: lz; rewrite /dim3 ?ltn_add2l; first by rewrite (ltn_trans _ h).
  by rewrite -addnS ltn_add2l.
Qed.

Definition delta (i k : nat) : R := (k == i)%:R.
Lemma lin_nth (fs : seq ((nat -> R) -> (nat -> R) -> R)) v j : List.Forall (lin2 N 0) fs ->
  nth 0 [seq g v v | g <- fs] j = \sum_(i < N) v i * nth 0 [seq g (delta i) (delta i) | g <- fs] j.
Proof.
elim: fs j => [|g fs IH] j; first by rewrite /= !nth_nil big1 // => i _; rewrite ?nth_nil mulr0.
move=> /List.Forall_cons_iff[[c [d e]] h]; case: j => [|j]; last exact: IH.
rewrite [LHS]/= e /sum big_ord0 addr0; apply: eq_bigr => i _; rewrite [nth _ _ _]/= e /sum big_ord0 addr0.
rewrite (bigD1 i) //= /delta eqxx mulr1 big1 ?addr0 => [|k ki]; first by rewrite mulrC.
by move: ki; rewrite -val_eqE /= => /negbTE ->; rewrite mulr0.
Qed.

Definition all_forms_of x := flatten [seq flatten [seq forms_of x n w | w <- views] | n <- iota 0
  (size (kinds s))].
Lemma changesE x v : changes x v = [seq g v v | g <- all_forms_of x].
Proof.
rewrite /changes /all_forms_of map_flatten -map_comp; congr flatten; apply: eq_map => n.
by rewrite -[RHS]/(map _ (flatten _)) map_flatten -map_comp; congr flatten; apply: eq_map => w;
  exact: changeE.
Qed.
Lemma all_forms_of_lin x : List.Forall (lin2 N 0) (all_forms_of x).
Proof.
have h l : {subset l <= iota 0 (size (kinds s))} ->
    List.Forall (lin2 N 0) (flatten [seq flatten [seq forms_of x n w | w <- views] | n <- l]).
  elim: l => [|n l IH] sub; first by constructor.
  have nl : (n < size (kinds s))%N by have := sub n (mem_head _ _); rewrite mem_iota.
  apply/Forall_cat; split; last by apply: IH => i il; apply: sub; rewrite inE il orbT.
  have fl w := forms_lin x w nl.
  rewrite -[flatten _]/(forms_of x n V1 ++ forms_of x n V2 ++ forms_of x n V3 ++ [::]).
  by do 3![apply/Forall_cat; split; first exact: fl]; constructor.
exact: h.
Qed.

Lemma size_changes x v : size (changes x v) = sumn [seq dim2 (ft i) | i <- kinds s].
Proof.
rewrite /changes size_flatten /seq.shape -map_comp -[in RHS](mkseq_nth 0%N (kinds s)) /mkseq -map_comp.
congr sumn; apply: eq_map => n; set f := ft (nth 0%N (kinds s) n).
have sz w : size (change x v n w) =
  (if (looks f w).1 then 2 + size (looks f w).2 else 2 * size (looks f w).2)%N.
  by rewrite changeE size_map size_image_forms.
rewrite -[LHS]/(size (change x v n V1 ++ change x v n V2 ++ change x v n V3 ++ [::])) -[RHS]/(dim2 f).
by rewrite size_cat sz size_cat sz size_cat sz.
Qed.

Definition system x : 'M[R]_N := \matrix_(i, j) nth 0 (changes x (delta i)) j.
Lemma systemE x v j : (\row_(i < N) v i *m system x) 0 j = nth 0 (changes x v) j.
Proof.
rewrite mxE changesE (lin_nth _ _ (all_forms_of_lin x)); apply: eq_bigr => i _.
by rewrite !mxE changesE.
Qed.

Hypothesis square : sumn [seq dim2 (ft i) | i <- kinds s] = N.
Lemma kernel x v : all (pred1 0) (changes x v) <-> \row_(i < N) v i *m system x = 0.
Proof.
split=> [/(all_nthP 0) h|h].
  by apply/rowP => j; rewrite systemE mxE; apply/eqP/h; rewrite size_changes square.
apply/(all_nthP 0) => j; rewrite size_changes square => jN; apply/eqP.
by rewrite -(systemE x v (Ordinal jN)) h mxE.
Qed.

Lemma det_kernel x : (forall v, all (pred1 0) (changes x v) -> forall k, (k < N)%N -> v k = 0) <->
  \det (system x) != 0.
Proof.
split=> [h|d0 v /kernel vM k kN].
  apply/det0P => -[r r0 rM]; case/rV0Pn: r0 => i /eqP; apply.
  pose v k := if insub k is Some i then r 0 i else 0.
  have vi (i' : 'I_N) : v i' = r 0 i' by rewrite /v valK.
  rewrite -vi; apply: h (ltn_ord i); apply/kernel; rewrite -[RHS]rM; congr (_ *m _).
  by apply/rowP => i'; rewrite mxE vi.
apply/eqP; apply: contraNT d0 => vk; apply/det0P; exists (\row_(i < N) v i) => //.
by apply/rV0Pn; exists (Ordinal kN); rewrite mxE.
Qed.
End System.

(** ** Lists of unknowns *)
Section Lists.
Variables (R : idomainType) (s : signature).
Notation Vec := (@Vec R).

Lemma nth_dirs k (dir : nat -> vec R) j : (j < k)%N ->
  nth 0 (own_dirs k dir) (2 * j) = x1 (dir j) /\ nth 0 (own_dirs k dir) (2 * j).+1 = x2 (dir j).
Proof.
have h a : let l := flatten [seq [:: x1 (dir i); x2 (dir i)] | i <- iota a k] in (j < k)%N ->
    nth 0 l (2 * j) = x1 (dir (a + j)%N) /\ nth 0 l (2 * j).+1 = x2 (dir (a + j)%N).
  elim: k a j => // k IH a [|j] l; first by rewrite addn0.
  by rewrite ltnS mulnS -addSnnS => /(IH a.+1) [<- <-].
exact: h 0%N.
Qed.

(** The unknowns of a feature, first of its point u, then of its directions. *)
Section Own.
Variables (f : feature) (u : vec R) (dir : nat -> vec R).
Let l := nth 0 (own_point (free f) u ++ own_dirs (pins f) dir).
Let o := (if free f then 2 else 3)%N.
Lemma own_pointN : [/\ l 0%N = x1 u, l 1%N = x2 u & ~~ free f -> l 2%N = x3 u].
Proof. by rewrite /l; case: (free f). Qed.
Lemma own_dirN j : (j < pins f)%N -> l (o + 2 * j)%N = x1 (dir j) /\ l (o + 2 * j).+1 = x2 (dir j).
Proof.
move=> jp; have [d1 d2] := nth_dirs dir jp.
rewrite /l !nth_cat size_own_point -/o ltnNge leq_addr /= addKn d1.
by rewrite ltnNge ltnW /= ?ltnS ?leq_addr // -addnS addKn d2.
Qed.
Lemma size_own : size (own_point (free f) u ++ own_dirs (pins f) dir) = dim3 f.
Proof. by rewrite size_cat size_own_point size_pairs size_iota. Qed.
End Own.

Variables (cam : seq R) (own : nat -> seq R).
Hypothesis size_cam : size cam = 11%N.
Hypothesis size_own_n : forall n, (n < size (kinds s))%N -> size (own n) = nth 0%N (sizes s) n.
Definition assembled := cam ++ flatten [seq own n | n <- iota 0 (size (kinds s))].
Lemma assembled_camera k : (k < 11)%N -> nth 0 assembled k = nth 0 cam k.
Proof. by move=> h; rewrite /assembled nth_cat size_cam h. Qed.
Lemma assembled_part n o : (n < size (kinds s))%N -> (o < nth 0%N (sizes s) n)%N ->
  part s (nth 0 assembled) n o = nth 0 (own n) o.
Proof.
move=> nl ol; have sh : seq.shape [seq own n | n <- iota 0 (size (kinds s))] = sizes s.
  apply: (@eq_from_nth _ 0%N); rewrite !size_map size_iota // => i il.
  by rewrite (nth_map [::]) ?size_map ?size_iota // (nth_map 0%N) ?size_iota // nth_iota // size_own_n.
rewrite /part /assembled nth_cat size_cam ltnNge leq_addr /= addKn nth_flatten sh.
rewrite -/(flatten_index _ _ _) flatten_indexKl // flatten_indexKr //.
by rewrite (nth_map 0%N) ?size_iota // nth_iota.
Qed.
End Lists.

(** A motion is zero only if its unknowns are. *)
Lemma zero_motion (R : idomainType) s (v : nat -> R) : (forall w, twist_of v w = Twist (vec0 R) (vec0 R)) ->
  (forall n, (n < size (kinds s))%N -> dX (motion_of s v n) = vec0 R /\
     forall j, (j < pins (ft (nth 0%N (kinds s) n)))%N -> dD (motion_of s v n) j = vec0 R) ->
  forall k, (k < unknowns_count s)%N -> v k = 0.
Proof.
move=> t0 m0 k; case: (ltnP k 11) => [k11 _|k11].
  by have := t0 V2; have := t0 V3 => -[] ? ? ? ? ? ? -[] ? ? ? ? ?; move: k k11; do 11?[case=> //].
rewrite -(subnKC k11) ltn_add2l; set i := (k - 11)%N => il.
rewrite -(reshape_indexK (sizes s) i) /flatten_index.
have := reshape_offsetP il; have := reshape_indexP il.
move: (reshape_index _ i) (reshape_offset _ i) => n o; rewrite size_map => nl.
rewrite (nth_map 0%N) // => lo.
have [X0 D0] := m0 n nl; exact: (free_motion_zero X0 D0 lo).
Qed.

(** ** The matrix is natural *)
Section Natural.
Variables (R R' : idomainType) (f : {rmorphism R -> R'}) (s : signature).
Variables (x : nat -> R) (x' : nat -> R').
Hypothesis fx : forall k, x' k = f (x k).
Lemma cameras_map w : cameras_at R' x' w = fcamera f (cameras_at R x w).
Proof. by case: w; rewrite /fcamera /fquat /fvec /= !(rmorph0, rmorph1) // -!fx. Qed.
Lemma point_map n : point (place_of s x' n) = fvec f (point (place_of s x n)).
Proof. by rewrite /fvec /= -!fx; case: (free _); rewrite ?rmorph0 -?fx. Qed.
Lemma dir_map n j : dir (place_of s x' n) j = fvec f (dir (place_of s x n) j).
Proof. by rewrite /fvec /= -!fx rmorph1. Qed.

Lemma changes_map v v' : (forall k, v' k = f (v k)) -> changes s x' v' = map f (changes s x v).
Proof.
move=> fv; rewrite /changes map_flatten -map_comp; congr flatten; apply: eq_map => n.
rewrite -[RHS]/(map f (flatten _)) map_flatten -map_comp; congr flatten; apply: eq_map => w.
have ft w' : twist_of v' w' = ftwist f (twist_of v w').
  by case: w'; rewrite /ftwist /fvec /= ?rmorph0 -?fv.
rewrite [RHS]/= /change cameras_map ft; apply: image_change_map.
- exact: point_map.
- exact: dir_map.
- by rewrite /motion_of /fvec /= /part -!fv; case: (free _); rewrite ?rmorph0 -?fv.
- by move=> j; rewrite /motion_of /free_motion /=; case: ifP => _; rewrite /fvec /= !rmorph0 // /part -!fv.
Qed.

Lemma det_map : \det (system s x') = f (\det (system s x)).
Proof.
rewrite -det_map_mx; congr (\det _); apply/matrixP => i j; rewrite !mxE.
rewrite (changes_map (v := delta R i)) => [|k]; last by rewrite /delta rmorph_nat.
case: (ltnP j (size (changes s x (delta R i)))) => h; first by rewrite (nth_map 0).
by rewrite !nth_default ?size_map // rmorph0.
Qed.
End Natural.
