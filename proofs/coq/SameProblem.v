(** * Neither the order of the features matters, nor the names of their pins

    Another order of features, other names of pins and another order of the pins in a look permute
    the parameters of a scene, and its images. *)
From Coq Require Import Permutation.
From mathcomp Require Import all_ssreflect all_algebra.
From mathcomp.zify Require Import zify.
From PL1P Require Import Statement Reducible Problems Forget Embedding Scenes.
Set Implicit Arguments.
Unset Strict Implicit.
Unset Printing Implicit Defensive.

(** ** Same is an equivalence relation *)
Lemma sameP f g : reflect ([/\ free f = free g, pins f = pins g & exists2 r, perm_eq r (iota 0 (pins f)) &
  forall v, same_look r (looks f v) (looks g v)]) (same f g).
Proof.
apply: (iffP and3P) => [[/eqP e1 /eqP e2 /hasP[r]]|[e1 e2 [r p h]]].
  by rewrite mem_permutations => p /and4P[h1 h2 h3 _]; split=> //; exists r => // -[].
by split; [exact/eqP | exact/eqP | apply/hasP; exists r; rewrite ?mem_permutations //= !h].
Qed.

Lemma same_refl f : proper f -> same f f.
Proof.
move=> pf; apply/sameP; split=> //; exists (iota 0 (pins f)) => // v.
have [_ le _] := properP v pf; rewrite /same_look eqxx /= (_ : map _ _ = sees_pins f v) //.
by rewrite -[RHS]map_id; apply/eq_in_map => j jl; rewrite nth_iota ?add0n //; exact: (allP le).
Qed.
Lemma same_sym f g : proper f -> same f g -> same g f.
Proof.
move=> pf /sameP[e1 e2 [r p h]]; apply/sameP; split=> //.
have sr : size r = pins f by rewrite (perm_size p) size_iota.
have ur : uniq r by rewrite (perm_uniq p) iota_uniq.
have rk j : (j \in r) = (j < pins f) by rewrite (perm_mem p) mem_iota.
exists [seq index i r | i <- iota 0 (pins f)]; last first.
  move=> v; have [_ /allP le _] := properP v pf; have /andP[/eqP e q] := h v.
  rewrite /same_look e eqxx /= perm_sym.
  have -> : (looks f v).2 =
      [seq nth 0 [seq index i r | i <- iota 0 (pins f)] j | j <- [seq nth 0 r j | j <- (looks f v).2]].
    rewrite -map_comp -[LHS]map_id; apply/eq_in_map => j /le jp /=.
    have rj : nth 0 r j < pins f by rewrite -rk mem_nth ?sr.
    by rewrite (nth_map 0) ?size_iota // nth_iota ?add0n // index_uniq ?sr.
  exact: perm_map.
rewrite -e2; apply: uniq_perm; rewrite ?iota_uniq //.
  rewrite map_inj_in_uniq ?iota_uniq // => i j; rewrite !mem_iota !add0n /= -!rk => ir jr e.
  by rewrite -(nth_index 0 ir) e nth_index.
move=> j; rewrite mem_iota add0n /=; apply/mapP/idP => [[i] |jp].
  by rewrite mem_iota add0n /= -rk -sr => ir ->; rewrite index_mem.
by exists (nth 0 r j); rewrite ?index_uniq ?sr // mem_iota add0n /= -rk mem_nth ?sr.
Qed.
Lemma same_trans f g h : proper f -> same f g -> same g h -> same f h.
Proof.
move=> pf /sameP[e1 e2 [r p q]] /sameP[e3 e4 [r' p' q']]; apply/sameP; rewrite e1 e2; split=> //.
have sr : size r = pins f by rewrite (perm_size p) size_iota.
exists [seq nth 0 r' i | i <- r].
  apply: perm_trans (p'); rewrite -[X in perm_eq _ X](mkseq_nth 0) (perm_size p') size_iota.
  by apply: perm_map; rewrite -e2.
move=> v; have [_ /allP le _] := properP v pf.
have /andP[/eqP e a] := q v; have /andP[/eqP e' a'] := q' v; rewrite /same_look e e' eqxx /=.
rewrite (_ : map _ (looks f v).2 = [seq nth 0 r' j | j <- [seq nth 0 r j | j <- (looks f v).2]]).
  exact: perm_trans (perm_map _ a) a'.
rewrite -map_comp; apply/eq_in_map => j /le jp /=; by rewrite (nth_map 0) ?sr.
Qed.

Lemma same_index f g : proper f -> proper g -> same f g -> index_of f = index_of g.
Proof.
move=> pf pg fg; apply: eq_find => h; apply/idP/idP; last exact: same_trans.
by apply: same_trans pg (same_sym pf fg).
Qed.
Lemma index_same f : index_of f < 27 -> same f (ft (index_of f)).
Proof. by move=> h; apply: (nth_find (feat 0 o o o)); rewrite has_find. Qed.

(** ** Permutations of features *)
Lemma all_permutation (p : pred feature) A B : Permutation A B -> all p A = all p B.
Proof.
elim=> //= [f l l' _ ->|f g l|l l' l'' _ -> _ ->] //.
by rewrite andbCA.
Qed.
Lemma same_all (p : pred feature) A B : (forall f g, proper f -> proper g -> same f g -> p f = p g) ->
  is_problem A -> is_problem B -> same_problem A B -> all p A = all p B.
Proof.
move=> ph pA pB [A' AA']; rewrite (all_permutation p AA'); move: pA;
  rewrite /is_problem (all_permutation _ AA').
elim: A' B pB {A AA'} => [|f A IH] [|g B] // /andP[pg pB] /andP[pf pA] /andP[fg AB].
by rewrite [LHS]/= [RHS]/= (ph f g) // (IH B).
Qed.
Lemma same_known A B : is_problem A -> is_problem B -> same_problem A B -> known A = known B.
Proof. by apply: same_all => f g pf pg fg; rewrite (same_index pf pg fg). Qed.

Section Alike.
Variable K : fieldType.
Notation placed := (feature * (nat -> K))%type.
Implicit Types (sc : seq placed).
Lemma alike_refl sc : alike sc sc. Proof. by split. Qed.
Lemma alike_cons fx gy sc sc' : alike [:: fx] [:: gy] -> alike sc sc' -> alike (fx :: sc) (gy :: sc').
Proof.
rewrite /alike /owns /seen /= !cats0 => -[h1 h2] [h3 h4].
by split=> [|C]; apply: perm_cat => //; have := h2 C; rewrite !cats0.
Qed.
Lemma permutation_alike A B : Permutation A B -> forall sc, map fst sc = A -> exists2 sc', map fst sc' =
  B & alike sc sc'.
Proof.
elim=> [|f l l' _ IH|f g l|l l' l'' _ IH _ IH'] sc.
- by move=> e; exists sc.
- case: sc => [|fx sc] //= [<- e]; have [sc' <- al] := IH _ e; exists (fx :: sc') => //.
  exact: alike_cons.
- case: sc => [|gx [|fx sc]] //= [<- <- <-]; exists (fx :: gx :: sc) => //.
  by rewrite /alike /owns /seen /=; split=> [|C]; rewrite perm_catCA.
- by move=> /IH[t et at1] ; have [u eu at2] := IH' _ et; exists u => //; exact: alike_trans at1 at2.
Qed.

Lemma same_alike f g (y : nat -> K) : proper f -> same f g -> exists x, alike [:: (g, y)] [:: (f, x)].
Proof.
move=> pf /sameP[e1 e2 [r p h]]; have sr : size r = pins f by rewrite (perm_size p) size_iota.
pose t := (if free f then 2 else 3)%N.
pose x m := if m < t then y m else y (t + 2 * nth 0 r ((m - t)./2) + odd (m - t)); exists x.
have eX : point_at f x = point_at g y by rewrite /point_at /x /t -e1; case: (free f).
have ed j : dir_at f x j = dir_at g y (nth 0 r j).
  rewrite /dir_at -e1 -/t /x !ltnNge leq_addr addKn mul2n odd_double doubleK addn0 /=.
  rewrite -addnS leq_addr addKn /= odd_double /= uphalf_double.
  by rewrite addn1.
have fl (T : eqType) (u : nat -> seq T) (l l' : seq nat) : perm_eq l l' ->
  perm_eq (flatten (map u l)) (flatten (map u l')).
  by move=> ll; apply: perm_flatten; exact: perm_map.
split=> [|C]; rewrite /owns /seen /= !cats0.
  have kE k (z : nat -> K) : own (k, z) = (if free k then [:: x1 (point_at k z); x2 (point_at k z)]
      else [:: x1 (point_at k z); x2 (point_at k z); x3 (point_at k z)]) ++
      flatten [seq [:: x1 (dir_at k z j); x2 (dir_at k z j)] | j <- iota 0 (pins k)].
    by rewrite ownE /kept_parameters /= orbF.
  rewrite !kE eX e1 e2; apply: perm_cat => //.
  rewrite perm_sym (_ : [seq [:: x1 (dir_at f x j); x2 (dir_at f x j)] | j <- _] =
    [seq [:: x1 (dir_at g y j); x2 (dir_at g y j)] | j <- [seq nth 0 r j | j <- iota 0 (pins g)]]).
    by apply: fl; rewrite -e2 -{1}sr -/(mkseq _ _) mkseq_nth.
  by rewrite -map_comp; apply: eq_map => j; rewrite ed.
have im v : perm_eq (image (g, y) (C v) (looks g v)) (image (f, x) (C v) (looks f v)).
  have /andP[/eqP e q] := h v; rewrite /image /= e eX; apply: perm_cat => //.
  rewrite perm_sym (_ : [seq _ | j <- (looks f v).2] =
    [seq line_image (looks g v).1 (normal (C v) (point_at g y) (dir_at g y j))
     | j <- [seq nth 0 r j | j <- (looks f v).2]]); first exact: fl.
  by rewrite -map_comp; apply: eq_map => j; rewrite ed.
by rewrite /views_of /= !cats0; apply: perm_cat => //; exact: perm_cat.
Qed.
Lemma all2_same_alike A B sc : is_problem A -> all2 same A B -> map fst sc = B -> exists2 sc', map fst sc' =
  A & alike sc sc'.
Proof.
elim: A B sc => [|f A IH] [|g B] [|[g' y] sc] //; first by exists [::].
move=> /andP[pf pA] /andP[fg AB] [e1 e2].
have [x al] := same_alike y pf fg; have [sc' e al'] := IH _ _ pA AB e2.
by exists ((f, x) :: sc'); [rewrite /= e | rewrite e1; exact: alike_cons].
Qed.
End Alike.

Lemma all2_same_sym A B : is_problem A -> all2 same A B -> all2 same B A.
Proof. by elim: A B => [|f A IH] [|g B] //= /andP[pf pA] /andP[fg AB]; rewrite (same_sym pf fg) IH. Qed.
Theorem same_minimal (F : fieldType) A B : [char F]%R =i pred0 -> is_problem A -> is_problem B ->
  same_problem A B ->
  minimal F A <-> minimal F B.
Proof.
move=> char0 pA pB [A' AA' A'B]; have pA' : is_problem A' by rewrite /is_problem -(all_permutation _ AA').
have step A1 A2 : is_problem A1 -> Permutation A1 A2 -> minimal F A1 -> minimal F A2.
  move=> p1 p12; have [sc e al] := permutation_alike p12 (fst_scene (generic F (parameters A1)) 11 A1).
  by apply: (alike_minimal char0) e al; rewrite /is_problem -(all_permutation _ p12).
have step' A1 A2 : is_problem A1 -> all2 same A1 A2 -> minimal F A2 -> minimal F A1.
  move=> p1 s12; have [sc e al] := all2_same_alike p1 s12 (fst_scene (generic F (parameters A2)) 11 A2).
  exact: (alike_minimal char0) e al.
split=> [/(step _ _ pA AA')|/(step' _ _ pA' A'B)]; first exact: step' pB (all2_same_sym pA' A'B).
exact: step pA' (Permutation_sym AA').
Qed.
