// The numbers of Theorem Y (proofs/calibrated_moduli.md): intersection numbers, for one problem
// less the zeros of Lemma Y4. Compares them with the checker's table of theorems. From the folder
// that holds checker/ and proofs/:
//
//   c++ -std=c++20 -O2 -I. proofs/computations/calibrated_moduli.cpp -lgmp -o calibrated_moduli
//
// Each line of the output is a problem and its number. Exit status 1 if a row of the table differs,
// is missing, or there is one too many.
#include "checker/bounds/theorems.h"
#include "proofs/computations/isotropic_planes.h"
#include "proofs/computations/moduli_space.h"

#include <algorithm>
#include <iostream>
#include <string_view>

namespace {

struct Case {
    std::string_view theorem; // of the row in the table
    std::string_view problem;
    proofs::VisibleFeatures features;
    bool has_other_zeros = false; // which are no solutions
};

/// For each of three views, and each of two isotropic points of a line in it (Lemma Y4).
std::int64_t zeros_of_rank_one() {
    return 3 * 2 * static_cast<std::int64_t>(proofs::isotropic_planes());
}

/// The classes of which Theorem Y speaks. U11 bounds the first one by the same number.
const std::vector<Case>& cases() {
    static const std::vector<Case> all{
        {"U11", "Pabcd/Pabcd/Pabcd + Pa/Pa/Pa", {{4, 1}, 0}},
        {"Y", "Pabcd/Pabcd/Pabcd + 2*a/a/a", {{4}, 2}},
        {"Y", "Pabc/Pabc/Pabc + Pab/Pab/Pab", {{3, 2}, 0}},
        {"Y", "Pabc/Pabc/Pabc + P/P/P + a/a/a", {{3, 0}, 1}},
        {"Y", "Pab/Pab/Pab + 3*a/a/a", {{2}, 3}},
        {"Y", "P/P/P + 4*a/a/a", {{0}, 4}},
        {"Y", "Pab/Pab/Pab + Pa/Pa/Pa + a/a/a", {{2, 1}, 1}, true},
    };
    return all;
}

bool is_in_table(const Case& c, std::int64_t number) {
    return std::ranges::any_of(checker::theorem_bounds, [&](const checker::TheoremBound& row) {
        return row.theorem == c.theorem && row.problem == c.problem && row.bound == number;
    });
}

} // namespace

int main() {
    const std::vector<proofs::FixedPoint> points = proofs::fixed_points();
    bool all = true;
    for (const Case& c : cases()) {
        const std::int64_t zeros = proofs::intersection_number(points, c.features);
        const std::int64_t number = zeros - (c.has_other_zeros ? zeros_of_rank_one() : 0);
        const bool holds = is_in_table(c, number);
        std::cout << (holds ? "holds   " : "FAILS   ") << "Theorem Y, " << c.problem << ": "
                  << number << '\n';
        all = all && holds;
    }
    const auto of_theorem = [](auto theorem) { return theorem == "Y"; };
    const auto rows =
        std::ranges::count_if(checker::theorem_bounds, of_theorem, &checker::TheoremBound::theorem);
    all = all && rows == std::ranges::count_if(cases(), of_theorem, &Case::theorem);
    std::cout << (all ? "All hold.\n" : "Some fail, or the table has other rows of Theorem Y.\n");
    return all ? 0 : 1;
}
