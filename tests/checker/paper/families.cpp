// A degree that a paper bounds from below, beside what is certified and what evidence says.
#include "checker/problem/notation.h"
#include "tests/support/file.h"
#include "tests/support/results.h"

using namespace checker;

namespace {

const std::string six_views = "Pa/Pa/Pa/Pa/Pa/Pa + 2*a/a/a/a/a/a";

std::string text_of(const std::string& name) {
    return read(CERTS_DIR "/" + name);
}

/// A file that proves this number of solutions of a problem.
ReplayedFile solutions_of(const std::string& notation, std::size_t solutions) {
    SolutionsFile content;
    content.counts.push_back({notation, parse_problem(notation), solutions});
    return {.name = "solutions", .content = content};
}

/// What the table of PLMP says of a degree, beside these files.
paper::FamilyDegree degree_beside(std::vector<ReplayedFile> files) {
    files.push_back(replay(all_classes(), "plmp", text_of("plmp.plc")));
    const Report report = summarize(all_classes(), files);
    REQUIRE(report.families.size() == 1);
    REQUIRE(report.families[0].degrees.size() == 1);
    return report.families[0].degrees[0];
}

} // namespace

TEST_CASE(
    "a degree that is claimed to be larger than a number stands beside the evidence on file") {
    const paper::FamilyDegree degree = degree_beside({});
    CHECK(degree.name == "1021_1");
    CHECK(degree.problem == six_views);
    CHECK(degree.claimed_above == 450'000);
    CHECK(degree.at_least == 0);
    CHECK(degree.at_most == degree.evidence); // Theorem E
    CHECK(degree.verdict == "differs, certified");
    const std::string line = say("\nplmp,", six_views, ',', degree.evidence, ",exact,certified,");
    CHECK(text_of("family-degrees.csv").find(line) != std::string::npos);
}

TEST_CASE("solutions of this problem alone are certified of it, in whatever names") {
    const std::string renamed = "2*a/a/a/a/a/a + Pb/Pb/Pb/Pb/Pb/Pb";
    CHECK(degree_beside({solutions_of(renamed, 70), solutions_of(six_views, 5)}).at_least == 128);
    CHECK(degree_beside({solutions_of("5*P/P", 20)}).at_least == 0);
}

TEST_CASE("only more solutions than claimed confirm a claim, and only a bound refutes it") {
    paper::FamilyDegree degree;
    degree.claimed_above = 10;
    for (const auto& [at_least, at_most, verdict] : {std::tuple{11, 0, "confirmed"},
                                                     {10, 0, "differs by evidence"},
                                                     {0, 11, "differs by evidence"},
                                                     {0, 10, "differs, certified"}}) {
        set_certified(degree, std::size_t(at_least), std::size_t(at_most));
        CHECK(degree.verdict == verdict);
    }
}

TEST_CASE("the solutions of six views are counted in multiples of 64, which is Theorem G") {
    const std::size_t most = degree_beside({}).at_most;
    CHECK(degree_beside({solutions_of(six_views, most)}).at_least == most);
    CHECK(degree_beside({solutions_of(six_views, most - 63)}).at_least == most);
    CHECK(degree_beside({solutions_of(six_views, most - 64)}).at_least == most - 64);
}

TEST_CASE("a file with more solutions than a theorem allows is refused") {
    const std::size_t most = degree_beside({}).at_most;
    CHECK(degree_beside({solutions_of(six_views, most)}).verdict == "differs, certified");
    CHECK(degree_beside({solutions_of(six_views, most + 1)}).at_least == 0);
    CHECK(degree_beside({solutions_of(six_views, most + 1)}).verdict.starts_with("withheld"));
}

TEST_CASE("beside a file that is refused, the comparison is withheld") {
    const paper::FamilyDegree degree = degree_beside({replay(all_classes(), "b", "")});
    CHECK(degree.verdict.starts_with("withheld"));
}
