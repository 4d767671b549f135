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
static constexpr std::array claimed_degrees{
    FamilyDegree{.family = "plmp",
                 .name = "1021_1",
                 .problem = "Pa/Pa/Pa/Pa/Pa/Pa + 2*a/a/a/a/a/a",
                 .claimed_above = 450'000,
                 .evidence = 186'368},
};

void set_certified(FamilyDegree& degree, std::size_t at_least) {
    degree.at_least = at_least;
    degree.verdict = at_least > degree.claimed_above ? "confirmed"
                     : at_least > degree.evidence    ? "open: the evidence is wrong"
                                                     : "differs by evidence";
}

static Claim compare(const Family& family, std::string_view name, std::size_t certified) {
    Claim line{.claim = std::string(name),
               .claimed = "-",
               .certified = say(certified),
               .verdict = "no claim"};
    for (const ClaimedNumber& claim : claimed_numbers) {
        if (claim.family != family.name || claim.row != name) continue;
        line.claimed = say(claim.number);
        line.verdict = claim.number == certified ? "confirmed" : "differs: not explained";
    }
    return line;
}

FamilyTable compare_family(const ProblemsFile& file) {
    const Family* family = complete_family(file);
    if (!family) return {};
    FamilyTable table{.family = family->name};
    for (const FamilyNumber& number : family->numbers)
        table.claims.push_back(compare(*family, number.name, value_of(number, file)));
    for (const FamilyDegree& degree : claimed_degrees)
        if (degree.family == family->name) table.degrees.push_back(degree);
    return table;
}
} // namespace checker::paper
