// Which theorem gives the degree of a class, and the rows of the classes without an integral.
#include "checker/exactly/degree.h"

#include "checker/degrees/constraint_class.h"
#include "checker/exactly/many_pins.h"
#include "tests/support/minimal_classes.h"

#include <doctest/doctest.h>

using namespace checker;
using namespace checker::exactly;

TEST_CASE("each row is a minimal class of its own, and no integral gives its degree") {
    const std::map<Signature, Row> all = rows_by_class(rows);
    CHECK(all.size() == rows.size());
    for (const auto& [signature, row] : all) {
        CHECK(constraint_class(signature) == signature);
        CHECK(is_minimal_class(number_of(all_classes(), signature)));
        CHECK_FALSE(theorem_k_applies(signature));
        CHECK(row.problem.starts_with("Pabcde"));
    }
}

TEST_CASE("a second row for a class is refused, in whichever words") {
    constexpr Row first{"Pabcdef/Pabcdef/Pabcdef + -/P/P + a/P/a", 64, "U8"};
    constexpr Row same{"Pabcdef/Pabcdef/Pabcdef + -/P/P + a/P/a", 63, "U8"};
    constexpr Row relabeled{"Pabcdef/Pabcdef/Pabcdef + P/-/P + P/a/a", 64, "U8"};
    constexpr Row other{"Pabcdef/Pabcdef/Pabcdef + -/P/P + P/a/a", 64, "U8"};
    CHECK_THROWS_AS(rows_by_class(std::array{first, same}), std::logic_error);
    CHECK_THROWS_AS(rows_by_class(std::array{first, relabeled}), std::logic_error);
    CHECK(rows_by_class(std::array{first, other}).size() == 2);
}

TEST_CASE("a degree does not depend on which degrees were asked for before") {
    const auto key = [](std::string_view problem) {
        return constraint_class(all_classes().representatives[class_of(problem)]);
    };
    const std::array problems{key("2*Pa/Pa/Pa + P/P/P"), key("4*P/a/a + 4*a/P/a + 3*a/a/P"),
                              key("P/P/P + 4*a/a/a"), key("Pabcd/Pabcd/Pabcd + 2*a/a/a"),
                              key("Pabcde/Pabcde/Pabcde + P/P/P")};
    constexpr std::array<std::size_t, 5> expected{312, 43224, 360, 480, 64};
    Degrees forwards, backwards;
    for (std::size_t i = 0; i < problems.size(); ++i) {
        CHECK(forwards.of(problems[i])->solutions == expected[i]);
        const std::size_t j = problems.size() - 1 - i;
        CHECK(backwards.of(problems[j])->solutions == expected[j]);
        CHECK(Degrees().of(problems[i])->solutions == expected[i]);
    }
}
