(** * Not obstructed implies rigid at a given point: by computation

    One walk over all balanced signatures inserts the camera rows of the pool's features into an
    echelon state modulo p, sharing what neighbours in the tree share. At every leaf the 11 slots
    are full or the signature is obstructed ([regular_check]). Regular.v says why that suffices. *)
From Coq Require Import ZArith Uint63 List.
From mathcomp Require Import all_ssreflect all_algebra.
From mathcomp.zify Require Import ssrZ.
From PL1P Require Import Statement Rigid Walk Predicates Elimination Forms.
Set Implicit Arguments.
Unset Strict Implicit.
Unset Printing Implicit Defensive.
Local Notation ZR := [idomainType of Z].

(** A point: cameras, and placed features of each kind; and the camera rows of the features. *)
Record point_data := PointData {
  cams : view -> camera ZR;
  pool : seq (seq (vec ZR * seq (vec ZR)));
  table : seq (seq (seq row)) }.

Section Tree.
Variable pt : point_data.
Definition instance i k : placed ZR :=
  let: (X, Ds) := nth (vec0 ZR, [::]) (nth [::] (pool pt) i) k in Placed i X (nth (vec0 ZR) Ds).
Definition capacity i := size (nth [::] (pool pt) i).

(** ** The blocks: pivots in the feature's own unknowns, and what is left on the cameras *)
Definition own i := let f := ft i in (if free f then 2 else 3) + 2 * pins f.
Definition block_state i k : state :=
  insert_all (empty (own i + 11)) (map reduce (block (cams pt) (instance i k))).
Definition camera_rows i k := rows_of (drop (own i) (block_state i k)).
Definition rows_table := [seq [seq camera_rows i k | k <- iota 0 (capacity i)] | i <- iota 0 27].

(** ** The walk *)
Definition step i k st := insert_all st (nth [::] (nth [::] (table pt) i) k).
Definition leaf pre st (acc : bool) := if acc then if full st then true else obstructed_by dotn (rev pre)
  else false.

(** ** The point is admissible *)
Definition nonzero (u : vec ZR) := ~~ [&& x1 u == 0%R, x2 u == 0%R & x3 u == 0%R].
Definition instance_ok i k := let q := instance i k in
  all (fun v => [&& sees_point (ft i) v ==> (x3 (project (cams pt v) (point q)) != 0%R) &
                 all (fun j => nonzero (line (cams pt v) q j)) (sees_pins (ft i) v)]) views &&
  all (fun j => x3 (dir q j) != 0%R) (iota 0 (pins (ft i))).
Definition differ (u w : vec ZR) := [|| x1 u != x1 w, x2 u != x2 w | x3 u != x3 w].
Definition cams_ok := let C := cams pt in
  [&& all (fun v => norm (quat_of (C v)) != 0%R) views, x1 (trans (C V2)) != 0%R &
    all (fun uw => differ (scale (norm (quat_of (C uw.2)) ^+ 2)%R (centre (C uw.1)))
      (scale (norm (quat_of (C uw.1)) ^+ 2)%R (centre (C uw.2))))
      [:: (V1, V2); (V2, V1); (V1, V3); (V3, V1); (V2, V3); (V3, V2)]].

(** What is computed for a point. *)
Record checked := Checked {
  first_camera : cams pt V1 = Camera (@Quat ZR 1%R 0%R 0%R 0%R) (vec0 ZR);
  tableE : table pt = rows_table;
  blocks_check : all (fun i => all (fun k => full (take (own i) (block_state i k))) (iota 0 (capacity i)))
    (iota 0 27);
  capacity_check : all (fun i => 11 < (capacity i).+1 * nth 0 ws i) (iota 0 27);
  cams_okE : cams_ok;
  instances_ok : all (fun i => all (instance_ok i) (iota 0 (capacity i))) (iota 0 27);
  regular_check : walk step leaf ws 0 11 (empty 11) [::] true = true }.
Hypothesis ok : checked.

Lemma leaf_all l acc : foldl (fun acc s => leaf (catrev s [::]) (run step 0 s (empty 11)) acc) acc l ->
  forall s, s \in l -> full (run step 0 s (empty 11)) || obstructed_by dotn s.
Proof.
have stays l' : foldl (fun acc s => leaf (catrev s [::]) (run step 0 s (empty 11)) acc) false l' = false
  by elim: l'.
elim: l acc => // s l IH acc h t; rewrite inE => /orP[/eqP ->|]; last exact: (IH _ h).
move: h; rewrite -[foldl _ _ (s :: l)]/(foldl _ (leaf _ _ acc) l); rewrite /leaf; case: acc => //;
  last by rewrite stays.
case: (full _) => //=; case e: (obstructed_by _ _); last by rewrite stays.
by rewrite -[catrev s [::]]/(rev s) revK in e.
Qed.

Lemma regular_full s : balanced s -> ~~ obstructed s -> full (run step 0 s (empty 11)).
Proof.
move=> bs ob; have sl : s \in balanced_list by rewrite balanced_mem.
have := regular_check ok; rewrite walkE; last by vm_compute.
by move=> /leaf_all -/(_ s sl); rewrite (obstructed_fast bs) (negbTE ob) orbF.
Qed.
End Tree.
