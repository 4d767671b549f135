// Solutions to as many digits as one likes, by Newton's method.
#pragma once

#include "prover/model/lifting/many_digits.h"

#include <vector>

namespace plprove::model {

/// Equations with rational coefficients, as many as unknowns, at points with many digits.
class DigitEquations {
public:
    DigitEquations() = default;
    DigitEquations(const DigitEquations&) = delete;
    DigitEquations& operator=(const DigitEquations&) = delete;
    virtual ~DigitEquations() = default;

    using Point = std::vector<BigComplex>;

    /// How many threads may ask at once is not limited.
    virtual std::vector<BigComplex> values(const Point& point, const ManyDigits& digits) const = 0;
    /// For each equation its derivatives by all unknowns.
    virtual std::vector<std::vector<BigComplex>> slopes(const Point& point,
                                                        const ManyDigits& digits) const = 0;
};

/// A solution and, unless it is real, its complex conjugate.
struct RefinedSolution {
    bool real = true;
    std::vector<BigComplex> coordinates;
};

/// Solutions to more and more bits.
class Refinement {
public:
    /// To some hundred bits, from approximations. The equations must outlive this object. Throws
    /// std::runtime_error where Newton's method does not converge.
    Refinement(const DigitEquations& equations, std::vector<RefinedSolution> approximations);

    /// To about twice as many bits. Throws std::runtime_error where Newton's method loses too many.
    void add_digits();
    /// To so many bits at least. Throws as add_digits() does.
    void add_digits_up_to(slong bits);

    slong bits() const { return bits_; }
    const std::vector<RefinedSolution>& solutions() const { return solutions_; }

private:
    void gain(slong more);

    const DigitEquations& equations_;
    slong bits_;
    std::vector<RefinedSolution> solutions_;
};

} // namespace plprove::model
