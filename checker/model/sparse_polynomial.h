// Polynomials in variables, with coefficients modulo q or rational, that know bounds of their
// degrees for all data (FORMAT.md, section 16, *Eliminations*).
#pragma once

#include "checker/algebra/modular.h"
#include "checker/file/complaint.h"

#include <functional>
#include <map>
#include <optional>

namespace checker {
/// The exponents of the variables; zeros at the end are left out.
using Powers = std::vector<std::uint8_t>;

Powers product_of(const Powers& a, const Powers& b);

/// A ring for models. Coefficient: Residue or mpq_class.
template <class Coefficient> class SparsePolynomials {
public:
    struct Element {
        std::map<Powers, Coefficient> terms{};     // no coefficient is 0
        std::optional<std::vector<int>> degrees{}; // one a group; none of what is 0 for all data
        bool is_foreign = false;                   // an unknown occurs that is no variable
    };

    /// Is told how many products of terms are about to be made.
    using Spend = std::function<void(std::uint64_t)>;

    SparsePolynomials(std::size_t groups, Spend spend)
        : groups_(groups), spend_(std::move(spend)) {}

    Element constant(int number) const {
        if (number == 0) return {};
        return value(from(number));
    }

    /// A number that depends on data.
    Element value(Coefficient number) const {
        Element result{.degrees = std::vector<int>(groups_)};
        if (!is_zero(number)) result.terms[{}] = std::move(number);
        return result;
    }

    /// The variable of this number, with its degree in each group.
    Element variable(std::size_t number, std::vector<int> degrees) const {
        Element result{.degrees = std::move(degrees)};
        Powers powers(number + 1);
        powers.back() = 1;
        result.terms[powers] = from(1);
        return result;
    }

    Element foreign() const { return {.degrees = std::vector<int>(groups_), .is_foreign = true}; }

    Element add(const Element& a, const Element& b) const {
        spend_(a.terms.size() + b.terms.size());
        Element sum = a;
        sum.is_foreign |= b.is_foreign;
        for (const auto& [powers, coefficient] : b.terms)
            add_term(sum.terms, powers, coefficient);
        if (!sum.degrees)
            sum.degrees = b.degrees;
        else if (b.degrees)
            for (std::size_t g = 0; g < groups_; ++g)
                (*sum.degrees)[g] = std::max((*sum.degrees)[g], (*b.degrees)[g]);
        return sum;
    }

    Element multiply(const Element& a, const Element& b) const {
        spend_(a.terms.size() * b.terms.size());
        Element product{.is_foreign = a.is_foreign || b.is_foreign};
        for (const auto& [p, x] : a.terms)
            for (const auto& [r, y] : b.terms)
                add_term(product.terms, product_of(p, r), Coefficient(x * y));
        if (!a.degrees || !b.degrees) return product;
        product.degrees = a.degrees;
        for (std::size_t g = 0; g < groups_; ++g)
            if (((*product.degrees)[g] += (*b.degrees)[g]) > 200)
                throw Refused("a degree larger than 200");
        return product;
    }

    /// Of a constant. Throws Refused if it is 0.
    Element inverse(const Element& a) const {
        if (a.terms.empty()) throw Refused("the model divides by the constant 0");
        return value(inverse_of(a.terms.begin()->second));
    }

private:
    static Coefficient from(int number);
    static Coefficient inverse_of(const Coefficient& x);
    static bool is_zero(const Coefficient& x) { return x == Coefficient{}; }

    static void add_term(std::map<Powers, Coefficient>& terms, const Powers& powers,
                         const Coefficient& coefficient) {
        const auto [place, is_new] = terms.try_emplace(powers, coefficient);
        if (!is_new) place->second = place->second + coefficient;
        if (is_zero(place->second)) terms.erase(place);
    }

    std::size_t groups_;
    Spend spend_;
};
} // namespace checker
