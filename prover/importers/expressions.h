// Expressions of a program that is imported: what Macaulay2 and Julia have in common. A reader of
// one of the languages reads statements, and says what names and functions mean.
#pragma once

#include "prover/importers/draft.h"
#include "prover/importers/tokens.h"

#include <algorithm>
#include <functional>
#include <map>
#include <string>
#include <vector>

namespace plprove::importers {

/// A place among the tokens.
class Tokens {
public:
    explicit Tokens(std::vector<Token> tokens) : tokens_(std::move(tokens)) {}

    const Token& here() const { return tokens_[place_]; }
    const Token& next() const { return tokens_[std::min(place_ + 1, tokens_.size() - 1)]; }
    const Token& after_next() const { return tokens_[std::min(place_ + 2, tokens_.size() - 1)]; }
    bool is(std::string_view symbol) const {
        return here().kind == Token::Kind::symbol && here().word == symbol;
    }
    bool is(Token::Kind kind) const { return here().kind == kind; }
    bool is_word(std::string_view name) const {
        return is(Token::Kind::name) && here().word == name;
    }
    /// The token here, and goes on; the last one stays.
    const Token& take() {
        const Token& taken = here();
        if (place_ + 1 < tokens_.size()) ++place_;
        return taken;
    }
    bool skip(std::string_view symbol) {
        if (!is(symbol)) return false;
        take();
        return true;
    }
    /// A place to come back to.
    std::size_t place() const { return place_; }
    void go_to(std::size_t place) { place_ = place; }
    void skip_new_lines() {
        while (is(Token::Kind::new_line))
            take();
    }
    /// Goes to the end of the statement, past its brackets.
    void skip_statement();
    bool at_end_of_statement() const {
        return is(";") || is(Token::Kind::new_line) || is(Token::Kind::end);
    }
    void expect(const std::string& symbol) {
        if (!skip(symbol)) fail("'" + symbol + "'");
    }
    /// A whole number; throws ModelError if there is none of at most four digits.
    int integer();
    std::string name(const std::string& expected = "a name");

    [[noreturn]] void fail(const std::string& expected, const std::string& advice = "") const;

private:
    std::vector<Token> tokens_;
    std::size_t place_ = 0;
};

class Expressions {
public:
    Expressions(Tokens& tokens, Language language) : tokens_(tokens), language_(language) {}

    Value read() { return sum(); }
    /// What a function is applied to.
    Value argument() { return postfix(); }

    std::map<std::string, Value> values; ///< of the names that have one
    Draft draft;

    /// The value of a function that not both languages have, the place being at its arguments;
    /// false if the name is none.
    std::function<bool(const std::string& name, Value& result)> call;
    /// Whether the name is a ring, to which x_R only moves x.
    std::function<bool(const std::string& name)> is_ring;

    /// The items between an opening bracket, which is taken already, and the closing one.
    std::vector<Value> list(const std::string& closing);

private:
    Value sum();
    Value product();
    Value signed_power();
    Value power();
    Value postfix();
    Value atom();
    Value name();
    Value function(const Token& function);
    Value matrix();
    Value item(const Value& of, int index, int first, model::Position at) const;
    Value subscript(const Value& of);
    bool begins_item() const;
    bool multiplies_silently(const Value& left) const;

    Tokens& tokens_;
    Language language_;
    bool spaces_separate_ = false; // between [ and ] of Julia
    int depth_ = 0;
};

} // namespace plprove::importers
