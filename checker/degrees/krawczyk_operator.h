// Krawczyk's operator in ball arithmetic, for any square system of equations
// (proofs/degrees.md, section 1). Needs the library Arb.
//
// A class At<T> stands for a system at some place, over a ring T of numbers:
//     At(system)
//     void move_to(z)         goes to the place z, of type std::vector<T>
//     T equation(e, row)      the value of the e-th equation there; its derivatives go to the row
//     degeneracy()            which condition on a solution is not proved; empty if all are
#pragma once

#include "checker/degrees/ball.h"
#include "checker/degrees/newton.h"

namespace checker {
/// The operator, computed with `bits` bits.
template <slong bits, template <class> class At, class System> class Krawczyk {
public:
    Krawczyk(const System& system, const std::vector<Complex>& start, bool real)
        : system_(system), real_(real), z_(start.size()), radii_(start.size()) {
        for (std::size_t i = 0; i < z_.size(); ++i)
            acb_set_d_d(z_[i].get(), start[i].real(), start[i].imag());
    }

    /// Proves, after at most `steps` Newton steps, that a box contains one zero, and that this is a
    /// solution. Returns why not, if there is no proof.
    std::string_view prove(int steps, Box& box) {
        if (!choose_radii(steps)) return "no inverse";
        for (std::size_t i = 0; i < z_.size(); ++i)
            acb_add_error_arb(z_[i].get(), acb_realref(Ball<bits>(radii_[i]).get()));
        evaluate_all();
        if (!contracts()) return "no proof of a zero near the starting value";
        box = enclosing_box();
        return system_.degeneracy();
    }

private:
    /// Sets the values and the Jacobian at z.
    void evaluate_all() {
        system_.move_to(z_);
        std::vector<Ball<bits>> row(z_.size());
        for (std::size_t e = 0; e < z_.size(); ++e) {
            Ball<bits> value = system_.equation(e, row);
            acb_swap(values_.at(e, 0), value.get());
            for (std::size_t k = 0; k < z_.size(); ++k)
                acb_swap(jacobian_.at(e, k), row[k].get());
        }
    }

    /// Makes at most `steps` Newton steps, until they are small. Then the radii are four times the
    /// next step, and equal relative to the sizes of the coordinates. False without an inverse.
    bool choose_radii(int steps) {
        for (;; --steps) {
            evaluate_all();
            if (!acb_mat_approx_inv(inverse_.get(), jacobian_.get(), bits)) return false;
            acb_mat_mul(change_.get(), inverse_.get(), values_.get(), bits);
            double relative = std::ldexp(1.0, 8 - int{bits});
            for (std::size_t i = 0; i < z_.size(); ++i) {
                radii_[i] = 1 + magnitude(z_[i].get());
                relative = std::max(relative, 4 * magnitude(change_.at(i, 0)) / radii_[i]);
            }
            for (double& radius : radii_)
                radius *= relative;
            if (steps == 0 || relative < std::ldexp(1.0, -int{bits} / 3)) return true;
            make_step();
        }
    }

    void make_step() {
        for (std::size_t i = 0; i < z_.size(); ++i) {
            acb_ptr z = z_[i].get();
            acb_sub(z, z, change_.at(i, 0), bits);
            acb_get_mid(z, z);
            if (real_) arb_zero(acb_imagref(z));
        }
    }

    /// Whether |Y F(m)| + |Y J(X) - I| r < r in each coordinate: m is the middle of the box X, r
    /// its radii, Y the inverse, F the equations. `change_` is still Y F(m).
    bool contracts() {
        acb_mat_mul(jacobian_.get(), inverse_.get(), jacobian_.get(), bits);
        for (std::size_t i = 0; i < z_.size(); ++i) {
            acb_sub_ui(jacobian_.at(i, i), jacobian_.at(i, i), 1, bits);
            double reach = magnitude(change_.at(i, 0));
            for (std::size_t k = 0; k < z_.size(); ++k)
                reach += magnitude(jacobian_.at(i, k)) * radii_[k];
            // The factor is for the rounding errors and underflows of this sum.
            if (!(reach * 1.000001 < radii_[i])) return false;
        }
        return true;
    }

    /// The box, with a margin for rounding errors.
    Box enclosing_box() {
        Box box{std::vector<double>(2 * z_.size()), std::vector<double>(2 * z_.size())};
        for (std::size_t i = 0; i < z_.size(); ++i) {
            const std::array<arb_srcptr, 2> parts{acb_realref(z_[i].get()),
                                                  acb_imagref(z_[i].get())};
            for (std::size_t part = 0; part < 2; ++part) {
                const double middle = arf_get_d(arb_midref(parts[part]), ARF_RND_NEAR);
                const double margin = std::ldexp(std::abs(middle) + radii_[i], -50);
                box.low[2 * i + part] = middle - (radii_[i] + margin);
                box.high[2 * i + part] = middle + (radii_[i] + margin);
            }
        }
        return box;
    }

    At<Ball<bits>> system_;
    bool real_;
    std::vector<Ball<bits>> z_; // a point, then a box around it
    std::vector<double> radii_;
    BallMatrix values_{z_.size(), 1}, change_{z_.size(), 1};
    BallMatrix jacobian_{z_.size(), z_.size()}, inverse_{z_.size(), z_.size()};
};

/// A box with one nondegenerate solution of the system, to which Newton steps from the starting
/// values lead. The solution is real if these are. Throws Refused without a proof.
template <template <class> class At, class System>
Box prove_box(const System& system, const ApproximateSolution& start) {
    const std::vector<Complex> z = refine_by_newton<At>(system, start);
    Box box;
    std::string_view reason = Krawczyk<64, At, System>(system, z, start.real).prove(2, box);
    if (!reason.empty()) {
        reason = Krawczyk<128, At, System>(system, z, start.real).prove(6, box);
        box.tries = 2;
    }
    if (!reason.empty()) {
        reason = Krawczyk<256, At, System>(system, z, start.real).prove(9, box);
        box.tries = 3;
    }
    if (!reason.empty()) throw Refused(reason);
    return box;
}
} // namespace checker
