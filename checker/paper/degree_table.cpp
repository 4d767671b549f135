#include "checker/paper/degree_table.h"

#include "checker/counts/families.h"

namespace checker::paper {
static std::size_t claimed_number(std::string_view name) {
    const auto is = [&](const ClaimedCount& claim) { return claim.name == name; };
    return std::ranges::find_if(claimed_counts, is)->claimed;
}

static std::vector<TerminalProblem> terminal_problems(const KnownDegrees& known,
                                                      bool (*belongs)(const Signature&)) {
    std::vector<TerminalProblem> problems;
    for (std::size_t n = 0; n < known.verdicts.size(); ++n) {
        if (!is_minimal(known.verdicts, n) || !known.classes.represents_swap_class(n)) continue;
        const Signature& signature = known.classes.representatives[n];
        if (belongs(signature)) problems.push_back({n, notation(signature), bounds_of(known, n)});
    }
    return problems;
}

PaperTable table_2a_of(const KnownDegrees& known) {
    const auto any = [](const Signature&) { return true; };
    return {"terminal", table_2a_limit, claimed_number("terminal camera-minimal"), table_2a,
            terminal_problems(known, any)};
}

PaperTable table_2b_of(const KnownDegrees& known) {
    return {"terminal, at most one pin a point", table_2b_limit,
            claimed_number("terminal, at most one pin a point"), table_2b,
            terminal_problems(known, at_most_one_pin)};
}

/// Counts of problems by what is known of their degrees, from one degree to another.
struct Tally {
    std::size_t at_least = 0;                 // certified to have at least the first degree
    std::size_t exact = 0;                    // certified to have one of the degrees
    std::size_t by_theorem = 0;               // of these, those whose upper bound is a theorem
    std::size_t known = 0;                    // have one of the degrees, certified or by evidence
    std::size_t undecided = 0;                // may have one of the degrees
    const TerminalProblem* witness = nullptr; // the last that is known
};

static Tally tally(const std::vector<TerminalProblem>& problems, std::size_t from, std::size_t to) {
    Tally result;
    for (const TerminalProblem& problem : problems) {
        const DegreeBounds& bounds = problem.bounds;
        const bool decided = bounds.exact() || bounds.complete;
        const bool inside = from <= bounds.at_least && bounds.at_least <= to;
        if (bounds.at_least >= from) ++result.at_least;
        if (inside && bounds.exact()) ++result.exact;
        if (inside && bounds.exact() && bounds.at_most->by_theorem()) ++result.by_theorem;
        if (inside && decided) ++result.known;
        if (inside && decided) result.witness = &problem;
        if (!decided && bounds.at_least <= to) ++result.undecided;
    }
    return result;
}

/// How the number of problems that are known to have a degree compares with a claim, when some are
/// undecided.
static std::string compare(std::size_t claimed, std::size_t known, std::size_t undecided,
                           bool certified) {
    const std::string_view grounds = certified ? "certified" : "by evidence";
    if (known > claimed || known + undecided < claimed) return say("differs, ", grounds);
    if (undecided > 0) return say("open: ", undecided, " undecided");
    return say("agrees, ", grounds);
}

static std::string name_of(const TerminalProblem* problem) {
    return problem ? say("class ", problem->number, ": ", problem->problem) : "";
}

/// Whether certificates alone decide which problems have at most this degree: each is exactly so
/// much, or has at least more.
static bool is_settled(const PaperTable& table, std::size_t degree) {
    const std::size_t exact = tally(table.problems, 0, degree).exact;
    const std::size_t more = tally(table.problems, degree + 1, SIZE_MAX).at_least;
    return exact + more == table.problems.size();
}

/// The line on one degree.
static DegreeClaim line_on(const PaperTable& table, std::size_t degree, std::size_t claimed) {
    const Tally found = tally(table.problems, degree, degree);
    const bool certified = found.exact > claimed || is_settled(table, degree);
    return {.claim = say(table.name, ", degree ", degree),
            .claimed = say(claimed),
            .at_least = say(found.at_least),
            .exact = say(found.exact),
            .by_theorem = say(found.by_theorem),
            .known = say(found.known),
            .verdict = compare(claimed, found.known, found.undecided, certified),
            .witness = name_of(found.witness)};
}

/// The lines on all degrees below the limit together, and on those from there.
static void add_sums(std::vector<DegreeClaim>& lines, const PaperTable& table,
                     std::size_t claimed_below) {
    const std::size_t last = table.limit - 1;
    const Tally below = tally(table.problems, 0, last);
    const Tally above = tally(table.problems, table.limit, SIZE_MAX);
    const std::size_t all = table.problems.size();
    const bool settled = is_settled(table, last);
    const bool too_many = below.exact > claimed_below || all - above.at_least < claimed_below;
    lines.push_back(
        {.claim = say(table.name, ", degree below ", table.limit),
         .claimed = say(claimed_below),
         .at_least = "-",
         .exact = say(below.exact),
         .by_theorem = say(below.by_theorem),
         .known = say(below.known),
         .verdict = compare(claimed_below, below.known, below.undecided, settled || too_many)});
    const std::size_t claimed_above = table.claimed_problems - claimed_below;
    const bool differs = above.at_least > claimed_above || all - below.exact < claimed_above;
    lines.push_back(
        {.claim = say(table.name, ", degree at least ", table.limit),
         .claimed = say(claimed_above),
         .at_least = say(above.at_least),
         .exact = "-",
         .by_theorem = "-",
         .known = "-",
         .verdict = compare(claimed_above, above.at_least, below.undecided, settled || differs)});
    const Tally any = tally(table.problems, 1, SIZE_MAX);
    lines.push_back({.claim = say(table.name, ", of any degree"),
                     .claimed = say(table.claimed_problems),
                     .at_least = say(any.at_least),
                     .exact = say(any.exact),
                     .by_theorem = say(any.by_theorem),
                     .known = say(any.known),
                     .verdict = "-"});
}

void add_table(std::vector<DegreeClaim>& lines, const PaperTable& table) {
    std::map<std::size_t, std::size_t> claimed; // by degree; also degrees that only we know
    std::size_t claimed_below = 0;
    for (const auto& [degree, problems] : table.claims) {
        claimed[degree] = problems;
        claimed_below += problems;
    }
    for (const TerminalProblem& problem : table.problems) {
        const DegreeBounds& bounds = problem.bounds;
        const bool decided = bounds.exact() || bounds.complete;
        if (decided && bounds.at_least < table.limit) claimed.emplace(bounds.at_least, 0);
    }
    for (const auto& [degree, problems] : claimed)
        lines.push_back(line_on(table, degree, problems));
    add_sums(lines, table, claimed_below);
}
} // namespace checker::paper
