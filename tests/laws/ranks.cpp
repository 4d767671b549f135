#include "tests/laws/ranks.h"

#include <algorithm>
#include <numeric>

namespace laws {

namespace {

/// A matrix of residues, zero at first.
class ResidueMatrix {
public:
    ResidueMatrix(std::size_t rows, std::size_t columns, std::uint64_t prime) {
        nmod_mat_init(matrix_, static_cast<slong>(rows), static_cast<slong>(columns), prime);
    }
    ResidueMatrix(const ResidueMatrix&) = delete;
    ResidueMatrix& operator=(const ResidueMatrix&) = delete;
    ~ResidueMatrix() { nmod_mat_clear(matrix_); }

    std::uint64_t& at(std::size_t row, std::size_t column) {
        return *nmod_mat_entry_ptr(matrix_, static_cast<slong>(row), static_cast<slong>(column));
    }
    nmod_mat_struct* get() { return matrix_; }

private:
    nmod_mat_t matrix_;
};

std::vector<std::size_t> all_rows(std::size_t rows) {
    std::vector<std::size_t> result(rows);
    std::iota(result.begin(), result.end(), 0);
    return result;
}

} // namespace

DegreeMatrix::DegreeMatrix(unsigned k, const DegreeForm& form) {
    const std::vector<Product> right = products(k);
    columns_ = right.size();
    for (const Product& left : products(checker::camera_unknowns - k))
        for (const Product& x : right)
            entries_.push_back(form.class_of(left * x).value_or(not_minimal));
}

void DegreeMatrix::fill(nmod_mat_struct* matrix, const std::vector<std::size_t>& rows,
                        const DegreeForm& form) const {
    for (std::size_t i = 0; i < rows.size(); ++i)
        for (std::size_t column = 0; column < columns_; ++column) {
            const std::size_t index = entry(rows[i], column);
            if (index == not_minimal) continue;
            const auto degree = static_cast<std::uint64_t>(form.classes()[index].degree);
            *nmod_mat_entry_ptr(matrix, static_cast<slong>(i), static_cast<slong>(column)) = degree;
        }
}

std::size_t DegreeMatrix::rank(const DegreeForm& form, std::uint64_t prime) const {
    ResidueMatrix matrix(rows(), columns_, prime);
    fill(matrix.get(), all_rows(rows()), form);
    return static_cast<std::size_t>(nmod_mat_rank(matrix.get()));
}

bool DegreeMatrix::contains(std::size_t row, std::size_t constraint_class) const {
    const auto first = entries_.begin() + static_cast<std::ptrdiff_t>(row * columns_);
    const auto last = first + static_cast<std::ptrdiff_t>(columns_);
    return std::find(first, last, constraint_class) != last;
}

std::vector<std::size_t> DegreeMatrix::rows_with(std::size_t constraint_class,
                                                 bool contained) const {
    std::vector<std::size_t> result;
    for (std::size_t row = 0; row < rows(); ++row)
        if (contains(row, constraint_class) == contained) result.push_back(row);
    return result;
}

std::size_t DegreeMatrix::rank_without(std::size_t constraint_class, const DegreeForm& form) const {
    const std::vector<std::size_t> without = rows_with(constraint_class, false);
    ResidueMatrix matrix(without.size(), columns_, primes[0]);
    fill(matrix.get(), without, form);
    return static_cast<std::size_t>(nmod_mat_rank(matrix.get()));
}

bool DegreeMatrix::guards(std::size_t constraint_class, std::size_t rank,
                          const DegreeForm& form) const {
    const std::vector<std::size_t> without = rows_with(constraint_class, false);
    const std::vector<std::size_t> with = rows_with(constraint_class, true);
    if (with.empty()) return false;
    ResidueMatrix matrix(without.size(), columns_, primes[0]);
    fill(matrix.get(), without, form);
    ResidueMatrix kernel(columns_, columns_, primes[0]);
    const auto nullity = static_cast<std::size_t>(nmod_mat_nullspace(kernel.get(), matrix.get()));
    if (columns_ - nullity != rank) return false;
    // Whether the row of the class's places is orthogonal to the whole kernel.
    return std::ranges::any_of(with, [&](std::size_t row) {
        for (std::size_t vector = 0; vector < nullity; ++vector) {
            std::uint64_t sum = 0;
            for (std::size_t column = 0; column < columns_; ++column)
                if (entry(row, column) == constraint_class)
                    sum = (sum + kernel.at(column, vector)) % primes[0];
            if (sum != 0) return true;
        }
        return false;
    });
}

} // namespace laws
