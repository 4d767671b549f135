// What is certified of degrees and what the paper claims, side by side.
#include "checker/counts/families.h"
#include "checker/paper/numbers.h"
#include "tests/checker/degrees/instances.h"
#include "tests/support/degree_claims.h"

#include <map>
#include <set>

using namespace checker;
using instances::chicago;

namespace {
using ClassNumbers = std::set<std::size_t>;

/// A report on all classes, each with the verdict that its obstruction gives, and on a file of
/// these bounds.
Report report_on(const std::vector<LowerBound>& bounds) {
    return summarize(all_classes(), {whole_classification(), degree_file(bounds)});
}

std::size_t number_in(const std::string& cell) {
    return cell == "-" ? 0 : std::stoul(cell);
}

/// The other feature of a pair that is swapped (12 to 17) or exchanged (21 to 26).
std::size_t partner(std::size_t feature) {
    if (feature >= 12 && feature < 18) return feature ^ 1;
    if (feature >= 21 && feature < 24) return feature + 3;
    if (feature >= 24) return feature - 3;
    return feature;
}

/// Signatures that one relabeling, swap or exchange leads to.
std::vector<Signature> next_to(const Signature& signature) {
    std::vector<Signature> next;
    for (const FeatureMap& map : relabelings)
        next.push_back(permuted(signature, map));
    for (std::size_t i = 0; i < feature_count; ++i) {
        if (signature[i] == 0 || partner(i) == i) continue;
        Signature image = signature;
        --image[i];
        ++image[partner(i)];
        next.push_back(image);
    }
    return next;
}

/// The terminal problems of a constraint class: by swaps, exchanges and relabelings, one after the
/// other.
ClassNumbers terminal_problems_like(std::size_t number) {
    ClassNumbers equivalent;
    std::vector<Signature> todo{all_classes().representatives[number]};
    std::set<Signature> seen(todo.begin(), todo.end());
    while (!todo.empty()) {
        const Signature s = todo.back();
        todo.pop_back();
        const std::size_t n = number_of(all_classes(), largest_relabeled(s));
        if (all_classes().represents_swap_class(n)) equivalent.insert(n);
        for (const Signature& t : next_to(s))
            if (seen.insert(t).second) todo.push_back(t);
    }
    return equivalent;
}
} // namespace

TEST_CASE("where no degree is asked for nothing is said of degrees") {
    const Report none = summarize(all_classes(), {whole_classification()});
    CHECK(none.degrees.empty());
    CHECK_FALSE(contains(detailed(none), "camera-degrees"));
}

TEST_CASE("a degree speaks for its constraint class") {
    // One record on a class with P/a/a, and what follows for the problems with Pab/b/a instead.
    const std::size_t point = class_of("4*-/P/P + P/-/P + P/a/a + 5*a/P/a");
    const Report report = report_on({{point, 8}, {chicago, 312}});
    const ClassNumbers equivalent = terminal_problems_like(point);
    CHECK(equivalent.size() > 1);
    CHECK(claim_on(report, "terminal, of any degree").exact == say(equivalent.size() + 1));
    CHECK(claim_on(report, "terminal, degree at least 300").at_least ==
          say(equivalent.size() + 1)); // and Chicago, which is alone
    CHECK(claim_on(report, "terminal, degree at least 300").claimed == "73816");
    CHECK(claim_on(report, "terminal, degree 160").verdict == paper::not_covered);
    CHECK(claim_on(report, "3002_1, class 2394").exact == "312");
    CHECK(claim_on(report, "3010_0, class 6722").verdict == "no claim in the paper");
    CHECK(claim_on(report, "PL0P, class 6722").verdict == paper::not_covered);
    CHECK(contains(detailed(report), "- class 2394: certified to have at least 312 solutions\n"));
}

TEST_CASE("degrees of classes that are not certified to be minimal do not count") {
    const Report report = summarize(all_classes(), {degree_file({{chicago, 312}})});
    CHECK(report.degrees.empty());
    CHECK(contains(detailed(report), "no degree: theorems are for classes certified minimal"));
}

TEST_CASE("all 74,575 terminal problems have an exact degree") {
    const Report& report = whole_report();
    CHECK(report.status == 0);
    CHECK(report.exact.size() == 140616);
    const paper::DegreeClaim any = claim_on(report, "terminal, of any degree");
    CHECK(any.exact == "74575");
    CHECK(any.at_least == "74575");
    CHECK(any.claimed == "74575");
    std::size_t below = 0;
    for (const paper::DegreeClaim& claim : report.degrees) {
        if (!claim.claim.starts_with("- registration")) // which need the number of relative poses
            CHECK(claim.verdict != paper::not_covered);
        const bool one = claim.claim.starts_with("terminal, degree ") &&
                         !claim.claim.starts_with("terminal, degree below") &&
                         !claim.claim.starts_with("terminal, degree at");
        if (one) below += number_in(claim.exact);
        const auto agrees = number_in(claim.exact) == number_in(claim.claimed);
        if (one) CHECK(claim.verdict == (agrees ? "agrees" : "differs"));
        if (one && !agrees) CHECK(contains(errata(report), claim.claim));
    }
    CHECK(claim_on(report, "terminal, degree below 300").exact == say(below));
    CHECK(claim_on(report, "terminal, degree at least 300").at_least == say(74575 - below));
}

TEST_CASE("the four problems that register a camera need the number of relative poses") {
    const auto verdicts = [](const Report& report) {
        std::map<std::string, std::size_t> counts;
        for (const paper::DegreeClaim& c : report.degrees)
            if (c.claim.starts_with("- registration of its third camera")) ++counts[c.verdict];
        return counts;
    };
    using Counts = std::map<std::string, std::size_t>;
    CHECK(verdicts(whole_report()) == Counts{{std::string(paper::not_covered), 4}});
    std::vector<LowerBound> bounds;
    for (const paper::ClaimedDegree& claim : paper::registrations)
        bounds.push_back({class_of(claim.problem), 1});
    const ReplayedFile poses = registration_file(relative_pose, 20);
    const Report report =
        summarize(all_classes(), {whole_classification(), poses, degree_file(bounds)});
    CHECK(verdicts(report) == Counts{{"agrees", 4}});
}

TEST_CASE("the paper's table of PL0Ps lists each minimal problem without pins once") {
    std::set<std::string_view> listed, expected;
    for (const paper::ClaimedDegree& claim : paper::pl0ps)
        CHECK(listed.insert(claim.problem).second);
    std::vector<std::string> names;
    for (std::size_t n = 0; n < all_classes().representatives.size(); ++n)
        if (is_minimal_class(n) && is_pl0p(all_classes().representatives[n]))
            names.push_back(notation(all_classes().representatives[n]));
    expected.insert(names.begin(), names.end());
    CHECK(listed == expected);
    for (const paper::ClaimedDegree& claim : paper::registrations)
        CHECK(listed.contains(claim.problem));
}
