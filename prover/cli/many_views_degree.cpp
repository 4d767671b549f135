#include "prover/cli/many_views_degree.h"

#include "prover/cli/sections.h"
#include "prover/cli/written_model.h"
#include "prover/many_views/certificate.h"
#include "prover/many_views/degrees_on_file.h"
#include "prover/minimal/problem_record.h"
#include "prover/model/solver/solution_count.h"
#include "prover/problem/notation.h"
#include "prover/scripts/problem_model.h"
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

bool has_complete_visibility(const Problem& problem) {
    const ViewSet all = all_views(problem.views);
    return std::ranges::all_of(problem.points, [&](ViewSet seen) { return seen == all; }) &&
           std::ranges::all_of(problem.lines, [&](const Line& line) { return line.seen == all; });
}

/// For what certificates say of problems with complete visibility alone.
void require_complete_visibility(const Problem& problem, const std::string& option) {
    if (has_complete_visibility(problem)) return;
    throw BadInput("some view misses a point or a line of " + notation(problem) +
                   ", and only a model of it has certificates: leave " + option +
                   " out, and see `plprove model --from`, `--lift`");
}

int all_threads() {
    return static_cast<int>(std::max(1U, std::thread::hardware_concurrency()));
}

/// What was found of a problem.
struct Finding {
    const Problem& problem;
    MonodromyCount count;
    int certified = 0; ///< how many solutions the certificate shows; 0 if there is none
};

many_views::MonodromyResult solutions_of(const Problem& problem,
                                         const ManyViewsDegreeRequest& request) {
    ProgressLine line("finding solutions", 0);
    many_views::MonodromySettings settings;
    settings.threads = all_threads();
    if (request.target > 0) settings.most_solutions = request.target - 1;
    if (request.at_least > 0) {
        constexpr int ways_that_find_all = 3; // usually
        settings.edges = ways_that_find_all;
        settings.most_solutions = request.at_least;
    }
    settings.report = [&](int known, int edges) {
        line.show(static_cast<std::size_t>(known), " so far, " + std::to_string(edges) + " ways");
    };
    return many_views::run_monodromy(problem, request.seed, settings);
}

many_views::SolutionsRecord record_of(const many_views::MonodromyResult& found,
                                      const ManyViewsDegreeRequest& request) {
    const int all = static_cast<int>(std::ssize(found.points));
    const int wanted = request.at_least > 0 ? request.at_least : all;
    return many_views::certify(found, wanted, request.seed, all_threads());
}

/// By the model of the problem: views may miss something.
MonodromyCount counted_in_part(const Problem& problem, const ManyViewsDegreeRequest& request) {
    if (!request.path.empty()) require_complete_visibility(problem, "-o");
    if (request.at_least > 0) require_complete_visibility(problem, "--at-least");
    const std::string text =
        well_formed(problem_model(best_view_first(problem), 0), notation(problem));
    ProgressLine line("finding solutions", 0);
    model::CountSettings settings;
    settings.seed = request.seed;
    settings.threads = static_cast<unsigned>(all_threads());
    if (request.target > 0) settings.most_solutions = request.target - 1;
    settings.found = [&](std::size_t found) { line.show(found, " so far"); };
    return model::count_solutions(model::compile(model::read_model(text)), settings);
}

/// Finds the solutions, and writes the certificate if one is asked for.
Finding found_in_full(const Problem& problem, const ManyViewsDegreeRequest& request,
                      const Deliver& deliver) {
    const many_views::MonodromyResult found = solutions_of(problem, request);
    Finding finding{problem, found};
    if (request.path.empty()) return finding;
    const auto record = record_of(found, request);
    finding.certified = record.count();
    if (finding.certified == 0)
        throw std::runtime_error("the run found no certificate: try another --seed");
    if (finding.certified < request.at_least)
        throw std::runtime_error("the run found a certificate of only " +
                                 std::to_string(finding.certified) +
                                 " solutions: try another --seed");
    deliver(request.path, many_views::write_solutions(std::span(&record, 1)));
    return finding;
}

/// Whether a theorem or certificates say that these are all: `certified`; or the computation only
/// suggests it.
std::string completeness(const Finding& finding) {
    const auto on_file = many_views::degree_on_file(finding.problem);
    if (on_file && on_file->status == "certified" && on_file->degree == finding.count.solutions)
        return "certified";
    return finding.count.complete() ? "evidence" : "unknown";
}

std::string json_report(const Finding& finding) {
    const MonodromyCount& count = finding.count;
    const nlohmann::ordered_json report = {{"problem", notation(finding.problem)},
                                           {"name", name(finding.problem)},
                                           {"solutions", finding.count.solutions},
                                           {"complete", completeness(finding)},
                                           {"ways", count.ways},
                                           {"ways_that_agree", count.edges},
                                           {"certificate", finding.certified},
                                           {"paths", count.paths},
                                           {"lost", count.lost}};
    return report.dump(2) + '\n';
}

std::string text_report(const Finding& finding) {
    const MonodromyCount& count = finding.count;
    std::ostringstream out;
    section(out, "problem") << notation(finding.problem) << '\n';
    const std::string complete = completeness(finding);
    section(out, "degree") << (complete == "unknown" ? "at least " : "") << finding.count.solutions
                           << (complete == "certified" ? " certified, all found" : " by evidence")
                           << '\n';
    section(out, "ways") << count.edges << " of " << count.ways
                         << " take the solutions of some images one to one to those of "
                            "others\n";
    section(out, "paths") << count.paths << ", " << count.lost << " lost\n";
    section(out, "certificate");
    if (finding.certified > 0)
        out << "of at least " << finding.certified
            << " solutions: certified once plcheck accepts it\n";
    else if (has_complete_visibility(finding.problem))
        out << "none: -o FILE writes one\n";
    else
        out << "none, as views miss something; of the model: plprove model --from, then --lift\n";
    return out.str();
}

} // namespace

int propose_upper_bound(const Problem& problem, const many_views::Powers& powers,
                        std::uint64_t seed, const std::string& path, const Deliver& deliver) {
    require_minimal(problem);
    require_complete_visibility(problem, "--at-most");
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
    const Finding finding = has_complete_visibility(problem)
                                ? found_in_full(problem, request, deliver)
                                : Finding{problem, counted_in_part(problem, request)};
    if (request.path != "-")
        deliver("-", request.json ? json_report(finding) : text_report(finding));
    return 0;
}

} // namespace plprove
