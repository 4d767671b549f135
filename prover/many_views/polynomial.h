// Polynomials in time: what images on a straight way are, and what follows from them.
#pragma once

#include <algorithm>
#include <complex>
#include <vector>

namespace plprove::many_views {

/// A polynomial, by the coefficients of 1, t, t^2, ...
class Polynomial {
public:
    using Coefficient = std::complex<double>;

    Polynomial() = default;
    explicit Polynomial(const Coefficient& constant) : coefficients_{constant} {}
    /// a + b t.
    Polynomial(const Coefficient& a, const Coefficient& b) : coefficients_{a, b} {}

    const std::vector<Coefficient>& coefficients() const { return coefficients_; }

    friend Polynomial operator+(const Polynomial& a, const Polynomial& b) {
        Polynomial sum = a;
        sum.coefficients_.resize(std::max(a.size(), b.size()));
        for (std::size_t i = 0; i < b.size(); ++i)
            sum.coefficients_[i] += b.coefficients_[i];
        return sum;
    }
    friend Polynomial operator-(const Polynomial& a, const Polynomial& b) {
        return a + Polynomial(-1) * b;
    }
    friend Polynomial operator*(const Polynomial& a, const Polynomial& b) {
        Polynomial product;
        if (a.size() == 0 || b.size() == 0) return product;
        product.coefficients_.resize(a.size() + b.size() - 1);
        for (std::size_t i = 0; i < a.size(); ++i)
            for (std::size_t j = 0; j < b.size(); ++j)
                product.coefficients_[i + j] += a.coefficients_[i] * b.coefficients_[j];
        return product;
    }
    bool operator==(const Polynomial&) const = default;

private:
    std::size_t size() const { return coefficients_.size(); }

    std::vector<Coefficient> coefficients_;
};

} // namespace plprove::many_views
