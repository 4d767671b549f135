(** * A minimal problem reduces to one reduced problem only

    Feature by feature. In a minimal problem nothing costs less than it frees. A pin of a point that
    is kept has more than two image coordinates if it is kept, and at most two if it is not: so the
    pins that are kept are the same. A free line that is left of a point is seen in all three views,
    so it is not forgotten if the point is kept; then both can be kept. *)
From Coq Require Import Permutation.
From mathcomp Require Import all_ssreflect all_algebra.
From mathcomp.zify Require Import zify.
From PL1P Require Import Statement Reducible Problems Reductions Forget RationalFunctions Independence
  Reduction Embedding Scenes SameProblem.
From PL1P Require Import Keeps Theorem1 Theorem2.
Set Implicit Arguments.
Unset Strict Implicit.
Unset Printing Implicit Defensive.

Definition left_over k := nothing k || (index_of k < 27).
Lemma free_known k : proper k -> free k -> index_of k < 27 ->
  same k free_line /\ forall v, 0 \in sees_pins k v.
Proof.
move=> pk fr lt; have sk := index_same lt; have /sameP[e1 e2 [r p q]] := sk.
have one : all (fun i => free (ft i) ==> (i == 11)) (iota 0 27) by vm_compute.
have := allP one (index_of k); rewrite mem_iota -e1 fr => /(_ lt)/eqP i11; rewrite i11 in sk e1 e2 q.
split=> // v; have /andP[_ /perm_size] := q v; rewrite size_map; have [_ /allP le _] := properP v pk.
have -> : size (looks (ft 11) v).2 = 1 by case: v {le}.
rewrite -/(sees_pins k v); case: (sees_pins k v) le => [|j [|]] // le _.
have := le j (mem_head _ _); rewrite (free_pins pk fr) ltnS leqn0 => /eqP ->; exact: mem_head.
Qed.

Lemma count_lost j (c2 l : seq nat) : j \notin c2 ->
  count (fun i => i \notin c2) l = count (fun i => i \notin j :: c2) l + count (pred1 j) l.
Proof.
move=> jc; elim: l => //= i l ->; rewrite inE negb_or.
by case: eqP => [->|_] /=; rewrite ?jc !add0n; [exact: addnCA | exact: addnA].
Qed.

Section One.
Variable f : feature.
Hypothesis pf : proper f.
Hypothesis tight : forall c, feasible f c -> dim3 f <= cost f c.
Implicit Types c d : selection.
Definition fits c := [/\ feasible f c, cost f c <= dim3 f & left_over (keep f c)].

Lemma fits_dims c : fits c -> dim2 f + space (keep f c) = dim2 (keep f c) + dim3 f.
Proof.
case=> fc le _; have := tight fc; rewrite /cost in le *; rewrite -(lost_dim2 pf fc).
move: (space _) (dim2 _) (dim3 f) le.
by move: (_ + _ + lost_seen f c V3) => n1 n2 n3 n4; lia.
Qed.
Lemma fits_final c : fits c -> ~~ nothing (keep f c) -> proper (keep f c) /\ final (keep f c).
Proof. by case=> fc _ /orP[->//|kn] nn; split; [exact: keep_proper | rewrite /final kn]. Qed.
Lemma nothing_both c d : fits c -> fits d -> nothing (keep f c) -> nothing (keep f d).
Proof.
move=> hc hd n; apply/negPn/negP => nd; have [pd fd] := fits_final hd nd; have := final_weight pd fd.
have := fits_dims hc; have := fits_dims hd; rewrite /space n (negbTE nd) (nothing_dim2 pf n).
by move: (dim2 f) (dim2 (keep f d)) (dim3 f) (dim3 (keep f d)) => n1 n2 n3 n4; lia.
Qed.

(** A pin that is kept with its point. *)
Lemma share_kept c j : fits c -> ~~ free f -> c.1 -> j \in c.2 -> 2 < share f j.
Proof.
move=> hc nf c1 jc; have [fc _ _] := hc.
have nn : ~~ nothing (keep f c) by rewrite /nothing /= c1 (negbTE nf).
have [pk fk] := fits_final hc nn; set i := index j c.2; have ik : i < pins (keep f c) by rewrite index_mem.
have nfk : ~~ free (keep f c) by rewrite /= c1 orbF.
have [h1 h2 h3] := forget_pin pk nfk ik; have := final_strict pk fk h1 h2; rewrite /strict -h3.
have -> : share (keep f c) i = share f j.
  have e v : (if sees_point (keep f c) v then 1 else 2) * (i \in sees_pins (keep f c) v) =
      (if sees_point f v then 1 else 2) * (j \in sees_pins f v).
    rewrite {1}/sees_point [X in if X then _ else _]/= c1 andbT; congr (_ * nat_of_bool _).
    apply/mapP/idP => [[j']|js]; last by exists j => //; rewrite mem_filter jc.
    rewrite mem_filter => /andP[j'c js] e; suff -> : j = j' by [].
    by rewrite -(nth_index 0 jc) -(nth_index 0 j'c) -e.
  by rewrite /share /= !e.
have e2 : space (keep (keep f c) (true, rem i (iota 0 (pins (keep f c))))) + 2 = dim3 (keep f c).
  set c' := (true, _); have fr : free (keep (keep f c) c') = false by rewrite -(negbTE nfk) /= orbF.
  rewrite /space /nothing /dim3 fr (negbTE nfk) [pins (keep _ c')]/= size_rem ?mem_iota // size_iota.
  have pos : 0 < size c.2 := leq_ltn_trans (leq0n i) ik.
  by rewrite [pins _]/=; case: (size c.2) pos => // m _; rewrite mulnS -addnA [(2 + _)%N]addnC.
by rewrite -e2; move: (dim2 _) (share _ _) (space _) => n1 n2 n3; clear; lia.
Qed.
Lemma share_lost c j : fits c -> ~~ free f -> c.1 -> j < pins f -> j \notin c.2 -> share f j <= 2.
Proof.
case=> fc le _ nf c1 jp jc; case/and3P: fc => uc ac pc.
have fd : feasible f (true, j :: c.2) by rewrite /feasible /= jc uc jp ac.
have := leq_trans le (tight fd); rewrite /cost.
have e v : lost_seen f c v =
    lost_seen f (true, j :: c.2) v + (if sees_point f v then 1 else 2) * (j \in sees_pins f v).
  have [us _ _] := properP v pf; rewrite /lost_seen c1 !andbF !add0n -mulnDr.
  congr (_ * _); rewrite !size_filter /=.
  have -> : (j \in sees_pins f v : nat) = count (pred1 j) (sees_pins f v) by rewrite count_uniq_mem.
  exact: count_lost.
rewrite !e /share /= addn0 /space /nothing /= c1 (negbTE nf) /= /dim3 /= (negbTE nf) orbF c1 /=.
rewrite mulnS; move: (2 * size c.2) (lost_seen _ _ _) (lost_seen _ _ _) (lost_seen _ _ _) => m n1 n2 n3.
by move: (_ * _) (_ * _) (_ * _) => n4 n5 n6; clear; lia.
Qed.
(** A free line that is left of a point. *)
Lemma line_left c d : fits c -> fits d -> ~~ free f -> ~~ nothing (keep f c) -> ~~ c.1 -> d.1 -> False.
Proof.
move=> hc hd nf nn nc d1; have [fc _ lo] := hc; have [fd _ _] := hd.
have kn : index_of (keep f c) < 27 by case/orP: lo => //; rewrite (negbTE nn).
have [pk fk] := fits_final hc nn; have frk : free (keep f c) by rewrite /= nc orbT.
have [_ see] := free_known pk frk kn; have pin1 : size c.2 = 1 := free_pins pk frk.
have [j e2] : exists j, c.2 = [:: j] by move: pin1; case: (c.2) => [|j [|]] //; exists j.
have jp : j < pins f by case/and3P: fc => _; rewrite e2 /= andbT.
have js v : j \in sees_pins f v.
  have := see v; rewrite /sees_pins /= e2 => /mapP[i]; rewrite mem_filter inE.
  by case/andP=> /eqP -> il _; exact: il.
have [jd|jd] := boolP (j \in d.2); last first.
  by have := share_lost hd nf d1 jp jd; rewrite /share /= !js; do 3 case: (sees_point f _).
have nd : ~~ nothing (keep f d) by rewrite /nothing /= d1 (negbTE nf).
have [pd ffd] := fits_final hd nd; pose i := index j d.2; have id : i < size d.2 by rewrite index_mem.
have fi : feasible (keep f d) (false, [:: i]) by rewrite /feasible /= id.
have nw : ~~ whole (keep f d) (false, [:: i]) by rewrite /whole /= d1 (negbTE nf).
have [t1 t2] := twice_dims fd fi.
have et : twice d (false, [:: i]) = (false, [:: j]) by rewrite /twice /= andbF nth_index.
have ec : c = (false, [:: j]) by case: (c) nc e2 => -[] l //= _ ->.
rewrite et -ec in t1 t2; have := final_strict pd ffd fi nw; rewrite /strict -t1 -t2.
have := fits_dims hc; have := fits_dims hd; rewrite {1}/space (negbTE nd).
move: (dim2 f) (dim3 f) (dim2 (keep f c)) (dim3 (keep f d)) (dim2 (keep f d)) (space (keep f c)).
by clear=> n1 n2 n3 n4 n5 n6; lia.
Qed.
Lemma same_kept c d : feasible f c -> feasible f d -> c.1 -> d.1 -> c.2 =i d.2 -> same (keep f c) (keep f d).
Proof.
move=> /and3P[uc _ _] /and3P[ud _ _] c1 d1 e.
have sz : size c.2 = size d.2 by apply: perm_size; exact: uniq_perm.
apply/sameP; split=> //; first by rewrite /= c1 d1.
exists [seq index j d.2 | j <- c.2].
  rewrite [pins _]/=; apply: uniq_perm; rewrite ?iota_uniq //.
    by rewrite map_inj_in_uniq // => i j; rewrite !e => ic jc h; rewrite -(nth_index 0 ic) h nth_index.
  move=> i; rewrite mem_iota add0n /=; apply/mapP/idP => [[j]|lt]; first by rewrite e sz -index_mem => lt ->.
  by exists (nth 0 d.2 i); rewrite ?e ?mem_nth -?sz // index_uniq -?sz.
move=> v; rewrite /same_look -[(looks (keep f c) v).1]/(sees_point f v && c.1).
rewrite -[(looks (keep f d) v).1]/(sees_point f v && d.1) c1 d1 eqxx andTb.
rewrite -[(looks (keep f c) v).2]/[seq index j c.2 | j <- sees_pins f v & j \in c.2].
rewrite -[(looks (keep f d) v).2]/[seq index j d.2 | j <- sees_pins f v & j \in d.2] -map_comp.
have -> : [seq j <- sees_pins f v | j \in d.2] = [seq j <- sees_pins f v | j \in c.2].
  by apply: eq_filter => j; rewrite e.
suff -> : [seq (nth 0 [seq index j d.2 | j <- c.2] \o index^~ c.2) j | j <- sees_pins f v & j \in c.2] =
  [seq index j d.2 | j <- sees_pins f v & j \in c.2] by [].
apply/eq_in_map => j; rewrite mem_filter => /andP[jc _] /=.
by rewrite (nth_map 0) ?index_mem // nth_index.
Qed.
Lemma same_pins c d : fits c -> fits d -> ~~ free f -> c.1 -> d.1 -> c.2 =i d.2.
Proof.
move=> hc hd nf c1 d1 j; apply/idP/idP => h; apply/negPn/negP => n.
  have [/and3P[_ /allP ac _] _ _] := hc.
  by have := share_kept hc nf c1 h; rewrite ltnNge (share_lost hd nf d1 (ac j h) n).
have [/and3P[_ /allP ad _] _ _] := hd.
by have := share_kept hd nf d1 h; rewrite ltnNge (share_lost hc nf c1 (ad j h) n).
Qed.
(** What is left of a feature is one, up to the names of pins. *)
Lemma one_kept c d : fits c -> fits d -> ~~ nothing (keep f c) -> same (keep f c) (keep f d).
Proof.
move=> hc hd nc; have nd : ~~ nothing (keep f d) by apply: contra nc; exact: nothing_both.
have line e : fits e -> ~~ nothing (keep f e) -> free (keep f e) -> same (keep f e) free_line.
  move=> he ne fr; have [pe _] := fits_final he ne; have [_ _ lo] := he.
  by apply: (proj1 (free_known pe fr _)); move: lo; rewrite /left_over (negbTE ne).
have lines : free (keep f c) -> free (keep f d) -> same (keep f c) (keep f d).
  have [pd _] := fits_final hd nd; have [pc _] := fits_final hc nc.
  by move=> /(line c hc nc) h1 /(line d hd nd) h2; exact: same_trans pc h1 (same_sym pd h2).
case fr: (free f); first by apply: lines; rewrite /= fr.
have nf := negbT fr; case c1: (c.1); case d1: (d.1).
- by have [fc _ _] := hc; have [fd _ _] := hd; apply: same_kept => //; exact: same_pins.
- by case: (line_left hd hc nf nd (negbT d1) c1).
- by case: (line_left hc hd nf nc (negbT c1) d1).
by apply: lines; rewrite /= ?c1 ?d1 orbT.
Qed.
End One.

(** ** The whole problem *)
Lemma selects_everything A : is_problem A -> selects A (map everything A) /\
  sumn [seq cost fc.1 fc.2 | fc <- zip A (map everything A)] <= sumn [seq dim3 f | f <- A].
Proof.
elim: A => // f A IH /andP[pf /IH[h1 h2]]; have [e1 _ e3] := everything_ok pf.
by rewrite [map _ _]/= selects_cons e1; split=> //; exact: leq_add.
Qed.
(** No selection costs less than all parameters. *)
Definition tight_problem A := forall cs, selects A cs ->
  sumn [seq dim3 f | f <- A] <= sumn [seq cost fc.1 fc.2 | fc <- zip A cs].
Lemma tight_cons f A : is_problem (f :: A) -> tight_problem (f :: A) ->
  (forall c, feasible f c -> dim3 f <= cost f c) /\ tight_problem A.
Proof.
move=> /andP[pf pA] t; have [h1 h2] := selects_everything pA; have [e1 _ e3] := everything_ok pf; split.
  move=> c fc; have := t (c :: map everything A); rewrite selects_cons fc => /(_ h1) /=.
  by move: h2; move: (sumn _) (sumn _) (cost f c) => n1 n2 n3; clear; lia.
move=> cs sel; have := t (everything f :: cs); rewrite selects_cons e1 => /(_ sel) /=.
by move: e3; move: (sumn _) (sumn _) (cost f _) => n1 n2 n3; clear; lia.
Qed.
Lemma one_all A cs ds : is_problem A -> tight_problem A -> selects A cs -> selects A ds ->
  sumn [seq cost fc.1 fc.2 | fc <- zip A cs] <= sumn [seq dim3 f | f <- A] ->
  sumn [seq cost fc.1 fc.2 | fc <- zip A ds] <= sumn [seq dim3 f | f <- A] ->
  known (kept A cs) -> known (kept A ds) -> all2 same (kept A cs) (kept A ds).
Proof.
elim: A cs ds => [|f A IH] [|c cs] [|d ds] //= pA t; rewrite !selects_cons => /andP[fc sc] /andP[fd sd].
have [tf tA] := tight_cons pA t; case/andP: pA => pf pA.
have fit (e : selection) (es : seq selection) : feasible f e -> selects A es ->
    cost f e + sumn [seq cost fc.1 fc.2 | fc <- zip A es] <= dim3 f + sumn [seq dim3 f | f <- A] ->
    known (kept (f :: A) (e :: es)) -> [/\ fits f e, sumn [seq cost fc.1 fc.2 | fc <- zip A es] <=
      sumn [seq dim3 f | f <- A] & known (kept A es)].
  move=> fe se le; have := tA _ se; have := tf _ fe; move: le.
  move: (sumn _) (sumn _) => n1 n2 l1 l2 l3; rewrite kept_cons => kn.
  have le1 : cost f e <= dim3 f by move: (cost f e) (dim3 f) l1 l2 l3 => n3 n4; clear; lia.
  split.
  - split=> //.
    by move: kn; rewrite /left_over; case: (nothing _) => //= /andP[].
  - by move: (cost f e) (dim3 f) l1 l2 l3 => n3 n4; clear; lia.
  - by move: kn; case: (nothing _) => //= /andP[].
move=> l1 l2 /(fit _ _ fc sc l1)[h1 h2 h3] /(fit _ _ fd sd l2)[g1 g2 g3].
have := IH _ _ pA tA sc sd h2 g2 h3 g3; rewrite !kept_cons.
case n1: (nothing (keep f c)); first by rewrite (nothing_both pf tf h1 g1 n1).
case n2: (nothing (keep f d)); first by rewrite (nothing_both pf tf g1 h1 n2) in n1.
by rewrite /= (one_kept pf tf h1 g1 (negbT n1)) => ->.
Qed.

Section Over.
Variable F : fieldType.
Hypothesis char0 : [char F]%R =i pred0.
Lemma minimal_tight A : is_problem A -> minimal F A -> tight_problem A.
Proof.
move=> pA mA cs sel; rewrite leqNgt; apply/negP => lt; have /andP[/eqP sz fs] := sel.
have red : reduces F A cs by split=> //; exact: (minimal_lifting char0 pA mA sz fs (ltnW lt)).
have [sA _] := (balanced_dominant char0 A).1 mA.
have [sB _] := (balanced_dominant char0 _).1 (minimal_kept char0 pA red mA).
have := @size_lifting F A cs; rewrite size_lifted // -sB (size_all pA red) sA /parameters => e.
by move: lt; rewrite -(ltn_add2l 11) e ltnn.
Qed.
Theorem one_reduction A cs ds : is_problem A -> minimal F A ->
  reduces F A cs -> reduced F (kept A cs) -> reduces F A ds -> reduced F (kept A ds) ->
  same_problem (kept A cs) (kept A ds).
Proof.
move=> pA mA; have cheap es : reduces F A es -> reduced F (kept A es) ->
    sumn [seq cost fc.1 fc.2 | fc <- zip A es] <= sumn [seq dim3 f | f <- A] /\ known (kept A es).
  move=> red rB; split; last first.
    by apply: (reduced_known char0 _ _ rB); [exact: kept_proper (proj1 red) | exact: minimal_kept red mA].
  have /andP[/eqP sz _] := proj1 red.
  have := ind_size (@den_neq0 _) (@fractionE _) (to := to F (parameters A)) (proj2 red).
  by rewrite (size_lifted F (parameters A) sz) leq_add2l.
move=> rc /(cheap _ rc)[h1 h2] rd /(cheap _ rd)[h3 h4].
exists (kept A cs); first exact: Permutation_refl.
exact: one_all pA (minimal_tight pA mA) (proj1 rc) (proj1 rd) h1 h3 h2 h4.
Qed.
End Over.

Theorem reductions_theorem : reductions.
Proof.
move=> F char0 A pA; split=> [cs mA red|cs mB red sz|mA|cs ds mA].
- exact: (minimal_kept char0 pA red).
- exact: (kept_minimal char0 pA red).
- exact: reduces_to_reduced.
- exact: one_reduction.
Qed.
