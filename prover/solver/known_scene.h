// What a camera that is to be registered sees of a known scene: the constraints of certs/FORMAT.md,
// section 10, with numbers in place of integers.
#pragma once

#include "prover/solver/bilinear.h"
#include "prover/solver/solution.h"
#include "prover/solver/templates/registration.h"
#include "prover/three_views/camera_system.h"

#include <array>
#include <vector>

namespace plprove {

/// Stars and groups are in the order of the type: ascending by how many pins or rays they have.
template <class Scalar>
struct KnownScene {
    using Vector = plprove::Vector<Scalar>;
    /// A known line through a known point, and the line that the camera sees of it.
    struct Pin {
        Vector direction, image;
    };
    /// A known point that the camera sees.
    struct Star {
        Vector point, image;
        std::vector<Pin> pins;
    };
    /// A known line that the camera sees.
    struct Line {
        Vector point, direction, image;
    };
    /// A known point on a line that the camera sees.
    struct Incidence {
        Vector point, image;
    };
    /// A known line that the ray of an image point meets.
    struct Ray {
        Vector direction, image;
    };
    /// Known lines of this kind that have a point in common.
    struct Group {
        Vector point;
        std::vector<Ray> rays;
    };
    friend const Vector& line_of(const Star&, const Pin& pin) { return pin.image; }

    std::vector<Star> stars;
    std::vector<Line> lines;
    std::vector<Incidence> incidences;
    std::vector<Group> groups;
};

/// The scene with all vectors replaced: known points by `point`, directions by `direction`, image
/// points and lines by `image`.
template <class To, class From, class Point, class Direction, class Image>
KnownScene<To> mapped(const KnownScene<From>& scene, Point point, Direction direction,
                      Image image) {
    KnownScene<To> result;
    for (const auto& star : scene.stars) {
        auto& added = result.stars.emplace_back();
        added.point = point(star.point);
        added.image = image(star.image);
        for (const auto& pin : star.pins)
            added.pins.push_back({direction(pin.direction), image(pin.image)});
    }
    for (const auto& line : scene.lines)
        result.lines.push_back({point(line.point), direction(line.direction), image(line.image)});
    for (const auto& incidence : scene.incidences)
        result.incidences.push_back({point(incidence.point), image(incidence.image)});
    for (const auto& group : scene.groups) {
        auto& added = result.groups.emplace_back();
        added.point = point(group.point);
        for (const auto& ray : group.rays)
            added.rays.push_back({direction(ray.direction), image(ray.image)});
    }
    return result;
}

/// The images of a label class as its features have them: what each view sees.
class ClassSights {
public:
    /// `images`: one vector for each free vector of the system.
    ClassSights(const CameraSystem& system, const std::vector<Eigen::Vector3d>& images);

    const std::vector<Feature>& features() const { return features_; }
    /// Assume that the view sees the point, or the line.
    Eigen::Vector3d point(std::size_t feature, int view) const;
    Eigen::Vector3d line(std::size_t feature, int view, int line) const;

private:
    struct Sight {
        Eigen::Vector3d point;
        std::vector<Eigen::Vector3d> lines;
    };
    std::vector<Feature> features_;
    std::vector<std::array<Sight, 3>> sights_;
};

/// What view `third` sees of the scene that two views determine: those after it, cyclically. The
/// camera of view third + 1 is [I | 0], that of view third + 2 is `pose`.
KnownScene<std::complex<double>> known_scene(const ClassSights& sights, int third,
                                             const ComplexPose& pose);

} // namespace plprove
