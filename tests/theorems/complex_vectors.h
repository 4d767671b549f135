// Vectors of three complex numbers, with the products of proofs that are not Hermitian; and random
// ones.
#pragma once

#include <array>
#include <cmath>
#include <complex>
#include <random>

namespace complex_vectors {

using Complex = std::complex<double>;
using Vector = std::array<Complex, 3>;
inline constexpr Complex i_unit{0, 1};

inline Complex dot(const Vector& a, const Vector& b) {
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}
inline Vector cross(const Vector& a, const Vector& b) {
    return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
inline Vector operator*(Complex c, const Vector& a) {
    return {c * a[0], c * a[1], c * a[2]};
}
inline Vector operator+(const Vector& a, const Vector& b) {
    return {a[0] + b[0], a[1] + b[1], a[2] + b[2]};
}
inline Vector operator-(const Vector& a, const Vector& b) {
    return a + Complex{-1} * b;
}

class Numbers {
public:
    explicit Numbers(unsigned seed) : engine_(seed) {}
    double real() { return std::uniform_real_distribution<>(-1, 1)(engine_); }
    Complex complex() { return {real(), real()}; }
    Vector real_vector() { return {real(), real(), real()}; }
    Vector complex_vector() { return {complex(), complex(), complex()}; }
    Vector unit_vector() {
        const Vector x = complex_vector();
        return 1.0 / std::sqrt(dot(x, x)) * x;
    }

private:
    std::mt19937_64 engine_;
};

} // namespace complex_vectors
