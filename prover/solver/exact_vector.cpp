#include "prover/solver/exact_vector.h"

#include <algorithm>
#include <cmath>

namespace plprove {

namespace {

IntegerVector integers(const std::array<mpz_class, 3>& x) {
    return {x[0].get_si(), x[1].get_si(), x[2].get_si()};
}

} // namespace

std::optional<IntegerVector> proportional(const ExactVector& x, std::int64_t largest) {
    mpz_class denominator = 1, divisor = 0;
    for (const mpq_class& coordinate : x)
        denominator = lcm(denominator, coordinate.get_den());
    std::array<mpz_class, 3> result;
    for (std::size_t k = 0; k < 3; ++k) {
        result[k] = x[k].get_num() * (denominator / x[k].get_den());
        divisor = gcd(divisor, result[k]);
    }
    for (mpz_class& coordinate : result) {
        coordinate /= divisor;
        if (abs(coordinate) > largest) return std::nullopt;
    }
    return integers(result);
}

IntegerVector nearest(const ExactVector& x, std::int64_t largest) {
    mpq_class size = 0;
    for (const mpq_class& coordinate : x)
        size = std::max<mpq_class>(size, abs(coordinate));
    std::array<mpz_class, 3> result;
    for (std::size_t k = 0; k < 3; ++k) {
        const mpq_class twice = 2 * (largest * x[k] / size) + 1;
        mpz_fdiv_q(result[k].get_mpz_t(), twice.get_num_mpz_t(),
                   mpz_class(2 * twice.get_den()).get_mpz_t());
    }
    return integers(result);
}

mpq_class dot(const ExactVector& a, const ExactVector& b) {
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

ExactVector exact_cross(const ExactVector& a, const ExactVector& b) {
    return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

ExactVector exact(const IntegerVector& x) {
    return {mpq_class(x[0]), mpq_class(x[1]), mpq_class(x[2])};
}

double angle(const ExactVector& a, const ExactVector& b) {
    const ExactVector normal = exact_cross(a, b);
    const mpq_class squared_sine = dot(normal, normal) / (dot(a, a) * dot(b, b));
    return std::asin(std::min(1.0, std::sqrt(squared_sine.get_d())));
}

} // namespace plprove
