#include "prover/fibres/class_fibre.h"

#include "prover/fibres/camera_digits.h"
#include "prover/format/certificate_text.h"
#include "prover/model/fibre_text.h"
#include "prover/model/lifting/eliminant.h"
#include "prover/three_views/degree_text.h"
#include "prover/three_views/random.h"

#include <algorithm>
#include <stdexcept>

namespace plprove {

namespace {

/// Factors from -3 to 3 of the camera coordinates.
std::vector<int> random_form(std::uint64_t seed) {
    constexpr std::uint64_t stream = 0x666f726d;
    Random random(seed, stream);
    std::vector<int> form;
    for (std::size_t k = 0; k < camera_dimension; ++k)
        form.push_back(static_cast<int>(random.bits() % 7) - 3);
    return form;
}

/// The solutions modulo q, from as many digits as this takes.
std::optional<model::Solutions> exact_solutions(const DegreeCertificate& certificate,
                                                const std::vector<int>& form,
                                                const std::function<void(long)>& progress) {
    constexpr slong most_bits = 4'000'000;
    const CameraDigits equations(certificate);
    model::Refinement refinement(equations, starting_points(certificate));
    while (refinement.bits() < most_bits) {
        refinement.double_digits();
        progress(refinement.bits());
        auto solutions = model::eliminant(refinement.solutions(), form, refinement.bits());
        if (solutions) return solutions;
    }
    return std::nullopt;
}

} // namespace

std::optional<ClassFibre> find_class_fibre(std::size_t number, int degree, std::uint64_t seed,
                                           const std::function<void(long)>& progress) {
    DegreeOptions options;
    options.seed = seed;
    options.degree = degree;
    options.small_images = true;
    const DegreeRun run = compute_degree(number, options);
    if (run.degree != degree || !run.certificate) return std::nullopt;
    ClassFibre fibre{run.certificate->number, run.certificate->images, {}, random_form(seed)};
    try {
        auto solutions = exact_solutions(*run.certificate, fibre.form, progress);
        if (!solutions) return std::nullopt;
        fibre.solutions = std::move(*solutions);
    } catch (const std::runtime_error&) {
        return std::nullopt; // Newton's method fails near a singular solution
    }
    return fibre;
}

std::vector<model::Univariate> factors_of(const ClassFibre& fibre) {
    nmod_poly_factor_t factors;
    nmod_poly_factor_init(factors);
    nmod_poly_factor(factors, fibre.solutions.polynomial.get());
    std::vector<model::Univariate> result;
    for (slong i = 0; i < factors->num; ++i)
        nmod_poly_set(result.emplace_back().get(), factors->p + i);
    nmod_poly_factor_clear(factors);
    std::ranges::sort(result, {}, &model::Univariate::degree);
    return result;
}

std::string write_record(const ClassFibre& fibre, const model::Univariate* factor) {
    CertificateText text;
    text.line("fibre", fibre.degree());
    model::append_solutions(text, fibre.solutions.polynomial, fibre.solutions.unknowns, fibre.form);
    if (factor)
        text.line("factor", factor->degree(), model::coefficients(*factor, factor->degree()));
    return write_images(fibre.number, fibre.images) + text.take();
}

} // namespace plprove
