#include "checker/counts/families.h"
#include "checker/paper/claims.h"
#include "checker/paper/numbers.h"

namespace checker::paper {
static const ClaimedCount* claim_on(std::string_view name) {
    const auto is = [&](const ClaimedCount& claim) { return claim.name == name; };
    const auto* place = std::ranges::find_if(claimed_counts, is);
    return place == claimed_counts.end() ? nullptr : place;
}

static Claim compare(const Count& count) {
    Claim line{.claim = std::string(count.name), .claimed = "-", .certified = "-"};
    const ClaimedCount* claim = claim_on(count.name);
    if (claim) line.claimed = say(claim->claimed);
    if (count.certified) line.certified = say(*count.certified);
    if (!count.certified)
        line.verdict = "not covered by these files";
    else if (!claim)
        line.verdict = "not in the paper";
    else if (*count.certified == claim->claimed)
        line.verdict = "confirmed";
    else if (*count.certified == claim->certified_instead) {
        line.verdict = say("differs: ", claim->why);
        line.counted = std::string(claim->counted);
    } else
        line.verdict = "differs: not explained";
    return line;
}

/// The line on a problem with complete visibility.
static Claim compare(std::string_view name, const Classification& classes, std::size_t number,
                     const Verdicts& verdicts) {
    const Signature& signature = classes.representatives[number];
    Claim line{.claim = say(name, ", class ", number, ": ", notation(signature)),
               .claimed = "minimal",
               .certified = "-",
               .verdict = "not covered by these files"};
    if (!verdicts[number]) return line;
    const bool minimal = verdicts[number]->minimal();
    line.certified = minimal ? "minimal" : "not minimal";
    line.verdict = minimal ? "confirmed" : "differs: not explained";
    return line;
}

std::vector<Claim> compare_counts(const Classification& classes, const Verdicts& verdicts) {
    std::vector<Claim> lines;
    for (const Count& count : count_classes(classes, verdicts))
        lines.push_back(compare(count));
    for (std::size_t n = 0; n < verdicts.size(); ++n) {
        const Signature& signature = classes.representatives[n];
        if (!completely_visible(signature)) continue;
        const std::string name = plmp_name(signature);
        if (std::ranges::find(complete_visibility, name) != complete_visibility.end())
            lines.push_back(compare(name, classes, n, verdicts));
    }
    return lines;
}
} // namespace checker::paper
