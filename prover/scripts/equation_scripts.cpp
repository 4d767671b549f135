#include "prover/scripts/equation_scripts.h"

#include "prover/model/point_search.h"
#include "prover/model/small_modular.h"
#include "prover/scripts/layout.h"

#include <algorithm>
#include <functional>
#include <optional>

namespace plprove {

namespace {

using model::Model;
using model::Named;
using model::Operation;
using model::Program;
using model::ScalarIndex;
using Kind = Operation::Kind;

/// The name with `'u` or `_u` for each `_`, which is an operator of Macaulay2, and would make names
/// like those of arrays.
std::string without_underscores(const std::string& name, const std::string& mark) {
    std::string result;
    for (const char c : name)
        result += c == '_' ? mark + "u" : std::string(1, c);
    return result;
}

/// If the mark is `_`: `x_1_3` of x[1..6] : vector 3, and `f_` of a scalar. With its mark, no name
/// is a word of the language.
std::vector<std::string> names_of(const std::vector<Named>& arrays, const std::string& mark) {
    std::vector<std::string> names;
    for (const Named& array : arrays)
        for (std::size_t i = 0; i < array.value.scalars.size(); ++i) {
            std::string indices;
            std::size_t rest = i;
            for (auto n = array.value.shape.rbegin(); n != array.value.shape.rend(); ++n) {
                const auto size = static_cast<std::size_t>(*n);
                indices.insert(0, mark + std::to_string(rest % size + 1));
                rest /= size;
            }
            names.push_back(without_underscores(array.name, mark) +
                            (indices.empty() ? mark : indices));
        }
    return names;
}

/// Writes the scalars that equations and conditions need as assignments: each of an operation that
/// is used more than once. The others become parts of these.
class Assignments {
public:
    using Ratio = std::function<std::string(const std::string&, const std::string&)>;

    /// `mark` joins the parts of a name; `ratio` is how to write a quotient of integers; `more` are
    /// other scalars that the script needs.
    Assignments(const Program& program, std::string mark, Ratio ratio,
                const std::vector<ScalarIndex>& more = {})
        : program_(program), mark_(std::move(mark)), ratio_(std::move(ratio)),
          data_(names_of(program.data_names, mark_)),
          unknowns_(names_of(program.unknown_names, mark_)), uses_(program.operations.size(), 0),
          texts_(program.operations.size()) {
        for (const auto& equation : program.equations)
            count(equation.scalar);
        for (const auto& condition : program.conditions)
            count(condition.scalar);
        for (const ScalarIndex scalar : more)
            count(scalar);
        for (ScalarIndex i = 0; i < program.operations.size(); ++i)
            if (uses_[i] > 0) write(i);
    }

    const std::vector<std::string>& data() const { return data_; }
    const std::vector<std::string>& unknowns() const { return unknowns_; }
    /// The assignments, a line each.
    const std::string& text() const { return text_; }
    /// What has the value of the scalar.
    const std::string& of(ScalarIndex scalar) const { return texts_[scalar]; }
    /// The divisors with data or unknowns, each once.
    const std::vector<std::string>& divisors() const { return divisors_; }

private:
    static bool is_leaf(const Operation& operation) {
        return operation.kind == Kind::constant || operation.kind == Kind::zero ||
               operation.kind == Kind::datum || operation.kind == Kind::unknown;
    }

    bool is_constant(ScalarIndex i) const { return program_.operations[i].kind == Kind::constant; }

    void count(ScalarIndex scalar) {
        std::vector<ScalarIndex> open{scalar};
        while (!open.empty()) {
            const ScalarIndex i = open.back();
            open.pop_back();
            const Operation& operation = program_.operations[i];
            if (++uses_[i] > 1 || is_leaf(operation)) continue;
            open.push_back(operation.left);
            if (operation.kind != Kind::copy) open.push_back(operation.right);
        }
    }

    /// Leaves out what adds 0 or multiplies by 1.
    std::string expression(const Operation& operation) {
        const std::string &a = texts_[operation.left], &b = texts_[operation.right];
        switch (operation.kind) {
        case Kind::constant:
            return std::to_string(operation.left);
        case Kind::zero:
            return "0";
        case Kind::datum:
            return data_[operation.left];
        case Kind::unknown:
            return unknowns_[operation.left];
        case Kind::copy:
            return a;
        case Kind::sum:
            return a == "0" ? b : b == "0" ? a : "(" + a + " + " + b + ")";
        case Kind::difference:
            return b == "0" ? a : a == "0" ? "(-" + b + ")" : "(" + a + " - " + b + ")";
        case Kind::product:
            if (a == "0" || b == "0") return "0";
            return a == "1" ? b : b == "1" ? a : a + "*" + b;
        case Kind::quotient:
            if (is_constant(operation.left) && is_constant(operation.right)) return ratio_(a, b);
            return "(" + a + "/(" + b + "))";
        }
        return {};
    }

    void write(ScalarIndex i) {
        const Operation& operation = program_.operations[i];
        texts_[i] = expression(operation);
        if (operation.kind == Kind::quotient && operation.by_variable) {
            const std::string& divisor = texts_[operation.right];
            if (std::ranges::find(divisors_, divisor) == divisors_.end())
                divisors_.push_back(divisor);
        }
        constexpr std::size_t longest = 60;
        const bool is_name = texts_[i].find_first_of("+-*/") == std::string::npos;
        if (is_name || (uses_[i] == 1 && texts_[i].size() <= longest)) return;
        // Twice the mark: no array has such a name.
        const std::string name = "t" + mark_ + mark_ + std::to_string(++named_);
        text_ += name + " = " + texts_[i] + ";\n";
        texts_[i] = name;
    }

    const Program& program_;
    std::string mark_;
    Ratio ratio_;
    std::vector<std::string> data_, unknowns_;
    std::vector<int> uses_;
    std::vector<std::string> texts_;
    std::vector<std::string> divisors_;
    std::string text_;
    int named_ = 0;
};

std::vector<std::string> texts_of(const Assignments& values,
                                  const std::vector<model::Located>& scalars) {
    std::vector<std::string> texts;
    for (const model::Located& scalar : scalars)
        texts.push_back(values.of(scalar.scalar));
    return texts;
}

/// A model with the comments that it begins with.
struct Source {
    explicit Source(const std::string& text)
        : model(model::read_model(text)), program(model::compile(model)),
          comments(model::opening_comments(text)) {}

    Model model;
    Program program;
    std::vector<std::string> comments;
};

std::string opening(const Source& source, const std::string& sign, const std::string& what) {
    std::string text = comment(sign, "The model " + source.model.name);
    for (const std::string& line : source.comments)
        text += sign + (line.empty() ? "" : " " + line) + "\n";
    return text + sign + "\n" + comment(sign, what) + sign + "\n";
}

/// Data and, if it is known, a solution, modulo the prime of the script.
struct Example {
    std::vector<model::SmallModular> data;
    std::optional<std::vector<model::SmallModular>> solution;
};

Example example_of(const Source& source) {
    constexpr std::uint64_t stream = 0;
    model::RandomResidues random(source.model, stream);
    auto seen = model::search_points<model::SmallModular>(source.program, random);
    if (seen.best) return {std::move(seen.best->data), std::move(seen.best->unknowns)};
    return {model::random_numbers<model::SmallModular>(random, source.program.data), {}};
}

/// What `I` and `conditions` are, from which the rest of the script follows.
std::string macaulay2_equations(const Source& source, const Assignments& values,
                                const Example& example) {
    std::string text = "FF = ZZ/" + std::to_string(model::small_prime) + ";\nR = FF[\n" +
                       list(values.unknowns(), "    ") + "];\nF = frac R;\n\n-- the data\n";
    for (std::size_t i = 0; i < values.data().size(); ++i)
        text += values.data()[i] + " = " + std::to_string(example.data[i].value()) + "_F;\n";
    std::vector<std::string> conditions = texts_of(values, source.program.conditions);
    conditions.insert(conditions.end(), values.divisors().begin(), values.divisors().end());
    return text + "\n" + values.text() +
           "\npolynomial = f -> numerator promote(f, F);\nI = ideal apply({\n" +
           list(texts_of(values, source.program.equations), "    ") +
           "}, polynomial);\n-- what is not 0\nconditions = {" +
           (conditions.empty() ? "" : "\n" + list(conditions, "    ")) + "};\n";
}

const char* const rank_of_known_solution = R"script(
if not (known gens I == 0 and
        all(conditions, c -> known polynomial c != 0)) then error "the values are no solution";
rankJ = rank known jacobian I;
<< "equations  " << numgens I << endl;
<< "unknowns   " << numgens R << endl;
<< "rank       " << rankJ << ", at a known solution" << endl;
<< "minimal    " << (
    if rankJ < numgens R then "not shown: the known solution is not regular"
    else if numgens I > numgens R then "not shown: there are more equations than unknowns"
    else "yes: the known solution is regular") << endl;
)script";

/// With c = n/d at the known solution, d^2 times the gradient of c is that of n d(x) - n(x) d.
const char* const rank_of_what_counts = R"script(
rankC = rank known (jacobian I | jacobian ideal apply(counted, c -> (
    c = promote(c, F); numerator c*known denominator c - known numerator c*denominator c)));
<< "counted    " << (
    if rankJ < numgens I then "not shown: the equations depend on each other there"
    else if rankC > rankJ then "not shown: what counts varies with the unknowns there"
    else if rankJ == numgens R then "finitely many values"
    else "finitely many values, unless the random numbers are unlucky") << endl;
)script";

const char* const count = R"script(
-- The count may take long: to leave it out, remove all that follows.
scan(conditions, c -> I = saturate(I, ideal polynomial c));
<< "dimension  " << dim I << endl;
<< "solutions  " << degree I << endl;
)script";

std::string numbers(const std::vector<model::SmallModular>& values) {
    std::vector<std::string> texts;
    for (const model::SmallModular value : values)
        texts.push_back(std::to_string(value.value()));
    return list(texts, "    ");
}

} // namespace

std::string macaulay2_script(const std::string& model) {
    const Source source(model);
    const Assignments values(
        source.program, "'",
        [](const std::string& a, const std::string& b) { return "(" + a + "_F/" + b + ")"; },
        source.program.counted);
    const Example example = example_of(source);
    const std::string rank =
        "This script sets up the equations over a finite field, for data with a known solution, "
        "and computes the rank of their Jacobian matrix by the unknowns there. If the rank is the "
        "number of equations and of unknowns, this proves that the model is minimal. If it is less "
        "than the number of equations, the data may be special. Then the script";
    const std::string counting =
        " counts the zeros, where no condition and no denominator is 0. For other data there may "
        "be more or fewer zeros, if the random numbers are very unlucky. What a model counts only "
        "once, by a `count` statement, is counted as often as it is a zero.";
    std::string script =
        opening(source, "--",
                (example.solution ? rank
                                  : "This script sets up the equations over a finite field, for "
                                    "random data, and") +
                    counting) +
        "-- Run it with:  M2 --script FILE\n\n" + macaulay2_equations(source, values, example);
    if (!example.solution) return script + count;
    script += "\n-- A solution: the values of the unknowns.\nknown = map(FF, R, {\n" +
              numbers(*example.solution) + "});\n" + (rank_of_known_solution + 1);
    std::vector<std::string> counted;
    for (const ScalarIndex scalar : source.program.counted)
        counted.push_back(values.of(scalar));
    if (!counted.empty())
        script += "\n-- What counts: solutions with the same values are one.\ncounted = {\n" +
                  list(counted, "    ") + "};\n" + (rank_of_what_counts + 1);
    return script + count;
}

std::string julia_script(const std::string& model) {
    const Source source(model);
    const Assignments values(source.program, "_", [](const std::string& a, const std::string& b) {
        return "(" + a + "//" + b + ")";
    });
    const auto variables = [](const std::vector<std::string>& names) {
        std::string text = "@var";
        for (const std::string& name : names)
            text += " " + name;
        return text + "\n";
    };
    std::string script =
        opening(source, "#",
                "This script sets up the equations with the data as parameters, and finds their "
                "zeros for random data by monodromy. It may take long, and it may stop too early. "
                "Zeros at which a condition is 0 do not count.") +
        "using HomotopyContinuation\n\n" + variables(values.unknowns()) + variables(values.data()) +
        "\n" + values.text() + "\nequations = [\n" +
        list(texts_of(values, source.program.equations), "    ") + "]\nunknowns = [\n" +
        list(values.unknowns(), "    ") + "]\ndata = [\n" + list(values.data(), "    ") +
        "]\nsystem = System(equations; variables = unknowns, parameters = data)\n" +
        "result = monodromy_solve(system)\n";
    const std::vector<std::string> conditions = texts_of(values, source.program.conditions);
    if (conditions.empty()) return script + "println(nsolutions(result))\n";
    return script + "# what is not 0\nconditions = System([\n" + list(conditions, "    ") +
           "]; variables = unknowns, parameters = data)\n" +
           "counts(z) = minimum(abs, conditions(z, parameters(result))) > 1e-8\n" +
           "println(count(counts, solutions(result)))\n";
}

} // namespace plprove
