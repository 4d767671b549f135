// The equations of problems in general (FORMAT.md, section 14), at cameras and scenes that are
// known exactly, and as a second method has them: cross products of images.
#include "checker/general_degrees/scene_at.h"
#include "tests/checker/general_degrees/known_scene.h"
#include "tests/checker/minimal/image_rank.h"
#include "tests/support/text.h"

#include <doctest/doctest.h>

using namespace checker;
using Rational = mpq_class;

namespace {

/// Value and derivative.
struct Change {
    Rational value = 0, change = 0;
    Change() = default;
    explicit Change(double x) : value(x) {}
    Change(const Rational& x, const Rational& dx) : value(x), change(dx) {}
    Change operator-() const { return {-value, -change}; }
    Change operator+(const Change& b) const { return {value + b.value, change + b.change}; }
    Change operator-(const Change& b) const { return {value - b.value, change - b.change}; }
    Change operator*(const Change& b) const {
        return {value * b.value, value * b.change + change * b.value};
    }
};

const std::vector<std::string> problems{
    "5*P/P",
    "3*PL/PL + 2*P/P",
    "2*PL/PL/PL + PLa/PLa/PLa + a/a/a",
    "PLM/PLM + 2*PL/PL + 2*PM/PM",
    "3*PL/PL/PL/PL + a/a/a/a",
    "projective: 7*P/P",
    "projective: 9*a/a/a",
    "projective: PLM/PLM + PLN/PLN + PL/PL + 2*PM/PM + 2*PN/PN",
    "projective: PLab/PLab/PLab/PLab + 2*PLabc/PLabc/PLabc/PLabc",
};

/// The values of all equations.
template <class T>
std::vector<T> values(const SceneSystem& system, const std::vector<T>& coordinates) {
    SceneAt<T> at(system);
    at.move_to(coordinates);
    std::vector<T> row(coordinates.size()), result;
    for (std::size_t e = 0; e < system.equations.size(); ++e)
        result.push_back(at.equation(e, row));
    return result;
}

} // namespace

TEST_CASE("the equations hold at the true cameras and depths, exactly, and not at others") {
    for (const std::string& notation : problems) {
        CAPTURE(notation);
        const KnownScene instance = known_scene(notation);
        const SceneSystem system = scene_system(instance.problem, instance.views);
        std::vector<Rational> coordinates = instance.coordinates;
        REQUIRE(coordinates.size() == system.camera_coordinates() + system.depths);
        REQUIRE(coordinates.size() == system.equations.size());
        CHECK(values(system, coordinates) == std::vector<Rational>(coordinates.size()));
        for (Rational& coordinate : coordinates) {
            coordinate += 1;
            CHECK(values(system, coordinates) != std::vector<Rational>(coordinates.size()));
            coordinate -= 1;
        }
    }
}

TEST_CASE("derivatives are those of the values, over the dual numbers") {
    for (const std::string& notation : problems) {
        CAPTURE(notation);
        const KnownScene instance = known_scene(notation);
        const SceneSystem system = scene_system(instance.problem, instance.views);
        const std::size_t size = instance.coordinates.size();
        std::vector<Rational> place;
        Dice dice(5);
        for (std::size_t i = 0; i < size; ++i)
            place.emplace_back(dice.from_to(-9, 9));
        SceneAt<Rational> at(system);
        at.move_to(place);
        std::vector<std::vector<Rational>> rows(size, std::vector<Rational>(size));
        for (std::size_t e = 0; e < size; ++e)
            at.equation(e, rows[e]);
        for (std::size_t k = 0; k < size; ++k) {
            std::vector<Change> moving;
            for (std::size_t i = 0; i < size; ++i)
                moving.emplace_back(place[i], Rational(i == k ? 1 : 0));
            const std::vector<Change> changes = values(system, moving);
            for (std::size_t e = 0; e < size; ++e)
                CHECK(rows[e][k] == changes[e].change);
        }
    }
}

TEST_CASE("equations of free points are coordinates of the cross product of two images") {
    for (const std::string& notation : problems) {
        CAPTURE(notation);
        const KnownScene instance = known_scene(notation);
        const SceneSystem system = scene_system(instance.problem, instance.views);
        // At the true cameras and other depths.
        std::vector<Rational> coordinates = instance.coordinates;
        for (std::size_t k = system.camera_coordinates(); k < coordinates.size(); ++k)
            coordinates[k] += 3;
        const std::vector<Rational> found = values(system, coordinates);
        std::size_t compared = 0;
        for (std::size_t e = 0; e < found.size(); ++e) {
            const auto& [camera, line, place] = system.equations[e];
            const bool is_free = place < system.points && !carrier(instance.problem, place);
            if (!is_free || line[0] != 0) continue;
            const auto& [x, form] = system.places[place];
            const std::size_t depth = system.camera_coordinates() + form.size() - 1;
            const Rational& d = coordinates[depth];
            Vector3<Rational> z;
            for (std::size_t i = 0; i < 3; ++i) {
                const auto& row = instance.cameras[camera + 1][i];
                z[i] = row[0] * Rational(x[0]) + row[1] * Rational(x[1]) + row[2] * Rational(x[2]) +
                       row[3] * d;
            }
            // The lines (0, y_3, -y_2) and (-y_3, 0, y_1) say which y this is.
            const ImageCoordinates& second = system.equations[e + 1].line;
            const Vector3<Rational> y{Rational(second[2]), Rational(-line[2]), Rational(line[1])};
            const Vector3<Rational> product = cross(z, y);
            CHECK(found[e] == product[0]);
            CHECK(found[e + 1] == product[1]);
            ++compared;
        }
        CHECK((compared > 0 || instance.problem.points.empty()));
    }
}
