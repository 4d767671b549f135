// Programs for Macaulay2, HomotopyContinuation.jl and Matlab as models: what they mean, and what
// is refused.
#include "prover/importers/importers.h"
#include "prover/model/fibre.h"
#include "prover/scripts/equation_scripts.h"
#include "prover/system/exit.h"

#include <doctest/doctest.h>

#include <fstream>
#include <random>
#include <sstream>
#include <string>
#include <vector>

namespace {

using namespace plprove;
using importers::import_program;

std::size_t solutions(const std::string& text) {
    const model::Model model = model::read_model(text);
    const auto fibre = model::find_fibre(model, model::compile(model)).fibre;
    return fibre ? fibre->polynomial.degree() : 0;
}

/// What is wrong with a program; empty if it is read.
std::string complaint(const std::string& program, const std::string& file) {
    try {
        model::compile(model::read_model(import_program(program, file)));
    } catch (const BadInput& error) {
        return error.what();
    }
    return {};
}

const std::string macaulay2 = R"(-- two conics
R = frac(QQ[a_1..a_5, b])[x, y, MonomialOrder => Lex];
M = matrix {{a_1, a_2}, {a_2, a_3}};
v = matrix {{x}, {y}}
f = (transpose v*M*v)_(0,0) + a_4*x -* a comment *- + a_5;
g = det matrix {{x, y, 1}, {b, 1, x}, {1, 2/3, y}} - 1234567890;
I = ideal(f, g)
dim I
)";

const std::string julia = R"(using HomotopyContinuation
#= a conic and a cubic =#
@var x y a[1:2, 1:2] b c   # and their coefficients
v = [x; y]
f = v' * a * v + 2b*x - 1.25e-1
g = det([x y 1; c 1 x
         1 -y 2//3])
F = System([f, g]; variables = v, parameters = [a[1, 1], a[1, 2], a[2, 1], a[2, 2], b, c])
result = solve(F; target_parameters = randn(6))
)";

// As generators of elimination templates have them: quadrics, whose data are random integers;
const std::string quadrics = R"(function [eqs, data0, eqs_data] = problem_quadrics(data0)
if nargin < 1 || isempty(data0)
    data0 = randi(50, 3*4, 1); % random integers
end
Q = reshape(data0(1:12), 3, 4);
xx = create_vars(3);
eqs = xx.^2 + Q*[xx; 1];
if nargout == 3
    xx = create_vars(3 + 3*4);
    eqs_data = problem_quadrics(xx(4:end));
end
)";

// six points and a focal length, where matrices are symbols;
const std::string focal = R"(function [eq, known, unknown, kngroups, cfg] = six_points()
F1 = gbs_Matrix('F1%d%d', 3, 3);
F2 = gbs_Matrix('F2%d%d', 3, 3);
F3 = gbs_Matrix('F3%d%d', 3, 3);
syms x y w real;
F = x*F1 + y*F2 + F3;
eq(1) = det(F);
Q = diag([1 1 w]);
te = 2*(F*Q*transpose(F)*Q)*F - trace(F*Q*F'*Q)*F;
eq(2:10) = te(:);
unknown = {'x' 'y' 'w'};
known = {};
for var = transpose([F1(:); F2(:); F3(:)])
    known = [known {char(var)}];
end
cfg = gbs_InitConfig();
end
)";

// and three points of a camera, in loops.
const std::string depths = R"(%{
A script.
%}
data0 = [rand(9, 1); randn(3, 1)];
X = reshape(data0(1:9), [], 3);
d = data0(10:end)';
s = sym('s', [1 3]);
pairs = [1 2
         1 3; 2 3];
eqs = [];
for k = 1:size(pairs, 1),
    v = s(pairs(k, 1))*X(:, pairs(k, 1)) ...
        - s(pairs(k, end))*X(:, pairs(k, end));
    if k == 1, eqs(end+1) = dot(v, v) - d(k); else, eqs = [eqs; v.'*v - d(k)]; end
end
)";

} // namespace

TEST_CASE("a program has the solutions that Bezout's theorem gives its equations") {
    CHECK(solutions(import_program(macaulay2, "conics.m2")) == 4);
    CHECK(solutions(import_program(julia, "curves.jl")) == 6);
    CHECK(solutions(import_program(quadrics, "problem_quadrics.m")) == 8);
    // Told by what they have in them.
    CHECK(import_program(julia, "-").find("data a_1_1") != std::string::npos);
    CHECK(import_program(macaulay2, "-").find("unknown x, y") != std::string::npos);
}

TEST_CASE("problem files of Matlab have the solutions that are known") {
    CHECK(solutions(import_program(depths, "depths.m")) == 8);
    // More equations than unknowns: no certificate, but the same model.
    const std::string text = import_program(focal, "-");
    CHECK(text.find("unknown x, y, w\n") != std::string::npos);
    CHECK(text.find("data F111, F121, ") != std::string::npos);
    std::size_t equations = 0;
    for (std::size_t at = 0; (at = text.find("\nequation ", at)) != std::string::npos; ++at)
        ++equations;
    CHECK(equations == 10);
    // As many: a cubic and a quadric of its unknowns, and a line.
    const std::size_t trace = focal.find("eq(2:10)");
    std::string square = focal;
    square.replace(trace, focal.find('\n', trace) - trace,
                   "eq(2) = trace(F*F'); eq(end+1) = F(1, :)*F1(:, 1) - w;");
    CHECK(solutions(import_program(square, "square.m")) == 6);
}

TEST_CASE("scripts of a model are imported as models with as many zeros") {
    for (const std::string name : {"p3p", "apollonius", "transversals", "gps", "two_circles"}) {
        CAPTURE(name);
        std::ostringstream text;
        text << std::ifstream(std::string(SOURCE_DIR) + "/models/" + name + ".model").rdbuf();
        const std::size_t count = solutions(text.str());
        CHECK(count > 0);
        CHECK(solutions(import_program(macaulay2_script(text.str()), "script.m2")) == count);
        CHECK(solutions(import_program(julia_script(text.str()), "script.jl")) == count);
    }
}

TEST_CASE("names of a program that models do not have become others") {
    const std::string text = import_program(
        "R = QQ[det', data, x_(1,1)..x_(2,2)]\nI = ideal(det'^2 - data, x_(1,2) + 1)", "a.m2");
    CHECK(text.find("unknown det_, data_, x_1_1, x_1_2, x_2_1, x_2_2\n") != std::string::npos);
    CHECK(text.find("equation det_^2 - data_ = 0\n") != std::string::npos);
}

TEST_CASE("large numbers are composed of small ones") {
    const std::string text = import_program("R = QQ[x]; I = ideal(x - 12345678)", "a.m2");
    CHECK(text.find("equation x - (12345*1000 + 678) = 0\n") != std::string::npos);
    CHECK(text.find("the data of one example") != std::string::npos);
}

TEST_CASE("what is not understood is refused with its place") {
    const std::string ring = "R = QQ[x, y]\n";
    CHECK(complaint(ring + "I = ideal(x + z)", "a.m2")
              .starts_with("line 2, column 15: found 'z', which is no variable"));
    CHECK(complaint(ring + "I = ideal(x^y)", "a.m2") ==
          "line 2, column 13: expected a whole number, found 'y'");
    CHECK(complaint(ring + "f = t -> t^2\nI = ideal(f x)", "a.m2")
              .starts_with("line 2, column 5: functions are not imported"));
    CHECK(complaint(ring + "I = ideal(x", "a.m2") ==
          "line 2, column 10: this bracket is not closed");
    CHECK(complaint(ring, "a.m2").starts_with("line 2, column 1: expected an ideal"));
    CHECK(complaint("@var x\nf = sin(x)\nSystem([f])", "a.jl")
              .starts_with("line 2, column 5: found 'sin', which is no variable"));
    CHECK(complaint("@var x y\nSystem([x + y]; variables = [x])", "a.jl")
              .starts_with("the variable 'y' is in an equation"));
    CHECK(complaint("@var x\nSystem([x^2 for i in 1:3])", "a.jl")
              .starts_with("line 2, column 13: expected an operator"));
    CHECK(complaint("x = 1", "a.txt").starts_with("a.txt is no program that can be imported"));
}

TEST_CASE("what Matlab programs do that is not understood is refused with its place") {
    const std::string start = "x = create_vars(2);\n";
    const auto matlab = [](const std::string& program) { return complaint(program, "a.m"); };
    CHECK(matlab(start + "eqs = [x(1) + z; x(2)];") ==
          "line 2, column 15: found 'z', which has no value: did you mean 'x'?");
    CHECK(matlab(start + "eqs = rotation(x)*x;")
              .starts_with("line 2, column 7: found 'rotation', which is no function"));
    CHECK(matlab(start + "eqs = x(3);") == "line 2, column 7: found the index 3 of a 2 by 1 array");
    CHECK(matlab(start + "eqs = x + [1; 2; 3];") ==
          "line 2, column 9: found a 2 by 1 array and a 3 by 1 array: their sizes do not fit");
    // Rows and columns are repeated.
    CHECK(matlab(start + "eqs = x(1)*x + [1 2 3];").empty());
    CHECK(matlab(start + "eqs = x*x;")
              .starts_with("line 2, column 8: found a 2 by 1 array and a 2 by 1 array: their "
                           "product is not defined"));
    CHECK(matlab(start + "while 1\n eqs = x;\nend")
              .starts_with("line 2, column 1: found 'while', which is not imported"));
    CHECK(matlab(start + "for i = 1:2\n eqs(i) = x(i);\n")
              .starts_with("line 4, column 1: expected the end of the loop"));
    CHECK(matlab("syms x y\nunknown = {'x' 'z'};\neqs = [x y];") ==
          "line 2, column 9: found the unknown 'z', which is no symbol of the program");
    CHECK(matlab("function eqs = f(data0)\neqs = data0(1)*create_vars(2);\nend")
              .starts_with("line 1, column 18: the argument 'data0' has no value"));
    CHECK(matlab(start).starts_with("line 2, column 1: expected equations"));
    // What gives no equation may be anything.
    CHECK(matlab(start + "[q, r] = qr(x); cfg.f = @(t) t; disp('ready'), eqs = x.^2 - 1;").empty());
    CHECK(matlab(start + "[q, r] = qr(x);\neqs = q;")
              .starts_with("line 2, column 2: functions with several values are not imported"));
}

TEST_CASE("Matlab computes with integers") {
    const auto value = [](const std::string& expression) {
        const std::string text =
            import_program("syms x\nA = [1 2; 3 4];\neqs = x - (100 + " + expression + ");", "a.m");
        const std::size_t begin = text.find("equation x - ") + 13;
        return std::stoi(text.substr(begin, text.find(" = 0") - begin)) - 100;
    };
    CHECK(value("A(2, 1)") == 3);
    CHECK(value("A(3)") == 2);
    CHECK(value("A(end)") == 4);
    CHECK(value("A(1, :)*[5; 6]") == 17);
    CHECK(value("A(:, 2)'*[1; 1]") == 6);
    CHECK(value("trace(A*A')") == value("sum(sum(A.^2))"));
    CHECK(value("sum(sum(A^2))") == 54);
    CHECK(value("sum(sum([1; 2]*[3 4]))") == 21);
    CHECK(value("sum([1 - 2, 3 -4])") == -2);
    CHECK(value("sum([1 2]*A, 2)") == 17);
    CHECK(value("2^3^2") == 64);
    CHECK(value("(-2^2)") == -4);
    CHECK(value("numel(1:2:7)") == 4);
    CHECK(value("size(reshape(1:6, 2, []), 2)") == 3);
    CHECK(value("length(zeros(2, 5))") == 5);
    CHECK(value("cross([1 0 0], [0 1 0])*[0; 0; 1]") == 1);
    CHECK(value("sum(diag(diag([1 2 3])))") == 6);
    CHECK(value("sum(skew([1 2 3])*[1; 2; 3])") == 0);
}

TEST_CASE("damaged programs are read or refused") {
    std::mt19937 random(1);
    const std::string bytes = "()[]{}_^,;=+-*/'\"#.x1 \n@\x80";
    for (const auto& [program, file] : {std::pair{macaulay2, "a.m2"}, std::pair{julia, "a.jl"},
                                        std::pair{depths, "a.m"}, std::pair{focal, "a.m"}})
        for (int trial = 0; trial < 500; ++trial) {
            std::string damaged = program.substr(0, 1 + random() % program.size());
            if (trial % 3 != 0) damaged = program;
            for (std::size_t i = random() % 4; i > 0; --i)
                damaged[random() % damaged.size()] = bytes[random() % bytes.size()];
            complaint(damaged, file);
        }
    // Deep and wide.
    for (const char* open : {"(", "{", "[", "-", "x*("})
        complaint(
            "R = QQ[x]\nI = ideal(" + std::string(1, 'x') + "-" +
                [&] {
                    std::string text;
                    for (int i = 0; i < 5000; ++i)
                        text += open;
                    return text;
                }(),
            "a.m2");
}
