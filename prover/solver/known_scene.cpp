#include "prover/solver/known_scene.h"

#include <Eigen/Geometry>
#include <algorithm>

namespace plprove {

namespace {

using Eigen::Vector3cd;
using Eigen::Vector3d;
using Scene = KnownScene<std::complex<double>>;

Vector3cd cross(const Vector3cd& a, const Vector3cd& b) {
    return bilinear_cross<Complex>(a, b);
}

Complex dot(const Vector3cd& a, const Vector3cd& b) {
    return bilinear<Complex>(a, b);
}

/// Locates features by two views, and adds what the third one sees of them.
class Locator {
public:
    Locator(const ClassSights& sights, int third, const ComplexPose& pose)
        : sights_(sights), first_((third + 1) % 3), second_((third + 2) % 3), third_(third),
          pose_(pose) {}

    void add(std::size_t index) {
        const Feature& feature = sights_.features()[index];
        if (!feature.has_point)
            add_line(index);
        else if (!feature.sees_point(third_))
            add_pins(index);
        else if (const auto point = located(index))
            add_star(index, *point);
        else
            add_ray(index);
    }

    Scene take() {
        for (auto& group : rays_)
            if (!group.rays.empty()) scene_.groups.push_back(std::move(group));
        std::ranges::stable_sort(scene_.groups, {},
                                 [](const auto& group) { return group.rays.size(); });
        std::ranges::stable_sort(scene_.stars, {},
                                 [](const auto& star) { return star.pins.size(); });
        return std::move(scene_);
    }

private:
    struct SpaceLine {
        Vector3cd point, direction;
    };

    Vector3cd seen_point(std::size_t index, int view) const { return sights_.point(index, view); }
    Vector3cd seen_line(std::size_t index, int view, int line) const {
        return sights_.line(index, view, line);
    }
    /// The direction in space of what view `second_` sees in this direction.
    Vector3cd turned_back(const Vector3cd& x) const { return pose_.R.transpose() * x; }

    /// Which line of the feature the view sees first; -1 if none.
    int first_line(const Feature& feature, int view) const {
        for (int line = 0; line < feature.lines; ++line)
            if (feature.sees_line(view, line)) return line;
        return -1;
    }

    /// The point, where both views see it, or one sees it and the other a line through it.
    std::optional<Vector3cd> located(std::size_t index) const {
        const Feature& feature = sights_.features()[index];
        const bool by_first = feature.sees_point(first_);
        const bool by_second = feature.sees_point(second_);
        if (by_first) {
            const Vector3cd x = seen_point(index, first_);
            if (by_second) return where_rays_meet(x, seen_point(index, second_));
            const int line = first_line(feature, second_);
            if (line < 0) return std::nullopt;
            const Vector3cd plane = seen_line(index, second_, line);
            return -dot(plane, pose_.t) / dot(plane, pose_.R * x) * x;
        }
        if (!by_second) return std::nullopt;
        const int line = first_line(feature, first_);
        if (line < 0) return std::nullopt;
        const Vector3cd plane = seen_line(index, first_, line);
        const Vector3cd ray = turned_back(seen_point(index, second_));
        const Vector3cd centre = -turned_back(pose_.t);
        return centre - dot(plane, centre) / dot(plane, ray) * ray;
    }

    /// The multiple of x that the second view sees as y.
    Vector3cd where_rays_meet(const Vector3cd& x, const Vector3cd& y) const {
        const Vector3cd a = cross(y, pose_.R * x);
        const Vector3cd b = cross(y, pose_.t);
        return -a.dot(b) / a.squaredNorm() * x;
    }

    /// Where the planes meet of a line that the first view sees, and one that the second sees.
    SpaceLine where_planes_meet(const Vector3cd& l, const Vector3cd& m) const {
        const Vector3cd plane = turned_back(m); // plane · X + m · t = 0
        const Vector3cd direction = cross(l, plane);
        const Vector3cd point =
            -dot(m, pose_.t) / direction.squaredNorm() * cross(direction.conjugate(), l);
        return {point, direction.normalized()};
    }

    SpaceLine known_line(std::size_t index, int line) const {
        return where_planes_meet(seen_line(index, first_, line), seen_line(index, second_, line));
    }

    bool is_known_line(const Feature& feature, int line) const {
        return feature.sees_line(first_, line) && feature.sees_line(second_, line);
    }

    void add_line(std::size_t index) {
        const SpaceLine line = known_line(index, 0);
        scene_.lines.push_back({line.point, line.direction, seen_line(index, third_, 0)});
    }

    void add_pins(std::size_t index) {
        const Feature& feature = sights_.features()[index];
        for (int pin = 0; pin < feature.lines; ++pin) {
            if (!feature.sees_line(third_, pin)) continue;
            const Vector3cd image = seen_line(index, third_, pin);
            if (is_known_line(feature, pin)) {
                const SpaceLine line = known_line(index, pin);
                scene_.lines.push_back({line.point, line.direction, image});
            } else if (const auto point = located(index)) {
                scene_.incidences.push_back({*point, image});
            }
        }
    }

    void add_star(std::size_t index, const Vector3cd& point) {
        const Feature& feature = sights_.features()[index];
        Scene::Star star{point, seen_point(index, third_), {}};
        for (int pin = 0; pin < feature.lines; ++pin)
            if (feature.sees_line(third_, pin) && is_known_line(feature, pin))
                star.pins.push_back(
                    {known_line(index, pin).direction, seen_line(index, third_, pin)});
        scene_.stars.push_back(std::move(star));
    }

    void add_ray(std::size_t index) {
        const Feature& feature = sights_.features()[index];
        const Vector3cd image = seen_point(index, third_);
        if (feature.sees_point(first_)) {
            rays_[0].point.setZero();
            rays_[0].rays.push_back({seen_point(index, first_), image});
        } else if (feature.sees_point(second_)) {
            rays_[1].point = -turned_back(pose_.t);
            const Vector3cd ray = turned_back(seen_point(index, second_));
            rays_[1].rays.push_back({ray.normalized(), image});
        } else {
            const SpaceLine line =
                where_planes_meet(seen_line(index, first_, first_line(feature, first_)),
                                  seen_line(index, second_, first_line(feature, second_)));
            scene_.groups.push_back({line.point, {{line.direction, image}}});
        }
    }

    const ClassSights& sights_;
    int first_, second_, third_;
    ComplexPose pose_;
    Scene scene_;
    std::array<Scene::Group, 2> rays_; // of the points that only the first or second view sees
};

} // namespace

ClassSights::ClassSights(const CameraSystem& system, const std::vector<Vector3d>& images)
    : features_(system.features), sights_(system.features.size()) {
    for (std::size_t f = 0; f < features_.size(); ++f)
        for (Sight& sight : sights_[f])
            sight.lines.resize(static_cast<std::size_t>(features_[f].lines));
    for (std::size_t k = 0; k < images.size(); ++k) {
        const FreeVector& free = system.free[k];
        Sight& sight =
            sights_[static_cast<std::size_t>(free.feature)][static_cast<std::size_t>(free.view)];
        if (free.line < 0)
            sight.point = images[k]; // comes before the lines through it
        else
            sight.lines[static_cast<std::size_t>(free.line)] =
                free.toward ? sight.point.cross(images[k]).normalized() : images[k];
    }
}

Vector3d ClassSights::point(std::size_t feature, int view) const {
    return sights_[feature][static_cast<std::size_t>(view)].point;
}

Vector3d ClassSights::line(std::size_t feature, int view, int line) const {
    return sights_[feature][static_cast<std::size_t>(view)].lines[static_cast<std::size_t>(line)];
}

KnownScene<std::complex<double>> known_scene(const ClassSights& sights, int third,
                                             const ComplexPose& pose) {
    Locator locator(sights, third, pose);
    for (std::size_t index = 0; index < sights.features().size(); ++index)
        locator.add(index);
    return locator.take();
}

} // namespace plprove
