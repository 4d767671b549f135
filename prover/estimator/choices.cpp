#include "prover/estimator/choices.h"

#include "prover/estimator/sampler.h"
#include "prover/problem/notation.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace plprove {

namespace {

struct Candidate {
    const char* notation;
    int degree;
    double milliseconds; ///< of one core, by `bench_solve PROBLEM 1000 samples`
    /// With half a pixel of noise, how many samples lead to rotations within 5 degrees of the
    /// truth, a share: by `bench_solve PROBLEM 1000 samples noise`.
    double success;
    double error; ///< in degrees, by `bench_solve PROBLEM 200 noise`
};

constexpr Candidate in_two_views{"5*P/P", 20, 0.09, 0.67, 2.4};

/// Those of few features and few solutions, so that most matches offer one of them. First
/// extensions of the five-point problem: what the third view sees of the five points, and lines.
constexpr std::array in_three_views{
    Candidate{"3*P/P/P + 2*P/P/-", 160, 0.9, 0.56, 3.7},
    Candidate{"2*P/P/P + 3*P/P/- + a/a/a", 80, 0.6, 0.37, 7.5},
    Candidate{"2*Pa/Pa/Pa + 3*P/P/-", 160, 0.9, 0.37, 6.9},
    Candidate{"P/P/P + 4*P/P/- + 2*a/a/a", 160, 1.0, 0.31, 7.7},
    Candidate{"P/P/P + Pab/Pab/Pab + 3*P/P/-", 160, 0.9, 0.39, 7.1},
    Candidate{"5*P/P/- + 3*a/a/a", 160, 1.0, 0.32, 10},
    Candidate{"3*P/P/P + a/a/a", 216, 1.4, 0.43, 5.3},
    Candidate{"2*P/P/P + P/P/- + 2*a/a/a", 256, 1.5, 0.24, 7.3},
    Candidate{"P/P/P + Pa/Pa/Pa + 2*a/a/a", 264, 1.6, 0.29, 6.8},
    Candidate{"2*P/P/P + Pa/Pa/Pa + P/P/-", 304, 1.3, 0.39, 4.7},
    Candidate{"P/P/P + 2*Pa/Pa/Pa", 312, 1.4, 0.38, 5.8},
    Candidate{"P/P/P + 4*a/a/a", 360, 1.6, 0.25, 6.1},
    Candidate{"3*P/P/P + P/P/- + P/-/P", 384, 1.2, 0.45, 2.6},
    Candidate{"Pa/Pa/Pa + Pab/Pab/Pab + a/a/a", 432, 1.6, 0.25, 6.0},
    Candidate{"Pab/Pab/Pab + Pabc/Pabc/Pabc", 480, 1.6, 0.21, 7.7},
};

/// The problem with its views in each order, each once.
std::vector<Features> in_all_orders(const Features& problem) {
    std::vector<Features> result;
    std::array<int, 3> order{0, 1, 2};
    do {
        Features other;
        for (const Feature& feature : problem)
            other.push_back(relabel_views(feature, order));
        const auto same = [&](const Features& known) {
            return std::ranges::is_permutation(known, other);
        };
        if (std::ranges::none_of(result, same)) result.push_back(std::move(other));
    } while (std::ranges::next_permutation(order).found);
    return result;
}

double expected_milliseconds(const Candidate& candidate, const Features& problem) {
    constexpr double right = 0.7;
    double matches = 0;
    for (const Feature& feature : problem)
        matches += feature.has_point + feature.lines;
    return candidate.milliseconds / (candidate.success * std::pow(right, matches));
}

} // namespace

std::vector<Choice> choices(const Matches& matches) {
    std::vector<Choice> result;
    const auto add = [&](const Candidate& candidate, const Features& problem) {
        if (Sampler(problem, matches).draw(0, 0))
            result.push_back({problem, candidate.degree, candidate.milliseconds,
                              expected_milliseconds(candidate, problem), candidate.error});
    };
    if (matches.views() == 2)
        add(in_two_views, parse_features(in_two_views.notation));
    else
        for (const Candidate& candidate : in_three_views)
            for (const Features& problem : in_all_orders(parse_features(candidate.notation)))
                add(candidate, problem);
    std::ranges::stable_sort(result, {}, &Choice::expected);
    return result;
}

} // namespace plprove
