#include "prover/fibres/class_fibre.h"

#include "prover/fibres/camera_digits.h"
#include "prover/fibres/exact_solutions.h"
#include "prover/format/certificate_text.h"
#include "prover/model/fibre_text.h"
#include "prover/three_views/degree_text.h"

namespace plprove {

std::optional<ClassFibre> find_class_fibre(std::size_t number, int degree, std::uint64_t seed,
                                           const std::function<void(long)>& progress) {
    DegreeOptions options;
    options.seed = seed;
    options.degree = degree;
    options.small_images = true;
    const DegreeRun run = compute_degree(number, options);
    if (run.degree != degree || !run.certificate) return std::nullopt;
    ClassFibre fibre{
        run.certificate->number, run.certificate->images, {}, random_form(camera_dimension, seed)};
    auto solutions = exact_solutions(CameraDigits(*run.certificate), run.certificate->solutions,
                                     fibre.form, progress);
    if (!solutions) return std::nullopt;
    fibre.solutions = std::move(*solutions);
    return fibre;
}

std::string write_record(const ClassFibre& fibre) {
    CertificateText text;
    text.line("fibre", fibre.degree());
    model::append_solutions(text, fibre.solutions.polynomial, fibre.solutions.unknowns, fibre.form);
    return write_images(fibre.number, fibre.images) + text.take();
}

} // namespace plprove
