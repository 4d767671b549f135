// Sparse polynomials in at most 32 variables. Coefficients are residues modulo q, or another type
// with +, -, *, is_zero() and 0 as its first value.
#pragma once

#include "prover/geometry/modular.h"
#include "prover/model/monomial.h"

#include <algorithm>
#include <vector>

namespace plprove::model {

/// A term: a coefficient other than 0, and its monomial.
template <class Coefficient>
struct TermOver {
    Monomial monomial;
    Coefficient coefficient;
};

/// A polynomial: its terms in ascending lexicographic order of the monomials.
template <class Coefficient>
class PolynomialOver {
public:
    using Term = TermOver<Coefficient>;

    PolynomialOver() = default;
    explicit PolynomialOver(Coefficient constant) {
        if (!constant.is_zero()) terms_.push_back({{}, constant});
    }
    static PolynomialOver variable(std::size_t index) {
        PolynomialOver result;
        result.terms_.push_back({variable_monomial(index), Coefficient(1)});
        return result;
    }

    const std::vector<Term>& terms() const { return terms_; }
    bool is_zero() const { return terms_.empty(); }
    bool is_constant() const {
        return terms_.empty() || (terms_.size() == 1 && terms_[0].monomial == Monomial{});
    }
    /// The coefficient of 1.
    Coefficient constant() const {
        return !terms_.empty() && terms_[0].monomial == Monomial{} ? terms_[0].coefficient
                                                                   : Coefficient{};
    }

    friend PolynomialOver operator+(const PolynomialOver& a, const PolynomialOver& b) {
        return combined(a, b, [](const Coefficient& y) { return y; });
    }
    friend PolynomialOver operator-(const PolynomialOver& a, const PolynomialOver& b) {
        return combined(a, b, [](const Coefficient& y) { return -y; });
    }
    /// Throws TooLarge if there are too many products of terms.
    friend PolynomialOver operator*(const PolynomialOver& a, const PolynomialOver& b) {
        constexpr std::size_t most_products = 20'000'000;
        if (a.terms_.size() * b.terms_.size() > most_products)
            throw TooLarge("a product of polynomials has more than 20,000,000 terms");
        std::vector<Term> products;
        products.reserve(a.terms_.size() * b.terms_.size());
        for (const Term& x : a.terms_)
            for (const Term& y : b.terms_)
                products.push_back({x.monomial * y.monomial, x.coefficient * y.coefficient});
        std::ranges::sort(products, {}, &Term::monomial);
        PolynomialOver result;
        for (std::size_t i = 0; i < products.size();) {
            Coefficient sum;
            const Monomial& monomial = products[i].monomial;
            for (; i < products.size() && products[i].monomial == monomial; ++i)
                sum = sum + products[i].coefficient;
            if (!sum.is_zero()) result.terms_.push_back({products[i - 1].monomial, sum});
        }
        return result;
    }
    /// Adds a term after all others: the monomial is the largest, the coefficient not 0.
    void append(const Monomial& monomial, const Coefficient& coefficient) {
        terms_.push_back({monomial, coefficient});
    }
    bool operator==(const PolynomialOver& other) const {
        return std::ranges::equal(terms_, other.terms_, [](const Term& x, const Term& y) {
            return x.monomial == y.monomial && x.coefficient == y.coefficient;
        });
    }

private:
    /// a plus what `signed_as` makes of the coefficients of b.
    template <class Sign>
    static PolynomialOver combined(const PolynomialOver& a, const PolynomialOver& b,
                                   const Sign& signed_as) {
        PolynomialOver result;
        result.terms_.reserve(a.terms_.size() + b.terms_.size());
        auto x = a.terms_.begin();
        auto y = b.terms_.begin();
        while (x != a.terms_.end() || y != b.terms_.end()) {
            if (y == b.terms_.end() || (x != a.terms_.end() && x->monomial < y->monomial)) {
                result.terms_.push_back(*x++);
            } else if (x == a.terms_.end() || y->monomial < x->monomial) {
                result.terms_.push_back({y->monomial, signed_as(y->coefficient)});
                ++y;
            } else {
                const Coefficient sum = x->coefficient + signed_as(y->coefficient);
                if (!sum.is_zero()) result.terms_.push_back({x->monomial, sum});
                ++x;
                ++y;
            }
        }
        return result;
    }

    std::vector<Term> terms_;
};

using Term = TermOver<Modular>;
using Polynomial = PolynomialOver<Modular>;

} // namespace plprove::model
