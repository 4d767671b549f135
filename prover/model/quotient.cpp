#include "prover/model/quotient.h"

#include <algorithm>
#include <unordered_map>

namespace plprove::model {

namespace {

using Vector = std::vector<Modular>;

/// Sparse where it is: the entries other than 0 of a vector of the quotient.
using Entries = std::vector<std::pair<std::size_t, Modular>>;

/// The quotient by an ideal, as a vector space: its monomials are those that no leading monomial
/// divides.
class QuotientSpace {
public:
    QuotientSpace(const std::vector<std::vector<Term>>& basis, std::size_t variables,
                  std::size_t most)
        : basis_(basis), variables_(variables) {
        for (std::size_t k = 0; k < basis.size(); ++k)
            leading_.emplace(basis[k].front().monomial, k);
        if (is_finite()) find_monomials(most);
    }

    /// Whether each variable has a power that is a leading monomial, and the ideal is not all.
    bool is_finite() const {
        if (leading_.contains(Monomial{})) return false;
        for (std::size_t v = 0; v < variables_; ++v)
            if (std::ranges::none_of(basis_, [&](const std::vector<Term>& element) {
                    const Monomial& leading = element.front().monomial;
                    return leading.degree() == leading.exponents[v];
                }))
                return false;
        return true;
    }

    std::size_t dimension() const { return monomials_.size(); }
    std::size_t index_of(const Monomial& monomial) const { return places_.at(monomial); }

    /// products[v][k]: variable v times monomial k.
    std::vector<std::vector<Entries>> multiplications() {
        struct Border {
            Monomial monomial;
            std::size_t variable, place;
        };
        std::vector<Border> border;
        for (std::size_t v = 0; v < variables_; ++v)
            for (std::size_t k = 0; k < monomials_.size(); ++k)
                border.push_back({monomials_[k] * variable_monomial(v), v, k});
        std::ranges::sort(border, [](const Border& a, const Border& b) {
            return grevlex_less(a.monomial, b.monomial);
        });
        products_.assign(variables_, std::vector<Entries>(monomials_.size()));
        for (const Border& item : border) {
            if (!normal_forms_.contains(item.monomial))
                normal_forms_.emplace(item.monomial, normal_form(item.monomial));
            products_[item.variable][item.place] = normal_forms_.at(item.monomial);
        }
        return std::move(products_);
    }

private:
    void find_monomials(std::size_t most) {
        monomials_.push_back({});
        places_.emplace(Monomial{}, 0);
        for (std::size_t i = 0; i < monomials_.size(); ++i)
            for (std::size_t v = 0; v < variables_; ++v) {
                const Monomial next = monomials_[i] * variable_monomial(v);
                if (places_.contains(next) || is_leading_multiple(next)) continue;
                places_.emplace(next, monomials_.size());
                monomials_.push_back(next);
                if (monomials_.size() > most)
                    throw TooLarge("a system has more than " + std::to_string(most) + " solutions");
            }
    }

    bool is_leading_multiple(const Monomial& monomial) const {
        return std::ranges::any_of(basis_, [&](const std::vector<Term>& element) {
            return element.front().monomial.divides(monomial);
        });
    }

    /// Of a monomial of the quotient, of a leading one, or of a multiple of a smaller such one.
    Entries normal_form(const Monomial& monomial) const {
        if (const auto place = places_.find(monomial); place != places_.end())
            return {{place->second, Modular(1)}};
        if (const auto element = leading_.find(monomial); element != leading_.end()) {
            Entries result;
            const std::vector<Term>& terms = basis_[element->second];
            for (std::size_t i = 1; i < terms.size(); ++i)
                result.emplace_back(places_.at(terms[i].monomial), -terms[i].coefficient);
            return result;
        }
        for (std::size_t v = 0; v < variables_; ++v) {
            if (monomial.exponents[v] == 0) continue;
            const Monomial smaller = monomial / variable_monomial(v);
            const auto form = normal_forms_.find(smaller);
            if (form != normal_forms_.end() && !places_.contains(smaller))
                return times(v, form->second);
        }
        throw std::logic_error("a monomial of the border has no smaller one");
    }

    Entries times(std::size_t variable, const Entries& vector) const {
        Vector sum(monomials_.size());
        for (const auto& [place, coefficient] : vector)
            for (const auto& [k, entry] : products_[variable][place])
                sum[k] = sum[k] + coefficient * entry;
        Entries result;
        for (std::size_t k = 0; k < sum.size(); ++k)
            if (!sum[k].is_zero()) result.emplace_back(k, sum[k]);
        return result;
    }

    const std::vector<std::vector<Term>>& basis_;
    std::size_t variables_;
    std::unordered_map<Monomial, std::size_t, HashOfMonomial> leading_; // element of the basis
    std::vector<Monomial> monomials_;
    std::unordered_map<Monomial, std::size_t, HashOfMonomial> places_;
    std::unordered_map<Monomial, Entries, HashOfMonomial> normal_forms_;
    std::vector<std::vector<Entries>> products_;
};

/// The polynomial with the roots of multiplicity 1.
Univariate simple_roots(const Univariate& polynomial) {
    Univariate result({Modular(1)});
    nmod_poly_factor_t factors;
    nmod_poly_factor_init(factors);
    nmod_poly_factor_squarefree(factors, polynomial.get());
    for (slong i = 0; i < factors->num; ++i)
        if (factors->exp[i] == 1) nmod_poly_mul(result.get(), result.get(), &factors->p[i]);
    nmod_poly_factor_clear(factors);
    return result;
}

/// The polynomial part of (s_0/t + s_1/t^2 + ...) times `polynomial`.
Univariate numerator(const Vector& sequence, const Univariate& polynomial) {
    const std::size_t degree = polynomial.degree();
    Vector coefficients(degree);
    for (std::size_t power = 0; power < degree; ++power)
        for (std::size_t i = power + 1; i <= degree; ++i)
            coefficients[power] =
                coefficients[power] + polynomial.coefficient(i) * sequence[i - power - 1];
    return Univariate(coefficients);
}

/// The shortest recurrence of a sequence, as a polynomial with leading coefficient 1.
Univariate recurrence(const Vector& sequence) {
    Univariate result;
    nmod_berlekamp_massey_t massey;
    nmod_berlekamp_massey_init(massey, modulus);
    for (const Modular value : sequence)
        nmod_berlekamp_massey_add_point(massey, value.value());
    nmod_berlekamp_massey_reduce(massey);
    nmod_poly_make_monic(result.get(), nmod_berlekamp_massey_V_poly(massey));
    nmod_berlekamp_massey_clear(massey);
    return result;
}

/// The sequences f(t^k x) for x = 1 and each variable, k = 0, 1, ...; f is a linear function, t is
/// multiplication by the form. The first has 2 D values, the others D.
std::vector<Vector> sequences(const std::vector<std::vector<Entries>>& products,
                              const std::vector<int>& form, std::size_t dimension,
                              std::size_t one) {
    // The transposed multiplication takes a linear function f to x -> f(t x).
    std::vector<Entries> by_form(dimension);
    for (std::size_t k = 0; k < dimension; ++k) {
        Vector sum(dimension);
        for (std::size_t v = 0; v < form.size(); ++v)
            for (const auto& [place, entry] : products[v][k])
                sum[place] = sum[place] + Modular(form[v]) * entry;
        for (std::size_t i = 0; i < dimension; ++i)
            if (!sum[i].is_zero()) by_form[k].emplace_back(i, sum[i]);
    }
    const auto value = [](const Vector& function, const Entries& vector) {
        Modular sum;
        for (const auto& [place, entry] : vector)
            sum = sum + function[place] * entry;
        return sum;
    };
    Vector function(dimension);
    std::uint64_t state = 1;
    for (Modular& entry : function) { // any function will do but for few
        state = state * 6364136223846793005U + 1442695040888963407U;
        entry = Modular(static_cast<std::int64_t>(state >> 3U));
    }
    std::vector<Vector> result(form.size() + 1);
    for (std::size_t k = 0; k < 2 * dimension; ++k) {
        result[0].push_back(function[one]);
        for (std::size_t v = 0; v < form.size() && k < dimension; ++v)
            result[v + 1].push_back(value(function, products[v][one]));
        Vector next(dimension);
        for (std::size_t i = 0; i < dimension; ++i)
            next[i] = value(function, by_form[i]);
        function = std::move(next);
    }
    return result;
}

} // namespace

std::optional<Solutions> solutions_of(const std::vector<std::vector<Term>>& basis,
                                      std::size_t variables, const std::vector<int>& form,
                                      std::size_t most) {
    QuotientSpace quotient(basis, variables, most);
    if (!quotient.is_finite()) return std::nullopt;
    const auto products = quotient.multiplications();
    const auto all = sequences(products, form, quotient.dimension(), quotient.index_of({}));
    const Univariate minimal = recurrence(all[0]);
    Solutions result{simple_roots(minimal), {}};
    // At a simple root the numerators are those of the partial fractions: their quotients are the
    // values of the variables.
    Univariate inverse = numerator(all[0], minimal);
    nmod_poly_rem(inverse.get(), inverse.get(), result.polynomial.get());
    if (result.polynomial.degree() == 0) return result;
    if (nmod_poly_invmod(inverse.get(), inverse.get(), result.polynomial.get()) == 0)
        throw TooLarge("a random linear function vanishes at a solution");
    for (std::size_t v = 0; v < form.size(); ++v) {
        Univariate value = numerator(all[v + 1], minimal);
        nmod_poly_rem(value.get(), value.get(), result.polynomial.get());
        nmod_poly_mulmod(value.get(), value.get(), inverse.get(), result.polynomial.get());
        result.unknowns.push_back(std::move(value));
    }
    return result;
}

} // namespace plprove::model
