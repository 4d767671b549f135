// Numbers modulo q that know how they change, to first order, when the unknowns do.
#pragma once

#include "checker/algebra/modular.h"
#include "checker/algebra/vector3.h"

#include <vector>

namespace checker::general {
/// A value, and its derivatives by the unknowns 0, 1, ...; those that are left out at the end are
/// 0.
struct Dual {
    Residue value{};
    std::vector<Residue> change{};
};

inline Dual constant(Residue value) {
    return {value, {}};
}

/// a x + b y of derivatives x and y.
inline std::vector<Residue> combination(Residue a, const std::vector<Residue>& x, Residue b,
                                        const std::vector<Residue>& y) {
    std::vector<Residue> sum(std::max(x.size(), y.size()));
    for (std::size_t i = 0; i < x.size(); ++i)
        sum[i] = a * x[i];
    for (std::size_t i = 0; i < y.size(); ++i)
        sum[i] = sum[i] + b * y[i];
    return sum;
}

inline Dual operator+(const Dual& a, const Dual& b) {
    return {a.value + b.value, combination({1}, a.change, {1}, b.change)};
}

inline Dual operator-(const Dual& a, const Dual& b) {
    return {a.value - b.value, combination({1}, a.change, -Residue{1}, b.change)};
}

inline Dual operator*(const Dual& a, const Dual& b) {
    return {a.value * b.value, combination(b.value, a.change, a.value, b.change)};
}
} // namespace checker::general
