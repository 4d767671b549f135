#include "prover/model/template_python.h"

#include "prover/model/straight_line_text.h"

#include <algorithm>
#include <array>
#include <functional>
#include <map>

namespace plprove::model {

namespace {

constexpr std::size_t page_columns = 100;

/// What Python does not take as an argument of `residuals` gets a `_` at its end.
std::string python_name(const std::string& name) {
    static constexpr std::array taken{
        "False",     "None",     "True",     "and",    "as",   "assert", "async", "await",
        "break",     "class",    "continue", "def",    "del",  "elif",   "else",  "except",
        "finally",   "for",      "from",     "global", "if",   "import", "in",    "is",
        "lambda",    "nonlocal", "np",       "not",    "or",   "pass",   "raise", "return",
        "solutions", "try",      "while",    "with",   "yield"};
    return std::ranges::find(taken, name) == taken.end() ? name : name + "_";
}

/// Items with commas, in lines of the page that begin with some spaces; a comma ends the last.
std::string wrapped(const std::vector<std::string>& items, std::size_t spaces = 4) {
    const std::string indent(spaces, ' ');
    std::string text, line = indent;
    for (const std::string& item : items) {
        if (line != indent && line.size() + item.size() + 2 > page_columns) {
            text += line + '\n';
            line = indent;
        }
        line += (line == indent ? "" : " ") + item + ",";
    }
    return text + line + '\n';
}

std::string joined(const std::vector<std::string>& items) {
    std::string text;
    for (const std::string& item : items)
        text += (text.empty() ? "" : ", ") + item;
    return text;
}

template <class Number>
std::string list(const std::vector<Number>& numbers) {
    std::string text;
    for (const Number number : numbers)
        text += (text.empty() ? "" : ",") + std::to_string(number);
    return "[" + text + "]";
}

std::string shape(const std::vector<int>& sizes) {
    std::string text;
    for (const int size : sizes)
        text += (text.empty() ? "" : ", ") + std::to_string(size);
    return "(" + text + (sizes.size() == 1 ? ",)" : ")");
}

/// A dictionary: the names as `written`, and their shapes.
template <class Written>
std::string shapes(const std::vector<Named>& names, const Written& written) {
    std::vector<std::string> items;
    for (const Named& named : names)
        items.push_back("\"" + written(named.name) + "\": " + shape(named.value.shape));
    return "{" + joined(items) + "}";
}

/// Distinct values and their numbers, as they come.
template <class Value>
class Numbers {
public:
    std::size_t operator()(const Value& value) {
        const auto [place, is_new] = numbers_.emplace(value, values_.size());
        if (is_new) values_.push_back(value);
        return place->second;
    }
    const std::vector<Value>& values() const { return values_; }

private:
    std::map<Value, std::size_t> numbers_;
    std::vector<Value> values_;
};

constexpr const char* solver = R"(

def named(solutions):
    """The columns of solutions as arrays, by the names of VARIABLES: {name: (n, *shape)}."""
    ends = np.cumsum([np.prod(shape, dtype=int) for shape in VARIABLES.values()])
    parts = np.split(solutions, ends[:-1], axis=1)
    return {name: part.reshape(-1, *shape) for (name, shape), part in zip(VARIABLES.items(), parts)}


def real(solutions, tolerance=1e-6):
    """Those solutions whose imaginary parts are small beside them, without these parts."""
    size = 1 + np.abs(solutions).max(axis=1)
    return solutions.real[np.abs(solutions.imag).max(axis=1) <= tolerance * size]


def _flat(**data):
    flat = []
    for name, value in data.items():
        array = np.asarray(value, dtype=float)
        if array.shape != DATA[name]:
            raise ValueError(f"{name} has the shape {array.shape}: give the shape {DATA[name]}")
        flat.append(array.ravel().tolist())
    return flat


def _solve(coefficients):
    coefficients = np.array(coefficients, dtype=float)
    matrix = np.zeros((len(_ROWS), len(_ROWS) + _BASIS + 1))
    matrix[_ROW, _COLUMN] = coefficients[_SOURCE]
    matrix = matrix[:, :-1] / np.abs(matrix).max(axis=1, keepdims=True)
    eliminated, basis = np.split(matrix, [len(_ROWS)], axis=1)
    # Each monomial of a column, as a sum of those of the basis.
    expressed = np.vstack([np.linalg.solve(eliminated, -basis), np.eye(_BASIS)])
    # The monomials of the basis, at a solution, are an eigenvector of each multiplication.
    multiplication = sum(factor * expressed[products] for _, factor, products in _ACTION)
    values, vectors = np.linalg.eig(multiplication)
    solutions = (expressed[_VARIABLES] @ (vectors / (expressed[_ONE] @ vectors))).T.astype(complex)
    if len(_ACTION) == 1:  # then the eigenvalues are values of a variable, and more accurate
        solutions[:, _ACTION[0][0]] = values
    for _ in range(STEPS):
        solutions = _refined(solutions, _by_monomials(coefficients))
    return solutions


def _by_monomials(coefficients):
    """The equations, by rows, as sums of monomials."""
    matrix = np.zeros((len(_EQUATIONS), len(_EXPONENTS)))
    for row, (monomials, sources) in zip(matrix, _EQUATIONS):
        row[monomials] = np.array(coefficients, dtype=float)[sources]
    return matrix


def _monomials(solutions, exponents):
    powers = [np.ones_like(solutions)]
    for _ in range(exponents.max()):
        powers.append(powers[-1] * solutions)
    return np.prod(np.array(powers)[exponents, :, np.arange(exponents.shape[1])], axis=1).T


def _residuals(solutions, equations):
    """And the sizes of equations: the sums of the sizes of terms, of variables from 1 up."""
    sizes = _monomials(np.maximum(np.abs(solutions), 1), _EXPONENTS) @ np.abs(equations).T
    return _monomials(solutions, _EXPONENTS) @ equations.T / sizes, sizes


def _refined(solutions, equations):
    """A step of Newton's method, for those that it brings nearer."""
    values, sizes = _residuals(solutions, equations)
    derivatives = [
        _monomials(solutions, np.maximum(_EXPONENTS - unit, 0)) @ (equations * exponents).T / sizes
        for unit, exponents in zip(np.eye(_EXPONENTS.shape[1], dtype=int), _EXPONENTS.T)
    ]
    jacobians = np.stack(derivatives, axis=2)
    stepped = solutions - (np.linalg.pinv(jacobians) @ values[..., None])[..., 0]
    after = _residuals(stepped, equations)[0]
    nearer = np.abs(after).max(axis=1) < np.abs(values).max(axis=1)
    return np.where(nearer[:, None], stepped, solutions)


)";

constexpr const char* index_arrays =
    R"(_ROW = np.repeat(np.arange(len(_ROWS)), [len(columns) for _, columns in _ROWS])
_COLUMN = np.concatenate([columns for _, columns in _ROWS])
_SOURCE = np.concatenate([_EQUATIONS[equation][1] for equation, _ in _ROWS])
)";

std::string documentation(const Study& study, const EliminationTemplate& table,
                          const std::string& arguments) {
    const std::string& name = study.model.name;
    const std::string solutions = std::to_string(table.basis.size());
    const std::string& first = table.variables.front().name;
    return "\"\"\"All " + solutions + " complex solutions of the problem " + name +
           ", for generic data.\n\n    solutions = " + name + ".solve(" + arguments + ")\n    " +
           name + ".named(solutions)[\"" + first + "\"]\n    " + name +
           ".real(solutions)\n\nAn elimination template of " + std::to_string(table.rows.size()) +
           " rows and " + std::to_string(table.columns()) +
           " columns, by `plprove template`; it needs NumPy alone.\n\"\"\"\n\n";
}

std::string functions(const std::string& arguments, const std::string& keywords,
                      std::size_t solutions) {
    const std::string n = std::to_string(solutions);
    const std::string after = arguments.empty() ? "" : ", " + arguments;
    return "\n\n\ndef solve(" + arguments + "):\n    \"\"\"All solutions: a complex array of " + n +
           " rows, with a column for each scalar of VARIABLES.\n\n    Data have the shapes "
           "of DATA.\n    \"\"\"\n    return _solve(_coefficients(" +
           arguments + "))\n\n\ndef residuals(solutions" + after +
           "):\n    \"\"\"Of each solution: the largest error of an equation, relative to its "
           "terms."
           "\"\"\"\n    equations = _by_monomials(_coefficients(" +
           arguments +
           "))\n    return np.abs(_residuals(np.asarray(solutions), equations)[0]).max(axis=1)\n" +
           solver + "def _coefficients(" + arguments + "):\n    [" + arguments + "] = _flat(" +
           keywords + ")\n";
}

/// The scalars of data, as items of flat lists.
std::vector<std::string> data_items(const Program& program) {
    std::vector<std::string> items;
    for (const Named& named : program.data_names)
        for (std::size_t i = 0; i < named.value.scalars.size(); ++i)
            items.push_back(python_name(named.name) + "[" + std::to_string(i) + "]");
    return items;
}

std::string tables(const EliminationTemplate& table, Numbers<Monomial>& monomials,
                   Numbers<std::size_t>& coefficients) {
    std::vector<std::string> equations, rows, action, exponents;
    for (const EliminationTemplate::Equation& equation : table.equations) {
        std::vector<std::size_t> places, sources;
        for (const Monomial& monomial : equation.monomials)
            places.push_back(monomials(monomial));
        for (const std::size_t coefficient : equation.coefficients)
            sources.push_back(coefficients(coefficient));
        equations.push_back("(" + list(places) + ", " + list(sources) + ")");
    }
    for (const EliminationTemplate::Row& row : table.rows)
        rows.push_back("(" + std::to_string(row.equation) + ", " + list(row.columns) + ")");
    for (const EliminationTemplate::Multiplication& term : table.action)
        action.push_back("(" + std::to_string(term.variable) + ", " + std::to_string(term.factor) +
                         ", " + list(term.products) + ")");
    for (const Monomial& monomial : monomials.values())
        exponents.push_back(
            list(std::vector<int>(monomial.exponents.begin(),
                                  monomial.exponents.begin() +
                                      static_cast<std::ptrdiff_t>(table.variable_columns.size()))));
    return "# Of each monomial of an equation, the exponents of the variables.\n_EXPONENTS = "
           "np.array([\n" +
           wrapped(exponents) +
           "])\n# Of each equation, its monomials and their coefficients.\n_EQUATIONS = [\n" +
           wrapped(equations) +
           "]\n# Multiples of equations: which one, and the columns of its monomials. Columns are "
           "those that are\n# eliminated, the basis, and one for what cancels.\n_ROWS = [\n" +
           wrapped(rows) + "]\n_BASIS = " + std::to_string(table.basis.size()) +
           "\n# Variables, factors, and the columns of the variable times the basis.\n_ACTION = "
           "[\n" +
           wrapped(action) + "]\n# The columns of the variables, and that of 1.\n_VARIABLES = " +
           list(table.variable_columns) + "\n_ONE = " + std::to_string(table.column_of_1) + "\n";
}

} // namespace

std::string python_module(const Study& study, const EliminationTemplate& table) {
    std::vector<std::string> arguments, keywords;
    for (const Named& named : study.program.data_names) {
        const std::string name = python_name(named.name);
        arguments.push_back(name);
        keywords.push_back(name + "=" + name);
    }
    Numbers<Monomial> monomials;
    Numbers<std::size_t> coefficients;
    const std::string numbers = tables(table, monomials, coefficients);
    const StraightLineText lines =
        straight_line_text(table.program, coefficients.values(), data_items(study.program));
    std::string text =
        documentation(study, table, joined(keywords)) +
        "import numpy as np\n\nDATA = " + shapes(study.program.data_names, python_name) +
        "\nVARIABLES = " + shapes(table.variables, std::identity{}) +
        "\nSTEPS = 2  # of Newton's method at the end of `solve`" +
        functions(joined(arguments), joined(keywords), table.basis.size());
    for (const auto& [name, expression] : lines.assignments)
        text += "    " + name + " = " + expression + "\n";
    return text + "    return [\n" + wrapped(lines.values, 8) + "    ]\n\n\n" + numbers +
           index_arrays;
}

} // namespace plprove::model
