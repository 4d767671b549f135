(** * A verdict that is computed, and proved

    [verdict A] says whether A is minimal: by counting degrees of freedom, and how often each of the
    27 features occurs when the pins that two views determine are forgotten. [judge s] is the
    verdict on what the text s stands for: the program plcoq computes it. *)
From Coq Require Import String List.
From mathcomp Require Import all_ssreflect all_algebra.
From mathcomp.zify Require Import zify.
From PL1P Require Import Statement Rigid Reducible Problems Reductions Forget Reduction Embedding Scenes
  SameProblem Minimal ProblemClasses Theorem1 OneReduction Determined Text
  Reader.
Set Implicit Arguments.
Unset Strict Implicit.
Unset Printing Implicit Defensive.

(** Unbalanced: images, and cameras with scene, differ in degrees of freedom. Loose: to forget
    something of a feature takes more degrees of freedom from space than from the images.
    Other_feature: none of these, but a feature is not one of the 27; no verdict. *)
Inductive answer := Minimal | Unbalanced | Loose | Obstructed | Other_feature | Not_read.
Definition without f j : selection := (true, rem j (iota 0 (pins f))).
Definition choices f := if pins f <= 2 then pairs (pins f) else [seq without f j | j <- iota 0 (pins f)].
Definition loose f := has (fun c => feasible f c && (cost f c < dim3 f)) (choices f).
Definition signature_by (ks : seq nat) : signature := mkseq (fun i => count_mem i ks) 27.
Definition answer_to (A : problem) : answer :=
  if sumn [seq dim2 f | f <- A] != parameters A then Unbalanced else
  let ks := [seq index_of f | f <- A] in
  if all (fun k => k < 27) ks then if obstructed (signature_by ks) then Obstructed else Minimal
  else if has loose A then Loose else Other_feature.
(** Without the pins that two views determine. *)
Definition verdict (A : problem) : answer :=
  if sumn [seq dim2 f | f <- A] != parameters A then Unbalanced else answer_to (lighten A).
Definition judge (s : string) : answer := if parse s is Some A then verdict A else Not_read.

(** ** What is proved *)
Definition right_answer F (a : answer) (A : problem) := match a with
  | Minimal => minimal F A | Unbalanced | Loose | Obstructed => ~ minimal F A
  | Other_feature => True | Not_read => False end.
Definition verdicts : Prop := forall F : fieldType, [char F]%R =i pred0 ->
  (forall A, is_problem A -> right_answer F (verdict A) A) /\
  (forall s, if judge s is Not_read then forall A, ~ means s A
     else (exists A, means s A) /\ forall A, means s A -> right_answer F (judge s) A).

Lemma signature_byE A : signature_by [seq index_of f | f <- A] = signature_of A.
Proof. by apply: eq_map => i; rewrite count_map. Qed.
Lemma all2_same_problem A B : all2 same A B -> same_problem A B.
Proof. by exists A => //; exact: Permutation.Permutation_refl. Qed.
Lemma loose_selection A : is_problem A -> has loose A -> exists2 cs, selects A cs &
  sumn [seq cost fc.1 fc.2 | fc <- zip A cs] < sumn [seq dim3 f | f <- A].
Proof.
elim: A => // f A IH /andP[pf pA] /orP[lf|/(IH pA)[cs h1 h2]].
  have [c /andP[fc lt]] : exists c, feasible f c && (cost f c < dim3 f).
    by move: lf; rewrite /loose => /hasP[c _ h]; exists c.
  have [h1 h2] := selects_everything pA.
  by exists (c :: map everything A); [rewrite selects_cons fc | rewrite /= -addSn leq_add].
have [e1 _ e3] := everything_ok pf; exists (everything f :: cs); first by rewrite selects_cons e1.
by rewrite /= -addnS leq_add.
Qed.

Lemma same_dims f g : same f g -> dim2 f = dim2 g /\ dim3 f = dim3 g.
Proof.
move=> /sameP[e1 e2 [r _ h]]; split; last by rewrite /dim3 e1 e2.
by apply: (congr1 sumn); apply: eq_map => v; have /andP[/eqP e /perm_size] := h v;
  rewrite size_map /sees_point /sees_pins e => ->.
Qed.
Lemma same_sum (h : feature -> nat) A B : (forall f g, same f g -> h f = h g) -> same_problem A B ->
  sumn [seq h f | f <- A] = sumn [seq h f | f <- B].
Proof.
move=> hs [A' AA' A'B]; transitivity (sumn [seq h f | f <- A']).
  by elim: AA' => //= [f l l' _ ->|f g l|l l' l'' _ -> _ ->] //; rewrite addnCA.
by elim: A' B A'B {AA'} => [|f A' IH] [|g B] //= /andP[/hs -> /IH ->].
Qed.

Section Over.
Variable F : fieldType.
Hypothesis char0 : [char F]%R =i pred0.
Lemma loose_not_minimal A : is_problem A -> has loose A -> ~ minimal F A.
Proof.
move=> pA /(loose_selection pA)[cs sel lt] mA.
by have := minimal_tight char0 pA mA sel; rewrite leqNgt lt.
Qed.
Lemma answer_toP A : is_problem A -> right_answer F (answer_to A) A.
Proof.
move=> pA; rewrite /answer_to; case: eqP => [bA|nb] /=; last by move=> /(balanced_dominant char0)[].
rewrite all_map; case kA: (all _ A); last by case lA: (has loose A) => //; exact: loose_not_minimal.
rewrite signature_byE.
have sm := same_minimal char0 pA (problem_of_proper _) (known_same kA).
have bs : balanced (signature_of A).
  have ks := known_same kA; rewrite balancedP ?size_mkseq // /parameters.
  rewrite -(same_sum _ ks) => [|f g /same_dims[]//]; rewrite -(same_sum _ ks) => [|f g /same_dims[]//].
  exact/eqP.
case ob: (obstructed _); first by move/sm/(minimal_iff char0 bs); rewrite ob.
by apply/sm/(minimal_iff char0 bs); rewrite ob.
Qed.
Lemma right_iff a A B : (minimal F A <-> minimal F B) -> right_answer F a B -> right_answer F a A.
Proof. by move=> AB; case: a => //=; rewrite AB. Qed.
Lemma verdictP A : is_problem A -> right_answer F (verdict A) A.
Proof.
move=> pA; rewrite /verdict; case: eqP => [bA|nb] /=; last by move=> /(balanced_dominant char0)[].
exact: (right_iff (minimal_lighter char0 pA bA) (answer_toP (lighten_proper pA))).
Qed.
End Over.

Theorem verdicts_theorem : verdicts.
Proof.
move=> F char0; split=> [A|s]; first exact: verdictP.
have [r1 r2 _] := reader_theorem; rewrite /judge; case e: (parse s) => [A|]; last first.
  by move=> A /r2[B]; rewrite e.
have [mA pA] := r1 _ _ e; have vA := verdictP char0 pA; suff h : (exists A, means s A) /\
    forall B, means s B -> right_answer F (verdict A) B by case: (verdict A) h vA.
split=> [|B mB]; first by exists A.
have [A' e' BA] := r2 _ _ mB; move: e'; rewrite e => -[AA']; rewrite -AA' in BA.
exact: (right_iff (same_minimal char0 (means_problem mB) pA (all2_same_problem BA))).
Qed.
