// Coefficients that are polynomials in the data of a model: each has its value for random data
// modulo q, and is computed by a straight-line program that they share.
#pragma once

#include "prover/geometry/modular.h"

#include <string>
#include <unordered_map>
#include <vector>

namespace plprove::model {

enum class StepKind { literal, datum, negative, sum, difference, product };

/// The operations that compute polynomials in the data. Two polynomials with the same value for
/// random data modulo q are taken for the same, so nothing is computed twice, and what is 0 is
/// known to be. That fails with a probability of about their degree / 2^61.
class DataProgram {
public:
    struct Step {
        StepKind kind = StepKind::literal;
        std::size_t left = 0;  ///< the number of a step before it, or of a datum, from 0
        std::size_t right = 0; ///< the number of a step before it
        double literal = 0;
    };

    const std::vector<Step>& steps() const { return steps_; }
    /// The number of the step with this value, which is added if there is none.
    std::size_t step(const Step& step, Modular value);

private:
    Step simplified(const Step& step, Modular value);

    std::vector<Step> steps_;
    std::unordered_map<Residue, std::size_t> places_; // of steps, by their values
};

/// A polynomial in data: a constant, or the value of a step.
class DataPolynomial {
public:
    DataPolynomial() = default;
    explicit DataPolynomial(int constant) : value_(constant), constant_(constant) {}
    static DataPolynomial datum(DataProgram& program, std::size_t index, Modular value);

    bool is_zero() const { return value_.is_zero(); }
    /// For the random data.
    Modular value() const { return value_; }
    /// The number of its step, in its program or, of a constant, in this one.
    std::size_t step(DataProgram& program) const;

    friend DataPolynomial operator+(const DataPolynomial& a, const DataPolynomial& b);
    friend DataPolynomial operator-(const DataPolynomial& a, const DataPolynomial& b);
    friend DataPolynomial operator*(const DataPolynomial& a, const DataPolynomial& b);
    DataPolynomial operator-() const { return DataPolynomial(-1) * *this; }
    /// Assumes a constant other than 0.
    DataPolynomial inverse() const;

private:
    static DataPolynomial combined(StepKind kind, const DataPolynomial& a, const DataPolynomial& b,
                                   const DataPolynomial& result);

    Modular value_;
    double constant_ = 0;            // unless there is a program
    DataProgram* program_ = nullptr; // nothing for a constant
    std::size_t step_ = 0;
};

} // namespace plprove::model
