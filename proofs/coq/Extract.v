(** * The program plcoq: [judge] and [census] as OCaml (verdicts.ml)

    Coq's own translations for OCaml: nat becomes int (no number here comes near 2^62), a string a
    string, bool, list and option their namesakes. plcoq.ml reads lines and prints answers. *)
From Coq Require Import Extraction ExtrOcamlBasic ExtrOcamlNatInt ExtrOcamlNativeString.
From PL1P Require Import Census Verdict.
Set Warnings "-extraction-opaque-accessed,-extraction-reserved-identifier".
Extraction Language OCaml.
Definition count_all (_ : unit) := census.
Extraction Inline census.
Extraction "verdicts.ml" judge count_all.
