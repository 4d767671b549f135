(** * Elimination modulo a prime, verified by what it preserves

    Rows are lists of machine integers below the modulus. An echelon state has one slot for each
    unknown; a filled slot i is a row with zeros before i and a one at i, of which only the part
    after i is stored. [insert] reduces a row against the slots and puts what is left into the first
    free one. The invariant is one-sided: a vector on which all inserted rows vanish modulo p makes
    every slot vanish modulo p ([insert_ok]). Hence neither primality nor the inverse routine needs
    a proof: a pivot that turns out not to be inverted is dropped. *)
From Coq Require Import ZArith List Uint63 Lia Bool.
Import ListNotations.
Local Open Scope Z_scope.

Definition p : int := 2147483629%uint63.
Definition pZ : Z := 2147483629.

Definition row := list int.
Definition state := list (option row).

(** (y + a x) mod p, entry by entry; a missing entry is zero. *)
Fixpoint add_mul (a : int) (q r : row) : row :=
  match q, r with
  | [], _ => r
  | x :: q', [] => ((a * x) mod p)%uint63 :: add_mul a q' []
  | x :: q', y :: r' => ((y + a * x) mod p)%uint63 :: add_mul a q' r'
  end.

(** Euclid: with u a = x and v a = y modulo p; any answer is checked by [insert]. *)
Fixpoint inverse_loop (fuel : nat) (x y u v : int) : int :=
  match fuel with
  | O => u
  | S fuel' => if (y =? 0)%uint63 then u else
      let k := (x / y)%uint63 in
      inverse_loop fuel' y (x - k * y)%uint63 v ((u + (p - v) * k) mod p)%uint63
  end.
Definition inverse (a : int) : int := inverse_loop 50 p a 0%uint63 1%uint63.

Fixpoint insert (st : state) (r : row) : state :=
  match st, r with
  | s :: st', a :: r' =>
    if (a =? 0)%uint63 then s :: insert st' r' else
    match s with
    | Some q => s :: insert st' (add_mul (p - a)%uint63 q r')
    | None => let c := inverse a in
        if ((a * c) mod p =? 1)%uint63 && (c <? p)%uint63 then Some (add_mul c r' []) :: st' else st
    end
  | _, _ => st
  end.

Definition insert_all (st : state) (rows : list row) : state := fold_left insert rows st.
Definition filled (s : option row) : bool := match s with Some _ => true | None => false end.
Definition full (st : state) : bool := forallb filled st.

(** ** Meaning *)
Fixpoint ev (r : row) (x : list Z) : Z :=
  match r, x with a :: r', y :: x' => to_Z a * y + ev r' x' | _, _ => 0 end.
Fixpoint holds (st : state) (x : list Z) : Prop :=
  match st, x with
  | s :: st', y :: x' => match s with Some q => (pZ | y + ev q x') | None => True end /\ holds st' x'
  | _, _ => True
  end.

Definition small (r : row) := Forall (fun a => to_Z a < pZ) r.
Definition small_st (st : state) := Forall (fun s => match s with Some q => small q | None => True end) st.

Lemma pZE : to_Z p = pZ. Proof. reflexivity. Qed.
Lemma wBE : wB = 2 ^ 63. Proof. reflexivity. Qed.

Lemma mulE a x : to_Z a < pZ -> to_Z x < pZ -> to_Z ((a * x) mod p)%uint63 = (to_Z a * to_Z x) mod pZ.
Proof.
  intros ha hx. rewrite mod_spec, mul_spec, pZE.
  pose proof (to_Z_bounded a). pose proof (to_Z_bounded x).
  rewrite (Z.mod_small _ wB); [reflexivity|]. unfold pZ in *. rewrite wBE. nia.
Qed.

Lemma add_mulE a x y : to_Z a <= pZ -> to_Z x < pZ -> to_Z y < pZ ->
  to_Z ((y + a * x) mod p)%uint63 = (to_Z y + to_Z a * to_Z x) mod pZ.
Proof.
  intros ha hx hy. rewrite mod_spec, add_spec, mul_spec, pZE.
  pose proof (to_Z_bounded a). pose proof (to_Z_bounded x). pose proof (to_Z_bounded y).
  assert (hb : 0 <= to_Z a * to_Z x <= pZ * pZ) by (unfold pZ in *; nia).
  rewrite (Z.mod_small (to_Z a * to_Z x) wB);
    [rewrite (Z.mod_small (to_Z y + to_Z a * to_Z x) wB); [reflexivity|]|];
    unfold pZ in *; rewrite wBE; lia.
Qed.

Lemma mod_small_p a : to_Z (a mod p)%uint63 < pZ.
Proof. rewrite mod_spec, pZE. apply Z.mod_pos_bound. reflexivity. Qed.

Lemma add_mul_small a q r : small q -> small r -> small (add_mul a q r).
Proof.
  revert r; induction q as [|x q IH]; intros r hq hr; [exact hr|].
  inversion hq; subst; destruct r as [|y r]; simpl; constructor; try apply mod_small_p; apply IH; auto.
  inversion hr; auto.
Qed.

(** Congruence modulo p, as a difference. *)
Definition eqm a b := (pZ | a - b).
Lemma eqm_mod z t : eqm (z mod pZ * t) (z * t).
Proof.
  exists (- (z / pZ) * t). rewrite (Z.div_mod z pZ) at 2 by discriminate. ring.
Qed.
Lemma eqm_add a b c d : eqm a b -> eqm c d -> eqm (a + c) (b + d).
Proof. intros [k hk] [l hl]. exists (k + l). lia. Qed.
Lemma eqm_refl a : eqm a a. Proof. exists 0. lia. Qed.

Lemma ev_nil_r r : ev r [] = 0. Proof. destruct r; reflexivity. Qed.

Lemma ev_add_mul a q r x : to_Z a <= pZ -> small q -> small r ->
  eqm (ev (add_mul a q r) x) (ev r x + to_Z a * ev q x).
Proof.
  intros ha; revert r x; induction q as [|b q IH]; intros r x hq hr.
  - simpl. rewrite Z.mul_0_r, Z.add_0_r. apply eqm_refl.
  - inversion hq as [|? ? hb hq']; subst.
    destruct x as [|t x]; [rewrite !ev_nil_r, Z.mul_0_r; apply eqm_refl|].
    destruct r as [|y r].
    + change (eqm (to_Z ((a * b) mod p)%uint63 * t + ev (add_mul a q []) x)
        (0 + to_Z a * (to_Z b * t + ev q x))).
      replace (0 + to_Z a * (to_Z b * t + ev q x)) with (to_Z a * to_Z b * t + (ev [] x + to_Z a * ev q x))
        by (simpl; ring).
      apply eqm_add; [|apply IH; auto].
      replace (to_Z ((a * b) mod p)%uint63) with ((to_Z a * to_Z b) mod pZ); [apply eqm_mod|].
      rewrite <- (Z.add_0_l (to_Z a * to_Z b)). change 0 with (to_Z 0%uint63).
      rewrite <- add_mulE; auto; [|reflexivity]. f_equal. f_equal.
      apply to_Z_inj. rewrite add_spec, Z.add_0_l, Z.mod_small; [reflexivity|apply to_Z_bounded].
    + inversion hr as [|? ? hy hr']; subst.
      change (eqm (to_Z ((y + a * b) mod p)%uint63 * t + ev (add_mul a q r) x)
                  (to_Z y * t + ev r x + to_Z a * (to_Z b * t + ev q x))).
      replace (to_Z y * t + ev r x + to_Z a * (to_Z b * t + ev q x))
        with ((to_Z y + to_Z a * to_Z b) * t + (ev r x + to_Z a * ev q x)) by ring.
      apply eqm_add; [|apply IH; auto]. rewrite add_mulE by auto. apply eqm_mod.
Qed.

Lemma eqm_divide a b : eqm a b -> (pZ | b) -> (pZ | a).
Proof. intros h hb. replace a with ((a - b) + b) by ring. apply Z.divide_add_r; auto. Qed.

Lemma insert_small st r : small_st st -> small r -> small_st (insert st r).
Proof.
  revert r; induction st as [|s st IH]; intros r hs hr; [exact hs|].
  destruct r as [|a r]; [exact hs|]. inversion hs as [|? ? h1 h2]; inversion hr as [|? ? h3 h4]; subst. simpl.
  destruct (a =? 0)%uint63.
  - constructor; [exact h1|]. apply IH; auto.
  - destruct s as [q|].
    + constructor; [exact h1|]. apply IH; auto. apply add_mul_small; auto.
    + destruct (_ && _); [|exact hs]. constructor; auto. apply add_mul_small; auto. constructor.
Qed.

Lemma pivot_identity q y e c r a k l m :
  e - c * r = k * q -> a * y + r = m * q -> c * a - 1 = l * q -> y + e = (k + c * m - l * y) * q.
Proof.
  intros h1 h2 h3. replace e with (k * q + c * r) by lia. replace r with (m * q - a * y) by lia.
  transitivity (k * q + c * m * q - (l * q) * y); [rewrite <- h3|]; ring.
Qed.

Lemma insert_ok st r x : small_st st -> small r -> holds st x -> (pZ | ev r x) -> holds (insert st r) x.
Proof.
  revert r x; induction st as [|s st IH]; intros r x hs hr hx hv; [exact hx|].
  destruct r as [|a r]; [exact hx|].
  destruct x as [|y x].
  { simpl. destruct (a =? 0)%uint63; [exact I|]. destruct s; [exact I|]. destruct (_ && _); exact I. }
  inversion hs as [|? ? h1 h2]; inversion hr as [|? ? h3 h4]; subst.
  destruct hx as [hx1 hx2]. simpl in hv. simpl insert.
  pose proof (to_Z_bounded a) as hab.
  destruct (a =? 0)%uint63 eqn:ea.
  - apply eqb_correct in ea. subst a. split; [exact hx1|]. apply IH; auto.
  - destruct s as [q|].
    + split; [exact hx1|]. apply IH; auto; [apply add_mul_small; auto|].
      assert (hpa : to_Z (p - a)%uint63 = pZ - to_Z a).
      { rewrite sub_spec, pZE. apply Z.mod_small. split; [lia|].
      apply Z.le_lt_trans with pZ; [lia|reflexivity]. }
      eapply eqm_divide; [apply ev_add_mul; auto; rewrite hpa; lia|].
      rewrite hpa.
      replace (ev r x + (pZ - to_Z a) * ev q x)
        with ((to_Z a * y + ev r x) + (ev q x * pZ - to_Z a * (y + ev q x))) by ring.
      apply Z.divide_add_r; [exact hv|]. apply Z.divide_sub_r; [apply Z.divide_factor_r|].
      apply Z.divide_mul_r. exact hx1.
    + destruct (_ && _) eqn:ec; [|split; [exact I|exact hx2]].
      apply andb_prop in ec. destruct ec as [e1 e2]. apply eqb_correct in e1. apply ltb_spec in e2.
      rewrite pZE in e2.
      split; [|exact hx2].
      assert (h5 : eqm (ev (add_mul (inverse a) r []) x) (ev [] x + to_Z (inverse a) * ev r x)).
      { apply ev_add_mul; auto; [lia|constructor]. }
      assert (h6 : eqm (to_Z (inverse a) * to_Z a) 1).
      { assert (h7 : (to_Z a * to_Z (inverse a)) mod pZ = 1).
        { rewrite <- mulE by auto. rewrite e1. reflexivity. }
        exists (to_Z a * to_Z (inverse a) / pZ). rewrite (Z.mul_comm (to_Z (inverse a))).
        rewrite (Z.div_mod (to_Z a * to_Z (inverse a)) pZ) at 1 by discriminate. rewrite h7. ring. }
      simpl in h5. rewrite ?Z.add_0_l in h5.
      destruct h5 as [k hk]. destruct h6 as [l hl]. destruct hv as [m hm].
      exists (k + to_Z (inverse a) * m - l * y).
      eapply pivot_identity; eauto.
Qed.

Lemma insert_all_ok rows st x : small_st st -> Forall small rows -> holds st x ->
  Forall (fun r => (pZ | ev r x)) rows -> small_st (insert_all st rows) /\ holds (insert_all st rows) x.
Proof.
  revert st; induction rows as [|r rows IH]; intros st hs hr hx hv; [auto|].
  inversion hr; inversion hv; subst. apply IH; auto using insert_small, insert_ok.
Qed.

Lemma ev_divide r x : Forall (Z.divide pZ) x -> (pZ | ev r x).
Proof.
  intros h; revert r; induction h as [|y x hy hx IH]; intros r; [rewrite ev_nil_r; apply Z.divide_0_r|].
  destruct r as [|a r]; [apply Z.divide_0_r|]. simpl.
  apply Z.divide_add_r; [apply Z.divide_mul_r; exact hy|apply IH].
Qed.

(** Where the first slots are full, the first unknowns are zero as soon as the later ones are. *)
Lemma full_zero st st' x x' : length st = length x -> full st = true -> holds (st ++ st') (x ++ x') ->
  Forall (Z.divide pZ) x' -> Forall (Z.divide pZ) x.
Proof.
  revert x; induction st as [|s st IH]; intros [|y x] hl hf hx hx'; try discriminate; auto.
  simpl in *. apply andb_prop in hf. destruct hf as [f1 f2]. destruct s as [q|]; [|discriminate].
  destruct hx as [h1 h2]. assert (h : Forall (Z.divide pZ) x) by (apply IH; auto).
  constructor; [|exact h]. apply Z.divide_add_cancel_r with (m := ev q (x ++ x')).
  - apply ev_divide. apply Forall_app. auto.
  - rewrite Z.add_comm. exact h1.
Qed.

Lemma holds_app st st' x x' : length st = length x -> holds (st ++ st') (x ++ x') -> holds st' x'.
Proof.
  revert x; induction st as [|s st IH]; intros [|y x] hl hx; try discriminate; [exact hx|].
  destruct hx as [_ hx]. simpl in hl. eapply IH; eauto.
Qed.

Definition empty (n : nat) : state := repeat None n.
Lemma holds_empty n x : holds (empty n) x.
Proof. revert x; induction n; intros [|y x]; simpl; auto. Qed.
Lemma small_empty n : small_st (empty n).
Proof. induction n; constructor; auto. Qed.

(** The slots of a state, written out as rows again. *)
Fixpoint rows_from (zeros : row) (st : state) : list row :=
  match st with
  | [] => []
  | None :: st' => rows_from (0%uint63 :: zeros) st'
  | Some q :: st' => (zeros ++ 1%uint63 :: q) :: rows_from (0%uint63 :: zeros) st'
  end.
Definition rows_of := rows_from [].

(** Integer forms, and their reduction. *)
Fixpoint evZ (f : list Z) (x : list Z) : Z :=
  match f, x with a :: f', y :: x' => a * y + evZ f' x' | _, _ => 0 end.
Definition reduce (f : list Z) : row := map (fun z => of_Z (z mod pZ)) f.

Lemma to_of_mod z : to_Z (of_Z (z mod pZ)) = z mod pZ.
Proof.
  rewrite of_Z_spec. apply Z.mod_small. pose proof (Z.mod_pos_bound z pZ eq_refl) as h.
  split; [lia|]. apply Z.lt_trans with pZ; [lia|reflexivity].
Qed.
Lemma reduce_small f : small (reduce f).
Proof.
  apply Forall_forall. intros a ha. apply in_map_iff in ha. destruct ha as [z [<- _]].
  rewrite to_of_mod. apply Z.mod_pos_bound. reflexivity.
Qed.
Lemma reduce_ev f x : eqm (ev (reduce f) x) (evZ f x).
Proof.
  revert x; induction f as [|a f IH]; intros [|y x]; try apply eqm_refl. simpl.
  apply eqm_add; [|apply IH]. rewrite to_of_mod. apply eqm_mod.
Qed.

Lemma ev_zeros k r y x : length y = k -> ev (repeat 0%uint63 k ++ r) (y ++ x) = ev r x.
Proof. revert y; induction k; intros [|t y] h; try discriminate; [reflexivity|]. simpl.
rewrite IHk; auto. Qed.

Lemma rows_from_ok k st y x : length y = k -> length x = length st -> small_st st -> holds st x ->
  Forall (fun r => small r /\ (pZ | ev r (y ++ x))) (rows_from (repeat 0%uint63 k) st).
Proof.
  revert k y x; induction st as [|s st IH]; intros k y x hy hl hs hx; [constructor|].
  destruct x as [|t x]; [discriminate|]. inversion hs; subst. destruct hx as [h1 h2].
  assert (tail : Forall (fun r => small r /\ (pZ | ev r (y ++ t :: x)))
    (rows_from (repeat 0%uint63 (S (length y))) st)).
  { replace (y ++ t :: x) with ((y ++ [t]) ++ x) by (rewrite <- app_assoc; reflexivity).
    apply IH; auto. rewrite app_length. simpl. lia. }
  destruct s as [q|]; simpl; auto.
  constructor; [|exact tail]. split.
  - apply Forall_app. split; [|constructor; [reflexivity|assumption]].
    apply Forall_forall. intros a ha. apply repeat_spec in ha. subst a. reflexivity.
  - rewrite ev_zeros by reflexivity. change (ev (1%uint63 :: q) (t :: x)) with (to_Z 1 * t + ev q x).
    rewrite to_Z_1, Z.mul_1_l. exact h1.
Qed.

Lemma rows_of_ok st x : length x = length st -> small_st st -> holds st x ->
  Forall (fun r => small r /\ (pZ | ev r x)) (rows_of st).
Proof. intros. apply (rows_from_ok 0 st [] x); auto. Qed.

(** ** Descent: what vanishes to every order is zero *)
Lemma infinitely_divisible z : (forall k, 0 <= k -> (pZ ^ k | z)) -> z = 0.
Proof.
  intros h. destruct (Z.eq_dec z 0) as [e|ne]; [exact e|exfalso].
  assert (hk := h (Z.abs z) (Z.abs_nonneg z)). apply Z.divide_abs_r in hk.
  apply Z.divide_pos_le in hk; [|lia].
  pose proof (Z.pow_gt_lin_r pZ (Z.abs z) eq_refl (Z.abs_nonneg z)). lia.
Qed.

Lemma evZ_scale f k x : evZ f (map (Z.mul k) x) = k * evZ f x.
Proof. revert x; induction f as [|a f IH]; intros [|y x]; simpl; try ring. rewrite IH. ring. Qed.
