// Polynomials modulo q and g as a field for the camera equations (prover/fibres/cameras_over.h).
#pragma once

#include "prover/model/fields.h"

namespace plprove {

struct UnivariateField : model::Algebra {
    using model::Algebra::Algebra;

    model::Univariate constant(std::int64_t value) const { return scaled(one(), value); }
    model::Univariate scaled(const model::Univariate& a, std::int64_t factor) const {
        return product(a, model::Univariate({Modular(factor)}));
    }

private:
    model::Univariate one() const { return model::Algebra::constant(1); }
};

} // namespace plprove
