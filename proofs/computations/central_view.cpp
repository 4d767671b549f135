// The bounds by Theorems R, S and X of proofs/relations.md. Compares them with the checker's tables
// (checker/bounds/central_views.h, hidden_points.h and others that these name); `--rows` prints the
// rows, each with its theorem. From the folder that holds checker/ and proofs/:
//
//   c++ -std=c++20 -O2 -I. proofs/computations/central_view.cpp -o central_view
//
// Exit status 1 if a row is missing or wrong, or there is one too many.
#include "checker/bounds/theorems.h"
#include "proofs/computations/hidden_points.h"

#include <iostream>
#include <map>
#include <string>

namespace {

using checker::Signature;

struct Row {
    std::string theorem;
    unsigned bound = 0;
    bool operator==(const Row&) const = default;
};

/// By problem.
using Rows = std::map<std::string, Row>;

/// One signature of each minimal constraint class in which no two views share five points.
std::vector<Signature> classes_to_bound() {
    const checker::Classification all = checker::classify();
    std::set<Signature> seen;
    std::vector<Signature> found;
    for (const Signature& signature : all.representatives) {
        if (!checker::obstruction(signature).minimal()) continue;
        if (!seen.insert(checker::constraint_class(signature)).second) continue;
        const bool extension = std::ranges::any_of(checker::view_pairs, [&](checker::Views pair) {
            return checker::shared_points(signature, pair) == 5;
        });
        if (!extension) found.push_back(signature);
    }
    return found;
}

/// The bounds by Theorem R, or else by Theorem S, by constraint class.
std::map<Signature, Row> direct_bounds(const std::vector<Signature>& classes) {
    std::map<Signature, Row> bounds;
    for (const Signature& signature : classes) {
        const Signature key = checker::constraint_class(signature);
        if (const auto by_r = proofs::bound_by_theorem(signature))
            bounds[key] = {"R", static_cast<unsigned>(*by_r)};
        else if (const auto by_s = proofs::hidden_bound_by_theorem(signature))
            bounds[key] = {"S", static_cast<unsigned>(*by_s)};
    }
    return bounds;
}

/// The rows that the tables should have. Where a class of equal degree has a smaller bound, the row
/// is one of Theorem X. A class in the table of proofs/upper_bounds.md has no row by Theorems S and
/// X.
Rows expected_rows() {
    const std::vector<Signature> classes = classes_to_bound();
    const std::map<Signature, Row> direct = direct_bounds(classes);
    std::set<std::string_view> bounded;
    for (const checker::TheoremBound& row : checker::theorem_bounds)
        bounded.insert(row.problem);
    Rows rows;
    for (const Signature& signature : classes) {
        const Signature key = checker::constraint_class(signature);
        std::optional<Row> best;
        if (const auto own = direct.find(key); own != direct.end()) best = own->second;
        for (const Signature& other : proofs::of_equal_degree(key)) {
            const auto found = direct.find(other);
            if (found == direct.end()) continue;
            const unsigned bound = found->second.bound;
            if (!best || bound < best->bound) best = Row{"X", bound};
        }
        const std::string problem = checker::notation(signature);
        if (best && (best->theorem == "R" || !bounded.contains(problem))) rows[problem] = *best;
    }
    return rows;
}

} // namespace

int main(int argc, char** argv) {
    const Rows expected = expected_rows();
    if (argc > 1 && std::string_view(argv[1]) == "--rows") {
        for (const auto& [problem, row] : expected)
            std::cout << row.theorem << ' ' << row.bound << ' ' << problem << ";\n";
        return 0;
    }
    Rows table;
    for (const auto& [theorem, problem, bound] : checker::central_view_rows())
        table[std::string(problem)] = {std::string(theorem), bound};
    const bool holds = table == expected;
    std::cout << "Theorems R, S and X: " << expected.size()
              << " constraint classes, the rows of the tables: "
              << (holds ? "holds" : "FAILS: run it with --rows and compare") << '\n';
    return holds ? 0 : 1;
}
