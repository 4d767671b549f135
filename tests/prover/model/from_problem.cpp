// Point-line problems as models: they have the numbers of solutions that theory and the path
// tracker know, and the verdicts of the classification.
#include "prover/model/fibre.h"
#include "prover/model/solution_point.h"
#include "prover/model/solver/solution_count.h"
#include "prover/problem/notation.h"
#include "prover/scripts/problem_model.h"
#include "prover/system/exit.h"

#include <doctest/doctest.h>

#include <map>
#include <string>
#include <vector>

namespace {

using namespace plprove;

struct Written {
    model::Model model;
    model::Program program;
};

Written written(const std::string& notation) {
    Written result;
    result.model = model::read_model(problem_model(parse_problem(notation), 0));
    result.program = model::compile(result.model);
    return result;
}

bool has_regular_solution(const std::string& notation) {
    const Written found = written(notation);
    return found.program.equations.size() == found.program.unknowns &&
           model::find_solution_point(found.model, found.program).fibre.has_value();
}

} // namespace

TEST_CASE("models of small problems have as many solutions as is known") {
    const std::map<std::string, std::size_t> degrees{
        {"5*P/P", 20},                // two poses for each of 10 essential matrices
        {"5*P/P + 3*a/a + Pa/Pa", 0}, // over-constrained
        {"3*PL/PL + 2*P/P", 16},
        {"projective: 7*P/P", 3},
        {"projective: 6*P/P/P", 3},
        {"upright: 3*P/P", 4},
        {"shared-focal: 6*P/P", 30}}; // two poses for each of 15
    for (const auto& [notation, degree] : degrees) {
        CAPTURE(notation);
        const Written found = written(notation);
        if (degree == 0) {
            CHECK(found.program.equations.size() > found.program.unknowns);
            continue;
        }
        const auto fibre = model::find_fibre(found.model, found.program).fibre;
        REQUIRE(fibre);
        CHECK(fibre->count() == degree);
        CHECK(model::count_solutions(found.program, {}).solutions == static_cast<int>(degree));
    }
}

TEST_CASE("paths count the solutions of problems that views see in part") {
    // The first three by Groebner bases (certs/three-views-in-part.csv), the last by Theorem C.
    const std::map<std::string, int> degrees{{"upright: Pa/Pa/Pa + a/a/a + P/-/P", 6},
                                             {"upright: a/P/Pa + -/P/P + 3*P/-/P + P/P/-", 16},
                                             {"upright: 3*P/a/a + 2*a/P/a + 2*a/a/P", 78},
                                             {"2*P/P/P + a/Pa/Pa + a/a/a", 240}};
    for (const auto& [notation, degree] : degrees) {
        CAPTURE(notation);
        const MonodromyCount count = model::count_solutions(written(notation).program, {});
        CHECK(count.solutions == degree);
        CHECK(2 * count.edges >= count.ways);
    }
}

TEST_CASE("the search for solutions ends where more are known than wanted, whatever the threads") {
    const model::Program program = written("upright: 3*P/a/a + 2*a/P/a + 2*a/a/P").program;
    const MonodromyCount one = model::count_solutions(program, {.most_solutions = 10});
    CHECK(one.solutions > 10);
    CHECK(one.solutions < 78);
    CHECK(!one.complete());
    const MonodromyCount three =
        model::count_solutions(program, {.threads = 3, .most_solutions = 10});
    CHECK(three.solutions == one.solutions);
    CHECK(three.paths == one.paths);
}

TEST_CASE("the view that sees most points comes first, and the degree stays") {
    const Problem written_so = parse_problem("upright: a/P/Pa + -/P/P + 3*P/-/P + P/P/-");
    const Problem best_first = best_view_first(written_so);
    CHECK(notation(best_first) == "upright: Pa/P/a + P/P/- + 3*P/-/P + -/P/P");
    const model::Program program = model::compile(model::read_model(problem_model(best_first, 0)));
    CHECK(program.unknowns < written("upright: a/P/Pa + -/P/P + 3*P/-/P + P/P/-").program.unknowns);
    CHECK(model::count_solutions(program, {}).solutions == 16);
}

TEST_CASE("a Groebner basis of too many unknowns is refused") {
    const model::Model large = model::read_model("model large\n"
                                                 "data d[1..33]\n"
                                                 "unknown x[1..33]\n"
                                                 "for i in 1..33\n"
                                                 "  equation x[i] = d[i]\n"
                                                 "end\n");
    CHECK(model::find_fibre(large, model::compile(large)).reason ==
          "there are more than 32 unknowns");
}

TEST_CASE("models of minimal problems have a regular solution, those of others have none") {
    for (const std::string notation :
         {"2*Pa/Pa/Pa + P/P/P", "-/P/P + 3*P/P/P + P/-/P", "P/P/P + 4*a/a/a",
          "a/a/a + 4*-/P/P + 3*a/P/a + 2*b/Pab/a", "2*a/Pa/Pa + Pa/a/P + -/P/P + a/a/P + Pab/b/a",
          "a/P/Pa + 5*P/-/P + 2*P/P/- + a/a/P + b/Pab/a", "PLM/PLM + 2*PL/PL + 2*PM/PM",
          "shared-k: 8*a/a/a", "shared-focal-center: 7*a/a/a", "focal: 3*PL/PL + 4*P/P",
          "upright: P/P/P + 2*a/a/a", "upright-shared-focal: 4*P/P", "upright-focal: 5*P/P",
          "projective: PLM/PLM + 2*PL/PL + 2*PM/PM + 2*P/P",
          "projective: 2*P/P/P + Pabcde/Pabcde/Pabcde + 2*a/a/a"}) {
        CAPTURE(notation);
        const Problem problem = parse_problem(notation);
        REQUIRE(is_balanced(problem));
        CHECK(has_regular_solution(notation));
    }
    for (const std::string notation : {"6*P/P", "4*P/P", "4*PL/PL + P/P", "11*P/P/-",
                                       "3*P/P/P + P/P/a", "upright: 4*PL/PL/PL"}) {
        CAPTURE(notation);
        CHECK(!has_regular_solution(notation));
    }
}

TEST_CASE("a problem that no view sees, or that is too large, has no model") {
    CHECK_THROWS_AS(written("2*-/-/-(Pa)"), BadInput);
    CHECK_THROWS_AS(written("40*-/P/P"), BadInput);
}
