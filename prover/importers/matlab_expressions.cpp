#include "prover/importers/matlab_expressions.h"

#include "prover/importers/matlab_functions.h"
#include "prover/importers/setting.h"
#include "prover/system/words.h"

#include <algorithm>
#include <utility>

namespace plprove::importers {

namespace {

using model::ModelError;
using model::Position;
using Kind = Token::Kind;

Array truth(bool value) {
    return Array::scalar(constant(value ? 1 : 0));
}

long integer(const Array& array, Position at) {
    const std::optional<long> value =
        array.is_scalar() ? integer_of(array.entries[0]) : std::nullopt;
    if (!value) throw ModelError(at, "expected a whole number that the program says");
    return *value;
}

} // namespace

Array MatlabExpressions::read(const std::string& target) {
    target_ = target;
    depth_ = 0;
    spaces_separate_ = false;
    end_.reset();
    return range();
}

bool MatlabExpressions::condition() {
    target_ = "data";
    depth_ = 0;
    const Position at = tokens_.here().at;
    return integer(disjunction(), at) != 0;
}

Array MatlabExpressions::disjunction() {
    Array left = conjunction();
    while (tokens_.is("||")) {
        const Position at = tokens_.take().at;
        const Array right = conjunction();
        left = truth(integer(left, at) != 0 || integer(right, at) != 0);
    }
    return left;
}

Array MatlabExpressions::conjunction() {
    Array left = comparison();
    while (tokens_.is("&&")) {
        const Position at = tokens_.take().at;
        const Array right = comparison();
        left = truth(integer(left, at) != 0 && integer(right, at) != 0);
    }
    return left;
}

Array MatlabExpressions::comparison() {
    if (tokens_.is("~")) {
        const Position at = tokens_.take().at;
        return truth(integer(comparison(), at) == 0);
    }
    const Array left = range();
    for (const char* sign : {"==", "~=", "<=", ">=", "<", ">"}) {
        if (!tokens_.is(sign)) continue;
        const Position at = tokens_.take().at;
        const long a = integer(left, at), b = integer(range(), at);
        const std::string_view word = sign;
        const bool has_equal = word != "~=" && word[word.size() - 1] == '=';
        return truth(word == "~=" ? a != b
                                  : (has_equal && a == b) || (word[0] == '<' && a < b) ||
                                        (word[0] == '>' && a > b));
    }
    return left;
}

/// a:b and a:step:b are rows of integers.
Array MatlabExpressions::range() {
    constexpr int deepest = 150;
    if (++depth_ > deepest)
        throw ModelError(tokens_.here().at, "more than 150 brackets are open: give names to parts");
    Array first = sum();
    --depth_;
    if (!tokens_.is(":")) return first;
    const Position at = tokens_.take().at;
    long step = 1, last = integer(sum(), at);
    if (tokens_.skip(":")) step = std::exchange(last, integer(sum(), at));
    if (step == 0) throw ModelError(at, "a range has a step");
    Array result{1, 0, {}};
    for (long i = integer(first, at); step > 0 ? i <= last : i >= last; i += step) {
        refuse_large(1, ++result.columns, at);
        result.entries.push_back(constant(i));
    }
    return result;
}

/// Between [ and ], `a -b` are two items, and `a - b` is one.
bool MatlabExpressions::begins_item() const {
    return spaces_separate_ && tokens_.here().after_space && !tokens_.next().after_space;
}

Array MatlabExpressions::sum() {
    Array left = product();
    while ((tokens_.is("+") || tokens_.is("-")) && !begins_item()) {
        const Token sign = tokens_.take();
        left = entrywise(left, product(), sign.at, sign.word == "+" ? sum_of : difference_of);
    }
    return left;
}

Array MatlabExpressions::product() {
    Array left = signed_power();
    while (tokens_.is("*") || tokens_.is(".*") || tokens_.is("/") || tokens_.is("./")) {
        const Token sign = tokens_.take();
        const Array right = signed_power();
        if (sign.word == "*")
            left = matrix_product(left, right, sign.at);
        else if (sign.word == "/" && !right.is_scalar())
            throw ModelError(sign.at, "found " + description(right) + ": only scalars divide");
        else
            left = entrywise(left, right, sign.at, sign.word == ".*" ? product_of : quotient_of);
    }
    return left;
}

Array MatlabExpressions::signed_power() {
    constexpr int deepest = 150;
    if (!tokens_.is("-") && !tokens_.is("+")) return power();
    const Token sign = tokens_.take();
    if (++depth_ > deepest) throw ModelError(sign.at, "more than 150 signs follow each other");
    const Array value = signed_power();
    --depth_;
    return sign.word == "-" ? entrywise(Array::scalar(constant(-1)), value, sign.at, product_of)
                            : value;
}

Array MatlabExpressions::power() {
    Array base = postfix();
    while (tokens_.is("^") || tokens_.is(".^")) {
        const Token sign = tokens_.take();
        const Array exponent = postfix();
        base = sign.word == "^" ? matrix_power(base, exponent, sign.at)
                                : entrywise(base, exponent, sign.at, power_of);
    }
    return base;
}

Array MatlabExpressions::postfix() {
    Array value = atom();
    while ((tokens_.is("'") || tokens_.is(".'")) && !tokens_.here().after_space) {
        tokens_.take();
        value = transposed(value);
    }
    return value;
}

Array MatlabExpressions::atom() {
    const Token& here = tokens_.here();
    if (here.kind == Kind::number) {
        const Token taken = tokens_.take();
        return Array::scalar(number(taken.word, taken.at));
    }
    if (here.kind == Kind::name) return name();
    if (tokens_.skip("[")) return matrix();
    if (tokens_.skip("(")) {
        const Setting separate(spaces_separate_, false);
        Array value = disjunction();
        tokens_.expect(")");
        return value;
    }
    tokens_.fail("a number, a name or a bracket");
}

std::vector<Array> MatlabExpressions::row() {
    std::vector<Array> items;
    while (!tokens_.is(";") && !tokens_.is(Kind::new_line) && !tokens_.is("]")) {
        items.push_back(range());
        const bool ends = tokens_.is(";") || tokens_.is(Kind::new_line) || tokens_.is("]");
        if (!tokens_.skip(",") && !ends && !tokens_.here().after_space)
            tokens_.fail("an operator, ',', ';' or ']'");
    }
    return items;
}

Array MatlabExpressions::matrix() {
    const Setting separate(spaces_separate_, true);
    const Position at = tokens_.here().at;
    std::vector<Array> rows;
    while (!tokens_.skip("]")) {
        rows.push_back(beside(row(), at));
        if (!tokens_.is("]")) tokens_.take();
    }
    return below(rows, at);
}

/// Whether indices or arguments follow: between [ and ], `a (1)` are two items.
bool MatlabExpressions::has_bracket() const {
    return tokens_.is("(") && !(spaces_separate_ && tokens_.here().after_space);
}

Array MatlabExpressions::name() {
    const Token token = tokens_.take();
    if (token.word == "end" && end_) return Array::scalar(constant(*end_));
    const auto found = values.find(token.word);
    if (found == values.end()) return function(token);
    if (!has_bracket()) return found->second;
    const Array& array = found->second;
    return part(array, indices(array), token.at);
}

/// How many arguments the bracket here has, which is closed.
std::size_t MatlabExpressions::arguments_ahead() {
    const std::size_t place = tokens_.place();
    std::size_t commas = 0;
    int open = 0;
    do {
        if (tokens_.is("(") || tokens_.is("[") || tokens_.is("{")) ++open;
        if (tokens_.is(")") || tokens_.is("]") || tokens_.is("}")) --open;
        if (tokens_.is(",") && open == 1) ++commas;
        tokens_.take();
    } while (open > 0);
    tokens_.go_to(place);
    return commas + 1;
}

std::vector<Index> MatlabExpressions::indices(const Array& of) {
    const Setting separate(spaces_separate_, false);
    const Position at = tokens_.here().at;
    const std::size_t count = arguments_ahead();
    if (count > 2)
        throw ModelError(at,
                         "found " + std::to_string(count) + " indices: arrays to import have two");
    tokens_.expect("(");
    std::vector<Index> result;
    for (std::size_t which = 0; which < count; ++which) {
        if (which > 0) tokens_.expect(",");
        result.push_back(index(of, which, count));
    }
    tokens_.expect(")");
    return result;
}

Index MatlabExpressions::index(const Array& of, std::size_t which, std::size_t count) {
    const std::size_t size = count == 1 ? of.size() : which == 0 ? of.rows : of.columns;
    const Setting last(end_, std::optional(static_cast<long>(size)));
    Index result;
    const Position at = tokens_.here().at;
    if (tokens_.is(":") && (tokens_.next().word == "," || tokens_.next().word == ")")) {
        tokens_.take();
        for (std::size_t i = 0; i < size; ++i)
            result.places.push_back(i);
        result.all = true;
        return result;
    }
    const Array places = range();
    result.rows = places.rows;
    result.columns = places.columns;
    for (const Value& place : places.entries) {
        const long number = integer(Array::scalar(place), at);
        if (number < 1)
            throw ModelError(at,
                             "found the index " + std::to_string(number) + ": the first one is 1");
        result.places.push_back(static_cast<std::size_t>(number - 1));
    }
    return result;
}

std::vector<MatlabExpressions::Argument> MatlabExpressions::arguments() {
    const Setting separate(spaces_separate_, false);
    const Setting last(end_, std::optional<long>());
    std::vector<Argument> result;
    tokens_.expect("(");
    while (!tokens_.skip(")")) {
        Argument argument;
        if (tokens_.is(Kind::text)) {
            const std::string text = tokens_.take().word;
            argument.text = text.substr(1, text.size() - 2);
        } else {
            argument.value = range();
        }
        result.push_back(std::move(argument));
        if (!tokens_.skip(",") && !tokens_.is(")")) tokens_.fail("an operator, ',' or ')'");
    }
    return result;
}

/// Of `(name ...)`, as isempty and exist have it: whether the variable has entries.
bool MatlabExpressions::is_given() {
    tokens_.expect("(");
    std::string name = tokens_.take().word;
    std::erase(name, '\'');
    while (!tokens_.is(")") && !tokens_.at_end_of_statement())
        tokens_.take();
    tokens_.expect(")");
    const auto found = values.find(name);
    return found != values.end() && found->second.size() > 0;
}

Array MatlabExpressions::function(const Token& name) {
    if (name.word == "isempty" && tokens_.is("(")) return truth(!is_given());
    if (name.word == "exist" && tokens_.is("(")) return truth(is_given());
    if (const auto failed = failures.find(name.word); failed != failures.end())
        throw failed->second;
    if (!MatlabSymbols::has_function(name.word) && !is_matlab_function(name.word))
        refuse_name(name);
    std::vector<Array> arrays;
    std::string text;
    if (has_bracket())
        for (Argument& argument : arguments()) {
            if (argument.text.empty()) arrays.push_back(std::move(argument.value));
            if (text.empty()) text = argument.text;
        }
    const std::optional<Array> made = symbols_.call(name.word, text, arrays, target_, name.at);
    return made ? *made : matlab_function(name.word, arrays, draft_, name.at);
}

void MatlabExpressions::refuse_name(const Token& name) const {
    const std::string program = "found " + in_quotes(name.word);
    if (tokens_.is("("))
        throw ModelError(name.at, program + ", which is no function that is imported: write out "
                                            "what it does");
    std::vector<std::string> names;
    for (const auto& [variable, value] : values)
        names.push_back(variable);
    throw ModelError(name.at,
                     program + ", which has no value" + model::did_you_mean(name.word, names));
}

} // namespace plprove::importers
