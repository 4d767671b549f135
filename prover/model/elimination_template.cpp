#include "prover/model/elimination_template.h"

#include "prover/model/multiples_matrix.h"
#include "prover/model/univariate.h"

#include <algorithm>
#include <map>
#include <set>

namespace plprove::model {

namespace {

/// A multiple of an equation: its number in the system, and a column.
using Multiple = std::pair<std::size_t, std::size_t>;

void require_template(const Study& study) {
    const std::string none = "the model " + study.model.name + " has no template: ";
    if (study.at_most() == std::size_t{0})
        throw BadInput(none + "it has no solution for generic data");
    if (!study.elimination)
        throw BadInput(none + "no upper bound is known for its solutions (" + study.no_elimination +
                       "); docs/models.md says how a model gets one");
    if (!study.fibre) throw BadInput(none + study.no_fibre);
    const std::size_t basis = study.elimination->basis.size();
    const std::size_t solutions = study.fibre->count();
    if (basis != solutions)
        throw BadInput(none + "its elimination leaves " + std::to_string(basis) +
                       " monomials, but " + std::to_string(solutions) +
                       " solutions are known; 'relation' statements may make these numbers equal");
}

GroupedSystem<Modular> values_of(const GroupedSystem<DataPolynomial>& system) {
    GroupedSystem<Modular> result{system.variables, {}};
    for (const auto& equation : system.equations) {
        Polynomial polynomial;
        for (const auto& [monomial, coefficient] : equation.polynomial.terms())
            polynomial.append(monomial, coefficient.value());
        result.equations.push_back({equation.number, polynomial, equation.degrees});
    }
    return result;
}

/// Which rows express the products of variables and monomials of the basis by the basis, modulo q.
class Reduction {
public:
    Reduction(const MultiplesMatrix& matrix, const std::vector<std::size_t>& basis)
        : matrix_(matrix), basis_(basis), rows_(independent_rows()) {
        find_targets();
        express_targets();
    }

    std::size_t variables() const { return matrix_.system().variables.units.size(); }
    const std::vector<Multiple>& rows() const { return rows_; }

    /// The columns of a variable times the monomials of the basis.
    std::vector<std::size_t> products(std::size_t variable) const {
        std::vector<std::size_t> result;
        for (const std::size_t column : basis_)
            result.push_back(
                matrix_.place(matrix_.columns()[column] * variable_monomial(variable)));
        return result;
    }

    /// What a form needs: columns to express, and the rows that do so.
    struct Needs {
        std::vector<std::size_t> targets;
        std::vector<std::size_t> rows;
    };
    Needs needs_of(const std::vector<int>& form) const {
        std::set<std::size_t> targets, rows;
        for (std::size_t v = 0; v < form.size(); ++v) {
            targets.insert(matrix_.place(variable_monomial(v)));
            if (form[v] != 0)
                for (const std::size_t column : products(v))
                    targets.insert(column);
        }
        std::erase_if(targets, [&](std::size_t column) { return !targets_.contains(column); });
        for (const std::size_t column : targets)
            for (int i = 0; i < combinations_.rows(); ++i)
                if (combinations_.at(i, targets_.at(column)) != 0)
                    rows.insert(static_cast<std::size_t>(i));
        return {{targets.begin(), targets.end()}, {rows.begin(), rows.end()}};
    }

    /// Whether the form has different values at all solutions.
    bool separates(const std::vector<int>& form) const {
        const auto size = static_cast<int>(basis_.size());
        ResidueMatrix multiplication(size, size);
        for (std::size_t v = 0; v < form.size(); ++v) {
            const std::vector<std::size_t> columns = products(v);
            for (int b = 0; b < size && form[v] != 0; ++b)
                add_expression(multiplication, b, columns[static_cast<std::size_t>(b)],
                               Modular(form[v]));
        }
        Univariate characteristic;
        nmod_mat_charpoly(characteristic.get(), multiplication.get());
        return nmod_poly_is_squarefree(characteristic.get()) != 0;
    }

private:
    /// Those with multipliers of small degree first, so that few rows will do.
    std::vector<Multiple> independent_rows() const {
        std::vector<Multiple> all;
        for (std::size_t e = 0; e < matrix_.system().equations.size(); ++e)
            for (std::size_t column = 0; column < matrix_.columns().size(); ++column)
                if (matrix_.fits(e, column)) all.emplace_back(e, column);
        std::ranges::stable_sort(all, {}, [&](const Multiple& multiple) {
            return matrix_.columns()[multiple.second].degree();
        });
        SparseRows eliminated(matrix_.columns().size());
        std::erase_if(all, [&](const Multiple& multiple) {
            return !eliminated.reduce_and_add(matrix_.row(multiple.first, multiple.second));
        });
        return all;
    }

    void find_targets() {
        for (std::size_t v = 0; v < variables(); ++v) {
            std::vector<std::size_t> columns = products(v);
            columns.push_back(matrix_.place(variable_monomial(v)));
            for (const std::size_t column : columns)
                if (!std::ranges::binary_search(basis_, column))
                    targets_.emplace(column, static_cast<int>(targets_.size()));
        }
    }

    void express_targets() {
        const auto size = static_cast<int>(rows_.size());
        const auto targets = static_cast<int>(targets_.size());
        std::vector<int> places(matrix_.columns().size());
        int next_eliminated = 0, next_basis = size;
        for (std::size_t column = 0; column < places.size(); ++column)
            places[column] =
                std::ranges::binary_search(basis_, column) ? next_basis++ : next_eliminated++;
        ResidueMatrix eliminated(size, size), basis(size, next_basis - size), unit(size, targets);
        for (int i = 0; i < size; ++i)
            for (const auto& [column, value] : entries(rows_[static_cast<std::size_t>(i)])) {
                const int place = places[column];
                (place < size ? eliminated.at(place, i) : basis.at(i, place - size)) = value;
            }
        for (const auto& [column, k] : targets_)
            unit.at(places[column], k) = 1;
        combinations_ = ResidueMatrix(size, targets);
        if (nmod_mat_solve(combinations_.get(), eliminated.get(), unit.get()) == 0)
            throw std::logic_error("the columns beyond the basis are not independent");
        ResidueMatrix transposed(targets, size);
        nmod_mat_transpose(transposed.get(), combinations_.get());
        expressions_ = ResidueMatrix(targets, next_basis - size);
        nmod_mat_mul(expressions_.get(), transposed.get(), basis.get());
        nmod_mat_neg(expressions_.get(), expressions_.get());
    }

    std::vector<std::pair<std::size_t, Residue>> entries(const Multiple& multiple) const {
        std::vector<std::pair<std::size_t, Residue>> result;
        const auto& [equation, column] = multiple;
        for (const Term& term : matrix_.system().equations[equation].polynomial.terms())
            result.emplace_back(matrix_.place(term.monomial * matrix_.columns()[column]),
                                term.coefficient.value());
        return result;
    }

    /// Adds to a row of a multiplication a monomial, expressed by the basis, times a factor.
    void add_expression(ResidueMatrix& multiplication, int row, std::size_t column,
                        Modular factor) const {
        for (int b = 0; b < multiplication.columns(); ++b) {
            Modular entry(basis_[static_cast<std::size_t>(b)] == column ? 1 : 0);
            if (const auto target = targets_.find(column); target != targets_.end())
                entry = Modular::of(expressions_.at(target->second, b));
            Residue& place = multiplication.at(row, b);
            place = (Modular::of(place) + factor * entry).value();
        }
    }

    const MultiplesMatrix& matrix_;
    const std::vector<std::size_t>& basis_;
    std::vector<Multiple> rows_;
    std::map<std::size_t, int> targets_; // columns to express, and their numbers
    ResidueMatrix combinations_;         // of rows, a column for each target
    ResidueMatrix expressions_;          // of targets by the basis
};

/// The variable that needs fewest rows among those that tell the solutions apart, or a sum of
/// multiples of all variables.
std::vector<int> separating_form(const Reduction& reduction, RandomResidues random) {
    std::vector<int> best;
    for (std::size_t v = 0; v < reduction.variables(); ++v) {
        std::vector<int> form(reduction.variables());
        form[v] = 1;
        if (!reduction.separates(form)) continue;
        if (best.empty() ||
            reduction.needs_of(form).rows.size() < reduction.needs_of(best).rows.size())
            best = form;
    }
    while (best.empty()) {
        std::vector<int> form;
        for (std::size_t v = 0; v < reduction.variables(); ++v)
            form.push_back(random.integer(9));
        if (reduction.separates(form)) best = form;
    }
    return best;
}

/// Columns beyond the basis, the targets first, on which the rows are independent: one a row. What
/// the rows have elsewhere cancels in the targets.
std::vector<std::size_t> independent_columns(const MultiplesMatrix& matrix,
                                             const std::vector<Multiple>& rows,
                                             const std::vector<std::size_t>& targets,
                                             const std::vector<std::size_t>& basis) {
    std::vector<std::size_t> order = targets;
    std::map<std::size_t, int> places;
    for (const std::size_t column : targets)
        places.emplace(column, static_cast<int>(places.size()));
    const auto each_entry = [&](const auto& work) {
        for (std::size_t i = 0; i < rows.size(); ++i)
            for (const Term& term : matrix.system().equations[rows[i].first].polynomial.terms())
                work(static_cast<int>(i),
                     matrix.place(term.monomial * matrix.columns()[rows[i].second]),
                     term.coefficient.value());
    };
    each_entry([&](int /*row*/, std::size_t column, Residue /*value*/) {
        if (std::ranges::binary_search(basis, column)) return;
        if (places.emplace(column, static_cast<int>(order.size())).second) order.push_back(column);
    });
    ResidueMatrix entries(static_cast<int>(rows.size()), static_cast<int>(order.size()));
    each_entry([&](int row, std::size_t column, Residue value) {
        if (const auto place = places.find(column); place != places.end())
            entries.at(row, place->second) = value;
    });
    nmod_mat_rref(entries.get());
    std::vector<std::size_t> result;
    for (int row = 0, column = 0; row < entries.rows(); ++row, ++column) {
        while (entries.at(row, column) == 0)
            ++column;
        result.push_back(order[static_cast<std::size_t>(column)]);
    }
    return result;
}

/// Makes the tables, from rows and columns of the matrix.
class Tables {
public:
    Tables(const GroupedSystem<DataPolynomial>& system, const MultiplesMatrix& matrix,
           const std::vector<std::size_t>& eliminated, const std::vector<std::size_t>& basis)
        : system_(system), matrix_(matrix) {
        for (const auto* columns : {&eliminated, &basis})
            for (const std::size_t column : *columns)
                places_.emplace(column, places_.size());
    }

    /// The number that a column of the matrix has in the template.
    std::size_t place(std::size_t column) const {
        const auto found = places_.find(column);
        return found == places_.end() ? places_.size() : found->second;
    }
    std::size_t place(const Monomial& monomial) const { return place(matrix_.place(monomial)); }

    /// The equations of these rows, all first `kept` equations of the model, and the rows.
    void add(const std::vector<Multiple>& rows, std::size_t kept, EliminationTemplate& to) const {
        std::set<std::size_t> used;
        for (const Multiple& row : rows)
            used.insert(row.first);
        std::map<std::size_t, std::size_t> numbers;
        for (std::size_t e = 0; e < system_.equations.size(); ++e) {
            if (!used.contains(e) && system_.equations[e].number > kept) continue;
            numbers.emplace(e, to.equations.size());
            EliminationTemplate::Equation& equation = to.equations.emplace_back();
            for (const auto& [monomial, coefficient] : system_.equations[e].polynomial.terms()) {
                equation.monomials.push_back(monomial);
                equation.coefficients.push_back(coefficient.step(to.program));
            }
        }
        for (const auto& [e, column] : rows) {
            EliminationTemplate::Row& row = to.rows.emplace_back();
            row.equation = numbers.at(e);
            for (const Monomial& monomial : to.equations[row.equation].monomials)
                row.columns.push_back(place(monomial * matrix_.columns()[column]));
        }
    }

private:
    const GroupedSystem<DataPolynomial>& system_;
    const MultiplesMatrix& matrix_;
    std::map<std::size_t, std::size_t> places_;
};

} // namespace

EliminationTemplate make_template(const Study& study) {
    require_template(study);
    const Elimination& elimination = *study.elimination;
    Grouping grouping;
    Degrees degrees;
    for (const Group& group : elimination.groups) {
        grouping.push_back(group.names);
        degrees.push_back(group.degree);
    }
    EliminationTemplate result;
    for (const std::string& name : variable_names(grouping))
        result.variables.push_back({name, array_of(study.program, name)});
    std::vector<DataPolynomial> data;
    for (std::size_t i = 0; i < elimination.data.size(); ++i)
        data.push_back(DataPolynomial::datum(result.program, i, elimination.data[i]));
    const auto system =
        *grouped_system(study.program, std::span<const DataPolynomial>(data), grouping);
    const GroupedSystem<Modular> values = values_of(system);
    const MultiplesMatrix matrix(values, degrees);
    std::vector<std::size_t> basis;
    for (const std::size_t number : elimination.basis)
        basis.push_back(number - 1);

    const Reduction reduction(matrix, basis);
    constexpr std::uint64_t stream = 5;
    const std::vector<int> form = separating_form(reduction, RandomResidues(study.model, stream));
    const Reduction::Needs needs = reduction.needs_of(form);
    std::vector<Multiple> rows;
    for (const std::size_t row : needs.rows)
        rows.push_back(reduction.rows()[row]);
    const Tables tables(system, matrix, independent_columns(matrix, rows, needs.targets, basis),
                        basis);
    tables.add(rows, study.program.equations.size(), result);
    for (const std::size_t column : basis)
        result.basis.push_back(matrix.columns()[column]);
    for (std::size_t v = 0; v < form.size(); ++v) {
        result.variable_columns.push_back(tables.place(variable_monomial(v)));
        if (form[v] == 0) continue;
        EliminationTemplate::Multiplication& term = result.action.emplace_back();
        term.variable = v;
        term.factor = form[v];
        for (const std::size_t column : reduction.products(v))
            term.products.push_back(tables.place(column));
    }
    result.column_of_1 = tables.place(Monomial{});
    return result;
}

} // namespace plprove::model
