#include "prover/three_views/integer_images.h"

#include "prover/monodromy/arrivals.h"
#include "prover/three_views/camera_loops.h"
#include "prover/three_views/scene.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <numeric>
#include <span>

namespace plprove {

namespace {

constexpr double small_imaginary_part = 1e-8; ///< of a real solution, relative; tried, not believed

/// Which solutions are to be written.
struct Demands {
    double nondegeneracy = 0;  ///< at least; larger than for complex images, as the checker refuses
                               ///< records with a solution that may be degenerate
    bool sure = true;          ///< only those that Newton's method surely finds again
    std::span<const int> bits; ///< how many bits to try after the binary point, ascending
};

constexpr std::array bits_of_random_images{3,  4,  5,  6,  7,  8,  9,  10, 11, 12, 14, 16,
                                           19, 22, 26, 30, 35, 40, 44, 46, 48, 50, 52};
constexpr std::array bits_of_given_images = [] {
    std::array<int, 42> bits{};
    std::iota(bits.begin(), bits.end(), 3);
    return bits;
}();

/// If the checker refuses one of these, other images will do.
constexpr Demands all{1e-13, false, bits_of_random_images};
/// Nothing else will do. Solutions with a large coordinate have room for few bits.
constexpr Demands for_given_images{1e-9, true, bits_of_given_images};

/// The images as the certificate has them.
std::vector<FeatureImage> feature_images(const CameraSystem& system,
                                         const std::vector<IntegerVector>& vectors) {
    std::vector<FeatureImage> result;
    for (const Feature& feature : system.features)
        result.push_back({feature, std::vector<ViewImage>(3)});
    for (std::size_t f = 0; f < vectors.size(); ++f) {
        const FreeVector& free = system.free[f];
        ViewImage& image = result[static_cast<std::size_t>(free.feature)]
                               .views[static_cast<std::size_t>(free.view)];
        if (free.line < 0)
            image.point = vectors[f];
        else
            image.lines.push_back(vectors[f]);
    }
    return result;
}

bool is_real(const CameraPoint& point) {
    double imaginary = 0, size = 1;
    for (const Complex& x : point) {
        imaginary = std::max(imaginary, std::abs(x.imag()));
        size = std::max(size, std::abs(x));
    }
    return imaginary < small_imaginary_part * size;
}

/// Solves the equations at fixed images from starting values nearby.
class FixedImages {
public:
    FixedImages(const CameraSystem& system, const Images& images)
        : system_(tracked_system(system, standard_chart())),
          images_(moving_images(system, standard_constants(system), images, images)) {}

    /// Newton's method from each start; nothing where it does not converge at once.
    std::vector<std::optional<CameraPoint>> solve(const std::vector<CameraPoint>& starts,
                                                  TrackFunction* track, double noise) const {
        return newton(track, noise, system_, images_, starts);
    }

    /// The same to the last digits of a double, whatever the condition.
    std::vector<std::optional<CameraPoint>>
    solve_well(const std::vector<CameraPoint>& starts) const {
        auto result = solve(starts, fastest_tracker(), 1e-11);
        std::vector<CameraPoint> open;
        for (std::size_t i = 0; i < starts.size(); ++i)
            if (!result[i]) open.push_back(starts[i]);
        const auto ends = solve(open, fastest_double_double_tracker(), 1e-16);
        auto end = ends.begin();
        for (auto& point : result)
            if (!point) point = *end++;
        return result;
    }

private:
    TrackedSystem system_;
    TrackedImages images_;
};

/// For each solution how many bits after the binary point are enough; 0: no number is.
std::vector<int> bits_of(const std::vector<CameraPoint>& points, const FixedImages& fixed,
                         const Demands& demands) {
    const auto find_again = [&](int bits, const auto& starts, const auto& indices) {
        // In the end few are left, which are ill-conditioned.
        const auto ends = bits < 12 ? fixed.solve(starts, fastest_tracker(), 1e-7)
                                    : fixed.solve(starts, fastest_double_double_tracker(), 1e-16);
        std::vector<bool> again;
        for (std::size_t k = 0; k < ends.size(); ++k)
            again.push_back(ends[k] && approximates(*ends[k], points[indices[k]]));
        return again;
    };
    std::vector<int> result;
    for (const auto& [sure, last] : enough_bits(points, demands.bits, find_again))
        result.push_back(sure > 0 || demands.sure ? sure : last);
    return result;
}

/// The certificate with the solutions that these zeros, in the standard chart, approximate.
DegreeCertificate certificate_of(const CameraSystem& system,
                                 const std::vector<IntegerVector>& vectors,
                                 const std::vector<CameraPoint>& zeros, const Demands& demands) {
    const Images images = unit_images(vectors);
    const FixedImages fixed(system, images);
    const auto seen = image_vectors(system, standard_constants(system), images);
    const auto is_degenerate = [&](const CameraPoint& point) {
        return nondegeneracy(system, seen, standard_chart().cameras(point)) < demands.nondegeneracy;
    };
    Arrivals arrivals{SolutionSet<CameraPoint>()};
    for (const auto& point : fixed.solve_well(zeros))
        if (point && !arrivals.has(*point) && !is_degenerate(*point))
            arrivals.add(*point, is_real(*point));
    DegreeCertificate certificate;
    certificate.images = feature_images(system, vectors);
    certificate.solutions =
        arrivals.written(std::identity(), [&](const std::vector<CameraPoint>& points) {
            return bits_of(points, fixed, demands);
        });
    return certificate;
}

} // namespace

LowerBound find_for_integer_images(const CameraSystem& system, int wanted, std::uint64_t seed,
                                   std::uint64_t stream, bool small,
                                   const std::function<void(const MonodromyProgress&)>& progress) {
    constexpr int most_edges = 6;
    std::vector<IntegerVector> vectors;
    CameraLoops loops(system, seed, stream, [&](const Images& scene, Random& random) {
        vectors = small ? small_vectors(system, random) : vectors_near(system, scene, random);
        return unit_images(vectors);
    });
    constexpr int one_of = 10; // more than at generic images
    if (small) loops.give_up_beyond(static_cast<std::uint64_t>(4 + wanted / one_of));
    auto monodromy = camera_monodromy(std::move(loops), progress);
    monodromy.reach(wanted, most_edges);
    const bool too_few = monodromy.solutions().size() < wanted;
    if (small && too_few) return {{}, monodromy.loops().counts(), monodromy.lost()};
    std::vector<CameraPoint> zeros;
    for (const CameraPoint& point : monodromy.solutions().points())
        zeros.push_back(standard_chart().point(monodromy.loops().chart().cameras(point)));
    return {certificate_of(system, vectors, zeros, all), monodromy.loops().counts(),
            monodromy.lost()};
}

DegreeCertificate certify_zeros(const CameraSystem& system,
                                const std::vector<IntegerVector>& vectors,
                                const std::vector<CameraPoint>& zeros) {
    return certificate_of(system, vectors, zeros, for_given_images);
}

} // namespace plprove
