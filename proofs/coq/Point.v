(** * The point of NormalPool.v as a configuration with integer parameters

    The matrix of Specialize.v has determinant nonzero there, if the signature is not obstructed
    ([xZ_det]). *)
From Coq Require Import ZArith.
From mathcomp Require Import all_ssreflect all_algebra.
From mathcomp.zify Require Import ssrZ.
From PL1P Require Import Statement Rigid Walk Forms Blocks Epipolar Crowded NormalPool Tree NormalPoint
  Regular.
From PL1P Require Import Motion Moves Specialize.
Set Implicit Arguments.
Unset Strict Implicit.
Unset Printing Implicit Defensive.
Import GRing.Theory.
Local Open Scope ring_scope.
Local Notation ZR := [idomainType of Z].

(** What is computed for NormalPool.v. *)
Local Notation cams := (Tree.cams normal_point).
Local Notation instance := (Tree.instance normal_point).
Local Notation capacity := (Tree.capacity normal_point).
Local Notation scene_of := (Regular.scene_of normal_point).

Lemma all_changes (R : idomainType) s (q : pred R) x v : all q (changes s x v) <->
  forall n, (n < size (kinds s))%N -> forall w, all q (change s x v n w).
Proof.
rewrite /changes all_flatten all_map; split=> [/allP h n nl w|h].
  have := h n; rewrite mem_iota => /(_ nl).
  by rewrite -[preim _ _ _]/(all q (flatten _)) all_views => /and3P[]; case: w.
apply/allP => n; rewrite mem_iota => nl.
by rewrite -[preim _ _ _]/(all q (flatten _)) all_views; apply/and3P; split; exact: h.
Qed.

(** ** The point as parameters *)
Section Point.
Variable s : signature.
Hypothesis bs : balanced s.

Lemma kindsE : kinds s = [seq ik.1 | ik <- places s].
Proof.
rewrite /kinds /places map_flatten -map_comp; congr flatten; apply: eq_map => i.
have h l : [seq (ik : nat * nat).1 | ik <- [seq (i, k) | k <- l]] = nseq (size l) i by elim: l => //= k l ->.
by rewrite -[RHS]/(map _ (map _ _)) h size_iota.
Qed.
Lemma size_kinds : size (kinds s) = size (places s). Proof. by rewrite kindsE size_map. Qed.

Definition at_place n := instance (place s n).1 (place s n).2.
Lemma kind_place n : (n < size (kinds s))%N -> (place s n).1 = nth 0%N (kinds s) n.
Proof. by rewrite size_kinds kindsE => nl; rewrite (nth_map (0, 0)%N). Qed.

(** Checks that Tree.v does not ask for. *)
Definition normal_ok i k := let p := instance i k in
  all (fun j => x3 (dir p j) == 1) (iota 0 (pins (ft i))) && (free (ft i) ==> (x3 (point p) == 0)) &&
  all (fun v => all (fun j => (x2 (line (cams v) p j) != 0) && (x3 (line (cams v) p j) != 0))
    (sees_pins (ft i) v)) views.
Lemma normals_ok : all (fun i => all (normal_ok i) (iota 0 (capacity i))) (iota 0 27).
Proof. by vm_compute. Qed.
Lemma place_ok n (q : nat -> nat -> bool) : all (fun i => all (q i) (iota 0 (capacity i))) (iota 0 27) ->
  (n < size (kinds s))%N -> q (place s n).1 (place s n).2.
Proof.
move=> h; rewrite size_kinds => nl; have : place s n \in places s by exact: mem_nth.
case: (place s n) => i k; rewrite mem_places => /andP[i27 ks] /=.
have := allP h i; rewrite mem_iota => /(_ i27) /allP /(_ k); apply.
by rewrite mem_iota; exact: leq_trans ks (balanced_capacity normal_checked bs i27).
Qed.

Lemma place_normal n : (n < size (kinds s))%N -> let f := ft (nth 0%N (kinds s) n) in
  [/\ forall j, (j < pins f)%N -> x3 (dir (at_place n) j) = 1, free f -> x3 (point (at_place n)) = 0 &
      forall w j, j \in sees_pins f w -> (x2 (line (cams w) (at_place n) j) != 0) &&
        (x3 (line (cams w) (at_place n) j) != 0)].
Proof.
move=> nl; rewrite -kind_place //=; have /andP[/andP[/allP nd fr] /and4P[/allP l1 /allP l2 /allP l3 _]] :=
  place_ok normals_ok nl.
split=> [j jp|f1|[]]; [| by apply/eqP; move: fr; rewrite f1 | exact: l1 | exact: l2 | exact: l3].
by apply/eqP/nd; rewrite mem_iota.
Qed.

Definition point_cam : seq Z :=
  let q := quat_of camera2 in let r := quat_of camera3 in
  [:: qb q; qc q; qd q; x2 (trans camera2); x3 (trans camera2); qb r; qc r; qd r;
      x1 (trans camera3); x2 (trans camera3); x3 (trans camera3)].
Definition point_own n : seq ZR := let f := ft (nth 0%N (kinds s) n) in
  own_point (free f) (point (at_place n)) ++ own_dirs (pins f) (dir (at_place n)).
Definition xZ : nat -> ZR := nth 0 (assembled s point_cam point_own).

Lemma point_own_size n : (n < size (kinds s))%N -> size (point_own n) = nth 0%N (sizes s) n.
Proof. by move=> nl; rewrite (nth_map 0%N) // /point_own size_own. Qed.
Lemma xZ_cameras w : cameras_at ZR xZ w = cams w.
Proof. by case: w. Qed.
Lemma xZ_part n o : (n < size (kinds s))%N -> (o < dim3 (ft (nth 0%N (kinds s) n)))%N -> part s xZ n o =
  nth 0 (point_own n) o.
Proof.
move=> nl ol; apply: assembled_part => //; first exact: point_own_size.
by rewrite (nth_map 0%N).
Qed.

Lemma xZ_point n : (n < size (kinds s))%N -> point (place_of s xZ n) = point (at_place n).
Proof.
move=> nl; have loc := xZ_part nl; set i := nth 0%N (kinds s) n in loc.
have [_ fr _] := place_normal nl; rewrite /= -/i in fr.
have [p0 p1 p2] := own_pointN (ft i) (point (at_place n)) (dir (at_place n)).
apply: vec_ext; rewrite /= -/i.
- by rewrite loc ?p0 // /dim3; case: (free _).
- by rewrite loc ?p1 // /dim3; case: (free _).
- case: (boolP (free (ft i))) fr => [_ -> //|nf _].
  by rewrite loc ?p2 // /dim3 (negbTE nf).
Qed.
Lemma xZ_dir n j : (n < size (kinds s))%N -> (j < pins (ft (nth 0%N (kinds s) n)))%N ->
  dir (place_of s xZ n) j = dir (at_place n) j.
Proof.
move=> nl; have loc := xZ_part nl; set i := nth 0%N (kinds s) n in loc * => jp.
have [nd _ _] := place_normal nl; rewrite /= -/i in nd.
have [d1 d2] := @own_dirN ZR (ft i) (point (at_place n)) (dir (at_place n)) j jp.
have lt : ((2 * j).+1 < 2 * pins (ft i))%N by rewrite -[(2 * j).+2]/(2 + 2 * j)%N -mulnS leq_mul2l.
apply: vec_ext; rewrite /= -/i.
- by rewrite loc ?d1 // /dim3 ltn_add2l ltnW.
- by rewrite loc ?d2 // /dim3 -addnS ltn_add2l.
- by rewrite nd.
Qed.

Lemma pins_seen i w j : j \in sees_pins (ft i) w -> (j < pins (ft i))%N.
Proof.
have := pins_okP i; rewrite /pins_ok => /and4P[/allP p1 /allP p2 /allP p3 _].
by case: w => jl; [apply: p1|apply: p2|apply: p3].
Qed.

Lemma xZ_line n w j : (n < size (kinds s))%N -> j \in sees_pins (ft (nth 0%N (kinds s) n)) w ->
  line (cameras_at ZR xZ w) (place_of s xZ n) j = line (cams w) (at_place n) j.
Proof. by move=> nl js; rewrite /line xZ_cameras xZ_point // xZ_dir //; exact: pins_seen js. Qed.

Lemma xZ_change v n w : (n < size (kinds s))%N -> change s xZ v n w =
  image_change (cams w) (twist_of v w) (at_place n) (motion_of s v n) (looks (ft (nth 0%N (kinds s) n)) w).
Proof.
move=> nl; rewrite /change xZ_cameras /image_change xZ_point //; congr (_ ++ flatten _).
apply/eq_in_map => j js; have jp := pins_seen js.
by rewrite /d_line /line xZ_point // xZ_dir.
Qed.

(** Rigid there: the matrix has determinant nonzero. *)
Lemma square : sumn [seq dim2 (ft i) | i <- kinds s] = unknowns_count s.
Proof.
have tot h : sumn [seq h i | i <- kinds s] = total s h.
  rewrite /kinds map_flatten sumn_flatten -map_comp /total -map_comp; congr sumn; apply: eq_map => i /=.
  by rewrite map_nseq sumn_nseq mulnC.
have /andP[_ /eqP b] := bs.
rewrite tot /unknowns_count tot -b -total_add; apply: total_eq => i i27.
exact: dim2E.
Qed.

Lemma xZ_det : ~~ obstructed s -> \det (system s xZ) != 0.
Proof.
move=> us; apply/(det_kernel square) => v /all_changes ch.
have [||T0 m0] := @scene_rigid normal_point normal_checked s bs us (twist_of v) (motion_of s v); first by [].
  rewrite Regular.size_scene -size_kinds => n nl p; have e : p = at_place n
    by rewrite /p scene_nth -?size_kinds.
  rewrite e kind_instance kind_place //; split=> [|w].
    by have := @free_motion_gauge ZR (at_place n) (part s v n); rewrite kind_instance kind_place.
  by rewrite -xZ_change //; exact: ch.
apply: zero_motion T0 _ => n nl; have nl' : (n < size (scene_of s))%N
  by rewrite Regular.size_scene -size_kinds.
have [X0 D0] := m0 n nl'; split=> // j jp; apply: D0.
by rewrite scene_nth -?size_kinds // kind_instance kind_place.
Qed.
End Point.
