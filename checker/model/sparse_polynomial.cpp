#include "checker/model/sparse_polynomial.h"

#include "checker/algebra/dual.h"

namespace checker {
Powers product_of(const Powers& a, const Powers& b) {
    Powers sum(std::max(a.size(), b.size()));
    for (std::size_t i = 0; i < sum.size(); ++i)
        sum[i] = static_cast<std::uint8_t>((i < a.size() ? a[i] : 0) + (i < b.size() ? b[i] : 0));
    return sum;
}

template <> Residue SparsePolynomials<Residue>::from(int number) {
    return in_ring<Residue>(number);
}

template <> Residue SparsePolynomials<Residue>::inverse_of(const Residue& x) {
    return x.inverse();
}

template <> mpq_class SparsePolynomials<mpq_class>::from(int number) {
    return number;
}

template <> mpq_class SparsePolynomials<mpq_class>::inverse_of(const mpq_class& x) {
    return 1 / x;
}
} // namespace checker
