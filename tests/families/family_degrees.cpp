// The degrees of a family of problems, for certs/family-degrees.csv: two seeds each have to agree.
//
// Usage: family_degrees FAMILY MOST [TABLE]
//
// Prints a line for each minimal problem of the family. Problems that TABLE has already are left
// out; so are those with more than MOST solutions, which it names on stderr.
#include "prover/many_views/monodromy.h"
#include "prover/minimal/problem_record.h"
#include "prover/problem/complete_visibility.h"
#include "prover/problem/notation.h"
#include "tests/families/two_seeds.h"

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <iostream>
#include <set>
#include <string>
#include <thread>

using namespace plprove;

namespace {

/// The problems that the table has a line for: the second column.
std::set<std::string> problems_in(const char* file) {
    std::set<std::string> problems;
    std::ifstream stream(file);
    for (std::string line; std::getline(stream, line);) {
        const auto begin = line.find(',') + 1;
        problems.insert(line.substr(begin, line.find(',', begin) - begin));
    }
    return problems;
}

/// A line of the table. Nothing if there are more solutions.
std::string line_of(const std::string& family, const Problem& problem, int most) {
    many_views::MonodromySettings settings;
    settings.threads = static_cast<int>(std::max(1U, std::thread::hardware_concurrency()));
    const int copies = problem.cameras->copies(problem.views);
    settings.most_solutions = most * copies;
    const auto found = counted_twice(most, [&](std::uint64_t seed) {
        MonodromyCount count = run_monodromy(problem, seed, settings);
        count.solutions = (count.solutions + copies - 1) / copies; // some may be lost
        return count;
    });
    if (!found) return {};
    return family + ',' + notation(problem) + ',' + std::to_string(found->solutions) +
           (found->exact ? ",exact" : ",at-least") + ",evidence,," + // nothing is certified yet
           std::to_string(found->agreeing_ways) + " of " + std::to_string(found->ways) +
           " ways agree\n";
}

} // namespace

int main(int argc, char** argv) {
    const CameraModel* family = argc < 3 ? nullptr : family_named(argv[1]);
    if (family == nullptr) {
        std::cerr << "usage: family_degrees FAMILY MOST [TABLE]\n";
        return 3;
    }
    const std::string name = argv[1];
    const auto on_file = argc > 3 ? problems_in(argv[3]) : std::set<std::string>{};
    for (const Problem& problem : family_problems(*family)) {
        const std::string notation = plprove::notation(problem);
        if (on_file.contains(notation) || !is_minimal(certify(problem))) continue;
        const std::string line = line_of(name, problem, std::atoi(argv[2]));
        if (line.empty())
            std::cerr << notation << " has more than " << argv[2] << " solutions\n";
        else
            std::cout << line << std::flush;
    }
    return 0;
}
