#include "prover/cli/many_views_degree.h"

#include "prover/cli/sections.h"
#include "prover/many_views/certificate.h"
#include "prover/many_views/degrees_on_file.h"
#include "prover/minimal/problem_record.h"
#include "prover/problem/notation.h"
#include "prover/system/exit.h"
#include "prover/system/progress.h"

#include <algorithm>
#include <nlohmann/json.hpp>
#include <sstream>
#include <thread>

namespace plprove {

namespace {

void require_minimal(const Problem& problem) {
    const ProblemRecord certificate = certify(problem);
    if (is_minimal(certificate)) return;
    throw BadInput("only minimal problems have a degree, and " + notation(problem) +
                   " is none: " + explanation(certificate));
}

void require_complete_visibility(const Problem& problem) {
    const ViewSet all = all_views(problem.views);
    const bool complete =
        std::ranges::all_of(problem.points, [&](ViewSet seen) { return seen == all; }) &&
        std::ranges::all_of(problem.lines, [&](const Line& line) { return line.seen == all; });
    if (complete) return;
    throw BadInput("some view misses a point or a line of " + notation(problem) +
                   ", and such degrees are computed only for at most three calibrated views and "
                   "one point on a line: let all views see everything");
}

/// How often a solution is found.
int copies(const Problem& problem) {
    return problem.cameras->copies(problem.views);
}

int all_threads() {
    return static_cast<int>(std::max(1U, std::thread::hardware_concurrency()));
}

many_views::MonodromyResult computed(const Problem& problem,
                                     const ManyViewsDegreeRequest& request) {
    ProgressLine line("finding solutions", 0);
    many_views::MonodromySettings settings;
    settings.threads = all_threads();
    if (request.at_least > 0) {
        constexpr int ways_that_find_all = 3; // usually
        settings.edges = ways_that_find_all;
        settings.most_solutions = request.at_least * copies(problem);
    }
    settings.report = [&](int known, int edges) {
        line.show(static_cast<std::size_t>(known / copies(problem)),
                  " so far, " + std::to_string(edges) + " ways");
    };
    return many_views::run_monodromy(problem, request.seed, settings);
}

many_views::SolutionsRecord record_of(const many_views::MonodromyResult& found,
                                      const ManyViewsDegreeRequest& request) {
    const int all = static_cast<int>(std::ssize(found.points));
    const int wanted =
        request.at_least > 0 ? request.at_least * copies(found.system.problem()) : all;
    return many_views::certify(found, wanted, request.seed, all_threads());
}

/// Whether a theorem or certificates say that these are all: `certified`; or the computation only
/// suggests it.
std::string completeness(const Problem& problem, const many_views::MonodromyResult& found) {
    const auto on_file = many_views::degree_on_file(notation(problem));
    if (on_file && on_file->status == "certified" &&
        on_file->degree * copies(problem) == found.solutions)
        return "certified";
    return found.complete() ? "evidence" : "unknown";
}

/// The `certified` last is how many solutions the certificate shows; 0 if there is none.
std::string json_report(const Problem& problem, const many_views::MonodromyResult& found,
                        int certified) {
    const nlohmann::ordered_json report = {{"problem", notation(problem)},
                                           {"name", name(problem)},
                                           {"solutions", found.solutions / copies(problem)},
                                           {"complete", completeness(problem, found)},
                                           {"ways", found.ways},
                                           {"ways_that_agree", found.edges},
                                           {"certificate", certified},
                                           {"paths", found.paths},
                                           {"lost", found.lost}};
    return report.dump(2) + '\n';
}

std::string text_report(const Problem& problem, const many_views::MonodromyResult& found,
                        int certified) {
    std::ostringstream out;
    section(out, "problem") << notation(problem) << '\n';
    const std::string complete = completeness(problem, found);
    section(out, "degree") << (complete == "unknown" ? "at least " : "")
                           << found.solutions / copies(problem)
                           << (complete == "certified" ? " certified, all found" : " by evidence")
                           << '\n';
    section(out, "ways") << found.edges << " of " << found.ways
                         << " take the solutions of some images one to one to those of "
                            "others\n";
    section(out, "paths") << found.paths << ", " << found.lost << " lost\n";
    section(out, "certificate");
    if (certified > 0)
        out << "of at least " << certified << " solutions: certified once plcheck accepts it\n";
    else
        out << "none: -o FILE writes one\n";
    return out.str();
}

} // namespace

int propose_upper_bound(const Problem& problem, const many_views::Powers& powers,
                        std::uint64_t seed, const std::string& path, const Deliver& deliver) {
    require_minimal(problem);
    require_complete_visibility(problem);
    if (!problem.cameras->all_matrices)
        throw BadInput("--at-most is for projective cameras: write `projective:` in front of the "
                       "problem");
    const auto record = many_views::propose_upper_bound(problem, powers, seed);
    deliver(path.empty() ? "-" : path, many_views::write_upper_bounds(std::span(&record, 1)));
    return 0;
}

int find_many_views_degree(const Problem& problem, const ManyViewsDegreeRequest& request,
                           const Deliver& deliver) {
    require_minimal(problem);
    require_complete_visibility(problem);
    const many_views::MonodromyResult found = computed(problem, request);
    int certified = 0;
    if (!request.path.empty()) {
        const auto record = record_of(found, request);
        certified = (record.count() + copies(problem) - 1) / copies(problem);
        if (certified == 0)
            throw std::runtime_error("the run found no certificate: try another --seed");
        if (certified < request.at_least)
            throw std::runtime_error("the run found a certificate of only " +
                                     std::to_string(certified) + " solutions: try another --seed");
        deliver(request.path, many_views::write_solutions(std::span(&record, 1)));
    }
    if (request.path != "-")
        deliver("-", request.json ? json_report(problem, found, certified)
                                  : text_report(problem, found, certified));
    return 0;
}

} // namespace plprove
