// Theorem C (proofs/common_centres.md): the checker's rows against the degrees that monodromy
// found.
#include "checker/bounds/theorems.h"
#include "tests/checker/bounds/degrees_on_file.h"
#include "tests/checker/bounds/templates.h"

#include <set>

using namespace checker;
using namespace templates;

TEST_CASE("each row of Theorem C has the degree on file, is certified, and a multiple of 8") {
    const auto on_file = degrees_on_file();
    const auto certified = certified_on_file();
    std::set<Signature> classes;
    for (const auto& [number, bound] : common_centre_rows()) {
        CAPTURE(number);
        const Signature constraints = constraint_class(all_classes().representatives.at(number));
        CHECK(on_file.at(constraints) == bound);
        CHECK(certified.contains(constraints));
        CHECK(bound % 8 == 0);
        CHECK(classes.insert(constraints).second);
    }
    CHECK(classes.size() == 9051);
}

TEST_CASE("Theorem C has a row for each minimal class with at most three pins at a point, but for "
          "extensions of five points") {
    std::set<Signature> rows;
    for (const auto& [number, bound] : common_centre_rows())
        rows.insert(constraint_class(all_classes().representatives.at(number)));
    for (std::size_t n = 0; n < all_classes().representatives.size(); ++n) {
        const Signature& signature = all_classes().representatives[n];
        bool many_pins = false;
        for (std::size_t i = 0; i < feature_count; ++i)
            many_pins |= signature[i] > 0 && features[i].pins > 3;
        const bool wanted = is_minimal_class(n) && !many_pins && !has_five_shared_points(signature);
        if (rows.contains(constraint_class(signature)) != wanted) CAPTURE(notation(signature));
        CHECK(rows.contains(constraint_class(signature)) == wanted);
    }
    for (const TheoremBound& row : theorem_bounds)
        CHECK_FALSE(
            rows.contains(constraint_class(all_classes().representatives[class_of(row.problem)])));
}

TEST_CASE("more solutions than Theorem C allows contradict it, and as many make the degree exact") {
    const std::size_t number = class_of("11*P/a/a");
    const Signature key = constraint_class(all_classes().representatives[number]);
    CHECK_FALSE(table_of({}, {{number, 4911, false}}).at(key).exact());
    const DegreeTable exact = table_of({}, {{number, 4912, false}});
    CHECK(exact.at(key).exact());
    CHECK(exact.at(key).at_most->by_theorem());
    CHECK_FALSE(contradiction(exact).has_value());
    CHECK(contradiction(table_of({}, {{number, 4913, false}})).has_value());
}
