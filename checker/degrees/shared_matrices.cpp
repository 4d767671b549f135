#include "checker/degrees/shared_matrices.h"

#include "checker/degrees/evaluation.h"
#include "checker/fibres/fibre_number.h"

namespace checker {
/// The quotient of sums of entries of the essential matrix that FORMAT.md, section 9, names: others
/// would do. None if the divisor is 0 somewhere.
static std::optional<Polynomial> quotient_of_entries(const Extension& extension,
                                                     const CameraCoordinates<FibreNumber>& cameras,
                                                     Views views) {
    const std::size_t i = first_view(views), j = first_view(views & (views - 1));
    // The epipolar equation of two unit vectors is an entry.
    CameraSystem system;
    for (const std::size_t view : {i, j})
        for (const Image& unit : {Image{1, 0, 0}, Image{0, 1, 0}, Image{0, 0, 1}})
            add_vector(system, view, unit);
    BackProjections<FibreNumber> space;
    back_project(system, cameras, space);
    CameraCoordinates<FibreNumber> derivatives;
    FibreNumber dividend, divisor;
    for (std::size_t a = 0; a < 3; ++a)
        for (std::size_t b = 0; b < 3; ++b) {
            const CameraEquation equation{Kind::epipolar, {a, 3 + b}};
            const FibreNumber entry = evaluate(system, equation, space, derivatives);
            const auto n = static_cast<double>(3 * a + b + 1);
            dividend = dividend + FibreNumber(n) * entry;
            divisor = divisor + FibreNumber(n * n) * entry;
        }
    const auto inverse = extension.inverse(divisor.in(extension));
    if (!inverse) return std::nullopt;
    return extension.multiply(dividend.in(extension), *inverse);
}

std::vector<SharedMatrices> shared_matrices(const Fibre& fibre) {
    const Extension extension(fibre.lower);
    CameraCoordinates<FibreNumber> cameras;
    for (std::size_t k = 0; k < camera_unknowns; ++k)
        cameras[k] = FibreNumber(fibre.unknowns[k], extension);
    std::vector<SharedMatrices> found;
    for (const Views views : view_pairs) {
        const auto quotient = quotient_of_entries(extension, cameras, views);
        if (!quotient) continue;
        Polynomial values = minimal_polynomial(extension, *quotient, extension.degree() / 2);
        if (!values.empty()) found.push_back({views, std::move(values)});
    }
    return found;
}
} // namespace checker
