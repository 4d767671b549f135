// The equations between cameras and images of degree files (FORMAT.md, section 9), over any ring of
// numbers: doubles find a solution, balls prove it, rationals test the equations.
#pragma once

#include "checker/jacobian.h"

#include <tuple>

namespace checker {
template <class T> using Triple = std::array<T, 3>;
using Image = Triple<std::int64_t>; // of a point or a line

/// What a view (0, 1, 2) sees; an auxiliary point or line, too.
struct Sight {
    unsigned view;
    Image image;
};

/// By sights: two points; a point and two lines; three lines.
enum class Kind { epipolar, incidence, pencil };
struct Equation {
    Kind kind;
    std::array<std::size_t, 3> sights;
};

/// Where a feature is in space: by sights, a ray and a plane that meet in its point; by their first
/// two sights, its lines; and the views that see them.
struct Place {
    std::size_t ray, plane;
    Views seen;
    std::vector<std::tuple<std::size_t, std::size_t, Views>> lines{};
};

struct System {
    std::vector<Sight> sights{};
    std::vector<Equation> equations{};
    std::vector<Place> places{};
};

/// The images of a feature: of its point, by view, and of its pins (or of the free line).
struct FeatureImages {
    std::array<Image, 3> point{};
    std::array<std::array<Image, 3>, 26> line{};
};

/// Adds the equations of a feature. Throws Refused if an image is zero.
inline void add_feature(System& system, const Feature& feature, const FeatureImages& images) {
    const auto add = [&](unsigned view, const Image& image) {
        if (image == Image{}) throw Refused("an image, or an auxiliary one, is zero");
        system.sights.push_back({view, image});
        return system.sights.size() - 1;
    };
    const auto auxiliary = [&](std::size_t sight) {
        const auto [view, image] = system.sights[sight];
        return add(view, {0, image[2], -image[1]});
    };
    const auto first = [](Views views) { return static_cast<unsigned>(std::countr_zero(views)); };
    const unsigned i = feature.free_line ? 0 : first(feature.point); // the view of the ray
    std::array<std::size_t, 3> point{}, plane{};                     // by view
    std::vector<std::array<std::size_t, 3>> pins(feature.pins);
    Views planes = 0; // the views of which there is one
    for (unsigned v = 0; v < 3; ++v) {
        const bool sees_point = feature.point >> v & 1;
        if (sees_point) point[v] = add(v, images.point[v]);
        for (std::size_t pin = 0; pin < feature.pins; ++pin) {
            if (!(feature.pin[pin] >> v & 1)) continue;
            pins[pin][v] = add(v, images.line[pin][v]);
            if (!sees_point) plane[v] = pins[pin][v];
        }
        if (v == i || !(feature.views >> v & 1)) continue;
        planes |= 1U << v;
        if (!sees_point) continue;
        plane[v] = auxiliary(point[v]);
        system.equations.push_back({Kind::epipolar, {point[i], point[v]}});
    }
    const unsigned j = i == 0 ? 1 : 0, k = i == 2 ? 1 : 2;
    const std::size_t ray = feature.free_line ? auxiliary(pins[0][0]) : point[i];
    if (std::popcount(planes) == 2)
        system.equations.push_back({Kind::incidence, {ray, plane[j], plane[k]}});
    const Views other = feature.point & planes; // the views of another image of the point
    Place place{ray, plane[first(other != 0 ? other : planes)], feature.point};
    for (std::size_t pin = 0; pin < feature.pins; ++pin) {
        const Views seen = feature.pin[pin];
        if (seen == 0b111) system.equations.push_back({Kind::pencil, pins[pin]});
        place.lines.emplace_back(pins[pin][first(seen)], pins[pin][first(seen & (seen - 1))], seen);
    }
    system.places.push_back(place);
}

template <class T> T dot(const Triple<T>& a, const Triple<T>& b) {
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}
template <class T> Triple<T> cross(const Triple<T>& a, const Triple<T>& b) {
    return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
template <class T> Triple<T> times(const T& s, const Triple<T>& a) {
    return {s * a[0], s * a[1], s * a[2]};
}
template <class T> Triple<T> minus(const Triple<T>& a, const Triple<T>& b) {
    return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}

template <class T> using Coordinates = std::array<T, camera_unknowns>; // of the cameras

/// What the cameras make of the sights: the ray R^T x or normal R^T l of each, and its derivatives
/// by x, y, z, which are not set in view 1.
template <class T> struct Scene {
    std::array<Triple<T>, 3> centres{};
    std::vector<std::array<Triple<T>, 4>> rays{};
    const Triple<T>& ray(std::size_t sight) const { return rays[sight][0]; }
};

/// The columns of R for the quaternion (1, x, y, z), and of its derivatives by x, y, z.
template <class T> std::array<Triple<Triple<T>>, 4> turn(const T& x, const T& y, const T& z) {
    const T o(1), t(2), xx = x * x, yy = y * y, zz = z * z;
    const T x2 = x + x, y2 = y + y, z2 = z + z, xy = x2 * y, xz = x2 * z, yz = y2 * z;
    return {{{{{o + xx - yy - zz, xy + z2, xz - y2},
               {xy - z2, o - xx + yy - zz, yz + x2},
               {xz + y2, yz - x2, o - xx - yy + zz}}},
             {{{x2, y2, z2}, {y2, -x2, t}, {z2, -t, -x2}}},
             {{{-y2, x2, -t}, {x2, y2, z2}, {t, z2, -y2}}},
             {{{-z2, t, x2}, {-t, -z2, y2}, {x2, y2, z2}}}}};
}

/// Looks at the sights with these cameras.
template <class T> void look(const System& system, const Coordinates<T>& c, Scene<T>& scene) {
    scene.centres[1] = {T(1), c[6], c[7]};
    scene.centres[2] = {c[8], c[9], c[10]};
    scene.rays.resize(system.sights.size());
    const std::array turns{turn(c[0], c[1], c[2]), turn(c[3], c[4], c[5])};
    for (std::size_t s = 0; s < system.sights.size(); ++s) {
        const auto& [view, image] = system.sights[s];
        const Triple<T> x{T(double(image[0])), T(double(image[1])), T(double(image[2]))};
        if (view == 0) scene.rays[s][0] = x;
        for (std::size_t k = 0; view > 0 && k < 12; ++k)
            scene.rays[s][k / 3][k % 3] = dot(turns[view - 1][k / 3][k % 3], x);
    }
}

/// The value of an equation; its derivatives by the camera coordinates go to `row`.
template <class T>
T evaluate(const System& system, const Equation& equation, const Scene<T>& scene,
           Coordinates<T>& row) {
    const auto& [first, second, third] = equation.sights;
    const Triple<T>&a = scene.ray(first), &b = scene.ray(second);
    const auto view = [&](std::size_t sight) { return system.sights[sight].view; };
    const auto by_ray = [&](std::size_t sight, const Triple<T>& derivative) {
        for (std::size_t k = 0; view(sight) > 0 && k < 3; ++k)
            row[3 * view(sight) - 3 + k] = dot(derivative, scene.rays[sight][k + 1]);
    };
    const auto by_centre = [&](std::size_t sight, const Triple<T>& derivative) {
        if (view(sight) == 1) row[6] = derivative[1], row[7] = derivative[2];
        if (view(sight) == 2) std::copy(derivative.begin(), derivative.end(), &row[8]);
    };
    row = {};
    const Triple<T> ab = minus(scene.centres[view(first)], scene.centres[view(second)]);
    if (equation.kind != Kind::incidence) { // determinants
        const bool pencil = equation.kind == Kind::pencil;
        const Triple<T>&c = pencil ? scene.ray(third) : ab, normal = cross(b, a);
        by_ray(first, cross(c, b));
        by_ray(second, cross(a, c));
        if (pencil) by_ray(third, normal);
        if (!pencil) by_centre(first, normal), by_centre(second, cross(a, b));
        return dot(c, normal);
    }
    const Triple<T>& c = scene.ray(third);
    const Triple<T> ac = minus(scene.centres[view(first)], scene.centres[view(third)]);
    const T b_ab = dot(b, ab), c_ac = dot(c, ac), ba = dot(b, a), ca = dot(c, a);
    by_ray(first, minus(times(b_ab, c), times(c_ac, b)));
    by_ray(second, minus(times(ca, ab), times(c_ac, a)));
    by_ray(third, minus(times(b_ab, a), times(ba, ac)));
    by_centre(first, minus(times(ca, b), times(ba, c)));
    by_centre(second, times(T(-ca), b));
    by_centre(third, times(ba, c));
    return b_ab * ca - c_ac * ba;
}

/// Whether a number is proved not to be zero; a set of numbers, whether none of them is.
template <class T> bool nonzero(const T& x) {
    return x != T(0);
}

/// Which condition of section 9 is not proved; empty if all are.
template <class T>
std::string_view degeneracy(const System& system, const Coordinates<T>& c, const Scene<T>& scene) {
    const auto differs = [](const Triple<T>& x) {
        return nonzero(x[0]) || nonzero(x[1]) || nonzero(x[2]);
    };
    const auto parallel = [&](std::size_t ray, std::size_t plane) {
        return !nonzero(dot(scene.ray(ray), scene.ray(plane)));
    };
    for (const T* q : {&c[0], &c[3]})
        if (!nonzero(T(T(1) + q[0] * q[0] + q[1] * q[1] + q[2] * q[2])))
            return "the norm of a quaternion is zero";
    for (const auto& [kind, sights] : system.equations)
        if (kind == Kind::incidence &&
            (parallel(sights[0], sights[1]) || parallel(sights[0], sights[2])))
            return "a ray is parallel to a plane of its incidence";
    for (const auto& [ray, plane, seen, lines] : system.places) {
        if (parallel(ray, plane)) return "a ray is parallel to the plane that it should meet";
        const Triple<T>&d = scene.ray(ray), &n = scene.ray(plane);
        const Triple<T>& centre = scene.centres[system.sights[ray].view];
        const T scale = dot(n, d);
        const T along = dot(n, minus(scene.centres[system.sights[plane].view], centre));
        for (unsigned v = 0; v < 3; ++v) { // X - c_v, scaled
            Triple<T> from = times(scale, minus(centre, scene.centres[v]));
            for (std::size_t k = 0; k < 3; ++k) from[k] = from[k] + along * d[k];
            if (seen >> v & 1 && !differs(from)) return "a point is the centre of a view of it";
            for (const auto& [a, b, views] : lines)
                if (views >> v & 1 && !differs(cross(from, cross(scene.ray(a), scene.ray(b)))))
                    return "a line has no direction, or meets the centre of a view of it";
        }
    }
    return {};
}
} // namespace checker
