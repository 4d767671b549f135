// The ranks of the degrees. For k = 0 .. 5 the matrix M_k has a row for each product y of weight
// 11 - k, a column for each product x of weight k, and the entry deg(x y). A relation of weight k
// is a vector that M_k takes to 0. Where degrees are right the ranks are 1, 6, 25, 81, 218, 467.
#pragma once

#include "tests/laws/degree_form.h"

#include <flint/nmod_mat.h>

namespace laws {

inline constexpr std::array<std::size_t, 6> expected_ranks{1, 6, 25, 81, 218, 467};

/// Primes. The rank modulo a prime is at most the rank.
inline constexpr std::array<std::uint64_t, 2> primes{(std::uint64_t{1} << 61) - 1,
                                                     (std::uint64_t{1} << 31) - 1};

/// The matrix M_k, by the classes of its entries.
class DegreeMatrix {
public:
    static constexpr std::size_t not_minimal = static_cast<std::size_t>(-1);

    DegreeMatrix(unsigned k, const DegreeForm& form);

    std::size_t columns() const { return columns_; }
    std::size_t rows() const { return entries_.size() / columns_; }

    /// The rank modulo a prime.
    std::size_t rank(const DegreeForm& form, std::uint64_t prime) const;

    /// The rank modulo the first prime of the rows that do not contain the class.
    std::size_t rank_without(std::size_t constraint_class, const DegreeForm& form) const;

    /// Whether any other degree of the class, the others unchanged, makes the rank larger. `rank`
    /// is that of the matrix modulo the first prime.
    ///
    /// It does if the rows without the class have this rank already, and for a row that contains
    /// the class, the vector with 1 where it is and 0 elsewhere is no combination of rows.
    bool guards(std::size_t constraint_class, std::size_t rank, const DegreeForm& form) const;

private:
    std::size_t entry(std::size_t row, std::size_t column) const {
        return entries_[row * columns_ + column];
    }
    bool contains(std::size_t row, std::size_t constraint_class) const;
    /// The rows that contain the class, or those that do not.
    std::vector<std::size_t> rows_with(std::size_t constraint_class, bool contained) const;
    /// Puts the degrees in these rows into a matrix that is zero.
    void fill(nmod_mat_struct* matrix, const std::vector<std::size_t>& rows,
              const DegreeForm& form) const;

    std::size_t columns_ = 0;
    std::vector<std::size_t> entries_; ///< row by row
};

} // namespace laws
