#include "checker/counts/families.h"
#include "checker/paper/claims.h"
#include "checker/paper/degree_table.h"
#include "checker/paper/numbers.h"

#include <span>

namespace checker::paper {
DegreeBounds bounds_of(const KnownDegrees& known, std::size_t number) {
    return checker::bounds_of(known.table, known.classes.representatives[number]);
}

/// How bounds of a number compare with a claim on it.
static std::string_view verdict_on(const DegreeBounds& bounds, std::size_t claimed) {
    if (bounds.at_least > claimed) return "differs";
    if (!bounds.exact()) return not_covered;
    return bounds.at_least == claimed ? "agrees" : "differs";
}

/// A line on the degree of one problem.
static DegreeClaim line_on(const std::string& problem, const DegreeBounds& bounds,
                           std::optional<std::size_t> claimed) {
    DegreeClaim line{.claim = problem, .claimed = "-", .at_least = "-", .exact = "-"};
    if (bounds.at_least > 0) line.at_least = say(bounds.at_least);
    if (bounds.exact()) line.exact = line.at_least;
    line.verdict = claimed ? verdict_on(bounds, *claimed) : "no claim in the paper";
    if (claimed) line.claimed = say(*claimed);
    return line;
}

/// The number of solutions of what is left when two views are posed relative to each other: the
/// degree divided by the number of relative poses. Its upper bound is such a quotient, too, so that
/// an exact degree is the product of two exact numbers (proofs/registrations.md, Lemma U1).
static DegreeBounds registration_of(const DegreeBounds& degree, std::size_t relative_poses) {
    if (relative_poses == 0) return {};
    DegreeBounds registration = degree;
    registration.at_least /= relative_poses;
    if (registration.at_most) registration.at_most->solutions /= relative_poses;
    return registration;
}

static std::optional<std::size_t> claim_in(std::span<const ClaimedDegree> claims,
                                           std::string_view problem) {
    for (const ClaimedDegree& claim : claims)
        if (claim.problem == problem) return claim.degree;
    return std::nullopt;
}

/// The lines on a minimal class.
static void add_lines(std::vector<DegreeClaim>& lines, std::size_t number,
                      const KnownDegrees& known) {
    const Signature& signature = known.classes.representatives[number];
    const DegreeBounds bounds = bounds_of(known, number);
    const std::string problem = notation(signature);
    const std::string name = say("class ", number, ": ", problem);
    if (is_pl0p(signature))
        lines.push_back(line_on("PL0P, " + name, bounds, claim_in(pl0ps, problem)));
    if (const auto claim = claim_in(registrations, problem))
        lines.push_back(line_on(say("- registration of its third camera, class ", number),
                                registration_of(bounds, known.relative_poses), claim));
    if (completely_visible(signature))
        lines.push_back(line_on(plmp_name(signature) + ", " + name, bounds, std::nullopt));
    if (problem == example.problem)
        lines.push_back(line_on("3 PPP and 1 PPL, " + name, bounds, example.degree));
}

std::vector<DegreeClaim> compare_degrees(const KnownDegrees& known) {
    std::vector<DegreeClaim> lines;
    bool all_proved = true;
    for (std::size_t n = 0; n < known.verdicts.size(); ++n) {
        all_proved = all_proved && known.verdicts[n].has_value();
        if (is_minimal(known.verdicts, n)) add_lines(lines, n, known);
    }
    if (!all_proved) return lines;
    for (const PaperTable& table : {table_2a_of(known), table_2b_of(known)})
        add_table(lines, table);
    return lines;
}
} // namespace checker::paper
