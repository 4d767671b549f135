// The trace test of 1021_1, the problem in six views (tests/families/pencil_trace.h): whether
// monodromy has found all solutions. Takes some twenty minutes of two cores.
//
// Usage: six_views_trace [SEED] [WAYS] [MOST]
//
// Says how many solutions monodromy finds along several ways, and what their sum does as an image
// moves. The status is 0 if no path is lost and the sum is linear, a thousand times as exactly as
// a missing solution would let it.
#include "prover/many_views/monodromy.h"
#include "prover/problem/notation.h"
#include "tests/families/pencil_trace.h"

#include <algorithm>
#include <cstdlib>
#include <iostream>
#include <thread>

using namespace plprove;

int main(int argc, char** argv) {
    const auto argument = [&](int i, int value) { return argc > i ? std::atoi(argv[i]) : value; };
    const auto seed = static_cast<std::uint64_t>(argument(1, 3));
    many_views::MonodromySettings settings;
    settings.edges = argument(2, 4);
    settings.most_solutions = argument(3, settings.most_solutions);
    settings.threads = static_cast<int>(std::max(1U, std::thread::hardware_concurrency()));
    const Problem problem = parse_problem("Pa/Pa/Pa/Pa/Pa/Pa + 2*a/a/a/a/a/a");
    const auto found = run_monodromy(problem, seed, settings);
    std::cout << found.points.size() << " solutions, " << found.edges << " of " << found.ways
              << " ways agree\n"
              << std::flush;
    const many_views::PencilTrace trace =
        trace_in_pencil(found.system, found.images, found.points, seed, settings.threads);
    std::cout << trace.lost << " lost as the image moves\n"
              << "slope of the sum: " << trace.slope << '\n'
              << "two slopes differ by " << trace.difference << '\n'
              << "they would by " << trace.if_one_missing << " if one solution were missing\n";
    constexpr double safety = 1000;
    const bool linear = trace.difference * safety < trace.if_one_missing;
    std::cout << (trace.lost == 0 && linear ? "evidence that none is missing\n" : "no evidence\n");
    return trace.lost == 0 && linear ? 0 : 1;
}
