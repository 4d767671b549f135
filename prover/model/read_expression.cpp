#include "prover/model/read_expression.h"

#include <algorithm>

namespace plprove::model {

namespace {

using Kind = Expression::Kind;

/// Reads by recursive descent: a function a rule of the grammar.
class Reader {
public:
    Reader(Cursor& cursor, const Names& names) : cursor_(cursor), names_(names) {}

    Expression sum() {
        constexpr int deepest = 200;
        if (++depth_ > deepest)
            throw ModelError(cursor_.at(), "more than 200 brackets are open: use let statements");
        const Position at = cursor_.at();
        Expression left = cursor_.skip("-") ? unary(Kind::negative, at, product()) : product();
        while (cursor_.is("+") || cursor_.is("-")) {
            const Position here = cursor_.at();
            const Kind kind = cursor_.take() == "+" ? Kind::sum : Kind::difference;
            left = binary(kind, here, std::move(left), product());
        }
        --depth_;
        return left;
    }

private:
    static Expression unary(Kind kind, Position at, Expression part) {
        Expression result{
            .kind = kind, .at = at, .name = {}, .number = 0, .parts = {}, .index = {}};
        result.parts.push_back(std::move(part));
        return result;
    }

    static Expression binary(Kind kind, Position at, Expression left, Expression right) {
        Expression result = unary(kind, at, std::move(left));
        result.parts.push_back(std::move(right));
        return result;
    }

    Expression product() {
        Expression left = power();
        while (cursor_.is("*") || cursor_.is("/")) {
            const Position here = cursor_.at();
            const Kind kind = cursor_.take() == "*" ? Kind::product : Kind::quotient;
            left = binary(kind, here, std::move(left), power());
        }
        return left;
    }

    Expression power() {
        constexpr int largest_exponent = 20;
        Expression base = atom();
        const Position here = cursor_.at();
        if (!cursor_.skip("^")) return base;
        Expression result = unary(Kind::power, here, std::move(base));
        result.number = cursor_.integer(1, largest_exponent);
        return result;
    }

    Expression atom() {
        Expression result = atom_without_index();
        while (cursor_.is("[")) {
            const Position here = cursor_.at();
            cursor_.take();
            Expression item = unary(Kind::item, here, std::move(result));
            item.index = read_index(cursor_, names_);
            cursor_.expect("]");
            result = std::move(item);
        }
        return result;
    }

    Expression atom_without_index() {
        const Position at = cursor_.at();
        if (cursor_.skip("(")) {
            Expression inner = sum();
            cursor_.expect(")");
            return inner;
        }
        Expression result{
            .kind = Kind::constant, .at = at, .name = {}, .number = 0, .parts = {}, .index = {}};
        const std::string word = cursor_.word();
        if (cursor_.skip("[")) {
            result.kind = Kind::array;
            result.parts = list("]");
        } else if (is_constant(word)) {
            result.number = std::stoi(cursor_.take());
        } else if (is_name(word)) {
            result.name = cursor_.take();
            if (cursor_.skip("("))
                read_call(result);
            else
                read_name(result);
        } else {
            fail_on_number(word);
        }
        return result;
    }

    [[noreturn]] void fail_on_number(const std::string& word) const {
        const bool number = !word.empty() && word.front() >= '0' && word.front() <= '9';
        cursor_.fail(number ? "a whole number from 0 to 999999" : "a number, a name, ( or [");
    }

    void read_name(Expression& result) const {
        result.kind = Kind::name;
        const auto& functions = function_names();
        if (std::ranges::find(functions, result.name) != functions.end())
            cursor_.fail("'(' after the function " + result.name);
        names_.all.require(result.name, result.at);
    }

    void read_call(Expression& result) {
        result.kind = Kind::call;
        const auto& functions = function_names();
        if (std::ranges::find(functions, result.name) == functions.end())
            throw ModelError(result.at, "found " + in_quotes(result.name) +
                                            ", which is no function" + advice_on(result.name));
        result.parts = list(")");
    }

    std::string advice_on(const std::string& name) const {
        if (names_.all.has(name)) return ": write * between factors, and [ ] around an index";
        const std::string advice = did_you_mean(name, function_names());
        return advice.empty() ? ": there are dot, norm2, cross, skew, det, trace, transpose, "
                                "identity and rotation"
                              : advice;
    }

    std::vector<Expression> list(const std::string& closing) {
        std::vector<Expression> items;
        do
            items.push_back(sum());
        while (cursor_.skip(","));
        if (!cursor_.skip(closing)) cursor_.fail("an operator, ',' or '" + closing + "'");
        return items;
    }

    Cursor& cursor_;
    const Names& names_;
    int depth_ = 0;
};

} // namespace

Expression read_sum(Cursor& cursor, const Names& names) {
    return Reader(cursor, names).sum();
}

Index read_index(Cursor& cursor, const Names& names) {
    Index index;
    for (int sign = 1; sign != 0;) {
        const Position at = cursor.at();
        const std::string word = cursor.word();
        if (!is_constant(word) && !names.loops.has(word))
            cursor.fail("a whole number or the name of a loop",
                        did_you_mean(word, names.loops.names()));
        index.terms.push_back({sign, cursor.take(), at});
        sign = cursor.skip("+") ? 1 : cursor.skip("-") ? -1 : 0;
    }
    return index;
}

} // namespace plprove::model
