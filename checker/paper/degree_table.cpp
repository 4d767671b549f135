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
    std::size_t uncertain = 0;                // may have one of the degrees
    const TerminalProblem* witness = nullptr; // the last that has one
};

static Tally tally(const std::vector<TerminalProblem>& problems, std::size_t from, std::size_t to) {
    Tally result;
    for (const TerminalProblem& problem : problems) {
        const DegreeBounds& bounds = problem.bounds;
        const bool inside = from <= bounds.at_least && bounds.at_least <= to;
        if (bounds.at_least >= from) ++result.at_least;
        if (inside && bounds.exact()) ++result.exact;
        if (inside && bounds.exact()) result.witness = &problem;
        if (!bounds.exact() && bounds.at_least <= to) ++result.uncertain;
    }
    return result;
}

/// How a number of problems compares with a claim, when it may be larger by those whose degree
/// these files do not give.
static std::string_view compare(std::size_t claimed, std::size_t number, std::size_t uncertain) {
    if (number > claimed || number + uncertain < claimed) return "differs";
    return uncertain > 0 ? not_covered : "agrees";
}

static std::string name_of(const TerminalProblem* problem) {
    return problem ? say("class ", problem->number, ": ", problem->problem) : "";
}

/// The line on one degree.
static DegreeClaim line_on(const PaperTable& table, std::size_t degree, std::size_t claimed) {
    const Tally found = tally(table.problems, degree, degree);
    return {.claim = say(table.name, ", degree ", degree),
            .claimed = say(claimed),
            .at_least = say(found.at_least),
            .exact = say(found.exact),
            .verdict = std::string(compare(claimed, found.exact, found.uncertain)),
            .witness = name_of(found.witness)};
}

/// The lines on all degrees below the limit together, and on those from there.
static void add_sums(std::vector<DegreeClaim>& lines, const PaperTable& table,
                     std::size_t claimed_below) {
    const Tally below = tally(table.problems, 0, table.limit - 1);
    const Tally above = tally(table.problems, table.limit, SIZE_MAX);
    const std::size_t claimed_above = table.claimed_problems - claimed_below;
    lines.push_back({.claim = say(table.name, ", degree below ", table.limit),
                     .claimed = say(claimed_below),
                     .at_least = "-",
                     .exact = say(below.exact),
                     .verdict = std::string(compare(claimed_below, below.exact, below.uncertain))});
    lines.push_back(
        {.claim = say(table.name, ", degree at least ", table.limit),
         .claimed = say(claimed_above),
         .at_least = say(above.at_least),
         .exact = "-",
         .verdict = std::string(compare(claimed_above, above.at_least, below.uncertain))});
    const Tally any = tally(table.problems, 1, SIZE_MAX);
    lines.push_back({.claim = say(table.name, ", of any degree"),
                     .claimed = say(table.claimed_problems),
                     .at_least = say(any.at_least),
                     .exact = say(any.exact),
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
        if (bounds.exact() && bounds.at_least < table.limit) claimed.emplace(bounds.at_least, 0);
    }
    for (const auto& [degree, problems] : claimed)
        lines.push_back(line_on(table, degree, problems));
    add_sums(lines, table, claimed_below);
}
} // namespace checker::paper
