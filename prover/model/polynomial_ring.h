// A program over polynomials modulo q: its data are residues, its unknowns variables. The inverse
// of a divisor is a variable of its own.
#pragma once

#include "prover/model/evaluation.h"
#include "prover/model/polynomial.h"

#include <span>

namespace plprove::model {

class PolynomialRing {
public:
    using Scalar = Polynomial;

    PolynomialRing(std::span<const Modular> data, std::size_t unknowns)
        : data_(data), variables_(unknowns) {}

    static Polynomial constant(int value) { return Polynomial(Modular(value)); }
    static Polynomial zero() { return {}; }
    Polynomial datum(std::size_t index) const { return Polynomial(data_[index]); }
    static Polynomial unknown(std::size_t index) { return Polynomial::variable(index); }
    static Polynomial sum(const Polynomial& a, const Polynomial& b) { return a + b; }
    static Polynomial difference(const Polynomial& a, const Polynomial& b) { return a - b; }
    static Polynomial product(const Polynomial& a, const Polynomial& b) { return a * b; }
    Polynomial quotient(const Polynomial& a, const Polynomial& b, const Operation& /*which*/) {
        return a * inverse(b);
    }

    /// The inverse of a polynomial: a constant, or a variable w with w times the polynomial = 1.
    Polynomial inverse(const Polynomial& divisor);

    /// How many variables there are, those of inverses included.
    std::size_t variables() const { return variables_; }
    /// w times its divisor, minus 1, of each inverse.
    const std::vector<Polynomial>& equations_of_inverses() const { return equations_; }

private:
    std::span<const Modular> data_;
    std::size_t variables_;
    std::vector<std::pair<Polynomial, Polynomial>> inverses_; // divisor, variable
    std::vector<Polynomial> equations_;
};

} // namespace plprove::model
