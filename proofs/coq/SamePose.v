(** * Poses with the same essential matrix

    If two cameras have the same E up to a factor, they have the same t, and their rotations are the
    same or differ by a half turn about t, all up to factors ([same_essential]). *)
From mathcomp Require Import all_ssreflect all_algebra.
From mathcomp.algebra_tactics Require Import ring.
From PL1P Require Import Statement Rigid Epipolar Template Pose.
Set Implicit Arguments.
Unset Strict Implicit.
Unset Printing Implicit Defensive.
Import GRing.Theory.
Local Open Scope ring_scope.

Section Same.
Variable L : fieldType.
Hypothesis two : 2%:R != 0 :> L.
Implicit Types (q p : quat L) (t u w X : vec L).
Notation Vec := (@Vec L).
Notation Quat := (@Quat L).

(** ** y . E x *)
Lemma essential_dot t q u w : dot (cross t (rot q u)) w =
  \sum_(e < 9) essential t q e * (entry w (e %/ 3)%N * entry u (e %% 3)%N).
Proof.
case: q => a b c d; case: t => t1 t2 t3; case: u => u1 u2 u3; case: w => w1 w2 w3.
by rewrite !big_ord_recl big_ord0 /essential /entry /unit_vec /cross /rot /dot /=; ring.
Qed.
Lemma epipolar_sum C X x y : x3 X != 0 -> x1 X / x3 X = x1 x -> x2 X / x3 X = x2 x -> x3 x = 1 ->
  x3 (project C X) != 0 -> x1 (project C X) / x3 (project C X) = x1 y -> x2 (project C X) / x3 (project C X) =
    x2 y -> x3 y = 1 ->
  dot (cross (trans C) (turn C x)) y = 0.
Proof.
move=> X3 e1 e2 e3 Y3; set Y := project C X in Y3 *; move=> f1 f2 f3.
have eX : X = scale (x3 X) x.
  by rewrite /scale -e1 -e2 e3 mulr1 !(mulrC (x3 X)) !divfK //; case: (X).
have eY : Y = scale (x3 Y) y.
  by rewrite /scale -f1 -f2 f3 mulr1 !(mulrC (x3 Y)) !divfK //; case: (Y).
have : x3 X * x3 Y * dot (cross (trans C) (turn C x)) y = dot (cross (trans C) (turn C X)) Y.
  rewrite [in RHS]eY {2}eX; case: (C) => -[a b c d] [t1 t2 t3]; case: (x) => u1 u2 u3; case: (y) => w1 w2 w3.
  by move: (x3 X) (x3 Y) => m n; rewrite /dot /cross /turn /rot /scale /dot /=; ring.
have -> : dot (cross (trans C) (turn C X)) Y = 0.
  by rewrite /Y /project; case: (turn C X) => r1 r2 r3; case: (trans C) => t1 t2 t3;
    rewrite /dot /cross /add /=; ring.
by move/eqP; rewrite !mulf_eq0 (negbTE X3) (negbTE Y3) => /eqP.
Qed.

(** ** R is invertible *)
Lemma conj_rot q u : rot q (rot (conj q) u) = scale (norm q ^+ 2) u.
Proof. by case: q => a b c d; apply: vec_ext; rewrite /norm /rot /scale /conj /dot /=; ring. Qed.

Lemma same_entries t q t' q' k u : (forall e, (e < 9)%N -> essential t' q' e = k * essential t q e) ->
  cross t' (rot q' u) = scale k (cross t (rot q u)).
Proof.
move=> h; have d a (a3 : (a < 3)%N) : dot (cross t' (rot q' u)) (unit_vec L a) =
  k * dot (cross t (rot q u)) (unit_vec L a).
  by rewrite !essential_dot mulr_sumr; apply: eq_bigr => e _; rewrite (h e (ltn_ord e)) -mulrA.
have := d 0%N isT; have := d 1%N isT; have := d 2%N isT.
move: (cross t' _) (cross t _) => [a1 a2 a3] [b1 b2 b3]; rewrite /dot /unit_vec /scale /= => h2 h1 h0.
by congr Vec; [move: h0 | move: h1 | move: h2]; rewrite ?(mulr0, mulr1, addr0, add0r).
Qed.
Lemma essential_nonzero t q : norm q != 0 -> (forall e, (e < 9)%N -> essential t q e = 0) -> t = vec0 L.
Proof.
move=> n0 z; have c w : cross t w = vec0 L.
  have := @same_entries t q t q 0 (rot (conj q) w); rewrite conj_rot => h.
  apply: (@scale_inj _ (norm q ^+ 2)); first by apply/eqP; rewrite expf_neq0.
  rewrite scale_zero; apply: etrans (_ : cross t (scale (norm q ^+ 2) w) = _).
    by rewrite /scale /cross /=; congr Vec; ring.
  by rewrite h => [|e e9]; rewrite /scale ?mul0r // !z.
have z1 w : x1 (cross t w) = 0 by rewrite c.
have z3 w : x3 (cross t w) = 0 by rewrite c.
have := z3 (Vec 0 1 0); have := z3 (Vec 1 0 0); have := z1 (Vec 0 1 0);
  rewrite /= !(mulr0, mulr1, subr0, sub0r) => e3 e2 e1.
by apply: vec_ext => //; apply/eqP; rewrite -oppr_eq0 ?e2 ?e3.
Qed.

(** ** Poses with the same E *)
Definition times p q := Quat (qa p * qa q - qb p * qb q - qc p * qc q - qd p * qd q)
  (qa p * qb q + qb p * qa q + qc p * qd q - qd p * qc q)
    (qa p * qc q - qb p * qd q + qc p * qa q + qd p * qb q)
  (qa p * qd q + qb p * qc q - qc p * qb q + qd p * qa q).
Lemma rot_times p q u : rot (times p q) u = rot p (rot q u).
Proof. by case: p => a b c d; case: q => a' b' c' d'; apply: vec_ext; rewrite /rot /dot /times /=; ring. Qed.
Lemma norm_times p q : norm (times p q) = norm p * norm q.
Proof. by rewrite /norm /times /=; ring. Qed.

(** Parallel vectors. *)
Lemma cross_zero t w : t <> vec0 L -> cross t w = vec0 L -> exists l, w = scale l t.
Proof.
case: t => t1 t2 t3; case: w => w1 w2 w3 t0; rewrite /cross /vec0 /= => -[e1 e2 e3].
have sub (x y : L) : x - y = 0 -> x = y by move/eqP; rewrite subr_eq0 => /eqP.
have {}e1 := sub _ _ e1; have {}e2 := sub _ _ e2; have {}e3 := sub _ _ e3.
have [z1|n1] := eqVneq t1 0; last first.
  by exists (w1 / t1); rewrite /scale /=; congr Vec; apply: (mulfI n1);
    rewrite mulrA (mulrC t1 (_ / _)) divfK // ?e3 -?e2 mulrC.
have [z2|n2] := eqVneq t2 0; last first.
  by exists (w2 / t2); rewrite /scale /=; congr Vec; apply: (mulfI n2);
    rewrite mulrA (mulrC t2 (_ / _)) divfK // ?e1 -?e3 mulrC.
have [z3|n3] := eqVneq t3 0; first by case: t0; rewrite z1 z2 z3.
by exists (w3 / t3); rewrite /scale /=; congr Vec; apply: (mulfI n3);
  rewrite mulrA (mulrC t3 (_ / _)) divfK // ?e2 -?e1 mulrC.
Qed.
(** [t] rot p = k [t]: then p is 1, or p is t, up to a factor. *)
Lemma same_twist t p k : t <> vec0 L -> norm p != 0 -> (forall w, cross t (rot p w) = scale k (cross t w)) ->
  [/\ qb p = 0, qc p = 0 & qd p = 0] \/
  exists l, p = Quat 0 (l * x1 t) (l * x2 t) (l * x3 t).
Proof.
case: p => a b c d; case: t => t1 t2 t3; rewrite /norm /= => t0 n0 h.
have sub (x y : L) : x = y -> x - y = 0 by move=> ->; exact: subrr.
have e1 w := sub _ _ (congr1 (@x1 L) (h w)); have e2 w := sub _ _ (congr1 (@x2 L) (h w)); have e3 w :=
  sub _ _ (congr1 (@x3 L) (h w)).
move: (e1 (Vec 1 0 0)) (e2 (Vec 1 0 0)) (e3 (Vec 1 0 0)) (e1 (Vec 0 1 0)) (e2 (Vec 0 1 0)) (e3 (Vec 0 1 0))
  (e1 (Vec 0 0 1)) (e2 (Vec 0 0 1)) (e3 (Vec 0 0 1)).
clear e1 e2 e3 h; rewrite /cross /rot /scale /dot /= => e11 e12 e13 e21 e22 e23 e31 e32 e33.
(* with P = (b, c, d) and V = t x P + a t: V_i P_j + V_j P_i = 0 *)
pose v1 := t2 * d - t3 * c + a * t1; pose v2 := t3 * b - t1 * d + a * t2.
pose v3 := t1 * c - t2 * b + a * t3.
have half (x : L) : x *+ 2 = 0 -> x = 0 by move/eqP; rewrite -mulr_natr mulf_eq0 (negbTE two) orbF => /eqP.
have comb (x y z w : L) : x = 0 -> y = 0 -> z = 0 -> w *+ 2 = x + y + z -> w = 0.
  by move=> -> -> -> h; apply: half; rewrite h !addr0.
have at0 : a * (t1 * b + t2 * c + t3 * d) = 0.
  by apply: oppr_inj; rewrite oppr0; apply: half; apply: (comb _ _ _ _ e11 e22 e33); ring.
have tw : (a * (t1 * b + t2 * c + t3 * d)) *+ 2 = 0 by rewrite at0 mul0rn.
have z0 : 0 = 0 :> L by [].
have v11 : v1 * b = 0 by apply: (comb _ _ _ _ e11 tw z0); rewrite /v1; ring.
have v22 : v2 * c = 0 by apply: (comb _ _ _ _ e22 tw z0); rewrite /v2; ring.
have v33 : v3 * d = 0 by apply: (comb _ _ _ _ e33 tw z0); rewrite /v3; ring.
have v12 : v1 * c + v2 * b = 0 by apply: (comb _ _ _ _ e12 e21 z0); rewrite /v1 /v2; ring.
have v13 : v1 * d + v3 * b = 0 by apply: (comb _ _ _ _ e13 e31 z0); rewrite /v1 /v3; ring.
have v23 : v2 * d + v3 * c = 0 by apply: (comb _ _ _ _ e23 e32 z0); rewrite /v2 /v3; ring.
clear e11 e12 e13 e21 e22 e23 e31 e32 e33 tw.
have [/and3P[/eqP b0 /eqP c0 /eqP d0]|nz] := boolP [&& b == 0, c == 0 & d == 0]; [by left | right].
have prod (x y z w : L) : x * y = 0 -> z * w = 0 -> x * w + z * y = 0 -> x * w = 0.
  move=> xy zw s; apply/eqP; rewrite -[_ == 0]orbb -mulf_eq0; apply/eqP.
  transitivity (x * w * (x * w + z * y) - (x * y) * (z * w)); first ring.
  by rewrite xy s mulr0 mul0r subr0.
have p12 := prod _ _ _ _ v11 v22 v12; have p13 := prod _ _ _ _ v11 v33 v13; have p23 :=
  prod _ _ _ _ v22 v33 v23.
have p21 : v2 * b = 0 by move: v12; rewrite p12 add0r.
have p31 : v3 * b = 0 by move: v13; rewrite p13 add0r.
have p32 : v3 * c = 0 by move: v23; rewrite p23 add0r.
have zero v : v * b = 0 -> v * c = 0 -> v * d = 0 -> v = 0.
  move=> /eqP hb /eqP hc /eqP hd; apply/eqP; apply: contraNT nz => v0.
  by move: hb hc hd; rewrite !mulf_eq0 (negbTE v0) /= => -> -> ->.
have V1 := zero _ v11 p12 p13; have V2 := zero _ p21 v22 p23; have V3 := zero _ p31 p32 v33.
(* t (norm p) = P x V + a V + (P . t) P *)
have at1 (ti : L) : a * ti * (a ^+ 2 + b ^+ 2 + c ^+ 2 + d ^+ 2) = 0 -> a = 0 \/ ti = 0.
  by move/eqP; rewrite !mulf_eq0 (negbTE n0) orbF => /orP[/eqP|/eqP]; [left | right].
have a0 : a = 0.
  have [|//|z1] := at1 t1.
    transitivity (a * (c * v3 - d * v2 + a * v1) + a * (t1 * b + t2 * c + t3 * d) * b);
      last by rewrite V1 V2 V3 at0 !(mulr0, mul0r, subr0, addr0).
    by rewrite /v1 /v2 /v3; ring.
  have [|//|z2] := at1 t2.
    transitivity (a * (d * v1 - b * v3 + a * v2) + a * (t1 * b + t2 * c + t3 * d) * c);
      last by rewrite V1 V2 V3 at0 !(mulr0, mul0r, subr0, addr0).
    by rewrite /v1 /v2 /v3; ring.
  have [|//|z3] := at1 t3.
    transitivity (a * (b * v2 - c * v1 + a * v3) + a * (t1 * b + t2 * c + t3 * d) * d);
      last by rewrite V1 V2 V3 at0 !(mulr0, mul0r, subr0, addr0).
    by rewrite /v1 /v2 /v3; ring.
  by case: t0; rewrite z1 z2 z3.
have [|l [-> -> ->]] := @cross_zero (Vec t1 t2 t3) (Vec b c d) t0; last by exists l; rewrite a0.
rewrite /cross /vec0 /=; congr Vec.
- by rewrite -[RHS]V1 /v1 a0 mul0r addr0.
- by rewrite -[RHS]V2 /v2 a0 mul0r addr0.
- by rewrite -[RHS]V3 /v3 a0 mul0r addr0.
Qed.

Lemma quat_ext q q' : qa q = qa q' -> qb q = qb q' -> qc q = qc q' -> qd q = qd q' -> q = q'.
Proof. by case: q => ? ? ? ?; case: q' => ? ? ? ? /= -> -> -> ->. Qed.
Lemma times_back p q : let r := times (times p (Rigid.conj q)) q in
  [/\ qa r = norm q * qa p, qb r = norm q * qb p, qc r = norm q * qc p & qd r = norm q * qd p].
Proof. by case: p => a b c d; case: q => a' b' c' d'; rewrite /times /norm /=; split; ring. Qed.
Definition factor b q := Quat (b * qa q) (b * qb q) (b * qc q) (b * qd q).
(** The rotation q, and then a half turn about t. *)
Definition turned t q := times (Quat 0 (x1 t) (x2 t) (x3 t)) q.

Lemma same_essential t q t' q' k : t <> vec0 L -> t' <> vec0 L -> norm q != 0 -> norm q' != 0 -> k != 0 ->
  (forall e, (e < 9)%N -> essential t' q' e = k * essential t q e) ->
  (exists2 m, m != 0 & t' = scale m t) /\
  exists2 b, b != 0 & q' = factor b q \/ q' = factor b (turned t q).
Proof.
move=> t0 t0' n0 n0' k0 h.
have c w : cross t' (rot q' (rot (Rigid.conj q) w)) = scale (k * norm q ^+ 2) (cross t w).
  rewrite (same_entries _ h) conj_rot; apply: vec_ext; rewrite /cross /scale /=; ring.
have K0 : k * norm q ^+ 2 != 0 by rewrite mulf_neq0 // expf_neq0.
have d w : dot t' (cross t w) = 0.
  apply: (mulfI K0); rewrite mulr0; transitivity (dot t' (cross t' (rot q' (rot (Rigid.conj q) w)))).
    by rewrite c /dot /scale /=; ring.
  by rewrite /dot /cross /=; ring.
have [|m et] := @cross_zero t t' t0.
  rewrite /vec0 /cross; congr Vec.
  - by rewrite -[RHS](d (Vec (-1) 0 0)) /dot /cross /=; ring.
  - by rewrite -[RHS](d (Vec 0 (-1) 0)) /dot /cross /=; ring.
  - by rewrite -[RHS](d (Vec 0 0 (-1))) /dot /cross /=; ring.
have m0 : m != 0.
  by apply/eqP => z; apply: t0'; rewrite et z /scale /vec0 !mul0r.
split; first by exists m.
have cp w : cross t (rot (times q' (Rigid.conj q)) w) = scale (k * norm q ^+ 2 / m) (cross t w).
  apply: (@scale_inj _ m); first exact/eqP.
  transitivity (cross t' (rot (times q' (Rigid.conj q)) w)).
    by rewrite et /scale /cross /=; congr Vec; ring.
  by rewrite rot_times c /scale /=; congr Vec; rewrite mulrA [m * _]mulrC divfK.
have nonzero b (w : quat L) : q' = factor b w -> b != 0.
  move=> e; apply: contraNneq n0' => z; rewrite e z /norm /factor /= !mul0r.
  by rewrite expr0n /= !addr0.
have div x y b : norm q * x = b * y -> x = b / norm q * y.
  by move=> e; apply: (mulfI n0); rewrite e mulrA [norm q * _]mulrC divfK.
have np : norm (times q' (Rigid.conj q)) != 0 by rewrite norm_times mulf_neq0 // norm_conj.
have := times_back q' q; case: (same_twist t0 np cp) => [[p2 p3 p4]|[l pE]].
  move: (times q' _) p2 p3 p4 => p p2 p3 p4 [ba bb bc bd].
  have e : q' = factor (qa p / norm q) q.
    by apply: quat_ext; apply: div; rewrite -?ba -?bb -?bc -?bd /times p2 p3 p4 /=; ring.
  by exists (qa p / norm q); [exact: nonzero e | left].
rewrite pE => -[ba bb bc bd]; have e : q' = factor (l / norm q) (turned t q).
  by apply: quat_ext; apply: div; rewrite -?ba -?bb -?bc -?bd /turned /times /=; ring.
by exists (l / norm q); [exact: nonzero e | right].
Qed.
End Same.
