(* Reads problems and prints what Verdict.v proves of them. Only this file and what OCaml translates
   are not proved: reading lines, printing answers and numbers. *)

open Verdicts

let usage =
  "Which point-line problems in three calibrated views are minimal? Coq proves each answer.\n\
   Usage: plcoq PROBLEM...      one line for each problem: its verdict, and the problem\n\
  \       plcoq <FILE           the same, for each line of a file\n\
  \       plcoq --counts        the numbers of classes, counted once more\n\n\
   A problem is a sum of features, as docs/notation.md says: '2*P/P/P + a/Pa/Pa + a/a/a'. It has\n\
   three calibrated views, and no line with two points (no capital letters but P).\n\n\
   Exit status: 0 done; 1 a problem has no verdict; 2 a line is no problem; 3 wrong use.\n"

let words = function
  | Minimal -> "minimal"
  | Unbalanced -> "not minimal (unbalanced)"
  | Loose -> "not minimal (images leave a point or line open)"
  | Obstructed -> "not minimal (obstructed)"
  | Other_feature -> "no verdict (a feature is not one of the 27)"
  | Not_read -> "not read (write it as docs/notation.md says)"

let status = function
  | Minimal | Unbalanced | Loose | Obstructed -> 0
  | Other_feature -> 1
  | Not_read -> 2

let answer line =
  match judge line with
  | a ->
    print_endline (words a ^ ": " ^ line);
    status a
  | exception Stack_overflow ->
    print_endline ("no verdict (it has too many features): " ^ line);
    1

let rec answer_lines worst =
  match input_line stdin with
  | line -> answer_lines (max worst (answer line))
  | exception End_of_file -> worst

let rec of_positive = function XH -> 1 | XO p -> 2 * of_positive p | XI p -> (2 * of_positive p) + 1
let of_n = function N0 -> 0 | Npos p -> of_positive p

let counted =
  [ "label classes"; "swap&label classes"; "label classes, minimal"; "label classes, not minimal";
    "swap&label classes, minimal"; "swap&label classes, not minimal"; "label classes, minimal, PL0P";
    "swap&label classes, minimal, at most one pin a point"; "label classes, five-point extensions";
    "swap&label classes, five-point extensions" ]

let print_counts () =
  List.iter2 (fun what n -> Printf.printf "%-54s %6d\n" what (of_n n)) counted (count_all ())

let () =
  match List.tl (Array.to_list Sys.argv) with
  | [ "--help" ] -> print_string usage
  | [ "--counts" ] -> print_counts ()
  | [] -> exit (answer_lines 0)
  | args when List.exists (fun a -> String.length a > 1 && String.sub a 0 2 = "--") args ->
    prerr_string usage;
    exit 3
  | args -> exit (List.fold_left (fun worst line -> max worst (answer line)) 0 args)
