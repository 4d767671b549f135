#include "prover/three_views/degree.h"

#include "prover/three_views/integer_images.h"

#include <algorithm>
#include <utility>

namespace plprove {

DegreeRun compute_degree(std::size_t number, const DegreeOptions& options) {
    // Some random images have a solution that is too ill-conditioned: then others do.
    constexpr std::size_t most_images = 12;
    int wanted = options.at_least;
    if (wanted == 0) wanted = options.degree;
    if (options.target > 0) wanted = std::min(wanted, options.target);
    const CameraSystem system = camera_system(label_classes()[number]);
    DegreeRun run;
    run.number = number;
    for (std::size_t attempt = 0; attempt < most_images && run.degree < wanted; ++attempt) {
        auto [certificate, counts, lost] =
            find_for_integer_images(system, wanted, options.seed, number + (attempt << 32U),
                                    options.small_images, options.progress);
        run.tracks += counts.tracks;
        run.retried += counts.retried;
        run.failed += static_cast<std::uint64_t>(lost);
        if (certificate.degree() <= run.degree) continue;
        run.degree = certificate.degree();
        run.certificate = std::move(certificate);
        run.certificate->number = number;
    }
    run.complete = options.degree > 0 && run.degree == options.degree;
    return run;
}

} // namespace plprove
