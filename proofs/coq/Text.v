(** * The notation of problems, as text: definitions, and what is proved of its reader

    [written f] is the text of a feature: what the three views see of it, then what none sees
    ([P/Pa/a], [a/b/-], [P/P/P(a)]; FORMAT.md, section 1, says the same in words). A problem is a sum
    of features, with counts: [2*P/P/P + a/a/a]. [means s A]: the text s stands for the problem A. *)
From Coq Require Import Ascii String List.
From mathcomp Require Import all_ssreflect.
From PL1P Require Import Statement.
Set Implicit Arguments.
Unset Strict Implicit.
Unset Printing Implicit Defensive.

Lemma ascii_eqP : Equality.axiom Ascii.eqb.
Proof. by move=> x y; apply: (iffP idP) => /Ascii.eqb_eq. Qed.
Canonical ascii_eqType := EqType ascii (EqMixin ascii_eqP).
Notation text := (seq ascii).

(** ** Text of a feature *)
Definition letters : text := list_ascii_of_string "abcdefghijklmnopqrstuvwxyz".
Definition in_order (js : seq nat) : text := [seq nth "?"%char letters j | j <- sort leq js].
Definition symbol (l : look) : text :=
  if l.1 then "P"%char :: in_order l.2 else if l.2 is [::] then [:: "-"%char] else in_order l.2.
(** What no view sees. A point with two pins or more needs no mention. *)
Definition unseen_point f := [&& ~~ free f, pins f <= 1 & ~~ has (sees_point f) views].
Definition unseen_pins f :=
  [seq j <- iota 0 (pins f) | ~~ has (fun v => j \in sees_pins f v) views].
Definition unseen f : text :=
  (if unseen_point f then [:: "P"%char] else [::]) ++ in_order (unseen_pins f).
Definition written f : text := symbol (looks f V1) ++ "/"%char :: symbol (looks f V2) ++ "/"%char ::
  symbol (looks f V3) ++ (if unseen f is [::] then [::] else "("%char :: unseen f ++ [:: ")"%char]).
Definition writable f := proper f && (pins f <= 26).

(** ** Text of a problem *)
Fixpoint split (c : ascii) (s : text) : seq text :=
  if s is x :: s' then
    if x == c then [::] :: split c s' else let ps := split c s' in (x :: head [::] ps) :: behead ps
  else [:: [::]].
Definition after_blanks (s : text) := drop (find (fun c => c != " "%char) s) s.
Definition trim (s : text) := rev (after_blanks (rev (after_blanks s))).
(** The terms of a sum, each in parts: the feature, perhaps a count before it; without the blanks at
    the ends of parts. *)
Definition terms (s : string) : seq (seq text) :=
  [seq map trim (split "*" t) | t <- split "+" (list_ascii_of_string s)].
Definition digits : text := list_ascii_of_string "0123456789".
(** A number below 10,000. *)
Fixpoint decimal_from fuel n (acc : text) : text :=
  let acc' := nth "?"%char digits (n %% 10) :: acc in
  if fuel is fuel'.+1 then if n < 10 then acc' else decimal_from fuel' (n %/ 10) acc' else acc'.
Definition decimal n := decimal_from 3 n [::].
Inductive term_means : seq text -> problem -> Prop :=
  | one_feature f : writable f -> term_means [:: written f] [:: f]
  | counted n f : writable f -> 0 < n <= 1000 -> term_means [:: decimal n; written f] (nseq n f).
Definition means s A := exists2 Bs, A = flatten Bs & Forall2 term_means (terms s) Bs.

(** ** The reader *)
Definition look_of (s : text) : look :=
  ("P"%char \in s, [seq index c letters | c <- s & c \in letters]).
Definition feature_of (s : text) : feature :=
  let ps := split "/" s in let qs := split "(" (nth [::] ps 2) in
  let l1 := look_of (nth [::] ps 0) in let l2 := look_of (nth [::] ps 1) in
  let l3 := look_of (nth [::] qs 0) in let u := look_of (nth [::] qs 1) in
  let k := foldr (fun j m => maxn j.+1 m) 0 (l1.2 ++ l2.2 ++ l3.2 ++ u.2) in
  Feature (~~ [|| l1.1, l2.1, l3.1, u.1 | 1 < k]) k (by_view l1 l2 l3).
(** What is read is written again, and compared. *)
Definition parse_feature (s : text) : option feature :=
  let f := feature_of s in if writable f && (written f == s) then Some f else None.
Definition number_of (s : text) := foldl (fun n c => 10 * n + index c digits) 0 s.
Definition parse_count (s : text) : option nat :=
  if size s <= 4 then let n := number_of s in
    if (0 < n <= 1000) && (decimal n == s) then Some n else None
  else None.
Definition parse_term (ps : seq text) : option problem := match ps with
  | [:: s] => if parse_feature s is Some f then Some [:: f] else None
  | [:: c; s] =>
      if parse_count c is Some n then if parse_feature s is Some f then Some (nseq n f) else None
      else None
  | _ => None end.
Fixpoint parse_terms (ts : seq (seq text)) : option problem :=
  if ts is t :: ts' then
    if parse_term t is Some B then if parse_terms ts' is Some A then Some (B ++ A) else None else None
  else Some [::].
Definition parse (s : string) : option problem := parse_terms (terms s).
Definition print (A : problem) : string := string_of_list_ascii
  (flatten (if A is f :: A' then written f :: [seq list_ascii_of_string " + " ++ written g | g <- A']
    else [::])).

(** ** What is proved: what is read is meant; what means a problem is read as one that differs only
    in the names of the pins and their order in a look; each problem of at most 26 pins a point can
    be written. *)
Definition reader : Prop :=
  [/\ forall s A, parse s = Some A -> means s A /\ is_problem A,
      forall s A, means s A -> exists2 B, parse s = Some B & all2 same A B &
      forall A, A <> [::] -> all writable A -> means (print A) A].
