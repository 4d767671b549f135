(** * The reader of Text.v is right *)
From Coq Require Import Ascii String List.
From mathcomp Require Import all_ssreflect.
From mathcomp.zify Require Import zify.
From PL1P Require Import Statement Reducible Problems Forget SameProblem Text.
Set Implicit Arguments.
Unset Strict Implicit.
Unset Printing Implicit Defensive.

(** ** Texts in pieces *)
Lemma split_last c s : c \notin s -> split c s = [:: s].
Proof. by elim: s => //= x s IH; rewrite inE negb_or eq_sym => /andP[/negbTE -> /IH ->]. Qed.
Lemma split_cat c s t : c \notin s -> split c (s ++ c :: t) = s :: split c t.
Proof.
by elim: s => /= [|x s IH]; rewrite ?eqxx // inE negb_or eq_sym => /andP[/negbTE -> /IH ->].
Qed.

(** Letters and other signs. *)
Definition sign c := c \notin letters.
Lemma letter_index j : j < 26 -> index (nth "?"%char letters j) letters = j.
Proof. by move=> lt; rewrite index_uniq. Qed.
Lemma letter_in j : j < 26 -> nth "?"%char letters j \in letters.
Proof. by move=> lt; apply: mem_nth. Qed.
Lemma signP c : c \in [:: "P"; "-"; "/"; "("; ")"; " "; "+"; "*"]%char -> sign c.
Proof. by move=> h; apply: (allP (_ : all sign [:: "P"; "-"; "/"; "("; ")"; " "; "+"; "*"]%char)). Qed.
Local Opaque letters.
Definition small (js : seq nat) := all (fun j => j < 26) js.
Lemma small_sort js : small (sort leq js) = small js. Proof. exact: all_sort. Qed.
Lemma sign_in_order c js : sign c -> small js -> c \notin in_order js.
Proof.
rewrite -small_sort => sc /allP le; apply/negP => /mapP[j /le lt e].
by move: sc; rewrite /sign e letter_in.
Qed.
Lemma in_order_read js : small js ->
  [seq index c letters | c <- in_order js & c \in letters] = sort leq js.
Proof.
rewrite -small_sort /in_order => /allP; elim: (sort leq js) => //= j l IH le.
have lt := le j (mem_head _ _); rewrite letter_in // [map _ _]/= letter_index // IH // => i il.
by apply: le; rewrite inE il orbT.
Qed.
Lemma look_symbol l : small l.2 -> look_of (symbol l) = (l.1, sort leq l.2).
Proof.
case: l => p js /= sm; rewrite /symbol /look_of /=; case: p.
  by rewrite mem_head [filter _ _]/= in_order_read.
case: js sm => // j js sm; rewrite in_order_read //; congr (_, _).
by apply/negbTE; exact: sign_in_order.
Qed.
Lemma sign_symbol c l : sign c -> small l.2 -> c \notin [:: "P"%char; "-"%char] -> c \notin symbol l.
Proof.
case: l => p js /= sc sm; rewrite !inE negb_or => /andP[cP cm]; rewrite /symbol /=.
by case: p; [|case: js sm => [_|j js sm]]; rewrite ?inE ?negb_or ?cP ?cm ?sign_in_order.
Qed.
Lemma unseen_read f : small (unseen_pins f) -> let u := unseen f in
  look_of (u ++ [:: ")"%char]) = (unseen_point f, sort leq (unseen_pins f)).
Proof.
move=> sm /=; rewrite /look_of /unseen !mem_cat filter_cat /= cats0.
rewrite filter_cat map_cat in_order_read //; congr (_, _); last by case: (unseen_point f).
have -> : ("P"%char \in in_order (unseen_pins f)) = false by apply/negbTE; exact: sign_in_order.
by case: (unseen_point f).
Qed.

(** ** A feature that is written and read again *)
Section Feature.
Variable f : feature.
Hypothesis wf : writable f.
Let pf : proper f. Proof. by case/andP: wf. Qed.
Let k26 : pins f <= 26. Proof. by case/andP: wf. Qed.
Lemma small_pins js : all (fun j => j < pins f) js -> small js.
Proof. by apply: sub_all => j lt; exact: leq_trans k26. Qed.
Lemma small_look v : small (looks f v).2.
Proof. by have [_ le _] := properP v pf; exact: small_pins. Qed.
Lemma unseen_below : all (fun j => j < pins f) (unseen_pins f).
Proof. by apply/allP => j; rewrite mem_filter mem_iota => /andP[]. Qed.

Definition sorted_look v : look := ((looks f v).1, sort leq (looks f v).2).
Definition again := Feature (free f) (pins f) (by_view (sorted_look V1) (sorted_look V2) (sorted_look V3)).
Lemma looks_again v : looks again v = sorted_look v. Proof. by case: v. Qed.

Lemma pieces : let ps := split "/" (written f) in let qs := split "(" (nth [::] ps 2) in
  [/\ look_of (nth [::] ps 0) = sorted_look V1, look_of (nth [::] ps 1) = sorted_look V2,
      look_of (nth [::] qs 0) = sorted_look V3 &
      look_of (nth [::] qs 1) = (unseen_point f, sort leq (unseen_pins f))].
Proof.
have sl v : "/"%char \notin symbol (looks f v) by apply: sign_symbol (small_look v) _ => //; exact: signP.
have so v : "("%char \notin symbol (looks f v) by apply: sign_symbol (small_look v) _ => //; exact: signP.
have su : small (unseen_pins f) := small_pins unseen_below.
have ul c : sign c -> c != "P"%char -> c \notin unseen f.
  move=> sc cP; rewrite /unseen mem_cat negb_or sign_in_order // andbT.
  by case: (unseen_point f); rewrite // inE.
have tail : "/"%char \notin symbol (looks f V3) ++
    (if unseen f is [::] then [::] else "("%char :: unseen f ++ [:: ")"%char]).
  rewrite mem_cat negb_or sl; case e: (unseen f) => //; rewrite -e inE negb_or mem_cat negb_or.
  by rewrite ul.
rewrite /written split_cat // split_cat // split_last //=.
rewrite !look_symbol; try exact: small_look; rewrite -/(sorted_look _); split=> //.
  case e: (unseen f) => [|c u]; first by rewrite cats0 split_last // look_symbol //; exact: small_look.
  by rewrite split_cat // [nth _ _ _]/= look_symbol //; exact: small_look.
have ur := unseen_read su; case e: (unseen f) => [|c u]; last first.
  rewrite -e split_cat // split_last /=; first exact: ur.
  by rewrite mem_cat negb_or ul.
rewrite cats0 split_last //=; move: ur; rewrite e /look_of /= => -[<- <-]; congr (_, _).
Qed.

Lemma pins_read : foldr (fun j m => maxn j.+1 m) 0 ((sorted_look V1).2 ++ (sorted_look V2).2 ++
  (sorted_look V3).2 ++ sort leq (unseen_pins f)) = pins f.
Proof.
set l := _ ++ _.
have le : all (fun j => j < pins f) l.
  by rewrite /l !all_cat !all_sort unseen_below; have [_ -> _] := properP V1 pf;
     have [_ -> _] := properP V2 pf; have [_ -> _] := properP V3 pf.
have mem j : j < pins f -> j \in l.
  move=> lt; rewrite /l !mem_cat !mem_sort mem_filter mem_iota add0n lt andbT /=.
  by rewrite -!/(sees_pins f _) orbF !negb_or; case: (_ \in _); case: (_ \in _); case: (_ \in _).
have up : foldr (fun j m => maxn j.+1 m) 0 l <= pins f.
  elim: l le {mem} => //= j l IH /andP[lt /IH h]; by rewrite geq_max lt.
have low j : j \in l -> j < foldr (fun j m => maxn j.+1 m) 0 l.
  elim: l {le mem up} => //= i l IH; rewrite inE leq_max => /orP[/eqP ->|/IH ->]; rewrite ?leqnn ?orbT //.
apply/eqP; rewrite eqn_leq up /=; case e: (pins f) => [|k] //; rewrite -ltnS ltnS.
by apply: low; apply: mem; rewrite e.
Qed.
Lemma read_written : feature_of (written f) = again.
Proof.
rewrite /feature_of; case: pieces => -> -> -> ->; rewrite [(_, sort _ _).2]/= pins_read /again; congr Feature.
rewrite /unseen_point -!/(sees_point f _) /= orbF.
case fr: (free f).
  have k1 : pins f = 1 by exact: free_pins.
  have np v : sees_point f v = false by have [_ _] := properP v pf; rewrite fr => /negbTE.
  by rewrite -!/(sees_point f _) !np k1.
rewrite -!/(sees_point f _) ltnNge.
by case: (sees_point f V1); case: (sees_point f V2); case: (sees_point f V3); case: (pins f <= 1).
Qed.
Lemma same_again : same f again.
Proof.
apply/sameP; split=> //; exists (iota 0 (pins f)) => // v; rewrite looks_again.
have [_ /allP le _] := properP v pf; rewrite /same_look /sorted_look eqxx /= perm_sym perm_sort.
rewrite (_ : map _ _ = (looks f v).2) // -[RHS]map_id; apply/eq_in_map => j /le lt.
by rewrite nth_iota ?add0n.
Qed.
Lemma proper_again : proper again.
Proof.
pose ok g v := let: (p, js) := looks g v in
  [&& uniq js, all (fun j => j < pins g) js & if free g then ~~ p else p || (size js <= 1)].
have e g : proper g = (free g ==> (pins g == 1)) && [&& ok g V1, ok g V2, ok g V3 & true] by [].
have one v : ok again v = ok f v.
  rewrite /ok looks_again /sorted_look; case: (looks f v) => p js /=.
  by rewrite sort_uniq all_sort size_sort.
by have := pf; rewrite !e !one.
Qed.
Lemma written_again : written again = written f.
Proof.
have so js : sort leq (sort leq js) = sort leq js.
  by apply: sorted_sort (sort_sorted leq_total js); exact: leq_trans.
have sy v : symbol (looks again v) = symbol (looks f v).
  rewrite looks_again /symbol /sorted_look /=; case: (looks f v) => p js /=.
  rewrite /in_order so; case: p => //; case: js => // j js.
  by case e: (sort leq (j :: js)) => //; have := size_sort leq (j :: js); rewrite e.
have up : unseen_point again = unseen_point f by [].
have uj : unseen_pins again = unseen_pins f.
  by apply: eq_filter => j; rewrite /sees_pins /= !mem_sort.
by rewrite /written !sy /unseen up uj.
Qed.
Lemma parse_written : parse_feature (written f) = Some again.
Proof.
rewrite /parse_feature read_written written_again eqxx andbT /writable proper_again.
by have -> : pins again <= 26.
Qed.
End Feature.

(** ** Terms and sums *)
Lemma parse_featureP s f : parse_feature s = Some f -> writable f /\ s = written f.
Proof. by rewrite /parse_feature; case: ifP => // /andP[w /eqP e] [<-]. Qed.
Lemma parse_countP s n : parse_count s = Some n -> 0 < n <= 1000 /\ s = decimal n.
Proof. by rewrite /parse_count; case: ifP => // _; case: ifP => // /andP[h /eqP e] [<-]. Qed.
Lemma parse_termP t A : parse_term t = Some A -> term_means t A.
Proof.
case: t => [|s [|s' [|]]] //=.
  by case e: (parse_feature s) => [f|] // [<-]; have [w ->] := parse_featureP e; constructor.
case e: (parse_count s) => [n|] //; case e': (parse_feature s') => [f|] // [<-].
by have [h ->] := parse_countP e; have [w ->] := parse_featureP e'; constructor.
Qed.
Lemma parse_meant s A : parse s = Some A -> means s A.
Proof.
rewrite /parse /means; elim: (terms s) A => [|t ts IH] A /=; first by case=> <-; exists [::].
case e: (parse_term t) => [B|] //; case e': (parse_terms ts) => [A'|] // [<-].
have [Bs -> h] := IH _ e'; exists (B :: Bs) => //; constructor=> //; exact: parse_termP.
Qed.
Lemma means_problem s A : means s A -> is_problem A.
Proof.
case=> Bs ->; elim=> // t B ts Bs' tB _; rewrite /is_problem /= all_cat => ->; rewrite andbT.
case: tB => [f|n f] /andP[pf _]; first by rewrite /is_problem /= pf.
by move=> _; rewrite /is_problem all_nseq pf orbT.
Qed.

Lemma decimal_read : all (fun n => (0 < n) ==> (parse_count (decimal n) == Some n)) (iota 0 1001).
Proof. by vm_compute. Qed.
Lemma parse_decimal n : 0 < n <= 1000 -> parse_count (decimal n) = Some n.
Proof.
move=> /andP[n0 le]; have := allP decimal_read n; rewrite mem_iota add0n ltnS => /(_ le).
by rewrite n0 => /eqP.
Qed.
Lemma all2_cat (a1 b1 a2 b2 : problem) :
  all2 same a1 b1 -> all2 same a2 b2 -> all2 same (a1 ++ a2) (b1 ++ b2).
Proof. by elim: a1 b1 => [|x a1 IH1] [|y b1] //= /andP[-> /IH1 h1] /h1. Qed.
Lemma means_term t A : term_means t A -> exists2 B, parse_term t = Some B & all2 same A B.
Proof.
case=> [f wf|n f wf hn]; rewrite /parse_term ?parse_decimal // parse_written //.
  by exists [:: again f]; rewrite //= same_again.
exists (nseq n (again f)) => //; elim: n {hn} => //= n ->; by rewrite same_again.
Qed.
Lemma means_parse s A : means s A -> exists2 B, parse s = Some B & all2 same A B.
Proof.
rewrite /means /parse => -[Bs ->]; elim=> [|t B ts Bs' tB _ [A' e h]]; first by exists [::].
have [B' e' h'] := means_term tB; exists (B' ++ A'); last exact: all2_cat.
by rewrite /= e' e.
Qed.

(** ** Every problem can be written *)
Lemma written_free c f : writable f -> sign c -> c \notin [:: "P"; "-"; "/"; "("; ")"]%char ->
  c \notin written f.
Proof.
move=> wf sc; rewrite !inE !negb_or => /and5P[cP cm cs co cc].
have sy v : c \notin symbol (looks f v).
  by apply: sign_symbol => //; [exact: small_look | rewrite !inE negb_or cP cm].
have cu : c \notin unseen f.
  rewrite /unseen mem_cat negb_or sign_in_order ?andbT //; last exact: small_pins wf _ (unseen_below f).
  by case: (unseen_point f); rewrite // inE.
rewrite /written mem_cat inE mem_cat inE mem_cat !negb_or !sy cs !andTb.
by move: cu; case: (unseen f) => // x u /negbTE cu; rewrite in_cons mem_cat cu mem_seq1 !negb_or co cc.
Qed.
Lemma trim_written f : writable f -> let w := written f in
  [/\ trim w = w, trim (w ++ [:: " "%char]) = w, trim (" "%char :: w) = w &
      trim (" "%char :: w ++ [:: " "%char]) = w].
Proof.
move=> wf; set w := written f; have nb : " "%char \notin w by exact: written_free.
have ne : w <> [::] by rewrite /w /written; case: (symbol _).
clearbody w => /=.
have none s : " "%char \notin s -> find (fun c => c != " "%char) s = 0.
  by case: s => //= x s; rewrite inE negb_or eq_sym => /andP[-> _].
have h : find (fun c => c != " "%char) w = 0 by exact: none.
have hr : find (fun c => c != " "%char) (rev w) = 0 by apply: none; rewrite mem_rev.
have hc t : find (fun c => c != " "%char) (w ++ t) = 0.
  by case: w ne nb {h hr} => //= x s _; rewrite inE negb_or eq_sym => /andP[-> _].
by rewrite /trim /after_blanks /= !h !hc !drop0 !rev_cat /= hr !drop0 revK.
Qed.
Lemma print_means A : A <> [::] -> all writable A -> means (print A) A.
Proof.
move=> ne wA; exists [seq [:: f] | f <- A]; first by elim: A {ne wA} => //= f A <-.
rewrite /terms /print list_ascii_of_string_of_list_ascii.
have sp f : writable f -> "+"%char \notin written f by move=> wf; exact: written_free.
have st f : writable f -> "*"%char \notin written f by move=> wf; exact: written_free.
have one f t : writable f -> t \in [:: written f; written f ++ [:: " "%char]; " "%char :: written f;
    " "%char :: written f ++ [:: " "%char]] -> term_means (map trim (split "*" t)) [:: f].
  move=> wf h; have [t1 t2 t3 t4] := trim_written wf; rewrite split_last.
    have -> : map trim [:: t] = [:: written f].
      by move: h; rewrite !inE => /or4P[]/eqP -> /=; rewrite ?t1 ?t2 ?t3 ?t4.
    exact: one_feature.
  move: h (st f wf); move: (written f) => w; rewrite !inE => /or4P[]/eqP ->;
    by rewrite ?(in_cons, mem_cat, mem_seq1) => /negbTE ->.
have rest A' p f : writable f -> all writable A' -> p \in [:: [::]; [:: " "%char]] ->
    Forall2 term_means [seq map trim (split "*" t) | t <- split "+" (p ++ written f ++
      flatten [seq list_ascii_of_string " + " ++ written g | g <- A'])] [seq [:: g] | g <- f :: A'].
  elim: A' p f => [|g A' IH] p f wf wA' hp.
    rewrite cats0 split_last; last by
      rewrite mem_cat negb_or sp // andbT; move: hp; rewrite !inE => /orP[]/eqP ->.
    constructor=> //; apply: one => //; by move: hp; rewrite !inE => /orP[]/eqP -> /=; rewrite eqxx ?orbT.
  case/andP: wA' => wg wA'.
  have -> : p ++ written f ++ flatten [seq list_ascii_of_string " + " ++ written h | h <- g :: A'] =
      (p ++ written f ++ [:: " "%char]) ++ "+"%char :: ([:: " "%char] ++ written g ++
        flatten [seq list_ascii_of_string " + " ++ written h | h <- A']).
    rewrite [flatten (map _ (g :: A'))]/=; move: (written f) (written g) (flatten _) => a b r.
    by rewrite /= -!catA.
  rewrite split_cat; last first.
    by rewrite mem_cat mem_cat !negb_or sp // andbT; move: hp; rewrite !inE => /orP[]/eqP ->.
  constructor; last exact: (IH [:: " "%char] g wg wA' isT).
  apply: one => //; by move: hp; rewrite !inE => /orP[]/eqP -> /=; rewrite eqxx ?orbT.
case: A ne wA => // f A _ /andP[wf wA]; exact: (rest A [::] f wf wA).
Qed.

Theorem reader_theorem : reader.
Proof.
split=> [s A e|s A|A]; [|exact: means_parse|exact: print_means].
by have m := parse_meant e; split; [|exact: means_problem m].
Qed.
