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

/// The derivatives at a point, and a decomposition of them: for Newton's method.
class Slopes {
public:
    /// With so many bits. Throws std::runtime_error where they are singular.
    Slopes(const DigitEquations& equations, const std::vector<BigComplex>& point, slong bits)
        : size_(static_cast<slong>(point.size())), bits_(bits),
          few_(std::max(first_bits, 3 * bits / size_)), slopes_(size_, size_),
          factors_(size_, size_), rows_(point.size()) {
        std::vector<BigComplex> rounded = point;
        for (BigComplex& x : rounded)
            acb_set_round(x.get(), x.get(), bits);
        slong row = 0;
        for (const std::vector<BigComplex>& gradient : equations.slopes(rounded, {bits})) {
            slong column = 0;
            for (const BigComplex& slope : gradient)
                acb_set(slopes_.entry(row, column++), slope.get());
            ++row;
        }
        if (acb_mat_approx_lu(rows_.data(), factors_.get(), slopes_.get(), few_) == 0)
            throw std::runtime_error("a solution is singular");
    }

    /// Subtracts the solution x of the system Jx = values from a point with so many bits. Returns
    /// the exponent of the largest change.
    slong subtract_solution(const std::vector<BigComplex>& values, std::vector<BigComplex>& point,
                            slong bits) {
        Matrix right(size_, 1), change(size_, 1);
        slong row = 0;
        for (const BigComplex& value : values)
            acb_set(right.entry(row++, 0), value.get());
        solve(change, right);
        slong largest = -bits;
        for (slong k = 0; k < size_; ++k) {
            BigComplex& x = point[static_cast<std::size_t>(k)];
            largest = std::max(largest, exponent(change.entry(k, 0), -bits));
            acb_sub(x.get(), x.get(), change.entry(k, 0), bits);
            acb_get_mid(x.get(), x.get());
        }
        return largest;
    }

private:
    /// In parts: the decomposition, with few bits, gives the first ones of the solution, then those
    /// of what they leave over. The size of the system says how few are best.
    void solve(Matrix& solution, Matrix& right) {
        Matrix part(size_, 1), rest(size_, 1);
        for (slong known = 0; known < bits_; known += few_ - margin) {
            for (slong row = 0; row < size_; ++row)
                acb_set_round(rest.entry(row, 0), right.entry(row, 0), few_);
            acb_mat_approx_solve_lu_precomp(part.get(), rows_.data(), factors_.get(), rest.get(),
                                            few_);
            for (slong row = 0; row < size_; ++row) {
                acb_add(solution.entry(row, 0), solution.entry(row, 0), part.entry(row, 0), bits_);
                acb_approx_dot(right.entry(row, 0), right.entry(row, 0), 1, slopes_.row(row), 1,
                               part.entry(0, 0), 1, size_, bits_ - known);
            }
        }
    }

    slong size_, bits_, few_;
    Matrix slopes_, factors_;
    std::vector<slong> rows_;
};

/// Steps of Newton's method, each of which gains so many bits, up to so many bits in the end: with
/// the same derivatives, for these cost most. Returns the exponent of the largest change of the
/// last step.
slong steps(const DigitEquations& equations, std::vector<BigComplex>& point, slong bits,
            slong gained, int count) {
    Slopes slopes(equations, point, gained + 2 * margin);
    slong largest = 0;
    for (slong left = count; left > 0; --left) {
        const slong reached = bits - (left - 1) * gained;
        largest = slopes.subtract_solution(equations.values(point, {reached}), point, reached);
    }
    return largest;
}

void refine(const DigitEquations& equations, std::vector<BigComplex>& point) {
    constexpr int most = 40;
    int tries = 0;
    while (steps(equations, point, first_bits, first_bits / 4, 2) > -first_bits / 2)
        if (++tries == most) throw std::runtime_error("Newton's method does not converge");
}

} // namespace

Refinement::Refinement(const DigitEquations& equations, std::vector<RefinedSolution> approximations)
    : equations_(equations), bits_(first_bits), solutions_(std::move(approximations)) {
    for (RefinedSolution& solution : solutions_)
        refine(equations_, solution.coordinates);
}

void Refinement::add_digits() {
    gain(bits_);
}

void Refinement::add_digits_up_to(slong bits) {
    while (bits_ < bits)
        gain(bits - bits_);
}

/// As many bits more as Newton's method can gain with the same derivatives, at most so many.
void Refinement::gain(slong more) {
    const slong reached = bits_ - 2 * margin, gained = std::min(more, reached);
    const int count = gained > reached / 3 ? 2 : 1; // derivatives with half as many bits, or a step
    bits_ += gained;
    const auto refine_some = [&](std::size_t begin, std::size_t end) {
        for (std::size_t n = begin; n < end; ++n) {
            const slong last =
                steps(equations_, solutions_[n].coordinates, bits_, gained / count, count);
            if (last > -(bits_ - gained / count - 2 * margin))
                throw std::runtime_error("Newton's method loses too many digits");
        }
        flint_cleanup(); // what FLINT keeps for a thread
    };
    in_parts(solutions_.size(), std::thread::hardware_concurrency(), refine_some);
}

} // namespace plprove::model
