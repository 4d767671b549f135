// For each of the 27 features, scenes whose images solve the camera equations exactly and are
// degenerate in one way: each way that section 9 of FORMAT.md lists and the feature can have. The
// checker must name it, and must let pass the scene beside it.
#include "tests/checker/degrees/instances.h"

using namespace checker;
using namespace instances;

namespace {
constexpr std::string_view parallel = "a ray is parallel to a plane of its incidence";
constexpr std::string_view parallel_in_pair = "a ray is parallel to the plane that it should meet";
constexpr std::string_view in_centre = "a point is the centre of a view of it";
constexpr std::string_view bad_line =
    "a line has no direction, or meets the centre of a view of it";

/// Views in general position, with integer coordinates: see instances.h.
const RationalCameras cameras{1, -2, 1, 2, 1, -1, 3, -2, -1, 2, 4};

/// A feature in space: of a free line, a point of it and its direction.
struct Scene {
    Space point{};
    std::vector<Space> directions{};
    bool at_infinity = false; // the point is the direction `point`
};

/// Vectors without a meaning, one after the other.
struct AnyVector {
    Random random{std::mt19937_64(11)};
    Space operator()() { return {random(9), random(9), 10 + random(3)}; }
};

bool is_zero(const Space& x) {
    return x == Space{0, 0, 0};
}

Image integer_image(const Space& x) {
    const Image image = coprime(x);
    for (const mpz_class& coordinate : image)
        REQUIRE(abs(coordinate) < 1'000'000'000'000);
    return image;
}

/// What a view sees of the point. If this is its centre, any image will do.
Space point_image(const Scene& scene, std::size_t view, AnyVector& any) {
    const Space x = scene.at_infinity ? turned(cameras, view, scene.point)
                                      : image_of(cameras, view, scene.point);
    return is_zero(x) ? any() : x;
}

/// What a view sees of a line, where it sees the point as x (or would). If the line meets the
/// centre of the view, any line through its image point will do.
Space line_image(const Scene& scene, std::size_t pin, std::size_t view, const Space& x,
                 AnyVector& any) {
    const Space direction = turned(cameras, view, scene.directions[pin]);
    const Space line = cross(x, direction);
    return is_zero(line) ? cross(direction, any()) : line;
}

FeatureImages images_of(const Scene& scene, const Feature& feature) {
    FeatureImages images;
    AnyVector any{Random{std::mt19937_64(12)}};
    for (std::size_t view = 0; view < 3; ++view) {
        const bool sees_point = has_view(feature.point, view);
        const Space x = point_image(scene, view, any);
        const bool centre_in_point =
            !scene.at_infinity && is_zero(image_of(cameras, view, scene.point));
        if (sees_point) images.point[view] = integer_image(x);
        for (std::size_t pin = 0; pin < feature.pins; ++pin) {
            if (!has_view(feature.pin[pin], view)) continue;
            const Space through = centre_in_point && !sees_point ? any() : x;
            images.line[pin][view] = integer_image(line_image(scene, pin, view, through, any));
        }
    }
    return images;
}

/// The condition that the scene's images violate; they must solve the equations.
std::string reason_for(const Scene& scene, const Feature& feature) {
    CameraSystem system;
    add_feature(system, feature, images_of(scene, feature));
    BackProjections<Rational> space;
    back_project(system, cameras, space);
    for (const CameraEquation& equation : system.equations) {
        RationalCameras row;
        CHECK(evaluate(system, equation, space, row) == 0);
    }
    return std::string(degeneracy(system, cameras, space));
}

Scene general_scene(const Feature& feature, AnyVector& any) {
    Scene scene{.point = any()};
    for (std::size_t pin = 0; pin < feature.pins; ++pin)
        scene.directions.push_back(any());
    return scene;
}

Space combination(int a, const Space& x, int b, const Space& y) {
    return plus(times(Rational(a), x), times(Rational(b), y));
}

/// A scene beside it: all is moved a little.
Scene neighbour(Scene scene, AnyVector& any) {
    const Rational little(1, 100);
    if (scene.at_infinity) {
        scene.at_infinity = false;
        scene.point = plus(times(Rational(50), scene.point), any());
    } else {
        scene.point = plus(scene.point, times(little, any()));
    }
    for (Space& direction : scene.directions)
        direction = plus(direction, times(little, any()));
    return scene;
}

/// Scenes with one degeneracy each, as a feature can have it.
class Scenes {
public:
    explicit Scenes(const Feature& feature) : feature_(feature) {
        first_ = feature.free_line ? 0 : first_view(feature.point);
        other_views_ = feature.views & ~(1U << first_);
    }

    /// The view of the ray that meets the planes.
    std::size_t ray_view() const { return first_; }

    bool has_incidence() const { return std::popcount(other_views_) == 2; }
    std::string_view parallel_reason() const {
        return has_incidence() ? parallel : parallel_in_pair;
    }

    /// Whether the plane of a view that does not see the point is that of this pin.
    bool is_plane_of(std::size_t pin, std::size_t view) const {
        return view != first_ && has_view(feature_.pin[pin], view) &&
               !has_view(feature_.point, view);
    }

    void check_point_at_infinity() {
        Scene scene = general_scene(feature_, any_);
        scene.at_infinity = true;
        check(scene, parallel_reason());
    }

    /// The ray lies in the plane of another view, so that this contains both centres.
    void check_ray_in_plane(std::size_t view) {
        Scene scene = general_scene(feature_, any_);
        const Space baseline = minus(centre_of(cameras, view), centre_of(cameras, first_));
        if (has_view(feature_.point, view)) {
            // The auxiliary line (0, z, -y) joins the image (x, y, z) and (1, 0, 0).
            const RationalCameras inverse = inverse_rotations();
            const Space axis = turned(inverse, view, {1, 0, 0});
            scene.point = plus(centre_of(cameras, first_), combination(2, baseline, 1, axis));
        } else {
            const Space ray = minus(scene.point, centre_of(cameras, first_));
            for (std::size_t pin = 0; pin < feature_.pins; ++pin)
                if (is_plane_of(pin, view))
                    scene.directions[pin] = combination(3, baseline, 1, ray);
        }
        check(scene, parallel_reason());
    }

    /// The auxiliary point of a free line is the image of its point at infinity.
    void check_auxiliary_ray_along_line() {
        Scene scene = general_scene(feature_, any_);
        scene.directions[0][0] = 0;
        check(scene, parallel);
    }

    void check_point_in_centre(std::size_t view) {
        Scene scene = general_scene(feature_, any_);
        scene.point = centre_of(cameras, view);
        check(scene, in_centre);
    }

    /// The planes of the first two views of a line are the same.
    void check_line_without_direction(std::size_t pin) {
        Scene scene = general_scene(feature_, any_);
        const Views seen = feature_.pin[pin];
        const std::size_t u = first_view(seen);
        const std::size_t w = first_view(seen & (seen - 1));
        const Space baseline = minus(centre_of(cameras, w), centre_of(cameras, u));
        scene.directions[pin] =
            combination(3, baseline, 1, minus(scene.point, centre_of(cameras, u)));
        // If this is the plane that the ray should meet, it contains the ray.
        const bool contains_ray =
            (u == first_ && is_plane_of(pin, w)) || (w == first_ && is_plane_of(pin, u));
        check(scene, contains_ray ? parallel_reason() : bad_line);
    }

    void check_line_through_centre(std::size_t pin, std::size_t view) {
        Scene scene = general_scene(feature_, any_);
        scene.directions[pin] = minus(scene.point, centre_of(cameras, view));
        bool contains_ray = false;
        if (view == first_ && !feature_.free_line)
            for (std::size_t other = 0; other < 3; ++other)
                contains_ray |= is_plane_of(pin, other);
        check(scene, contains_ray ? parallel_reason() : bad_line);
    }

private:
    /// Quaternions of the inverse rotations.
    static RationalCameras inverse_rotations() {
        RationalCameras inverse = cameras;
        for (std::size_t i = 0; i < 6; ++i)
            inverse[i] = -cameras[i];
        return inverse;
    }

    void check(const Scene& scene, std::string_view reason) {
        CHECK(reason_for(scene, feature_) == reason);
        CHECK(reason_for(neighbour(scene, any_), feature_) == "");
    }

    const Feature& feature_;
    std::size_t first_ = 0;
    Views other_views_ = 0;
    AnyVector any_{};
};
} // namespace

TEST_CASE("for every feature, rays that are parallel to the planes that they should meet") {
    for (const Feature& feature : features) {
        CAPTURE(feature.notation);
        Scenes scenes(feature);
        if (feature.free_line) {
            scenes.check_auxiliary_ray_along_line();
            continue;
        }
        scenes.check_point_at_infinity();
        for (std::size_t view = 0; view < 3; ++view) {
            CAPTURE(view);
            if (view != scenes.ray_view() && has_view(feature.views, view))
                scenes.check_ray_in_plane(view);
        }
    }
}

TEST_CASE("for every feature, its point in the centre of a view that sees it") {
    for (const Feature& feature : features) {
        CAPTURE(feature.notation);
        for (std::size_t view = 0; view < 3; ++view) {
            CAPTURE(view);
            if (has_view(feature.point, view)) Scenes(feature).check_point_in_centre(view);
        }
    }
}

TEST_CASE("for every feature, a line without direction or through the centre of a view of it") {
    for (const Feature& feature : features) {
        CAPTURE(feature.notation);
        for (std::size_t pin = 0; pin < feature.pins; ++pin) {
            CAPTURE(pin);
            if (std::popcount(feature.pin[pin]) < 2) continue;
            Scenes scenes(feature);
            scenes.check_line_without_direction(pin);
            for (std::size_t view = 0; view < 3; ++view) {
                CAPTURE(view);
                if (has_view(feature.pin[pin], view)) scenes.check_line_through_centre(pin, view);
            }
        }
    }
}
