(** * Enumeration of the solutions of the balance equation, and walks that visit each once

    [sols ws n] lists the vectors s with sum s_i ws_i = n (proved complete and without repetition);
    [walk] visits the same vectors depth first, carrying a state along the tree, without building
    the list. *)
From Coq Require Import NArith.
From mathcomp Require Import all_ssreflect.
From PL1P Require Import Statement.
Set Implicit Arguments.
Unset Strict Implicit.
Unset Printing Implicit Defensive.

Fixpoint sols (ws : seq nat) (n : nat) : seq (seq nat) :=
  if ws is w :: ws' then flatten [seq map (cons k) (sols ws' (n - k * w)) | k <- iota 0 n.+1 & k * w <= n]
  else if n is 0 then [:: [::]] else [::].

Fixpoint dotn (s ws : seq nat) := if s is x :: s' then if ws is w :: ws' then x * w + dotn s' ws' else 0
  else 0.

Lemma sols_cons w ws n : sols (w :: ws) n =
  [seq k :: s | k <- [seq k <- iota 0 n.+1 | k * w <= n], s <- sols ws (n - k * w)].
Proof. by []. Qed.

Lemma sols_mem ws n s : all (ltn 0) ws -> (s \in sols ws n) = (size s == size ws) && (dotn s ws == n).
Proof.
elim: ws n s => [|w ws IH] n s; first by case: s n => [|x s] [|n].
move=> /andP[w0 ws0]; rewrite sols_cons; apply/allpairsPdep/andP.
  case=> k [s' []]; rewrite mem_filter IH // => /andP[le _] /andP[/eqP ss /eqP dn] -> /=.
  by rewrite ss dn subnKC.
case: s => [|x s] [] // ss dn.
have {}ss : size s == size ws := ss.
have {}dn : x * w + dotn s ws = n := eqP dn.
exists x, s; rewrite mem_filter IH // -dn leq_addr addKn eqxx mem_iota add0n ltnS ss; split=> //.
by rewrite (leq_trans _ (leq_addr _ _)) // leq_pmulr.
Qed.

Lemma sols_uniq ws n : uniq (sols ws n).
Proof.
elim: ws n => [|w ws IH] n; first by case: n.
rewrite sols_cons; apply: allpairs_uniq_dep => [|k _|[k s] [k1 s1] _ _ [-> ->]] //.
by rewrite filter_uniq ?iota_uniq.
Qed.

(** The walk. [step i k st] is the state after taking one more copy (number k) of item i. *)
Section Walk.
Variables (A St : Type) (step : nat -> nat -> St -> St) (leaf : seq nat -> St -> A -> A).

Fixpoint copies (visit : nat -> St -> seq nat -> A -> A) i w pre fuel k n st acc :=
  let acc' := visit n st (k :: pre) acc in
  if fuel is fuel'.+1 then
    if w <= n then copies visit i w pre fuel' k.+1 (n - w) (step i k st) acc' else acc'
  else acc'.

Fixpoint walk (ws : seq nat) (i n : nat) (st : St) (pre : seq nat) (acc : A) : A :=
  if ws is w :: ws' then copies (walk ws' i.+1) i w pre n 0 n st acc
  else if n is 0 then leaf pre st acc else acc.

Fixpoint take_copies i k m st := if m is m'.+1 then take_copies i k.+1 m' (step i k st) else st.
Fixpoint run i s st := if s is m :: s' then run i.+1 s' (take_copies i 0 m st) else st.
(** The state after a first item of which k copies are already in. *)
Definition run_from k i s st := if s is x :: s' then run i.+1 s' (take_copies i k (x - k) st) else st.

Lemma walkE ws i n st pre acc : all (ltn 0) ws ->
  walk ws i n st pre acc = foldl (fun acc s => leaf (catrev s pre) (run i s st) acc) acc (sols ws n).
Proof.
elim: ws i n st pre acc => [|w ws IH] i n st pre acc; first by case: n.
move=> /andP[w0 ws0].
have copiesE fuel k m st' acc' : m <= fuel ->
  copies (walk ws i.+1) i w pre fuel k m st' acc' =
  foldl (fun acc s => leaf (catrev s pre) (run_from k i s st') acc) acc'
    (flatten [seq map (cons (k + j)) (sols ws (m - j * w)) | j <- [seq j <- iota 0 fuel.+1 | j * w <= m]]).
  have e m' l : [seq j <- 0 :: l | j * w <= m'] = 0 :: [seq j <- l | j * w <= m'] by [].
  have here k' m' st2 acc2 : walk ws i.+1 m' st2 (k' :: pre) acc2 =
      foldl (fun acc s => leaf (catrev s pre) (run_from k' i s st2) acc) acc2 (map (cons k') (sols ws m')).
    by rewrite IH //; elim: (sols ws m') acc2 => //= s l IHl acc2; rewrite IHl subnn.
  elim: fuel k m st' acc' => [|fuel IHf] k m st' acc' mf.
    by move: mf; rewrite leqn0 => /eqP ->; rewrite e /= here cats0 addn0.
  have -> : [seq j <- iota 0 fuel.+2 | j * w <= m] = 0 :: map succn [seq j <- iota 0 fuel.+1 | j.+1 * w <= m].
    by rewrite -[iota 0 fuel.+2]/(0 :: iota 1 fuel.+1) e (iotaDl 1 0) filter_map.
  rewrite map_cons -[flatten (_ :: _)]/(_ ++ _) foldl_cat mul0n subn0 addn0 -here.
  rewrite [LHS]/=; move: (walk _ _ _ _ _ _) => acc2.
  case: leqP => [wm|mw]; last first.
    rewrite (_ : filter _ _ = [::]) //; apply/eqP; rewrite -[_ == _]negbK -has_filter.
    by apply/hasPn => j _; rewrite -ltnNge (leq_trans mw) // leq_pmull.
  rewrite IHf; last by rewrite -ltnS (leq_trans _ mf) // -subn_gt0 subKn // (leq_trans w0).
  rewrite -map_comp.
  have -> : [seq j <- iota 0 fuel.+1 | j * w <= m - w] = [seq j <- iota 0 fuel.+1 | j.+1 * w <= m].
    by apply: eq_filter => j; rewrite mulSn -leq_subRL.
  set l := [seq j <- _ | _].
  elim: l acc2 => // j l IHl acc2; rewrite 2!map_cons -![flatten (_ :: _)]/(_ ++ _) !foldl_cat IHl;
    congr foldl.
  rewrite /= mulSn subnDA addSnnS.
  elim: (sols ws _) acc2 => // s t IHt acc2; rewrite !map_cons [LHS]/= [RHS]/= IHt;
    congr (foldl _ (leaf _ (run _ _ _) _)).
  by rewrite addKn addnS subSS addKn.
rewrite -[LHS]/(copies _ _ _ _ _ _ _ _ _) copiesE // -[sols _ _]/(flatten _).
by elim: (flatten _) acc => // s l IHl acc; rewrite [LHS]/= [RHS]/= IHl; case: s => //= x s; rewrite subn0.
Qed.
End Walk.

(** ** Balanced signatures *)
Definition ws := Eval vm_compute in [seq weight i | i <- iota 0 27].
Lemma wsE : ws = [seq weight i | i <- iota 0 27]. Proof. by vm_compute. Qed.

(** A total is a dot product with the vector of the 27 values of h. *)
Definition coefs (h : nat -> nat) := [seq h i | i <- iota 0 27].

Lemma dotn_map l (f h : nat -> nat) : dotn (map f l) (map h l) = sumn [seq f i * h i | i <- l].
Proof. by elim: l => //= i l ->. Qed.

Lemma totalE s h : size s = 27 -> total s h = dotn s (coefs h).
Proof. by move=> ss; rewrite -{2}(mkseq_nth 0 s) ss dotn_map. Qed.

Definition balanced_list := sols ws 11.

Lemma balanced_mem s : (s \in balanced_list) = balanced s.
Proof.
rewrite sols_mem // /balanced; case: eqP => //= ss.
by rewrite totalE // wsE.
Qed.

Lemma balanced_uniq : uniq balanced_list. Proof. exact: sols_uniq. Qed.

(** ** Counting several properties in one walk *)
Fixpoint bump (bs : seq bool) (acc : seq N) : seq N :=
  if bs is b :: bs' then if acc is c :: acc' then (if b then N.succ c else c) :: bump bs' acc' else acc
    else acc.

Lemma bumpE (flags : seq nat -> seq bool) k (l : seq (seq nat)) acc j : (forall s, size (flags s) = k) ->
  size acc = k -> j < k ->
  nth N0 (foldl (fun acc s => bump (flags s) acc) acc l) j =
  N.add (nth N0 acc j) (N.of_nat (count (fun s => nth false (flags s) j) l)).
Proof.
move=> fk; elim: l acc => [|s l IH] acc sk jk /=; first by rewrite N.add_0_r.
have sb bs : size (bump bs acc) = size acc by elim: acc bs {sk} => [|c acc IHa] [|b bs] //=; rewrite IHa.
rewrite IH ?sb //.
have -> : nth N0 (bump (flags s) acc) j = N.add (nth N0 acc j) (N.of_nat (nth false (flags s) j)).
  move: (flags s) (fk s) acc sk j jk {IH sb} => bs; elim: bs k {fk} => [|b bs IHb] [|k] //= [] e [|c acc] //=
    [] e' [|j] //=.
    by case: b => /= _; rewrite ?N.add_0_r // N.add_1_r.
  by move=> jk; rewrite (IHb k).
by rewrite Nnat.Nat2N.inj_add N.add_assoc.
Qed.
