# Writes the axioms of each theorem, one a line, from Assumptions.v and what coqc prints of it:
#     awk -f axioms.awk Assumptions.v Assumptions.out
FNR == NR { if (/^Print Assumptions/) { sub(/\.$/, "", $3); theorem[++theorems] = $3 } next }
function flush_axiom() { if (axiom != "") print theorem[n] ": " axiom; axiom = "" }
/^Closed under the global context$/ { flush_axiom(); n++; print theorem[n] ": no axioms"; next }
/^Axioms:$/ { flush_axiom(); n++; next }
/^ / { sub(/^ +/, " "); axiom = axiom $0; next }
{ flush_axiom(); axiom = $0 }
END { flush_axiom() }
