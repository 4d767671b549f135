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

AtMostFile replay_at_most(Reader& reader, const Execution& execution) try {
    AtMostFile file;
    Records records(file.refusals, execution);
    while (!reader.at_end()) {
        const AtMostRecord record = read_at_most(reader);
        const std::string& notation = record.problem.notation;
        const Problem& problem = record.problem.problem;
        records.replay(record.line, printable(notation, 200) + ": ", [&] {
            records.spend(1);
            const auto spend = [&](std::uint64_t effort) { records.spend(effort); };
            const std::size_t bound =
                solutions_at_most(problem, record.views, record.powers, spend);
            file.bounds.push_back({notation, problem, bound});
        });
    }
    return file;
} catch (const TooMuchEffort& too_much) {
    return {.refusals = too_much.refusals()};
}
} // namespace checker
