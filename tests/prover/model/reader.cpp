// Reading the text of a model: what it means, and what errors say.
#include "prover/model/program.h"

#include <doctest/doctest.h>

#include <string>
#include <vector>

namespace {

using namespace plprove::model;

const std::string start = "model m\ndata a, v : vector 3, w : vector 2\nunknown x\n";

/// What is wrong with a model that begins as above; empty if nothing is.
std::string complaint(const std::string& text) {
    try {
        compile(read_model(text));
    } catch (const plprove::BadInput& error) {
        return error.what();
    }
    return {};
}

struct Mistake {
    std::string line;      ///< the fourth line of the model
    std::string complaint; ///< how the message begins
};

} // namespace

TEST_CASE("an error names the line and the column, what was found and what is expected") {
    const std::vector<Mistake> mistakes{
        {"equations x = a", "line 4, column 1: expected data, unknown, let, equation, relation, "
                            "nonzero, count or for, found 'equations': did you mean 'equation'?"},
        {"equation x = norm(v)", "line 4, column 14: found 'norm', which is no function: did you "
                                 "mean 'norm2'?"},
        {"equation x = b", "line 4, column 14: found 'b', which has no meaning here"},
        {"equation x + = a", "line 4, column 14: expected a number, a name, ( or [, found '='"},
        {"equation x", "line 4, column 11: expected an operator, '=' or '~', found the end of the "
                       "line"},
        {"equation x = a a",
         "line 4, column 16: expected an operator or the end of the line, found "
         "'a'"},
        {"equation x = v", "line 4, column 1: found a scalar and a vector of 3: + and - need equal "
                           "shapes"},
        {"equation x = dot(v, w)", "line 4, column 14: found a vector of 3 and a vector of 2"},
        {"equation x = v*v", "line 4, column 15: found a vector of 3 times a vector of 3"},
        {"equation x = v[4]",
         "line 4, column 15: found the index 4 of a vector of 3: it goes from 1 "
         "to 3"},
        {"equation x = v[a]", "line 4, column 16: expected a whole number or the name of a loop, "
                              "found 'a'"},
        {"equation x = a[1]", "line 4, column 15: a scalar has no items"},
        {"equation x = a/v", "line 4, column 15: found a vector of 3 to the right of /"},
        {"equation x = a/0", "line 4, column 16: this divides by 0"},
        {"equation x = a^21",
         "line 4, column 16: expected a whole number from 1 to 20, found '21'"},
        {"equation x = det(v)", "line 4, column 14: found det of a vector of 3"},
        {"equation x = 1000000", "line 4, column 14: expected a whole number from 0 to 999999"},
        {"equation x ~ a", "line 4, column 1: found a scalar and a scalar: ~ needs two vectors"},
        {"equation x = (a\nlet b = a", "line 5, column 1: expected ')', found 'let'"},
        {"let x = a", "line 4, column 5: 'x' has a meaning already"},
        {"let dot = a", "line 4, column 5: 'dot' is a word of the language"},
        {"unknown y[2..3]", "line 4, column 11: expected '1', found '2'"},
        {"unknown y : tensor 3", "line 4, column 13: expected vector or matrix, found 'tensor'"},
        {"for i in 1..3\nequation x = a",
         "line 5, column 15: expected 'end' of the loop in line 4"},
        {"for i in 1..3\nunknown y\nend", "line 5, column 1: data and unknowns stand outside"},
        {"end", "line 4, column 1: expected data, unknown, let, equation, relation, nonzero, count "
                "or for, found 'end': no loop is open"},
        {"equation x = a ? 1", "line 4, column 16: found the character '?'"},
        {"let y = 1\nlet z = [1, v]", "line 5, column 13: found a vector of 3 after a scalar"}};
    for (const Mistake& mistake : mistakes) {
        const std::string found = complaint(start + mistake.line + '\n');
        CHECK(found.substr(0, mistake.complaint.size()) == mistake.complaint);
    }
}

TEST_CASE("a text without unknowns, equations or a heading is no model") {
    CHECK(complaint("") ==
          "line 1, column 1: expected 'model' and a name, found nothing: begin with "
          "a line such as 'model p3p'");
    CHECK(complaint("data x\n").starts_with("line 1, column 1: expected 'model', found 'data'"));
    CHECK(complaint(start).starts_with("the model has no equation"));
    CHECK(complaint("model m\ndata a\nequation a = 0\n").starts_with("the model has no unknown"));
    CHECK(complaint("model m\nunknown x[1..99][1..2]\n")
              .starts_with("line 2, column 9: a model has at most 100 unknown scalars"));
}

TEST_CASE("the words of a model do not depend on spaces, comments and open brackets") {
    const Model plain =
        read_model("model m\nunknown x\nequation dot ( [ x , 1 ] , [ x , 2 ] ) = 0\n");
    const Model spread = read_model("# a comment\nmodel m\n\n  unknown x # the unknown\n"
                                    "equation dot([x,1], # open\n\n [x,2])=0");
    CHECK(plain.lines == spread.lines);
    CHECK(plain.lines[2] == "equation dot ( [ x , 1 ] , [ x , 2 ] ) = 0");
}

TEST_CASE("a loop runs as often as its bounds say, and its names end with it") {
    const std::string head = "model m\ndata a[1..4]\nunknown x[1..4]\n";
    const auto equations = [&](const std::string& body) {
        return compile(read_model(head + body)).equations.size();
    };
    CHECK(equations("for i in 1..4\nequation x[i] = a[5-i]\nend\n") == 4);
    CHECK(equations("equation x = a\nfor i in 2..1\nequation x[9] = a[1]\nend\n") == 4);
    CHECK(equations("for i in 1..4\nfor j in i..4\nlet b = i*a[j]\nequation x[i] = b\nend\nend\n"
                    "for i in 1..2\nlet b = a\nequation x = b\nend\n") == 18);
    CHECK(complaint(head + "for i in 1..4\nlet b = a[i]\nend\nequation x[1] = b\n")
              .starts_with("line 7, column 17: found 'b', which has no meaning here"));
}
