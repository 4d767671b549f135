(** * What is proved: definitions only, then the claim itself
    Point-line problems in three calibrated views in which every line carries at most one point.
    Notation of mathcomp: [seq] is a finite list, [nth d s i] its i-th entry (d past the end),
    [iota 0 n] the list 0..n-1, [f \in s] membership, [%R] ring operations, [&&] a boolean "and". *)
From Coq Require Import NArith ZArith.
From mathcomp Require Import all_ssreflect all_algebra.
From mathcomp.zify Require Import ssrZ.   (* Z, Coq's integers, as an integral domain *)
Set Implicit Arguments.
Import GRing.Theory.

(** ** Local features: a point with [pins] lines through it, and what each view sees of it *)
Inductive view := V1 | V2 | V3.
Definition views := [:: V1; V2; V3].
Definition by_view T (x y z : T) (v : view) := match v with V1 => x | V2 => y | V3 => z end.
(** A look is (is the point seen?, which pins are seen?). A free line is a pin of a point that no view sees. *)
Definition look := (bool * seq nat)%type.
Record feature := Feature { pins : nat; looks : view -> look }.
Definition sees_point f v := (looks f v).1.
Definition sees_pins f v := (looks f v).2.
Definition free f := ~~ has (sees_point f) views.
Definition o : look := (false, [::]).      Definition P : look := (true, [::]).
Definition a : look := (false, [:: 0]).    Definition Pa : look := (true, [:: 0]).
Definition b : look := (false, [:: 1]).    Definition Pab : look := (true, [:: 0; 1]).
Definition feat k (l1 l2 l3 : look) := Feature k (by_view l1 l2 l3).
Definition star k := let l := (true, iota 0 k) in feat k l l l.
Definition features := [:: star 7; star 6; star 5; star 4; star 3;                        (*  0 ..  4 *)
  feat 2 Pab Pab Pab; feat 1 Pa Pa Pa; feat 0 P P P;                                      (*  5,  6,  7 *)
  feat 1 a Pa Pa; feat 1 Pa a Pa; feat 1 Pa Pa a; feat 1 a a a;                           (*  8 .. 11 *)
  feat 1 a P Pa; feat 1 a Pa P; feat 1 P a Pa; feat 1 Pa a P; feat 1 P Pa a; feat 1 Pa P a;  (* 12 .. 17 *)
  feat 0 o P P; feat 0 P o P; feat 0 P P o;                                               (* 18 .. 20 *)
  feat 1 P a a; feat 1 a P a; feat 1 a a P; feat 2 Pab b a; feat 2 b Pab a; feat 2 b a Pab]. (* 21 .. 26 *)
Definition ft i := nth (feat 0 o o o) features i.
(** A signature says how often each of the 27 features occurs; [total s h] sums h over the occurrences. *)
Definition signature := seq nat.
Definition total (s : signature) (h : nat -> nat) := sumn [seq nth 0 s i * h i | i <- iota 0 27].
(** Degrees of freedom in space and in the images; balanced: what is left are the 11 of the cameras. *)
Definition dim3 f := (if free f then 2 else 3) + 2 * pins f.
Definition dim2 f := sumn [seq let n := size (sees_pins f v) in if sees_point f v then 2 + n else 2 * n | v <- views].
Definition weight i := dim2 (ft i) - dim3 (ft i).
Definition balanced (s : signature) := (size s == 27) && (total s weight == 11).

(** ** Relabeling the views, and the swap *)
Definition same_look (r : seq nat) (l l' : look) := (l.1 == l'.1) && perm_eq [seq nth 0 r j | j <- l.2] l'.2.
Definition same f g :=      (* equal up to renaming the pins *)
  (pins f == pins g) && has (fun r => all (fun v => same_look r (looks f v) (looks g v)) views) (permutations (iota 0 (pins f))).
Definition index_of f := find (same f) features.
Definition view_perms := [:: by_view V1 V2 V3; by_view V1 V3 V2; by_view V2 V1 V3;
                             by_view V2 V3 V1; by_view V3 V1 V2; by_view V3 V2 V1].
Definition relabel_feature (g : view -> view) f := Feature (pins f) (fun v => looks f (g v)).
Definition relabel g (s : signature) := mkseq (fun i => nth 0 s (index_of (relabel_feature g (ft i)))) 27.
Definition label_equiv (s t : signature) := t \in [seq relabel g s | g <- view_perms].
(** Swap: if just two views see the point of an occurrence, exchange them (P/Pa/a and Pa/P/a). *)
Definition swap_feature f := match [seq v <- views | ~~ sees_point f v] with
  | [:: v] => relabel_feature (by_view (by_view V1 V3 V2) (by_view V3 V2 V1) (by_view V2 V1 V3) v) f | _ => f end.
Definition swap i (s : signature) :=
  mkseq (fun k => nth 0 s k - (k == i) + (k == index_of (swap_feature (ft i)))) 27.
Inductive swap_equiv : signature -> signature -> Prop :=
  | sw_label s t : label_equiv s t -> swap_equiv s t
  | sw_swap s i : i < 27 -> 0 < nth 0 s i -> swap_equiv s (swap i s)
  | sw_sym s t : swap_equiv s t -> swap_equiv t s
  | sw_trans s t u : swap_equiv s t -> swap_equiv t u -> swap_equiv s u.

(** ** Cameras, scenes and their motions, over an integral domain R *)
Section Geometry.
Variable R : idomainType.
Local Open Scope ring_scope.
Record vec := Vec { x1 : R; x2 : R; x3 : R }.
Definition vec0 := Vec 0 0 0.
Definition add u w := Vec (x1 u + x1 w) (x2 u + x2 w) (x3 u + x3 w).
Definition scale k u := Vec (k * x1 u) (k * x2 u) (k * x3 u).
Definition dot u w := x1 u * x1 w + x2 u * x2 w + x3 u * x3 w.
Definition cross u w := Vec (x2 u * x3 w - x3 u * x2 w) (x3 u * x1 w - x1 u * x3 w) (x1 u * x2 w - x2 u * x1 w).
(** A camera [R~ | t]: [rot q] is R~, the rotation of the quaternion q = qa + qb i + qc j + qd k times its norm. *)
Record quat := Quat { qa : R; qb : R; qc : R; qd : R }.
Definition conj q := Quat (qa q) (- qb q) (- qc q) (- qd q).
Definition norm q := qa q ^+ 2 + qb q ^+ 2 + qc q ^+ 2 + qd q ^+ 2.
Definition rot q u := let: Quat a b c d := q in Vec
  (dot (Vec (a^+2 + b^+2 - c^+2 - d^+2) ((b*c - a*d) *+ 2) ((b*d + a*c) *+ 2)) u)
  (dot (Vec ((b*c + a*d) *+ 2) (a^+2 - b^+2 + c^+2 - d^+2) ((c*d - a*b) *+ 2)) u)
  (dot (Vec ((b*d - a*c) *+ 2) ((c*d + a*b) *+ 2) (a^+2 - b^+2 - c^+2 + d^+2)) u).
Record camera := Camera { quat_of : quat; trans : vec }.
Definition turn C u := rot (quat_of C) u.
Definition project C X := add (turn C X) (trans C).
Definition centre C := rot (conj (quat_of C)) (trans C).   (* up to the factor -1/norm^2 *)
(** A placed feature: which of the 27, its point, the directions of its pins 0, 1, ... *)
Record placed := Placed { kind : nat; point : vec; dir : nat -> vec }.
Definition line C p j := cross (project C (point p)) (turn C (dir p j)).   (* the image of pin j *)
(** First-order motions: R~ moves by omega x R~, t by dt, points by dX, directions by dD. *)
Record twist := Twist { omega : vec; dt : vec }.
Record motion := Motion { dX : vec; dD : nat -> vec }.
Definition d_turn C T D dD := add (cross (omega T) (turn C D)) (turn C dD).
Definition d_project C T X dX := add (d_turn C T X dX) (dt T).
Definition d_line C T p m j := dot (line C p j) (d_turn C T (dir p j) (dD m j)).
(** The change of the image of p in a view that sees the look l, linear in (T, m). *)
Definition image_change C T p m (l : look) : seq R :=
  let x := project C (point p) in let dx := d_project C T (point p) (dX m) in
  (if l.1 then [:: dot (Vec 0 (x3 x) (- x2 x)) dx; dot (Vec (- x3 x) 0 (x1 x)) dx] else [::]) ++
  flatten [seq d_line C T p m j :: (if l.1 then [::] else [:: dot (line C p j) dx]) | j <- l.2].
(** Normalisations that leave 11 parameters to the cameras and [dim3] to a feature. *)
Definition gauge (T : view -> twist) := T V1 = Twist vec0 vec0 /\ x1 (dt (T V2)) = 0.
Definition feature_gauge p m := (forall j, (j < pins (ft (kind p)))%N -> x3 (dD m j) = 0) /\ (free (ft (kind p)) -> x3 (dX m) = 0).
Definition p0 := Placed 0 vec0 (fun _ => vec0).
Definition rigid (C : view -> camera) (scene : seq placed) := forall (T : view -> twist) (m : nat -> motion),
  gauge T ->
  (forall n, (n < size scene)%N -> let p := nth p0 scene n in feature_gauge p (m n) /\
     forall v, all (pred1 0) (image_change (C v) (T v) p (m n) (looks (ft (kind p)) v))) ->
  (forall v, T v = Twist vec0 vec0) /\
  (forall n, n < size scene -> dX (m n) = vec0 /\ forall j, j < pins (ft (kind (nth p0 scene n))) -> dD (m n) j = vec0)%N.
Definition shape (scene : seq placed) (s : signature) :=
  all (fun p => kind p < 27)%N scene /\ s = [seq count (fun p => kind p == i) scene | i <- iota 0 27].
Definition admissible (C : view -> camera) (scene : seq placed) :=
  [/\ C V1 = Camera (Quat 1 0 0 0) vec0, forall v, norm (quat_of (C v)) <> 0, x1 (trans (C V2)) <> 0,
      (forall u v, u <> v -> scale (norm (quat_of (C v)) ^+ 2) (centre (C u)) <> scale (norm (quat_of (C u)) ^+ 2) (centre (C v))) &
      forall n, (n < size scene)%N -> let p := nth p0 scene n in
      [/\ (forall v, sees_point (ft (kind p)) v -> x3 (project (C v) (point p)) <> 0),
          (forall v j, j \in sees_pins (ft (kind p)) v -> line (C v) p j <> vec0) &
          forall j, (j < pins (ft (kind p)))%N -> x3 (dir p j) <> 0]].
End Geometry.
Definition minimal s := exists (C : view -> camera [idomainType of Z]) scene, [/\ shape scene s, admissible C scene & rigid C scene].

(** ** Obstructed: two views share more than five points, or the cameras can slide along a star *)
Definition shared s u v := total s (fun i => sees_point (ft i) u && sees_point (ft i) v).
Definition shown s v := total s (fun i => sees_point (ft i) v || (0 < size (sees_pins (ft i) v))).
Definition crowded s := has (fun uv => 5 < shared s uv.1 uv.2) [:: (V1, V2); (V1, V3); (V2, V3)].
Definition sliding s := has (fun i => [&& 0 < nth 0 s i, 3 <= pins (ft i) &
  [|| pins (ft i) == 7, (pins (ft i) == 6) && (0 < total s (fun k => free (ft k))) | has (fun v => shown s v == 1) views]]) (iota 0 27).
Definition obstructed s := crowded s || sliding s.

(** ** The claim *)
Definition classes (E : signature -> signature -> Prop) (Q : signature -> Prop) (n : N) := exists reps : seq signature,
  [/\ N.of_nat (size reps) = n, uniq reps, {in reps, forall r, Q r}, {in reps &, forall r r', E r r' -> r = r'}
    & forall s, Q s -> exists2 r, r \in reps & E s r].
Definition good s := balanced s /\ minimal s.
Definition bad s := balanced s /\ ~ minimal s.
Definition only (c : feature -> bool) (s : signature) := forall i, i < 27 -> 0 < nth 0 s i -> c (ft i).
Definition pl0p s := good s /\ only (fun f => (pins f == 0) || free f) s.
Definition one_pin s := good s /\ only (fun f => pins f <= 1) s.
Definition five_point s := good s /\ [\/ shared s V1 V2 = 5, shared s V1 V3 = 5 | shared s V2 V3 = 5].
Definition classification : Prop :=
  [/\ [/\ classes eq balanced 845161, classes label_equiv balanced 143494 & classes swap_equiv balanced 76446],
      (forall s, balanced s -> minimal s <-> ~~ obstructed s) /\
      (forall (R : idomainType) (C : view -> camera R) scene s,
         shape scene s -> balanced s -> obstructed s -> admissible C scene -> ~ rigid C scene),
      [/\ classes label_equiv good 140616, classes label_equiv bad 2878,
          classes swap_equiv good 74575 & classes swap_equiv bad 1871] &
      [/\ classes label_equiv pl0p 51, classes swap_equiv one_pin 9533,
          classes label_equiv five_point 6413 & classes swap_equiv five_point 3615]].
