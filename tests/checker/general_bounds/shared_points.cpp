// Theorem W (proofs/shared_points.md): which calibrated problem it leads to, and the degrees on
// file that follow. tests/families/shared_points.py made these, paths counted some.
#include "checker/general_bounds/shared_points.h"

#include "checker/conclusion/label_class.h"
#include "checker/degrees/constraint_class.h"
#include "checker/exactly/degree.h"
#include "checker/problem/notation.h"
#include "tests/checker/general_bounds/degrees_on_file.h"

#include <doctest/doctest.h>

using namespace checker;

namespace {

std::optional<Signature> signature_of_part(const std::string& text) {
    const auto part = calibrated_part(parse_problem(text));
    return part ? label_class(*part) : std::nullopt;
}

/// The degree of a minimal problem by the theorem; 0 if it says nothing.
std::size_t degree_by_theorem(exactly::Degrees& degrees, const std::string& text) {
    const auto signature = signature_of_part(text);
    if (!signature) return 0;
    return degrees.of(constraint_class(*signature)).value().solutions * 3 / 2;
}

std::string part_of(const std::string& text) {
    const auto signature = signature_of_part(text);
    return signature ? notation(*signature) : "none";
}

} // namespace

TEST_CASE("one of six shared points goes, or one of two views does not see it any more") {
    CHECK(part_of("shared-focal: P/P/P + 2*a/P/Pa + 5*P/-/P") == "P/P/P + 2*a/P/Pa + 4*P/-/P");
    CHECK(part_of("shared-focal: P/P/P + 2*P/a/Pa + 5*-/P/P") == "P/P/P + 2*a/P/Pa + 4*P/-/P");
    // Lines through the point go, too.
    CHECK(part_of("shared-focal: 5*a/P/Pa + -/Pa/Pa + P/-/P") == "5*a/P/Pa + P/-/P");
    CHECK(part_of("shared-focal: 6*a/P/Pa") == "5*a/P/Pa + a/P/a");
    CHECK(part_of("shared-focal: 5*a/P/Pa + a/Pa/P") == "4*a/P/Pa + a/Pa/P + a/P/a");
}

TEST_CASE("the theorem says nothing of other problems") {
    for (const char* text : {"shared-focal: 2*a/Pa/Pa + a/P/Pa + 2*-/P/P + 2*P/-/P", // five
                             "shared-focal: 7*-/P/P + P/-/P + P/P/- + 3*a/P/a",      // seven
                             "upright-shared-focal: 3*P/P/P + 3*-/P/P",              // another kind
                             "focal: 3*P/P/P + 3*-/P/P", "3*P/P/P + 3*-/P/P",        // others
                             "shared-focal: 2*PL/PL/PL + P/P/P + 3*-/P/P", // a line joins two
                             "shared-focal: 6*P/P", "shared-focal: 3*P/P/P/- + 3*-/P/P/P"}) {
        CAPTURE(text);
        CHECK(part_of(text) == "none");
    }
}

TEST_CASE(
    "the degrees of three views with a common focal length on file are those of the theorem") {
    exactly::Degrees degrees;
    int count = 0;
    for (const OnFileInPart& row : degrees_in_part_on_file("shared-focal")) {
        if (row.source != "by Theorem W" || row.degree == "0") continue; // 0: not minimal
        CAPTURE(row.problem);
        CHECK(std::to_string(degree_by_theorem(degrees, row.problem)) == row.degree);
        ++count;
    }
    CHECK(count == 941);
}
