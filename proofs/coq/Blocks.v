(** * Placed features as blocks of a linear system in unknown motions

    [free_motion] spends all of a feature's unknowns, [image_forms] are its equations; dropping
    equations that follow from the others, or unknowns that are not needed, gives the smaller blocks
    of Obstructed.v. *)
From Coq Require List.
From mathcomp Require Import all_ssreflect all_algebra.
From mathcomp.algebra_tactics Require Import ring.
From PL1P Require Import Statement Rigid Walk System.
Set Implicit Arguments.
Unset Strict Implicit.
Unset Printing Implicit Defensive.
Import GRing.Theory.
Local Open Scope ring_scope.

(** ** Sums over a scene are totals of its signature *)
Lemma sumn_scene (R : idomainType) (scene : seq (placed R)) s h : shape scene s ->
  sumn [seq h (kind p) | p <- scene] = total s h.
Proof.
case=> k27 ->; rewrite /total.
have -> : [seq nth 0%N [seq count (fun p => kind p == i) scene | i <- iota 0 27] i * h i | i <- iota 0 27]%N =
          [seq count (fun p => kind p == i) scene * h i | i <- iota 0 27]%N.
  by apply/eq_in_map => i; rewrite mem_iota => i27; rewrite (nth_map 0%N) ?size_iota // nth_iota.
elim: scene k27 => [|p scene IH]; first by move=> _; elim: (iota 0 27) => //= i l <-; rewrite mul0n.
move=> /andP[p27 k27]; rewrite [LHS]/= IH //.
have key (c : nat -> nat) l : (h (kind p) * count (pred1 (kind p)) l + sumn [seq c i * h i | i <- l] =
    sumn [seq ((kind p == i) + c i) * h i | i <- l])%N.
  elim: l => [|i l IHl]; first by rewrite muln0.
  rewrite [LHS]/= [RHS]/= -IHl mulnDr !mulnDl eq_sym; case: (eqVneq (kind p) i) => [->|ne] /=;
    first by rewrite muln1 mul1n addnACA.
  by rewrite muln0 mul0n !add0n addnCA.
have one : count (pred1 (kind p)) (iota 0 27) = 1%N by rewrite count_uniq_mem ?iota_uniq // mem_iota p27.
have := key (fun i => count (fun q => kind q == i) scene) (iota 0 27).
by rewrite one muln1 => ->.
Qed.

Lemma count_scene (R : idomainType) (scene : seq (placed R)) s i : shape scene s -> (i < 27)%N ->
  nth 0%N s i = count (fun p => kind p == i) scene.
Proof. by case=> _ -> i27; rewrite (nth_map 0%N) ?size_iota // nth_iota. Qed.

Lemma scene_kind (R : idomainType) (scene : seq (placed R)) s n : shape scene s -> (n < size scene)%N ->
  (kind (nth (p0 R) scene n) < 27)%N.
Proof.
case=> k27 _; elim: scene n k27 => [|p scene IH] [|n] //= /andP[] //.
by move=> _ h; apply: IH.
Qed.

Section Blocks.
Variable R : idomainType.
Implicit Types (x y z : nat -> R).
Notation Vec := (@Vec R).
Notation Forall := List.Forall.

(** A motion that spends the 3 + 2k unknowns of a point with k pins, or the 4 of a free line. *)
Definition free_motion (i : nat) y : motion R :=
  let fr := free (ft i) in let o := if fr then 2%N else 3%N in
  Motion (Vec (y 0%N) (y 1%N) (if fr then 0 else y 2%N)) (fun j => if (j < pins (ft i))%N
    then Vec (y (o + 2 * j)%N) (y (o + 2 * j).+1) 0 else vec0 R).

Lemma vec_eq0 a b c : Vec a b c = vec0 R -> [/\ a = 0, b = 0 & c = 0].
Proof. by case=> -> -> ->. Qed.

Lemma free_motion_zero i y : dX (free_motion i y) = vec0 R ->
  (forall j, (j < pins (ft i))%N -> dD (free_motion i y) j = vec0 R) -> forall k, (k < dim3 (ft i))%N ->
    y k = 0.
Proof.
rewrite /dim3 /free_motion /=; set o := (if free (ft i) then 2 else 3)%N => /vec_eq0[h0 h1 h2] hD k kl.
case: (ltnP k o) => [ko|ok].
  by move: h2 ko; rewrite /o; case: (free _); case: k {kl} => [|[|[|k]]].
have := odd_double_half (k - o); set j := (k - o)./2 => ej.
have jk : (j < pins (ft i))%N.
  by rewrite -ltn_double -!mul2n; apply: leq_ltn_trans (_ : k - o < _)%N;
    rewrite ?ltn_subLR // -ej mul2n leq_addl.
have := hD j jk; rewrite jk => /vec_eq0[d1 d2 _].
have ek : k = (o + (odd (k - o) + 2 * j))%N by rewrite mul2n ej subnKC.
by rewrite ek; case: (odd _) => /=; rewrite ?add1n ?add0n ?addnS.
Qed.

Lemma free_motion_gauge p y : feature_gauge p (free_motion (kind p) y).
Proof. by split=> [j jk|fr]; rewrite /free_motion /= ?jk // fr. Qed.

Section Linear.
Variables n0 u : nat.
Variables (T : (nat -> R) -> view -> twist R) (m : (nat -> R) -> (nat -> R) -> motion R).
Hypothesis T_omega : forall v, vlin n0 u (fun z _ => omega (T z v)).
Hypothesis T_dt : forall v, vlin n0 u (fun z _ => dt (T z v)).
Hypothesis m_dX : vlin n0 u (fun z y => dX (m z y)).
Hypothesis m_dD : forall j, vlin n0 u (fun z y => dD (m z y) j).
Variables (C : view -> camera R) (p : placed R).

Definition dx v z y := d_project (C v) (T z v) (point p) (dX (m z y)).
Lemma dx_lin v : vlin n0 u (dx v).
Proof.
apply: vlin_add; last exact: T_dt.
by apply: vlin_add; [apply: vlin_cross; exact: T_omega | apply: vlin_rot].
Qed.

Definition point_forms v := let x := project (C v) (point p) in
  [:: (fun z y => dot (Vec 0 (x3 x) (- x2 x)) (dx v z y));
    (fun z y => dot (Vec (- x3 x) 0 (x1 x)) (dx v z y))].
Definition pin_forms v (l : look) : seq ((nat -> R) -> (nat -> R) -> R) :=
  flatten [seq (fun z y => d_line (C v) (T z v) p (m z y) j) ::
    (if l.1 then [::] else [:: (fun z y => dot (line (C v) p j) (dx v z y))]) | j <- l.2].
Definition image_forms v (l : look) := (if l.1 then point_forms v else [::]) ++ pin_forms v l.
Definition all_forms := flatten [seq image_forms v (looks (ft (kind p)) v) | v <- views].

Lemma point_forms_lin v : Forall (lin2 n0 u) (point_forms v).
Proof. by repeat constructor; apply: lin2_dot; exact: dx_lin. Qed.

Lemma pin_forms_lin v l : Forall (lin2 n0 u) (pin_forms v l).
Proof.
rewrite /pin_forms; elim: l.2 => [|j js IH]; first by constructor.
rewrite [flatten _]/=; constructor.
  by apply: lin2_dot; apply: vlin_add; [apply: vlin_cross; exact: T_omega | apply: vlin_rot].
apply/Forall_cat; split=> //; case: ifP => _; first by constructor.
by constructor; [apply: lin2_dot; exact: dx_lin | constructor].
Qed.

Lemma image_forms_lin v l : Forall (lin2 n0 u) (image_forms v l).
Proof.
apply/Forall_cat; split; last exact: pin_forms_lin.
by case: ifP => _; [exact: point_forms_lin | constructor].
Qed.

Lemma all_formsE : all_forms = image_forms V1 (looks (ft (kind p)) V1) ++
  image_forms V2 (looks (ft (kind p)) V2) ++
  image_forms V3 (looks (ft (kind p)) V3).
Proof. by rewrite /all_forms -[flatten _]/(_ ++ _ ++ _ ++ [::]) cats0. Qed.
Lemma all_forms_lin : Forall (lin2 n0 u) all_forms.
Proof.
by rewrite all_formsE; apply/Forall_cat; split; [|apply/Forall_cat; split]; exact: image_forms_lin.
Qed.

Lemma size_image_forms v l : size (image_forms v l) = (if l.1 then 2 + size l.2 else 2 * size l.2)%N.
Proof.
have sz A B (g : A -> seq B) c js : (forall j, size (g j) = c) -> size (flatten (map g js)) = (c * size js)%N.
  by move=> h; elim: js => [|j js IH]; rewrite ?muln0 // [flatten _]/= size_cat IH h mulnS.
rewrite size_cat /pin_forms; case: l => -[] js /=; first by rewrite (sz _ _ _ 1%N) ?mul1n.
by rewrite (sz _ _ _ 2%N).
Qed.

Lemma size_all_forms : size all_forms = dim2 (ft (kind p)).
Proof. by rewrite all_formsE size_cat [X in (_ + X)%N]size_cat !size_image_forms /dim2 /= addn0. Qed.

Definition still z y v := all (pred1 0) (image_change (C v) (T z v) p (m z y) (looks (ft (kind p)) v)).

Lemma pin_forms_still z y v l : Forall (fun f => f z y = 0) (pin_forms v l) ->
  all (pred1 0) (flatten [seq d_line (C v) (T z v) p (m z y) j ::
    (if l.1 then [::] else [:: dot (line (C v) p j) (dx v z y)]) | j <- l.2]).
Proof.
rewrite /pin_forms; elim: l.2 => [|j js IH] // /List.Forall_cons_iff[h1 /Forall_cat[h2 h3]].
rewrite map_cons -[flatten (_ :: _)]/(_ :: _ ++ flatten _).
rewrite -[all _ _]/(pred1 0 _ && all (pred1 0) (_ ++ flatten _)) all_cat; apply/and3P; split;
  first by rewrite /= h1.
  2: exact: IH.
by move: h2; case: ifP => // _ /List.Forall_cons_iff[h2 _]; rewrite /= h2 eqxx.
Qed.

Lemma still_cat z y v : let l := looks (ft (kind p)) v in
  (l.1 -> Forall (fun f => f z y = 0) (point_forms v)) -> Forall (fun f => f z y = 0) (pin_forms v l) ->
    still z y v.
Proof.
move=> l hp hq; rewrite /still /image_change all_cat -/l; apply/andP; split; last exact: pin_forms_still.
case: l.1 hp => // /(_ isT) hp; inversion hp as [|? ? h1 h2]; inversion h2 as [|? ? h3 _]; subst.
by rewrite /= -/(dx v z y) h1 h3 eqxx.
Qed.

Lemma image_forms_still z y v : Forall (fun f => f z y = 0) (image_forms v (looks (ft (kind p)) v)) ->
  still z y v.
Proof. by move=> /Forall_cat[h1 h2]; apply: still_cat => // e; move: h1; rewrite e. Qed.

Lemma all_forms_still z y : Forall (fun f => f z y = 0) all_forms -> forall v, still z y v.
Proof.
rewrite all_formsE => /Forall_cat[h1 /Forall_cat[h2 h3]].
by case; apply: image_forms_still.
Qed.
End Linear.

Lemma free_motion_dX_lin n0 i : vlin n0 (dim3 (ft i)) (fun _ y => dX (free_motion i y)).
Proof.
rewrite /free_motion /dim3; split=> /=; try by apply: lin2_y; case: (free _); rewrite addnC ltn_addl.
by case: (free _); [exact: lin2_0 | apply: lin2_y; rewrite addnC ltn_addl].
Qed.
Lemma free_motion_dD_lin n0 i j : vlin n0 (dim3 (ft i)) (fun _ y => dD (free_motion i y) j).
Proof.
rewrite /free_motion /dim3 /=; case: (ltnP j (pins (ft i))) => jk; last exact: vlin_0.
have h : ((2 * j).+1 < 2 * pins (ft i))%N by rewrite -[(2 * j).+2]/(2 + 2 * j)%N -mulnS leq_mul2l.
split=> /=; last exact: lin2_0.
  by apply: lin2_y; rewrite ltn_add2l (ltn_trans _ h).
by apply: lin2_y; rewrite -addnS ltn_add2l.
Qed.
End Blocks.
