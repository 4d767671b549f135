// Random complex numbers that are the same on every machine: integers from a counter (splitmix64),
// exact arithmetic and square roots, nothing from a mathematical library.
#pragma once

#include "prover/three_views/camera_system.h"

#include <cmath>
#include <cstdint>

namespace plprove {

/// Where the coordinates of random points are from.
enum class Field : std::uint8_t { real, complex };

class Random {
public:
    /// Different streams of the same seed are independent sequences.
    Random(std::uint64_t seed, std::uint64_t stream) : state_(mix(mix(seed) + stream)) {}

    std::uint64_t bits() { return mix(state_ += 0x9e3779b97f4a7c15U); }

    /// Uniform in [-1, 1), a multiple of 2^-52.
    double real() { return static_cast<double>(static_cast<std::int64_t>(bits()) >> 11) * 0x1p-52; }

    /// Uniform in the ring 1/4 <= |z| <= 1.
    Complex complex() {
        while (true) {
            const double x = real(), y = real(), square = x * x + y * y;
            if (square <= 1 && square >= 0.0625) return {x, y};
        }
    }

    /// On the unit circle.
    Complex any_phase() {
        const Complex z = complex();
        return z / std::sqrt(z.real() * z.real() + z.imag() * z.imag());
    }

    /// On the unit circle, in the half with positive real part and rather near 1.
    Complex phase() {
        const double slope = 4 * real(), scale = 1 / std::sqrt(1 + slope * slope);
        return {scale, slope * scale};
    }

    Complex3 complex3() { return vector(Field::complex); }

    /// complex(), or its real counterpart: uniform in 1/4 <= |x| <= 1.
    Complex number(Field field) {
        if (field == Field::complex) return complex();
        while (true) {
            const double x = real();
            if (std::abs(x) >= 0.25) return x;
        }
    }

    Complex3 vector(Field field) {
        const Complex x = number(field), y = number(field), z = number(field);
        return {x, y, z};
    }

private:
    static std::uint64_t mix(std::uint64_t x) {
        x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9U;
        x = (x ^ (x >> 27)) * 0x94d049bb133111ebU;
        return x ^ (x >> 31);
    }

    std::uint64_t state_;
};

} // namespace plprove
