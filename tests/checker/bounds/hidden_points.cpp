// Theorems S and X (proofs/relations.md): their bounds against what is known of the same degrees in
// other ways, and against the statements.
#include "proofs/computations/hidden_points.h"
#include "tests/checker/bounds/degrees_on_file.h"
#include "tests/checker/bounds/templates.h"

using namespace checker;
using namespace templates;

namespace {
/// One signature of each minimal constraint class, by class.
const std::map<Signature, Signature>& minimal_constraint_classes() {
    static const std::map<Signature, Signature> classes = [] {
        std::map<Signature, Signature> found;
        for (std::size_t n = 0; n < all_classes().representatives.size(); ++n) {
            const Signature& signature = all_classes().representatives[n];
            if (is_minimal_class(n)) found.emplace(constraint_class(signature), signature);
        }
        return found;
    }();
    return classes;
}
} // namespace

TEST_CASE("certified degrees attain the bounds of Theorem S, all but 36") {
    const auto on_file = degrees_on_file();
    const auto certified = certified_on_file();
    std::size_t attained = 0, larger = 0;
    for (const auto& [key, signature] : minimal_constraint_classes()) {
        if (has_five_shared_points(signature) || proofs::bound_by_theorem(signature)) continue;
        const auto bound = proofs::hidden_bound_by_theorem(signature);
        if (!bound) continue;
        CAPTURE(notation(signature));
        const auto degree = static_cast<std::int64_t>(on_file.at(key));
        CHECK(degree <= *bound);
        CHECK(certified.contains(key));
        CHECK(*bound % 8 == 0);
        ++(degree == *bound ? attained : larger);
    }
    CHECK(attained == 938);
    CHECK(larger == 36);
}

TEST_CASE("where two views share five points, Theorem S and the templates give the same degree") {
    const DegreeTable table = table_of(committed().bounds);
    std::size_t compared = 0;
    for (const auto& [key, signature] : minimal_constraint_classes()) {
        if (!has_five_shared_points(signature)) continue;
        const auto bound = proofs::hidden_bound_by_theorem(signature);
        if (!bound) continue;
        CAPTURE(notation(signature));
        CHECK(static_cast<std::size_t>(*bound) == table.at(key).at_most->solutions);
        ++compared;
    }
    CHECK(compared == 321);
}

TEST_CASE("Theorem S with another view first: where both speak, no bound is below the degree") {
    const auto on_file = degrees_on_file();
    std::size_t compared = 0, agree = 0;
    for (const auto& [key, signature] : minimal_constraint_classes()) {
        std::set<Signature> seen;
        for (const FeatureMap& map : relabelings) {
            const Signature relabeled = proofs::merged(permuted(signature, map));
            if (!seen.insert(relabeled).second) continue;
            const auto bound = proofs::hidden_bound_in_view_1(relabeled);
            if (!bound) continue;
            CAPTURE(notation(relabeled));
            const std::size_t degree = on_file.at(key);
            CHECK(static_cast<std::size_t>(*bound) >= degree);
            agree += static_cast<std::size_t>(*bound) == degree ? 1 : 0;
            ++compared;
        }
    }
    CHECK(agree + 60 == compared);
}

TEST_CASE("Theorem X: all degrees on file agree, and certified ones come from other theorems") {
    const auto on_file = degrees_on_file();
    std::size_t equations = 0;
    for (const auto& [key, signature] : minimal_constraint_classes()) {
        for (const Signature& other : proofs::handed_over(key)) {
            CAPTURE(notation(key));
            CAPTURE(notation(other));
            CHECK(on_file.at(key) == on_file.at(other));
            ++equations;
        }
    }
    CHECK(equations == 2436);
}

TEST_CASE("a view hands a point over where four points are shared: with three, degrees differ") {
    const auto on_file = degrees_on_file();
    const auto class_with = [](std::string_view problem) {
        return constraint_class(all_classes().representatives[class_of(problem)]);
    };
    const Signature three = class_with("3*-/P/P + 8*a/P/a");
    CHECK(proofs::handed_over(three).empty());
    CHECK(on_file.at(three) != on_file.at(class_with("3*-/P/P + 7*a/P/a + a/a/P")));
    const Signature four = class_with("4*-/P/P + 7*a/P/a");
    CHECK(proofs::handed_over(four) == std::set{class_with("4*-/P/P + 6*a/P/a + a/a/P")});
}

TEST_CASE("with four P/P/- the classes of a/P/a and P/a/a are the same on M") {
    using namespace proofs; // its operators
    const FeatureClasses c;
    const Cycle difference = cycle_of(HiddenPoints{.t_2 = 1}) - c.T;
    for (unsigned of_t = 0; of_t <= 6; ++of_t) {
        const Cycle rest = power(c.E_3, 4) * power(c.T, of_t) * power(c.E_2, 6 - of_t);
        CHECK(degree_of(rest * difference) == 0);
    }
    const Cycle three = power(c.E_3, 3) * power(c.T, 7);
    CHECK(degree_of(three * difference) != 0);
}
