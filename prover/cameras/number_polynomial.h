// Polynomials with integer coefficients in the numbers of a camera: as such, a camera map says what
// the path tracker has to compute.
#pragma once

#include <algorithm>
#include <map>
#include <vector>

namespace plprove {

struct NumberPolynomial {
    /// Of each product of numbers, counted from 0 and ascending, the coefficient; never 0.
    std::map<std::vector<int>, int> terms{};

    static NumberPolynomial number(int k) { return {{{{k}, 1}}}; }
    static NumberPolynomial constant(int value) { return {{{{}, value}}}; }

    void add(const std::vector<int>& factors, int coefficient) {
        const auto term = terms.try_emplace(factors, 0).first;
        term->second += coefficient;
        if (term->second == 0) terms.erase(term);
    }

    friend NumberPolynomial operator+(NumberPolynomial a, const NumberPolynomial& b) {
        for (const auto& [factors, coefficient] : b.terms)
            a.add(factors, coefficient);
        return a;
    }
    friend NumberPolynomial operator-(NumberPolynomial a, const NumberPolynomial& b) {
        for (const auto& [factors, coefficient] : b.terms)
            a.add(factors, -coefficient);
        return a;
    }
    friend NumberPolynomial operator*(const NumberPolynomial& a, const NumberPolynomial& b) {
        NumberPolynomial product;
        for (const auto& [x, coefficient] : a.terms)
            for (const auto& [y, other] : b.terms) {
                std::vector<int> factors = x;
                factors.insert(factors.end(), y.begin(), y.end());
                std::ranges::sort(factors);
                product.add(factors, coefficient * other);
            }
        return product;
    }

    NumberPolynomial derivative(int k) const {
        NumberPolynomial result;
        for (const auto& [factors, coefficient] : terms) {
            const auto power = static_cast<int>(std::ranges::count(factors, k));
            if (power == 0) continue;
            std::vector<int> rest = factors;
            rest.erase(std::ranges::find(rest, k));
            result.add(rest, power * coefficient);
        }
        return result;
    }
};

} // namespace plprove
