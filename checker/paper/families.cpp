#include "checker/general/rows.h"
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

static Claim compare(std::string_view family, const general::Row& row) {
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

FamilyTable compare_family(const general::ProblemsFile& file) {
    FamilyTable table{.family = file.family};
    for (const general::Row& row : general::rows_of(file))
        table.claims.push_back(compare(file.family, row));
    return table;
}
} // namespace checker::paper
