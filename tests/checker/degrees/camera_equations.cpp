// The camera equations (FORMAT.md, section 9) at cameras and scenes that are known exactly.
#include "tests/checker/degrees/instances.h"

using namespace checker;
using namespace instances;

namespace {
/// Value and derivative.
struct Dual {
    Rational value = 0, change = 0;
    Dual() = default;
    explicit Dual(double x) : value(x) {}
    Dual(const Rational& x, const Rational& dx) : value(x), change(dx) {}
    Dual operator-() const { return {-value, -change}; }
    Dual operator+(const Dual& b) const { return {value + b.value, change + b.change}; }
    Dual operator-(const Dual& b) const { return {value - b.value, change - b.change}; }
    Dual operator*(const Dual& b) const {
        return {value * b.value, value * b.change + change * b.value};
    }
};

/// The derivatives of a system's equations by the k-th coordinate, in two ways, at a point.
void compare_derivatives(const CameraSystem& system, const RationalCameras& point, std::size_t k) {
    BackProjections<Rational> space;
    back_project(system, point, space);
    CameraCoordinates<Dual> moving, unused;
    for (std::size_t i = 0; i < camera_unknowns; ++i)
        moving[i] = {point[i], Rational(i == k ? 1 : 0)};
    BackProjections<Dual> moving_space;
    back_project(system, moving, moving_space);
    for (const CameraEquation& equation : system.equations) {
        RationalCameras row;
        const Dual value = evaluate(system, equation, moving_space, unused);
        CHECK(evaluate(system, equation, space, row) == value.value);
        CHECK(row[k] == value.change);
    }
}
} // namespace

TEST_CASE("the equations hold at the true cameras, exactly, and not at others") {
    for (const std::size_t number : all_kinds()) {
        CAPTURE(number);
        Instance instance = good_instance(number);
        const CameraSystem system = system_of(instance);
        REQUIRE(system.equations.size() == 11);
        BackProjections<Rational> space;
        RationalCameras row;
        const auto violated = [&] {
            back_project(system, instance.cameras, space);
            return std::count_if(
                system.equations.begin(), system.equations.end(),
                [&](const CameraEquation& e) { return evaluate(system, e, space, row) != 0; });
        };
        CHECK(violated() == 0);
        for (Rational& coordinate : instance.cameras) {
            coordinate += 1;
            CHECK(violated() > 0);
            coordinate -= 1;
        }
    }
}

TEST_CASE("derivatives are those of the values, over the dual numbers") {
    for (const std::size_t number : all_kinds()) {
        const CameraSystem system = system_of(good_instance(number));
        Random random;
        RationalCameras point;
        for (Rational& x : point)
            x = random(9);
        for (std::size_t k = 0; k < camera_unknowns; ++k)
            compare_derivatives(system, point, k);
    }
}

TEST_CASE("the number of equations of a feature is its weight") {
    const Instance all = [] {
        Instance instance = example();
        Random random;
        instance.features.clear();
        instance.points.clear();
        for (std::size_t i = 0; i < feature_count; ++i) {
            instance.features.push_back(i);
            auto& points = instance.points.emplace_back();
            for (unsigned k = 0; k < features[i].pins + 1; ++k)
                points.push_back({random(9), random(9), random(9)});
        }
        return instance;
    }();
    for (std::size_t i = 0; i < feature_count; ++i) {
        CAPTURE(features[i].notation);
        const Instance one{all.cameras, {i}, {all.points[i]}};
        CHECK(system_of(one).equations.size() == features[i].weight());
    }
}

TEST_CASE("images that are zero") {
    const std::string zero = "2: class 2394: an image, or an auxiliary one, is zero";
    const std::string& images = example_images();
    const std::size_t last = images.rfind("image");
    const auto with_images = [&](const std::string& views) {
        return images.substr(0, last) + "image P/P/P" + views + "\n" + example_solution();
    };
    CHECK(refusal(with_images(" view point 0 0 0 view point 1 2 3 view point 3 4 5")) == zero);
    CHECK(refusal(with_images(" view point 1 2 4 view point 1 0 0 view point 3 4 5")) == zero);
    const std::size_t toward = images.find("toward"), point = images.find("point") + 5;
    const std::size_t end = images.find(" view", toward);
    CHECK(refusal(images.substr(0, toward + 6) + images.substr(point, toward - 1 - point) +
                  images.substr(end) + example_solution()) == zero);
}
