// Elimination templates, and the straight-line code of their coefficients.
#include "prover/model/elimination_template.h"
#include "prover/model/straight_line_text.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <string>

namespace {

using namespace plprove::model;

std::string refusal(const std::string& text) {
    try {
        make_template(study(text));
    } catch (const plprove::BadInput& error) {
        return error.what();
    }
    return {};
}

} // namespace

TEST_CASE("equal polynomials in data are computed once, and those that are 0 are constants") {
    DataProgram program;
    const auto a = DataPolynomial::datum(program, 0, plprove::Modular(123456789123456));
    const auto b = DataPolynomial::datum(program, 1, plprove::Modular(987654321987654));
    const DataPolynomial two(2);
    CHECK(((a + b) * (a + b) - (a * a + two * a * b + b * b)).is_zero());
    CHECK((a * b).step(program) == (b * a).step(program));
    CHECK((two * two.inverse() * a).step(program) == a.step(program));
    const std::size_t sum = ((a + b) * (a - b)).step(program);
    const StraightLineText text = straight_line_text(
        program, {sum, (-b).step(program), DataPolynomial(3).step(program)}, {"a", "b"});
    CHECK(text.assignments.empty());
    CHECK(text.values == std::vector<std::string>{"(a + b)*(a - b)", "-b", "3"});
}

TEST_CASE(
    "a template has as many rows as columns beyond the basis, and the basis is the solutions") {
    // Two conics: by Bezout 4 solutions, by Macaulay all monomials up to degree 3.
    const Study conics =
        study("model conics\ndata a : matrix 3 by 3, b : matrix 3 by 3\nunknown x, y\n"
              "let v = [x, y, 1]\nequation dot(v, a*v) = 0\nequation dot(v, b*v) = 0\n");
    const EliminationTemplate table = make_template(conics);
    CHECK(table.basis.size() == 4);
    CHECK(table.rows.size() <= 6);
    CHECK(table.variable_columns.size() == 2);
    REQUIRE(table.action.size() == 1);
    CHECK(table.action[0].products.size() == 4);
    for (const EliminationTemplate::Row& row : table.rows)
        CHECK(std::ranges::all_of(row.columns,
                                  [&](std::size_t column) { return column <= table.columns(); }));
}

TEST_CASE("where the elimination leaves more than the solutions, or is missing, is no template") {
    CHECK(refusal("model m\ndata a\nunknown x, y\nequation x = a\n")
              .starts_with("the model m has no template: "));
    CHECK(refusal("model m\ndata a, b\nunknown x\nequation x*(x - a)*(x - b) = 0\n"
                  "nonzero x - b\n") ==
          "the model m has no template: its elimination leaves 3 monomials, but 2 solutions are "
          "known; 'relation' statements may make these numbers equal");
}
