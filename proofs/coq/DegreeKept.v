(** * The camera-degree when one more view sees a dangling pin

    Let a view that sees the point of a dangling pin see the pin too: the camera-degree stays as it
    was ([reveal_camera_degree]). So the degree of a minimal problem does not depend on which of two
    views sees the pin: Corollary 1 of the paper, with degrees ([swap_degree]). For let L = F(y), E
    the field of y and the cameras, and s the new coordinate. A derivation kills E and moves s, so s
    is transcendental over E, and E(s) over L(s) is as large as E over L.

    Also: a problem has at most one degree ([dimension_unique]), and a minimal problem has one
    ([degree_exists]: the proof does not find it, it refutes that there is none). *)
From mathcomp Require Import all_ssreflect all_algebra.
From SsrMultinomials Require Import mpoly.
From PL1P Require Import Statement Reducible Problems Reductions Derivations RationalFunctions.
From PL1P Require Import Independence Generic Reduction CameraMinimal Replacements Dangling Degree.
From PL1P Require Import Lemma1 Subfields.
Set Implicit Arguments.
Unset Strict Implicit.
Unset Printing Implicit Defensive.
Import GRing.Theory.
Local Open Scope ring_scope.

Lemma killed_subfield (F K : fieldType) (c : {rmorphism F -> K}) D : derivation c D ->
  subfield (fun u => D u = 0).
Proof.
move=> hD; split; first split.
- exact: (der1 hD).
- by move=> u w hu hw; rewrite (derB hD) hu hw subr0.
- by move=> u w hu hw; rewrite (derM hD) hu hw mul0r mulr0 addr0.
move=> u hu; have [->|u0] := eqVneq u 0; first by rewrite invr0 (der0 hD).
have := derM hD u u^-1; rewrite divff // (der1 hD) hu mul0r add0r => /esym/eqP.
by rewrite mulf_eq0 (negbTE u0) => /eqP.
Qed.

(** ** The field F(y) *)
Section Rational.
Variables (F : fieldType) (n : nat).
Notation K := [fieldType of {fraction {mpoly F[n]}}].
Notation c := (const (to F n)).
Implicit Types (y z : seq K) (S : K -> Prop) (u s : K).
Lemma rational_subfield y : subfield (rational y).
Proof.
split; last by move=> u; exact: (frV (ev := ev_of y)).
split; first exact: (fr1 (ev_of y)).
  by move=> u w; exact: (frB (ev := ev_of y)).
by move=> u w; exact: (frM (ev := ev_of y)).
Qed.
Lemma rational_value y p : rational y (at_y y p). Proof. exact: (fr_of (ev_of y)). Qed.
Lemma rational_const y a : rational y (c a).
Proof. by have := fr_of (ev_of y) a%:MP; rewrite [ev_of y _]mmapC. Qed.
Lemma rational_mem y u : u \in y -> rational y u. Proof. exact: fr_mem. Qed.
Lemma value_sub z S : subring S -> (forall a, S (c a)) -> (forall a, a \in z -> S a) ->
  forall p, S (at_y z p).
Proof.
move=> hS Sc Sz p; rewrite -[at_y z p]/(ev_of z p) (mpolyE p) rmorph_sum; apply: sr_sum => // M _.
rewrite -mul_mpolyC rmorphM; apply: srM => //; first by rewrite [ev_of z _]mmapC; exact: Sc.
rewrite mpolyXE_id rmorph_prod; apply: sr_prod => // i _; rewrite rmorphX; apply: srX => //.
by rewrite [ev_of z _]mmapX mmap1U; apply: Sz; exact: mem_nth.
Qed.
Lemma rational_sub z S : subfield S -> (forall a, S (c a)) -> (forall a, a \in z -> S a) ->
  forall u, rational z u -> S u.
Proof.
move=> [hS iS] Sc Sz u [p [q [q0 e]]]; rewrite -[u](mulfK q0) e.
by apply: (srM hS); [|apply: iS]; exact: value_sub.
Qed.
Lemma rational_quotient y z s : (forall a, a \in z -> rational y a \/ a = s) ->
  forall u, rational z u -> quotient (rational y) s u.
Proof.
move=> hz u [p [q [q0 e]]]; have rL := (rational_subfield y).1; have rP := over_ring rL.
pose S w := exists P, over (rational y) P /\ w = P.[s].
have hS : subring S.
  split=> [|_ _ [P [hP ->]] [Q [hQ ->]]|_ _ [P [hP ->]] [Q [hQ ->]]].
  - by exists 1; split; [exact: sr1 | rewrite hornerC].
  - by exists (P - Q); split; [exact: (srB rP) | rewrite !hornerE].
  - by exists (P * Q); split; [exact: (srM rP) | rewrite hornerM].
have C a : rational y a -> S a by exists a%:P; split; [exact: overC | rewrite hornerC].
have val r : S (at_y z r).
  apply: value_sub => // [a|a /hz[|->]]; first exact/C/rational_const; first exact: C.
  by exists 'X; split; [exact: (overX rL) | rewrite hornerX].
have [P [hP eP]] := val p; have [Q [hQ eQ]] := val q.
by exists P, Q; split=> //; rewrite -?eP -?eQ.
Qed.
Theorem dimension_unique y (E : K -> Prop) d d' : dimension y E d -> dimension y E d' -> d = d'.
Proof. exact: basis_unique (rational_subfield y).1. Qed.
Lemma determined_root y u : determined y u -> root_over (rational y) u.
Proof.
case=> p p0 rt; exists (map_poly (at_y y) p); split=> // i.
by rewrite coef_map_id0; [exact: rational_value | exact: (rmorph0 (ev_of y))].
Qed.
End Rational.

(** ** A minimal problem has a degree, a camera-minimal one a camera-degree *)
Theorem degree_exists (F : fieldType) A : minimal F A -> ~ ~ exists2 d, (0 < d)%N & degree F A d.
Proof.
case=> _ fin; have hL := rational_subfield (images F (parameters A) A).
have hE : subfield (fun _ : [fieldType of {fraction {mpoly F[parameters A]}}] => True) by [].
apply: (@basis_exists _ _ _ hL hE _ (mkseq (generic F _) (parameters A))) =>
  // [z _|S hS LS Sz u _].
  by split=> //; apply: determined_root; exact: fin.
apply: (rational_sub hS _ Sz) => [a|]; first exact/LS/rational_const.
by apply: fr_all => k kn; apply: fr_mem; apply/map_f; rewrite mem_iota.
Qed.
Theorem camera_degree_exists (F : fieldType) A : camera_minimal F A ->
  ~ ~ exists2 d, (0 < d)%N & camera_degree F A d.
Proof.
case=> _ fin; have hL := rational_subfield (images F (parameters A) A).
have hE := rational_subfield (with_cameras F (parameters A) A).
have LE u : rational (images F (parameters A) A) u -> rational (with_cameras F (parameters A) A) u.
  apply: (rational_sub hE) => [a|a ay]; first exact: rational_const.
  by apply: rational_mem; rewrite mem_cat ay.
apply: (@basis_exists _ _ _ hL hE LE (mkseq (generic F _) 11)).
  move=> z zz; split; first by apply: rational_mem; rewrite mem_cat zz orbT.
  by case/mapP: zz => k; rewrite mem_iota => /= k11 ->; apply: determined_root; exact: fin.
move=> S hS LS Sz; apply: (rational_sub hS) => [a|a]; first exact/LS/rational_const.
by rewrite mem_cat => /orP[ay|/Sz //]; apply: LS; exact: rational_mem.
Qed.

(** ** The camera-degree, when one more view sees a dangling pin *)
Section Step.
Variables (F : fieldType) (pre post : problem) (f : feature) (j : nat) (u v : view).
Hypothesis char0 : [char F] =i pred0.
Notation A := (pre ++ f :: post).
Notation A' := (pre ++ reveal f j v :: post).
Hypothesis pA : is_problem A.
Hypothesis hj : dangles f j u v.
Notation n := (parameters A).
Theorem reveal_camera_degree d : camera_degree F A d <-> camera_degree F A' d.
Proof.
have [D [hD sD uD vD kD]] := turning_derivation char0 pA hj.
rewrite /camera_degree /with_cameras (reveal_parameters pre post f j v).
have p := reveal_images F pre post hj; set w := slope _ _ _ _ _ _ in vD p.
have zD k : (k < 11)%N -> D (generic F n k) = 0 by exact: (spared_first (leq_addr _ _) sD).
set y := images F n A in kD p *; set y' := images F n A' in p *; set cams := mkseq _ _.
have yy' a : (a \in y') = (a == w) || (a \in y) by rewrite -(perm_mem p) mem_rcons inE.
have sub z t : {subset z <= t} -> forall u, rational z u -> rational t u.
  move=> zt; apply: (rational_sub (rational_subfield t)) => [a|a /zt]; first exact: rational_const.
  exact: rational_mem.
have LM a : rational y a -> rational y' a by apply: sub => b; rewrite yy' orbC => ->.
have LE a : rational y a -> rational (y ++ cams) a by apply: sub => b; rewrite mem_cat => ->.
have ME' a : rational y' a -> rational (y' ++ cams) a by apply: sub => b; rewrite mem_cat => ->.
have EE' a : rational (y ++ cams) a -> rational (y' ++ cams) a.
  by apply: sub => b; rewrite !mem_cat yy' => /orP[]->; rewrite !orbT.
have Mw : rational y' w by apply: rational_mem; rewrite yy' eqxx.
have fM : forall a, rational y' a -> quotient (rational y) w a.
  apply: rational_quotient => a; rewrite yy' => /predU1P[|ay]; first by right.
  by left; exact: rational_mem.
have fE : forall a, rational (y' ++ cams) a -> quotient (rational (y ++ cams)) w a.
  apply: rational_quotient => a; rewrite mem_cat yy' -orbA => /predU1P[|ay]; first by right.
  by left; apply: rational_mem; rewrite mem_cat.
have DE : forall a, rational (y ++ cams) a -> D a = 0.
  apply: (rational_sub (killed_subfield hD)) => a; first exact: (derC hD).
  rewrite mem_cat => /orP[ay|/mapP[k]]; first by apply/eqP; exact: (allP kD).
  by rewrite mem_iota => /= k11 ->; exact: zD.
have hL := rational_subfield y; have hM := rational_subfield y'.
have hE := rational_subfield (y ++ cams); have hE' := rational_subfield (y' ++ cams).
have tr := moved_root char0 hD (hE.1) DE vD.
split; first exact: (basis_up hL hM hE LE LM EE' Mw fM fE tr).
exact: (basis_down hL hM hE hE' LE LM EE' ME' Mw fM fE tr).
Qed.
End Step.

(** ** Which of two views sees the pin *)
Theorem swap_camera_degree (F : fieldType) A f B j u v w : [char F] =i pred0 ->
  is_problem (A ++ f :: B) -> dangles f j u v -> dangles f j u w -> forall d,
  camera_degree F (A ++ reveal f j v :: B) d <-> camera_degree F (A ++ reveal f j w :: B) d.
Proof.
move=> char0 pA dv dw d; have := reveal_camera_degree char0 pA dv d.
by have := reveal_camera_degree char0 pA dw d; tauto.
Qed.
Theorem swap_degree (F : fieldType) A f B j u v w : [char F] =i pred0 ->
  is_problem (A ++ f :: B) -> dangles f j u v -> dangles f j u w ->
  minimal F (A ++ reveal f j v :: B) -> forall d,
  degree F (A ++ reveal f j v :: B) d <-> degree F (A ++ reveal f j w :: B) d.
Proof.
move=> char0 pA dv dw mv d; have [_ swap] := replacements_theorem char0 j u pA.
have mw := (swap v w dv dw).1 mv.
have pr t : dangles f j u t -> is_problem (A ++ reveal f j t :: B).
  move=> dt; move: pA; rewrite /is_problem !all_cat => /and3P[p1 pf p3].
  by apply/and3P; split=> //; exact: reveal_proper pf dt.
have [_ ev] := lemma1_theorem char0 (pr v dv) mv; have [_ ew] := lemma1_theorem char0 (pr w dw) mw.
by have := swap_camera_degree char0 pA dv dw d; have := ev d; have := ew d; tauto.
Qed.

Theorem degrees_theorem : degrees.
Proof.
move=> F char0; split=> [|A f B j u pA].
  split=> [A d d'|A d d'|A|A]; [exact: dimension_unique | exact: dimension_unique | |].
    exact: degree_exists.
  exact: camera_degree_exists.
split=> [v d dv|v w d dv dw mv]; first exact: (reveal_camera_degree char0 pA dv).
exact: (swap_degree char0 pA dv dw mv).
Qed.
