// The degrees of problems that views may see in part, for certs/three-views-in-part.csv: by paths,
// where two seeds have to agree.
//
// Usage: three_views_degrees.py --list KIND | degrees_in_part MOST
//
// Reads lines of a problem and the number of its label classes, and adds the columns `degree` and
// `source`. The degree is - if there are more than MOST solutions, ? if seeds do not agree.
#include "prover/minimal/problem_record.h"
#include "prover/model/solver/solution_count.h"
#include "prover/monodromy/two_seeds.h"
#include "prover/problem/notation.h"
#include "prover/scripts/problem_model.h"

#include <cstdlib>
#include <iostream>
#include <string>

using namespace plprove;

namespace {

std::string columns(const Problem& problem, int most) {
    constexpr std::uint64_t most_seeds = 6;
    if (!is_minimal(certify(problem))) return "0,not minimal";
    const std::string text = problem_model(best_view_first(problem), 0);
    const model::Program program = model::compile(model::read_model(text));
    const auto found = counted_twice(most, most_seeds, [&](std::uint64_t seed) {
        return model::count_solutions(program, {.seed = seed, .most_solutions = most});
    });
    const std::string degree = !found ? "-" : found->exact ? std::to_string(found->solutions) : "?";
    return degree + ",by paths for its constraint class";
}

} // namespace

int main(int argc, char** argv) {
    const int most = argc == 2 ? std::atoi(argv[1]) : 0;
    if (most < 1) {
        std::cerr << "usage: three_views_degrees.py --list KIND | degrees_in_part MOST\n";
        return 3;
    }
    for (std::string line; std::getline(std::cin, line);)
        std::cout << line << ',' << columns(parse_problem(line.substr(0, line.find(','))), most)
                  << std::endl;
}
