// Lower and upper bounds together: which classes have an exact degree, which contradict themselves.
#include "checker/conclusion/registrations.h"
#include "checker/degrees/constraint_class.h"
#include "tests/checker/registration/committed.h"
#include "tests/support/degree_claims.h"

using namespace checker;
using namespace registrations;

namespace {
const std::string point_and_line = "2*P/P/P + a/a/a + 3*-/P/P"; // a PL0P of degree 80

std::vector<bool> only(std::size_t number) {
    std::vector<bool> minimal(all_classes().representatives.size());
    minimal[number] = true;
    return minimal;
}

/// The type of the registration of an extension.
Registration type_of(std::size_t number) {
    return bound_by_registration(all_classes().representatives[number], committed())->type;
}
} // namespace

TEST_CASE("theorems are applied to classes that are proved minimal, and to no others") {
    const std::size_t chicago = class_of("2*Pa/Pa/Pa + P/P/P");
    const Signature key = constraint_class(all_classes().representatives[chicago]);
    const std::vector<LowerBound> lower{{chicago, 312}};
    const std::vector<bool> none(all_classes().representatives.size());
    DegreeTable nothing = bounds_by_files(all_classes(), none, lower, {});
    add_theorems(nothing, all_classes(), none, {.all = true});
    REQUIRE(nothing.size() == 1);
    CHECK(nothing.at(key).at_least == 312);
    CHECK_FALSE(nothing.at(key).at_most.has_value());
    DegreeTable one = bounds_by_files(all_classes(), only(chicago), lower, {});
    add_theorems(one, all_classes(), only(chicago), {});
    REQUIRE(one.size() == 1);
    CHECK(one.at(key).exact());
    CHECK(one.at(key).theorem->solutions == 312);
}

TEST_CASE("a lower bound speaks for the constraint class, whichever class of it has the record") {
    std::size_t others = 0;
    for (std::size_t n = 0; n < all_classes().representatives.size() && others < 20; ++n) {
        const Signature& other = all_classes().representatives[n];
        if (constraint_class(other) == other) continue;
        const DegreeTable table = bounds_by_files(all_classes(), {}, {{n, 8}}, {});
        REQUIRE(table.size() == 1);
        CHECK(table.contains(constraint_class(other)));
        ++others;
    }
    CHECK(others == 20);
}

TEST_CASE("of several files the largest lower and the smallest upper bounds count") {
    const std::size_t number = class_of(point_and_line);
    const Signature key = constraint_class(all_classes().representatives[number]);
    for (const auto& lower : {std::vector<LowerBound>{{number, 60}, {number, 50}},
                              std::vector<LowerBound>{{number, 50}, {number, 60}}})
        CHECK(table_of({}, lower).at(key).at_least == 60);
    const auto at_most = [&](std::vector<std::size_t> registrations) {
        std::vector<ReplayedFile> files{registration_file(relative_pose, 20)};
        for (const std::size_t bound : registrations)
            files.push_back(registration_file(type_of(number), bound));
        const auto bounds =
            registration_bounds(find(all_classes(), files), all_classes(), only(number));
        return table_of(bounds).at(key).at_most->solutions;
    };
    CHECK(at_most({5}) == 100);
    CHECK(at_most({5, 4, 6}) == 80);
}

TEST_CASE("models agree with the theorem for all 3,615 terminal extensions of five points") {
    std::vector<ReplayedFile> files = committed_files();
    files.push_back(whole_classification());
    const Report report = summarize(all_classes(), files);
    CHECK(report.status == 0);
    std::size_t terminal = 0;
    for (const ExactDegree& exact : report.exact) {
        const Signature& signature = all_classes().representatives[exact.number];
        const auto product = bound_by_registration(signature, committed());
        if (product) CHECK(product->bound == exact.degree);
        if (product) terminal += all_classes().represents_swap_class(exact.number);
    }
    CHECK(terminal == 3615);
}

TEST_CASE("models that allow too few or enough solutions") {
    const std::size_t number = class_of(point_and_line);
    const auto refused = [&](std::size_t registrations, std::size_t counted) {
        const Report report =
            summarize(all_classes(),
                      {problem_of_class(number), registration_file(type_of(number), registrations),
                       degree_file({{number, counted}}), registration_file(relative_pose, 20)});
        CHECK(report.findings.objections[1].empty() == report.findings.objections[3].empty());
        CHECK(report.findings.objections[0].empty());
        CHECK((report.status == 0 || report.exact.empty()));
        return std::pair(!report.findings.objections[1].empty(),
                         !report.findings.objections[2].empty());
    };
    CHECK(refused(4, 80) == std::pair(false, false));
    CHECK(refused(5, 80) == std::pair(false, false)); // a weak bound is a bound
    CHECK(refused(4, 81) == std::pair(false, true));
    CHECK(refused(3, 60) == std::pair(true, false));
    CHECK(refused(3, 80) == std::pair(true, true));
}

TEST_CASE("without a proof that the class is minimal, no bound contradicts another") {
    const std::size_t number = class_of(point_and_line);
    CHECK(summarize(all_classes(),
                    {registration_file(relative_pose, 20), registration_file(type_of(number), 3),
                     degree_file({{number, 1000}})})
              .status == 0);
}
