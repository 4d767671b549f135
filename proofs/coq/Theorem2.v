(** * Theorem 2 of the paper: every minimal problem reduces to a reduced problem

    A selection is cheap if it takes at least as many degrees of freedom from space as from the
    images. A cheap selection of each feature that keeps as little as possible leaves final
    features, so a reduced problem. In a minimal problem no selection is cheaper than keeping
    everything. *)
From Coq Require Import Permutation.
From mathcomp Require Import all_ssreflect all_algebra.
From mathcomp.zify Require Import zify.
From PL1P Require Import Statement Reducible Problems Reductions Forget Independence Reduction Embedding
  Scenes.
From PL1P Require Import Keeps Theorem1.
Set Implicit Arguments.
Unset Strict Implicit.
Unset Printing Implicit Defensive.

(** ** To forget twice *)
Section Twice.
Variables (f : feature) (c d : selection).
Hypothesis fc : feasible f c.
Hypothesis fd : feasible (keep f c) d.
Definition twice : selection := (c.1 && d.1, [seq nth 0 c.2 i | i <- d.2]).
Let uc : uniq c.2. Proof. by case/and3P: fc. Qed.
Let dc i : i \in d.2 -> i < size c.2. Proof. by case/and3P: fd => _ /allP h _ /h. Qed.
Lemma twice_feasible : feasible f twice.
Proof.
case/and3P: fc => _ /allP ac pc; case/and3P: fd => ud /allP ad pd; apply/and3P; split=> /=.
- rewrite map_inj_in_uniq // => i j /dc ic /dc jc /eqP; by rewrite nth_uniq // => /eqP.
- by apply/allP => j /mapP[i /dc ic ->]; apply: ac; exact: mem_nth.
rewrite size_map; case: (d.1) pd => /=; last by rewrite andbF.
rewrite andbT; case: (c.1) pc => //= pc _; apply: leq_trans pc; rewrite -[size c.2](size_iota 0).
by apply: uniq_leq_size => // i /dc ic; rewrite mem_iota.
Qed.
Lemma twice_mem j : (j \in twice.2) = (j \in c.2) && (index j c.2 \in d.2).
Proof.
apply/mapP/andP => [[i id ->]|[jc jd]]; last by exists (index j c.2); rewrite ?nth_index.
by rewrite mem_nth ?dc // index_uniq ?dc.
Qed.
Lemma twice_seen v : seen_by (keep f twice) v = seen_by (keep (keep f c) d) v.
Proof.
have e : size [seq index j twice.2 | j <- sees_pins f v & j \in twice.2] =
    size [seq index i d.2 | i <- [seq index j c.2 | j <- sees_pins f v & j \in c.2] & i \in d.2].
  rewrite !size_map !size_filter count_map count_filter; apply: eq_count => j.
  by rewrite twice_mem andbC.
have -> : seen_by (keep f twice) v =
  let n := size [seq index j twice.2 | j <- sees_pins f v & j \in twice.2] in
  if sees_point f v && (c.1 && d.1) then 2 + n else 2 * n by [].
by rewrite e andbA.
Qed.
Lemma twice_dims : dim2 (keep f twice) = dim2 (keep (keep f c) d) /\ space (keep f twice) =
  space (keep (keep f c) d).
Proof.
split; first by rewrite !dim2E !twice_seen.
have e1 : free (keep f twice) = free (keep (keep f c) d) by rewrite /= negb_and orbA.
have e2 : pins (keep f twice) = pins (keep (keep f c) d) by rewrite /= size_map.
by rewrite /space /nothing /dim3 e1 e2.
Qed.
End Twice.

(** ** Forgetting as much as possible *)
Definition content f := pins f + ~~ free f.
Definition settled f := nothing f || final f.
Lemma content_keep f c : proper f -> feasible f c -> ~~ whole f c -> content (keep f c) < content f.
Proof.
move=> pf /and3P[uc /allP ac fc]; rewrite /whole /content /= negb_and => nw.
have : size c.2 <= pins f.
  by rewrite -[pins f](size_iota 0); apply: uniq_leq_size => // i /ac ic; rewrite mem_iota.
by case: (free f) nw; case: (c.1) => //=; lia.
Qed.
Lemma settle f c : proper f -> feasible f c -> ~~ strict f c ->
  exists2 d, feasible f d && ~~ strict f d & settled (keep f d).
Proof.
move=> pf; have [m] := ubnP (content (keep f c)); elim: m c => // m IH c le fc sc.
have [n|nn] := boolP (nothing (keep f c)); first by exists c; rewrite ?fc // /settled n.
have [ff|[d /andP[fd nw] sd]] := not_final (keep_proper pf fc nn).
  by exists c; rewrite ?fc // /settled ff orbT.
have [e1 e2] := twice_dims fc fd; apply: (IH (twice c d)).
- have lt := content_keep (keep_proper pf fc nn) fd nw; rewrite ltnS in le.
  by apply: leq_trans le; move: lt; rewrite /content /= size_map negb_or negb_and orbA !negb_or !negbK.
- exact: twice_feasible.
move: sc sd; rewrite /strict e1 e2 /space (negbTE nn) -!leqNgt.
by move: (dim2 _) (dim2 _) (dim2 _) (dim3 _) (dim3 _) (if _ then _ else _) => n1 n2 n3 n4 n5 n6; lia.
Qed.
Lemma settle_all A : is_problem A -> exists2 cs, selects A cs &
  (sumn [seq cost fc.1 fc.2 | fc <- zip A cs] <= sumn [seq dim3 f | f <- A]) && all final (kept A cs).
Proof.
elim: A => [|f A IH]; first by exists [::].
case/andP=> pf /IH[cs sel /andP[le fin]]; have [e1 e2 e3] := everything_ok pf.
have [|c /andP[fc sc] st] := settle pf e1; first by rewrite cost_strict // -leqNgt.
rewrite cost_strict // -leqNgt in sc; exists (c :: cs); first by rewrite selects_cons fc.
apply/andP; split; first exact: leq_add.
by rewrite kept_cons; move: st; rewrite /settled; case: (nothing _) => //= ->.
Qed.

Section Over.
Variable F : fieldType.
Hypothesis char0 : [char F]%R =i pred0.
Theorem reduces_to_reduced A : is_problem A -> minimal F A ->
  exists2 cs, reduces F A cs & reduced F (kept A cs).
Proof.
move=> pA mA; have [cs sel /andP[le fin]] := settle_all pA; exists cs.
  by split=> //; case/andP: (sel) => /eqP sz fs; exact: (minimal_lifting char0).
by apply: final_reduced => //; exact: kept_proper.
Qed.
End Over.
