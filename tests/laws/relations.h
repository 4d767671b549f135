// Relations among the constraints that features put on cameras: sums of products of weight 3, 4 and
// 5 that are 0 whatever the remaining features are. They were found from the degrees on file and
// hold for all of them; none is proved (proofs/degrees.md, section 6).
#pragma once

#include "tests/laws/degree_form.h"

#include <string_view>

namespace laws {

/// A name that the relations use for a feature.
struct Symbol {
    std::string_view name;
    std::string_view notation;
};

inline constexpr std::array symbols{
    Symbol{"E1", "-/P/P"},   Symbol{"E2", "P/-/P"},  Symbol{"E3", "P/P/-"}, Symbol{"T1", "P/a/a"},
    Symbol{"T2", "a/P/a"},   Symbol{"T3", "a/a/P"},  Symbol{"L", "a/a/a"},  Symbol{"S1", "a/P/Pa"},
    Symbol{"S2", "P/a/Pa"},  Symbol{"S3", "P/Pa/a"}, Symbol{"Q", "P/P/P"},  Symbol{"W1", "a/Pa/Pa"},
    Symbol{"A", "Pa/Pa/Pa"},
};

/// A relation: a sum that is 0. Terms are separated by blanks; each has a sign, a coefficient and
/// `*` unless it is 1, and symbols with `.` between them.
struct NamedRelation {
    std::string_view name;
    std::string_view sum;
};

struct Term {
    std::int64_t coefficient = 0;
    Product product{};
};

/// A relation: sum over terms of coefficient times deg(product y) is 0 for each product y whose
/// weight, `weight` and that of y, is 11 in all.
struct Relation {
    std::string name;
    unsigned weight = 0;
    std::vector<Term> terms;
};

/// The terms of a sum such as `+E1.T2 -2*L`. Throws std::invalid_argument if a symbol is unknown.
std::vector<Term> parse_sum(std::string_view sum);

/// All relations, one of each set that relabeling the views permutes: degrees do not depend on the
/// order of the views, so the others say the same.
std::vector<Relation> all_relations();

} // namespace laws
