(** * Poses with the same essential matrix

    If two cameras with t = (1, ...) have the same E up to scale, they have the same t, and their
    rotations are the same or differ by a half turn about t ([same_essential]). *)
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

(** [t] rot p = k [t]: then p is 1, or p is t, up to a factor. *)
Lemma same_twist t p k : x1 t = 1 -> norm p != 0 -> (forall w, cross t (rot p w) = scale k (cross t w)) ->
  [/\ qb p = 0, qc p = 0 & qd p = 0] \/ [/\ qa p = 0, qc p = x2 t * qb p & qd p = x3 t * qb p].
Proof.
case: p => a b c d; case: t => t1 t2 t3; rewrite /norm /= => -> {t1} n0 h.
have sub (x y : L) : x = y -> x - y = 0 by move=> ->; exact: subrr.
have e1 w := sub _ _ (congr1 (@x1 L) (h w)); have e2 w := sub _ _ (congr1 (@x2 L) (h w)); have e3 w :=
  sub _ _ (congr1 (@x3 L) (h w)).
move: (e1 (Vec 1 0 0)) (e2 (Vec 1 0 0)) (e3 (Vec 1 0 0)) (e1 (Vec 0 1 0)) (e2 (Vec 0 1 0)) (e3 (Vec 0 1 0))
  (e1 (Vec 0 0 1)) (e2 (Vec 0 0 1)) (e3 (Vec 0 0 1)).
clear e1 e2 e3 h; rewrite /cross /rot /scale /dot /= => e11 e12 e13 e21 e22 e23 e31 e32 e33.
(* with P = (b, c, d) and V = t x P + a t: V_i P_j + V_j P_i = 0 *)
pose v1 := t2 * d - t3 * c + a; pose v2 := t3 * b - d + a * t2; pose v3 := c - t2 * b + a * t3.
have half (x : L) : x *+ 2 = 0 -> x = 0 by move/eqP; rewrite -mulr_natr mulf_eq0 (negbTE two) orbF => /eqP.
have comb (x y z w : L) : x = 0 -> y = 0 -> z = 0 -> w *+ 2 = x + y + z -> w = 0.
  by move=> -> -> -> h; apply: half; rewrite h !addr0.
have at0 : a * (b + t2 * c + t3 * d) = 0.
  by apply: oppr_inj; rewrite oppr0; apply: half; apply: (comb _ _ _ _ e11 e22 e33); ring.
have tw : (a * (b + t2 * c + t3 * d)) *+ 2 = 0 by rewrite at0 mul0rn.
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
have eD : d = t3 * b + a * t2.
  by apply/eqP; rewrite eq_sym -subr_eq0; apply/eqP; rewrite -[RHS]V2 /v2; ring.
have eC : c = t2 * b - a * t3.
  by apply/eqP; rewrite -subr_eq0; apply/eqP; rewrite -[RHS]V3 /v3; ring.
have aT : a * (1 + t2 ^+ 2 + t3 ^+ 2) = 0.
  by rewrite -[RHS]V1 /v1 eD eC; ring.
have a0 : a = 0.
  apply/eqP; move/eqP: aT; rewrite mulf_eq0 => /orP[//|/eqP T0].
  case/eqP: n0; transitivity ((a ^+ 2 + b ^+ 2) * (1 + t2 ^+ 2 + t3 ^+ 2)); first by rewrite eD eC; ring.
  by rewrite T0 mulr0.
by split; rewrite ?eC ?eD a0 // ?mul0r ?subr0 ?addr0 //; ring.
Qed.

Lemma quat_ext q q' : qa q = qa q' -> qb q = qb q' -> qc q = qc q' -> qd q = qd q' -> q = q'.
Proof. by case: q => ? ? ? ?; case: q' => ? ? ? ? /= -> -> -> ->. Qed.
Lemma times_back p q : let r := times (times p (Rigid.conj q)) q in
  [/\ qa r = norm q * qa p, qb r = norm q * qb p, qc r = norm q * qc p & qd r = norm q * qd p].
Proof. by case: p => a b c d; case: q => a' b' c' d'; rewrite /times /norm /=; split; ring. Qed.
(** The rotation q after a half turn about t. *)
Definition turned t q := let w := times (Quat 0 1 (x2 t) (x3 t)) q in Quat 1 (qb w / qa w) (qc w / qa w)
  (qd w / qa w).

Lemma same_essential t q t' q' k : x1 t = 1 -> x1 t' = 1 -> qa q = 1 -> qa q' = 1 -> norm q != 0 ->
  norm q' != 0 -> k != 0 ->
  (forall e, (e < 9)%N -> essential t' q' e = k * essential t q e) -> t' = t /\ (q' = q \/ q' = turned t q).
Proof.
move=> t1 t1' q1 q1' n0 n0' k0 h.
have c w : cross t' (rot q' (rot (Rigid.conj q) w)) = scale (k * norm q ^+ 2) (cross t w).
  rewrite (same_entries _ h) conj_rot; apply: vec_ext; rewrite /cross /scale /=; ring.
have K0 : k * norm q ^+ 2 != 0 by rewrite mulf_neq0 // expf_neq0.
have d w : dot t' (cross t w) = 0.
  apply: (mulfI K0); rewrite mulr0; transitivity (dot t' (cross t' (rot q' (rot (Rigid.conj q) w)))).
    by rewrite c /dot /scale /=; ring.
  by rewrite /dot /cross /=; ring.
have et : t' = t.
  apply: vec_ext; first by rewrite t1.
    by apply/eqP; rewrite -subr_eq0 -oppr_eq0 -(d (Vec 0 0 1)) /dot /cross /= t1 t1'; apply/eqP; ring.
  by apply/eqP; rewrite -subr_eq0 -(d (Vec 0 1 0)) /dot /cross /= t1 t1'; apply/eqP; ring.
split=> //; have := times_back q' q; have np : norm (times q' (Rigid.conj q)) != 0
  by rewrite norm_times mulf_neq0 // norm_conj.
have cp w : cross t (rot (times q' (Rigid.conj q)) w) = scale (k * norm q ^+ 2) (cross t w)
  by rewrite rot_times -c et.
move: (times q' _) np cp => p np cp [ba bb bc bd]; have [[p2 p3 p4]|[p1 p3 p4]] := same_twist t1 np cp.
- left; move: ba bb bc bd; rewrite /times p2 p3 p4 /= !mul0r !subr0 !addr0 q1 q1' !mulr1 => -> eb ec ed.
  by apply: quat_ext; rewrite ?q1 ?q1' //; apply: (mulfI n0); rewrite -?eb -?ec -?ed.
- right; have {}ba := esym ba; have {}bb := esym bb; have {}bc := esym bc; have {}bd := esym bd.
  set w := times (Quat 0 1 (x2 t) (x3 t)) q; pose b := qb p.
  have pE : p = Quat 0 b (x2 t * b) (x3 t * b) by rewrite -p1 -p3 -p4 /b; case: (p).
  have wa : norm q = b * qa w by move: ba; rewrite q1' mulr1 pE /w /times /= => ->; ring.
  have wb : norm q * qb q' = b * qb w by rewrite bb pE /w /times /=; ring.
  have wc : norm q * qc q' = b * qc w by rewrite bc pE /w /times /=; ring.
  have wd : norm q * qd q' = b * qd w by rewrite bd pE /w /times /=; ring.
  have /andP[b0 a0] : (b != 0) && (qa w != 0) by move: n0; rewrite wa mulf_eq0 negb_or.
  have div x y : norm q * x = b * y -> x = y / qa w.
    by rewrite wa => e; apply: (mulfI b0); apply: (mulIf a0); rewrite -[RHS]mulrA divfK // -e; ring.
  by rewrite /turned -/w; apply: quat_ext; rewrite /= ?q1'; [| exact: div | exact: div | exact: div].
Qed.
End Same.
