// Certificates of the degrees of a family that are on file (certs/family-degrees.csv): a file of
// solutions (certs/FORMAT.md, section 14), with all solutions of each problem, by its degree. Where
// `plprove group PROBLEM -o FILE` makes fibres, these take their place in certs/solutions.
//
// Usage: family_solutions FAMILY MOST [PROBLEM]...
//
// Prints the file of all problems with at most MOST solutions, or of these problems. Says on stderr
// how many solutions it finds of each; the status is 1 if they are too few of some.
#include "prover/many_views/certificate.h"
#include "prover/many_views/degrees_on_file.h"
#include "prover/problem/complete_visibility.h"
#include "prover/problem/notation.h"

#include <algorithm>
#include <cstdlib>
#include <iostream>
#include <thread>

using namespace plprove;

namespace {

/// How many ways between images usually find all solutions; more where a few seeds did not.
int ways_for(int degree, std::uint64_t seed) {
    if (degree == 1) return 1;
    return seed <= 3 ? 3 : 12;
}

/// The record with the most solutions that a few seeds find. Some have too many: a real solution
/// that is nearly double is taken for a pair, which plcheck refuses.
many_views::SolutionsRecord best_record(const many_views::DegreeOnFile& known) {
    constexpr std::uint64_t most_seeds = 8;
    const Problem problem = parse_problem(std::string(known.problem));
    const int all = known.degree * problem.cameras->copies(problem.views);
    many_views::MonodromySettings settings;
    settings.threads = static_cast<int>(std::max(1U, std::thread::hardware_concurrency()));
    many_views::SolutionsRecord best{problem, {}, {}};
    for (std::uint64_t seed = 1; seed <= most_seeds && best.count() < all; ++seed) {
        settings.edges = settings.edges_of_few = ways_for(known.degree, seed);
        const auto found = many_views::run_monodromy(problem, seed, settings);
        const int wanted = static_cast<int>(std::ssize(found.points));
        const auto record = many_views::certify(found, wanted, seed, settings.threads);
        if (record.count() > best.count() && record.count() <= all) best = record;
    }
    return best;
}

} // namespace

int main(int argc, char** argv) {
    if (argc < 3 || family_named(argv[1]) == nullptr) {
        std::cerr << "usage: family_solutions FAMILY MOST [PROBLEM]...\n";
        return 3;
    }
    const std::string_view family = argv[1];
    const int most = std::atoi(argv[2]);
    const std::vector<std::string_view> only(argv + 3, argv + argc);
    std::vector<many_views::SolutionsRecord> records;
    bool complete = true;
    for (const std::string_view line : many_views::family_degree_lines()) {
        const many_views::DegreeOnFile known = many_views::parse_family_degree(line);
        const bool wanted = only.empty() || std::ranges::find(only, known.problem) != only.end();
        if (known.family != family || known.degree > most || !wanted) continue;
        records.push_back(best_record(known));
        const Problem& problem = records.back().problem;
        const int count = records.back().count() / problem.cameras->copies(problem.views);
        std::cerr << known.problem << ": " << count << " of " << known.degree << '\n';
        complete = complete && count >= known.degree;
    }
    std::cout << many_views::write_solutions(records);
    return complete ? 0 : 1;
}
