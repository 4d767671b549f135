#include "checker/family/rows.h"
#include "checker/paper/claims.h"

namespace checker::paper {
/// A number of a paper, by its row in FORMAT.md, section 13.
struct ClaimedNumber {
    std::string_view family;
    std::string_view row;
    std::size_t number = 0;
};

/// Of PLMP, and of PLMP for projective cameras.
static constexpr std::array claimed_numbers{
    ClaimedNumber{"plmp", "minimal", 30},
    ClaimedNumber{"plmp", "minimal, in 2 views", 3},
    ClaimedNumber{"plmp", "minimal, in 3 views", 17},
    ClaimedNumber{"plmp", "minimal, in 4 views", 6},
    ClaimedNumber{"plmp", "minimal, in 5 views", 3},
    ClaimedNumber{"plmp", "minimal, in 6 views", 1},
    ClaimedNumber{"projective", "- no four on a line, no six in a plane", 149},
    ClaimedNumber{"projective", "minimal", 291},
    ClaimedNumber{"projective", "- with one solution", 73},
};

/// Of PLMP, Table 1: "> 450k".
static constexpr FamilyDegree claimed_degree{.name = "1021_1",
                                             .problem = "Pa/Pa/Pa/Pa/Pa/Pa + 2*a/a/a/a/a/a",
                                             .claimed_above = 450'000,
                                             .evidence = 186'368};

void set_certified(FamilyDegree& degree, std::size_t at_least, std::size_t at_most) {
    degree.at_least = at_least;
    degree.at_most = at_most;
    const bool refuted = at_most > 0 && at_most <= degree.claimed_above;
    degree.verdict = at_least > degree.claimed_above ? "confirmed"
                     : refuted                       ? "differs, certified"
                                                     : "differs by evidence";
}

static Claim compare(std::string_view family, const FamilyRow& row) {
    Claim line{.claim = std::string(row.name),
               .claimed = "-",
               .certified = say(row.number),
               .verdict = "no claim"};
    for (const ClaimedNumber& claim : claimed_numbers) {
        if (claim.family != family || claim.row != row.name) continue;
        line.claimed = say(claim.number);
        line.verdict = claim.number == row.number ? "confirmed" : "differs: not explained";
    }
    return line;
}

FamilyTable compare_family(const ProblemsFile& file) {
    FamilyTable table{.family = file.family};
    for (const FamilyRow& row : rows_of(file))
        table.claims.push_back(compare(file.family, row));
    if (table.family == "plmp") table.degrees.push_back(claimed_degree);
    return table;
}
} // namespace checker::paper
