(** * The essential matrix of a relative pose

    A camera [R | t], next to [1 | 0], has the essential matrix E = [t] R: u |-> t x R u. It
    satisfies the ten cubic equations of Template.v ([essential_cubics]). *)
From mathcomp Require Import all_ssreflect all_algebra.
From mathcomp.algebra_tactics Require Import ring.
From PL1P Require Import Statement Rigid Epipolar Template.
Set Implicit Arguments.
Unset Strict Implicit.
Unset Printing Implicit Defensive.
Import GRing.Theory.
Local Open Scope ring_scope.

Section Pose.
Variable L : fieldType.
Implicit Types (q p : quat L) (t u w X : vec L).
Notation Vec := (@Vec L).
Notation Quat := (@Quat L).

Definition entry u a := match a with 0 => x1 u | 1 => x2 u | _ => x3 u end%N.
Definition unit_vec a := Vec (a == 0%N)%:R (a == 1%N)%:R (a == 2%N)%:R.
(** Entry 3 a + b is E_ab. *)
Definition essential t q e := entry (cross t (rot q (unit_vec (e %% 3)%N))) (e %/ 3)%N.

Lemma rows_dot t q i j : (i < 3)%N -> (j < 3)%N -> let E := essential t q in
  E (3 * i)%N * E (3 * j)%N + E (3 * i + 1)%N * E (3 * j + 1)%N + E (3 * i + 2)%N * E (3 * j + 2)%N =
  norm q ^+ 2 * (dot t t * (i == j)%:R - entry t i * entry t j).
Proof.
case: q => a b c d; case: t => t1 t2 t3; rewrite /essential /entry /unit_vec /cross /rot /dot /norm.
by do 3?[case: i => [|i] //=]; move=> _; do 3?[case: j => [|j] //=]; move=> _; ring.
Qed.
Lemma t_kills t q b : (b < 3)%N -> let E := essential t q in
  entry t 0 * E b + entry t 1 * E (3 + b)%N + entry t 2 * E (6 + b)%N = 0.
Proof.
rewrite /essential; case: b => [|[|[|b]]] // _; rewrite [(_ %% _)%N]/= [(_ %/ _)%N]/=; move: (rot _ _) => w;
  rewrite /cross /=; ring.
Qed.
Lemma essential_cubics t q k : (k < 10)%N -> form k (essential t q) (essential t q) (essential t q) = 0.
Proof.
rewrite /form ltnS leq_eqVlt; case: eqP => [_ _|_ /= k9].
  rewrite /essential /=; move: (rot q _) (rot q _) (rot q _) => u w x.
  by rewrite /cross /=; ring.
have i3 : (k %/ 3 < 3)%N by rewrite ltn_divLR.
have b3 : (k %% 3 < 3)%N by rewrite ltn_mod.
have rows := rows_dot t q; have := t_kills t q b3; move: rows (divn_eq k 3) i3 b3; set E := essential t q.
move: (k %/ 3)%N (k %% 3)%N => i b rows -> i3 b3; rewrite !rows // => kills.
have -> : E 0%N * E 0%N + E 1%N * E 1%N + E 2%N * E 2%N + E 3%N * E 3%N + E 4%N * E 4%N + E 5%N * E 5%N +
    E 6%N * E 6%N + E 7%N * E 7%N + E 8%N * E 8%N = (norm q ^+ 2 * dot t t) *+ 2.
  have r0 := rows 0%N 0%N isT isT; have r1 := rows 1%N 1%N isT isT; have r2 := rows 2%N 2%N isT isT.
  transitivity ((E 0%N * E 0%N + E 1%N * E 1%N + E 2%N * E 2%N) +
    (E 3%N * E 3%N + E 4%N * E 4%N + E 5%N * E 5%N) +
    (E 6%N * E 6%N + E 7%N * E 7%N + E 8%N * E 8%N)); first by rewrite -!addrA.
  by rewrite r0 r1 r2 /entry /dot /=; ring.
transitivity (- (norm q ^+ 2 * entry t i * (entry t 0 * E b + entry t 1 * E (3 + b)%N + entry t 2 * E
  (6 + b)%N)) *+ 2); last first.
  by rewrite kills mulr0 oppr0 mul0rn.
by case: i i3 {rows} => [|[|[|i]]] // _; rewrite ?mul0n ?mul1n -?[(2 * 3)%N]/6%N ?add0n /=; ring.
Qed.
End Pose.
