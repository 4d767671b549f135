#include "checker/degrees/krawczyk.h"

#ifndef PLC_ARB
namespace checker {
const bool has_arb = false;
Box certify(const CameraSystem&, const ApproximateSolution&) {
    throw Refused("this plcheck was built without Arb");
}
std::vector<Proof> certify_all(const CameraSystem&, std::span<const ApproximateSolution>,
                               std::size_t) {
    throw Refused("this plcheck was built without Arb");
}
} // namespace checker
#else
#include "checker/degrees/ball.h"
#include "checker/degrees/newton.h"

#include <atomic>
#include <future>

namespace checker {
const bool has_arb = true;

/// Krawczyk's operator of a system, computed with so many bits (proofs/degrees.md, section 1).
template <slong bits> class Krawczyk {
public:
    Krawczyk(const CameraSystem& system, const CameraCoordinates<Complex>& start, bool real)
        : system_(system), real_(real) {
        for (std::size_t i = 0; i < z_.size(); ++i)
            acb_set_d_d(z_[i].get(), start[i].real(), start[i].imag());
    }

    /// Proves, after at most so many Newton steps, that a box contains one zero, and that this is a
    /// solution. Returns why not, if there is no proof.
    std::string_view prove(int steps, Box& box) {
        if (!choose_radii(steps)) return "no inverse";
        for (std::size_t i = 0; i < z_.size(); ++i)
            acb_add_error_arb(z_[i].get(), acb_realref(Ball<bits>(radii_[i]).get()));
        evaluate_all();
        if (!contracts()) return "no proof of a zero near the starting value";
        box = enclosing_box();
        return degeneracy(system_, z_, space_);
    }

private:
    /// Sets the values and the Jacobian at z.
    void evaluate_all() {
        back_project(system_, z_, space_);
        CameraCoordinates<Ball<bits>> row;
        for (std::size_t e = 0; e < z_.size(); ++e) {
            Ball<bits> value = evaluate(system_, system_.equations[e], space_, row);
            acb_swap(values_.at(e, 0), value.get());
            for (std::size_t k = 0; k < z_.size(); ++k)
                acb_swap(jacobian_.at(e, k), row[k].get());
        }
    }

    /// Makes at most so many Newton steps, until they are small. Then the radii are four times the
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
        Box box;
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

    const CameraSystem& system_;
    bool real_;
    CameraCoordinates<Ball<bits>> z_; // a point, then a box around it
    BackProjections<Ball<bits>> space_;
    std::array<double, camera_unknowns> radii_{};
    BallMatrix values_{1}, change_{1}, jacobian_{camera_unknowns}, inverse_{camera_unknowns};
};

Box certify(const CameraSystem& system, const ApproximateSolution& start) {
    const CameraCoordinates<Complex> z = refine_by_newton(system, start);
    Box box;
    std::string_view reason = Krawczyk<64>(system, z, start.real).prove(2, box);
    if (!reason.empty()) {
        reason = Krawczyk<128>(system, z, start.real).prove(6, box);
        box.tries = 2;
    }
    if (!reason.empty()) {
        reason = Krawczyk<256>(system, z, start.real).prove(9, box);
        box.tries = 3;
    }
    if (!reason.empty()) throw Refused(reason);
    return box;
}

std::vector<Proof> certify_all(const CameraSystem& system,
                               std::span<const ApproximateSolution> starts, std::size_t threads) {
    std::vector<Proof> proofs(starts.size());
    std::atomic<std::size_t> next = 0; // start that no thread has taken
    const auto work = [&] {
        for (std::size_t i = next++; i < starts.size(); i = next++)
            try {
                proofs[i] = certify(system, starts[i]);
            } catch (const Refused& refused) {
                proofs[i] = refused;
            }
    };
    std::vector<std::future<void>> others;
    try {
        while (others.size() + 1 < std::min(threads, starts.size()))
            others.push_back(std::async(std::launch::async, [&] {
                work();
                flint_cleanup(); // what Arb keeps for a thread
            }));
    } catch (const std::system_error&) {
        // The system gives no more threads: fewer do it.
    }
    work();
    for (std::future<void>& other : others)
        other.get();
    return proofs;
}
} // namespace checker
#endif
