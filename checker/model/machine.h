// Executes a model over a ring (FORMAT.md, section 16): what its equations, conditions and counts
// are at given data and unknowns.
#pragma once

#include "checker/model/functions.h"
#include "checker/model/program.h"

#include <cstdlib>
#include <functional>
#include <utility>

namespace checker {
/// Values of names, as far as they are given; data and unknowns all are.
template <class Ring> using Given = std::map<std::string, std::vector<typename Ring::Element>>;

/// The numerators of what a model says, and the scalars that count.
template <class Ring> struct Outcome {
    using Element = typename Ring::Element;
    std::vector<Element> equations{};
    std::vector<Element> relations{};
    std::vector<Element> conditions{};
    std::vector<Fraction<Element>> counted{};
    std::vector<Element> divisors{}; // of all divisions, by their numbers
};

template <class Ring> class Machine {
public:
    using Scalar = Fraction<typename Ring::Element>;
    using Value = Array<Scalar>;

    Machine(Ring& ring, const Given<Ring>& given) : arrays_(ring), given_(given) {}

    /// Throws Malformed where the statements make no sense, with the line.
    Outcome<Ring> run(const Program& program) {
        execute(program.statements);
        outcome_.divisors = arrays_.scalars.divisors();
        return std::move(outcome_);
    }

    /// How many scalars the values of all names have that are defined outside of loops.
    std::map<std::string, std::size_t> sizes() const {
        std::map<std::string, std::size_t> all;
        for (const auto& [name, value] : values_)
            all[name] = value.items.size();
        return all;
    }

private:
    using Kind = Expression::Kind;

    void execute(const std::vector<Statement>& statements) {
        for (const Statement& statement : statements) {
            try {
                if (++executed_ > 100'000)
                    throw Senseless{"more than 100,000 statements to execute"};
                execute(statement);
            } catch (const Senseless& senseless) {
                throw Malformed{{statement.line, senseless.reason}};
            }
        }
    }

    void execute(const Statement& statement) {
        const auto& parts = statement.parts;
        switch (statement.kind) {
        case Statement::Kind::data:
        case Statement::Kind::unknown:
            return define(statement.name, given(statement.name, statement.shape));
        case Statement::Kind::let: {
            Value value = evaluate(parts[0]);
            if (!in_loop_ && given_.contains(statement.name))
                value = given(statement.name, value.shape);
            return define(statement.name, std::move(value));
        }
        case Statement::Kind::equal:
            return add_differences(outcome_.equations, parts);
        case Statement::Kind::relation:
            return add_differences(outcome_.relations, parts);
        case Statement::Kind::proportional:
            return add_proportion(evaluate(parts[0]), evaluate(parts[1]));
        case Statement::Kind::nonzero:
            for (const Expression& part : parts)
                for (const Scalar& scalar : evaluate(part).items)
                    outcome_.conditions.push_back(scalar.numerator);
            return;
        case Statement::Kind::count:
            for (const Expression& part : parts)
                for (Scalar& scalar : evaluate(part).items)
                    outcome_.counted.push_back(std::move(scalar));
            return;
        case Statement::Kind::loop:
            return repeat(statement);
        }
    }

    /// Another number of elements than the shape has belongs to another statement of the name.
    Value given(const std::string& name, const std::vector<std::size_t>& shape) const {
        Value value{.shape = shape};
        for (const auto& element : given_.at(name))
            value.items.push_back({.numerator = element});
        const auto size =
            std::accumulate(shape.begin(), shape.end(), std::size_t{1}, std::multiplies<>());
        if (value.items.size() != size) throw Senseless{say("`", name, "` has a meaning already")};
        return value;
    }

    void define(const std::string& name, Value value) {
        require_new(name);
        values_[name] = std::move(value);
    }

    void require_new(const std::string& name) const {
        if (values_.contains(name) || loops_.contains(name))
            throw Senseless{say("`", name, "` has a meaning already")};
    }

    void add_differences(std::vector<typename Ring::Element>& list,
                         const std::vector<Expression>& sides) {
        const Value difference = arrays_.subtract(evaluate(sides[0]), evaluate(sides[1]));
        for (const Scalar& scalar : difference.items)
            list.push_back(scalar.numerator);
    }

    void add_proportion(const Value& u, const Value& v) {
        Arrays<Ring>::require(u.is_vector() && u.shape == v.shape && u.shape[0] > 1,
                              "`~` needs two vectors of one size, two or more");
        const auto& scalars = arrays_.scalars;
        const Scalar &last_u = u.items.back(), &last_v = v.items.back();
        for (std::size_t k = 0; k + 1 < u.items.size(); ++k)
            outcome_.equations.push_back(scalars
                                             .subtract(scalars.multiply(u.items[k], last_v),
                                                       scalars.multiply(last_u, v.items[k]))
                                             .numerator);
        outcome_.conditions.push_back(last_u.numerator);
        outcome_.conditions.push_back(last_v.numerator);
    }

    void repeat(const Statement& loop) {
        require_new(loop.name);
        const bool outer = std::exchange(in_loop_, true);
        const std::int64_t first = index(loop.parts[0]), last = index(loop.parts[1]);
        for (std::int64_t i = first; i <= last; ++i) {
            loops_[loop.name] = i;
            const std::size_t before = executed_;
            execute(loop.body);
            for (const Statement& inner : loop.body)
                if (inner.kind == Statement::Kind::let) values_.erase(inner.name);
            if (executed_ == before) break; // an empty loop
        }
        loops_.erase(loop.name);
        in_loop_ = outer;
    }

    std::int64_t index(const Expression& e) const {
        if (e.kind == Kind::constant) return e.number;
        if (e.kind == Kind::minus) return -index(e.parts[0]);
        if (e.kind == Kind::sum) {
            std::int64_t sum = 0;
            for (const Expression& part : e.parts)
                sum += index(part);
            if (std::abs(sum) > 1'000'000) throw Senseless{"an index larger than 1,000,000"};
            return sum;
        }
        const auto loop = loops_.find(e.name);
        if (loop == loops_.end()) throw Senseless{say("`", e.name, "` is the name of no loop")};
        return loop->second;
    }

    Value evaluate(const Expression& e) {
        switch (e.kind) {
        case Kind::constant:
            return arrays_.number(e.number);
        case Kind::name:
            return value_of(e.name);
        case Kind::call:
            return call(e);
        case Kind::list:
            return arrays_.list(evaluate_all(e.parts));
        case Kind::item:
            return item(e);
        case Kind::minus:
            return arrays_.negative(evaluate(e.parts[0]));
        case Kind::over:
            break; // a factor of a product, below
        case Kind::power:
            return arrays_.power(evaluate(e.parts[0]), e.number);
        case Kind::sum: {
            Value sum = evaluate(e.parts[0]);
            for (std::size_t i = 1; i < e.parts.size(); ++i)
                sum = arrays_.add(std::move(sum), evaluate(e.parts[i]));
            return sum;
        }
        case Kind::product:
            break;
        }
        Value product = evaluate(e.parts[0]);
        for (std::size_t i = 1; i < e.parts.size(); ++i)
            product = e.parts[i].kind == Kind::over
                          ? arrays_.divide(product, evaluate_divisor(e.parts[i].parts[0]))
                          : arrays_.multiply(product, evaluate(e.parts[i]));
        return product;
    }

    /// A divisor that is no constant other than 0 is a condition, too.
    Value evaluate_divisor(const Expression& e) {
        Value divisor = evaluate(e);
        if (divisor.is_scalar() && !divisor.items[0].is_constant)
            outcome_.conditions.push_back(divisor.items[0].numerator);
        return divisor;
    }

    std::vector<Value> evaluate_all(const std::vector<Expression>& parts) {
        std::vector<Value> values;
        for (const Expression& part : parts)
            values.push_back(evaluate(part));
        return values;
    }

    Value value_of(const std::string& name) const {
        if (const auto loop = loops_.find(name); loop != loops_.end())
            return arrays_.number(static_cast<int>(loop->second));
        const auto value = values_.find(name);
        if (value == values_.end()) throw Senseless{say("`", name, "` has no meaning here")};
        return value->second;
    }

    Value item(const Expression& e) {
        Value value = evaluate(e.parts[0]);
        for (std::size_t i = 1; i < e.parts.size(); ++i)
            value = arrays_.item(value, index(e.parts[i]));
        return value;
    }

    Value call(const Expression& e) {
        if (e.name == "identity") {
            if (e.parts.size() != 1 || e.parts[0].kind != Kind::constant || e.parts[0].number < 1 ||
                e.parts[0].number > 100)
                throw Senseless{"`identity` needs a constant from 1 to 100"};
            return arrays_.identity(static_cast<std::size_t>(e.parts[0].number));
        }
        auto [value, condition] = arrays_.call(e.name, evaluate_all(e.parts));
        if (condition) outcome_.conditions.push_back(condition->numerator);
        return value;
    }

    Arrays<Ring> arrays_;
    const Given<Ring>& given_;
    std::map<std::string, Value> values_{};
    std::map<std::string, std::int64_t> loops_{};
    bool in_loop_ = false;
    std::size_t executed_ = 0;
    Outcome<Ring> outcome_{};
};
} // namespace checker
