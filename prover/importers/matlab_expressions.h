// Expressions of Matlab, in a program that is imported.
#pragma once

#include "prover/importers/arrays.h"
#include "prover/importers/draft.h"
#include "prover/importers/expressions.h"
#include "prover/importers/matlab_symbols.h"

#include <map>
#include <optional>
#include <string>
#include <vector>

namespace plprove::importers {

class MatlabExpressions {
public:
    MatlabExpressions(Tokens& tokens, MatlabSymbols& symbols, Draft& draft)
        : tokens_(tokens), symbols_(symbols), draft_(draft) {}

    /// The expression here, and goes on behind it. Random data in it are named after `target`.
    Array read(const std::string& target);
    /// What `if` asks.
    bool condition();
    /// The indices in the brackets here, of this array; `end` is its last place.
    std::vector<Index> indices(const Array& of);

    std::map<std::string, Array> values; ///< of the variables
    /// Why a variable has no value, although it was given one.
    std::map<std::string, model::ModelError> failures;

private:
    struct Argument {
        Array value;
        std::string text; ///< what is in quotes
    };

    Array disjunction();
    Array conjunction();
    Array comparison();
    Array range();
    Array sum();
    Array product();
    Array signed_power();
    Array power();
    Array postfix();
    Array atom();
    Array name();
    Array function(const Token& name);
    Array matrix();
    std::vector<Array> row();
    bool begins_item() const;
    Index index(const Array& of, std::size_t which, std::size_t count);
    bool has_bracket() const;
    std::size_t arguments_ahead();
    std::vector<Argument> arguments();
    bool is_given();
    [[noreturn]] void refuse_name(const Token& name) const;

    Tokens& tokens_;
    MatlabSymbols& symbols_;
    Draft& draft_;
    std::string target_;
    bool spaces_separate_ = false; // between [ and ]
    std::optional<long> end_;      // between brackets after an array: its last place
    int depth_ = 0;
};

} // namespace plprove::importers
