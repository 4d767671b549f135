#include "checker/general_degrees/solutions_file.h"

#include "checker/degrees/solutions.h"
#include "checker/fibres/prove_fibre.h"
#include "checker/general_degrees/scene_at.h"
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

/// The fibres of a problem, one after the other: those that hold, by their polynomials.
struct FibresOfProblem {
    std::string notation{};
    std::vector<Polynomial> proved{};
};

class SolutionsFileReplay {
public:
    SolutionsFileReplay(Reader& reader, const Execution& execution, SolutionsFile& file)
        : reader_(reader), file_(file), records_(file.refusals, execution),
          solutions_(reader, records_, execution.threads) {}

    void run() {
        while (!reader_.at_end()) {
            const ImagesRecord record = read_record_of_images(reader_);
            if (record.problem.notation != fibres_.notation) finish_fibres();
            if (reader_.comes("fibre"))
                replay_fibre(record);
            else
                replay_solutions(record);
        }
        finish_fibres();
    }

private:
    void replay_fibre(const ImagesRecord& record) {
        const Problem& problem = record.problem.problem;
        const std::size_t degree = read_fibre_degree(reader_);
        const auto cameras = static_cast<std::size_t>(camera_columns(problem));
        const Fibre fibre = read_fibre(reader_, degree, coordinates_of(problem), cameras);
        records_.replay(record.line, printable(record.problem.notation, 200) + ": ", [&] {
            records_.spend(effort_of(fibre));
            prove_fibre<SceneAt>(scene_system(problem, record.views), fibre);
            file_.counts.push_back({record.problem.notation, problem, degree, {}});
            fibres_.notation = record.problem.notation;
            fibres_.proved.push_back(fibre.lower);
        });
    }

    /// Adds what all fibres of one problem show.
    void finish_fibres() {
        if (fibres_.proved.empty()) return;
        const auto spend = [&](std::uint64_t effort) { records_.spend(effort); };
        file_.counts.back().cycle_types = cycle_types_of(fibres_.proved, spend);
        fibres_ = {};
    }

    void replay_solutions(const ImagesRecord& record) {
        const Problem& problem = record.problem.problem;
        const std::string& notation = record.problem.notation;
        const auto prepare = [&]() -> Certify {
            if (!has_arb) throw Refused("this plcheck was built without Arb: see --version");
            return [system = scene_system(problem, record.views)](const auto& start) {
                return certify_cameras(system, start);
            };
        };
        const auto count = solutions_.run({coordinates_of(problem), "problem"}, record.line,
                                          printable(notation, 200), prepare);
        if (count) file_.counts.push_back({notation, problem, *count, {}});
    }

    Reader& reader_;
    SolutionsFile& file_;
    Records records_;
    SolutionsReplay solutions_;
    FibresOfProblem fibres_{};
};

SolutionsFile replay_solutions(Reader& reader, const Execution& execution) try {
    SolutionsFile file;
    SolutionsFileReplay(reader, execution, file).run();
    return file;
} catch (const TooMuchEffort& too_much) {
    return {.refusals = too_much.refusals()};
}
} // namespace checker
