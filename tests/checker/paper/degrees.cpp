// What is certified of degrees, what evidence says and what the paper claims, side by side.
#include "checker/counts/families.h"
#include "checker/degrees/constraint_class.h"
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

/// How many solutions a minimal class has at most, by theorem; very many if none says.
std::size_t most_solutions(std::size_t number) {
    static const DegreeTable table = [] {
        std::vector<bool> minimal;
        for (std::size_t n = 0; n < all_classes().representatives.size(); ++n)
            minimal.push_back(is_minimal_class(n));
        return combine(all_classes(), minimal, {}, {});
    }();
    const auto found = table.find(constraint_class(all_classes().representatives[number]));
    return found == table.end() ? SIZE_MAX : found->second.at_most->solutions;
}

/// The same bound for every minimal class, or the largest that a theorem allows.
std::vector<LowerBound> everywhere(std::size_t solutions, bool complete) {
    std::vector<LowerBound> bounds;
    for (std::size_t n = 0; n < all_classes().representatives.size(); ++n)
        if (is_minimal_class(n))
            bounds.push_back({n, std::min(solutions, most_solutions(n)), complete});
    return bounds;
}

/// The first minimal class with a feature, of whose degree no theorem speaks.
std::size_t unbounded_class_with(std::string_view feature) {
    std::size_t n = 0;
    const auto fits = [&] {
        return all_classes().representatives[n][index_of(feature)] > 0 && is_minimal_class(n) &&
               most_solutions(n) == SIZE_MAX;
    };
    while (!fits())
        ++n;
    return n;
}

/// How many terminal problems have less solutions by theorem.
std::size_t terminal_below(std::size_t solutions) {
    std::size_t count = 0;
    for (std::size_t n = 0; n < all_classes().representatives.size(); ++n)
        if (is_minimal_class(n) && all_classes().represents_swap_class(n))
            count += most_solutions(n) < solutions;
    return count;
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

TEST_CASE("without degree files nothing is said of degrees") {
    const Report none = report_on({});
    CHECK(none.degrees.empty());
    CHECK_FALSE(contains(detailed(none), "camera-degrees"));
}

TEST_CASE("a degree speaks for its constraint class; certified, evidence and claimed are apart") {
    // One record on a class with P/a/a, and what it says of the problems with Pab/b/a instead.
    const std::size_t point = unbounded_class_with("P/a/a");
    REQUIRE(is_minimal_class(point));
    const Report report = report_on({{point, 160, true}, {chicago, 312, false}});
    const paper::DegreeClaim exactly = claim_on(report, "terminal, degree 160");
    CHECK(exactly.claimed == "547");
    CHECK(exactly.verdict.starts_with("open: "));
    const ClassNumbers equivalent = terminal_problems_like(point);
    CHECK(exactly.known == say(equivalent.size()));
    CHECK(exactly.at_least == say(equivalent.size() + 1)); // and Chicago, which is alone
    CHECK(equivalent.size() > 1);
    CHECK(claim_on(report, "terminal, degree at least 300").at_least == "1");
    CHECK(claim_on(report, "terminal, degree at least 300").claimed == "73816");
    CHECK(claim_on(report, "terminal, degree at least 300").known == "-");
    CHECK(claim_on(report, "3002_1, class 2394").at_least == "312");
    CHECK(claim_on(report, "3010_0, class 6722").verdict == "no claim in the paper");
    CHECK(claim_on(report, "PL0P, class 6722").verdict == "not covered by these files");

    CHECK(contains(detailed(report),
                   "- class 2394: certified to have at least 312 solutions; evidence "
                   "that there are no more: none\n"));
    CHECK(contains(json(report), "\"certified_at_least\": 312, \"evidence_complete\": false"));
}

TEST_CASE("the largest certified bound of a constraint class counts") {
    const std::size_t four_lines = class_of("P/P/P + 4*a/a/a"); // no bound by theorem
    const auto known = [&](const std::vector<LowerBound>& bounds) {
        return claim_on(report_on(bounds), "1040_0");
    };
    const auto larger = known({{four_lines, 200, true}, {four_lines, 216, false}});
    CHECK(larger.at_least == "216");
    CHECK(larger.known == "-"); // the evidence for 200 is refuted
    CHECK(known({{four_lines, 216, true}, {four_lines, 216, false}}).known == "216");
}

TEST_CASE("degrees of classes that are not certified to be minimal do not count") {
    const Report report = summarize(all_classes(), {degree_file({{chicago, 312, true}})});
    CHECK(report.degrees.empty());
    CHECK(contains(detailed(report), "no degree: upper bounds are for classes certified minimal"));
}

TEST_CASE("counts by degree that differ from the paper's, certified or by evidence") {
    std::vector<LowerBound> bounds = everywhere(500, false);
    const std::size_t below_300 = terminal_below(300), below_160 = terminal_below(160);
    REQUIRE(below_300 > below_160);
    Report report = report_on(bounds);
    CHECK(claim_on(report, "terminal, degree at least 300").at_least == say(74575 - below_300));
    CHECK(claim_on(report, "terminal, degree at least 300").verdict == "differs, certified");
    CHECK(claim_on(report, "terminal, degree at least 300").known == "-");
    CHECK(claim_on(report, "terminal, degree 160").verdict == "differs, certified");
    CHECK(claim_on(report, "terminal, degree below 300").verdict == "differs, certified");
    CHECK(report.status == 0);
    CHECK(contains(errata(report),
                   say("terminal, degree 160\n  Paper: 547; certified at least: ",
                       74575 - below_160, "; certified exactly: 0; known exactly: 0; differs")));

    for (LowerBound& bound : bounds)
        if (bound.number == 6722) bound = {6722, 176, true};
    report = report_on(bounds);
    CHECK(claim_on(report, "terminal, degree 176").claimed == "0");
    CHECK(claim_on(report, "terminal, degree 176").known == "1");
    CHECK(claim_on(report, "terminal, degree 176").verdict == "differs, by evidence");
    CHECK(contains(errata(report), "Witness: class 6722: 3*P/P/P + a/a/a"));
    // Few problems have less than 300 solutions, since the others are certified to have more.
    CHECK(claim_on(report, "terminal, degree below 300").verdict == "differs, certified");
}

TEST_CASE("evidence alone certifies neither that problems are fewer nor that they are more") {
    const auto report = [](std::size_t others) { // 759 with less than 300, as claimed
        std::vector<LowerBound> bounds = everywhere(others, true);
        std::size_t terminal = 0;
        for (LowerBound& bound : bounds) {
            terminal += all_classes().represents_swap_class(bound.number);
            if (terminal <= 759) bound.solutions = std::min<std::size_t>(bound.solutions, 80);
        }
        return report_on(bounds);
    };
    for (const std::size_t others : {160U, 300U}) {
        const Report r = report(others);
        const paper::DegreeClaim below = claim_on(r, "terminal, degree below 300"),
                                 rest = claim_on(r, "terminal, degree at least 300");
        const std::size_t least = std::stoul(rest.at_least), less = std::stoul(below.known);
        CHECK(least + less == 74575);
        CHECK(below.verdict == (less > 759   ? "differs, by evidence"
                                : less < 759 ? "differs, certified"
                                             : "agrees, by evidence"));
        CHECK(rest.verdict == (least > 73816   ? "differs, certified"
                               : least < 73816 ? "differs, by evidence"
                                               : "agrees, by evidence"));
    }
}

TEST_CASE("the problems without pins, and the four that register a camera") {
    // Five points have 20 relative poses; nothing is said of what is left then.
    const ReplayedFile poses{
        .name = "poses", .content = BoundsFile{.templates = 1, .bounds = {{relative_pose, 20}}}};
    const auto report = [&](std::size_t solutions, bool complete) {
        return summarize(all_classes(), {whole_classification(), poses,
                                         degree_file(everywhere(solutions, complete))});
    };
    const auto verdicts = [](const Report& r, const std::string& start) {
        std::map<std::string, std::size_t> counts; // of verdicts
        for (const paper::DegreeClaim& c : r.degrees)
            if (c.claim.starts_with(start)) ++counts[c.verdict];
        return counts;
    };
    using Counts = std::map<std::string, std::size_t>;
    const Report r = report(160, true);
    CHECK(verdicts(r, "- registration of its third camera") ==
          Counts{{"agrees, by evidence", 3}, {"differs, certified", 1}});
    const auto claimed_160 = std::ranges::count(paper::pl0ps, 160U, &paper::ClaimedDegree::degree);
    CHECK(claimed_160 == 3);
    CHECK(verdicts(r, "PL0P, ") == Counts{{"agrees, by evidence", 3},
                                          {"differs, certified", 1}, // 80 are claimed
                                          {"differs, by evidence", 47}});
    CHECK(claim_on(r, "terminal, degree at least 300").verdict == "differs, by evidence");
    CHECK(claim_on(r, "terminal, degree below 300").verdict == "differs, by evidence");

    const Report open = report(100, false);
    CHECK(verdicts(open, "- registration of its third camera") ==
          Counts{{"open", 3}, {"differs, certified", 1}});
    CHECK(verdicts(open, "PL0P, ") == Counts{{"open", 50}, {"differs, certified", 1}});

    const Report unknown =
        summarize(all_classes(), {whole_classification(), degree_file(everywhere(160, true))});
    CHECK(verdicts(unknown, "- registration of its third camera") ==
          Counts{{"not covered by these files", 4}});
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
