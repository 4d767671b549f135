// Files of models (FORMAT.md, section 16): what they prove, and what is refused for which reason if
// anything is altered in them.
#include "checker/model/model_file.h"
#include "checker/conclusion/models.h"
#include "checker/model/layout.h"
#include "tests/support/text.h"

#include <doctest/doctest.h>

using namespace checker;

namespace {

/// The square roots of a number: two.
const std::string roots = R"(model square_root
claimed 2
data a
unknown x
equation x ^ 2 = a
modulus 2305843009213693951
fibre 2
data 2
polynomial 2305843009213693949 0
unknown 0 1
separated by 1
elimination
data 2
degree 2 in x
basis 1 2
rows 1 1
minor 1
)";

/// The same; what counts is the square of the root: one value. In s = x x it is s = a.
const std::string squares = R"(model square
data a
unknown x
let s = x * x
equation s = a
count s
modulus 2305843009213693951
fibre 2
data 2
polynomial 2305843009213693949 0
unknown 0 1
separated by 1
distinct 1 by 1
elimination
data 2
degree 1 in s
basis 1
rows 1 1
minor 1
)";

/// Where a circle meets a line, with fractions, a loop, arrays and a relation: two points. The
/// variables are u = (x, y), of degree 2; `relation` is never needed, but true.
const std::string circle = R"(model circle
data c : vector 2 , r , m
unknown x , y
let u = [ x , y ] / 1
let zero = norm2 ( u ) - x ^ 2 - y ^ 2
relation zero = 0
for i in 1 .. 1
equation norm2 ( u - c ) = r / 2
end
equation y / m = x [ 1 + 0 ]
modulus 2305843009213693951
)";

ModelFile outcome(const std::string& text, std::uint64_t effort = usual_effort) {
    Reader reader(text);
    return replay_model(reader, {.effort = effort});
}

/// The first refusal, or what is malformed, after the number of its line.
std::string fault(const std::string& text) {
    try {
        const ModelFile file = outcome(text);
        REQUIRE(file.refusals.count > 0);
        return say(file.refusals.first[0].line, ": ", file.refusals.first[0].reason);
    } catch (const Malformed& malformed) {
        return say(malformed.complaint.line, ": ", malformed.complaint.reason);
    }
}

std::string brackets(int count, const std::string& bracket) {
    std::string all;
    for (int i = 0; i < count; ++i)
        all += bracket;
    return all;
}

/// What is wrong with the file of square roots if a part of it is replaced.
std::string altered(const std::string& old, const std::string& by) {
    return fault(with(roots, old, by));
}

} // namespace

TEST_CASE("a fibre bounds from below, an elimination from above") {
    const ModelFile file = outcome(roots);
    CHECK(file.name == "square_root");
    CHECK(file.claimed == 2);
    CHECK(file.at_least == 2);
    CHECK(file.at_most == 2);
    CHECK(file.records == 2);
    CHECK(file.refusals.count == 0);
    const ModelFile counted = outcome(squares);
    CHECK(counted.at_least == 1);
    CHECK(counted.at_most == 1);
}

TEST_CASE("what is altered in a fibre is refused, for its reason") {
    CHECK(altered("unknown 0 1", "unknown 1 1") ==
          "7: a fibre: the sum of `separated by` is not t");
    CHECK(altered("\ndata 2", "\ndata 3") == "7: a fibre: equation 1 is not 0");
    CHECK(altered("polynomial 2305843009213693949 0", "polynomial 0 0") ==
          "7: a fibre: the polynomial has a multiple root");
    CHECK(altered("polynomial 2305843009213693949 0", "polynomial 0 1") ==
          "7: a fibre: equation 1 is not 0");
    CHECK(altered("equation x ^ 2 = a\n", "equation x ^ 2 = a\nnonzero x - 1 , x * 0\n") ==
          "8: a fibre: condition 2 has a common factor with g");
    CHECK(altered("equation x ^ 2 = a", "equation ( x ^ 2 - a ) ^ 2 = 0") ==
          "7: a fibre: the Jacobian has no inverse");
    CHECK(altered("equation x ^ 2 = a\n", "equation x ^ 2 = a\nequation 0 = 0\n") ==
          "8: a fibre: the model has 2 equations for 1 unknowns: a fibre needs as many");
    CHECK(altered("equation x ^ 2 = a", "equation x ^ 2 = a / ( 1 - 1 )") ==
          "7: a fibre: the model divides by the constant 0");
    CHECK(fault(with(squares, "distinct 1 by 1", "distinct 2 by 1")) ==
          "8: a fibre: the values that count are not proved to be 2 different ones");
    CHECK(altered("polynomial 2305843009213693949", "polynomial 2305843009213693951") ==
          "9: found `2305843009213693951`, expected an integer from 0 to 2305843009213693950");
    CHECK(altered("unknown 0 1\n", "unknown 0\n") ==
          "10: found nothing, expected an integer from 0 to 2305843009213693950");
}

TEST_CASE("what is altered in an elimination is refused, for its reason") {
    const std::string start = "12: an elimination: ";
    CHECK(altered("minor 1", "minor 2") == start + "the minor is 1 modulo q");
    CHECK(
        altered("basis 1 2", "basis 1 3") ==
        start +
            "a monomial of the basis, times a variable, has a larger degree than that of a group");
    CHECK(altered("basis 1 2", "basis 1 4") == start + "there is no monomial 4");
    CHECK(altered("basis 1 2", "basis 1") == start + "there are fewer rows than columns");
    CHECK(altered("rows 1 1", "rows 1 2") ==
          start + "a multiple of equation 1 has a larger degree than that of a group");
    CHECK(altered("rows 1 1", "rows 2 1") == start + "there is no equation 2");
    CHECK(altered("degree 2 in x\nbasis 1 2\nrows 1 1", "degree 3 in x\nbasis 1 2 3\nrows 1 1 2") ==
          start + "there are more rows than columns");
    CHECK(altered("degree 2 in x", "degree 2 in a") ==
          "14: found `a`, expected an unknown, or the name of a `let` statement");
    // Degrees bound those for all data: what cancels counts.
    CHECK(altered("equation x ^ 2 = a", "equation x ^ 2 + x ^ 3 - x ^ 3 = a") ==
          start + "a multiple of equation 1 has a larger degree than that of a group");
    CHECK(fault(with(squares, "count s", "count s , x")) ==
          "13: found nothing, expected an integer from -999999 to 999999");
    CHECK(fault(with(with(squares, "count s", "count x"), "distinct 1", "distinct 2")) ==
          "14: an elimination: what counts is not given by the variables");
    CHECK(fault(with(squares, "count s", "relation s = x\ncount s")) ==
          "15: an elimination: relation 1 does not hold for all data and unknowns");
    CHECK(fault(with(squares, "equation s = a", "equation s + 0 * x = a")) ==
          "14: an elimination: equation 1 has an unknown that is no variable");
}

TEST_CASE("a model that makes no sense is malformed, and the line is said") {
    const auto model = [](const std::string& old, const std::string& by) {
        return fault(with(circle, old, by));
    };
    CHECK(model("x [ 1 + 0 ]", "x [ 1 + 0 ]") == "10: a scalar has no items");
    CHECK(model("y / m = x [ 1 + 0 ]", "z / m = x") == "10: `z` has no meaning here");
    CHECK(model("let zero", "let u") == "5: `u` has a meaning already");
    // Of another shape, so that there are too few scalars for the first statement.
    CHECK(model("modulus", "data c\nmodulus") == "2: `c` has a meaning already");
    CHECK(fault("model early\ndata a\nlet x = [ a , a ]\nequation x [ 2 ] = a\nunknown x\n") ==
          "3: `x` has a meaning already");
    CHECK(model("let zero", "let det") == "5: found `det`, expected a name");
    CHECK(model("norm2 ( u ) - x ^ 2", "norm2 ( u , u ) - x ^ 2") ==
          "5: there is no function `norm2` of 2 values");
    CHECK(model("( u - c )", "( u - r )") == "8: sums need equal shapes");
    CHECK(model("r / 2", "r / c") == "8: a divisor is a scalar");
    CHECK(
        model("= r / 2", "= u * u") ==
        "8: a product needs a scalar, or a matrix and what it fits: use dot or cross for vectors");
    CHECK(model("for i in 1 .. 1", "for i in 1 .. j") == "7: `j` is the name of no loop");
    CHECK(model("for i in 1 .. 1", "for i in 1 .. 200000") ==
          "8: more than 100,000 statements to execute");
    CHECK(model("unknown x , y", "unknown x , y , w") == "10: a scalar has no items");
    CHECK(model("c : vector 2", "c : vector 101") ==
          "2: found `101`, expected an integer from 1 to 100");
    CHECK(model("y / m = x [ 1 + 0 ]", "y / m = x )") ==
          "10: found `)`, expected the end of the line");
    CHECK(model("end\n", "") == "10: found `modulus`, expected `end`");
    const std::string deep = "let d = " + brackets(200, "( ") + "1" + brackets(200, " )") + "\n";
    CHECK(model("let zero", deep + "let zero") ==
          "5: found `more`, expected at most 100 brackets in each other");
}

TEST_CASE("equations that contradict each other for generic data are at most 0 solutions") {
    const std::string contradiction = R"(model contradiction
data a , b
unknown x
equation x = a
equation x = b
modulus 2305843009213693951
elimination
data 2 3
degree 1 in x
basis
rows 1 1
rows 2 1
minor 1
)";
    CHECK(outcome(contradiction).at_most == std::size_t{0});
    CHECK(fault(with(contradiction, "data 2 3", "data 2 4")) ==
          "7: an elimination: the minor is 2 modulo q");
    CHECK(fault(with(contradiction, "data 2 3", "data 2 2")) ==
          "7: an elimination: the minor is 0 modulo q");
    CHECK(fault(with(contradiction, "rows 2 1\n", "")) ==
          "7: an elimination: there are fewer rows than columns");
    CHECK(in_words({.name = "m", .at_most = 0}) ==
          "m is not minimal: for generic data it has no solution");
}

TEST_CASE("fewer equations than unknowns have no solution") {
    const std::string fine = with(circle, "x [ 1 + 0 ]", "x");
    CHECK(!outcome(fine).at_most);
    const ModelFile file = outcome(with(fine, "unknown x , y", "unknown x , y , w"));
    CHECK(file.at_most == std::size_t{0});
    CHECK(file.records == 1);
}

TEST_CASE("functions and items refuse what they are not made for") {
    const auto of = [](const std::string& expression) {
        return fault(with(circle, "let zero", "let w = " + expression + "\nlet zero"));
    };
    const std::string fine = "11: a scalar has no items"; // that of the circle itself
    CHECK(of("c [ 2 ]") == fine);
    CHECK(of("c [ 3 ]") == "5: there is no item 3");
    CHECK(of("c [ 0 ]") == "5: there is no item 0");
    CHECK(of("c [ 999999 + 1 ]") == "5: there is no item 1000000");
    CHECK(of("c [ 999999 + 2 ]") == "5: an index larger than 1,000,000");
    CHECK(of("c [ 1 - 999999 - 999999 ]") == "5: an index larger than 1,000,000");
    CHECK(of("[ x , c ]") == "5: the items of a list have different shapes");
    CHECK(of("u ^ 2") == "5: only scalars have powers");
    CHECK(of("dot ( u , [ x , y , 1 ] )") == "5: this needs vectors of one size");
    CHECK(of("dot ( [ u , u ] , [ u , u ] )") == "5: this needs vectors of one size");
    for (const char* call :
         {"skew ( u )", "cross ( u , [ x , y , 1 ] )", "cross ( [ x , y , 1 ] , u )"})
        CHECK(of(call) == "5: this needs vectors of three");
    for (const char* call : {"det ( u )", "det ( [ u , u , u ] )", "trace ( [ u ] )"})
        CHECK(of(call) == "5: this needs a square matrix");
    CHECK(of("transpose ( u )") == "5: only a matrix has a transpose");
    CHECK(of("det ( identity ( 6 ) )") == fine);
    CHECK(of("det ( identity ( 7 ) )") == "5: a determinant has at most 6 rows");
    for (const char* call : {"rotation ( u )", "rotation ( identity ( 3 ) )"})
        CHECK(of(call) == "5: a rotation needs a vector of three or four");
    for (const char* call : {"identity ( 1 )", "identity ( 100 )"})
        CHECK(of(call) == fine);
    for (const char* call :
         {"identity ( 0 )", "identity ( 101 )", "identity ( x )", "identity ( 2 , 2 )"})
        CHECK(of(call) == "5: `identity` needs a constant from 1 to 100");
}

TEST_CASE("a model has limits, and may reach them") {
    const auto model = [](const std::string& old, const std::string& by) {
        return fault(with(circle, old, by));
    };
    const std::string fine = "10: a scalar has no items"; // that of the circle itself
    CHECK(model("unknown x , y", "unknown x , y , w : vector 98") == fine);
    CHECK(model("unknown x , y", "unknown x , y , w : vector 99") ==
          "3: a model has at most 100 of these scalars");
    CHECK(model("r , m", "r , m , w : matrix 83 by 12") == fine);
    CHECK(model("r , m", "r , m , w : matrix 83 by 12 , v") ==
          "2: a model has at most 1000 of these scalars");
    const std::string body = "for i in 1 .. 1\nequation norm2 ( u - c ) = r / 2\n";
    CHECK(model(body, "for i in 1 .. 99990\nlet w = x\n") == fine);
    CHECK(model(body, "for i in 1 .. 99991\nlet w = x\n") ==
          "10: more than 100,000 statements to execute");
    CHECK(model("for i in 1 .. 1\n", "for i in 1 .. 0\ndata d\n") ==
          "8: found `data`, expected `end`");
    CHECK(model("for i in", "for u in") == "7: `u` has a meaning already");
    CHECK(fault("model none\ndata a\nequation a = a\nmodulus 2305843009213693951\n") ==
          "3: the model has no unknown");
    const auto repeated = [](int times) {
        return altered("equation x ^ 2 = a",
                       say("for i in 1 .. ", times, "\nequation x ^ 2 = a\nend"));
    };
    CHECK(repeated(1000) ==
          "9: a fibre: the model has 1000 equations for 1 unknowns: a fibre needs as many");
    CHECK(repeated(1001) == "5: the model has more than 1,000 equations");
}

TEST_CASE("a model has at most 5,000,000 operations") {
    const auto text = [](std::uint64_t sums) {
        return say("model large\nunknown x\nfor i in 1 .. 499\nlet w = identity ( 100 )\nend\n"
                   "for i in 1 .. ",
                   sums, "\nlet w = x + x\nend\nequation x = 0\nmodulus 2305843009213693951\n");
    };
    const auto operations = [&](std::uint64_t sums) {
        const std::string all = text(sums);
        Reader reader(all);
        return layout_of(read_program(reader)).multiplications;
    };
    const std::uint64_t most = 5'000'000, others = operations(0);
    REQUIRE(operations(1) == others + 1);
    CHECK(operations(most - others - 1) == most - 1);
    CHECK(operations(most - others) == most);
    CHECK(fault(text(most - others + 1)) == "9: more than 5,000,000 operations");
}

TEST_CASE("a name that stands twice in a group has the degree 2") {
    const std::string parabola = "model parabola\ndata a\nunknown x , y\nequation y = x ^ 2\n"
                                 "equation y = a\nmodulus 2305843009213693951\nelimination\n"
                                 "data 5\ndegree 3 in x y y\nbasis 1 3\nrows 1 1 3\n"
                                 "rows 2 1 3\nminor 1\n";
    CHECK(outcome(parabola).at_most == 2);
    // Then x * y is no column.
    CHECK(fault(with(parabola, "degree 3", "degree 2")) ==
          "7: an elimination: a monomial of the basis, times a variable, has a larger degree than "
          "that of a group");
    // Then the third column is y * y.
    CHECK(fault(with(parabola, "x y y", "x y")) ==
          "7: an elimination: a multiple of equation 1 has a larger degree than that of a group");
}

TEST_CASE("an elimination has limits, and may reach them") {
    const std::string lone = with(
        roots, roots.substr(roots.find("fibre"), roots.find("elimination") - roots.find("fibre")),
        "");
    const auto equation = [&](const std::string& left) {
        return fault(with(lone, "equation x ^ 2 =", "equation " + left + " ="));
    };
    CHECK(equation("x ^ 2 / 0") == "7: an elimination: the model divides by the constant 0");
    CHECK(equation("( x ^ 20 ) ^ 10") ==
          "7: an elimination: a multiple of equation 1 has a larger degree than that of a group");
    CHECK(equation("( x ^ 20 ) ^ 10 * x") == "7: an elimination: a degree larger than 200");
    const auto columns = [](int x, int y, int z) {
        return fault(say("model three\nunknown x , y , z\nequation x = 0\nequation y = 0\n"
                         "equation z = 0\nmodulus 2305843009213693951\nelimination\ndata\ndegree ",
                         x, " in x\ndegree ", y, " in y\ndegree ", z,
                         " in z\nbasis 9999\nrows 1 1\nminor 1\n"));
    };
    CHECK(columns(19, 19, 9) == "7: an elimination: there is no monomial 9999");
    CHECK(columns(19, 19, 10) == "7: an elimination: there are more than 4000 columns");
}

TEST_CASE("files take an effort, and no more than they are given") {
    CHECK(outcome(roots, 2).refusals.count == 0);
    const ModelFile file = outcome(roots, 1);
    REQUIRE(file.refusals.count == 1);
    CHECK(file.refusals.first[0].reason.find("more effort than allowed") != std::string::npos);
    CHECK(file.at_least == 0);
}

TEST_CASE("the text of a model has the same lines however it is written") {
    const std::string text = "# comment\n\nmodel square_root # more\n claimed 2\ndata a\n"
                             "unknown x\nequation ( x\n )^2=a";
    CHECK(lines_of_model(text) ==
          "model square_root\nclaimed 2\ndata a\nunknown x\nequation ( x ) ^ 2 = a\n");
    CHECK(lines_of_model("let a=b[1..2]") == "let a = b [ 1 .. 2 ]\n");
    CHECK(outcome(roots).text == lines_of_model(roots.substr(0, roots.find("modulus"))));
}

TEST_CASE("files of one model add up, and may not contradict each other") {
    const auto replayed = [](const std::string& text) {
        return ReplayedFile{.name = "file", .content = outcome(text)};
    };
    const std::string fibre = roots.substr(0, roots.find("elimination"));
    const std::string elimination = with(
        roots, roots.substr(roots.find("fibre"), roots.find("elimination") - roots.find("fibre")),
        "");
    CHECK(contradictions_of_models({replayed(fibre), replayed(elimination)}).empty());
    ReplayedFile wrong = replayed(elimination);
    std::get<ModelFile>(wrong.content).at_most = 1;
    const auto found = contradictions_of_models({replayed(fibre), wrong});
    CHECK(found.size() == 2);
    CHECK(found.at(0) == "the model square_root has at least 2 solutions, and at most 1");
}

TEST_CASE("what is certified is compared with what is claimed") {
    const auto verdict = [](std::size_t claimed, std::size_t at_least,
                            std::optional<std::size_t> at_most) {
        return verdict_on({.claimed = claimed, .at_least = at_least, .at_most = at_most});
    };
    CHECK(verdict(4, 4, 4) == "confirmed");
    CHECK(verdict(4, 4, 5) == "open");
    CHECK(verdict(4, 4, {}) == "open");
    CHECK(verdict(4, 5, {}) == "differs: more are certified");
    CHECK(verdict(4, 0, 3) == "differs: fewer are certified");
    CHECK(verdict(4, 0, 0) == "differs: fewer are certified");
    CHECK(verdict(0, 4, 4) == "no claim");
}
