// The degrees of families on file, compared with those of the engine for three views.
#include "prover/many_views/degrees_on_file.h"

#include "prover/catalogue/degrees.h"
#include "prover/minimal/decision.h"
#include "prover/minimal/problem_record.h"
#include "prover/problem/notation.h"
#include "prover/problem/spec.h"

#include <doctest/doctest.h>
#include <map>
#include <set>

using namespace plprove;
using many_views::DegreeOnFile;

namespace {

std::vector<DegreeOnFile> all_on_file() {
    std::vector<DegreeOnFile> all;
    for (const std::string_view line : many_views::family_degree_lines())
        all.push_back(many_views::parse_family_degree(line));
    return all;
}

std::set<std::string> minimal_problems(const CameraModel& family) {
    std::set<std::string> problems;
    for (const Problem& problem : family_problems(family))
        if (is_minimal(certify(problem))) problems.insert(notation(problem));
    return problems;
}

} // namespace

TEST_CASE("degrees of families on file are of different minimal problems of these families") {
    std::map<std::string, std::set<std::string>> open;
    for (const CameraModel* cameras : camera_models())
        open[std::string(family_name(*cameras))] = minimal_problems(*cameras);
    for (const DegreeOnFile& line : all_on_file()) {
        CAPTURE(line.problem);
        CHECK(open[std::string(line.family)].erase(std::string(line.problem)) == 1);
        CHECK(line.degree > 0);
        // What is certified exactly, tests of the checker compare with what it certifies.
        const bool has_class = line.family == "plmp" && !parse_general_spec(line.problem);
        const bool by_theorem = line.source.starts_with("by theorem"); // in two views, say
        CHECK(line.source.starts_with("by its label class; ") == (has_class && !by_theorem));
        const bool is_exact = has_class || by_theorem || line.source.starts_with("by certificates");
        CHECK(line.status == (is_exact ? "certified" : "evidence"));
        if (is_exact) CHECK(line.certified == line.degree);
        // Two runs have to agree, and where cameras are known in part most ways, too; else the
        // degree is what is certified.
        const bool of_a_paper = line.family == "plmp" || line.family == "projective";
        CHECK((line.bound == "exact" || (!of_a_paper && line.certified == line.degree)));
    }
    CHECK(open.size() == 9);
    for (const char* complete : {"projective", "plmp", "upright", "upright-shared-focal"})
        CHECK(open[complete].empty());
}

TEST_CASE("degrees in three views are of whole constraint classes") {
    int minimal = 0;
    for (const std::string_view line : many_views::three_view_degree_lines()) {
        CAPTURE(line);
        const DegreeOnFile row = many_views::parse_three_view_degree(line);
        const auto found = many_views::degree_on_file(parse_problem(row.problem));
        CHECK(found.has_value() == (row.degree > 0));
        if (!found) continue;
        ++minimal;
        // Where all views see all, there is a line of the family, too.
        CHECK(found->degree == row.degree);
    }
    CHECK(minimal == 613 + 1379 + 941 + 7);
    // The views in another order, another view sees the line, and a second line.
    const auto degree = [](const char* text) {
        return many_views::degree_on_file(parse_problem(text))->degree;
    };
    CHECK(degree("upright: a/P/Pa + -/P/P + 3*P/-/P + P/P/-") == 16);
    CHECK(degree("upright: P/Pa/a + P/P/- + 3*-/P/P + P/-/P") == 16);
    CHECK(degree("upright: a/Pa/P + -/P/P + 3*P/-/P + P/P/-") == 16);
    CHECK(degree("upright: 3*P/a/a + 2*a/P/a + 2*a/a/P") == 78);
    CHECK(degree("upright: Pab/b/a + 2*P/a/a + 2*a/P/a + 2*b/a/Pab") == 78);
    CHECK(degree("upright-shared-focal: 3*P/a/a + 3*a/a/P + 2*a/P/a") == 370);
    CHECK(!many_views::degree_on_file(parse_problem("2*Pa/Pa/Pa + P/P/P")));
}

TEST_CASE("two views and a focal length each have twice the solutions of uncalibrated views") {
    // A fundamental matrix determines the focal lengths, and has two poses.
    std::map<std::string_view, int> degrees;
    for (const DegreeOnFile& line : all_on_file())
        degrees[line.problem] = line.degree;
    int compared = 0;
    for (const auto& [problem, degree] : degrees) {
        if (!problem.starts_with("focal: ")) continue;
        if (parse_problem(std::string(problem)).views > 2) continue;
        const std::string uncalibrated = "projective" + std::string(problem.substr(5));
        CAPTURE(uncalibrated);
        CHECK(degree == 2 * degrees.at(uncalibrated)); // Theorem 16, 4
        ++compared;
    }
    CHECK(compared == 6);
}

TEST_CASE("two engines agree on problems in three views with pins and free lines") {
    int compared = 0;
    for (const DegreeOnFile& line : all_on_file()) {
        if (line.family != "plmp" || parse_general_spec(line.problem)) continue;
        const Decision decision = decide(parse_spec(std::string(line.problem)));
        if (!decision.classes) continue; // two views
        CAPTURE(line.problem);
        CHECK(degree_on_file(decision.classes->constraint) == line.degree);
        ++compared;
    }
    CHECK(compared >= 12);
}
