#include "prover/model/monomial.h"

#include <algorithm>
#include <cstring>
#include <numeric>

namespace plprove::model {

int Monomial::degree() const {
    return std::accumulate(exponents.begin(), exponents.end(), 0);
}

bool Monomial::divides(const Monomial& other) const {
    for (std::size_t i = 0; i < most_variables; ++i)
        if (exponents[i] > other.exponents[i]) return false;
    return true;
}

Monomial operator*(const Monomial& a, const Monomial& b) {
    Monomial result;
    unsigned int overflow = 0;
    for (std::size_t i = 0; i < most_variables; ++i) {
        const unsigned int sum = unsigned{a.exponents[i]} + b.exponents[i];
        overflow |= sum >> 8U;
        result.exponents[i] = static_cast<std::uint8_t>(sum);
    }
    if (overflow != 0) throw TooLarge("a polynomial has a degree of more than 255");
    return result;
}

Monomial operator/(const Monomial& a, const Monomial& b) {
    Monomial result;
    for (std::size_t i = 0; i < most_variables; ++i)
        result.exponents[i] = static_cast<std::uint8_t>(a.exponents[i] - b.exponents[i]);
    return result;
}

Monomial variable_monomial(std::size_t variable) {
    Monomial result;
    result.exponents.at(variable) = 1;
    return result;
}

Monomial least_common_multiple(const Monomial& a, const Monomial& b) {
    Monomial result;
    for (std::size_t i = 0; i < most_variables; ++i)
        result.exponents[i] = std::max(a.exponents[i], b.exponents[i]);
    return result;
}

bool grevlex_less(const Monomial& a, const Monomial& b) {
    const int difference = a.degree() - b.degree();
    if (difference != 0) return difference < 0;
    for (std::size_t i = most_variables; i-- > 0;)
        if (a.exponents[i] != b.exponents[i]) return a.exponents[i] > b.exponents[i];
    return false;
}

std::size_t HashOfMonomial::operator()(const Monomial& monomial) const {
    std::array<std::uint64_t, most_variables / 8> words;
    std::memcpy(words.data(), monomial.exponents.data(), most_variables);
    std::uint64_t hash = 0;
    for (const std::uint64_t word : words) {
        hash = (hash ^ word) * 0x9e3779b97f4a7c15U;
        hash ^= hash >> 29U;
    }
    return hash;
}

Polynomial::Polynomial(Modular constant) {
    if (!constant.is_zero()) terms_.push_back({{}, constant});
}

Polynomial Polynomial::variable(std::size_t index) {
    Polynomial result;
    result.terms_.push_back({variable_monomial(index), Modular(1)});
    return result;
}

bool Polynomial::is_constant() const {
    return terms_.empty() || (terms_.size() == 1 && terms_[0].monomial == Monomial{});
}

Modular Polynomial::constant() const {
    return !terms_.empty() && terms_[0].monomial == Monomial{} ? terms_[0].coefficient : Modular{};
}

Polynomial operator+(const Polynomial& a, const Polynomial& b) {
    Polynomial result;
    result.terms_.reserve(a.terms_.size() + b.terms_.size());
    auto x = a.terms_.begin();
    auto y = b.terms_.begin();
    while (x != a.terms_.end() && y != b.terms_.end()) {
        if (x->monomial < y->monomial) {
            result.terms_.push_back(*x++);
        } else if (y->monomial < x->monomial) {
            result.terms_.push_back(*y++);
        } else {
            const Modular sum = x->coefficient + y->coefficient;
            if (!sum.is_zero()) result.terms_.push_back({x->monomial, sum});
            ++x;
            ++y;
        }
    }
    result.terms_.insert(result.terms_.end(), x, a.terms_.end());
    result.terms_.insert(result.terms_.end(), y, b.terms_.end());
    return result;
}

Polynomial operator-(const Polynomial& a, const Polynomial& b) {
    Polynomial negative = b;
    for (Term& term : negative.terms_)
        term.coefficient = -term.coefficient;
    return a + negative;
}

Polynomial operator*(const Polynomial& a, const Polynomial& b) {
    constexpr std::size_t most_products = 20'000'000;
    if (a.terms_.size() * b.terms_.size() > most_products)
        throw TooLarge("a product of polynomials has more than 20,000,000 terms");
    std::vector<Term> products;
    products.reserve(a.terms_.size() * b.terms_.size());
    for (const Term& x : a.terms_)
        for (const Term& y : b.terms_)
            products.push_back({x.monomial * y.monomial, x.coefficient * y.coefficient});
    std::ranges::sort(products, {}, &Term::monomial);
    Polynomial result;
    for (std::size_t i = 0; i < products.size();) {
        Modular sum;
        const Monomial& monomial = products[i].monomial;
        for (; i < products.size() && products[i].monomial == monomial; ++i)
            sum = sum + products[i].coefficient;
        if (!sum.is_zero()) result.terms_.push_back({products[i - 1].monomial, sum});
    }
    return result;
}

bool Polynomial::operator==(const Polynomial& other) const {
    return std::ranges::equal(terms_, other.terms_, [](const Term& x, const Term& y) {
        return x.monomial == y.monomial && x.coefficient == y.coefficient;
    });
}

} // namespace plprove::model
