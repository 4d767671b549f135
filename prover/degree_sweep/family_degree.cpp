#include "prover/degree_sweep/family_degree.h"

#include "prover/many_views/certificate.h"
#include "prover/many_views/monodromy.h"
#include "prover/monodromy/two_seeds.h"
#include "prover/problem/notation.h"

#include <algorithm>
#include <functional>
#include <limits>
#include <optional>
#include <span>

namespace plprove {

namespace {

using many_views::MonodromyResult;

/// The runs over one problem.
class Runs {
public:
    Runs(const SweepItem& item, const DegreeOptions& options)
        : problem_(parse_problem(item.problem)), seed_(options.seed) {
        if (options.target > 0) settings_.most_solutions = options.target - 1;
    }

    /// One more. The numbers count from 1 on.
    MonodromyCount operator()(std::uint64_t number) {
        runs_.push_back(many_views::run_monodromy(problem_, seed_of(number), settings_));
        return runs_.back();
    }

    /// The certificate of the run that found most.
    many_views::SolutionsRecord record() const {
        const auto size = [](const MonodromyResult& run) { return run.points.size(); };
        return record_of(std::ranges::max_element(runs_, {}, size));
    }

    /// A certificate of all these solutions, or of most, by the runs that found as many.
    many_views::SolutionsRecord record(int solutions) const {
        std::optional<many_views::SolutionsRecord> best;
        for (auto run = runs_.begin(); run != runs_.end(); ++run) {
            if (run->solutions != solutions) continue;
            auto found = record_of(run);
            if (!best || found.count() > best->count()) best = std::move(found);
            if (best->count() >= solutions) break;
        }
        return best.value();
    }

    void add_paths_to(DegreeRun& run) const {
        for (const MonodromyResult& one : runs_) {
            run.tracks += static_cast<std::uint64_t>(one.paths);
            run.failed += static_cast<std::uint64_t>(one.lost);
        }
    }

    static constexpr std::uint64_t most_seeds = 3;

private:
    std::uint64_t seed_of(std::uint64_t number) const { return most_seeds * seed_ + number; }

    many_views::SolutionsRecord record_of(std::vector<MonodromyResult>::const_iterator run) const {
        const auto number = static_cast<std::uint64_t>(run - runs_.begin()) + 1;
        return many_views::certify(*run, static_cast<int>(std::ssize(run->points)), seed_of(number),
                                   1);
    }

    Problem problem_;
    std::uint64_t seed_;
    many_views::MonodromySettings settings_;
    std::vector<MonodromyResult> runs_;
};

std::string without_first_line(const std::string& file) {
    return file.substr(file.find('\n') + 1);
}

std::string ways(const CountedTwice& counted) {
    return std::to_string(counted.agreeing_ways) + " of " + std::to_string(counted.ways) +
           " ways agree";
}

} // namespace

DegreeRun compute_family_degree(const SweepItem& item, const DegreeOptions& options) {
    DegreeRun run;
    run.number = item.number;
    run.problem = item.problem;
    Runs runs(item, options);
    const int most = options.target > 0 ? options.target - 1 : std::numeric_limits<int>::max();
    const auto counted = counted_twice(most, Runs::most_seeds, std::ref(runs));
    runs.add_paths_to(run);
    const bool exact = counted && counted->exact;
    const auto record = exact ? runs.record(counted->solutions) : runs.record();
    run.degree = record.count();
    run.complete = exact && run.degree == counted->solutions;
    if (run.degree > 0)
        run.record = without_first_line(many_views::write_solutions(std::span(&record, 1)));
    run.notes.push_back(counted ? ways(*counted) : "stopped at the target");
    if (exact && !run.complete)
        run.notes.push_back("of " + std::to_string(counted->solutions) +
                            " solutions the certificate has " + std::to_string(run.degree));
    return run;
}

} // namespace plprove
