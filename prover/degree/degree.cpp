#include "prover/degree/degree.h"

#include "prover/degree/completeness.h"
#include "prover/degree/integer_images.h"
#include "prover/degree/subproblems.h"

#include <algorithm>
#include <utility>

namespace plprove {

namespace {

constexpr int most_integer_images = 3;
constexpr std::size_t most_attempts = 3;

/// Tries other integer images until all solutions arrive there, or `wanted` do.
DegreeCertificate certify(const CameraSystem& system, Monodromy& monodromy, int wanted,
                          Random& random) {
    DegreeCertificate best;
    for (int attempt = 0; attempt < most_integer_images && best.degree() < wanted; ++attempt) {
        DegreeCertificate certificate =
            certify_degree(system, monodromy, monodromy.solutions().size(), wanted, random);
        if (attempt == 0 || certificate.degree() > best.degree()) best = std::move(certificate);
    }
    return best;
}

/// Finds all solutions, or as many as are wanted, and certifies them. Conjugates of solutions for
/// integer images are solutions, too: if there are more of these than were found, some are missing.
void find_all(const CameraSystem& system, Monodromy& monodromy, const DegreeOptions& options,
              Random& random, DegreeRun& run) {
    for (int edges = first_edges; edges <= most_edges; edges = monodromy.edges() + 1) {
        run.evidence = complete(system, monodromy, edges, options.target, random, run.notes);
        if (!options.certificate) return;
        const int found = monodromy.solutions().size();
        const bool all = run.evidence || options.target == 0;
        run.certificate = certify(system, monodromy, all ? found : options.target, random);
        if (!run.evidence || run.certificate->degree() <= found) return;
        run.evidence.reset();
    }
    run.notes.push_back("there are more solutions for integer images than were found");
}

/// The relative poses of the first two views that share five points, among the solutions found.
std::optional<PoseCount> poses_of_shared_points(const CameraSystem& system,
                                                const Monodromy& monodromy) {
    const Subproblems parts = subproblems(system);
    if (parts.five_points.empty()) return std::nullopt;
    return count_poses(parts.five_points.front(), monodromy.chart(),
                       monodromy.solutions().points());
}

void add(DegreeRun& run, const PathCounts& counts) {
    run.tracks += counts.tracks;
    run.retried += counts.retried;
    run.failed += counts.failed;
}

/// Finishes the run with the certificate that it has. The certificate may show more solutions than
/// were found, or fewer; evidence is for all of them.
void adopt_certificate(DegreeRun& run) {
    const int shown = run.certificate->degree();
    if (run.evidence && shown < run.degree)
        run.notes.push_back(std::to_string(run.degree - shown) +
                            " solutions were lost on the way to integer images");
    run.degree = std::max(run.degree, shown);
    run.certificate->number = run.number;
    run.certificate->evidence = shown == run.degree ? run.evidence : std::nullopt;
}

/// Notes how many edges are no bijections of the solutions, if any.
void note_edges(DegreeRun& run, const Monodromy& monodromy) {
    const int edges = monodromy.edges() - monodromy.bijective_edges();
    if (edges == 0) return;
    run.notes.push_back(std::to_string(edges) + " of " + std::to_string(monodromy.edges()) +
                        " edges are no bijections: " + std::to_string(monodromy.unmatched()) +
                        " solutions lack a partner");
}

/// The run with the random numbers of this attempt.
DegreeRun attempt_degree(std::size_t number, const DegreeOptions& options, std::size_t attempt) {
    const CameraSystem system = camera_system(label_classes()[number]);
    const std::uint64_t stream = number + (attempt << 32U);
    // Only a certificate finds out that something is no solution; without one, suspect more.
    Monodromy monodromy(system, options.seed, stream,
                        options.certificate ? Monodromy::suspicious : 1e-6);
    monodromy.report_to(options.progress);
    Random random(options.seed, ~stream);
    DegreeRun run;
    run.number = number;
    // With integer images the conjugates of solutions are solutions, too: with a certificate, a
    // little more than half of the target is enough at first.
    if (options.target > 0 && options.certificate) {
        const int enough = options.target * 11 / 20 + 4;
        monodromy.run(first_edges, enough);
        run.certificate = certify_degree(system, monodromy, enough, options.target, random);
    }
    if (!run.certificate || run.certificate->degree() < options.target || options.target == 0)
        find_all(system, monodromy, options, random, run);
    run.degree = monodromy.solutions().size();
    run.five_point_poses = poses_of_shared_points(system, monodromy);
    if (run.certificate) adopt_certificate(run);
    if (run.evidence || options.target == 0) note_edges(run, monodromy);
    add(run, monodromy.follower().counts());
    return run;
}

/// Whether it ended without what was asked for, or with weak evidence.
bool falls_short(const DegreeRun& run, const DegreeOptions& options) {
    if (run.evidence) return run.evidence->edges < agreeing_edges;
    return options.target == 0 || run.degree < options.target;
}

/// Of two runs that fall short the one with more of this is better.
std::pair<bool, int> merit(const DegreeRun& run) {
    return {run.complete(), run.certificate ? run.certificate->degree() : 0};
}

/// Finds a certificate of options.at_least solutions: with other random images again, as some have
/// a solution that is too ill-conditioned.
DegreeRun find_lower_bound(std::size_t number, const DegreeOptions& options) {
    constexpr std::size_t most_images = 12;
    const CameraSystem system = camera_system(label_classes()[number]);
    DegreeRun run;
    run.number = number;
    for (std::size_t attempt = 0; attempt < most_images && run.degree < options.at_least;
         ++attempt) {
        auto [certificate, counts] =
            find_for_integer_images(system, options, number + (attempt << 32U));
        add(run, counts);
        if (certificate.degree() <= run.degree) continue;
        run.degree = certificate.degree();
        run.certificate = std::move(certificate);
        run.certificate->number = number;
    }
    return run;
}

} // namespace

int DegreeCertificate::degree() const {
    int degree = 0;
    for (const ApproximateSolution& solution : solutions)
        degree += solution.real ? 1 : 2;
    return degree;
}

DegreeRun compute_degree(std::size_t number, const DegreeOptions& options) {
    if (options.at_least > 0) return find_lower_bound(number, options);
    DegreeRun run = attempt_degree(number, options, 0);
    // Rarely a degenerate end of a path is taken for a solution; then no edge is a bijection any
    // more. With other random numbers this is unlikely to happen again.
    for (std::size_t attempt = 1; attempt < most_attempts && falls_short(run, options); ++attempt) {
        DegreeRun again = attempt_degree(number, options, attempt);
        again.notes.push_back("attempt " + std::to_string(attempt + 1) + ": others fell short");
        if (!falls_short(again, options) || merit(again) > merit(run)) std::swap(run, again);
        run.tracks += again.tracks;
        run.retried += again.retried;
        run.failed += again.failed;
    }
    return run;
}

} // namespace plprove
