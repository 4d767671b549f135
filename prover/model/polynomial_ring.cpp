#include "prover/model/polynomial_ring.h"

namespace plprove::model {

Polynomial PolynomialRing::inverse(const Polynomial& divisor) {
    if (divisor.is_zero())
        throw BadInput("the model divides by 0, whatever the data: state it without this division");
    if (divisor.is_constant()) return Polynomial(divisor.constant().inverse());
    for (const auto& [known, variable] : inverses_)
        if (known == divisor) return variable;
    if (variables_ == most_variables)
        throw TooLarge("unknowns and inverses of divisors are more than " +
                       std::to_string(most_variables));
    Polynomial variable = Polynomial::variable(variables_++);
    equations_.push_back(variable * divisor - Polynomial(Modular(1)));
    inverses_.emplace_back(divisor, variable);
    return variable;
}

} // namespace plprove::model
