#include "prover/fibres/shared_matrices.h"

#include "prover/fibres/cameras_over.h"
#include "prover/fibres/univariate_field.h"

#include <optional>

namespace plprove {

namespace {

using model::Univariate;

/// Unit vectors in two views; the value of each equation is an entry of their essential matrix.
CameraImages unit_vectors(int first, int second) {
    CameraImages images;
    for (const int view : {first, second})
        for (const IntegerVector unit : {IntegerVector{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}) {
            images.system.vectors.push_back({.view = view});
            images.vectors.push_back(unit);
        }
    for (int a = 0; a < 3; ++a)
        for (int b = 3; b < 6; ++b)
            images.system.equations.push_back({EquationKind::epipolar, {a, b, 0}});
    return images;
}

/// The quotient of sums of entries that FORMAT.md, section 9, names; nothing where the divisor is 0
/// at a solution.
std::optional<Univariate> quotient_of(const UnivariateField& field,
                                      const std::vector<Univariate>& entries) {
    Univariate dividend, divisor;
    std::int64_t factor = 1;
    for (const Univariate& entry : entries) {
        dividend = field.sum(dividend, field.scaled(entry, factor));
        divisor = field.sum(divisor, field.scaled(entry, factor * factor));
        ++factor;
    }
    try {
        return field.product(dividend, field.inverse(divisor));
    } catch (const model::NotInvertible&) {
        return std::nullopt;
    }
}

/// The minimal polynomial of x up to a factor, by what its powers have of 1.
Univariate minimal_polynomial(const UnivariateField& field, const Univariate& x,
                              std::size_t degree) {
    constexpr std::size_t spare = 8; // a recurrence of full length is none that these know
    std::vector<Modular> sequence;
    Univariate power = field.constant(1);
    for (std::size_t k = 0; k < degree + spare; ++k) {
        sequence.push_back(power.coefficient(0));
        power = field.product(power, x);
    }
    return model::recurrence_of(sequence);
}

} // namespace

Univariate shared_matrices(const model::Solutions& solutions) {
    const UnivariateField field(solutions.polynomial);
    const std::size_t degree = solutions.polynomial.degree();
    Univariate best({Modular(1)});
    for (const auto& [first, second] : {std::pair(0, 1), {0, 2}, {1, 2}}) {
        const CameraImages images = unit_vectors(first, second);
        const auto quotient =
            quotient_of(field, CamerasOver(field, images, solutions.unknowns).values());
        if (!quotient) continue;
        Univariate values = minimal_polynomial(field, *quotient, degree);
        const bool is_better = best.degree() == 0 || values.degree() < best.degree();
        if (2 * values.degree() <= degree && is_better) best = std::move(values);
    }
    return best;
}

} // namespace plprove
