(** * The classification: the claim of Statement.v, proved *)
From Coq Require Import NArith ZArith.
From mathcomp Require Import all_ssreflect all_algebra.
From mathcomp.zify Require Import ssrZ.
From PL1P Require Import Statement Rigid Walk Predicates Orbits Census ArchivePoint Regular Obstructed
  Minimal.
Set Implicit Arguments.
Unset Strict Implicit.
Unset Printing Implicit Defensive.

(** ** The flags of the census, by the stated predicates *)
Section Flags.
Variable s : signature.
Hypothesis bs : balanced s.
Let o := obstructed s.
Definition slow_flags : seq bool :=
  let l := representative label_orbit s in let w := representative merge_orbit s in
  [:: l; w; l && ~~ o; l && o; w && ~~ o; w && o; l && (~~ o && pl0p_by tot s);
    w && (~~ o && one_pin_by tot s);
      l && (~~ o && five_by tot s); w && (~~ o && five_by tot s)].
Lemma flagsE : flags s = slow_flags.
Proof.
have ss : size s = 27 by case/andP: bs => /eqP.
have imp := swap_label_top ss; rewrite (label_topE ss) (swap_topE ss) in imp.
rewrite /flags /slow_flags (label_topE ss) (swap_topE ss).
rewrite (obstructed_fast bs) (pl0p_fast bs) (one_pin_fast bs) (five_fast bs) -/o.
case: (representative label_orbit s) imp; case: (representative merge_orbit s) => imp; rewrite //= ?andbA //.
by have := imp isT.
Qed.
End Flags.

Lemma size_flags s : size (flags s) = 10.
Proof. by rewrite /flags; case: ifP. Qed.

Lemma counted j : j < 10 -> N.of_nat (count (fun s => nth false (slow_flags s) j) balanced_list) =
  nth N0 counts j.
Proof.
move=> j10; rewrite -censusE /census walkE; last by vm_compute.
have -> : foldl (fun acc s => bump (flags (rev (catrev s [::]))) acc) (nseq 10 N0) (sols ws 11) =
          foldl (fun acc s => bump (flags s) acc) (nseq 10 N0) balanced_list.
  rewrite /balanced_list; elim: (sols ws 11) (nseq 10 N0) => // s l IH acc.
  by rewrite [LHS]/= [RHS]/= IH -[catrev s [::]]/(rev s) revK.
rewrite (bumpE (k := 10)) //; last exact: size_flags.
have -> : nth N0 (nseq 10 N0) j = N0 by rewrite nth_nseq if_same.
rewrite N.add_0_l; apply: (congr1 N.of_nat); apply: eq_in_count => s sl.
by rewrite flagsE // -balanced_mem.
Qed.

Lemma classes_iff E (Q Q' : signature -> Prop) n : (forall s, Q s <-> Q' s) -> classes E Q n ->
  classes E Q' n.
Proof.
move=> e [reps [h1 h2 h3 h4 h5]]; exists reps; split=> //; first by move=> r /h3 /e.
by move=> s /e /h5.
Qed.

(** Properties that are decided by the portrait of a signature. *)
Definition by_portrait (q : seq nat -> bool) := forall s t, portrait s = portrait t -> q s = q t.

Lemma stable (orbit : seq nat -> seq (seq nat)) q : (forall s t, t \in orbit s -> size t = 27) ->
  (forall s t, t \in orbit s -> portrait t = portrait s) -> by_portrait q ->
  forall s t, t \in orbit s -> balanced s && q s -> balanced t && q t.
Proof.
move=> sz po pq s t ts /andP[bs qs]; have e := po s t ts.
rewrite (pq _ _ e) qs andbT balancedE (sz s t ts) eqxx /=.
by move: bs; rewrite balancedE => /andP[_ w]; case: e => -> _ _ _ _.
Qed.

Lemma label_nonempty s : label_orbit s != [::]. Proof. by []. Qed.
Lemma merge_nonempty s : merge_orbit s != [::]. Proof. by []. Qed.

Lemma label_classes (Q : signature -> Prop) q n : (forall s, balanced s -> reflect (Q s) (q s)) ->
  by_portrait q ->
  N.of_nat (count (fun s => representative label_orbit s && q s) balanced_list) = n ->
  classes label_equiv (fun s => balanced s /\ Q s) n.
Proof.
move=> qP pq; apply: (classesP label_orbit_size label_nonempty label_orbit_same).
- move=> s; case bs : (balanced s); last by constructor; case.
  by apply: (iffP (qP s bs)) => [|[]].
- exact: label_equiv_orbit.
- exact: (stable label_orbit_size portrait_label pq).
Qed.

Lemma swap_classes (Q : signature -> Prop) q n : (forall s, balanced s -> reflect (Q s) (q s)) ->
  by_portrait q ->
  N.of_nat (count (fun s => representative merge_orbit s && q s) balanced_list) = n ->
  classes swap_equiv (fun s => balanced s /\ Q s) n.
Proof.
move=> qP pq; apply: (classesP merge_orbit_size merge_nonempty merge_orbit_same).
- move=> s; case bs : (balanced s); last by constructor; case.
  by apply: (iffP (qP s bs)) => [|[]].
- exact: swap_equivE.
- exact: (stable merge_orbit_size portrait_swap pq).
Qed.

Lemma and_reflect (A B : Prop) a b : reflect A a -> reflect B b -> reflect (A /\ B) (a && b).
Proof. by move=> ra rb; apply: (iffP andP) => -[/ra ? /rb ?]. Qed.

Lemma portrait_obstructed s t : portrait s = portrait t -> obstructed s = obstructed t.
Proof. by rewrite !obstructedE; case. Qed.
Lemma pp_true : by_portrait (fun _ => true). Proof. by []. Qed.
Lemma pp_obs : by_portrait obstructed. Proof. exact: portrait_obstructed. Qed.
Lemma pp_min : by_portrait (fun s => ~~ obstructed s). Proof. by move=> s t /portrait_obstructed ->. Qed.
Lemma pp_pl0p : by_portrait (fun s => ~~ obstructed s && pl0p_by tot s).
Proof. by move=> s t e; rewrite (portrait_obstructed e); case: e => _ _ -> _ _. Qed.
Lemma pp_one : by_portrait (fun s => ~~ obstructed s && one_pin_by tot s).
Proof. by move=> s t e; rewrite (portrait_obstructed e); case: e => _ _ _ -> _. Qed.
Lemma pp_five : by_portrait (fun s => ~~ obstructed s && five_by tot s).
Proof. by move=> s t e; rewrite (portrait_obstructed e); case: e => _ _ _ _ ->. Qed.

Lemma balanced_walk : walk (fun _ _ st => st) (fun _ (_ : unit) acc => N.succ acc) ws 0 11 tt [::] N0 =
  845161%num.
Proof. vm_cast_no_check (erefl 845161%num). Qed.
Lemma foldl_succ (l : seq (seq nat)) n : foldl (fun acc _ => N.succ acc) n l = N.add n (N.of_nat (size l)).
Proof.
elim: l n => [|s l IH] n; first by rewrite N.add_0_r.
by rewrite [foldl _ _ _]/= IH [size _]/= Nnat.Nat2N.inj_succ N.add_succ_l N.add_succ_r.
Qed.
Lemma balanced_count : N.of_nat (size balanced_list) = 845161%num.
Proof.
have h : foldl (fun acc (_ : seq nat) => N.succ acc) N0 balanced_list = 845161%num.
  have := balanced_walk; rewrite walkE; last by vm_compute.
  exact: id.
have e := foldl_succ balanced_list N0; rewrite N.add_0_l in e.
exact: (etrans (esym e) h).
Qed.

(** What has an orbit in common is equivalent. *)
Lemma orbit_equivalence (E : signature -> signature -> Prop) (orbit : seq nat -> seq (seq nat)) :
  (forall s t, balanced s -> balanced t -> E s t <-> orbit s =i orbit t) -> equivalence E.
Proof.
move=> e; split=> [s bs|s t bs bt /(e _ _ bs bt) h|s t u bs bt bu /(e _ _ bs bt) h1 /(e _ _ bt bu) h2].
- exact/(e _ _ bs bs).
- by apply/(e _ _ bt bs) => w; rewrite h.
- by apply/(e _ _ bs bu) => w; rewrite h1.
Qed.

(** ** Over a field F of characteristic 0 *)
Section Over.
Variable F : fieldType.
Hypothesis char0 : [char F]%R =i pred0.

Lemma minP s : balanced s -> reflect (minimal F (problem_of s)) (~~ obstructed s).
Proof. by move=> bs; apply: (iffP idP) => /(minimal_iff char0 bs). Qed.
Lemma notminP s : balanced s -> reflect (~ minimal F (problem_of s)) (obstructed s).
Proof.
move=> bs; apply: (iffP idP) => [ob /(minimal_iff char0 bs)|h]; first by rewrite ob.
by apply/negPn/negP => /(minimal_iff char0 bs).
Qed.

Lemma classified : classification_over F.
Proof.
have andA (A B D : Prop) : A /\ (B /\ D) <-> (A /\ B) /\ D by tauto.
split.
- split.
  + exact: (label_classes minP pp_min (@counted 2 isT)).
  + exact: (label_classes notminP pp_obs (@counted 3 isT)).
  + exact: (swap_classes minP pp_min (@counted 4 isT)).
  + exact: (swap_classes notminP pp_obs (@counted 5 isT)).
- split.
  + apply: (classes_iff (fun s => andA _ _ _)); apply: (label_classes _ pp_pl0p);
      last exact: (@counted 6 isT).
    by move=> s bs; exact: and_reflect (minP bs) (pl0p_byE s).
  + apply: (classes_iff (fun s => andA _ _ _)); apply: (swap_classes _ pp_one); last exact: (@counted 7 isT).
    by move=> s bs; exact: and_reflect (minP bs) (one_pin_byE s).
  + apply: (classes_iff (fun s => andA _ _ _)); apply: (label_classes _ pp_five);
      last exact: (@counted 8 isT).
    by move=> s bs; exact: and_reflect (minP bs) (five_byE s).
  + apply: (classes_iff (fun s => andA _ _ _)); apply: (swap_classes _ pp_five); last exact: (@counted 9 isT).
    by move=> s bs; exact: and_reflect (minP bs) (five_byE s).
Qed.
End Over.

Theorem main_theorem : classification.
Proof.
have true_iff s : balanced s /\ True <-> balanced s by tauto.
have rT s : balanced s -> reflect True true by move=> _; constructor.
split.
- by split; [exact: (orbit_equivalence label_equiv_orbit) | exact: (orbit_equivalence swap_equivE)].
- split.
  + exists balanced_list; split.
    * exact: balanced_count.
    * exact: balanced_uniq.
    * by move=> s; rewrite balanced_mem.
    * by move=> s t _ _.
    * by move=> s bs; exists s => //; rewrite balanced_mem.
  + apply: (classes_iff true_iff); apply: (label_classes rT pp_true).
    apply: etrans (@counted 0 isT); apply: (congr1 N.of_nat); by apply: eq_count => s; rewrite andbT.
  + apply: (classes_iff true_iff); apply: (swap_classes rT pp_true).
    apply: etrans (@counted 1 isT); apply: (congr1 N.of_nat); by apply: eq_count => s; rewrite andbT.
- exact: classified.
Qed.

Theorem rigidity_theorem : rigidity.
Proof.
have only_if (R : idomainType) (C : view -> camera R) scene s : shape scene s -> balanced s -> obstructed s ->
    admissible C scene -> ~ rigid C scene.
  by move=> sh bs ob ad; exact: (obstructed_not_rigid sh ad bs ob).
split; [by move=> F char0 s bs; exact: minimal_iff | split=> // s bs]; split;
  first exact: (regular_rigid archive_checked).
by case=> C [scene [sh ad rg]]; apply/negP => ob; exact: only_if sh bs ob ad rg.
Qed.
