// The bounds by Theorems R, S and X of proofs/relations.md, a second proof of degrees that Theorem
// C (proofs/common_centres.md) has. Compares them with the checker's table of this theorem;
// `--rows` prints them. From the folder that holds checker/ and proofs/:
//
//   c++ -std=c++20 -O2 -I. proofs/computations/central_view.cpp -o central_view
//
// Exit status 1 if a bound is smaller than the row of its class, or too few are the same.
#include "checker/bounds/theorems.h"
#include "proofs/computations/hidden_points.h"

#include <iostream>
#include <map>
#include <string>

namespace {

using checker::Signature;

struct Bound {
    std::string_view theorem{};
    std::int64_t solutions = 0;
};

/// By constraint class.
using Bounds = std::map<Signature, Bound>;

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

/// The bounds by Theorem R, or else by Theorem S.
Bounds direct_bounds(const std::vector<Signature>& classes) {
    Bounds bounds;
    for (const Signature& signature : classes) {
        const Signature key = checker::constraint_class(signature);
        if (const auto by_r = proofs::bound_by_theorem(signature))
            bounds[key] = {"R", *by_r};
        else if (const auto by_s = proofs::hidden_bound_by_theorem(signature))
            bounds[key] = {"S", *by_s};
    }
    return bounds;
}

/// The same, and by Theorem X where a class of equal degree has a smaller bound.
Bounds all_bounds() {
    const std::vector<Signature> classes = classes_to_bound();
    const Bounds direct = direct_bounds(classes);
    Bounds bounds = direct;
    for (const Signature& signature : classes) {
        const Signature key = checker::constraint_class(signature);
        for (const Signature& other : proofs::of_equal_degree(key)) {
            const auto found = direct.find(other);
            if (found == direct.end()) continue;
            const std::int64_t solutions = found->second.solutions;
            const auto own = bounds.find(key);
            if (own == bounds.end() || solutions < own->second.solutions)
                bounds[key] = {"X", solutions};
        }
    }
    return bounds;
}

/// The rows of Theorem C, by constraint class.
std::map<Signature, std::int64_t> rows() {
    const checker::Classification all = checker::classify();
    std::map<Signature, std::int64_t> found;
    for (const auto& [number, bound] : checker::common_centre_rows())
        found[checker::constraint_class(all.representatives.at(number))] = bound;
    return found;
}

/// How bounds compare with the rows.
struct Comparison {
    std::size_t same = 0, larger = 0, smaller = 0;
};

std::map<std::string_view, Comparison> compare(const Bounds& bounds) {
    const std::map<Signature, std::int64_t> degrees = rows();
    std::map<std::string_view, Comparison> by_theorem;
    for (const auto& [signature, bound] : bounds) {
        Comparison& found = by_theorem[bound.theorem];
        const std::int64_t degree = degrees.at(signature);
        ++(bound.solutions == degree  ? found.same
           : bound.solutions > degree ? found.larger
                                      : found.smaller);
    }
    return by_theorem;
}

} // namespace

int main(int argc, char** argv) {
    const Bounds bounds = all_bounds();
    if (argc > 1 && std::string_view(argv[1]) == "--rows") {
        for (const auto& [signature, bound] : bounds)
            std::cout << bound.theorem << ' ' << bound.solutions << ' '
                      << checker::notation(signature) << ";\n";
        return 0;
    }
    bool hold = true;
    for (const auto& [theorem, found] : compare(bounds)) {
        std::cout << "Theorem " << theorem << ": " << found.same << " bounds are the degrees, "
                  << found.larger << " are larger, " << found.smaller << " smaller\n";
        hold = hold && found.smaller == 0 && found.same > 10 * found.larger;
    }
    std::cout << (hold ? "All hold" : "NOT ALL HOLD") << '\n';
    return hold ? 0 : 1;
}
