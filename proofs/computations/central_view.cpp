// The bounds by Theorem R of proofs/relations.md. Compares them with the checker's table
// (checker/bounds/central_views.h and central_views_lines.h); `--rows` prints the rows of the
// table. From the folder that holds checker/ and proofs/:
//
//   c++ -std=c++20 -O2 -I. proofs/computations/central_view.cpp -o central_view
//
// Exit status 1 if a row is missing or wrong, or there is one too many.
#include "checker/bounds/theorems.h"
#include "checker/problem/obstruction.h"
#include "proofs/computations/feature_classes.h"

#include <iostream>
#include <map>
#include <set>
#include <string>

namespace {

using checker::Signature;

/// The rows that the table should have: one for each minimal constraint class of which the theorem
/// speaks, but not those in which two views share five points.
std::map<std::string, unsigned> expected_rows() {
    const checker::Classification all = checker::classify();
    std::set<Signature> seen;
    std::map<std::string, unsigned> rows;
    for (const Signature& signature : all.representatives) {
        if (!checker::obstruction(signature).minimal()) continue;
        if (!seen.insert(checker::constraint_class(signature)).second) continue;
        const bool extension = std::ranges::any_of(checker::view_pairs, [&](checker::Views pair) {
            return checker::shared_points(signature, pair) == 5;
        });
        if (extension) continue;
        if (const auto found = proofs::bound_by_theorem(signature))
            rows[checker::notation(signature)] = static_cast<unsigned>(*found);
    }
    return rows;
}

} // namespace

int main(int argc, char** argv) {
    const std::map<std::string, unsigned> expected = expected_rows();
    if (argc > 1 && std::string_view(argv[1]) == "--rows") {
        for (const auto& [problem, bound] : expected)
            std::cout << bound << ' ' << problem << ";\n";
        return 0;
    }
    std::map<std::string, unsigned> table;
    for (const auto& [theorem, problem, bound] : checker::central_view_rows())
        table[std::string(problem)] = bound;
    const bool holds = table == expected;
    std::cout << "Theorem R: " << expected.size() << " constraint classes, the rows of the table: "
              << (holds ? "holds" : "FAILS: run it with --rows and compare") << '\n';
    return holds ? 0 : 1;
}
