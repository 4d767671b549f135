(** * Two views that share more than five points: not rigid, at every admissible configuration *)
From Coq Require List.
From mathcomp Require Import all_ssreflect all_algebra.
From mathcomp.zify Require Import zify.
From mathcomp.algebra_tactics Require Import ring.
From PL1P Require Import Statement Rigid Walk System Blocks Epipolar.
Set Implicit Arguments.
Unset Strict Implicit.
Unset Printing Implicit Defensive.
Import GRing.Theory.
Local Open Scope ring_scope.

Lemma total_add s (g h : nat -> nat) : total s (fun i => g i + h i)%N = (total s g + total s h)%N.
Proof. by rewrite /total; elim: (iota 0 27) => //= i l ->; rewrite mulnDr addnACA. Qed.
Lemma total_eq s (g h : nat -> nat) : (forall i, (i < 27)%N -> g i = h i) -> total s g = total s h.
Proof. by move=> e; rewrite /total; congr sumn; apply/eq_in_map => i; rewrite mem_iota => i27; rewrite e. Qed.

Lemma dim2E i : (i < 27)%N -> dim2 (ft i) = (weight i + dim3 (ft i))%N.
Proof.
move=> i27; have h : all (fun i => dim2 (ft i) == weight i + dim3 (ft i))%N (iota 0 27) by vm_compute.
by apply/eqP; apply: (allP h); rewrite mem_iota.
Qed.

Section NotRigid.
Variable R : idomainType.
Notation Vec := (@Vec R).
Notation Forall := List.Forall.
Implicit Types (z y : nat -> R) (s : signature).
Variables (C : view -> camera R) (scene : seq (placed R)) (s : signature).
Hypothesis sh : shape scene s.
Hypothesis ad : admissible C scene.

Notation place n := (nth (p0 R) scene n).

Lemma point_seen p n v : (n < size scene)%N -> p = place n -> sees_point (ft (kind p)) v ->
  x3 (project (C v) (point p)) <> 0.
Proof. by case: ad => _ _ _ _ /(_ n) h nl ->; case: (h nl) => h1 _ _; exact: h1. Qed.

(** ** More unknowns than equations: a motion *)
Lemma not_rigid n0 (globals : seq ((nat -> R) -> R)) (own : placed R -> nat)
    (forms : placed R -> seq ((nat -> R) -> (nat -> R) -> R)) (T : (nat -> R) -> view -> twist R)
    (m : placed R -> (nat -> R) -> (nat -> R) -> motion R) :
  Forall (lin n0) globals -> (forall p, Forall (lin2 n0 (own p)) (forms p)) ->
  (size globals + sumn [seq size (forms p) | p <- scene] < n0 + sumn [seq own p | p <- scene])%N ->
  (forall z, Forall (fun g => g z = 0) globals -> gauge (T z)) ->
  (forall z, Forall (fun g => g z = 0) globals -> forall n, (n < size scene)%N -> forall y,
     Forall (fun f => f z y = 0) (forms (place n)) ->
     feature_gauge (place n) (m (place n) z y) /\
     forall v, still T (m (place n)) C (place n) z y v) ->
  (forall z, Forall (fun g => g z = 0) globals -> (forall v, T z v = Twist (vec0 R) (vec0 R)) ->
     (forall n, (n < size scene)%N -> exists y, dX (m (place n) z y) = vec0 R) -> forall i, (i < n0)%N ->
       z i = 0) ->
  (forall z, (forall i, (i < n0)%N -> z i = 0) -> forall n, (n < size scene)%N ->
    forall y, dX (m (place n) z y) = vec0 R ->
     (forall j, (j < pins (ft (kind (place n))))%N -> dD (m (place n) z y) j = vec0 R) ->
     forall j, (j < own (place n))%N -> y j = 0) ->
  ~ rigid C scene.
Proof.
move=> gl fl lt hT hm hz hy rg.
have [z [ys [nz zg zf]]] := @assembled R _ n0 globals own forms gl fl (p0 R) scene lt.
have [|n nl|T0 m0] := rg (T z) (fun n => m (place n) z (ys n)).
- exact: hT.
- exact: hm (zf n nl).
have z0 : forall i, (i < n0)%N -> z i = 0.
  by apply: hz => // n nl; exists (ys n); case: (m0 n nl).
case: nz => [[i il]|[n [j [nl jl]]]]; first by rewrite z0 ?eqxx.
have [d1 d2] := m0 n nl.
by rewrite (hy z z0 n nl (ys n) d1 d2) ?eqxx.
Qed.

Lemma globals_zero i j z : Forall (fun g => g z = 0) (globals C i j) ->
  rotation_kept C i j z = vec0 R /\ baseline_kept C i j z = vec0 R.
Proof.
move=> /List.Forall_cons_iff[h1
  /List.Forall_cons_iff[h2 /List.Forall_cons_iff[h3
    /List.Forall_cons_iff[h4 /List.Forall_cons_iff[h5 /List.Forall_cons_iff[h6 _]]]]]].
by split; apply: vec_ext.
Qed.

(** ** Two views that share more than five points *)
Lemma crowded_pair i j : i <> j -> balanced s -> (5 < shared s i j)%N -> ~ rigid C scene.
Proof.
move=> ij /andP[_ /eqP b] m5.
case: ad => [_ norms _ centres _].
have cij := centres i j ij.
apply: (@not_rigid 12 (globals C i j) (@own R) (forms C i j) (@twists R) (@moved R)).
- exact: globals_lin.
- by move=> p; exact: forms_lin.
- have total_forms : (sumn [seq size (forms C i j p) | p <- scene] + shared s i j =
    11 + sumn [seq own p | p <- scene])%N.
    rewrite /shared -(sumn_scene (fun k => both i j k) sh) -b -(sumn_scene weight sh).
    case: sh => k27 _; elim: scene k27 => // p l IH /andP[p27 /IH {}IH].
    by rewrite !map_cons [LHS]/= addnACA size_forms dim2E // IH /own /= addnACA.
  rewrite [size _]/=; move: total_forms m5.
  by move: (sumn _) (sumn _) (shared _ _ _) => a1 a2 a3; lia.
- by [].
- move=> z zg n nl y h; have [r0 b0] := globals_zero zg.
  split; first exact: free_motion_gauge.
  move: h; rewrite /forms => /Forall_cat[h1 /Forall_cat[h2 h3]].
  have hv v : Forall (fun f => f z y = 0) (view_forms C i j (place n) v) by case: v.
  have other v : (same_view v j && both i j (kind (place n))) = false ->
    still (@twists R) (@moved R (place n)) C (place n) z y v.
    by move=> e; apply: image_forms_still; move: (hv v); rewrite /view_forms e.
  move=> v; case e: (same_view v j && both i j (kind (place n))); last exact: other.
  move/andP: e => [/same_viewP -> bo]; have /andP[si sj] := bo.
  have ii : still (@twists R) (@moved R (place n)) C (place n) z y i.
    by apply: other; case: same_viewP.
  move: (hv j); rewrite /view_forms bo (introT (same_viewP j j) erefl) => /List.Forall_cons_iff[hc hp].
  apply: still_cat => // _.
  move: ii; rewrite /still /image_change -/(sees_point _ _) si => /andP[/eqP i1 /andP[/eqP i2 _]].
  have [//|c1 c2] := @epipolar R C i j norms z (point (place n)) (dX (moved (place n) z y)) r0 b0 _ i1 i2 hc.
    exact: (point_seen nl erefl si).
  by constructor; [exact: c1 | constructor; [exact: c2 | constructor]].
- move=> z zg T0 _; have [r0 b0] := globals_zero zg.
  have [e2 e3] := (T0 V2, T0 V3); move: e2 e3 => /= [z0 z1 z2 z3 z4] [z5 z6 z7 z8 z9 z10].
  have dt0 v : dt (twists z v) = vec0 R by rewrite T0.
  move: b0; rewrite /baseline_kept !dt0 => b0.
  have m0 : z 11%N = 0.
    apply/eqP/negP => /negP m0; apply: (@baseline_nonzero R C i j cij).
    apply: (@scale_inj _ (z 11%N)); first exact/eqP.
    rewrite scale_zero; have := add_zero3 b0; rewrite !scale_zero A_zero => ->; by apply: vec_ext;
      rewrite /= add0r.
  by do 12?[case=> [|] //].
- move=> z _ n nl y d1 d2 k kl; exact: free_motion_zero d1 d2 k kl.
Qed.
End NotRigid.
