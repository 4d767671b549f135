#include "prover/model/operations.h"
#include "prover/model/program.h"

#include <algorithm>

namespace plprove::model {

namespace {

using Kind = Expression::Kind;

class Compiler {
public:
    explicit Compiler(Program& program) : program_(program), operations_(program) {}

    void run(const std::vector<Statement>& statements) {
        for (const Statement& statement : statements)
            execute(statement);
    }

private:
    void execute(const Statement& statement) {
        constexpr int most_executions = 100'000;
        if (++executions_ > most_executions)
            throw ModelError(statement.at, "the statements are executed more than 100,000 times: "
                                           "shorten the loops");
        switch (statement.kind) {
        case Statement::Kind::data:
        case Statement::Kind::unknown:
            return give_variables(statement);
        case Statement::Kind::let:
            return give_let(statement);
        case Statement::Kind::equation:
        case Statement::Kind::proportional:
        case Statement::Kind::relation:
            return add_equations(statement);
        case Statement::Kind::nonzero:
        case Statement::Kind::count:
            return add_list(statement);
        case Statement::Kind::loop:
            return run_loop(statement);
        }
    }

    void give_variables(const Statement& statement) {
        const bool data = statement.kind == Statement::Kind::data;
        std::size_t& count = data ? program_.data : program_.unknowns;
        const std::size_t most = data ? 1000 : 100;
        for (const Variable& variable : statement.variables) {
            std::size_t size = 1;
            for (const int n : variable.shape)
                size = std::min(size * static_cast<std::size_t>(n), most + 1);
            if (count + size > most)
                throw ModelError(variable.at, "a model has at most " + std::to_string(most) +
                                                  (data ? " scalars of data" : " unknown scalars"));
            Array value{variable.shape, {}};
            for (std::size_t i = 0; i < size; ++i) {
                value.scalars.push_back(program_.operations.size());
                program_.operations.push_back(
                    {data ? Operation::Kind::datum : Operation::Kind::unknown, true, count++, 0, 0,
                     false});
            }
            (data ? program_.data_names : program_.unknown_names).push_back({variable.name, value});
            values_.push_back({variable.name, value});
        }
    }

    void give_let(const Statement& statement) {
        Named value{statement.name, evaluate(statement.expressions[0])};
        if (depth_ == 0) {
            for (ScalarIndex& scalar : value.value.scalars)
                scalar = operations_.add(Operation::Kind::copy, scalar, scalar, statement.at);
            program_.lets.push_back(value);
        }
        values_.push_back(std::move(value));
    }

    void add_equations(const Statement& statement) {
        const Array left = evaluate(statement.expressions[0]);
        const Array right = evaluate(statement.expressions[1]);
        if (statement.kind == Statement::Kind::proportional)
            return add_proportional(left, right, statement.at);
        const bool relation = statement.kind == Statement::Kind::relation;
        for (const Expression& side : statement.expressions)
            if (relation) note_names(side, program_.related);
        const Array all = operations_.sum(Operation::Kind::difference, left, right, statement.at);
        for (const ScalarIndex scalar : all.scalars)
            (relation ? program_.relations : program_.equations).push_back({scalar, statement.at});
        limit_equations(statement.at);
    }

    void limit_equations(Position at) const {
        constexpr std::size_t most = 1000;
        if (program_.equations.size() + program_.relations.size() > most)
            throw ModelError(at,
                             "a model has at most 1,000 scalar equations: state a smaller problem");
    }

    void add_proportional(const Array& left, const Array& right, Position at) {
        if (left.shape.size() != 1 || left.shape != right.shape || left.shape[0] < 2)
            throw ModelError(at, "found " + describe_shape(left.shape) + " and " +
                                     describe_shape(right.shape) +
                                     ": ~ needs two vectors of one size, at least 2");
        const auto product = [&](std::size_t i, std::size_t j) {
            return operations_.add(Operation::Kind::product, left.scalars[i], right.scalars[j], at);
        };
        const std::size_t last = left.scalars.size() - 1;
        for (std::size_t k = 0; k < last; ++k)
            program_.equations.push_back({operations_.add(Operation::Kind::difference,
                                                          product(k, last), product(last, k), at),
                                          at});
        program_.conditions.push_back({left.scalars[last], at});
        program_.conditions.push_back({right.scalars[last], at});
        limit_equations(at);
    }

    void add_list(const Statement& statement) {
        const bool count = statement.kind == Statement::Kind::count;
        program_.counts = program_.counts || count;
        for (const Expression& expression : statement.expressions) {
            if (count) note_names(expression, program_.counted_names);
            for (const ScalarIndex scalar : evaluate(expression).scalars) {
                if (count)
                    program_.counted.push_back(scalar);
                else
                    program_.conditions.push_back({scalar, expression.at});
            }
        }
    }

    void run_loop(const Statement& statement) {
        const int first = evaluate(statement.first), last = evaluate(statement.last);
        const std::size_t kept = values_.size();
        ++depth_;
        for (int i = first; i <= last; ++i) {
            loops_.emplace_back(statement.name, i);
            run(statement.body);
            loops_.pop_back();
            values_.resize(kept);
        }
        --depth_;
    }

    /// Adds the names in an expression to a list, each once.
    static void note_names(const Expression& expression, std::vector<std::string>& names) {
        const bool known = std::ranges::find(names, expression.name) != names.end();
        if (expression.kind == Kind::name && !known) names.push_back(expression.name);
        for (const Expression& part : expression.parts)
            note_names(part, names);
    }

    int evaluate(const Index& index) const {
        constexpr int largest = 1'000'000'000;
        int value = 0;
        for (const Index::Term& term : index.terms) {
            value += term.sign * (is_constant(term.word) ? std::stoi(term.word) : loop(term.word));
            if (std::abs(value) > largest)
                throw ModelError(term.at, "the index is beyond 1,000,000,000: write a smaller one");
        }
        return value;
    }

    int loop(const std::string& name) const {
        const auto found =
            std::ranges::find(loops_, name, [](const auto& loop) { return loop.first; });
        return found->second;
    }

    Array evaluate(const Expression& expression) {
        const Position at = expression.at;
        if (expression.kind == Kind::constant)
            return {{},
                    {expression.number == 0 ? operations_.zero()
                                            : operations_.constant(expression.number)}};
        if (expression.kind == Kind::name) return value_of(expression);
        if (expression.kind == Kind::call && expression.name == "identity")
            return identity(expression);
        std::vector<Array> parts;
        for (const Expression& part : expression.parts)
            parts.push_back(evaluate(part));
        switch (expression.kind) {
        case Kind::call:
            return operations_.call(expression.name, parts, at);
        case Kind::array:
            return array_of(parts, expression);
        case Kind::item:
            return item(parts[0], expression);
        case Kind::sum:
            return operations_.sum(Operation::Kind::sum, parts[0], parts[1], at);
        case Kind::difference:
            return operations_.sum(Operation::Kind::difference, parts[0], parts[1], at);
        case Kind::negative:
            return operations_.negative(parts[0], at);
        case Kind::product:
            return operations_.product(parts[0], parts[1], at);
        case Kind::quotient:
            return quotient(parts, expression);
        default:
            return operations_.power(parts[0], expression.number, at);
        }
    }

    Array value_of(const Expression& expression) {
        const auto is_it = [&](const Named& value) { return value.name == expression.name; };
        if (const auto found = std::ranges::find_if(values_, is_it); found != values_.end())
            return found->value;
        return {{}, {signed_constant(loop(expression.name))}};
    }

    /// An integer that may be negative, as a loop's name.
    ScalarIndex signed_constant(int value) {
        const ScalarIndex size = operations_.constant(std::abs(value));
        if (value >= 0) return size;
        return operations_.add(Operation::Kind::difference, operations_.zero(), size, {});
    }

    Array identity(const Expression& expression) {
        const bool fits = expression.parts.size() == 1 &&
                          expression.parts[0].kind == Kind::constant &&
                          expression.parts[0].number >= 1 && expression.parts[0].number <= 100;
        if (!fits)
            throw ModelError(expression.at,
                             "identity needs one whole number from 1 to 100, such as identity(3)");
        return operations_.identity(expression.parts[0].number);
    }

    static Array array_of(const std::vector<Array>& items, const Expression& expression) {
        Array result{items[0].shape, {}};
        result.shape.insert(result.shape.begin(), static_cast<int>(items.size()));
        for (std::size_t i = 0; i < items.size(); ++i) {
            if (items[i].shape != items[0].shape)
                throw ModelError(expression.parts[i].at,
                                 "found " + describe_shape(items[i].shape) + " after " +
                                     describe_shape(items[0].shape) +
                                     ": the items between [ and ] need equal shapes");
            result.scalars.insert(result.scalars.end(), items[i].scalars.begin(),
                                  items[i].scalars.end());
        }
        return result;
    }

    Array item(const Array& array, const Expression& expression) const {
        if (array.shape.empty())
            throw ModelError(expression.at, "a scalar has no items: leave out the index");
        const int index = evaluate(expression.index);
        if (index < 1 || index > array.shape[0])
            throw ModelError(expression.at, "found the index " + std::to_string(index) + " of " +
                                                describe_shape(array.shape) +
                                                ": it goes from 1 to " +
                                                std::to_string(array.shape[0]));
        const auto size = static_cast<std::ptrdiff_t>(array.scalars.size()) / array.shape[0];
        const auto begin = array.scalars.begin() + (index - 1) * size;
        return {{array.shape.begin() + 1, array.shape.end()}, {begin, begin + size}};
    }

    Array quotient(const std::vector<Array>& parts, const Expression& expression) {
        const Expression& divisor = expression.parts[1];
        if (divisor.kind == Kind::constant && divisor.number == 0)
            throw ModelError(divisor.at, "this divides by 0: divide by something else");
        Array result = operations_.quotient(parts[0], parts[1], expression.at);
        if (divisor.kind != Kind::constant)
            program_.conditions.push_back({parts[1].scalars[0], expression.at});
        return result;
    }

    Program& program_;
    Operations operations_;
    std::vector<Named> values_;
    std::vector<std::pair<std::string, int>> loops_;
    int depth_ = 0; // of loops
    int executions_ = 0;
};

} // namespace

Program compile(const Model& model) {
    Program program;
    Compiler(program).run(model.statements);
    if (program.unknowns == 0)
        throw BadInput("the model has no unknown: add a line such as 'unknown x'");
    if (program.equations.empty())
        throw BadInput("the model has no equation: add a line such as 'equation x^2 = a'");
    return program;
}

} // namespace plprove::model
