#include "prover/model/solver/numeric_equations.h"

#include "prover/model/fields.h"
#include "prover/model/gradient_ring.h"

#include <Eigen/LU>
#include <Eigen/QR>
#include <algorithm>
#include <limits>

namespace plprove::model {

namespace {

/// Complex numbers in doubles, as GradientRing wants them.
struct ComplexField {
    using Element = std::complex<double>;

    static Element constant(int value) { return value; }
    static Element sum(const Element& a, const Element& b) { return a + b; }
    static Element difference(const Element& a, const Element& b) { return a - b; }
    static Element product(const Element& a, const Element& b) { return a * b; }
    static bool is_zero(const Element& a) { return a == 0.0; }
    static Element inverse(const Element& a) {
        if (is_zero(a)) throw NotInvertible();
        return 1.0 / a;
    }
};

using Ring = GradientRing<ComplexField>;

/// The values and gradients of all scalars; nothing where a divisor is 0.
std::optional<std::vector<Ring::Scalar>> run(const Program& program,
                                             const std::vector<ScalarIndex>& wanted,
                                             const Numbers& data, const Numbers& unknowns,
                                             bool by_data) {
    const ComplexField field;
    Ring ring(field, data, unknowns, by_data);
    try {
        return evaluate(program, ring, wanted);
    } catch (const NotInvertible&) {
        return std::nullopt;
    }
}

bool is_finite(const std::complex<double>& z) {
    return std::isfinite(z.real()) && std::isfinite(z.imag());
}

double length(const Numbers& numbers) {
    double sum = 0;
    for (const std::complex<double>& z : numbers)
        sum += std::norm(z);
    return std::sqrt(sum);
}

void subtract(Numbers& numbers, const Eigen::VectorXcd& change, Eigen::Index first) {
    for (std::size_t i = 0; i < numbers.size(); ++i)
        numbers[i] -= change[first + static_cast<Eigen::Index>(i)];
}

/// One of Newton's steps towards solved data; its length, relative to the point.
std::optional<double> step_for_data(const Program& program, bool data_only, SolvedData& point) {
    const auto at = linearise(program, point.data, point.unknowns, true);
    if (!at) return std::nullopt;
    const auto n = static_cast<Eigen::Index>(data_only ? 0 : program.unknowns);
    Eigen::MatrixXcd jacobian(at->values.size(), n + at->by_data.cols());
    jacobian << at->by_unknowns.leftCols(n), at->by_data;
    const Eigen::VectorXcd change =
        jacobian.completeOrthogonalDecomposition().solve(at->values).eval();
    if (!change.allFinite()) return std::nullopt;
    if (!data_only) subtract(point.unknowns, change, 0);
    subtract(point.data, change, n);
    return change.norm() / (1 + length(point.data) + length(point.unknowns));
}

/// How large the terms of each equation are at least: 1 and the unknowns times the derivatives.
Eigen::VectorXd sizes_of_terms(const Linearisation& at, const Numbers& unknowns) {
    Eigen::VectorXd sizes(at.by_unknowns.cols());
    for (std::size_t i = 0; i < unknowns.size(); ++i)
        sizes[static_cast<Eigen::Index>(i)] = std::abs(unknowns[i]);
    return (at.by_unknowns.cwiseAbs() * sizes).array() + 1;
}

/// Whether the Jacobian is regular, as far as rounding lets one see: where it is not, equations
/// whose terms change by 10^-16 have solutions 10^-8 away.
bool is_regular(const Linearisation& at, const Numbers& unknowns) {
    const Eigen::MatrixXcd scaled =
        sizes_of_terms(at, unknowns).cwiseInverse().asDiagonal() * at.by_unknowns;
    constexpr double largest = 1e7; // of the inverse, relative to the point
    return scaled.partialPivLu().inverse().norm() < largest * (1 + length(unknowns));
}

bool is_regular(const Program& program, const Numbers& data, const Numbers& unknowns) {
    const auto at = linearise(program, data, unknowns, false);
    return at && is_regular(*at, unknowns);
}

/// The values of some scalars; nothing where a divisor is 0, or a number is not finite.
std::optional<Numbers> values_of(const Program& program, const std::vector<ScalarIndex>& wanted,
                                 const Numbers& data, const Numbers& unknowns) {
    const auto scalars = run(program, wanted, data, unknowns, false);
    if (!scalars) return std::nullopt;
    Numbers values;
    for (const ScalarIndex index : wanted)
        values.push_back((*scalars)[index].value);
    if (!std::ranges::all_of(values, is_finite)) return std::nullopt;
    return values;
}

} // namespace

std::optional<Linearisation> linearise(const Program& program, const Numbers& data,
                                       const Numbers& unknowns, bool by_data) {
    const std::vector<ScalarIndex> equations = scalars_of(program.equations);
    const auto scalars = run(program, equations, data, unknowns, by_data);
    if (!scalars) return std::nullopt;
    const auto rows = static_cast<Eigen::Index>(equations.size());
    const auto n = static_cast<Eigen::Index>(unknowns.size());
    const auto m = by_data ? static_cast<Eigen::Index>(data.size()) : Eigen::Index{0};
    Eigen::VectorXcd values(rows);
    Eigen::MatrixXcd jacobian = Eigen::MatrixXcd::Zero(rows, n + m);
    for (Eigen::Index row = 0; row < rows; ++row) {
        const Ring::Scalar& scalar = (*scalars)[equations[static_cast<std::size_t>(row)]];
        values[row] = scalar.value;
        for (const auto& [variable, slope] : scalar.gradient)
            jacobian(row, static_cast<Eigen::Index>(variable)) = slope;
    }
    if (!values.allFinite() || !jacobian.allFinite()) return std::nullopt;
    return Linearisation{values, jacobian.leftCols(n), jacobian.rightCols(m)};
}

std::optional<Numbers> counted_values(const Program& program, const Numbers& data,
                                      const Numbers& unknowns) {
    return program.counts ? values_of(program, program.counted, data, unknowns) : unknowns;
}

double residual_of(const Program& program, const Numbers& data, const Numbers& unknowns) {
    const auto at = linearise(program, data, unknowns, false);
    if (!at) return std::numeric_limits<double>::infinity();
    return at->values.cwiseAbs().cwiseQuotient(sizes_of_terms(*at, unknowns)).maxCoeff();
}

bool keeps_conditions(const Program& program, const Numbers& data, const Numbers& unknowns) {
    const auto values = values_of(program, scalars_of(program.conditions), data, unknowns);
    constexpr double tiny = 1e-9;
    return values && std::ranges::all_of(*values, [](const auto& z) { return std::abs(z) > tiny; });
}

std::optional<Numbers> refined(const Program& program, const Numbers& data,
                               const Numbers& approximation) {
    constexpr int most_steps = 3;
    constexpr double far = 1e-4;
    constexpr double converged = 1e-6;
    constexpr double rounding = 1e-12; // another step would lead no further
    const double size = 1 + length(approximation);
    Numbers point = approximation;
    std::optional<Linearisation> at;
    double moved = 0, last = size;
    for (int step = 0; step < most_steps && last > rounding * size; ++step) {
        at = linearise(program, data, point, false);
        if (!at) return std::nullopt;
        const Eigen::VectorXcd change = at->by_unknowns.partialPivLu().solve(at->values);
        if (!change.allFinite()) return std::nullopt;
        subtract(point, change, 0);
        last = change.norm();
        moved += last;
    }
    if (!(moved < far * size && last < converged * size) || !is_regular(*at, point))
        return std::nullopt;
    return point;
}

std::optional<SolvedData> solved_for_data(const Program& program, const SolvedData& near) {
    constexpr int most_steps = 40;
    constexpr double converged = 1e-13;
    constexpr double largest = 1e3; // of a solution that paths can start from
    for (const bool data_only : {true, false}) {
        SolvedData point = near;
        std::optional<double> length_of_step;
        double last = 1;
        for (int step = 0; step < most_steps; ++step) {
            length_of_step = step_for_data(program, data_only, point);
            if (!length_of_step) break;
            last = *length_of_step;
            if (last < converged) break;
        }
        if (!length_of_step || last >= converged) continue;
        const double residual = residual_of(program, point.data, point.unknowns);
        constexpr double small = 1e-9; // a least-squares solution may be none
        if (residual < small && length(point.data) < largest && length(point.unknowns) < largest &&
            keeps_conditions(program, point.data, point.unknowns) &&
            is_regular(program, point.data, point.unknowns))
            return point;
    }
    return std::nullopt;
}

} // namespace plprove::model
