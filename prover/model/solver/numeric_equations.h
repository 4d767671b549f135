// The equations of a model in complex numbers, and Newton's method: for points, one at a time.
#pragma once

#include "prover/model/program.h"

#include <Eigen/Core>
#include <complex>
#include <optional>
#include <vector>

namespace plprove::model {

/// Values of all unknowns, or of all scalars of data.
using Numbers = std::vector<std::complex<double>>;

/// The equations at a point, and their derivatives.
struct Linearisation {
    Eigen::VectorXcd values;
    Eigen::MatrixXcd by_unknowns;
    Eigen::MatrixXcd by_data; ///< empty unless asked for
};

/// Nothing where a divisor is 0, or a number is not finite.
std::optional<Linearisation> linearise(const Program& program, const Numbers& data,
                                       const Numbers& unknowns, bool by_data);

/// By what a solution is counted: the values that the model counts, else the unknowns. Nothing
/// where a divisor is 0, or a number is not finite.
std::optional<Numbers> counted_values(const Program& program, const Numbers& data,
                                      const Numbers& unknowns);

/// The largest absolute value of an equation, each relative to the sum of 1 and of the sizes of the
/// unknowns times its derivatives by them; infinite where there is none.
double residual_of(const Program& program, const Numbers& data, const Numbers& unknowns);

/// Whether no condition is as small as rounding may make a zero.
bool keeps_conditions(const Program& program, const Numbers& data, const Numbers& unknowns);

/// Where Newton's method for the unknowns leads from an approximation; nothing where that is far
/// away, or the Jacobian is singular as far as rounding lets one see.
std::optional<Numbers> refined(const Program& program, const Numbers& data,
                               const Numbers& approximation);

/// Data, and unknowns that solve their equations.
struct SolvedData {
    Numbers data;
    Numbers unknowns;
};

/// Changes data, or data and unknowns if that does not do, as little as Newton's method does, until
/// the equations hold. Nothing where it does not converge, a condition fails, or the Jacobian by
/// the unknowns is singular.
std::optional<SolvedData> solved_for_data(const Program& program, const SolvedData& near);

} // namespace plprove::model
