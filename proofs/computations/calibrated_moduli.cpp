// The numbers of Theorem Y (proofs/calibrated_moduli.md): intersection numbers, for one problem
// less the zeros of Lemma Y4. Compares them with the checker's tables of theorems. From the folder
// that holds checker/ and proofs/:
//
//   c++ -std=c++20 -O2 -I. proofs/computations/calibrated_moduli.cpp -lgmp -o calibrated_moduli
//
// Each line of the output is a problem and its number. Exit status 1 if a row differs or is
// missing.
#include "checker/bounds/theorems.h"
#include "checker/problem/classes.h"
#include "proofs/computations/isotropic_planes.h"
#include "proofs/computations/moduli_space.h"

#include <iostream>
#include <map>
#include <string>
#include <string_view>

namespace {

struct Case {
    std::string_view problem;
    proofs::VisibleFeatures features;
    bool has_other_zeros = false; // which are no solutions
};

/// For each of three views, and each of two isotropic points of a line in it (Lemma Y4).
std::int64_t zeros_of_rank_one() {
    return 3 * 2 * static_cast<std::int64_t>(proofs::isotropic_planes());
}

/// The classes of which Theorem Y speaks, and one that Theorem U11 bounds by the same number. The
/// second has a row of Theorem Y; of the others Theorem C has rows.
const std::vector<Case>& cases() {
    static const std::vector<Case> all{
        {"Pabcd/Pabcd/Pabcd + Pa/Pa/Pa", {{4, 1}, 0}},
        {"Pabcd/Pabcd/Pabcd + 2*a/a/a", {{4}, 2}},
        {"Pabc/Pabc/Pabc + Pab/Pab/Pab", {{3, 2}, 0}},
        {"Pabc/Pabc/Pabc + P/P/P + a/a/a", {{3, 0}, 1}},
        {"Pab/Pab/Pab + 3*a/a/a", {{2}, 3}},
        {"P/P/P + 4*a/a/a", {{0}, 4}},
        {"Pab/Pab/Pab + Pa/Pa/Pa + a/a/a", {{2, 1}, 1}, true},
    };
    return all;
}

/// The bounds of the checker's tables, by problem.
std::map<std::string, std::int64_t> rows() {
    std::map<std::string, std::int64_t> bounds;
    for (const auto& [theorem, problem, bound] : checker::theorem_bounds)
        bounds[std::string(problem)] = bound;
    const checker::Classification all = checker::classify();
    for (const auto& [number, bound] : checker::common_centre_rows())
        bounds[checker::notation(all.representatives.at(number))] = bound;
    return bounds;
}

} // namespace

int main() {
    const std::vector<proofs::FixedPoint> points = proofs::fixed_points();
    const std::map<std::string, std::int64_t> bounds = rows();
    bool all = true;
    for (const Case& c : cases()) {
        const std::int64_t zeros = proofs::intersection_number(points, c.features);
        const std::int64_t number = zeros - (c.has_other_zeros ? zeros_of_rank_one() : 0);
        const auto row = bounds.find(std::string(c.problem));
        const bool holds = row != bounds.end() && row->second == number;
        std::cout << (holds ? "holds   " : "FAILS   ") << "Theorem Y, " << c.problem << ": "
                  << number << '\n';
        all = all && holds;
    }
    std::cout << (all ? "All hold.\n" : "Some fail.\n");
    return all ? 0 : 1;
}
