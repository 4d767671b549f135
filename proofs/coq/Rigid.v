(** * Rigid configurations: the definition by which minimal is decided

    A configuration is rigid if its only motion that changes no image is zero. By [rigidity],
    minimal means rigid at some admissible configuration over the integers. And what is obstructed
    is rigid at none, over any domain. *)
From Coq Require Import ZArith.
From mathcomp Require Import all_ssreflect all_algebra.
From mathcomp.zify Require Import ssrZ.   (* Z, Coq's integers, as an integral domain *)
From PL1P Require Import Statement.
Set Implicit Arguments.
Import GRing.Theory.

(** ** Features of a signature, one by one, and how many parameters each has *)
Definition kinds (s : signature) := flatten [seq nseq (nth 0 s i) i | i <- iota 0 27]%N.
Definition sizes s := [seq dim3 (ft i) | i <- kinds s].

Section Scene.
Variable R : idomainType.
Local Open Scope ring_scope.
(** A placed feature: which of the 27, its point, the directions of its pins 0, 1, ... *)
Record placed := Placed { kind : nat; point : vec R; dir : nat -> vec R }.
(** The image of pin j. *)
Definition line C p j := cross (project C (point p)) (turn C (dir p j)).
Definition place_at (x : nat -> R) i := let o := (if free (ft i) then 2 else 3)%N in
  Placed i (@Vec R (x 0%N) (x 1%N) (if free (ft i) then 0 else x 2%N))
    (fun j => @Vec R (x (o + 2 * j)%N) (x (o + 2 * j).+1) 1).
Definition scene_at (x : nat -> R) s :=
  let own n k := x (11 + (sumn (take n (sizes s)) + k))%N in
  mkseq (fun n => place_at (own n) (nth 0%N (kinds s) n)) (size (kinds s)).
End Scene.

(** ** Obstructed: two views share more than five points, or the cameras can slide along a star *)
Definition shown s v :=
  total s (fun i => sees_point (ft i) v || (0 < size (sees_pins (ft i) v)))%N.
Definition crowded s :=
  has (fun uv => 5 < shared s uv.1 uv.2)%N [:: (V1, V2); (V1, V3); (V2, V3)].
Definition sliding s := has (fun i => [&& 0 < nth 0 s i, 3 <= pins (ft i) &
  [|| pins (ft i) == 7,
      (pins (ft i) == 6) && (0 < total s (fun k => free (ft k))) |
      has (fun v => shown s v == 1) views]])%N (iota 0 27).
Definition obstructed s := crowded s || sliding s.

Section Rigid.
Variable R : idomainType.
Local Open Scope ring_scope.
Notation vec := (@vec R).
Notation Vec := (@Vec R).
Notation quat := (@quat R).
Notation Quat := (@Quat R).
Notation camera := (@camera R).
Notation placed := (@placed R).
Notation vec0 := (@vec0 R).
Definition conj (q : quat) := Quat (qa q) (- qb q) (- qc q) (- qd q).
Definition norm (q : quat) := qa q ^+ 2 + qb q ^+ 2 + qc q ^+ 2 + qd q ^+ 2.
Definition centre (C : camera) := rot (conj (quat_of C)) (trans C).   (* up to the factor -1/norm^2 *)
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
  flatten [seq
    d_line C T p m j :: (if l.1 then [::] else [:: dot (line C p j) dx]) | j <- l.2].
(** Normalisations that leave 11 parameters to the cameras and [dim3] to a feature. *)
Definition gauge (T : view -> twist) := T V1 = Twist vec0 vec0 /\ x1 (dt (T V2)) = 0.
Definition feature_gauge (p : placed) m :=
  (forall j, (j < pins (ft (kind p)))%N -> x3 (dD m j) = 0) /\
  (free (ft (kind p)) -> x3 (dX m) = 0).
Definition p0 := @Placed R 0 vec0 (fun _ => vec0).
(** Rigid: only the zero motion changes no image. *)
Definition rigid (C : view -> camera) (scene : seq placed) :=
  forall (T : view -> twist) (m : nat -> motion),
  gauge T ->
  (forall n, (n < size scene)%N -> let p := nth p0 scene n in feature_gauge p (m n) /\
     forall v, all (pred1 0) (image_change (C v) (T v) p (m n) (looks (ft (kind p)) v))) ->
  (forall v, T v = Twist vec0 vec0) /\
  (forall n, n < size scene -> dX (m n) = vec0 /\
     forall j, j < pins (ft (kind (nth p0 scene n))) -> dD (m n) j = vec0)%N.
Definition shape (scene : seq placed) (s : signature) :=
  all (fun p => kind p < 27)%N scene /\
  s = [seq count (fun p => kind p == i) scene | i <- iota 0 27].
(** Admissible: camera 1 is [1 | 0]; no quaternion has norm zero; the first coordinate of the
    translation of camera 2 is not zero; *the three centres are distinct*; and of each feature, the
    third coordinate of a seen point, the image of a seen line and the third coordinate of a
    direction are not zero. *)
Definition admissible (C : view -> camera) (scene : seq placed) :=
  [/\ C V1 = Camera (Quat 1 0 0 0) vec0,
      forall v, norm (quat_of (C v)) <> 0,
      x1 (trans (C V2)) <> 0,
      (forall u v, u <> v ->
         scale (norm (quat_of (C v)) ^+ 2) (centre (C u)) <>
         scale (norm (quat_of (C u)) ^+ 2) (centre (C v))) &
      forall n, (n < size scene)%N -> let p := nth p0 scene n in
      [/\ (forall v, sees_point (ft (kind p)) v -> x3 (project (C v) (point p)) <> 0),
          (forall v j, j \in sees_pins (ft (kind p)) v -> line (C v) p j <> vec0) &
          forall j, (j < pins (ft (kind p)))%N -> x3 (dir p j) <> 0]].
End Rigid.

Definition rigid_somewhere s := exists (C : view -> camera [idomainType of Z]) scene,
  [/\ shape scene s, admissible C scene & rigid C scene].
Definition rigidity : Prop :=
  (forall F : fieldType, [char F]%R =i pred0 ->
     forall s, balanced s -> minimal F (problem_of s) <-> ~~ obstructed s) /\
  (forall s, balanced s -> ~~ obstructed s <-> rigid_somewhere s) /\
  (forall (R : idomainType) (C : view -> camera R) scene s,
     shape scene s -> balanced s -> obstructed s -> admissible C scene -> ~ rigid C scene).
