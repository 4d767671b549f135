// Programs for Macaulay2 and HomotopyContinuation.jl as models: what they mean, and what is
// refused.
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

} // namespace

TEST_CASE("a program has the solutions that Bezout's theorem gives its equations") {
    CHECK(solutions(import_program(macaulay2, "conics.m2")) == 4);
    CHECK(solutions(import_program(julia, "curves.jl")) == 6);
    // Told by what they have in them.
    CHECK(import_program(julia, "-").find("data a_1_1") != std::string::npos);
    CHECK(import_program(macaulay2, "-").find("unknown x, y") != std::string::npos);
}

TEST_CASE("scripts of a model are imported as models with as many zeros") {
    for (const std::string name : {"p3p", "apollonius", "transversals", "gps", "two_circles"}) {
        CAPTURE(name);
        std::ostringstream text;
        text << std::ifstream(std::string(SOURCE_DIR) + "/models/" + name + ".model").rdbuf();
        const model::Model model = model::read_model(text.str());
        const model::Program program = model::compile(model);
        const std::size_t count = solutions(text.str());
        CHECK(count > 0);
        CHECK(solutions(import_program(macaulay2_script(model, program), "script.m2")) == count);
        CHECK(solutions(import_program(julia_script(model, program), "script.jl")) == count);
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

TEST_CASE("damaged programs are read or refused") {
    std::mt19937 random(1);
    const std::string bytes = "()[]{}_^,;=+-*/'\"#.x1 \n@\x80";
    for (const auto& [program, file] : {std::pair{macaulay2, "a.m2"}, std::pair{julia, "a.jl"}})
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
