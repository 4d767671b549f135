// The degrees that Theorem K proves (proofs/points_with_many_pins.md). From the folder that holds
// checker/ and proofs/:
//
//   c++ -std=c++20 -O2 -I. proofs/computations/points_with_many_pins.cpp -lgmp -o many
//   ./many
//
// prints them for each constraint class to which the theorem applies, and compares them with the
// checker's rows. Exit status 1 if a row is not a degree of the theorem.
#include "checker/bounds/theorems.h"
#include "checker/degrees/constraint_class.h"
#include "proofs/computations/four_pins.h"

#include <iostream>
#include <map>
#include <set>

int main() {
    std::map<std::size_t, std::int64_t> rows;
    for (const auto& [number, bound] : checker::many_pin_rows())
        rows.emplace(number, bound);
    const auto few_common_points = proofs::blown_up::integrals_with_stars();
    const proofs::blown_up::FourPinIntegrals four_pins;
    const checker::Classification classes = checker::classify();
    std::set<checker::Signature> printed;
    bool hold = true;
    for (std::size_t number = 0; number < classes.representatives.size(); ++number) {
        const checker::Signature constraints =
            checker::constraint_class(classes.representatives[number]);
        if (!proofs::blown_up::has_degree_with_many_pins(constraints)) continue;
        if (!checker::obstruction(constraints).minimal()) continue;
        if (!printed.insert(constraints).second) continue;
        const bool few = proofs::blown_up::views_share_few_points(constraints);
        const std::int64_t degree =
            few ? few_common_points.of(constraints) : four_pins.of(constraints);
        std::cout << degree << ' ' << checker::notation(constraints) << '\n';
        const auto row = rows.find(number);
        if (row == rows.end()) continue;
        hold = hold && row->second == degree;
        rows.erase(row);
    }
    hold = hold && rows.empty();
    std::cout << "Theorem K, " << printed.size()
              << " constraint classes: " << (hold ? "All rows hold" : "NOT ALL ROWS HOLD") << '\n';
    return hold ? 0 : 1;
}
