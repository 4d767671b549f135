// What the checker says of several files together: verdicts beside the paper's numbers, each
// explanation only where it explains, complaints, the exit status.
#include "checker/counts/families.h"
#include "checker/paper/numbers.h"
#include "tests/support/results.h"

using namespace checker;

namespace {

const paper::Claim& line_on(const Report& report, std::string_view name) {
    for (const paper::Claim& claim : report.claims)
        if (claim.claim == name) return claim;
    FAIL(name);
    return report.claims.front();
}

/// The classes that a count of the paper with an explanation counts.
bool is_counted(const paper::ClaimedCount& claim, std::size_t n) {
    const Signature& s = all_classes().representatives[n];
    if (!extends_five_points(s) || !is_minimal(all_verdicts(), n)) return false;
    if (claim.name == "five-point extensions, minimal") return true;
    if (claim.name == "- terminal camera-minimal") return all_classes().represents_swap_class(n);
    if (claim.name == "- PL0Ps") return is_pl0p(s);
    FAIL("say here which classes this count has: ", claim.name);
    return false;
}

/// Verdicts with which a count has only `counted` classes; its other classes are called obstructed.
Verdicts verdicts_with(const paper::ClaimedCount& claim, std::size_t counted) {
    Verdicts verdicts = all_verdicts();
    std::size_t found = 0;
    for (std::size_t n = 0; n < verdicts.size(); ++n)
        if (is_counted(claim, n) && ++found > counted) verdicts[n]->star = 1;
    return verdicts;
}

Report report_on(const Verdicts& verdicts) {
    return summarize(all_classes(), {classification_with(verdicts)});
}

} // namespace

TEST_CASE("a difference is explained only where the certified number is the explained one") {
    for (const paper::ClaimedCount& claim : paper::claimed_counts) {
        if (claim.certified_instead == 0) continue;
        CAPTURE(claim.name);
        const paper::Claim as_known = line_on(report_on(all_verdicts()), claim.name);
        CHECK(as_known.certified == say(claim.certified_instead));
        CHECK(as_known.verdict == say("differs: ", claim.why));
        CHECK(as_known.counted == claim.counted);
        const std::size_t other = claim.certified_instead - 1;
        const paper::Claim altered = line_on(report_on(verdicts_with(claim, other)), claim.name);
        CHECK(altered.certified == say(other));
        CHECK(altered.verdict == "differs: not explained");
        CHECK(altered.counted.empty());
        if (claim.claimed > claim.certified_instead) continue; // there are no more
        const paper::Claim agreeing =
            line_on(report_on(verdicts_with(claim, claim.claimed)), claim.name);
        CHECK(agreeing.verdict == "confirmed");
        CHECK(agreeing.counted.empty());
    }
}

TEST_CASE("a count without an explanation that differs is not explained") {
    Verdicts verdicts = all_verdicts();
    verdicts[2394]->star = 1; // 2*Pa/Pa/Pa + P/P/P
    const Report report = report_on(verdicts);
    const paper::Claim& minimal = line_on(report, "label classes, minimal");
    CHECK(minimal.claimed == "140616");
    CHECK(minimal.certified == "140615");
    CHECK(minimal.verdict == "differs: not explained");
    const paper::Claim& problem = line_on(report, "3002_1, class 2394: 2*Pa/Pa/Pa + P/P/P");
    CHECK(problem.certified == "not minimal");
    CHECK(problem.verdict == "differs: not explained");
    CHECK(line_on(report, "label classes").verdict == "confirmed");
    const std::string list = errata(report);
    CHECK(list.find("Paper: 140616; certified: 140615; differs: not explained.") != list.npos);
    CHECK(report.status == 0); // a difference is a finding, not a refusal
    CHECK(report.judgement.verified);
}

TEST_CASE("the errata have each count that differs, and nothing else") {
    const Report report = report_on(all_verdicts());
    const std::string list = errata(report);
    std::size_t differences = 0;
    for (std::size_t at = 0; (at = list.find("  Paper: ", at)) != list.npos; ++at)
        ++differences;
    CHECK(differences == 3);
    CHECK(list.find("Witness: class 72050, 2*a/P/Pa + 2*P/a/Pa + 3*-/P/P") != list.npos);
    CHECK(list.find("Witness: class 7024, 2*P/P/P + 3*-/P/P + 2*P/-/P") != list.npos);
    CHECK(notation(all_classes().representatives[72050]) == "2*a/P/Pa + 2*P/a/Pa + 3*-/P/P");
    CHECK(notation(all_classes().representatives[7024]) == "2*P/P/P + 3*-/P/P + 2*P/-/P");
    CHECK(errata(summarize(all_classes(), {})) ==
          "no count that these files cover differs from the paper\n");
}

TEST_CASE("without certificates only the enumeration is certified, and nothing is verified") {
    const Report report = summarize(all_classes(), {});
    CHECK(report.status == 1);
    for (std::size_t i = 0; i < report.claims.size(); ++i)
        CHECK(report.claims[i].verdict == (i < 3 ? "confirmed" : "not covered by these files"));
    CHECK(summary(report).empty());
    CHECK(conclusion(report) == "NOT VERIFIED: there is no file; give one\n");
    CHECK(complaints(report).empty());
}

TEST_CASE("problem files prove what they are about, and together all") {
    const Report one = summarize(all_classes(), {problem_of_class(2394)});
    CHECK(line_on(one, "3002_1, class 2394: 2*Pa/Pa/Pa + P/P/P").verdict == "confirmed");
    CHECK(line_on(one, "label classes, minimal").verdict == "not covered by these files");
    CHECK(finding(one.findings.files[0]) ==
          "problem.plc: certified minimal, class 2394: 2*Pa/Pa/Pa + P/P/P\n");
    CHECK(summary(one).empty());
    CHECK(conclusion(one) == "VERIFIED: 2*Pa/Pa/Pa + P/P/P is minimal (problem.plc)\n");
    Verdicts others = all_verdicts();
    others[2394].reset();
    const Report both =
        summarize(all_classes(), {classification_with(others), problem_of_class(2394)});
    CHECK(line_on(both, "label classes, minimal").verdict == "confirmed");
}

TEST_CASE("the status is that of the worst file") {
    const ReplayedFile good = problem_of_class(2394);
    ReplayedFile refused = degree_file({});
    std::get<DegreeFile>(refused.content).refusals.add(7, "a reason");
    const ReplayedFile unreadable{.name = "none", .content = Unreadable{"no such file"}};
    const ReplayedFile malformed{.name = "text", .content = Malformed{{3, "another reason"}}};
    const auto status = [](const std::vector<ReplayedFile>& files) {
        return summarize(all_classes(), files).status;
    };
    CHECK(status({good}) == 0);
    CHECK(status({good, refused}) == 1);
    CHECK(status({refused, good}) == 1);
    CHECK(status({refused, malformed, good}) == 2);
    CHECK(status({malformed, refused}) == 2);
    CHECK(status({good, unreadable}) == 2);
    const Report report = summarize(all_classes(), {good, refused, malformed});
    CHECK(complaints(report) == "degrees.plc:7: refused: a reason\n"
                                "text:3: does not conform to FORMAT.md: another reason\n");
    CHECK(detailed(report).find("text: not a certificate file\n") != std::string::npos);
}

TEST_CASE("in a run with a file that is refused, no row of a table confirms anything") {
    const ReplayedFile malformed{.name = "text", .content = Malformed{{1, "a reason"}}};
    const Report report =
        summarize(all_classes(), {whole_classification(), degree_file({{2394, 312}}), malformed});
    CHECK(report.status == 2);
    CHECK(report.claims.size() > 30);
    for (const paper::Claim& claim : report.claims)
        CHECK(claim.verdict == "withheld: a file is refused");
    CHECK(report.degrees.size() > 50);
    for (const paper::DegreeClaim& claim : report.degrees)
        CHECK(claim.verdict == "withheld: a file is refused");
    CHECK(detailed(report).find("confirmed") == std::string::npos);
    CHECK(errata(report) == "no count that these files cover differs from the paper\n");
    CHECK(conclusion(report) == "NOT VERIFIED: 1 of 3 files is refused (text)\n");
}

TEST_CASE("a degree file or a file of a model without a record is refused") {
    const ReplayedFile model{.name = "model.plc", .content = ModelFile{.name = "m", .text = "m"}};
    for (const ReplayedFile& empty : {degree_file({}), model}) {
        CHECK(summarize(all_classes(), {empty}).status == 1);
        const Report report = summarize(all_classes(), {problem_of_class(2394), empty});
        CHECK(report.status == 1);
        CHECK(complaints(report) ==
              empty.name + ":0: refused: it has no record, so it proves nothing\n");
    }
}

TEST_CASE("of many refusals the first 20 are told, the rest counted") {
    ReplayedFile refused = degree_file({});
    for (std::size_t line = 1; line <= 25; ++line)
        std::get<DegreeFile>(refused.content).refusals.add(line, "a reason");
    const std::string list = complaints(summarize(all_classes(), {refused}));
    CHECK(std::count(list.begin(), list.end(), '\n') == 21);
    CHECK(list.ends_with("degrees.plc:20: refused: a reason\ndegrees.plc: 5 more refused\n"));
}

TEST_CASE("a file that does not conform proves nothing") {
    const std::string bytes =
        "plcert 2 problem\nproblem 7*P/P/P\nverdict over-constrained 10\nmore\n";
    const ReplayedFile file = replay(all_classes(), "file", bytes);
    CHECK(std::holds_alternative<Malformed>(file.content));
    CHECK(kind_of(file).empty());
    CHECK(refusals_of(file).count == 0);
}
