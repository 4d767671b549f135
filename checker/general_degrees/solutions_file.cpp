#include "checker/general_degrees/solutions_file.h"

#include "checker/degrees/solutions.h"
#include "checker/general_degrees/scene_certify.h"
#include "checker/problem/notation.h"

namespace checker {
/// A record up to its solutions.
struct ImagesRecord {
    std::size_t line = 0;
    Written problem{};
    std::vector<Numbers> views{}; // what they see
};

static ImagesRecord read_record_of_images(Reader& reader) {
    ImagesRecord record{.line = reader.line()};
    reader.take("problem");
    record.problem = read_notation(reader);
    const Problem& problem = record.problem.problem;
    for (int view = 0; view < std::popcount(problem.views); ++view) {
        reader.take("view");
        record.views.push_back(read_view(reader, problem));
    }
    return record;
}

/// How many coordinates a solution of the problem has.
static std::size_t coordinates_of(const Problem& problem) {
    return static_cast<std::size_t>(camera_columns(problem)) + depths_of(problem);
}

/// How many different cameras so many coordinates are, at least.
static std::size_t different(const Problem& problem, std::size_t count) {
    const int twofold = problem.cameras->twofold ? problem.view_count() - 1 : 0; // cameras
    const std::size_t copies = std::size_t{1} << twofold;
    return (count + copies - 1) / copies;
}

SolutionsFile replay_solutions(Reader& reader, const Execution& execution) try {
    SolutionsFile file;
    if (!has_arb) {
        file.refusals.add(reader.line(), "this plcheck was built without Arb");
        return file;
    }
    Records records(file.refusals, execution);
    SolutionsReplay solutions(reader, records, execution.threads);
    while (!reader.at_end()) {
        const ImagesRecord record = read_record_of_images(reader);
        const std::string& notation = record.problem.notation;
        const Problem& problem = record.problem.problem;
        const auto prepare = [&]() -> Certify {
            return [system = scene_system(problem, record.views)](const auto& start) {
                return certify_cameras(system, start);
            };
        };
        const auto count = solutions.run({coordinates_of(problem), "problem"}, record.line,
                                         printable(notation, 200), prepare);
        if (count) file.counts.push_back({notation, problem, different(problem, *count)});
    }
    return file;
} catch (const TooMuchEffort& too_much) {
    return {.refusals = too_much.refusals()};
}
} // namespace checker
