#include "prover/fibres/class_fibre.h"

#include "prover/fibres/camera_digits.h"
#include "prover/fibres/cameras_over.h"
#include "prover/fibres/exact_solutions.h"
#include "prover/fibres/linear_unknowns.h"
#include "prover/format/certificate_text.h"
#include "prover/model/fibre_text.h"
#include "prover/three_views/degree_text.h"

namespace plprove {

namespace {

/// All solutions for the images of a certificate that shows approximations of them.
std::optional<ClassFibre> fibre_of(const DegreeCertificate& certificate, std::uint64_t seed,
                                   const std::function<void(long)>& bits) {
    constexpr std::size_t rotations = 6; // of coordinates; the equations are linear in the others
    const CameraImages images = camera_images(certificate);
    auto exact = exact_solutions(CameraDigits(images), certificate.solutions,
                                 forms_of(rotations, seed), bits);
    if (!exact) return std::nullopt;
    const UnivariateField field(exact->solutions.polynomial);
    auto coordinates = with_linear_unknowns(
        field, std::move(exact->solutions.unknowns), camera_dimension - rotations,
        [&](const auto& point) { return CamerasOver(field, images, point).values(); });
    if (!coordinates) return std::nullopt;
    exact->form.resize(camera_dimension);
    return ClassFibre{certificate.number,
                      certificate.images,
                      {exact->solutions.polynomial, std::move(*coordinates)},
                      std::move(exact->form)};
}

} // namespace

std::optional<ClassFibre> find_class_fibre(std::size_t number, DegreeOptions options,
                                           const std::function<void(long)>& bits) {
    options.small_images = true;
    const DegreeRun run = compute_degree(number, options);
    return run.complete ? fibre_of(*run.certificate, options.seed, bits) : std::nullopt;
}

DegreeRun compute_class_fibre(std::size_t number, const DegreeOptions& options) {
    constexpr std::uint64_t most_tries = 20; // some images are not generic
    DegreeRun run;
    run.number = number;
    DegreeOptions others = options;
    others.small_images = true;
    for (std::uint64_t n = 0; n < most_tries && !run.complete; ++n) {
        others.seed = options.seed * most_tries + n;
        const DegreeRun found = compute_degree(number, others);
        run.tracks += found.tracks;
        run.retried += found.retried;
        run.failed += found.failed;
        if (!found.complete) continue;
        const auto fibre = fibre_of(*found.certificate, others.seed, {});
        if (!fibre) continue;
        run.degree = fibre->degree();
        run.complete = true;
        run.record = write_record(*fibre);
    }
    if (!run.complete)
        run.notes.push_back("no fibre over " + std::to_string(most_tries) + " sets of images");
    return run;
}

std::string write_record(const ClassFibre& fibre) {
    CertificateText text;
    text.line("fibre", fibre.degree());
    model::append_solutions(text, fibre.solutions.polynomial, fibre.solutions.unknowns, fibre.form);
    return write_images(fibre.number, fibre.images) + text.take();
}

} // namespace plprove
