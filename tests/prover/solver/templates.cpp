// Registration problems and their templates: equations against planted cameras, degrees against
// their bounds, and numbers of solutions against those of a Groebner basis modulo a prime.
#include "prover/solver/templates/template.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <set>

using namespace plprove;
using namespace plprove::templates;

namespace {

const std::map<Registration, int>& types() {
    static const auto all = [] {
        auto found = registration_types(label_classes());
        found.emplace(relative_pose(), 0);
        return found;
    }();
    return all;
}

std::vector<Frame> frames(const Registration& type) {
    std::vector<Frame> suitable;
    for (const Frame frame : {Frame::general, Frame::line, Frame::points, Frame::lines})
        if (suits(frame, type)) suitable.push_back(frame);
    return suitable;
}

Residue value(const Polynomial& polynomial, const std::array<Residue, 4>& at) {
    const nmod_t q = modulus_context();
    Residue total = 0;
    for (const auto& [monomial, coefficient] : polynomial) {
        Residue term = coefficient;
        for (std::size_t i = 0; i < 4; ++i)
            term = nmod_mul(term, nmod_pow_ui(at[i], static_cast<mp_limb_t>(monomial[i]), q), q);
        total = nmod_add(total, term, q);
    }
    return total;
}

/// A camera with a rotation that is rational in the coordinates of the frame: `matrix` is `scale`
/// times the rotation, and it takes X to matrix X + translation.
struct Planted {
    std::array<Residue, 4> coordinates{};
    Matrix3 matrix{};
    std::int64_t scale = 1;
    Vector3 translation{};

    Vector3 image(const Vector3& x) const { return matrix * x + translation; }
};

Residue fraction(std::int64_t numerator, std::int64_t denominator) {
    return nmod_div(residue(numerator), residue(denominator), modulus_context());
}

Planted plant(Frame frame) {
    if (frame == Frame::general) { // 1 + 4 + 4 + 16 = 25, the norm of a quaternion with entries / 5
        Planted camera{{}, rotation_matrix({1, 2, 2, 4}), 25, {7, -11, 130}};
        camera.coordinates = {fraction(1, 5), fraction(2, 5), fraction(2, 5), fraction(4, 5)};
        return camera;
    }
    Planted camera{{}, {}, 65, {70, -110, 131}};
    camera.coordinates = {fraction(3, 5), fraction(4, 5), fraction(5, 13), fraction(12, 13)};
    camera.matrix = {{{39, -20, 48}, {52, 15, -36}, {0, 60, 25}}}; // 65 S T
    return camera;
}

/// An image line through the image point of the camera, other than by chance like any other.
Vector3 line_through(const Vector3& image, int salt) {
    return cross(image, {3 + salt, 5 - 2 * salt, 7 + salt * salt});
}

/// Data that the camera satisfies, with the objects in space of `data`.
RegistrationData seen_by(const Planted& camera, RegistrationData data, Frame frame) {
    // In the frames `line` and `points` the translation is what the objects on the axis require.
    for (auto& star : data.stars) {
        star.image = camera.image(star.point);
        for (auto& pin : star.pins)
            pin.toward = camera.image(star.point + pin.direction);
    }
    for (std::size_t i = 0; i < data.lines.size(); ++i) {
        auto& line = data.lines[i];
        if ((frame != Frame::line && frame != Frame::lines) || i > 0)
            line.image = cross(camera.image(line.point), camera.image(line.point + line.direction));
    }
    int salt = 0;
    for (auto& incidence : data.incidences)
        incidence.image = line_through(camera.image(incidence.point), ++salt);
    for (auto& group : data.groups)
        for (auto& ray : group.rays)
            ray.image = camera.image(group.point + ray.direction);
    return data;
}

/// Small, so that no image is large.
RegistrationData small(RegistrationData data) {
    const auto shrink = [](Vector3& v) {
        for (std::int64_t& x : v)
            if (x > 9 || x < -9) x = x % 7 + 1;
    };
    for (auto& star : data.stars) {
        shrink(star.point);
        for (auto& pin : star.pins)
            shrink(pin.direction);
    }
    for (auto& line : data.lines) {
        shrink(line.point);
        shrink(line.direction);
    }
    for (auto& incidence : data.incidences)
        shrink(incidence.point);
    for (auto& group : data.groups) {
        shrink(group.point);
        for (auto& ray : group.rays)
            shrink(ray.direction);
    }
    return data;
}

} // namespace

TEST_CASE("all equations vanish at the rotation of a camera that satisfies the constraints") {
    std::size_t checked = 0;
    for (const auto& [type, count] : types())
        for (const Frame frame : frames(type)) {
            CAPTURE(describe(type));
            CAPTURE(name(frame));
            Planted camera = plant(frame);
            RegistrationData data = small(draw_data(type, frame, 5));
            // The third coordinate of the image of what is on the axis has to be 0.
            if (frame == Frame::points || frame == Frame::lines) camera.translation[2] = 0;
            if (frame == Frame::line)
                camera.translation[2] = -(camera.matrix * data.lines[0].point)[2];
            data = seen_by(camera, data, frame);
            for (const Equation& equation : equations(data, frame)) {
                CHECK(value(equation.polynomial, camera.coordinates) == 0);
                ++checked;
            }
            // ... and not at the rotation of another one.
            const std::array<Residue, 4> other =
                frame == Frame::general
                    ? std::array{fraction(1, 2), fraction(1, 2), fraction(1, 2), fraction(1, 2)}
                    : std::array{fraction(4, 5), fraction(3, 5), fraction(3, 5), fraction(4, 5)};
            CHECK(std::ranges::any_of(equations(data, frame), [&](const Equation& equation) {
                return value(equation.polynomial, other) != 0;
            }));
        }
    CHECK(checked > 1000);
}

TEST_CASE("no equation has a larger degree than is claimed of it, most have no smaller one") {
    std::size_t total = 0;
    std::size_t attained = 0;
    for (const auto& [type, count] : types())
        for (const Frame frame : frames(type)) {
            CAPTURE(describe(type));
            CAPTURE(name(frame));
            const RotationRing ring(frame);
            for (const Equation& equation : equations(draw_data(type, frame, 3), frame)) {
                BiDegree degree{};
                for (const auto& [monomial, coefficient] : equation.polynomial)
                    for (std::size_t i = 0; i < 2; ++i)
                        degree[i] = std::max(degree[i], ring.degree(monomial)[i]);
                CHECK(at_most(degree, equation.degree));
                ++total;
                attained += degree == equation.degree ? 1 : 0;
            }
        }
    CHECK(total > 1000);
    CHECK(attained * 10 > total * 9);
}

TEST_CASE("bounds are the numbers of solutions that Groebner bases modulo a prime have shown") {
    const auto bound = [](std::vector<int> stars, int lines, int incidences,
                          std::vector<int> groups) {
        Registration type;
        type.stars = std::move(stars);
        type.lines = lines;
        type.incidences = incidences;
        type.groups = std::move(groups);
        const auto found = best_template(type);
        return found ? found->basis.size() : 0;
    };
    CHECK(bound({0, 0, 0}, 0, 0, {}) == 8);
    CHECK(bound({0, 0}, 1, 0, {}) == 4);
    CHECK(bound({0}, 2, 0, {}) == 8);
    CHECK(bound({}, 3, 0, {}) == 8);
    CHECK(bound({}, 0, 6, {}) == 8);
    CHECK(bound({0, 0}, 0, 2, {}) == 8);
    CHECK(bound({0, 0}, 0, 1, {1}) == 12);
    CHECK(bound({}, 0, 5, {1}) == 16);
    CHECK(bound({}, 2, 0, {1, 1}) == 16);
    CHECK(bound({0, 0}, 0, 0, {1, 1}) == 16);
    CHECK(bound({}, 0, 4, {1, 1}) == 32);
    CHECK(bound({0}, 0, 0, {1, 1, 1, 1}) == 32);
    CHECK(bound({}, 0, 3, {1, 1, 1}) == 52);
    CHECK(bound({}, 0, 0, {1, 1, 1, 1, 1, 1}) == 64);
    CHECK(bound({}, 0, 0, {5}) == 20); // ten essential matrices
}

TEST_CASE("each registration problem has six constraints; rays of a view are at most five") {
    for (const auto& [type, count] : types()) {
        if (type == relative_pose()) continue;
        CAPTURE(describe(type));
        int weight = 2 * static_cast<int>(type.stars.size()) + 2 * type.lines + type.incidences;
        for (const int pins : type.stars)
            weight += pins;
        for (const int rays : type.groups)
            weight += rays;
        CHECK(weight == 6);
        CHECK(count > 0);
    }
    CHECK(types().size() == 89);
}
