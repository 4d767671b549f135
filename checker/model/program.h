// The text of a model (FORMAT.md, section 16) as a tree: statements, and the expressions in them.
#pragma once

#include "checker/file/reader.h"

namespace checker {
struct Expression {
    /// `minus` is a summand that is subtracted, `over` a factor that divides. An item's parts are
    /// the array and the indices.
    enum class Kind { constant, name, call, list, item, sum, minus, product, over, power };
    Kind kind = Kind::constant;
    int number = 0;     // a constant, or the exponent of a power
    std::string name{}; // of a value, a loop or a function
    std::vector<Expression> parts{};
};

struct Statement {
    enum class Kind { data, unknown, let, equal, proportional, relation, nonzero, count, loop };
    Kind kind = Kind::let;
    std::size_t line = 0;
    std::string name{};               // what it declares
    std::vector<std::size_t> shape{}; // of data and unknowns
    std::vector<Expression> parts{};  // a loop: the first and the last index
    std::vector<Statement> body{};    // of a loop
};

struct Program {
    std::string name{};
    std::size_t claimed = 0; // 0: nothing is claimed
    std::vector<Statement> statements{};
    std::string text{}; // its lines in the file, by which models are the same
};

/// Takes the lines of a model. Throws Malformed where they violate the grammar.
Program read_program(Reader& reader);

/// The lines of a model's text as a file has them: words with one space between them, no comments.
std::string lines_of_model(std::string_view text);

/// Whether a word is a name: a letter, then letters, digits and `_`; 40 characters at most.
bool is_name(std::string_view word);
} // namespace checker
