// What a user expects is verified if the files prove just that, and not otherwise.
#include "checker/conclusion/label_class.h"
#include "checker/family/isomorphism.h"
#include "checker/problem/notation.h"
#include "checker/registration/registration.h"
#include "prover/minimal/problem_file.h"
#include "prover/problem/notation.h"
#include "tests/support/random_problems.h"
#include "tests/support/results.h"
#include "tests/support/text.h"

using namespace checker;

namespace {

const std::string chicago = "2*Pa/Pa/Pa + P/P/P";

ExpectedProblem expect(const std::string& problem, const std::string& verdict,
                       std::optional<ExpectedDegree> degree = {}) {
    return {problem, parse_problem(problem), false, verdict, degree};
}

constexpr ExpectedDegree exact_degree(std::size_t solutions) {
    return {.exactly = true, .solutions = solutions};
}

constexpr ExpectedDegree at_least(std::size_t solutions) {
    return {.exactly = false, .solutions = solutions};
}

/// The certificate of a problem, replayed.
ReplayedFile certificate_of(const std::string& problem) {
    const auto certificate = plprove::certify_problem(plprove::parse_features(problem));
    return replay(all_classes(), "problem.plc", plprove::write(certificate));
}

Report report_on(const std::vector<ReplayedFile>& files, const Expectation& expectation) {
    return summarize(all_classes(), files, expectation);
}

/// Whether files prove what is expected. The status has to say the same.
bool verified(const std::vector<ReplayedFile>& files, const Expectation& expectation) {
    const Report report = report_on(files, expectation);
    CHECK(report.findings.status == 0);
    CHECK(report.status == (report.judgement.verified ? 0 : 1));
    CHECK(conclusion(report).starts_with(report.status == 0 ? "VERIFIED: " : "NOT VERIFIED: "));
    return report.judgement.verified;
}

/// What is the same for the same problem in three views.
Invariant meaning(const std::string& text) {
    return invariant(parse_problem(text, section_1));
}

/// A problem with its views in another order.
plprove::Features with_views_rotated(plprove::Features problem) {
    for (plprove::Feature& feature : problem)
        std::rotate(feature.sights.begin(), feature.sights.begin() + 1, feature.sights.end());
    return problem;
}

} // namespace

TEST_CASE("a problem is the same in another order, with other names of pins, and otherwise not") {
    plprove::RandomProblems random(7);
    std::size_t changed = 0; // by an order of the views
    for (int i = 0; i < 300; ++i) {
        const plprove::Features problem = random.around_a_class(2);
        const Invariant own = meaning(plprove::notation(problem));
        CAPTURE(plprove::notation(problem));
        CHECK(meaning(plprove::notation(random.disguised(problem))) == own);
        plprove::Features shorter = problem;
        shorter.pop_back();
        CHECK_FALSE(meaning(plprove::notation(shorter)) == own);
        changed += meaning(plprove::notation(with_views_rotated(problem))) != own;
    }
    CHECK(changed > 200);
    CHECK(meaning("P/P/P(a)") != meaning("P/P/P"));
    CHECK(meaning("a/a/a(P)") != meaning("a/a/a"));
    CHECK(meaning("a/b/-") != meaning("a/a/-"));
    CHECK(meaning("Pab/b/a") == meaning("Pab/a/b"));
    CHECK(parse_problem("5*P/P").view_count() == 2);
}

TEST_CASE("a problem is the same in both notations, with implied lines or without") {
    plprove::RandomProblems random(8);
    const auto without = [](const std::string& text) {
        return without_implied_lines(parse_problem(text));
    };
    for (int i = 0; i < 200; ++i) {
        const std::string text = plprove::notation(random.around_a_class(2));
        CAPTURE(text);
        CHECK(invariant(without(text)) == meaning(text));
    }
    CHECK(invariant(without("2*PL/PL/PL + P/P/P + a/a/a")) == meaning("3*P/P/P + a/a/a"));
    CHECK(invariant(without("PLa/PLa/- + PL/PL/P + P/P/P")) == meaning("Pa/Pa/- + 2*P/P/P"));
    for (const char* other : {"3*PL/PL/PL + a/a/a", "PL/PL/PL + PL/PL/L + 2*P/P/P"})
        CHECK(without(other).lines.size() == parse_problem(other).lines.size());
}

TEST_CASE("a problem is read with any blanks, and with equal features side by side") {
    const Invariant problem = meaning(chicago);
    CHECK(meaning("P/P/P+2 * Pa/Pa/Pa ") == problem);
    CHECK(meaning("Pa/Pa/Pa + P/P/P + Pa/Pa/Pa") == problem);
    for (const std::string wrong :
         {"", " ", "+", "P/P/P +", "+ P/P/P", "P/P/P ++ P/P/P", "P", "p/p/p", "P/P + P/P/P",
          "0*P/P/P", "P/P/P;P/P/P", "P/P/P a/a/a", "1000*P/P/P + P/P/P", "2394"}) {
        CAPTURE(wrong);
        CHECK_THROWS_AS(parse_problem(wrong, section_1), Malformed);
    }
}

TEST_CASE("a balanced problem of the 27 features belongs to a class as it stands") {
    for (std::size_t n = 0; n < all_classes().representatives.size(); n += 997) {
        const Signature& representative = all_classes().representatives[n];
        for (const FeatureMap& map : relabelings) {
            const Problem problem = parse_problem(notation(permuted(representative, map)));
            CHECK(class_of(all_classes(), problem) == n);
        }
    }
    for (const char* other : {"P/P/P", "5*P/P", "3*P/P/P + P/P/a", "3*P/P/P + a/a/a + P/P/P(a)",
                              "4*P/P/P", "3*P/P/P + a/a/a + a/a/-"})
        CHECK_FALSE(class_of(all_classes(), parse_problem(other)));
}

TEST_CASE("verdicts by a problem file, each for what is expected") {
    const auto verdicts = [](const std::string& problem) {
        std::string found;
        for (const std::string_view verdict : expected_verdicts)
            if (verified({certificate_of(problem)}, expect(problem, std::string(verdict))))
                found += std::string(verdict) + ' ';
        return found;
    };
    CHECK(verdicts(chicago) == "minimal camera-minimal ");
    CHECK(verdicts("3*P/P/P + P/P/a") == "camera-minimal not-minimal ");
    CHECK(verdicts("Pabcdef/Pabcdef/Pabcdef + a/a/a") == "not-minimal obstructed ");
    CHECK(verdicts("3*P/P/P") == "not-minimal under-constrained ");
    CHECK(verdicts("7*P/P/P") == "not-minimal over-constrained ");
    CHECK(verified({certificate_of("3*P/P/P")}, expect("3*P/P/P", "under-constrained 2")));
    CHECK_FALSE(verified({certificate_of("3*P/P/P")}, expect("3*P/P/P", "under-constrained 1")));
}

TEST_CASE("a problem file speaks of its problem, whatever the order and the names") {
    const std::string problem = "2*Pab/b/a + b/Pab/a + 4*P/P/- + P/-/P + 3*-/P/P";
    const std::vector files{certificate_of(problem)};
    CHECK(verified(files,
                   expect("3*-/P/P + P/-/P + Pab/a/b + 4*P/P/- + Pab/b/a + a/Pab/b", "minimal")));
    // With the views in another order it is another problem.
    CHECK_FALSE(
        verified(files, expect("2*a/Pab/b + a/b/Pab + 4*-/P/P + P/P/- + 3*P/-/P", "minimal")));
    CHECK_FALSE(verified(files, expect(chicago, "minimal")));
    const Report other = report_on(files, expect(chicago, "minimal"));
    CHECK(contains(conclusion(other), chicago + " is minimal: no file says whether it is; add"));
}

TEST_CASE("a record of a classification speaks of all problems of its class") {
    const std::vector files{whole_classification()};
    CHECK(verified(files, expect(chicago, "minimal")));
    CHECK(verified(files, expect("P/P/P + 3*a/a/a + 2*P/P/-", "minimal"))); // number 8728
    CHECK(verified(files, expect("Pabcdef/Pabcdef/Pabcdef + a/a/a", "obstructed")));
    CHECK_FALSE(verified(files, expect("Pabcdef/Pabcdef/Pabcdef + a/a/a", "minimal")));
    // What reduces to a class is not in it: the files have to prove the reduction.
    CHECK_FALSE(verified(files, expect("3*P/P/P + P/P/a", "camera-minimal")));
    CHECK_FALSE(verified(files, expect(chicago + " + a/a/-", "camera-minimal")));
}

TEST_CASE("degrees, exact by theorem for what is proved minimal, and at least by records") {
    const ReplayedFile all = whole_classification();
    const ReplayedFile degrees = degree_file({{2394, 311}});
    for (const std::vector<ReplayedFile>& files :
         {std::vector{all}, std::vector{certificate_of(chicago)}, std::vector{all, degrees}}) {
        CHECK(verified(files, expect(chicago, "minimal", exact_degree(312))));
        CHECK(verified(files, expect(chicago, "", at_least(312))));
        for (const std::size_t wrong : {311U, 313U})
            CHECK_FALSE(verified(files, expect(chicago, "minimal", exact_degree(wrong))));
        CHECK_FALSE(verified(files, expect(chicago, "", at_least(313))));
        CHECK_FALSE(verified(files, expect(chicago, "obstructed", exact_degree(312))));
    }
    CHECK(verified({degrees}, expect(chicago, "", at_least(300))));
    CHECK_FALSE(verified({degrees}, expect(chicago, "", at_least(312)))); // not proved minimal
    CHECK_FALSE(verified({degrees}, expect(chicago, "minimal", at_least(311))));
    CHECK_FALSE(verified({degrees}, expect("3*P/P/P + a/a/a", "", at_least(1))));
    // The proof that another class is minimal is none for this one.
    CHECK_FALSE(
        verified({certificate_of("3*P/P/P + a/a/a")}, expect(chicago, "", exact_degree(312))));
    Verdicts others = all_verdicts();
    others[2394].reset();
    CHECK_FALSE(verified({classification_with(others)}, expect(chicago, "", exact_degree(312))));
    const std::string obstructed = "Pabcdef/Pabcdef/Pabcdef + a/a/a";
    CHECK_FALSE(verified({all}, expect(obstructed, "", at_least(1))));
}

TEST_CASE("groups, by fibres and the degree that a theorem says") {
    const CycleType cycle{1, 3, 11, 26, 271}, even{156, 156}, odd{312};
    const auto by_fibres = [](const std::vector<CycleType>& cycle_types) {
        return std::vector{LowerBound{2394, 312, cycle_types}};
    };
    const ReplayedFile all = whole_classification();
    const auto group = [](const std::string& name) {
        ExpectedProblem expected = expect(chicago, "");
        expected.group = name;
        return expected;
    };
    for (const auto& [bounds, contains, symmetric] :
         std::initializer_list<std::tuple<std::vector<LowerBound>, bool, bool>>{
             {by_fibres({even, odd}), false, false},
             {by_fibres({cycle}), false, false},
             {by_fibres({cycle, odd}), true, false},
             {by_fibres({cycle, even}), true, true}}) {
        const std::vector<ReplayedFile> files{all, degree_file(bounds)};
        CHECK(verified(files, group(">=A312")) == contains);
        CHECK(verified(files, group("S312")) == symmetric);
        CHECK_FALSE(verified(files, group("S311")));
        CHECK_FALSE(verified({files[1]}, group(">=A312"))); // not proved minimal
    }
    const Report report = report_on({all, degree_file(by_fibres({cycle, even}))}, group("S312"));
    CHECK(conclusion(report) ==
          "VERIFIED: " + chicago + " has the group S312 (classification.plc, degrees.plc)\n");
    CHECK(report.judgement.why.back() == "its group is S312, by fibres: proofs/fibres.md");
    CHECK(conclusion(report_on({all}, group("S312"))) ==
          "NOT VERIFIED: " + chicago +
              " has the group S312: no theorem and no fibres certify its group; add the file that "
              "plprove group PROBLEM -o FILE writes (classification.plc)\n");
    CHECK(contains(json(report), "\"certified_groups\": [\n  [2394, \"S312\"]]"));
    CHECK(contains(text(report), "312 solutions with the group S312: class 2394"));
}

TEST_CASE("a record that counts more solutions than the theorem refuses its file") {
    const ReplayedFile more = degree_file({{6722, 200}, {2394, 313}});
    const Report report =
        report_on({whole_classification(), more}, expect(chicago, "", exact_degree(312)));
    CHECK(report.status == 1);
    CHECK(complaints(report) ==
          "degrees.plc:0: refused: bounds contradict each other: class 2394 has at least 313 "
          "solutions, and at most 312, by Theorem C of proofs/three_views/4_classes.md\n");
    CHECK(conclusion(report).starts_with("NOT VERIFIED: "));
    CHECK(verified({more}, expect(chicago, "", at_least(313)))); // without a proof of minimality
}

TEST_CASE("the degree of a problem that reduces to a class needs a proof of the reduction") {
    const std::string problem = "P/P/a + 3*P/P/P + a/-/-"; // to class 6723, of degree 272
    const ReplayedFile all = whole_classification();
    CHECK(
        verified({certificate_of(problem)}, expect(problem, "camera-minimal", exact_degree(272))));
    CHECK(verified({certificate_of(problem)}, expect(problem, "", at_least(272))));
    const ReplayedFile degrees = degree_file({{6723, 272}});
    const Report without = report_on({all, degrees}, expect(problem, "", at_least(1)));
    CHECK_FALSE(without.judgement.verified);
    CHECK(contains(conclusion(without), "these files do not say to which class it reduces"));
    // A problem file about another problem with the same reduction does not help.
    CHECK_FALSE(verified({all, degrees, certificate_of("P/P/a + 3*P/P/P")},
                         expect(problem, "", at_least(1))));
}

TEST_CASE("a constraint class shares its degree: swaps, exchanges and other orders of the views") {
    const std::vector files{whole_classification()};
    CHECK(notation(all_classes().representatives[6726]) == "3*P/P/P + -/P/P + P/a/a");
    CHECK(verified(files, expect("3*P/P/P + -/P/P + P/a/a", "minimal", exact_degree(464))));
    CHECK(verified(files, expect("3*P/P/P + -/P/P + Pab/b/a", "minimal", exact_degree(464))));
    CHECK(verified(files, expect("3*P/P/P + P/-/P + a/P/a", "minimal", exact_degree(464))));
}

TEST_CASE(
    "in two views the degree is the number of relative poses, if a class attains the product") {
    const Signature extension = all_classes().representatives[6779]; // of degree 80 = 20 * 4
    const Registration type = registration(extension, 0b110);
    CHECK(shared_points(extension, 0b110) == 5);
    const ReplayedFile all = whole_classification();
    const ReplayedFile poses = registration_file(relative_pose, 20);
    const ReplayedFile four = registration_file(type, 4), five = registration_file(type, 5);
    for (const std::string problem : {"5*P/P", "4*P/P + Pa/P + P/- + a/a"}) {
        const ReplayedFile own = certificate_of(problem);
        CHECK(verified({all, poses, four, own}, expect(problem, "", exact_degree(20))));
        CHECK(verified({all, poses, four, own}, expect(problem, "", at_least(20))));
        CHECK_FALSE(verified({all, poses, four, own}, expect(problem, "", exact_degree(10))));
        CHECK_FALSE(verified({all, poses, five, own}, expect(problem, "", exact_degree(20))));
        CHECK_FALSE(verified({all, poses, five, own}, expect(problem, "", at_least(2))));
        // Theorem A knows the problem of five points, so its minimality counts as one solution.
        const bool known = problem == "5*P/P";
        CHECK(verified({all, poses, five, own}, expect(problem, "", at_least(1))) == known);
        CHECK_FALSE(verified({poses, four, own}, expect(problem, "", exact_degree(20))));
        CHECK_FALSE(verified({all, poses, four}, expect(problem, "", exact_degree(20))));
    }
    const ReplayedFile six = certificate_of("6*P/P");
    CHECK_FALSE(verified({all, poses, four, six}, expect("6*P/P", "", at_least(1))));
}

TEST_CASE("the files that are named are those that prove it") {
    ReplayedFile other = certificate_of("3*P/P/P + a/a/a");
    other.name = "other.plc";
    const Report report = report_on({other, certificate_of(chicago), degree_file({{2394, 311}})},
                                    expect(chicago, "minimal", exact_degree(312)));
    CHECK(report.judgement.files == std::vector<std::string>{"problem.plc"});
    CHECK(conclusion(report) == "VERIFIED: 2*Pa/Pa/Pa + P/P/P is minimal, and has exactly 312 "
                                "camera solutions (problem.plc)\n");
    CHECK(contains(why(report), "by Theorem C of proofs/three_views/4_classes.md"));
}

TEST_CASE("the whole classification is verified if no class lacks its record") {
    CHECK(verified({whole_classification()}, WholeClassification{}));
    Verdicts verdicts = all_verdicts();
    verdicts[2394].reset();
    CHECK_FALSE(verified({classification_with(verdicts)}, WholeClassification{}));
    CHECK(
        verified({classification_with(verdicts), certificate_of(chicago)}, WholeClassification{}));
    CHECK_FALSE(verified({certificate_of(chicago)}, WholeClassification{}));
}

TEST_CASE("nothing is verified in a run in which a file is refused") {
    ReplayedFile refused = degree_file({{6722, 216}});
    std::get<DegreeFile>(refused.content).refusals.add(3, "a reason");
    for (const ReplayedFile& bad :
         {refused, ReplayedFile{.name = "x", .content = Malformed{{1, "a reason"}}},
          ReplayedFile{.name = "x", .content = Unreadable{"a reason"}}, degree_file({})})
        for (const Expectation& expectation :
             {Expectation{}, Expectation{expect(chicago, "minimal")},
              Expectation{WholeClassification{}}}) {
            const Report report = report_on({whole_classification(), bad}, expectation);
            CHECK(report.status > 0);
            CHECK(conclusion(report).starts_with("NOT VERIFIED: "));
            CHECK(conclusion(report).ends_with("1 of 2 files is refused (" + bad.name + ")\n"));
        }
}
