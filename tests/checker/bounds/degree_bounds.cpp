// Lower and upper bounds together: what is exact, what contradicts itself, and of which classes.
#include "checker/bounds/registration.h"
#include "tests/checker/bounds/templates.h"
#include "tests/support/degree_claims.h"

#include <map>
#include <tuple>

using namespace checker;
using namespace templates;

namespace {
constexpr std::string_view point_and_line = "2*P/P/P + a/a/a + 3*-/P/P"; // at most 80 solutions

const ReplayedFile& committed_file() {
    static const ReplayedFile file{.name = "bounds", .content = committed()};
    return file;
}

/// Another class whose upper bound is that of the same type of registration.
std::size_t other_class_like(std::size_t number) {
    const auto type = [](std::size_t n) {
        return bound_by_registration(all_classes().representatives[n], committed().bounds);
    };
    const auto wanted = type(number);
    REQUIRE(wanted.has_value());
    for (std::size_t n = number + 1; n < all_classes().representatives.size(); ++n) {
        const auto found = is_minimal_class(n) ? type(n) : std::nullopt;
        if (found && found->type == wanted->type) return n;
    }
    FAIL("no other class");
    return 0;
}

/// By degree, how many classes have it exactly when all are minimal and this is a lower bound.
using Classes = std::map<std::size_t, std::size_t>;
Classes exact_with(std::string_view problem, std::size_t solutions) {
    const Report report =
        summarize(all_classes(), {whole_classification(), committed_file(),
                                  degree_file({{class_of(problem), solutions, false}})});
    Classes found;
    for (const ExactDegree& exact : report.exact)
        ++found[exact.degree];
    return found;
}
} // namespace

TEST_CASE("a degree is certified exact where the bounds meet, and not a solution earlier") {
    const auto claims_at = [](std::size_t solutions) {
        const Report report =
            summarize(all_classes(), {whole_classification(), committed_file(),
                                      degree_file({{class_of(point_and_line), solutions, false}})});
        return std::tuple(claim_on(report, say("PL0P, class ", class_of(point_and_line))),
                          report.status, claim_on(report, "terminal, of any degree").exact);
    };
    const auto [exact, status, all_exact] = claims_at(80);
    CHECK(status == 0);
    CHECK(exact.at_least == "80");
    CHECK(exact.exact == "80");
    CHECK(exact.by_theorem == "-");
    CHECK(exact.claimed == "80");
    CHECK(exact.verdict == "agrees, certified");
    // ... and with it the degree of all classes with the same type of registration.
    CHECK(all_exact == "8");
    const auto [less, still, none_exact] = claims_at(79);
    CHECK(still == 0);
    CHECK(less.at_least == "79");
    CHECK(less.exact == "-");
    CHECK(none_exact == "0");
    CHECK(less.known == "-");
}

TEST_CASE("of the bounds by theorem, one that is attained says nothing of others, but 64") {
    CHECK(exact_with("2*Pa/Pa/Pa + P/P/P", 312) == Classes{{312, 1}});
    CHECK(exact_with("Pabcd/Pabcd/Pabcd + Pa/Pa/Pa", 240) == Classes{{240, 1}});
    CHECK(exact_with("Pabcde/Pabcde/Pabcde + P/P/P", 64) == Classes{{64, 13}});
    CHECK(exact_with("Pabcdef/Pabcdef/Pabcdef + 2*P/a/a", 64) == Classes{{64, 13}});
    CHECK(exact_with("Pabcde/Pabcde/Pabcde + P/P/P", 63).empty());
}

TEST_CASE("theorems apply to classes that are proved minimal, and to no others") {
    const std::size_t chicago = class_of("2*Pa/Pa/Pa + P/P/P");
    const Signature key = constraint_class(all_classes().representatives[chicago]);
    std::vector<bool> minimal(all_classes().representatives.size());
    const std::vector<LowerBound> lower{{chicago, 312, false}};
    const DegreeTable nothing = combine(all_classes(), minimal, lower, committed().bounds);
    REQUIRE(nothing.size() == 1);
    CHECK(nothing.at(key).at_least == 312);
    CHECK_FALSE(nothing.at(key).at_most.has_value());
    minimal[chicago] = true;
    const DegreeTable one = combine(all_classes(), minimal, lower, committed().bounds);
    REQUIRE(one.size() == 1);
    REQUIRE(one.at(key).at_most.has_value());
    CHECK(one.at(key).at_most->by_theorem());
    CHECK(one.at(key).exact());
    // ... without a file of upper bounds, too.
    CHECK(combine(all_classes(), minimal, lower, {}).at(key).exact());
}

TEST_CASE("a lower bound speaks for the constraint class, whichever class of it has the record") {
    const Signature& signature = all_classes().representatives[class_of("3*P/P/P + a/P/Pa")];
    const Signature key = constraint_class(signature);
    std::size_t others = 0;
    for (std::size_t n = 0; n < all_classes().representatives.size() && others < 20; ++n) {
        const Signature& other = all_classes().representatives[n];
        if (constraint_class(other) == other) continue;
        const DegreeTable table = combine(all_classes(), {}, {{n, 8, false}}, {});
        REQUIRE(table.size() == 1);
        CHECK(table.contains(constraint_class(other)));
        ++others;
    }
    CHECK(others == 20);
    CHECK(combine(all_classes(), {}, {{class_of("3*P/P/P + a/P/Pa"), 8, false}}, {}).contains(key));
}

TEST_CASE("a theorem applies to whichever class of its constraint class is proved minimal") {
    std::size_t others = 0;
    std::vector<bool> minimal(all_classes().representatives.size());
    const DegreeTable all = table_of({});
    for (std::size_t n = 0; n < minimal.size(); ++n) {
        const Signature& signature = all_classes().representatives[n];
        const Signature key = constraint_class(signature);
        if (key == signature || !is_minimal_class(n) || !all.contains(key)) continue;
        if (++others > 3) break;
        minimal[n] = true;
        const DegreeTable one = combine(all_classes(), minimal, {}, {});
        minimal[n] = false;
        REQUIRE(one.size() == 1);
        CHECK(one.at(key).at_most->solutions == all.at(key).at_most->solutions);
    }
    CHECK(others > 0);
}

TEST_CASE("of several files the largest lower and the smallest upper bounds count") {
    const std::size_t number = class_of(point_and_line);
    const Signature key = constraint_class(all_classes().representatives[number]);
    const auto known = [&](const std::vector<LowerBound>& lower) {
        return table_of(committed().bounds, lower).at(key);
    };
    for (const bool first : {false, true}) {
        const LowerBound large{number, 60, first}, small{number, 50, !first};
        for (const auto& lower : {std::vector{large, small}, std::vector{small, large}}) {
            CHECK(known(lower).at_least == 60);
            CHECK(known(lower).complete == first); // the evidence for 50 is refuted
        }
    }
    const LowerBound open{number, 60, false}, complete{number, 60, true};
    CHECK(known({open, complete}).complete);
    CHECK(known({complete, open}).complete);

    const auto type =
        bound_by_registration(all_classes().representatives[number], committed().bounds)->type;
    const auto exact_with_file = [&](std::size_t bound) {
        const ReplayedFile other{.name = "other",
                                 .content = BoundsFile{.templates = 1, .bounds = {{type, bound}}}};
        std::vector<ReplayedFile> files{whole_classification(), committed_file(), other,
                                        degree_file({{number, 60, false}})};
        const Report report = summarize(all_classes(), files);
        std::swap(files[1], files[2]);
        CHECK(summarize(all_classes(), files).exact.size() == report.exact.size());
        return report.exact.size();
    };
    CHECK(exact_with_file(3) > 0); // 20 times 3
    CHECK(exact_with_file(5) == 0);
}

TEST_CASE("a file without templates changes nothing") {
    const ReplayedFile empty{.name = "empty", .content = BoundsFile{}};
    const ReplayedFile degrees = degree_file({{class_of(point_and_line), 80, false}});
    const Report report = summarize(all_classes(), {whole_classification(), empty, degrees});
    CHECK(report.upper_bounds.empty());
    CHECK(report.exact.empty());
    CHECK(report.status == 1); // it proves nothing
    const Report alone = summarize(all_classes(), {whole_classification(), empty});
    CHECK(alone.upper_bounds.empty());
    CHECK(alone.degrees.empty());
}

TEST_CASE("terminal problems are counted by upper bound, apart for templates and theorems") {
    const Report report = summarize(all_classes(), {whole_classification(), committed_file()});
    std::map<std::size_t, UpperBoundCount> counts;
    std::size_t by_templates = 0, by_theorem = 0;
    for (const UpperBoundCount& count : report.upper_bounds) {
        counts[count.solutions] = count;
        by_templates += count.by_templates;
        by_theorem += count.by_theorem;
    }
    CHECK(by_templates == 3615);
    CHECK(by_theorem == 70960); // all others
    CHECK(counts.at(64).by_theorem == 13);
    CHECK(counts.at(64).by_templates == 0);
    CHECK(counts.at(272).by_theorem == 10);
    CHECK(counts.at(400).by_templates == 13); // those with groups of five rays
    CHECK(counts.at(1280).by_templates == 342);
    CHECK(contains(detailed(report),
                   "certified: 13 terminal problems have at most 64 solutions, 13 of "
                   "them by theorem\n"));
}

TEST_CASE("where certificates contradict each other, nothing follows") {
    const std::size_t one = class_of(point_and_line), other = other_class_like(one);
    const auto consistent = [&](const std::vector<LowerBound>& lower) {
        const Report report = summarize(
            all_classes(), {whole_classification(), committed_file(), degree_file(lower)});
        CHECK((report.status == 0 || report.exact.empty()));
        CHECK(report.degrees.empty() == (report.status == 1));
        CHECK(report.upper_bounds.empty() == (report.status == 1));
        const bool says = contains(complaints(report), "bounds contradict each other: ");
        CHECK(says == (report.status == 1));
        CHECK(report.findings.comparisons[0].objections.empty());
        for (const std::size_t file : {1U, 2U})
            CHECK(report.findings.comparisons[file].objections.empty() == (report.status == 0));
        return report.status == 0;
    };
    CHECK(consistent({{one, 80, false}}));
    CHECK_FALSE(consistent({{one, 81, false}}));
    // One class attains the bound of the type, and another is said to have more solutions.
    CHECK_FALSE(consistent({{one, 80, false}, {other, 81, false}}));
    // ... or more than by theorem.
    CHECK(consistent({{class_of("2*Pa/Pa/Pa + P/P/P"), 312, false}}));
    CHECK_FALSE(consistent({{class_of("2*Pa/Pa/Pa + P/P/P"), 313, false}}));
}

TEST_CASE("one class attains the bound of its type, and another is bounded by less") {
    const std::size_t one = class_of(point_and_line), other = other_class_like(one);
    const Signature other_key = constraint_class(all_classes().representatives[other]);
    const auto contradicts = [&](std::size_t solutions) {
        DegreeTable table = table_of(committed().bounds, {{one, solutions, false}});
        table.at(other_key).at_most->solutions = 79;
        return contradiction(table).has_value();
    };
    CHECK_FALSE(contradicts(79));
    CHECK(contradicts(80));
}
