(** * Rigid at a configuration, in terms of derivations

    Let x be parameters in K whose configuration is regular: no denominator of an image coordinate
    is zero. If the configuration is rigid, a derivation that kills the images kills x
    ([rigid_kills]). Conversely, let there be a derivation with any given values at x; if each that
    kills the images kills x, the configuration is rigid ([kills_rigid]). *)
From mathcomp Require Import all_ssreflect all_algebra.
From mathcomp.algebra_tactics Require Import ring.
From PL1P Require Import Statement Rigid Walk Derivations Forms Blocks Epipolar Motion Specialize.
Set Implicit Arguments.
Unset Strict Implicit.
Unset Printing Implicit Defensive.
Import GRing.Theory.
Local Open Scope ring_scope.

Section Moves.
Variables (F K : fieldType) (c : {rmorphism F -> K}) (s : signature) (x : nat -> K).
Hypothesis char0 : [char F] =i pred0.
Notation Vec := (@Vec K).
Let C := cameras_at K x.
Let scene := scene_at K x s.
Let place n := nth (p0 K) scene n.
Definition r2 := Vec (x 0%N) (x 1%N) (x 2%N).
Definition r3 := Vec (x 5%N) (x 6%N) (x 7%N).

Let two : 2%:R != 0 :> K := two_neq0 c char0.

Definition local n k := x (11 + (sumn (take n (sizes s)) + k)).
Lemma place_nth n : (n < size (kinds s))%N -> place n = @place_at K (local n) (nth 0%N (kinds s) n).
Proof. by move=> h; rewrite /place /scene /scene_at nth_mkseq. Qed.
Lemma size_scene : size scene = size (kinds s). Proof. exact: size_mkseq. Qed.
Lemma kind_place n : (n < size (kinds s))%N -> kind (place n) = nth 0%N (kinds s) n.
Proof. by move=> h; rewrite place_nth. Qed.

Definition regular :=
  [/\ size2 r2 != 0, size2 r3 != 0 &
      forall n, (n < size (kinds s))%N -> let p := place n in forall v,
      (sees_point (ft (kind p)) v -> x3 (project (C v) (point p)) != 0) /\
      forall j, j \in sees_pins (ft (kind p)) v -> (x2 (line (C v) p j) != 0) && (x3 (line (C v) p j) != 0)].
Hypothesis reg : regular.

Section OneDerivation.
Variable D : K -> K.
Hypothesis hD : derivation c D.
Let rho := stretch D r2.
Definition twists v := match v with
  | V1 => Twist (vec0 K) (vec0 K)
  | V2 => Twist (spin D r2) (dvec D (trans (C V2)))
  | V3 => Twist (spin D r3) (add (dvec D (trans (C V3))) (scale (rho - stretch D r3) (trans (C V3))))
  end.
Definition moves n := Motion (add (dvec D (point (place n))) (scale rho (point (place n))))
  (fun j => dvec D (dir (place n) j)).

Definition al v := match v with V1 => rho | V2 => 0 | V3 => rho - stretch D r3 end.
Definition be v := match v with V1 => 0 | V2 => - rho | V3 => - stretch D r3 end.

Lemma rot_one (u : vec K) : rot (@Quat K 1 0 0 0) u = u.
Proof. by case: u => a b f; rewrite /rot /dot /=; congr Vec; ring. Qed.

Lemma dir_moves v (e : vec K) : d_turn (C v) (twists v) e (dvec D e) =
  add (dvec D (turn (C v) e)) (scale (be v) (turn (C v) e)).
Proof.
have [n2 n3 _] := reg; case: v; rewrite /d_turn /turn.
- rewrite -[quat_of (C V1)]/(@Quat K 1 0 0 0) !rot_one; case: e => a b f; rewrite /add /cross /scale /dvec /=;
    congr Vec; ring.
- exact: (turn_moved hD e n2).
- exact: (turn_moved hD e n3).
Qed.

Lemma vaddA (u v w : vec K) : add u (add v w) = add (add u v) w.
Proof. by rewrite /add /= !addrA. Qed.

Lemma project_moves v X : let Y := project (C v) X in
  d_project (C v) (twists v) X (add (dvec D X) (scale rho X)) = add (dvec D Y) (scale (al v) Y).
Proof.
have e : d_project (C v) (twists v) X (add (dvec D X) (scale rho X)) =
  add (add (d_turn (C v) (twists v) X (dvec D X)) (scale rho (turn (C v) X))) (dt (twists v)).
  by rewrite /d_project /d_turn /turn rot_add rot_scale vaddA.
move=> Y; rewrite {}e dir_moves /Y /project => {Y}; have := derD hD; move: (turn (C v) X) => [a b f] dAdd.
case: v; rewrite /add /scale /dvec /= !dAdd ?(der0 hD); congr Vec; ring.
Qed.

Lemma images_killed n v : (n < size (kinds s))%N -> let p := place n in let l := looks (ft (kind p)) v in
  all (fun a => D a == 0) (placed_image (C v) p l) =
    all (pred1 0) (image_change (C v) (twists v) p (moves n) l).
Proof.
move=> nl p l; have [_ _ /(_ n nl v)[seen lines]] := reg.
apply: (image_killed hD (erefl _) (al := al v) (be := be v)).
- exact: project_moves.
- by move=> j _; exact: dir_moves.
- exact: seen.
- exact: lines.
Qed.

Definition coordinates := flatten
  [seq flatten [seq placed_image (C v) p (looks (ft (kind p)) v) | v <- views] | p <- scene].
Lemma all_views A (q : pred A) (f : view -> seq A) :
  all q (flatten [seq f v | v <- views]) = [&& all q (f V1), all q (f V2) & all q (f V3)].
Proof. by rewrite /= !all_cat andbT. Qed.
Lemma all_coordinates (q : pred K) : all q coordinates ->
  forall n, (n < size (kinds s))%N ->
    forall v, all q (placed_image (C v) (place n) (looks (ft (kind (place n))) v)).
Proof.
rewrite /coordinates all_flatten all_map => /(all_nthP (p0 K)) h n nl v.
have := h n; rewrite size_scene => /(_ nl).
by rewrite -[preim _ _ _]/(all q (flatten _)) all_views => /and3P[]; case: v.
Qed.
Lemma coordinates_all (q : pred K) :
  (forall n, (n < size (kinds s))%N ->
    forall v, all q (placed_image (C v) (place n) (looks (ft (kind (place n))) v))) -> all q coordinates.
Proof.
move=> h; rewrite /coordinates all_flatten all_map; apply/(all_nthP (p0 K)) => n; rewrite size_scene => nl.
by rewrite -[preim _ _ _]/(all q (flatten _)) all_views; apply/and3P; split; exact: h.
Qed.

Lemma twists_gauge : gauge twists.
Proof. by split=> //; exact: der1 hD. Qed.
Lemma moves_gauge n : (n < size (kinds s))%N -> feature_gauge (place n) (moves n).
Proof.
move=> nl; split=> [j _|]; rewrite /moves place_nth //; first exact: der1 hD.
by move=> /= ->; rewrite (der0 hD) mulr0 addr0.
Qed.

Theorem rigid_kills : rigid C scene -> all (fun a => D a == 0) coordinates ->
  forall k, (k < 11 + sumn (sizes s))%N -> D (x k) = 0.
Proof.
move=> rg killed.
have [|T0 m0] := rg twists moves twists_gauge.
  rewrite size_scene => n nl; split; first exact: moves_gauge.
  by move=> v; exact: etrans (esym (images_killed v nl)) (all_coordinates killed nl v).
rewrite size_scene in m0; have [n2 n3 _] := reg.
have w2 : dvec D r2 = vec0 K by apply: (spin_zero two n2); have q := congr1 (@omega K) (T0 V2); exact: q.
have w3 : dvec D r3 = vec0 K by apply: (spin_zero two n3); have q := congr1 (@omega K) (T0 V3); exact: q.
have rho0 : rho = 0 := stretch_zero hD w2.
have t2 : dvec D (trans (C V2)) = vec0 K by have q := congr1 (@dt K) (T0 V2); exact: q.
have t3 : dvec D (trans (C V3)) = vec0 K.
  have := congr1 (@dt K) (T0 V3); rewrite /= rho0 (stretch_zero hD w3) subrr /add /scale /= !mul0r !addr0.
  exact: id.
apply: (@zero_motion K s (fun k => D (x k))) => [[||]|n nl] //.
- by move: t2; rewrite /dvec /= (der1 hD) => t2; congr Twist; [exact: w2 | exact: t2].
- by congr Twist; [exact: w3 | exact: t3].
have [X0 D0] := m0 n nl; split=> [|j jp].
  move: X0; rewrite /moves rho0 place_nth //= /add /scale /dvec /= !mul0r !addr0 => -[h0 h1 h2].
  apply: vec_ext => //=; by move: h2; case: (free _).
by have := D0 j; rewrite kind_place // => /(_ jp); rewrite /moves place_nth //= jp /dvec /= (der1 hD).
Qed.

Lemma zero_twists : (forall k, (k < 11)%N -> D (x k) = 0) -> rho = 0 /\ forall v, twists v =
  Twist (vec0 K) (vec0 K).
Proof.
move=> z; have D1 := der1 hD.
have w2 : dvec D r2 = vec0 K by rewrite /dvec /= !z.
have w3 : dvec D r3 = vec0 K by rewrite /dvec /= !z.
have sp r : dvec D r = vec0 K -> spin D r = vec0 K.
  by move=> e; rewrite /spin e; case: r {e} => ? ? ?; rewrite /scale /add /cross /vec0 /=; congr Vec; ring.
have rho0 : rho = 0 := stretch_zero hD w2.
split=> //; case=> //=; rewrite ?rho0 ?(stretch_zero hD w3) ?sp // /dvec /= !z // ?D1 //.
by rewrite /add /scale /vec0 /= subrr !mul0r !addr0.
Qed.
End OneDerivation.

Lemma image_change_eq (A : camera K) (T : twist K) p m m' (l : look) : dX m = dX m' ->
  (forall j, j \in l.2 -> dD m j = dD m' j) -> image_change A T p m l = image_change A T p m' l.
Proof.
move=> eX eD; rewrite /image_change eX; congr (_ ++ flatten _); apply/eq_in_map => j jl.
by rewrite /d_line eD.
Qed.

Hypothesis extend : forall d : nat -> K, exists2 D, derivation c D &
  forall k, (k < 11 + sumn (sizes s))%N -> D (x k) = d k.

Section Given.
Variables (T : view -> twist K) (m : nat -> motion K).
Hypothesis gT : gauge T.
Hypothesis still : forall n, (n < size scene)%N -> let p := nth (p0 K) scene n in feature_gauge p (m n) /\
     forall v, all (pred1 0) (image_change (C v) (T v) p (m n) (looks (ft (kind p)) v)).
Let rho := dot (omega (T V2)) r2.
Definition u2 := unspin (omega (T V2)) r2.
Definition u3 := unspin (omega (T V3)) r3.
Definition w3 := add (dt (T V3)) (scale (dot (omega (T V3)) r3 - rho) (trans (C V3))).
Definition own_values n := own_unknowns (ft (kind (place n)))
  (Motion (add (dX (m n)) (scale (- rho) (point (place n)))) (dD (m n))).
Definition values_of : seq K := assembled s
  [:: x1 u2; x2 u2; x3 u2; x2 (dt (T V2)); x3 (dt (T V2)); x1 u3; x2 u3; x3 u3; x1 w3; x2 w3;
    x3 w3] own_values.

Variable D : K -> K.
Hypothesis hD : derivation c D.
Hypothesis D_values : forall k, (k < 11 + sumn (sizes s))%N -> D (x k) = nth 0 values_of k.

Lemma D_camera k : (k < 11)%N -> D (x k) = nth 0 values_of k.
Proof. by move=> h; apply: D_values; exact: ltn_addr. Qed.
Lemma D_local n o : (n < size (kinds s))%N -> (o < nth 0%N (sizes s) n)%N -> D (local n o) =
  nth 0 (own_values n) o.
Proof.
move=> nl ol; rewrite D_values; last by rewrite ltn_add2l; apply: (@flatten_indexP (sizes s) n o).
apply: assembled_part => // i il.
by rewrite (nth_map 0%N) // /own_values /own_unknowns size_own kind_place.
Qed.

Lemma given_twists : stretch D r2 = rho /\ forall v, twists D v = T v.
Proof.
have [n2 n3 _] := reg; have [g1 g2] := gT.
have e2 : dvec D r2 = u2 by rewrite /dvec /= !D_camera.
have e3 : dvec D r3 = u3 by rewrite /dvec /= !D_camera.
have s2 := spin_unspin two n2 e2; have s3 := spin_unspin two n3 e3.
have h2 : stretch D r2 = rho := stretch_unspin hD two n2 e2.
have h3 := stretch_unspin hD two n3 e3.
split=> //; case; first by rewrite g1.
  rewrite /= s2 /dvec /= (der1 hD) !D_camera //=; case: (T V2) g2 => w [t1 t2 t3] /= ->.
  by [].
rewrite /= s3 h2 h3 /dvec /= !D_camera //=; case: (T V3) => w [t1 t2 t3] /=.
congr Twist; rewrite /w3 /= /add /scale /=; congr Vec; ring.
Qed.

Lemma given_moves n : (n < size (kinds s))%N ->
  dX (moves D n) = dX (m n) /\ forall j, (j < pins (ft (kind (place n))))%N -> dD (moves D n) j = dD (m n) j.
Proof.
move=> nl; have [h _] := given_twists.
have [[gD gX] _] : let p := place n in feature_gauge p (m n) /\
    forall v, all (pred1 0) (image_change (C v) (T v) p (m n) (looks (ft (kind p)) v)).
  by apply: still; rewrite size_scene.
have dim : nth 0%N (sizes s) n = dim3 (ft (nth 0%N (kinds s) n)) by rewrite (nth_map 0%N).
have loc := @D_local n _ nl; rewrite dim /own_values in loc.
rewrite /moves h; move: gD gX loc; rewrite place_nth //=.
set f := ft _; set y := local n; set X := Vec _ _ _ => gD gX loc.
have [q0 q1 q2] := own_pointN f (add (dX (m n)) (scale (- rho) X)) (dD (m n)); split.
  apply: vec_ext => /=.
  - by rewrite loc ?[nth _ _ _]q0 /= ?mulNr ?subrK // /dim3; case: (free _).
  - by rewrite loc ?[nth _ _ _]q1 /= ?mulNr ?subrK // /dim3; case: (free _).
  - have [fr|nf] := boolP (free f); first by rewrite (der0 hD) mulr0 addr0 gX.
    rewrite loc; last by rewrite /dim3 (negbTE nf).
    by rewrite [nth _ _ _](q2 nf) /X /= (negbTE nf) mulNr subrK.
move=> j jp; have [d1 d2] := @own_dirN K f (add (dX (m n)) (scale (- rho) X)) (dD (m n)) j jp.
have lt : ((2 * j).+1 < 2 * pins f)%N by rewrite -[(2 * j).+2]/(2 + 2 * j)%N -mulnS leq_mul2l.
apply: vec_ext => /=.
- by rewrite loc ?[nth _ _ _]d1 // /dim3 ltn_add2l ltnW.
- by rewrite loc ?[nth _ _ _]d2 // /dim3 -addnS ltn_add2l.
- by rewrite (der1 hD) gD.
Qed.
End Given.

Theorem kills_rigid : (forall D, derivation c D -> all (fun a => D a == 0) coordinates ->
  forall k, (k < 11 + sumn (sizes s))%N -> D (x k) = 0) -> rigid C scene.
Proof.
move=> kills T m gT still.
have [D hD val] := extend (nth 0 (values_of T m)).
have [_ tw] := given_twists gT hD val.
have mv n (nl : (n < size (kinds s))%N) := given_moves gT still hD val nl.
have killed : all (fun a => D a == 0) coordinates.
  apply: coordinates_all => n nl v; apply: etrans (images_killed hD v nl) _.
  have nl' : (n < size scene)%N by rewrite size_scene.
  have [_ st] := still n nl'; rewrite tw; apply: etrans (st v).
  have [e1 e2] := mv n nl; congr (all _ _); apply: image_change_eq e1 _ => j jl; apply: e2.
  have := pins_okP (kind (place n)); rewrite /pins_ok => /and4P[/allP p1 /allP p2 /allP p3 _].
  by clear st; case: v jl => jl; [apply: p1|apply: p2|apply: p3].
have z := kills D hD killed.
have [|h zt] := @zero_twists D hD; first by move=> k k11; apply: z; exact: ltn_addr.
rewrite size_scene; split=> [v|n nl]; first by rewrite -tw zt.
have [e1 e2] := mv n nl; rewrite -e1.
have zl o : (o < nth 0%N (sizes s) n)%N -> D (local n o) = 0.
  by move=> ol; apply: z; rewrite ltn_add2l; apply: (@flatten_indexP (sizes s) n o).
have dim : nth 0%N (sizes s) n = dim3 (ft (nth 0%N (kinds s) n)) by rewrite (nth_map 0%N).
rewrite dim /dim3 in zl; split=> [|j jp].
  rewrite /moves h place_nth //= /add /scale /dvec /= !mul0r !addr0 !zl; try by case: (free _).
  by case fr: (free _); rewrite ?(der0 hD) // zl // fr.
rewrite -e2 //; move: jp; rewrite /moves -/(place n) place_nth //= => jp.
have lt : ((2 * j).+1 < 2 * pins (ft (nth 0%N (kinds s) n)))%N
  by rewrite -[(2 * j).+2]/(2 + 2 * j)%N -mulnS leq_mul2l.
set o := if _ then _ else _ in zl *.
have z1 : D (local n (o + 2 * j)%N) = 0 by apply: zl; rewrite ltn_add2l ltnW.
have z2 : D (local n (o + 2 * j).+1) = 0 by apply: zl; rewrite -addnS ltn_add2l.
by rewrite /dvec /= z1 z2 (der1 hD).
Qed.
End Moves.
