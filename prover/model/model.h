// A model: data, unknowns, equations and conditions, as a person wrote them (certs/FORMAT.md,
// section 16). What it means is in program.h.
#pragma once

#include "prover/model/words.h"

#include <string>
#include <vector>

namespace plprove::model {

/// A sum of numbers and names of loops: { +1 or -1, number or name }.
struct Index {
    struct Term {
        int sign = 1;
        std::string word; ///< a CONSTANT or the NAME of a loop
        Position at;
    };
    std::vector<Term> terms;
};

/// What stands on a side of an equation, or in a `let` statement.
struct Expression {
    enum class Kind {
        constant,
        name,
        call,
        array,
        item,
        sum,
        difference,
        negative,
        product,
        quotient,
        power
    };
    Kind kind = Kind::constant;
    Position at;
    std::string name;              ///< of a name or of a function
    int number = 0;                ///< the constant, or the exponent
    std::vector<Expression> parts; ///< operands, arguments, items
    Index index;                   ///< of an item
};

/// A name that `data` or `unknown` gives, and its shape.
struct Variable {
    std::string name;
    std::vector<int> shape;
    Position at;
};

struct Statement {
    enum class Kind { data, unknown, let, equation, proportional, relation, nonzero, count, loop };
    Kind kind = Kind::equation;
    Position at;
    std::string name;                    ///< of `let`, or of the loop
    std::vector<Variable> variables;     ///< of `data` and `unknown`
    std::vector<Expression> expressions; ///< the sides, or what a list has
    Index first, last;                   ///< of the loop
    std::vector<Statement> body;
};

struct Model {
    std::string name;
    int claimed = 0; ///< how many solutions the source claims, 0 if it does not say
    std::vector<Statement> statements;
    std::vector<std::string>
        lines; ///< the words, one space between them: as a certificate has them
};

/// Reads a text. Throws ModelError where it does not keep the grammar, or has a name that means
/// nothing.
Model read_model(std::string_view text);

/// The comments before the first statement, a line each, but those with control characters.
std::vector<std::string> opening_comments(const std::string& text);

} // namespace plprove::model
