#include "checker/krawczyk.h"

#ifndef PLC_ARB
namespace checker {
const bool has_arb = false;
Box certify(const System&, const Start&) {
    throw Refused("this plcheck was built without Arb");
}
} // namespace checker
#else
#if __has_include(<flint/acb_mat.h>)
#include <flint/acb_mat.h>
#else
#include <acb_mat.h>
#endif

#include <cmath>
#include <complex>

namespace checker {
const bool has_arb = true;

/// A set of complex numbers, a rectangle: what is computed of balls contains all that is computed
/// of their elements. The midpoint has so many bits.
template <slong bits> class Ball {
public:
    Ball() { acb_init(value_); }
    explicit Ball(double x) : Ball() { acb_set_d(value_, x); }
    Ball(const Ball& other) : Ball() { acb_set(value_, other.value_); }
    Ball(Ball&& other) noexcept : Ball() { acb_swap(value_, other.value_); }
    Ball& operator=(Ball other) noexcept { return acb_swap(value_, other.value_), *this; }
    ~Ball() { acb_clear(value_); }
    acb_ptr get() { return value_; }
    acb_srcptr get() const { return value_; }
    Ball operator+(const Ball& other) const { return apply(acb_add, other); }
    Ball operator-(const Ball& other) const { return apply(acb_sub, other); }
    Ball operator*(const Ball& other) const { return apply(acb_mul, other); }
    Ball operator-() const { return Ball() - *this; }

private:
    template <class Operation> Ball apply(Operation operation, const Ball& other) const {
        Ball result;
        operation(result.value_, value_, other.value_, bits);
        return result;
    }
    acb_t value_;
};

template <slong bits> bool nonzero(const Ball<bits>& x) {
    return !acb_contains_zero(x.get());
}

template <slong bits> Ball<bits> dot(const Triple<Ball<bits>>& a, const Triple<Ball<bits>>& b) {
    static_assert(sizeof(a) == 3 * sizeof(acb_struct)); // an array of acb_t
    Ball<bits> sum;
    acb_dot(sum.get(), nullptr, 0, a[0].get(), 1, b[0].get(), 1, 3, bits);
    return sum;
}

/// An upper bound of the absolute value, up to an underflow.
static double magnitude(acb_srcptr x) {
    mag_t bound;
    mag_init(bound);
    acb_get_mag(bound, x);
    const double result = mag_get_d(bound);
    mag_clear(bound);
    return result;
}

/// A matrix of balls.
struct Matrix {
    explicit Matrix(slong columns) { acb_mat_init(entries, camera_unknowns, columns); }
    Matrix(const Matrix&) = delete;
    Matrix& operator=(const Matrix&) = delete;
    ~Matrix() { acb_mat_clear(entries); }
    acb_ptr at(std::size_t r, std::size_t c) { return acb_mat_entry(entries, slong(r), slong(c)); }
    acb_mat_t entries;
};

using Complex = std::complex<double>;

/// Solves linear equations, rows with the right side last, by elimination; garbage if it cannot.
static Coordinates<Complex>
solve(std::array<std::array<Complex, camera_unknowns + 1>, camera_unknowns> m) {
    Coordinates<Complex> solution;
    for (std::size_t c = 0; c < m.size(); ++c) {
        const auto size = [&](const auto& row) { return std::norm(row[c]); };
        std::swap(m[c],
                  *std::ranges::max_element(m.begin() + std::ptrdiff_t(c), m.end(), {}, size));
        for (std::size_t r = 0; r < m.size(); ++r) {
            const Complex factor = m[r][c] / m[c][c];
            for (std::size_t k = c; r != c && k < m[r].size(); ++k) m[r][k] -= factor * m[c][k];
        }
    }
    for (std::size_t i = 0; i < m.size(); ++i) solution[i] = m[i].back() / m[i][i];
    return solution;
}

/// Where Newton steps in doubles lead from the starting values.
static Coordinates<Complex> approach(const System& system, const Start& start) {
    Coordinates<Complex> z, row;
    for (std::size_t i = 0; i < z.size(); ++i)
        z[i] = std::ldexp(1.0, -int(start.bits)) *
               Complex(double(start.coordinates[i][0]), double(start.coordinates[i][1]));
    Scene<Complex> scene;
    double relative = 1; // size of the last step
    for (int step = 0; step < 8 && relative > 1e-10; ++step) {
        std::array<std::array<Complex, camera_unknowns + 1>, camera_unknowns> rows;
        look(system, z, scene);
        for (std::size_t e = 0; e < z.size(); ++e) {
            rows[e].back() = evaluate(system, system.equations[e], scene, row);
            std::copy(row.begin(), row.end(), rows[e].begin());
        }
        const Coordinates<Complex> change = solve(rows);
        relative = 0;
        for (std::size_t i = 0; i < z.size(); ++i) {
            z[i] -= start.real ? change[i].real() : change[i];
            relative = std::max(relative, std::abs(change[i]) / (1 + std::abs(z[i])));
        }
    }
    return z;
}

/// Proves with so many bits, after at most so many Newton steps, that a box contains one solution,
/// and that not degenerate (proofs/degrees.md, section 1). Returns why not, if there is no proof.
template <slong bits>
static std::string_view prove(const System& system, const Coordinates<Complex>& start, bool real,
                              int steps, Box& box) {
    constexpr std::size_t n = camera_unknowns;
    Coordinates<Ball<bits>> z, row;
    for (std::size_t i = 0; i < n; ++i) acb_set_d_d(z[i].get(), start[i].real(), start[i].imag());
    Scene<Ball<bits>> scene;
    Matrix values(1), change(1), jacobian(n), inverse(n);
    const auto evaluate_all = [&] {
        look(system, z, scene);
        for (std::size_t e = 0; e < n; ++e) {
            auto value = evaluate(system, system.equations[e], scene, row);
            acb_swap(values.at(e, 0), value.get());
            for (std::size_t k = 0; k < n; ++k) acb_swap(jacobian.at(e, k), row[k].get());
        }
    };
    // The radii are four times the next step, and equal relative to the sizes of the coordinates.
    std::array<double, n> radius;
    for (;; --steps) {
        evaluate_all();
        if (!acb_mat_approx_inv(inverse.entries, jacobian.entries, bits)) return "no inverse";
        acb_mat_mul(change.entries, inverse.entries, values.entries, bits);
        double relative = std::ldexp(1.0, 8 - bits);
        for (std::size_t i = 0; i < n; ++i) {
            radius[i] = 1 + magnitude(z[i].get());
            relative = std::max(relative, 4 * magnitude(change.at(i, 0)) / radius[i]);
        }
        for (double& r : radius) r *= relative;
        if (steps == 0 || relative < std::ldexp(1.0, -bits / 3)) break;
        for (std::size_t i = 0; i < n; ++i) {
            acb_sub(z[i].get(), z[i].get(), change.at(i, 0), bits);
            acb_get_mid(z[i].get(), z[i].get());
            if (real) arb_zero(acb_imagref(z[i].get()));
        }
    }
    for (std::size_t i = 0; i < n; ++i)
        acb_add_error_arb(z[i].get(), acb_realref(Ball<bits>(radius[i]).get()));

    evaluate_all();
    acb_mat_mul(jacobian.entries, inverse.entries, jacobian.entries, bits);
    for (std::size_t i = 0; i < n; ++i) { // |Y F(m)| + |Y J(X) - I| r < r
        acb_sub_ui(jacobian.at(i, i), jacobian.at(i, i), 1, bits);
        double reach = magnitude(change.at(i, 0));
        for (std::size_t k = 0; k < n; ++k) reach += magnitude(jacobian.at(i, k)) * radius[k];
        // The factor is for the rounding errors and underflows of this sum.
        if (!(reach * 1.000001 < radius[i])) return "no proof of a zero near the starting value";
        for (std::size_t part = 0; part < 2; ++part) { // with a margin for rounding errors
            arb_srcptr x = part == 0 ? acb_realref(z[i].get()) : acb_imagref(z[i].get());
            const double middle = arf_get_d(arb_midref(x), ARF_RND_NEAR);
            const double width = radius[i] + std::ldexp(std::abs(middle) + radius[i], -50);
            box.low[2 * i + part] = middle - width, box.high[2 * i + part] = middle + width;
        }
    }
    return degeneracy(system, z, scene);
}

Box certify(const System& system, const Start& start) {
    Box box;
    const Coordinates<Complex> z = approach(system, start);
    std::string_view reason = prove<64>(system, z, start.real, 2, box);
    if (!reason.empty()) reason = prove<128>(system, z, start.real, 6, box);
    if (!reason.empty()) reason = prove<256>(system, z, start.real, 9, box);
    if (!reason.empty()) throw Refused(reason);
    return box;
}
} // namespace checker
#endif
