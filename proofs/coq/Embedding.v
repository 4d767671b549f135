(** * Any independent elements may serve as parameters

    K is the field of rational functions in n parameters over F. Let L be a field over F, and let n
    elements of L be independent. Then K embeds in L, parameters to these elements. Independence is
    the same in K and in L, and the images of a scene go to the images of a scene. *)
From mathcomp Require Import all_ssreflect all_algebra.
From SsrMultinomials Require Import mpoly.
From PL1P Require Import Statement Reducible Derivations RationalFunctions Independence Generic Reduction.
Set Implicit Arguments.
Unset Strict Implicit.
Unset Printing Implicit Defensive.
Import GRing.Theory.
Local Open Scope ring_scope.

(** ** A morphism that kills nothing extends to fractions *)
Section Extend.
Variables (R : idomainType) (L : fieldType) (f : {rmorphism R -> L}).
Hypothesis f0 : forall p, (f p == 0) = (p == 0).
Notation frac := (@FracField.tofrac R).
Definition extend (u : {fraction R}) : L := f (numerator u) / f (denominator u).
Lemma extendE p q : q != 0 -> extend (frac p / frac q) = f p / f q.
Proof.
move=> q0; rewrite /extend; set u := frac p / frac q; have d0 := den_neq0 u.
have : frac (numerator u) / frac (denominator u) = frac p / frac q by rewrite -fractionE.
move/eqP; rewrite eqr_div ?tofrac_eq0 //; last by rewrite -(tofrac_eq0 (denominator u)).
rewrite -!rmorphM -subr_eq0 -rmorphB tofrac_eq0 subr_eq0 => /eqP e; apply/eqP.
by rewrite eqr_div ?f0 // -?rmorphM ?e // -(tofrac_eq0 (denominator u)).
Qed.
Lemma extend_frac p : extend (frac p) = f p.
Proof. by have := @extendE p 1 (oner_neq0 _); rewrite !rmorph1 !divr1. Qed.
Lemma extend_is_rmorphism : rmorphism extend.
Proof.
have nd u : exists pq : R * R, pq.2 != 0 /\ u = frac pq.1 / frac pq.2.
  by exists (numerator u, denominator u); split; [rewrite -tofrac_eq0 den_neq0 | exact: fractionE].
split=> [u w|]; last split=> [u w|]; last by rewrite -(rmorph1 [rmorphism of frac]) extend_frac rmorph1.
- case: (nd u) => -[p q] [/= q0 ->]; case: (nd w) => -[r s] [/= s0 ->].
  rewrite -mulNr addf_div ?tofrac_eq0 // -!(rmorphN, rmorphM, rmorphD) !extendE ?mulf_neq0 //.
  by rewrite !(rmorphN, rmorphM, rmorphD) -[in RHS]mulNr addf_div ?f0.
- case: (nd u) => -[p q] [/= q0 ->]; case: (nd w) => -[r s] [/= s0 ->].
  by rewrite mulf_div -!rmorphM !extendE ?mulf_neq0 // !rmorphM mulf_div.
Qed.
End Extend.

(** ** The images of a scene, with any parameters *)
Definition views_of (K : fieldType) (C : view -> camera K) (fx : feature * (nat -> K)) :=
  flatten [seq image fx (C v) (looks fx.1 v) | v <- views].
Definition images_at (K : fieldType) (x : nat -> K) A :=
  flatten [seq views_of (cameras_at K x) fx | fx <- scene x 11 A].
Section Natural.
Variables (K L : fieldType) (g : {rmorphism K -> L}).
Lemma point_image_map x : point_image (gvec g x) = map g (point_image x).
Proof. by rewrite /= !fmorph_div. Qed.
Lemma line_image_map p n : line_image p (gvec g n) = map g (line_image p n).
Proof. by case: p; rewrite /= !fmorph_div. Qed.
Lemma image_map f (x : nat -> K) (x' : nat -> L) C l : (forall k, x' k = g (x k)) ->
  image (f, x') (gcamera g C) l = map g (image (f, x) C l).
Proof.
move=> gx; have eX : point_at f x' = gvec g (point_at f x).
  by rewrite /gvec /point_at /= !gx; case: (free f); rewrite ?rmorph0.
have ed j : dir_at f x' j = gvec g (dir_at f x j) by rewrite /gvec /dir_at /= !gx rmorph1.
rewrite /image /= map_cat map_flatten -map_comp eX -gproject; congr (_ ++ _).
  by case: (l.1); rewrite // point_image_map.
by congr flatten; apply: eq_map => j /=; rewrite ed -gnormal line_image_map.
Qed.
Lemma images_map (x : nat -> K) (x' : nat -> L) A : (forall k, x' k = g (x k)) ->
  images_at x' A = map g (images_at x A).
Proof.
move=> gx; rewrite /images_at map_flatten; congr flatten.
elim: A 11%N => // f A IH o; rewrite [LHS]/= [RHS]/= -IH; congr (_ :: _).
rewrite /views_of map_flatten -map_comp; congr flatten; apply: eq_map => v /=.
by rewrite (gcameras gx); apply: image_map => k; exact: gx.
Qed.
End Natural.

(** ** The embedding *)
Section Embedding.
Variables (F L : fieldType) (c : {rmorphism F -> L}) (s : seq L).
Notation n := (size s).
Notation K := [fieldType of {fraction {mpoly F[n]}}].
Hypothesis hs : ind c s.
Let ev := mmap_rmorphism (fun i : 'I_n => nth 0 s i) c.
Lemma ev0 p : (ev p == 0) = (p == 0).
Proof. by apply/eqP/eqP => [/hs|->]; rewrite ?rmorph0. Qed.
Definition embed : {rmorphism K -> L} := RMorphism (extend_is_rmorphism ev0).
Lemma embed_C a : embed (const (to F n) a) = c a.
Proof. by rewrite -[LHS]/(extend ev (FracField.tofrac _)) (extend_frac ev0) /= mmapC. Qed.
Lemma embed_param k : embed (generic F n k) = nth 0 s k.
Proof.
rewrite /generic; case: insubP => [i _ <-|].
  by rewrite -[LHS]/(extend ev (FracField.tofrac _)) (extend_frac ev0) /= mmapX mmap1U.
by rewrite -leqNgt => le; rewrite rmorph0 nth_default.
Qed.
Lemma embed_value m (y : 'I_m -> K) Q : value c (fun i => embed (y i)) Q = embed (value (const (to F n)) y Q).
Proof.
rewrite /value /mmap rmorph_sum; apply: eq_bigr => M _; rewrite rmorphM embed_C; congr (_ * _).
by rewrite rmorph_prod; apply: eq_bigr => i _; rewrite rmorphX.
Qed.
Lemma value_ext m (y z : 'I_m -> L) Q : y =1 z -> value c y Q = value c z Q.
Proof.
move=> e; rewrite /value /mmap; apply: eq_bigr => M _; congr (_ * _).
by apply: eq_bigr => i _; rewrite e.
Qed.
Lemma embed_ind (y : seq K) : ind c (map embed y) <-> ind (const (to F n)) y.
Proof.
have e : size (map embed y) = size y by exact: size_map.
have ye Q : value c (fun i : 'I_(size y) => nth 0 (map embed y) i) Q =
    embed (value (const (to F n)) (fun i : 'I_(size y) => nth 0 y i) Q).
  by rewrite -embed_value; apply: value_ext => i; rewrite (nth_map 0).
split=> [/(indE c e) iy|iy]; last apply/(indE c e); move=> Q v0; apply: iy.
  by rewrite ye; apply/eqP; rewrite fmorph_eq0; apply/eqP.
by apply/eqP; rewrite -(fmorph_eq0 embed) -ye; apply/eqP.
Qed.
End Embedding.

Lemma images_atE (F : fieldType) n A : images F n A = images_at (generic F n) A.
Proof. by []. Qed.

(** The images of A are independent if they are at some independent parameters. *)
Theorem anywhere (F L : fieldType) (c : {rmorphism F -> L}) (s : seq L) A : ind c s ->
  ind c (images_at (nth 0 s) A) <-> Statement.independent (images F (size s) A).
Proof.
move=> hs; rewrite (@images_map _ _ (embed hs) (generic F (size s))); first exact: embed_ind.
by move=> k; rewrite embed_param.
Qed.
