// Fields of residues modulo a prime, where programs are run.
#pragma once

#include "prover/geometry/modular.h"

#include <stdexcept>

namespace plprove::model {

/// Something was to be divided by that has no inverse.
class NotInvertible : public std::runtime_error {
public:
    NotInvertible() : std::runtime_error("a divisor vanishes at the chosen point") {}
};

/// The field of these numbers: Modular, or SmallModular.
template <class Number>
struct PrimeFieldOf {
    using Element = Number;

    static Element constant(int value) { return Element(value); }
    static Element sum(Element a, Element b) { return a + b; }
    static Element difference(Element a, Element b) { return a - b; }
    static Element product(Element a, Element b) { return a * b; }
    static bool is_zero(Element a) { return a.is_zero(); }
    static Element inverse(Element a) {
        if (a.is_zero()) throw NotInvertible();
        return a.inverse();
    }
};

/// The field of q elements.
using PrimeField = PrimeFieldOf<Modular>;

} // namespace plprove::model
