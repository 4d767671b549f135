#include "prover/model/groebner.h"

#include "prover/model/critical_pairs.h"
#include "prover/model/sparse_rows.h"

#include <algorithm>
#include <unordered_map>
#include <unordered_set>

namespace plprove::model {

namespace {

using Terms = std::vector<Term>; // in descending order

Terms descending(const Polynomial& polynomial) {
    Terms terms = polynomial.terms();
    std::ranges::sort(
        terms, [](const Term& a, const Term& b) { return grevlex_less(b.monomial, a.monomial); });
    return terms;
}

Terms multiplied(const Terms& terms, const Monomial& factor) {
    Terms result = terms;
    for (Term& term : result)
        term.monomial = term.monomial * factor;
    return result;
}

/// A matrix whose columns are monomials: rows that are to be reduced, and multiples of elements of
/// the basis that reduce them.
class MacaulayMatrix {
public:
    MacaulayMatrix(const std::vector<Terms>& basis, const CriticalPairs& pairs,
                   const GroebnerLimits& limits)
        : basis_(basis), pairs_(pairs), limits_(limits) {}

    void add_row(Terms row) {
        note(row);
        rows_.push_back(std::move(row));
    }

    /// The leading monomial is the pivot of this row; no other may have it.
    void add_reducer(Terms row) {
        reduced_.insert(row.front().monomial);
        note(row);
        reducers_.push_back(std::move(row));
    }

    bool has_reducer(const Monomial& leading) const { return reduced_.contains(leading); }

    /// Adds a multiple of an element of the basis for each monomial that has one.
    void complete() {
        for (std::size_t i = 0; i < monomials_.size(); ++i) {
            const Monomial monomial = monomials_[i];
            if (reduced_.contains(monomial)) continue;
            for (std::size_t k = 0; k < basis_.size(); ++k)
                if (pairs_.is_minimal(k) && pairs_.leading()[k].divides(monomial)) {
                    add_reducer(multiplied(basis_[k], monomial / pairs_.leading()[k]));
                    break;
                }
        }
    }

    /// The rows in echelon form, those that are 0 left out.
    std::vector<Terms> reduced_rows() {
        SparseRows matrix = with_reducers();
        std::vector<SparseRow> rows;
        for (const Terms& row : rows_)
            rows.push_back(sparse(row));
        std::ranges::stable_sort(rows, std::greater{},
                                 [](const SparseRow& row) { return row.columns.front(); });
        std::vector<std::size_t> pivots;
        for (const SparseRow& row : rows) {
            SparseRow rest = matrix.reduce(row);
            if (rest.empty()) continue;
            pivots.push_back(rest.columns.front());
            matrix.add_pivot(std::move(rest));
        }
        std::vector<Terms> result;
        for (const std::size_t pivot : pivots)
            result.push_back(terms(matrix.reduce(matrix.pivot(pivot), true)));
        return result;
    }

    /// The reducers, each reduced by the others.
    std::vector<Terms> reduced_tails(std::size_t count) {
        SparseRows matrix = with_reducers();
        std::vector<Terms> result;
        for (std::size_t i = 0; i < count; ++i)
            result.push_back(terms(matrix.reduce(sparse(reducers_[i]), true)));
        return result;
    }

    /// How many entries the reducers have: reducing a row costs at most that.
    std::size_t work() const {
        std::size_t entries = 0;
        for (const Terms& row : reducers_)
            entries += row.size();
        return entries * (rows_.size() + 1);
    }

private:
    void note(const Terms& row) {
        for (const Term& term : row)
            if (columns_.try_emplace(term.monomial, 0).second) monomials_.push_back(term.monomial);
        if (monomials_.size() > limits_.columns)
            throw TooLarge("a matrix has more than " + std::to_string(limits_.columns) +
                           " columns");
    }

    SparseRows with_reducers() {
        std::ranges::sort(monomials_,
                          [](const Monomial& a, const Monomial& b) { return grevlex_less(b, a); });
        for (std::size_t i = 0; i < monomials_.size(); ++i)
            columns_[monomials_[i]] = static_cast<std::uint32_t>(i);
        SparseRows matrix(monomials_.size());
        for (const Terms& row : reducers_)
            matrix.add_pivot(sparse(row));
        return matrix;
    }

    SparseRow sparse(const Terms& row) const {
        SparseRow result;
        for (const Term& term : row) {
            result.columns.push_back(columns_.at(term.monomial));
            result.entries.push_back(term.coefficient);
        }
        return result;
    }

    Terms terms(const SparseRow& row) const {
        Terms result;
        for (std::size_t i = 0; i < row.columns.size(); ++i)
            result.push_back({monomials_[row.columns[i]], row.entries[i]});
        return result;
    }

    const std::vector<Terms>& basis_;
    const CriticalPairs& pairs_;
    const GroebnerLimits& limits_;
    std::vector<Monomial> monomials_;
    std::unordered_map<Monomial, std::uint32_t, HashOfMonomial> columns_;
    std::unordered_set<Monomial, HashOfMonomial> reduced_;
    std::vector<Terms> rows_, reducers_;
};

class Computation {
public:
    explicit Computation(const GroebnerLimits& limits) : limits_(limits) {}

    void add(Terms element) {
        const Modular scale = element.front().coefficient.inverse();
        for (Term& term : element)
            term.coefficient = term.coefficient * scale;
        pairs_.add_element(element.front().monomial);
        basis_.push_back(std::move(element));
    }

    /// Reduces the polynomials, then pairs degree by degree.
    void run(std::vector<Terms> polynomials) {
        MacaulayMatrix first(basis_, pairs_, limits_);
        for (Terms& polynomial : polynomials)
            first.add_row(std::move(polynomial));
        add_all(first.reduced_rows());
        while (!pairs_.empty() && !is_unit())
            step();
    }

    std::vector<Terms> reduced_basis() const {
        MacaulayMatrix matrix(basis_, pairs_, limits_);
        std::size_t count = 0;
        for (std::size_t k = 0; k < basis_.size(); ++k)
            if (pairs_.is_minimal(k)) {
                matrix.add_reducer(basis_[k]);
                ++count;
            }
        matrix.complete();
        return matrix.reduced_tails(count);
    }

private:
    bool is_unit() const {
        return std::ranges::any_of(
            basis_, [](const Terms& element) { return element.front().monomial == Monomial{}; });
    }

    void step() {
        MacaulayMatrix matrix(basis_, pairs_, limits_);
        std::unordered_map<Monomial, std::unordered_set<std::size_t>, HashOfMonomial> added;
        for (const CriticalPair& pair : pairs_.take_least())
            for (const std::size_t k : {pair.first, pair.second}) {
                if (!added[pair.multiple].insert(k).second) continue;
                Terms row = multiplied(basis_[k], pair.multiple / pairs_.leading()[k]);
                if (matrix.has_reducer(pair.multiple))
                    matrix.add_row(std::move(row));
                else
                    matrix.add_reducer(std::move(row));
            }
        matrix.complete();
        spent_ += matrix.work();
        if (spent_ > limits_.operations) throw TooLarge("the matrices need too many operations");
        add_all(matrix.reduced_rows());
    }

    /// Adds elements in ascending order of their leading monomials, none of which divides another
    /// that is added before it.
    void add_all(std::vector<Terms> elements) {
        std::ranges::sort(elements, [](const Terms& a, const Terms& b) {
            return grevlex_less(a.front().monomial, b.front().monomial);
        });
        for (Terms& element : elements)
            add(std::move(element));
    }

    const GroebnerLimits& limits_;
    std::vector<Terms> basis_;
    CriticalPairs pairs_;
    std::size_t spent_ = 0;
};

} // namespace

std::vector<std::vector<Term>> groebner_basis(std::span<const Polynomial> polynomials,
                                              const GroebnerLimits& limits) {
    std::vector<Terms> given;
    for (const Polynomial& polynomial : polynomials)
        if (!polynomial.is_zero()) given.push_back(descending(polynomial));
    Computation computation(limits);
    computation.run(std::move(given));
    return computation.reduced_basis();
}

} // namespace plprove::model
