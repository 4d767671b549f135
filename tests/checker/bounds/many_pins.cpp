// Theorem K (proofs/points_with_many_pins.md): the checker's rows against the degrees that
// monodromy found, and against the rows of other theorems.
#include "checker/bounds/theorems.h"
#include "tests/checker/bounds/degrees_on_file.h"
#include "tests/checker/bounds/templates.h"

#include <set>

using namespace checker;
using namespace templates;

TEST_CASE("each row of Theorem K has the degree on file, and no other theorem bounds its class") {
    const auto on_file = degrees_on_file();
    std::set<Signature> others, classes;
    for (const auto& [theorem, problem, bound] : theorem_bounds)
        others.insert(constraint_class(all_classes().representatives[class_of(problem)]));
    for (const auto& [number, bound] : common_centre_rows())
        others.insert(constraint_class(all_classes().representatives.at(number)));
    for (const auto& [number, bound] : many_pin_rows()) {
        CAPTURE(number);
        const Signature constraints = constraint_class(all_classes().representatives.at(number));
        CHECK(on_file.at(constraints) == bound);
        CHECK_FALSE(others.contains(constraints));
        CHECK(classes.insert(constraints).second);
    }
    CHECK(classes.size() == 65);
}

TEST_CASE("the checker names Theorem K") {
    const Signature constraints =
        constraint_class(all_classes().representatives[class_of("Pabcd/Pabcd/Pabcd + 4*P/a/a")]);
    const auto& bound = table_of({}).at(constraints).at_most.value();
    CHECK(bound.solutions == 1248);
    CHECK(std::get<TheoremRow>(bound.by).theorem == theorem_of_many_pins);
}
