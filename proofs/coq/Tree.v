(** * Not obstructed implies minimal: by computation

    One walk over all balanced signatures inserts the camera rows of the pool's features into an echelon state modulo
    p, sharing what neighbours in the tree share. At every leaf the 11 slots are full or the signature is obstructed
    ([regular_check]). Regular.v says why that suffices. *)
From Coq Require Import ZArith Uint63 List.
From mathcomp Require Import all_ssreflect all_algebra.
From mathcomp.zify Require Import ssrZ.
From PL1P Require Import Statement Rigid Walk Predicates Elimination Forms Pool.
Set Implicit Arguments.
Unset Strict Implicit.
Unset Printing Implicit Defensive.
Local Notation ZR := [idomainType of Z].

Definition cams : view -> camera ZR :=
  by_view (Camera (@Quat ZR 1%R 0%R 0%R 0%R) (vec0 ZR)) camera2 camera3.
Definition instance i k : placed ZR :=
  let: (X, Ds) := nth (vec0 ZR, [::]) (nth [::] pool i) k in Placed i X (nth (vec0 ZR) Ds).
Definition capacity i := size (nth [::] pool i).

(** ** The blocks: pivots in the feature's own unknowns, and what is left on the cameras *)
Definition own i := let f := ft i in (if free f then 2 else 3) + 2 * pins f.
Definition block_state i k : state := insert_all (empty (own i + 11)) (map reduce (block cams (instance i k))).
Definition camera_rows i k := rows_of (drop (own i) (block_state i k)).
Definition table := Eval vm_compute in [seq [seq camera_rows i k | k <- iota 0 (capacity i)] | i <- iota 0 27].

Lemma tableE : table = [seq [seq camera_rows i k | k <- iota 0 (capacity i)] | i <- iota 0 27].
Proof. by vm_compute. Qed.

Lemma blocks_check : all (fun i => all (fun k => full (take (own i) (block_state i k))) (iota 0 (capacity i))) (iota 0 27).
Proof. by vm_compute. Qed.

Lemma capacity_check : all (fun i => 11 < (capacity i).+1 * nth 0 ws i) (iota 0 27).
Proof. by vm_compute. Qed.

(** ** The walk *)
Definition step i k st := insert_all st (nth [::] (nth [::] table i) k).
Definition leaf pre st (acc : bool) := if acc then if full st then true else obstructed_by dotn (rev pre) else false.

Lemma regular_check : walk step leaf ws 0 11 (empty 11) [::] true = true.
Proof. vm_cast_no_check (erefl true). Qed.

Lemma leaf_all l acc : foldl (fun acc s => leaf (catrev s [::]) (run step 0 s (empty 11)) acc) acc l ->
  forall s, s \in l -> full (run step 0 s (empty 11)) || obstructed_by dotn s.
Proof.
have stays l' : foldl (fun acc s => leaf (catrev s [::]) (run step 0 s (empty 11)) acc) false l' = false by elim: l'.
elim: l acc => // s l IH acc h t; rewrite inE => /orP[/eqP ->|]; last exact: (IH _ h).
move: h; rewrite -[foldl _ _ (s :: l)]/(foldl _ (leaf _ _ acc) l); rewrite /leaf; case: acc => //; last by rewrite stays.
case: (full _) => //=; case e: (obstructed_by _ _); last by rewrite stays.
by rewrite -[catrev s [::]]/(rev s) revK in e.
Qed.

Lemma regular_full s : balanced s -> ~~ obstructed s -> full (run step 0 s (empty 11)).
Proof.
move=> bs ob; have sl : s \in balanced_list by rewrite balanced_mem.
have := regular_check; rewrite walkE; last by vm_compute.
by move=> /leaf_all -/(_ s sl); rewrite (obstructed_fast bs) (negbTE ob) orbF.
Qed.

