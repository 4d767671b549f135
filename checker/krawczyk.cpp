#include "checker/krawczyk.h"

#ifndef PLC_ARB
namespace checker {
bool has_arb() {
    return false;
}
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

namespace checker {
bool has_arb() {
    return true;
}

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

/// Proves with so many bits, after so many Newton steps, that a box contains one solution, and that
/// not degenerate (proofs/degrees.md, section 1). Returns why there is no proof, if there is none.
template <slong bits>
static std::string_view prove(const System& system, const Start& start, int steps, Box& box) {
    constexpr std::size_t n = camera_unknowns;
    Coordinates<Ball<bits>> z, row;
    for (std::size_t i = 0; i < n; ++i) {
        acb_set_si_si(z[i].get(), start.coordinates[i][0], start.coordinates[i][1]);
        acb_mul_2exp_si(z[i].get(), z[i].get(), -start.bits);
    }
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
    for (evaluate_all();; evaluate_all(), --steps) {
        if (!acb_mat_approx_inv(inverse.entries, jacobian.entries, bits)) return "no inverse";
        acb_mat_mul(change.entries, inverse.entries, values.entries, bits);
        if (steps == 0) break;
        for (std::size_t i = 0; i < n; ++i) {
            acb_sub(z[i].get(), z[i].get(), change.at(i, 0), bits);
            acb_get_mid(z[i].get(), z[i].get());
            if (start.real) arb_zero(acb_imagref(z[i].get()));
        }
    }

    // The radii: four times the next step, and equal relative to the sizes of the coordinates.
    std::array<double, n> radius;
    double relative = std::ldexp(1.0, 8 - bits);
    for (std::size_t i = 0; i < n; ++i) {
        radius[i] = 1 + magnitude(z[i].get());
        relative = std::max(relative, 4 * magnitude(change.at(i, 0)) / radius[i]);
    }
    for (std::size_t i = 0; i < n; ++i) {
        const Ball<bits> error(radius[i] *= relative);
        acb_add_error_arb(z[i].get(), acb_realref(error.get()));
    }

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
    std::string_view reason = prove<64>(system, start, 0, box);
    if (!reason.empty()) reason = prove<64>(system, start, 2, box);
    if (!reason.empty()) reason = prove<128>(system, start, 5, box);
    if (!reason.empty()) reason = prove<256>(system, start, 9, box);
    if (!reason.empty()) throw Refused(reason);
    return box;
}
} // namespace checker
#endif
