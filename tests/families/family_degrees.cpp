// The degrees of a family of problems, for certs/family-degrees.csv: computed with two seeds each,
// which have to agree.
//
// Usage: family_degrees plmp|projective MOST [TABLE]
//
// Prints a line for each minimal problem of the family. Problems that TABLE has already are left
// out; so are those with more than MOST solutions, which it names on stderr.
#include "prover/many_views/monodromy.h"
#include "prover/minimal/problem_record.h"
#include "prover/problem/notation.h"

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

/// A line of the table: exact if two seeds give the same number, else the smaller one, as a run may
/// count a solution twice. Nothing if there are more solutions.
std::string line_of(const std::string& family, const Problem& problem, int most) {
    many_views::MonodromySettings settings;
    settings.threads = static_cast<int>(std::max(1U, std::thread::hardware_concurrency()));
    settings.most_solutions = most;
    const auto first = run_monodromy(problem, 1, settings);
    if (first.solutions > most) return {};
    const auto second = run_monodromy(problem, 2, settings);
    const bool agree = first.solutions == second.solutions;
    return family + ',' + notation(problem) + ',' +
           std::to_string(std::min(first.solutions, second.solutions)) + ',' +
           (agree ? "exact" : "at-least") + ",evidence,," + // nothing is certified yet
           std::to_string(first.edges + second.edges) + " of " +
           std::to_string(first.ways + second.ways) + " ways agree\n";
}

} // namespace

int main(int argc, char** argv) {
    if (argc < 3) {
        std::cerr << "usage: family_degrees plmp|projective MOST [TABLE]\n";
        return 3;
    }
    const std::string name = argv[1];
    const CameraModel& family = name == "plmp" ? calibrated_cameras : projective_cameras;
    const auto known = argc > 3 ? problems_in(argv[3]) : std::set<std::string>{};
    for (const Problem& problem : family_problems(family)) {
        const std::string notation = plprove::notation(problem);
        if (known.contains(notation) || !is_minimal(certify(problem))) continue;
        const std::string line = line_of(name, problem, std::atoi(argv[2]));
        if (line.empty())
            std::cerr << notation << " has more than " << argv[2] << " solutions\n";
        else
            std::cout << line << std::flush;
    }
    return 0;
}
