#include "prover/importers/expressions.h"

#include "prover/importers/setting.h"
#include "prover/system/words.h"

namespace plprove::importers {

namespace {

using model::ModelError;
using model::Position;
using Kind = Token::Kind;

/// Below each other: rows, or the items of a list.
void append_below(std::vector<Value>& items, const Value& value) {
    if (value.is_list)
        items.insert(items.end(), value.items.begin(), value.items.end());
    else
        items.push_back(value);
}

} // namespace

void Tokens::skip_statement() {
    int open = 0;
    while (!is(Kind::end)) {
        if (open == 0 && (is(";") || is(Kind::new_line))) return;
        if (is("(") || is("[") || is("{")) ++open;
        if (is(")") || is("]") || is("}")) --open;
        take();
    }
}

int Tokens::integer() {
    constexpr std::size_t longest = 4;
    if (!is(Kind::number) || here().word.size() > longest ||
        here().word.find_first_of(".eE") != std::string::npos)
        fail("a whole number");
    return std::stoi(take().word);
}

std::string Tokens::name(const std::string& expected) {
    if (!is(Kind::name)) fail(expected);
    return take().word;
}

void Tokens::fail(const std::string& expected, const std::string& advice) const {
    const std::string found = is(Kind::end)        ? "the end of the program"
                              : is(Kind::new_line) ? "the end of the line"
                                                   : in_quotes(here().word);
    throw ModelError(here().at, "expected " + expected + ", found " + found + advice);
}

/// Between [ and ], `a -b` are two items, and `a - b` is one.
bool Expressions::begins_item() const {
    return spaces_separate_ && tokens_.here().after_space && !tokens_.next().after_space;
}

Value Expressions::sum() {
    constexpr int deepest = 150;
    if (++depth_ > deepest)
        throw ModelError(tokens_.here().at, "more than 150 brackets are open: give names to parts");
    Value left = product();
    while ((tokens_.is("+") || tokens_.is("-")) && !begins_item()) {
        const Token sign = tokens_.take();
        tokens_.skip_new_lines();
        const Value right = product();
        left = sign.word == "+" ? importers::sum(left, right, sign.at)
                                : difference(left, right, sign.at);
    }
    --depth_;
    return left;
}

/// In Julia 2x is a product.
bool Expressions::multiplies_silently(const Value& left) const {
    const Token& here = tokens_.here();
    return language_ == Language::julia && !here.after_space && !left.is_list &&
           left.text.find_first_not_of("0123456789") == std::string::npos &&
           (here.kind == Kind::name || tokens_.is("("));
}

Value Expressions::product() {
    Value left = signed_power();
    for (;;) {
        const Token& here = tokens_.here();
        const Position at = here.at;
        const bool divides = tokens_.is("/") || (language_ == Language::julia && tokens_.is("//"));
        if (multiplies_silently(left)) {
            left = importers::product(left, signed_power(), at);
        } else if (tokens_.is("*") || tokens_.is(".*") || divides) {
            tokens_.take();
            tokens_.skip_new_lines();
            const Value right = signed_power();
            left = divides ? quotient(left, right, at) : importers::product(left, right, at);
        } else {
            return left;
        }
    }
}

Value Expressions::signed_power() {
    constexpr int deepest = 150;
    if (!tokens_.is("-") && !tokens_.is("+")) return power();
    const Token sign = tokens_.take();
    if (++depth_ > deepest) throw ModelError(sign.at, "more than 150 signs follow each other");
    const Value value = signed_power();
    --depth_;
    return sign.word == "-" ? negative(value, sign.at) : value;
}

Value Expressions::power() {
    Value base = postfix();
    while (tokens_.is("^") || tokens_.is(".^")) {
        const Position at = tokens_.take().at;
        const bool bracket = tokens_.skip("(");
        base = importers::power(base, tokens_.integer(), at);
        if (bracket) tokens_.expect(")");
        if (language_ == Language::macaulay2) base = subscript(base);
    }
    return base;
}

Value Expressions::item(const Value& of, int index, int first, Position at) const {
    const int count = static_cast<int>(of.items.size());
    if (!of.is_list || index < first || index >= first + count)
        throw ModelError(at, "found the index " + std::to_string(index) + " of " + description(of));
    return of.items[static_cast<std::size_t>(index - first)];
}

/// In Macaulay2 l_0 and l#0 are the first item, M_(0,1) is an entry; x_R is x.
Value Expressions::subscript(const Value& of) {
    Value value = of;
    while (tokens_.is("_") || tokens_.is("#")) {
        const Position at = tokens_.take().at;
        if (tokens_.is(Kind::name) && is_ring(tokens_.here().word)) {
            tokens_.take();
        } else if (tokens_.skip("(")) {
            value = item(value, tokens_.integer(), 0, at);
            while (tokens_.skip(","))
                value = item(value, tokens_.integer(), 0, at);
            tokens_.expect(")");
        } else {
            value = item(value, tokens_.integer(), 0, at);
        }
    }
    return value;
}

Value Expressions::postfix() {
    Value value = atom();
    if (language_ == Language::macaulay2) return subscript(value);
    for (;;) {
        const Position at = tokens_.here().at;
        if (tokens_.is("[") && !tokens_.here().after_space) {
            tokens_.take();
            value = item(value, tokens_.integer(), 1, at);
            while (tokens_.skip(","))
                value = item(value, tokens_.integer(), 1, at);
            tokens_.expect("]");
        } else if (tokens_.is("'") && !tokens_.here().after_space) {
            tokens_.take();
            value = transposed(value, at);
        } else {
            return value;
        }
    }
}

Value Expressions::atom() {
    const Token& here = tokens_.here();
    if (here.kind == Kind::number) {
        const Token taken = tokens_.take();
        return number(taken.word, taken.at);
    }
    if (here.kind == Kind::name) return name();
    if (tokens_.skip("(")) {
        const Setting setting(spaces_separate_, false);
        std::vector<Value> items = list(")");
        // In Macaulay2 (a, b) is a sequence.
        return items.size() == 1 ? items[0] : Value::list(std::move(items));
    }
    if (language_ == Language::macaulay2 && tokens_.skip("{")) return Value::list(list("}"));
    if (language_ == Language::julia && tokens_.skip("[")) return matrix();
    tokens_.fail("a number, a name or a bracket");
}

std::vector<Value> Expressions::list(const std::string& closing) {
    std::vector<Value> items;
    tokens_.skip_new_lines();
    while (!tokens_.skip(closing)) {
        items.push_back(sum());
        tokens_.skip_new_lines();
        if (tokens_.skip(","))
            tokens_.skip_new_lines();
        else if (!tokens_.is(closing))
            tokens_.fail("an operator, ',' or '" + closing + "'");
    }
    return items;
}

/// [a, b], [a; b] and [a b; c d]: a list, or rows.
Value Expressions::matrix() {
    const Setting setting(spaces_separate_, true);
    std::vector<Value> items;
    tokens_.skip_new_lines();
    while (!tokens_.skip("]")) {
        std::vector<Value> row{sum()};
        while (!tokens_.is(",") && !tokens_.is(";") && !tokens_.is("]") &&
               !tokens_.is(Kind::new_line)) {
            if (!tokens_.here().after_space || tokens_.is(Kind::end) || tokens_.is_word("for"))
                tokens_.fail("an operator, ',', ';' or ']'");
            row.push_back(sum());
        }
        const bool comma = tokens_.is(",");
        if (row.size() > 1)
            items.push_back(Value::list(std::move(row)));
        else if (comma || tokens_.is("]"))
            items.push_back(row[0]);
        else
            append_below(items, row[0]);
        if (comma || tokens_.is(";")) tokens_.take();
        tokens_.skip_new_lines();
    }
    return Value::list(std::move(items));
}

Value Expressions::name() {
    const Token token = tokens_.here();
    if (language_ == Language::macaulay2 && tokens_.next().word == "_" &&
        tokens_.after_next().kind == Kind::number) {
        const auto found = values.find(token.word + "_" + tokens_.after_next().word);
        if (found != values.end()) {
            tokens_.take(), tokens_.take(), tokens_.take();
            return found->second;
        }
    }
    if (language_ == Language::macaulay2 && tokens_.next().word == "_" &&
        tokens_.after_next().word == "(") {
        Tokens ahead = tokens_; // x_(1,2)
        ahead.take(), ahead.take(), ahead.take();
        std::string key = token.word;
        while (ahead.is(Kind::number)) {
            key += "_" + ahead.take().word;
            ahead.skip(",");
        }
        const auto found = values.find(key);
        if (found != values.end() && ahead.skip(")")) {
            tokens_ = ahead;
            return found->second;
        }
    }
    const auto found = values.find(token.word);
    if (found != values.end()) {
        tokens_.take();
        return found->second;
    }
    return function(token);
}

Value Expressions::function(const Token& function) {
    tokens_.take();
    Value result;
    if (call(function.word, result)) return result;
    const Setting setting(spaces_separate_, false);
    const auto two = [&](Value (*operation)(const Value&, const Value&, Position)) {
        tokens_.expect("(");
        const std::vector<Value> items = list(")");
        if (items.size() != 2)
            throw ModelError(function.at, "found " + in_quotes(function.word) + " of " +
                                              std::to_string(items.size()) + " values: it needs 2");
        return operation(items[0], items[1], function.at);
    };
    const auto with_names = [&](const Value& value) { return draft.named("t", value); };
    if (function.word == "det" || function.word == "determinant")
        return with_names(determinant(with_names(argument()), function.at));
    if (function.word == "transpose") return transposed(argument(), function.at);
    if (function.word == "dot") return two(dot);
    if (function.word == "cross") return two(cross);
    std::vector<std::string> names;
    for (const auto& [name, value] : values)
        names.push_back(name);
    throw ModelError(function.at, "found " + in_quotes(function.word) +
                                      ", which is no variable and no function that is imported" +
                                      model::did_you_mean(function.word, names));
}

} // namespace plprove::importers
