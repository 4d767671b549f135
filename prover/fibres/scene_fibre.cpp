#include "prover/fibres/scene_fibre.h"

#include "prover/fibres/exact_solutions.h"
#include "prover/fibres/linear_unknowns.h"
#include "prover/fibres/scene_digits.h"
#include "prover/fibres/scenes_over.h"
#include "prover/many_views/certificate.h"
#include "prover/model/fibre_text.h"

#include <thread>

namespace plprove {

namespace {

int all_threads() {
    return static_cast<int>(std::max(1U, std::thread::hardware_concurrency()));
}

} // namespace

std::optional<many_views::MonodromyResult> find_scenes(const Problem& problem, int degree,
                                                       std::uint64_t seed) {
    constexpr std::uint64_t most_runs = 8;
    many_views::MonodromySettings settings;
    settings.threads = all_threads();
    settings.edges = 3; // usually find all
    settings.most_solutions = degree;
    for (std::uint64_t run = 0; run < most_runs; ++run) {
        auto found = many_views::run_monodromy(problem, most_runs * seed + run, settings);
        if (std::ssize(found.points) == degree) return found;
    }
    return std::nullopt;
}

std::optional<SceneFibre> find_scene_fibre(const many_views::MonodromyResult& scenes,
                                           std::uint64_t seed, int largest_coordinate,
                                           const std::function<void(long)>& progress) {
    const int degree = static_cast<int>(std::ssize(scenes.points));
    const many_views::SolutionsRecord record =
        many_views::certify(scenes, degree, seed, all_threads(), largest_coordinate);
    if (record.count() != degree) return std::nullopt;
    const SceneEquations scene = scene_equations(record.problem, record.views);
    const SceneDigits equations(scene);
    auto exact =
        exact_solutions(equations, record.solutions, forms_of(scene.camera_coordinates, seed),
                        progress, [&](const auto& point, const auto& digits) {
                            return equations.is_degenerate(point, digits);
                        });
    if (!exact) return std::nullopt;
    const UnivariateField field(exact->solutions.polynomial);
    auto unknowns = with_linear_unknowns( // the depths, once the cameras are known
        field, std::move(exact->solutions.unknowns), scene.unknowns - scene.camera_coordinates,
        [&](const auto& point) { return ScenesOver(field, scene, point).values(); });
    if (!unknowns) return std::nullopt;
    return SceneFibre{record.problem,
                      record.views,
                      {exact->solutions.polynomial, std::move(*unknowns)},
                      std::move(exact->form)};
}

std::string write_record(const SceneFibre& fibre) {
    CertificateText text;
    many_views::append_images(text, fibre.problem, fibre.views);
    text.line("fibre", fibre.degree());
    model::append_solutions(text, fibre.solutions.polynomial, fibre.solutions.unknowns, fibre.form);
    return text.take();
}

} // namespace plprove
