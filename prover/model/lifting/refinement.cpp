#include "prover/model/lifting/refinement.h"

#include "prover/system/in_parts.h"

#include <algorithm>
#include <flint/flint.h>
#include <stdexcept>
#include <thread>

namespace plprove::model {

namespace {

constexpr slong first_bits = 256;
/// Bits of a step that the condition of the equations may cost, with a good margin.
constexpr slong margin = 64;

class Matrix {
public:
    Matrix(slong rows, slong columns) { acb_mat_init(value_, rows, columns); }
    Matrix(const Matrix&) = delete;
    Matrix& operator=(const Matrix&) = delete;
    ~Matrix() { acb_mat_clear(value_); }

    acb_mat_struct* get() { return value_; }
    const acb_mat_struct* get() const { return value_; }
    acb_ptr entry(slong row, slong column) { return acb_mat_entry(value_, row, column); }
    acb_srcptr row(slong row) const { return value_->rows[row]; }

private:
    acb_mat_t value_;
};

/// The least e with |x| < 2^e, or nearly so; `least` if there is none above it.
slong exponent(acb_srcptr x, slong least) {
    mag_t size;
    mag_init(size);
    acb_get_mag(size, x);
    slong result = least;
    if (!mag_is_zero(size)) result = std::max(least, fmpz_get_si(MAG_EXPREF(size)));
    mag_clear(size);
    return result;
}

/// Solves a system with so many bits, in parts: a decomposition with few bits gives the first ones
/// of the solution, then those of what they leave over. The size of the system says how few are
/// best.
void solve(Matrix& solution, const Matrix& system, Matrix& right, slong size, slong bits) {
    const slong few = std::max(first_bits, 3 * bits / size);
    Matrix factors(size, size), part(size, 1), rest(size, 1);
    std::vector<slong> rows(static_cast<std::size_t>(size));
    if (acb_mat_approx_lu(rows.data(), factors.get(), system.get(), few) == 0)
        throw std::runtime_error("a solution is singular");
    for (slong known = 0; known < bits; known += few - margin) {
        for (slong row = 0; row < size; ++row)
            acb_set_round(rest.entry(row, 0), right.entry(row, 0), few);
        acb_mat_approx_solve_lu_precomp(part.get(), rows.data(), factors.get(), rest.get(), few);
        for (slong row = 0; row < size; ++row) {
            acb_add(solution.entry(row, 0), solution.entry(row, 0), part.entry(row, 0), bits);
            acb_approx_dot(right.entry(row, 0), right.entry(row, 0), 1, system.row(row), 1,
                           part.entry(0, 0), 1, size, bits - known);
        }
    }
}

/// A Newton step with so many bits; for the derivatives those that it gains do. Returns the
/// exponent of its largest change.
slong step(const DigitEquations& equations, std::vector<BigComplex>& point, slong bits,
           slong gained) {
    const auto size = static_cast<slong>(point.size());
    const ManyDigits fine{bits}, coarse{gained + 2 * margin};
    std::vector<BigComplex> rounded = point;
    for (BigComplex& x : rounded)
        acb_set_round(x.get(), x.get(), coarse.bits);
    Matrix jacobian(size, size), right(size, 1), change(size, 1);
    slong row = 0;
    for (const BigComplex& value : equations.values(point, fine))
        acb_set(right.entry(row++, 0), value.get());
    row = 0;
    for (const std::vector<BigComplex>& slopes : equations.slopes(rounded, coarse)) {
        slong column = 0;
        for (const BigComplex& slope : slopes)
            acb_set(jacobian.entry(row, column++), slope.get());
        ++row;
    }
    solve(change, jacobian, right, size, coarse.bits);
    slong largest = -bits;
    for (slong k = 0; k < size; ++k) {
        BigComplex& x = point[static_cast<std::size_t>(k)];
        largest = std::max(largest, exponent(change.entry(k, 0), -bits));
        acb_sub(x.get(), x.get(), change.entry(k, 0), bits);
        acb_get_mid(x.get(), x.get());
    }
    return largest;
}

void refine(const DigitEquations& equations, std::vector<BigComplex>& point) {
    constexpr int most_steps = 40;
    int steps = 0;
    while (step(equations, point, first_bits, first_bits / 2) > -first_bits / 2)
        if (++steps == most_steps) throw std::runtime_error("Newton's method does not converge");
}

} // namespace

Refinement::Refinement(const DigitEquations& equations, std::vector<RefinedSolution> approximations)
    : equations_(equations), bits_(first_bits), solutions_(std::move(approximations)) {
    for (RefinedSolution& solution : solutions_)
        refine(equations_, solution.coordinates);
}

void Refinement::add_digits() {
    constexpr slong few = 2000; // cost hardly more than fewer
    const slong reached = bits_ - 2 * margin, gained = bits_ < few ? reached : bits_ / 2;
    bits_ += gained;
    const auto refine_some = [&](std::size_t begin, std::size_t end) {
        for (std::size_t n = begin; n < end; ++n)
            if (step(equations_, solutions_[n].coordinates, bits_, gained) > -reached)
                throw std::runtime_error("Newton's method loses too many digits");
        flint_cleanup(); // what FLINT keeps for a thread
    };
    in_parts(solutions_.size(), std::thread::hardware_concurrency(), refine_some);
}

} // namespace plprove::model
