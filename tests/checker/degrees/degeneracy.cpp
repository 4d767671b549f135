// Zeros of the camera equations that are no solutions (FORMAT.md, section 9): cameras and images
// that violate one condition each. degenerate_scenes.cpp does so for every feature.
#include "tests/checker/degrees/instances.h"

using namespace checker;
using namespace instances;

namespace {
template <class T>
std::string reason_for(const CameraSystem& system, const CameraCoordinates<T>& cameras) {
    BackProjections<T> space;
    back_project(system, cameras, space);
    return std::string(degeneracy(system, cameras, space));
}

/// The reason for a feature's images in views that are not turned, so that rays and normals are the
/// images themselves.
std::string reason_for_images(std::string_view feature, const FeatureImages& images) {
    const RationalCameras cameras{0, 0, 0, 0, 0, 0, 2, 3, -1, 4, 5};
    CameraSystem system;
    add_feature(system, features[index_of(feature)], images);
    return reason_for(system, cameras);
}
} // namespace

TEST_CASE("the norm of a quaternion is zero") {
    const CameraSystem system = system_of(example());
    CHECK(reason_for(system, example().cameras).empty());
    for (const std::size_t first : {0U, 3U}) {
        ComplexCameras z = approximate(example().cameras);
        z[first] = {0, 1};
        z[first + 1] = 0;
        z[first + 2] = 0;
        CHECK(reason_for(system, z) == "the norm of a quaternion is zero");
    }
}

TEST_CASE("the centre of a view in a point, or on a line") {
    const Instance& instance = example();
    const CameraSystem system = system_of(instance);
    const auto with_centre_3 = [&](const Space& centre) {
        RationalCameras cameras = instance.cameras;
        std::copy(centre.begin(), centre.end(), &cameras[8]);
        return reason_for(system, cameras);
    };
    CHECK(with_centre_3({0, 0, 0}).empty()); // does not solve the equations, but is no degeneracy
    for (const auto& points : instance.points)
        CHECK(with_centre_3(points[0]) == "a point is the centre of a view of it");
    for (std::size_t f = 0; f < 2; ++f)
        CHECK(with_centre_3(instance.points[f][1]) ==
              "a line has no direction, or meets the centre of a view of it");
}

TEST_CASE("rays and planes that are parallel, and planes that are") {
    using Lines = std::array<Image, 3>;
    CHECK(reason_for_images("P/a/a", {{Image{1, 2, 3}}, {Lines{Image{}, {1, 1, -1}, {1, 0, 0}}}}) ==
          "a ray is parallel to a plane of its incidence");
    CHECK(reason_for_images("P/a/a", {{Image{1, 2, 3}}, {Lines{Image{}, {1, 0, 0}, {1, 1, -1}}}}) ==
          "a ray is parallel to a plane of its incidence");
    CHECK(reason_for_images("P/a/a", {{Image{1, 2, 3}}, {Lines{Image{}, {1, 0, 0}, {2, 0, 0}}}}) ==
          "a line has no direction, or meets the centre of a view of it");
    CHECK(reason_for_images("P/a/a", {{Image{1, 3, 3}}, {Lines{Image{}, {1, 0, 0}, {0, 1, 0}}}})
              .empty());
    CHECK(reason_for_images("-/P/P", {{Image{}, {1, 2, 3}, {1, 2, 3}}, {}}) ==
          "a ray is parallel to the plane that it should meet");
    CHECK(reason_for_images("-/P/P", {{Image{}, {1, 2, 3}, {1, 1, 3}}, {}}).empty());
}

TEST_CASE("degenerate solutions of the equations are refused") {
    const Instance instance = good_instance(6722);
    const std::string start = record(6722, instance);
    std::size_t refused = 0;
    for (const auto& z : hunt(system_of(instance), 60)) {
        const DegreeFile file = replayed(start + solution_line(z, false));
        refused += file.refusals.count > 0 &&
                   file.refusals.first[0].reason ==
                       "class 6722: a ray is parallel to a plane of its incidence";
    }
    CHECK(refused > 0);
}
