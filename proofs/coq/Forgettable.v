(** * Features of which something can always be forgotten

    The cameras are given. If images do not determine a feature (no view sees a pin or the point,
    one view sees a free line, ...), a line or all of it can be forgotten; so can a pin that at most
    two views see, with its point ([forgettable]). To see that what is kept and the images of what is
    lost are independent, add elements of K that fix the rest of the feature: slopes of pins in
    other views, or a coordinate. Only the zero derivation kills all these, and there are not more
    of them than parameters ([local_lifting]). *)
From Coq Require Import ZArith.
From mathcomp Require Import all_ssreflect all_algebra.
From mathcomp.algebra_tactics Require Import ring.
From mathcomp.zify Require Import zify.
From SsrMultinomials Require Import mpoly.
From PL1P Require Import Statement Reducible Forget Derivations RationalFunctions Independence.
From PL1P Require Import Generic Motion Lifting Reduction Embedding Scenes Keeps Theorem1.
From PL1P Require Import Determined Dangling Placed Terminal Lifts Recovered.
Set Implicit Arguments.
Unset Strict Implicit.
Unset Printing Implicit Defensive.
Import GRing.Theory.

(** ** All other features are kept *)
Lemma everything_kept f : proper f -> ~~ nothing (keep f (everything f)).
Proof.
move=> pf; rewrite /nothing /= orbF size_iota negb_and.
by case fr: (free f) => //=; rewrite (free_pins pf fr).
Qed.
Lemma everything_all A : is_problem A ->
  all (fun fc => feasible fc.1 fc.2) (zip A (map everything A)) /\
  sumn [seq cost fc.1 fc.2 | fc <- zip A (map everything A)] <= sumn [seq dim3 f | f <- A].
Proof.
elim: A => // g A IH /andP[pg /IH[h1 h2]] /=; have [e1 _ e3] := everything_ok pg.
by rewrite e1 h1 leq_add.
Qed.
Section Kept.
Variable K : fieldType.
Implicit Types (fx : feature * (nat -> K)) (l : seq (feature * (nat -> K) * selection)).
Notation kepts l := (flatten [seq kept_parameters fxc.1 fxc.2 |
  fxc <- l & ~~ nothing (keep fxc.1.1 fxc.2)]).
Lemma kepts_cons fx c l :
  kepts ((fx, c) :: l) = (if nothing (keep fx.1 c) then [::] else kept_parameters fx c) ++ kepts l.
Proof. by rewrite [filter _ (_ :: _)]/=; case: (nothing _). Qed.
Lemma everything_own (D : K -> K) x o A : is_problem A ->
  killed D (kepts (zip (scene x o A) (map everything A))) -> killed D (owns (scene x o A)).
Proof.
elim: A o => // g A IH o /andP[pg pA]; set gx := (g, fun k => x (o + k)).
have -> : owns (scene x o (g :: A)) = own gx ++ owns (scene x (o + dim3 g) A) by [].
have -> : zip (scene x o (g :: A)) (map everything (g :: A)) =
  (gx, everything g) :: zip (scene x (o + dim3 g) A) (map everything A) by [].
rewrite kepts_cons (negbTE (everything_kept pg)) ownE !(killed_cat D (kept_parameters gx _)).
by case/andP=> -> /IH ->.
Qed.
(** A derivation that kills what is kept and lost: if it kills the parameters of f, it kills all. *)
Definition instead (pre post : problem) c := map everything pre ++ c :: map everything post.
Lemma zip_instead T (s t : seq T) a pre post c : size s = size pre ->
  zip (s ++ a :: t) (instead pre post c) =
    zip s (map everything pre) ++ (a, c) :: zip t (map everything post).
Proof. by move=> e; rewrite zip_cat // size_map. Qed.
Lemma scene_owned (D : K -> K) (C : view -> camera K) x pre post f c :
  is_problem pre -> is_problem post ->
  let o := 11 + sumn [seq dim3 g | g <- pre] in let fx := (f, fun k => x (o + k)) in
  let sc := scene x 11 (pre ++ f :: post) in
  killed D (kepts (zip sc (instead pre post c))) ->
  killed D (flatten [seq flatten [seq lost_image fxc.1 fxc.2 (C v) (looks fxc.1.1 v) | v <- views] |
    fxc <- zip sc (instead pre post c)]) ->
  ((~~ nothing (keep f c) -> killed D (kept_parameters fx c)) ->
    (forall v, killed D (lost_image fx c (C v) (looks f v))) -> killed D (own fx)) ->
  killed D (owns sc).
Proof.
move=> p1 p2 o fx sc; have sE : sc = scene x 11 pre ++ fx :: scene x (o + dim3 f) post.
  by rewrite /sc scene_cat.
have sp : size (scene x 11 pre) = size pre by rewrite -(size_map fst) fst_scene.
have kc (s t : seq K) : killed D (s ++ t) = killed D s && killed D t by exact: all_cat.
rewrite sE (zip_instead _ _ _ _ sp) filter_cat !map_cat !flatten_cat.
rewrite (kc (flatten [seq kept_parameters _ _ | _ <- _])) => /andP[/(everything_own p1) k1 kk].
rewrite (kc (flatten [seq flatten _ | _ <- zip (scene x 11 pre) _])) => /andP[_].
rewrite -[flatten (map _ (_ :: _))]/(flatten _ ++ _) kc => /andP[kl _] rigid.
rewrite /owns map_cat flatten_cat kc -/(owns _) k1 -[flatten _]/(own fx ++ owns _) kc.
move: kk; rewrite kepts_cons killed_cat => /andP[k2 /(everything_own p2) ->].
rewrite andbT; apply: rigid.
  by move=> nn; move: k2; rewrite (negbTE nn).
by move=> v; move: kl; rewrite killed_flatten => /and4P[h1 h2 h3 _]; case: v.
Qed.
End Kept.
Lemma sums_le s t s' t' c d e : s <= s' -> t <= t' -> c + e <= d ->
  11 + (s + (c + t)) + e <= 11 + (s' + (d + t')).
Proof. by lia. Qed.

Local Open Scope ring_scope.

(** ** Vectors, and what derivations kill *)
Section Kills.
Variables (F K : fieldType) (c0 : {rmorphism F -> K}) (D : K -> K).
Hypothesis hD : derivation c0 D.
Variables (f : feature) (x : nat -> K).
Notation X := (point_at f x).
Notation d := (dir_at f x).
Lemma three_solve (p q r v : vec K) : dot p (cross q r) != 0 -> dot p v = 0 -> dot q v = 0 ->
  dot r v = 0 -> v = vec0 K.
Proof.
move=> h e1 e2 e3; apply: (scale_solve h).
transitivity (add (scale (dot p v) (cross q r))
  (add (scale (dot q v) (cross r p)) (scale (dot r v) (cross p q)))).
  by rewrite /add /scale /dot /cross /=; congr Vec; ring.
by rewrite e1 e2 e3 /add /scale /vec0 !mul0r !addr0.
Qed.
Lemma dot3 (v : vec K) : dot (@Vec K 0 0 1) v = x3 v.
Proof. by rewrite /dot /= !mul0r !add0r mul1r. Qed.
Lemma scale1 (v : vec K) : scale 1 v = v.
Proof. by case: v => v1 v2 v3; rewrite /scale /= !mul1r. Qed.
Lemma scale0 (v : vec K) : scale 0 v = vec0 K.
Proof. by rewrite /scale !mul0r. Qed.
Lemma killed_three a b c : killed D [:: a; b; c] -> [/\ D a = 0, D b = 0 & D c = 0].
Proof. by case/and4P=> /eqP ? /eqP ? /eqP ? _. Qed.
Lemma kept_point s : free f = false -> killed D (kept_parameters (f, x) (true, s)) ->
  dead D X /\ forall i, i \in s -> dead D (d i).
Proof.
move=> nf; have fE : free (keep f (true, s)) = false by rewrite /= nf.
rewrite /kept_parameters killed_cat killed_flatten fE.
case/andP=> /and4P[/eqP h1 /eqP h2 /eqP h3 _] /allP h.
by split=> // i /h /and3P[/eqP e1 /eqP e2 _]; split=> //; exact: (der1 hD).
Qed.
Lemma kept_line i : killed D (kept_parameters (f, x) (false, [:: i])) ->
  dead D (d i) /\ dvec D X = scale (D (x3 X)) (d i).
Proof.
have fE : free (keep f (false, [:: i])) by rewrite /= orbT.
rewrite /kept_parameters killed_cat killed_flatten fE.
case/andP=> /and3P[/eqP h1 /eqP h2 _] /andP[/and3P[/eqP e1 /eqP e2 _] _].
have hd : dead D (d i) by split=> //; exact: (der1 hD).
split=> //; move: h1 h2 e1 e2; rewrite [head _ _]/= [(_, _).1]/= [(_, _).2]/=.
have : x3 (d i) = 1 by [].
move: X (d i) => [a b e] [p q r] /=.
rewrite !(derD hD) !(derM hD) !(derN hD) /dvec /scale /= => -> + + e1 e2.
rewrite e1 e2 !mulr0 !addr0 !mulNr => /eqP + /eqP.
by rewrite !subr_eq0 mulr1 => /eqP -> /eqP ->.
Qed.
Lemma lost_pin c C l i : i \in l.2 -> i \notin c.2 -> killed D (lost_image (f, x) c C l) ->
  killed D (line_image l.1 (normal C X (d i))).
Proof.
move=> il ic; rewrite /lost_image killed_cat killed_flatten => /andP[_ /allP h]; apply: h.
by rewrite mem_filter ic il.
Qed.
Lemma lost_all C l : lost_image (f, x) (false, [::]) C l = image (f, x) C l.
Proof.
rewrite /lost_image /image andbT (eq_has (a2 := pred0)) // has_pred0.
by rewrite (eq_filter (a2 := predT)) // filter_predT.
Qed.
End Kills.

(** ** At generic parameters *)
Section Generic.
Variables (F : fieldType) (n o : nat) (f : feature).
Hypothesis char0 : [char F] =i pred0.
Hypothesis o11 : (11 <= o)%N.
Hypothesis room : (o + dim3 f <= n)%N.
Hypothesis nf : free f = false.
Notation K := [fieldType of {fraction {mpoly F[n]}}].
Notation C := (cameras_at K (generic F n)).
Notation x := (fun k => generic F n (o + k)%N).
Notation X := (point_at f x).
Notation d := (dir_at f x).
Notation pl w i := (plane_of (C w) X (d i)).
(** These vectors and polynomials are not zero. *)
Lemma ray_third u : x3 (ray_of (C u) X) != 0.
Proof.
apply: (not_zero char0 o11 room (e := fun R C (x : nat -> R) => x3 (ray_of (C u) (point_at f x)))).
  by move=> R R' g C0 C' x0 x' hC hx; rewrite hC (gpoint hx) gray.
by rewrite /point_at nf; case: u; vm_compute.
Qed.
Lemma pin_off_plane w i j : (i < pins f)%N -> (j < pins f)%N -> (i < 2)%N -> (j < 2)%N ->
  i != j -> dot (pl w i) (d j) != 0.
Proof.
move=> ip jp i2 j2 ij; apply: (not_zero char0 o11 room (e := fun R C (x : nat -> R) =>
  dot (plane_of (C w) (point_at f x) (dir_at f x i)) (dir_at f x j))).
  by move=> R R' g C0 C' x0 x' hC hx; rewrite hC (gpoint hx) !(gdir hx) // gplane gdot.
rewrite /point_at /dir_at nf; case: i i2 ij {ip} => [|[|]] // _; case: j j2 {jp} => [|[|]] // _ _.
  by case: w; vm_compute.
by case: w; vm_compute.
Qed.
Lemma three_planes u v w : pins f = 3%N -> u <> v -> u <> w -> v <> w ->
  dot (pl u 0%N) (cross (pl v 1%N) (pl w 2%N)) != 0.
Proof.
move=> p3 uv uw vw.
pose q R (C : view -> camera R) (x : nat -> R) v i := plane_of (C v) (point_at f x) (dir_at f x i).
apply: (not_zero char0 o11 room
  (e := fun R C x => dot (q R C x u 0%N) (cross (q R C x v 1%N) (q R C x w 2%N)))).
  move=> R R' g C0 C' x0 x' hC hx; rewrite /q !hC (gpoint hx) !(gdir hx) ?p3 //.
  by rewrite !gplane gcross gdot.
rewrite /q /point_at /dir_at nf; case: u uv uw; case: v vw => //.
all: by case: w => // _ _ _; vm_compute.
Qed.

Variable D : K -> K.
Hypothesis hD : derivation (const (to F n)) D.
Hypothesis hC : forall v, dead_camera D (C v).
Hypothesis pf : proper f.
Lemma still_flat w i : (i < pins f)%N -> dead D X -> D (slope F n o f i w) = 0 -> flat o f D w i.
Proof.
move=> ip hX; apply: (slope_flat char0 o11 room pf hD hC nf ip).
exact: (dead_point hD (dead_project hD (hC w) hX)).
Qed.
End Generic.

(** ** Counting: a view that does not see the point sees at most one pin *)
Definition other := by_view V2 V1 V1.
Lemma otherP v : v <> other v. Proof. by case: v. Qed.
Lemma at_most_one (l : seq nat) : (size l <= 1)%N ->
  ((0%N \in l) + (1%N \in l) + (2 \in l) + (3 \in l) <= 1)%N.
Proof. by case: l => [|i [|]] // _; rewrite !inE; case: i => [|[|[|[|]]]]. Qed.
Lemma pin_seen f j : (0 < pins_seen f j)%N -> exists v, j \in sees_pins f v.
Proof. by rewrite -has_count => /has_view. Qed.
Lemma lines_dim2 f : (forall v, sees_point f v = false) ->
  dim2 f = (2 * (size (sees_pins f V1) + size (sees_pins f V2) + size (sees_pins f V3)))%N.
Proof. by move=> np; rewrite dim2E /seen_by !np !mulnDr. Qed.

Lemma turn_size p a1 a2 a3 e : (0 < p)%N -> (sumn [:: a1; a2; a3] + e <= 2)%N ->
  ((if false && (p.-1 == 0)%N then 0 else 3 + 2 * p.-1) + (a1 + a2 + a3) + e <= 3 + 2 * p)%N.
Proof. by rewrite /=; lia. Qed.
Lemma few_pins f : (forall v, (size (sees_pins f v) <= 1)%N) ->
  (pins_seen f 0 + pins_seen f 1 + pins_seen f 2 + pins_seen f 3 <= 3)%N.
Proof.
move=> few; move: (at_most_one (few V1)) (at_most_one (few V2)) (at_most_one (few V3)).
rewrite /pins_seen /= !addn0; by do 12 (move: (nat_of_bool _); move=> ?); lia.
Qed.
Lemma apart (g : view -> seq nat) u v i j : (size (g v) <= 1)%N -> i \in g u -> j \in g v ->
  i != j -> u <> v.
Proof.
move=> s iu jv ij e; case/negP: ij; move: s iu jv; rewrite e.
by case: (g v) => [|k [|]] // _; rewrite !inE => /eqP -> /eqP ->.
Qed.
Lemma line_size p a1 a2 a3 e : (1 + sumn [:: a1; a2; a3] + e <= 2 * p)%N ->
  (2 + 2 * 1 + (a1 + a2 + a3) + e <= 3 + 2 * p)%N.
Proof. by rewrite /=; lia. Qed.
Lemma two_size a1 a2 a3 :
  (a1 + (a2 + (a3 + 0)) = 1 -> 1 + sumn [:: 2 * a1; 2 * a2; 2 * a3] + 1 <= 2 * 2)%N.
Proof. by rewrite /=; lia. Qed.
Lemma three_size a1 a2 a3 :
  (a1 <= 1 -> a2 <= 1 -> a3 <= 1 -> 2 * (a1 + a2 + a3) + 3 <= 3 + 2 * 3)%N.
Proof. by lia. Qed.
Lemma one_of_two a b c e : (a + b + c + e <= 3 -> 0 < a -> 0 < b -> (a == 1) = false -> b = 1)%N.
Proof. by lia. Qed.
Lemma not_four a b c e : (a + b + c + e <= 3 -> 0 < a -> 0 < b -> 0 < c -> 0 < e -> False)%N.
Proof. by lia. Qed.
Lemma two_numbers i b j : (i < 2 -> b < 2 -> j < 2 -> b != i -> j != i -> j = b)%N.
Proof. by lia. Qed.

(** ** The feature f of a problem *)
Section Cases.
Variables (F : fieldType) (pre post : problem) (f : feature).
Hypothesis char0 : [char F] =i pred0.
Notation A := (pre ++ f :: post).
Hypothesis pA : is_problem A.
Notation n := (parameters A).
Notation o := (11 + sumn [seq dim3 g | g <- pre])%N.
Notation K := [fieldType of {fraction {mpoly F[n]}}].
Notation gx := (generic F n).
Notation C := (cameras_at K gx).
Notation x := (fun k => gx (o + k)%N).
Notation X := (point_at f x).
Notation d := (dir_at f x).
Notation c0 := (const (to F n)).
Notation line j v := (normal (C v) X (d j)).
Notation fine := (exists cs, reducible F A cs).
Lemma parts : [/\ is_problem pre, proper f & is_problem post].
Proof. by move: pA; rewrite /is_problem all_cat => /and3P[]. Qed.
Let pf : proper f. Proof. by case: parts. Qed.
Let room : (o + dim3 f <= n)%N.
Proof. by rewrite /parameters map_cat sumn_cat /= -addnA !leq_add2l leq_addr. Qed.
Let o11 : (11 <= o)%N. Proof. exact: leq_addr. Qed.

(** *** The list of what is kept and lost, and of ex, fixes everything and is short *)
Theorem local_lifting c (ex : seq K) : feasible f c -> ~~ whole f c ->
  (cost f c + size ex <= dim3 f)%N ->
  (forall D, derivation c0 D -> (forall v, dead_camera D (C v)) ->
    (~~ nothing (keep f c) -> killed D (kept_parameters (f, x) c)) ->
    (forall v, killed D (lost_image (f, x) c (C v) (looks f v))) -> killed D ex ->
    killed D (own (f, x))) ->
  reducible F A (instead pre post c).
Proof.
move=> fc nw le rigid; have [p1 _ p2] := parts.
have [[a1 l1] [a2 l2]] := (everything_all p1, everything_all p2).
have sz : size (instead pre post c) = size A by rewrite !size_cat /= !size_map.
split.
  by rewrite /forgets sz eqxx zip_instead // !all_cat /= a1 a2 fc (negbTE nw) andbF.
set y := lifted F n A (instead pre post c).
suff li : ind c0 (y ++ ex) by exact: (ind_catl (y := y) li).
apply: (unmoved_ind (@den_neq0 _) (@fractionE _) (@to0 F n) char0).
  rewrite size_cat size_lifted //; move: (size ex) le => e le.
  by rewrite zip_instead // map_cat sumn_cat /parameters map_cat sumn_cat; exact: sums_le.
move=> D hD; rewrite killed_cat => /andP[]; rewrite /y /lifted killed_cat => /andP[kc].
rewrite killed_cat => /andP[kk kl] ke.
have g k : (k < 11)%N -> D (gx k) = 0.
  by move=> h; have /(all_nthP 0)/(_ k) := kc; rewrite size_mkseq nth_mkseq // => /(_ h)/eqP.
have D0 := der0 hD; have D1 := der1 hD.
have hC v : dead_camera D (C v) by case: v; split=> //; try split; rewrite ?[in LHS]/= ?g ?D0 ?D1.
have ko := scene_owned p1 p2 kk kl (fun k2 kl => rigid D hD hC k2 kl ke).
have all_killed : killed D (mkseq gx n) by rewrite -owns_scene killed_cat ko andbT.
move=> i; have /(all_nthP 0)/(_ i) := all_killed.
by rewrite size_mkseq nth_mkseq ?ltn_ord // => /(_ isT)/eqP; rewrite /generic valK.
Qed.

(** *** All is forgotten: a free line in one view, a point without pins in one view *)
Lemma forget_all (ex : seq K) : (dim2 f + size ex <= dim3 f)%N ->
  (forall D, derivation c0 D -> (forall v, dead_camera D (C v)) ->
    (forall v, killed D (image (f, x) (C v) (looks f v))) -> killed D ex ->
    killed D (own (f, x))) -> fine.
Proof.
move=> le h; set c : selection := (false, [::]).
have nt : nothing (keep f c) by rewrite /nothing /= orbT.
exists (instead pre post c); apply: (local_lifting (ex := ex)) => //.
- by rewrite /whole /= orbF eq_sym; case fr: (free f) => //; rewrite (free_pins pf fr).
- have -> // : cost f c = dim2 f.
  by rewrite /cost /space nt add0n -[LHS]addn0 -(nothing_dim2 pf nt) lost_dim2.
- by move=> D hD hC _ kl ke; apply: h => // v; rewrite -lost_all; exact: kl.
Qed.
Lemma nothing_seen : dim2 f = 0%N -> fine.
Proof. by move=> z; apply: (forget_all (ex := own (f, x))) => //; rewrite z size_mkseq. Qed.
Lemma free_once : free f -> (pins_seen f 0 <= 1)%N -> fine.
Proof.
move=> fr; have p1 := free_pins pf fr.
have np v : sees_point f v = false by have [_ _] := properP v pf; rewrite fr => /negbTE.
have sz v : size (sees_pins f v) = (0%N \in sees_pins f v).
  have [u le _] := properP v pf; move: le u; rewrite p1.
  by case: (sees_pins f v) => [|[|i] [|[|j] l]].
have e : dim2 f = (2 * pins_seen f 0)%N by rewrite (lines_dim2 np) !sz /pins_seen /= addn0 addnA.
rewrite leq_eqVlt ltnS leqn0 orbC => /orP[/eqP z|/eqP z]; first by apply: nothing_seen; rewrite e z.
have [u iu] : exists v, 0%N \in sees_pins f v by apply: pin_seen; rewrite z.
apply: (forget_all (ex := line_image false (line 0%N (other u)))) => [|D hD hC ki ke].
  by rewrite e z /dim3 fr p1.
have ip : (0 < pins f)%N by rewrite p1.
have fu := image_flat char0 o11 room pf hD hC (ki u) iu.
have fw := line_flat char0 o11 room pf hD hC ip ke.
apply: own_stays => //; first exact: (free_stays char0 o11 room pf hD fr (@otherP u) ip fu fw).
by rewrite p1; case=> // _; exact: (pin_stays char0 o11 room pf hD (@otherP u) ip fu fw).
Qed.
Lemma point_once : free f = false -> pins f = 0%N -> (points_seen f <= 1)%N -> fine.
Proof.
move=> nf p0; have sz v : seen_by f v = (2 * sees_point f v)%N.
  have [_ le _] := properP v pf; move: le; rewrite p0 /seen_by; case: (sees_pins f v) => //= _.
  by case: (sees_point f v).
have e : dim2 f = (2 * points_seen f)%N by rewrite dim2E !sz /points_seen /= addn0 addnA !mulnDr.
rewrite leq_eqVlt ltnS leqn0 orbC => /orP[/eqP z|/eqP z]; first by apply: nothing_seen; rewrite e z.
have [u pu] : exists v, sees_point f v by apply: has_view; rewrite has_count -/(points_seen f) z.
apply: (forget_all (ex := [:: x3 X])) => [|D hD hC ki /killed_one ke].
  by rewrite e z /dim3 nf.
apply: own_stays => //; last by rewrite p0.
have [k ek] := image_rayed o11 room pf hD hC (ki u) pu; apply: dvec_dead.
apply: (ray_solve (l := @Vec K 0 0 1) (norm2 char0 o11 room u) ek); rewrite dot3; first exact: ke.
exact: ray_third.
Qed.

(** *** One pin is forgotten, the point and the others are kept *)
Lemma turn_pin j u w (ex : seq K) : free f = false -> (j < pins f)%N -> u <> w ->
  (sumn [seq ((if sees_point f v then 1 else 2) * (j \in sees_pins f v))%N | v <- views] +
    size ex <= 2)%N ->
  (forall D, derivation c0 D ->
    (forall v, j \in sees_pins f v -> killed D (line_image (sees_point f v) (line j v))) ->
    killed D ex -> D (slope F n o f j u) = 0 /\ D (slope F n o f j w) = 0) -> fine.
Proof.
move=> nf jp uw le h; set s := rem j (iota 0 (pins f)); set c : selection := (true, s).
have fE : free (keep f c) = false by rewrite /= nf.
have ms i : (i \in s) = (i != j) && (i < pins f)%N.
  by rewrite mem_rem_uniq ?iota_uniq // !inE mem_iota.
have ss : size s = (pins f).-1 by rewrite size_rem ?size_iota // mem_iota.
have lv v : lost_seen f c v = ((if sees_point f v then 1 else 2) * (j \in sees_pins f v))%N.
  have [un /allP lt _] := properP v pf.
  rewrite /lost_seen andbF add0n -(count_uniq_mem j un) -size_filter.
  by congr (_ * size _)%N; apply: eq_in_filter => i /lt ip; rewrite -[c.2]/s ms ip andbT negbK.
exists (instead pre post c); apply: (local_lifting (ex := ex)).
- by rewrite /feasible /= rem_uniq ?iota_uniq // andbT; apply/allP => i; rewrite ms => /andP[].
- by rewrite /whole nf -[c.2]/s ss andTb; case: (pins f) jp => // k _; rewrite neq_ltn leqnn.
- rewrite /cost /space /nothing /dim3 fE nf !lv -[pins (keep f c)]/(size s) ss.
  by apply: turn_size le; exact: leq_trans jp.
move=> D hD hC kk kl ke; have [|hX hd] := kept_point hD nf (kk _); first by rewrite /nothing fE.
have [zu zw] : D (slope F n o f j u) = 0 /\ D (slope F n o f j w) = 0.
  by apply: h => // v jv; apply: lost_pin jv _ (kl v); rewrite -[c.2]/s ms eqxx.
apply: own_stays => // i ip; have [->|ij] := eqVneq i j; last by apply: hd; rewrite ms ij.
have fl t := still_flat char0 o11 room nf hD hC pf (w := t) jp hX.
exact: (pin_stays char0 o11 room pf hD uw jp (fl u zu) (fl w zw)).
Qed.
(** No view sees the pin. *)
Lemma pin_unseen j : free f = false -> (j < pins f)%N -> pins_seen f j = 0%N -> fine.
Proof.
move=> nf jp z; apply: (@turn_pin j V1 V2 [:: slope F n o f j V1; slope F n o f j V2]) => //.
  by move: z; rewrite /pins_seen /=; do 3 case: (j \in _) => //; rewrite !muln0.
by move=> D hD _ /killed_two.
Qed.
(** Only u sees the pin, and u sees the point. *)
Lemma pin_once j u : free f = false -> (j < pins f)%N -> pins_seen f j = 1%N -> sees_point f u ->
  j \in sees_pins f u -> fine.
Proof.
move=> nf jp one pu ju; apply: (@turn_pin j u (other u) [:: slope F n o f j (other u)]) => //.
- exact: otherP.
- move: pu ju one; rewrite /pins_seen /=.
  by case: (u) => -> ->; do 2 case: (j \in _) => //; rewrite !muln0.
by move=> D hD kl /killed_one ke; split=> //; have := kl u ju; rewrite pu => /killed_one.
Qed.
(** *** No view sees the point: each view sees at most one pin *)
Section NoPoint.
Hypothesis nf : free f = false.
Hypothesis np : forall v, sees_point f v = false.
Let few v : (size (sees_pins f v) <= 1)%N.
Proof. by have [_ _] := properP v pf; rewrite nf np. Qed.
Let in_f v j : j \in sees_pins f v -> (j < pins f)%N.
Proof. by have [_ /allP le _] := properP v pf; exact: le. Qed.
Let seen_line D v j : killed D (image (f, x) (C v) (looks f v)) -> j \in sees_pins f v ->
  killed D (line_image false (line j v)).
Proof. by rewrite -lost_all -(np v) => k jv; apply: lost_pin jv _ k. Qed.
(** The line of pin i is kept. *)
Lemma keep_line i (ex : seq K) : (i < pins f)%N ->
  (1 + sumn [seq (2 * count (predC1 i) (sees_pins f v))%N | v <- views] + size ex <=
    2 * pins f)%N ->
  (forall D, derivation c0 D -> (forall v, dead_camera D (C v)) ->
    (forall v j, j \in sees_pins f v -> j != i -> killed D (line_image false (line j v))) ->
    killed D ex -> dvec D X = scale (D (x3 X)) (d i) ->
    dead D X /\ forall j, (j < pins f)%N -> j != i -> dead D (d j)) -> fine.
Proof.
move=> ip le h; set c : selection := (false, [:: i]).
have nt : nothing (keep f c) = false by rewrite /nothing /= andbF.
have fE : free (keep f c) by rewrite /= orbT.
have lv v : lost_seen f c v = (2 * count (predC1 i) (sees_pins f v))%N.
  rewrite /lost_seen np andFb add0n size_filter; congr (_ * _)%N; apply: eq_count => j.
  by rewrite -[c.2]/[:: i] inE.
exists (instead pre post c); apply: (local_lifting (ex := ex)).
- by rewrite /feasible /= ip.
- by rewrite /whole nf.
- by rewrite /cost /space nt /dim3 fE nf !lv; exact: line_size le.
move=> D hD hC kk kl ke; have [hd eX] := kept_line hD (kk (negbT nt)).
have [|hX hr] := h D hD hC _ ke eX.
  by move=> v j jv ji; rewrite -(np v); apply: lost_pin jv _ (kl v); rewrite -[c.2]/[:: i] inE.
by apply: own_stays => // j jp; have [->|] := eqVneq j i; [exact: hd | exact: hr].
Qed.
Lemma one_line : pins f = 1%N -> fine.
Proof.
move=> p1; have lv v : count (predC1 0%N) (sees_pins f v) = 0%N.
  have := in_f (v := v); case: (sees_pins f v) (few v) => [|j [|]] // _ /(_ j).
  by rewrite inE eqxx p1 => /(_ isT); case: j.
apply: (@keep_line 0%N [:: x3 X]); first by rewrite p1.
  by rewrite p1 -[size _]/1%N [sumn _]/= !lv.
move=> D hD hC _ /killed_one z e; split; last by rewrite p1; case.
by apply: dvec_dead; rewrite e z; exact: scale0.
Qed.
(** The plane of pin b and the line of pin i meet in X only. *)
Lemma two_lines i b : pins f = 2%N -> (i < 2)%N -> (b < 2)%N -> b != i -> pins_seen f b = 1%N ->
  fine.
Proof.
move=> p2 i2 b2 bi one; have [u bu] : exists v, b \in sees_pins f v by apply: pin_seen; rewrite one.
have lv v : count (predC1 i) (sees_pins f v) = (b \in sees_pins f v).
  have := in_f (v := v); case: (sees_pins f v) (few v) => [|j [|]] // _ /(_ j).
  rewrite !inE eqxx p2 => /(_ isT) j2; rewrite [LHS]/= addn0.
  case: eqVneq => [->|ji]; first by rewrite (negbTE bi).
  by rewrite (two_numbers i2 b2 j2 bi ji) eqxx.
have ip : (i < pins f)%N by rewrite p2.
have bp : (b < pins f)%N by rewrite p2.
apply: (@keep_line i [:: slope F n o f b (other u)]); first exact: ip.
  by rewrite -[size _]/1%N -[sumn _]/(sumn [:: _; _; _]) !lv p2; exact: two_size one.
move=> D hD hC kl /killed_one z e; have kb := kl u b bu bi.
have fb := line_flat char0 o11 room pf hD hC bp kb.
have hX : dead D X.
  apply: dvec_dead; apply: (ray_solve (oner_neq0 _) (etrans (scale1 _) e) fb.1).
  exact: (pin_off_plane char0 o11 room nf u bp ip b2 i2 bi).
split; first exact: hX.
move=> j; rewrite p2 => j2 ji; rewrite (two_numbers i2 b2 j2 bi ji).
apply: (pin_stays char0 o11 room pf hD (@otherP u) bp fb).
exact: (still_flat char0 o11 room nf hD hC pf bp hX z).
Qed.
(** Three planes of three pins in three views meet in X only. *)
Lemma three_lines : pins f = 3%N -> (forall j, (j < 3)%N -> (0 < pins_seen f j)%N) -> fine.
Proof.
move=> p3 h; have [u iu] := pin_seen (h 0%N isT); have [v iv] := pin_seen (h 1%N isT).
have [w iw] := pin_seen (h 2%N isT).
have uv := apart (few v) iu iv isT; have uw := apart (few w) iu iw isT.
have vw := apart (few w) iv iw isT.
pose ex := [:: slope F n o f 0 (other u); slope F n o f 1 (other v); slope F n o f 2 (other w)].
apply: (@forget_all ex); first by rewrite (lines_dim2 np) /dim3 nf p3; exact: three_size.
move=> D hD hC ki /killed_three[z0 z1 z2].
have ip j : (j < 3)%N -> (j < pins f)%N by rewrite p3.
have f0 := line_flat char0 o11 room pf hD hC (ip 0%N isT) (seen_line (ki u) iu).
have f1 := line_flat char0 o11 room pf hD hC (ip 1%N isT) (seen_line (ki v) iv).
have f2 := line_flat char0 o11 room pf hD hC (ip 2%N isT) (seen_line (ki w) iw).
have hX : dead D X.
  apply: dvec_dead.
  exact: (three_solve (three_planes char0 o11 room nf p3 uv uw vw) f0.1 f1.1 f2.1).
have pin j t : (j < 3)%N -> flat o f D t j -> D (slope F n o f j (other t)) = 0 -> dead D (d j).
  move=> /ip jp fj zj; apply: (pin_stays char0 o11 room pf hD (@otherP t) jp fj).
  exact: (still_flat char0 o11 room nf hD hC pf jp hX zj).
apply: own_stays; first exact: hX.
rewrite p3; case=> [_|[_|[_|]]]; last by [].
- exact: (pin 0%N u isT f0 z0).
- exact: (pin 1%N v isT f1 z1).
- exact: (pin 2%N w isT f2 z2).
Qed.
Lemma no_point : fine.
Proof.
case un: (has (fun j => pins_seen f j == 0%N) (iota 0 (pins f))).
  by case/hasP: un => j; rewrite mem_iota => jp /eqP z; exact: (@pin_unseen j nf jp z).
have h j : (j < pins f)%N -> (0 < pins_seen f j)%N.
  by move=> jp; rewrite lt0n; apply: contraFN un => z; apply/hasP; exists j; rewrite // mem_iota.
have le := few_pins few; case p: (pins f) h => [|[|[|[|k]]]] h.
- by apply: (@point_once nf p); rewrite /points_seen /= !np.
- exact: one_line.
- case e0: (pins_seen f 0 == 1)%N; first exact: (@two_lines 1 0 p isT isT isT (eqP e0)).
  exact: (@two_lines 0 1 p isT isT isT (one_of_two le (h 0%N isT) (h 1%N isT) e0)).
- exact: three_lines.
- by case: (not_four le (h 0%N isT) (h 1%N isT) (h 2%N isT) (h 3%N isT)).
Qed.
End NoPoint.
End Cases.

(** ** The theorem

    A pin is superfluous if at most two views see it, and these see its point. *)
Definition superfluous f j := (pins_seen f j <= 2)%N &&
  all (fun v => (j \in sees_pins f v) ==> sees_point f v) views.
(** A free line in one view or none; a point with a superfluous pin, or in no view, or in one view
    and without pins. *)
Definition forgettable f := if free f then (pins_seen f 0 <= 1)%N else
  [|| has (superfluous f) (iota 0 (pins f)), points_seen f == 0%N |
      (points_seen f == 1%N) && (pins f == 0%N)].
Lemma pin_superfluous (F : fieldType) pre f post j : [char F] =i pred0 ->
  is_problem (pre ++ f :: post) -> free f = false -> (j < pins f)%N -> superfluous f j ->
  exists cs, reducible F (pre ++ f :: post) cs.
Proof.
move=> char0 pA nf jp /andP[le sp].
have see v : j \in sees_pins f v -> sees_point f v.
  by case/and4P: sp => h1 h2 h3 _; apply/implyP; case: v.
move: le; rewrite leq_eqVlt ltnS leq_eqVlt ltnS leqn0 => /or3P[/eqP two|/eqP one|/eqP z].
- have [u [w [uw ju jw]]] : exists u w, [/\ u <> w, j \in sees_pins f u & j \in sees_pins f w].
    by apply: two_views; rewrite -/(pins_seen f j) two.
  apply: (turn_pin char0 pA nf jp uw (ex := [::])) => [|D hD kl _].
    have e v : ((if sees_point f v then 1 else 2) * (j \in sees_pins f v) =
      (j \in sees_pins f v))%N.
      by case: (boolP (j \in _)) => [/see ->|_]; rewrite ?muln0.
    by rewrite /= !e addn0 -two.
  by split; [have := kl u ju | have := kl w jw]; rewrite see // => /killed_one.
- have [u ju] : exists v, j \in sees_pins f v by apply: pin_seen; rewrite one.
  exact: (pin_once char0 pA nf jp one (see u ju) ju).
exact: (pin_unseen char0 pA nf jp z).
Qed.
Theorem forgettable_reducible (F : fieldType) pre f post : [char F] =i pred0 ->
  is_problem (pre ++ f :: post) -> forgettable f -> exists cs, reducible F (pre ++ f :: post) cs.
Proof.
move=> char0 pA; rewrite /forgettable; case fr: (free f); first exact: (free_once char0 pA fr).
case/or3P=> [/hasP[j]|/eqP z|/andP[/eqP z /eqP p0]].
- by rewrite mem_iota => /= jp; exact: (pin_superfluous char0 pA fr jp).
- apply: (no_point char0 pA fr) => v; apply/negbTE/negP => pv.
  have : (0 < points_seen f)%N; last by rewrite z.
  by rewrite /points_seen -has_count /=; case: (v) pv => ->; rewrite ?orbT.
by apply: (point_once char0 pA fr p0); rewrite z.
Qed.
