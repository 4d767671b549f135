// Numbers modulo q and a polynomial g that know how they change with the unknowns of a model.
#pragma once

#include "checker/algebra/dual.h"
#include "checker/fibres/extension.h"

namespace checker {
/// A ring for models: elements of the extension that know how they change with each unknown.
/// Changes that are left out are 0.
class DualExtension {
public:
    struct Element {
        Polynomial value{};
        std::vector<Polynomial> change{};
    };

    explicit DualExtension(const Extension& extension) : extension_(extension) {}

    Element constant(int number) const {
        return {extension_.constant(in_ring<Residue>(number)), {}};
    }
    /// The unknown of this number.
    Element unknown(Polynomial value, std::size_t number) const;
    Element add(const Element& a, const Element& b) const;
    Element multiply(const Element& a, const Element& b) const;
    /// Of a constant. Throws Refused if it is 0.
    Element inverse(const Element& a) const;

private:
    const Extension& extension_;
};
} // namespace checker
