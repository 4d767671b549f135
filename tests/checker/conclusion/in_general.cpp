// What a user expects of problems in general is verified if the files prove just that, and not
// otherwise.
#include "checker/command/expected.h"
#include "tests/support/file.h"
#include "tests/support/results.h"
#include "tests/support/text.h"

using namespace checker;

namespace {

std::string archive(const std::string& family) {
    return read(CERTS_DIR "/" + family + ".plc");
}

Report report_on(const std::string& bytes, const ExpectedWords& words) {
    return summarize(all_classes(), {replay(all_classes(), "file", bytes)}, expectation_of(words));
}

bool verified(const std::string& bytes, const ExpectedWords& words) {
    const Report report = report_on(bytes, words);
    CHECK(report.judgement.verified == (report.status == 0));
    return report.judgement.verified;
}

ExpectedWords expect(std::string_view problem, std::string_view verdict) {
    return {.problem = problem, .verdict = verdict};
}

/// Why the words make no sense.
std::string usage_of(const ExpectedWords& words) {
    try {
        expectation_of(words);
    } catch (const WrongUsage& usage) {
        return usage.reason;
    }
    return {};
}

} // namespace

TEST_CASE("a problem in general is expected by any names of its points and lines") {
    const std::string plmp = archive("plmp");
    for (const char* problem : {"PL/PL + PM/PM + PLM/PLM + PL/PL + PM/PM",
                                "PX/PX+PY/PY + PXY/PXY + PX/PX + PY/PY", "5*P/P", " 5 * P / P "}) {
        CAPTURE(problem);
        CHECK(verified(plmp, expect(problem, "minimal")));
        CHECK(verified(plmp, expect(problem, "camera-minimal")));
        CHECK(!verified(plmp, expect(problem, "not-minimal")));
    }
    for (const char* problem : {"P/P + 4*PL/PL", "5*PL/PL", "Pabcdef/Pabcdef/Pabcdef + a/a/a"}) {
        CAPTURE(problem);
        CHECK(verified(plmp, expect(problem, "not-minimal")));
        CHECK(!verified(plmp, expect(problem, "minimal")));
        CHECK(!verified(plmp, expect(problem, "obstructed")));
    }
}

TEST_CASE("another problem, other cameras or other views prove nothing") {
    const std::string plmp = archive("plmp");
    for (const char* problem : {"projective: 5*P/P", "projective: 7*P/P", "4*P/P", "5*P/P/P",
                                "2*PL/PL + 3*P/P", "P/P/P + 4*a/a/-"})
        for (const char* verdict : {"minimal", "not-minimal"})
            CHECK(!verified(plmp, expect(problem, verdict)));
    CHECK(verified(archive("projective"), expect("projective: 7*P/P", "minimal")));
}

TEST_CASE("a large problem is told at once from another one that looks alike") {
    // Points in cycles, with a line for each two neighbours.
    const auto cycles = [](const std::vector<std::string>& all) {
        std::string notation;
        for (const std::string& lines : all)
            for (std::size_t i = 0; i < lines.size(); ++i) {
                const auto [a, b] = std::minmax(lines[i], lines[(i + 1) % lines.size()]);
                const std::string feature{'P', a, b};
                notation += (notation.empty() ? "projective: " : " + ") + feature + '/' + feature;
            }
        return notation;
    };
    const std::string two = cycles({"ABCDEFGHIJKL", "MNOQRSTUVWXY"});
    const std::string one = cycles({"ABCDEFGHIJKLMNOQRSTUVWXY"});
    const std::string other_names = cycles({"XVTRMNOQSUWY", "ACEGIKLJHFDB"});
    const std::string file =
        "plcert 2 problems\nmodulus 2305843009213693951\nproblem " + two + "\nunbalanced\n";
    CHECK(verified(file, expect(two, "not-minimal")));
    CHECK(verified(file, expect(other_names, "not-minimal")));
    CHECK(!verified(file, expect(one, "not-minimal")));
}

TEST_CASE("a verdict that is not minimal says nothing of the number of relative poses") {
    const Report report = report_on(archive("plmp"), {.problem = "4*PL/PL + P/P", .degree = "20"});
    CHECK(!report.judgement.verified);
}

TEST_CASE("a family is expected whole") {
    const std::string plmp = archive("plmp");
    CHECK(verified(plmp, {.family = "plmp"}));
    CHECK(!verified(plmp, {.family = "projective"}));
    CHECK(verified(archive("projective"), {.family = "projective"}));
    CHECK(!verified(with(plmp, "family plmp\n", ""), {.family = "plmp"}));
    CHECK(!verified(plmp.substr(0, plmp.rfind("problem ")), {.family = "plmp"}));
}

TEST_CASE("the numbers of a family stand beside those of its paper, and confirm nothing if a file "
          "is refused") {
    const Report report = report_on(archive("plmp"), {});
    REQUIRE(report.families.size() == 1);
    std::size_t sum = 0;
    for (const paper::Claim& claim : report.families[0].claims) {
        CHECK(claim.verdict == (claim.claim == "balanced" ? "no claim" : "confirmed"));
        if (claim.claim.starts_with("minimal, in ")) sum += std::stoul(claim.certified);
    }
    CHECK(say(sum) == report.families[0].claims[1].certified);
    const std::string bytes = with(archive("plmp"), "minimal 2057", "minimal 1057");
    CHECK(report_on(bytes, {}).families.empty());
    const Report beside = summarize(all_classes(), {replay(all_classes(), "a", archive("plmp")),
                                                    replay(all_classes(), "b", "")});
    REQUIRE(beside.families.size() == 1);
    for (const paper::Claim& claim : beside.families[0].claims)
        CHECK(claim.verdict.starts_with("withheld"));
}

namespace {

const std::string six_points = "projective: 6*P/P/P";
const std::string with_a_line = "projective: 2*PL/PL/PL + 4*P/P/P";

/// The record of six points in the archive, of a problem with this notation.
std::string record_as(const std::string& notation) {
    const std::string archived = archive("projective");
    const std::string start = "problem " + six_points + "\nminimal";
    const std::size_t begin = archived.find(start);
    REQUIRE(begin != archived.npos);
    const std::string record = archived.substr(begin, archived.find("problem ", begin + 1) - begin);
    return "plcert 2 problems\nmodulus 2305843009213693951\n" + with(record, six_points, notation);
}

/// A file that counts so many solutions, or says that there are so many at most.
ReplayedFile counts(const std::string& notation, std::size_t solutions) {
    SolutionsFile content;
    content.counts.push_back({notation, parse_problem(notation), solutions});
    return {.name = "solutions", .content = content};
}

ReplayedFile bounds(const std::string& notation, std::size_t at_most) {
    AtMostFile content;
    content.bounds.push_back({notation, parse_problem(notation), at_most});
    return {.name = "at-most", .content = content};
}

Report degree_report(const std::string& notation, const std::string& degree,
                     const std::vector<ReplayedFile>& beside) {
    std::vector<ReplayedFile> files{replay(all_classes(), "file", record_as(notation))};
    files.insert(files.end(), beside.begin(), beside.end());
    return summarize(all_classes(), files, expectation_of({.problem = notation, .degree = degree}));
}

} // namespace

TEST_CASE("a line with two points changes no bound, by theorem or by file") {
    for (const std::string& notation : {six_points, with_a_line})
        for (const std::string& counted : {six_points, with_a_line}) {
            CAPTURE(notation);
            CAPTURE(counted);
            const auto verified = [&](const std::string& degree,
                                      const std::vector<ReplayedFile>& beside) {
                return degree_report(notation, degree, beside).judgement.verified;
            };
            CHECK(verified("3", {counts(counted, 3)})); // at most 3 by Theorem Q
            CHECK(!verified("3", {counts(counted, 2)}));
            CHECK(!verified("3", {}));
            CHECK(verified(">=2", {counts(counted, 2)}));
            CHECK(verified("2", {counts(counted, 2), bounds(counted, 2)}));
        }
    const Report wrong = degree_report(with_a_line, "4", {counts(with_a_line, 4)});
    CHECK(wrong.status == 1);
    CHECK(contains(complaints(wrong), "projective: 2*PL/PL/PL + 4*P/P/P has at least 4 solutions, "
                                      "and at most 3, by Theorem Q of proofs/moduli.md"));
    // A verdict on one of them is none on the other.
    CHECK(!verified(record_as(with_a_line), expect(six_points, "minimal")));
}

TEST_CASE("a line that a view sees with one of its two points may change a degree") {
    const std::string partly = "projective: PL/PL/PL + PL/PL/L + 5*P/P/P";
    const Report report = summarize(all_classes(), {counts(partly, 1'000)});
    CHECK(report.status == 0);
}

TEST_CASE("in three calibrated views theorems give the degree, whatever files count") {
    const auto exact = [](const std::vector<ReplayedFile>& beside) {
        std::vector<ReplayedFile> files{replay(all_classes(), "plmp", archive("plmp"))};
        files.insert(files.end(), beside.begin(), beside.end());
        const Report report = summarize(all_classes(), files);
        REQUIRE(report.families.size() == 1);
        CHECK(report.families[0].exact_by_theorem == report.families[0].exact);
        return report.families[0].exact;
    };
    CHECK(exact({}) == 12);
    CHECK(exact({counts("2*Pa/Pa/Pa + P/P/P", 311)}) == 12);
    CHECK(exact({counts("5*P/P", 20)}) == 13);
    CHECK(exact({counts("5*P/P", 17)}) == 13); // as the number is a multiple of 4
    CHECK(exact({counts("5*P/P", 16)}) == 12);
    CHECK(exact({replay(all_classes(), "solutions", archive("solutions/plmp"))}) == 24);
    const Report wrong = summarize(all_classes(), {replay(all_classes(), "plmp", archive("plmp")),
                                                   counts("2*Pa/Pa/Pa + P/P/P", 313)});
    CHECK(contains(complaints(wrong), "2*Pa/Pa/Pa + P/P/P has at least 320 solutions, and at most "
                                      "312, by Theorem C of proofs/three_views/4_classes.md"));
}

TEST_CASE("what makes no sense is said in the words of the notation that is meant") {
    CHECK(contains(usage_of(expect("projective: 7*P", "minimal")), "2 to 12 views"));
    CHECK(contains(usage_of(expect("3*PLL/PL", "minimal")), "section 13"));
    CHECK(contains(usage_of(expect("Pa/Paa/P", "minimal")), "section 1 "));
    CHECK(contains(usage_of({.family = "pl1p"}), "choose one of plmp, "));
    CHECK(contains(usage_of({.family = "plmp", .classification = true}), "leave out"));
}
