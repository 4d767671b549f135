(** * The equations of a placed feature as rows of coefficients

    [block C p] has one row for each entry of the three image changes of p; the columns are the
    feature's own unknowns (dX, then dD of each pin, without the coordinates that the gauge fixes)
    and the 11 of the cameras. *)
From mathcomp Require Import all_ssreflect all_algebra.
From mathcomp.algebra_tactics Require Import ring.
From PL1P Require Import Statement Rigid.
Set Implicit Arguments.
Unset Strict Implicit.
Unset Printing Implicit Defensive.
Import GRing.Theory.
Local Open Scope ring_scope.

Section Forms.
Variable R : idomainType.
Notation Vec := (@Vec R).
Implicit Types (u w l : vec R) (T : view -> twist R) (m : motion R) (C : view -> camera R).

Fixpoint ev (f x : seq R) : R := if f is a :: f' then if x is y :: x' then a * y + ev f' x' else 0 else 0.

Lemma ev_cat f g x y : size f = size x -> ev (f ++ g) (x ++ y) = ev f x + ev g y.
Proof. by elim: f x => [|a f IH] [|t x] //=; [rewrite add0r | case=> /IH ->; rewrite addrA]. Qed.
Lemma ev_zeros n x : ev (nseq n 0) x = 0.
Proof. by elim: n x => [|n IH] [|t x] //=; rewrite IH mul0r add0r. Qed.

(** The unknowns. *)
Definition own_point (fr : bool) u := if fr then [:: x1 u; x2 u] else [:: x1 u; x2 u; x3 u].
Definition own_dirs k (d : nat -> vec R) := flatten [seq [:: x1 (d j); x2 (d j)] | j <- iota 0 k].
Definition own_unknowns f m := own_point (free f) (dX m) ++ own_dirs (pins f) (dD m).
Definition camera_unknowns T :=
  [:: x1 (omega (T V2)); x2 (omega (T V2)); x3 (omega (T V2)); x2 (dt (T V2)); x3 (dt (T V2));
      x1 (omega (T V3)); x2 (omega (T V3)); x3 (omega (T V3)); x1 (dt (T V3)); x2 (dt (T V3));
        x3 (dt (T V3))].
Definition unknowns f T m := own_unknowns f m ++ camera_unknowns T.

(** The rows. *)
Definition camera_row v (w l : vec R) := match v with
  | V1 => nseq 11 0
  | V2 => [:: x1 w; x2 w; x3 w; x2 l; x3 l] ++ nseq 6 0
  | V3 => nseq 5 0 ++ [:: x1 w; x2 w; x3 w; x1 l; x2 l; x3 l]
  end.
Definition pull (C : camera R) l := rot (conj (quat_of C)) l.
Definition point_row f (C : view -> camera R) v X l :=
  own_point (free f) (pull (C v) l) ++ nseq (2 * pins f)%N 0 ++ camera_row v (cross (turn (C v) X) l) l.
Definition dir_row f (C : view -> camera R) v (D : vec R) j l :=
  nseq (if free f then 2 else 3)%N 0 ++
    flatten [seq (if i == j then [:: x1 (pull (C v) l); x2 (pull (C v) l)] else [:: 0; 0]) | i <- iota 0
      (pins f)]
  ++ camera_row v (cross (turn (C v) D) l) (vec0 R).

Definition view_block C p v :=
  let f := ft (kind p) in let L := looks f v in
  let x := project (C v) (point p) in
  let row := point_row f C v (point p) in
  (if L.1 then [:: row (Vec 0 (x3 x) (- x2 x)); row (Vec (- x3 x) 0 (x1 x))] else [::]) ++
  flatten [seq dir_row f C v (dir p j) j (line (C v) p j) :: (if L.1 then [::] else [:: row (line (C v) p j)])
    | j <- L.2].
Definition block C p := flatten [seq view_block C p v | v <- views].

(** ** The rows are the image changes *)
Lemma dot_rot q l u : dot l (rot q u) = dot (rot (conj q) l) u.
Proof. case: q => a b c d; rewrite /dot /rot /conj /dot /=; ring. Qed.
Lemma triple l w u : dot l (cross w u) = dot (cross u l) w.
Proof. rewrite /dot /cross /=; ring. Qed.
Lemma dot_add l u w : dot l (add u w) = dot l u + dot l w.
Proof. rewrite /dot /add /=; ring. Qed.

Lemma camera_rowE T v w l : gauge T -> ev (camera_row v w l) (camera_unknowns T) =
  dot w (omega (T v)) + dot l (dt (T v)).
Proof.
case=> e1 e2; case: v; rewrite /camera_row /camera_unknowns.
- by rewrite ev_zeros e1 /dot /= !mulr0 !addr0.
- rewrite [ev _ _]/= /dot e2; ring.
- rewrite [ev _ _]/= /dot; ring.
Qed.

Lemma own_pointE (fr : bool) u w : (fr -> x3 w = 0) -> ev (own_point fr u) (own_point fr w) = dot u w.
Proof. by case: fr => /= h; rewrite /dot; [rewrite h //; ring | ring]. Qed.

Lemma size_own_point fr u : size (own_point fr u) = (if fr then 2 else 3)%N.
Proof. by case: fr. Qed.
Lemma size_pairs (F G : nat -> R) (s : seq nat) : size (flatten [seq [:: F i; G i] | i <- s]) =
  (2 * size s)%N.
Proof. by elim: s => //= i s ->; rewrite mulnS. Qed.

Lemma size_at (j : nat) (y z : R) (s : seq nat) :
  size (flatten [seq (if i == j then [:: y; z] else [:: 0; 0]) | i <- s]) = (2 * size s)%N.
Proof. by elim: s => //= i s IH; case: (i == j); rewrite /= IH mulnS. Qed.

Lemma point_rowE f C T m v X l : gauge T -> (free f -> x3 (dX m) = 0) ->
  ev (point_row f C v X l) (unknowns f T m) = dot l (d_project (C v) (T v) X (dX m)).
Proof.
move=> gT gm; rewrite /point_row /unknowns /own_unknowns -catA ev_cat ?size_own_point // own_pointE //.
rewrite ev_cat ?size_nseq ?size_pairs ?size_iota // ev_zeros add0r camera_rowE //.
by rewrite /d_project /d_turn !dot_add /turn dot_rot triple /pull; ring.
Qed.

Lemma dir_rowE f C T m v D j l : gauge T -> (j < pins f)%N -> x3 (dD m j) = 0 ->
  ev (dir_row f C v D j l) (unknowns f T m) = dot l (d_turn (C v) (T v) D (dD m j)).
Proof.
move=> gT jk gm; rewrite /dir_row /unknowns /own_unknowns -catA ev_cat ?size_nseq ?size_own_point // ev_zeros
  add0r.
rewrite ev_cat ?size_at ?size_pairs // camera_rowE //.
rewrite /d_turn dot_add /turn dot_rot triple /pull; move: (rot _ l) => W.
rewrite [dot (vec0 R) _]/dot /= !mul0r !addr0 addrC; congr (_ + _).
have: uniq (iota 0 (pins f)) by exact: iota_uniq.
have: j \in iota 0 (pins f) by rewrite mem_iota.
rewrite /own_dirs; elim: (iota 0 _) => // i s IH; rewrite inE => /orP[/eqP <-|js] /= /andP[ns us].
  rewrite eqxx /= (_ : ev _ _ = 0); first by rewrite /dot gm mulr0 !addr0 ?addrA.
  by elim: s ns {IH us} => // k s IHs; rewrite inE negb_or eq_sym => /andP[/negbTE kj /IHs];
    rewrite /= kj /= !mul0r !add0r.
by rewrite (_ : i == j = false) /= ?mul0r ?add0r ?IH //; apply: contraNF ns => /eqP ->.
Qed.

Definition pins_ok f := all (fun v => all (fun j => j < pins f)%N (sees_pins f v)) views.

Lemma view_blockE C T m p v : gauge T -> feature_gauge p m -> pins_ok (ft (kind p)) ->
  map (ev^~ (unknowns (ft (kind p)) T m)) (view_block C p v) =
    image_change (C v) (T v) p m (looks (ft (kind p)) v).
Proof.
move=> gT [gD gX] ok; rewrite /view_block /image_change map_cat map_flatten -map_comp; congr (_ ++ flatten _).
  by case: (looks _ _).1; rewrite //= !point_rowE.
apply/eq_in_map => j jL; rewrite /= dir_rowE ?gD //.
- by case: (looks _ _).1; rewrite //= !point_rowE.
- by case/and4P: ok => /allP h1 /allP h2 /allP h3 _; case: (v) jL; [apply: h1|apply: h2|apply: h3].
- by case/and4P: ok => /allP h1 /allP h2 /allP h3 _; case: (v) jL; [apply: h1|apply: h2|apply: h3].
Qed.

End Forms.

Lemma pins_okP i : pins_ok (ft i).
Proof.
have h : all (fun i => pins_ok (ft i)) (iota 0 27) by vm_compute.
case: (ltnP i 27) => i27; first by apply: (allP h); rewrite mem_iota.
by rewrite /ft nth_default.
Qed.
