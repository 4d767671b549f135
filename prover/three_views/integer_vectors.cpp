#include "prover/three_views/integer_vectors.h"

#include <algorithm>
#include <cmath>
#include <functional>

namespace plprove {

namespace {

bool are_parallel(const IntegerVector& a, const IntegerVector& b) {
    return a[0] * b[1] == a[1] * b[0] && a[0] * b[2] == a[2] * b[0] && a[1] * b[2] == a[2] * b[1];
}

bool are_dependent(const IntegerVector& a, const IntegerVector& b, const IntegerVector& c) {
    return a[0] * (b[1] * c[2] - b[2] * c[1]) + a[1] * (b[2] * c[0] - b[0] * c[2]) +
               a[2] * (b[0] * c[1] - b[1] * c[0]) ==
           0;
}

/// Whether a vector fits to others of its view. Images are hardly generic where two or three points
/// or lines of a view are dependent, or a point is on a line: paths would end at degenerate
/// solutions.
bool is_generic(const IntegerVector& x, const std::vector<IntegerVector>& others) {
    for (std::size_t i = 0; i < others.size(); ++i) {
        const IntegerVector& y = others[i];
        if (are_parallel(x, y) || x[0] * y[0] + x[1] * y[1] + x[2] * y[2] == 0) return false;
        for (std::size_t j = 0; j < i; ++j)
            if (are_dependent(x, y, others[j])) return false;
    }
    return true;
}

bool has_zero(const IntegerVector& x) {
    return x[0] == 0 || x[1] == 0 || x[2] == 0;
}

/// Makes a vector, for the free vector of this number; the earlier ones of its view are given.
using Candidate = std::function<IntegerVector(std::size_t, const std::vector<IntegerVector>&)>;

/// Generic vectors among those that `candidate` makes.
std::vector<IntegerVector> generic_vectors(const CameraSystem& system, const Candidate& candidate) {
    std::vector<IntegerVector> result;
    std::array<std::vector<IntegerVector>, 3> views;
    for (const FreeVector& free : system.free) {
        auto& others = views[static_cast<std::size_t>(free.view)];
        IntegerVector x;
        do
            x = candidate(result.size(), others);
        while (!is_generic(x, others));
        others.push_back(x);
        result.push_back(x);
    }
    return result;
}

double length(const Complex3& x) {
    return std::sqrt(std::norm(x[0]) + std::norm(x[1]) + std::norm(x[2]));
}

double product(const Complex3& x, const Complex3& y) {
    return std::abs(x[0] * y[0] + x[1] * y[1] + x[2] * y[2]);
}

/// How far unit images are from degenerate ones: no two vectors of a view shall be nearly parallel
/// or perpendicular, no three nearly dependent. The weights make these about equally frequent.
double spread(const CameraSystem& system, const Images& images) {
    constexpr double perpendicular = 3, dependent = 20;
    const auto same_view = [&](std::size_t i, std::size_t j) {
        return system.free[i].view == system.free[j].view;
    };
    double least = 1;
    for (std::size_t i = 0; i < images.size(); ++i)
        for (std::size_t j = 0; j < i; ++j) {
            if (!same_view(i, j)) continue;
            const Complex3 normal = cross(images[i], images[j]);
            least =
                std::min({least, length(normal), perpendicular * product(images[i], images[j])});
            for (std::size_t k = 0; k < j; ++k)
                if (same_view(i, k))
                    least = std::min(least, dependent * product(normal, images[k]));
        }
    return least;
}

} // namespace

std::vector<IntegerVector> vectors_near(const CameraSystem& system, const Images& images,
                                        Random& random) {
    constexpr double scale = 50;
    constexpr int choices = 100;
    const auto candidate = [&](std::size_t f, const auto&) {
        IntegerVector x;
        do {
            const Images near = random_neighbour({images[f]}, random, Field::real);
            for (std::size_t k = 0; k < 3; ++k)
                x[k] = std::llrint(scale * near.front()[k].real());
        } while (has_zero(x));
        return x;
    };
    std::vector<IntegerVector> best;
    double best_spread = -1;
    for (int i = 0; i < choices; ++i) {
        std::vector<IntegerVector> vectors = generic_vectors(system, candidate);
        const double value = spread(system, unit_images(vectors));
        if (value <= best_spread) continue;
        best_spread = value;
        best = std::move(vectors);
    }
    return best;
}

std::vector<IntegerVector> small_vectors(const CameraSystem& system, Random& random) {
    constexpr int patience = 300;
    std::int64_t largest = 2;
    int tried = 0;
    return generic_vectors(system, [&](std::size_t, const std::vector<IntegerVector>& others) {
        // Photos may be turned: so the first vector is (0, 0, 1), and the second (0, y, z).
        if (others.empty()) return IntegerVector{0, 0, 1};
        // Where many vectors of a view have to be generic, the smallest integers do not suffice.
        if (++tried % patience == 0) ++largest;
        const auto width = static_cast<std::uint64_t>(2 * largest + 1);
        IntegerVector x;
        do
            for (std::int64_t& coordinate : x)
                coordinate = static_cast<std::int64_t>(random.bits() % width) - largest;
        while (has_zero(x));
        if (others.size() == 1) x[0] = 0;
        return x;
    });
}

Images unit_images(const std::vector<IntegerVector>& vectors) {
    Images result;
    for (const auto& [x, y, z] : vectors) {
        const auto a = static_cast<double>(x), b = static_cast<double>(y),
                   c = static_cast<double>(z);
        const double scale = 1 / std::sqrt(a * a + b * b + c * c);
        result.push_back({a * scale, b * scale, c * scale});
    }
    return result;
}

} // namespace plprove
