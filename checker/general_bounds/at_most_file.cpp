#include "checker/general_bounds/at_most_file.h"

#include "checker/general_bounds/section.h"
#include "checker/problem/notation.h"

namespace checker {
struct AtMostRecord {
    std::size_t line = 0;
    Written problem{};
    std::vector<Numbers> views{}; // what they see, those of further images last
    Powers powers{};
};

static AtMostRecord read_at_most(Reader& reader) {
    AtMostRecord record{.line = reader.line()};
    reader.take("problem");
    record.problem = read_notation(reader);
    const Problem& problem = record.problem.problem;
    const std::size_t given = static_cast<std::size_t>(std::popcount(problem.views));
    constexpr std::size_t most_further = 99;
    while (record.views.size() <= given || reader.comes("view")) {
        if (record.views.size() == given + most_further) reader.fail("view", "`powers`");
        reader.take("view");
        record.views.push_back(read_view(reader, problem));
    }
    constexpr int most = 20;
    reader.take("powers");
    record.powers.cubics = reader.small_integer(1, most);
    record.powers.linear = reader.small_integer(1, most);
    reader.end_line();
    return record;
}

/// Elimination grows with the cube of the number of monomials.
static std::uint64_t effort_of(std::uint64_t monomials) {
    return 1 + monomials * monomials * monomials / 1'000'000;
}

AtMostFile replay_at_most(Reader& reader, const Execution& execution) try {
    AtMostFile file;
    Effort effort(execution.effort);
    Progress progress;
    while (!reader.at_end()) {
        const AtMostRecord record = read_at_most(reader);
        const auto& [notation, list, problem] = record.problem;
        const auto spend = [&](std::size_t monomials) {
            effort.spend(effort_of(monomials), record.line);
        };
        progress.line = record.line;
        progress.records += 1;
        execution.watch(progress);
        try {
            const std::size_t bound =
                solutions_at_most(problem, record.views, record.powers, spend);
            file.bounds.push_back({notation, problem, bound});
        } catch (const Refused& refused) {
            file.refusals.add(record.line, say(printable(notation, 200), ": ", refused.reason));
        }
    }
    return file;
} catch (const TooMuchEffort& too_much) {
    return {.refusals = too_much.refusals()};
}
} // namespace checker
