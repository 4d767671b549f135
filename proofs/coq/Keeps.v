(** * Reduction keeps minimality

    The images of what is kept, and those of what is forgotten, determine all images, and are
    determined by them: a derivation kills the ones if and only if it kills the others
    ([kept_lost]). So if A is minimal, these are n independent elements, and what is kept is minimal
    by counting. Conversely, if what is kept is minimal, a derivation that kills the images of A
    kills what is kept and the images of what is forgotten. By the lifting property these are
    independent, so it is zero. *)
From mathcomp Require Import all_ssreflect all_algebra.
From mathcomp.algebra_tactics Require Import ring.
From mathcomp.zify Require Import zify.
From SsrMultinomials Require Import mpoly.
From PL1P Require Import Statement Reducible Problems Forget Derivations RationalFunctions Independence
  Generic.
From PL1P Require Import Lifting Reduction Embedding Scenes.
Set Implicit Arguments.
Unset Strict Implicit.
Unset Printing Implicit Defensive.
Import GRing.Theory.
Local Open Scope ring_scope.

(** ** The images of what is kept *)
Section Kept.
Variable K : fieldType.
Notation placed := (feature * (nat -> K))%type.
Implicit Types (fx : placed) (x : nat -> K) (c : selection) (C : camera K).
Definition kept_image fx c C (l : look) : seq K := let X := point_at fx.1 fx.2 in
  (if l.1 && c.1 then point_image (project C X) else [::]) ++
  flatten [seq line_image (l.1 && c.1) (normal C X (dir_at fx.1 fx.2 j)) | j <- l.2 & j \in c.2].
Definition kept_feature fx c : placed := (keep fx.1 c, nth 0 (kept_parameters fx c)).

Lemma nth_pairs (u w : nat -> K) l i : (i < size l)%N -> let s := flatten [seq [:: u j; w j] | j <- l] in
  nth 0 s (2 * i) = u (nth 0%N l i) /\ nth 0 s (2 * i).+1 = w (nth 0%N l i).
Proof. by elim: l i => // j l IH [|i] lt; rewrite ?mulnS //; exact: IH. Qed.
Lemma point_kept f x c : point_at (keep f c) (nth 0 (kept_parameters (f, x) c)) = let X := point_at f x in
  if c.1 then X else add X (scale (- x3 X) (dir_at f x (head 0%N c.2))).
Proof.
rewrite {1}/point_at /kept_parameters; set X := point_at _ _; set Y := if c.1 then _ else _.
have fE : free (keep f c) = free f || ~~ c.1 by [].
rewrite -[RHS]/Y [(f, x).1]/= fE; have : (free f || ~~ c.1 -> x3 Y = 0) by
  rewrite /Y; case: (c.1) => /=; rewrite ?orbF ?orbT ?mulr1 ?subrr // /X /point_at /= => ->.
by case: (free f || ~~ c.1) => [/(_ isT)|_]; case: (Y) => y1 y2 y3 //= ->.
Qed.
Lemma dir_kept f x c i : (i < size c.2)%N ->
  dir_at (keep f c) (nth 0 (kept_parameters (f, x) c)) i = dir_at f x (nth 0%N c.2 i).
Proof.
move=> lt; have [e1 e2] := nth_pairs (fun j => x1 (dir_at f x j)) (fun j => x2 (dir_at f x j)) lt.
rewrite {1}/dir_at; set o := (if free (keep f c) then 2 else 3)%N; set s := kept_parameters _ _.
have e k : nth 0 s (o + k) = nth 0 (flatten [seq [:: x1 (dir_at f x j); x2 (dir_at f x j)] | j <- c.2]) k.
  rewrite /s /kept_parameters /o nth_cat -/(keep f c) [(f, x).1]/= [(f, x).2]/=.
  by case: (free (keep f c)); rewrite /= ?addnS ?ltnNge ?leq_addr //= ?subSS ?add0n ?subn0.
by rewrite -addnS !e e1 e2.
Qed.
Lemma slide_kept f x c C j : c.1 || (size c.2 <= 1)%N -> j \in c.2 -> let X := point_at f x in
  normal C (if c.1 then X else add X (scale (- x3 X) (dir_at f x (head 0%N c.2)))) (dir_at f x j) =
  normal C X (dir_at f x j).
Proof.
move=> fc jc; case c1: (c.1) fc => //= fc; have -> : head 0%N c.2 = j.
  by move: jc fc; case: (c.2) => [|i [|]] //=; rewrite inE => /eqP ->.
by rewrite -normal_slide.
Qed.
Lemma image_kept fx c C v : feasible fx.1 c ->
  image (kept_feature fx c) C (looks (keep fx.1 c) v) = kept_image fx c C (looks fx.1 v).
Proof.
case: fx => f x /and3P[uc ac fc]; rewrite /image /kept_feature point_kept /kept_image; congr (_ ++ _).
  by rewrite /= /sees_point; case: ((looks f v).1) => //=; case: (c.1).
rewrite -[(looks (keep f c) v).2]/[seq index j c.2 | j <- sees_pins f v & j \in c.2] -map_comp.
congr flatten; apply/eq_in_map => j; rewrite mem_filter => /andP[jc _].
by rewrite /= dir_kept ?index_mem // nth_index // slide_kept.
Qed.
Lemma nothing_kept fx c C v : proper fx.1 -> nothing (keep fx.1 c) -> kept_image fx c C (looks fx.1 v) = [::].
Proof.
case: fx => f x pf; rewrite /nothing /= => /andP[fr /eqP/size0nil e].
have [_ _ sp] := properP v pf; rewrite /kept_image e [X in map _ X](_ : _ = [::]) ?cats0; last first.
  by rewrite -[RHS](filter_pred0 (looks f v).2); apply: eq_filter => j; rewrite in_nil.
move: fr sp; rewrite /sees_point /=; case: (free f) => /=; first by move=> _ /negbTE ->.
by move=> /negbTE ->; rewrite andbF.
Qed.
End Kept.

(** ** What a derivation kills *)
Section Killed.
Variables (F K : fieldType) (c0 : {rmorphism F -> K}) (D : K -> K).
Hypothesis hD : derivation c0 D.
Notation Z a := (D a = 0).
Lemma line_other (n x : vec K) : x2 n != 0 -> x3 n != 0 -> x3 x != 0 -> dot n x = 0 -> Z (x1 x / x3 x) ->
  (Z (x2 x / x3 x) /\ Z (x1 n / x2 n)) <-> (Z (x1 n / x3 n) /\ Z (x2 n / x3 n)).
Proof.
move=> n2 n3 m3 e h1.
have e3 : x3 n = - (x1 n * (x1 x / x3 x) + x2 n * (x2 x / x3 x)).
  apply: (mulIf m3); rewrite -[LHS](addr0 _) -[0 in LHS]oppr0 -e /dot; field; exact: m3.
split=> [[h2 h]|[h h']].
  have h3 : Z (x3 n / x2 n).
    have -> : x3 n / x2 n = - (x1 n / x2 n * (x1 x / x3 x) + x2 x / x3 x) by rewrite e3; field; rewrite m3 n2.
    by apply: (zN hD); apply: (zD hD) => //; exact: (zM hD).
  have -> : x1 n / x3 n = x1 n / x2 n / (x3 n / x2 n) by field; rewrite n2 n3.
  have -> : x2 n / x3 n = (x3 n / x2 n)^-1 by field; rewrite n2 n3.
  by split; [apply: (zM hD) => //; exact: (zV hD) | exact: (zV hD)].
have -> : x1 n / x2 n = x1 n / x3 n / (x2 n / x3 n) by field; rewrite n2 n3.
have -> : x2 x / x3 x = - (1 + x1 n / x3 n * (x1 x / x3 x)) / (x2 n / x3 n).
  apply: (mulIf (x := x2 n / x3 n)); first by rewrite mulf_neq0 ?invr_neq0.
  rewrite divfK ?mulf_neq0 ?invr_neq0 //; apply: (mulIf (mulf_neq0 n3 m3)).
  transitivity (x2 n * x2 x); first by field; rewrite n3 m3.
  transitivity (- (x3 n * x3 x + x1 n * x1 x)); last by field; rewrite n3 m3.
  by apply/eqP; rewrite -addr_eq0; apply/eqP; rewrite -[RHS]e /dot; ring.
split; last by apply: (zM hD) => //; exact: (zV hD).
apply: (zM hD); last exact: (zV hD).
by apply: (zN hD); apply: (zD hD); [exact: (der1 hD) | exact: (zM hD)].
Qed.

(** Not generic: a point at infinity in a view, or a line in special position. *)
Definition regular_at f (x : nat -> K) (C : view -> camera K) := free f = false ->
  forall v, x3 (project (C v) (point_at f x)) != 0 /\ forall j, (j < pins f)%N ->
    let n := normal (C v) (point_at f x) (dir_at f x j) in x2 n != 0 /\ x3 n != 0.
Lemma killed_one a : killed D [:: a] <-> Z a.
Proof. by rewrite /killed /= andbT; split=> /eqP. Qed.
Lemma killed_two a b : killed D [:: a; b] <-> Z a /\ Z b.
Proof. by rewrite /killed /= andbT; split=> [/andP[/eqP ? /eqP ?]|[-> ->]] //; rewrite eqxx. Qed.
Lemma kept_lost f x c v C : proper f -> feasible f c -> regular_at f x C ->
  killed D (image (f, x) (C v) (looks f v)) =
  killed D (kept_image (f, x) c (C v) (looks f v)) && killed D (lost_image (f, x) c (C v) (looks f v)).
Proof.
move=> pf /and3P[uc ac fc] rg; have [u /allP le sp] := properP v pf.
rewrite /lost_image /image /kept_image /= !killed_cat !killed_flatten -/(sees_point f v) -/(sees_pins f v).
set X := point_at f x; pose n j := normal (C v) X (dir_at f x j); pose q := project (C v) X.
pose line p j := killed D (line_image p (n j)).
have split_lines p : all (line p) (sees_pins f v) =
    all (line p) [seq j <- sees_pins f v | j \in c.2] && all (line p) [seq j <- sees_pins f v | j \notin c.2].
  by rewrite -all_cat; apply: perm_all; rewrite perm_sym; apply: permEl; exact: perm_filterC.
rewrite -/(line _) split_lines.
case p: (sees_point f v) sp => sp /=; last by [].
have fr : free f = false by move: sp; case: (free f).
have [q3 nn] := rg fr v; case c1: (c.1) fc => fc /=; first by rewrite andbA.
case: ifP => [/hasP[j jl jc]|/negbT none].
  have only i : i \in c.2 -> i = j.
    by move: jc fc; case: (c.2) => [|k [|]] //=; rewrite !inE => /eqP -> _ /eqP.
  have flt : [seq i <- sees_pins f v | i \in c.2] = [:: j].
    apply: perm_small_eq => //; apply: uniq_perm; rewrite ?filter_uniq // => i.
    rewrite mem_filter !inE; apply/andP/eqP => [[/only]|->] //.
  rewrite flt /= !andbT; have [n2 n3] := nn j (le j jl).
  have e0 : dot (n j) q = 0 by rewrite /n /normal /dot /cross /q /=; ring.
  have h := line_other n2 n3 q3 e0; apply/and3P/and3P => -[/andP[/eqP h1 /eqP h2] h3 rest].
    have [z1 z2] := (h h1).1 (conj h2 ((killed_one _).1 h3)).
    by split=> //; [apply/andP; split; apply/eqP; [exact: z1 | exact: z2] | exact/eqP].
  have [z2 z3] := (h (elimT eqP h3)).2 (conj h1 h2).
  split=> //; last exact/killed_one.
  by apply/andP; split; [exact: h3 | apply/eqP; exact: z2].
have flt : [seq i <- sees_pins f v | i \in c.2] = [::].
  by apply/eqP; rewrite -[_ == _]negbK -has_filter.
by rewrite flt.
Qed.
End Killed.
