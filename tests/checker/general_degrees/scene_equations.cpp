// The equations of problems in general (FORMAT.md, section 14), at cameras and scenes that are
// known exactly, and as a second method has them: cross products of images.
#include "checker/general_degrees/scene_at.h"
#include "tests/checker/general/image_rank.h"
#include "tests/support/text.h"

#include <doctest/doctest.h>

using namespace checker;
using general::carrier;
using general::ImageCoordinates;
using general::SceneSystem;
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

/// A camera: rows of four numbers.
using Camera = std::array<std::array<int, 4>, 3>;

/// Cameras and depths in the coordinates of FORMAT.md, all of them integers, and what views see.
struct Instance {
    general::Problem problem{};
    std::vector<Camera> cameras{};
    std::vector<Rational> coordinates{};
    std::vector<Numbers> views{};
};

Camera calibrated(bool second, Dice& dice, std::vector<Rational>& coordinates) {
    const int x = dice.from_to(-2, 2), y = dice.from_to(-2, 2), z = dice.from_to(-2, 2);
    const int t = second ? 1 : dice.from_to(-3, 3), u = dice.from_to(-3, 3),
              v = dice.from_to(-3, 3);
    for (const int number : {x, y, z, t, u, v})
        coordinates.emplace_back(number);
    if (second) coordinates.erase(coordinates.end() - 3);
    return {{{1 + x * x - y * y - z * z, 2 * (x * y - z), 2 * (x * z + y), t},
             {2 * (x * y + z), 1 - x * x + y * y - z * z, 2 * (y * z - x), u},
             {2 * (x * z - y), 2 * (y * z + x), 1 - x * x - y * y + z * z, v}}};
}

Camera projective(bool second, Dice& dice, std::vector<Rational>& coordinates) {
    Camera camera{};
    for (std::size_t entry = 0; entry < 12; ++entry) {
        int& number = camera[entry / 4][entry % 4];
        const bool one = second ? entry == 3 || entry == 4 : entry == 0;
        const bool fixed = second ? entry < 5 : entry < 1;
        number = fixed ? (one ? 1 : 0) : dice.from_to(-3, 3);
        if (!fixed) coordinates.emplace_back(number);
    }
    return camera;
}

using Four = std::array<int, 4>;

/// The image of a place, multiplied.
Vector3<int> image(const Camera& camera, const Four& place, int factor) {
    Vector3<int> result{};
    for (std::size_t i = 0; i < 3; ++i)
        for (std::size_t j = 0; j < 4; ++j)
            result[i] += factor * camera[i][j] * place[j];
    return result;
}

void append(Numbers& numbers, const Vector3<int>& vector) {
    numbers.insert(numbers.end(), vector.begin(), vector.end());
}

/// Places with a depth of their own, in the order of the depths: view 1 sees (x, depth) at x.
struct Places {
    std::vector<Four> free{};
    std::vector<std::array<int, 2>> factors{}; // of each point; of free ones, none
};

Places random_places(const general::Problem& problem, Dice& dice) {
    Places places;
    const auto add = [&] {
        Four& place = places.free.emplace_back();
        for (int& number : place)
            number = dice.from_to(-4, 4);
    };
    for (std::size_t p = 0; p < problem.points.size(); ++p) {
        places.factors.push_back({dice.from_to(1, 2), dice.from_to(-2, -1)});
        if (!carrier(problem, p)) add();
    }
    for (const general::Line& line : problem.lines)
        for (std::size_t n = line.points.size(); n < 2; ++n)
            add();
    return places;
}

/// What a camera sees of the places, each image multiplied by 1 up to `most`. A dependent point has
/// such factors that its image is the same.
Numbers view_of(const general::Problem& problem, const Places& places, const Camera& camera,
                int most, Dice& dice) {
    Numbers numbers;
    std::vector<int> multiples;
    std::size_t next = 0;
    for (std::size_t p = 0; p < problem.points.size(); ++p) {
        const auto on = carrier(problem, p);
        if (!on) {
            multiples.push_back(dice.from_to(1, most));
            append(numbers, image(camera, places.free[next++], multiples[p]));
            continue;
        }
        const auto& points = problem.lines[*on].points;
        const int a = multiples[points[0]], b = multiples[points[1]];
        multiples.push_back(a * b);
        numbers.push_back(places.factors[p][0] * b);
        numbers.push_back(places.factors[p][1] * a);
    }
    while (next < places.free.size())
        append(numbers, image(camera, places.free[next++], dice.from_to(1, most)));
    return numbers;
}

Instance instance_of(const std::string& notation, unsigned seed) {
    Dice dice(seed);
    Instance instance{.problem = problem_of(notation)};
    const general::Problem& problem = instance.problem;
    instance.cameras.push_back({{{1, 0, 0, 0}, {0, 1, 0, 0}, {0, 0, 1, 0}}});
    for (int view = 1; view < std::popcount(problem.views); ++view) {
        const auto make = problem.projective ? projective : calibrated;
        instance.cameras.push_back(make(view == 1, dice, instance.coordinates));
    }
    const Places places = random_places(problem, dice);
    for (const Four& place : places.free)
        instance.coordinates.emplace_back(place[3]);
    for (const Camera& camera : instance.cameras) {
        const int most = instance.views.empty() ? 1 : 2; // view 1 shows the places themselves
        instance.views.push_back(view_of(problem, places, camera, most, dice));
    }
    return instance;
}

/// An instance whose images meet the conditions of FORMAT.md, and its system.
std::pair<Instance, SceneSystem> good_instance(const std::string& notation) {
    for (unsigned seed = 1; seed < 1000; ++seed)
        try {
            const Instance instance = instance_of(notation, seed);
            const SceneSystem system = general::scene_system(instance.problem, instance.views);
            general::SceneAt<Rational> at(system);
            at.move_to(instance.coordinates);
            if (at.degeneracy().empty()) return {instance, system};
        } catch (const Refused&) {
            continue; // too special
        }
    FAIL("no instance");
    return {};
}

/// The values of all equations.
template <class T>
std::vector<T> values(const SceneSystem& system, const std::vector<T>& coordinates) {
    general::SceneAt<T> at(system);
    at.move_to(coordinates);
    std::vector<T> row(coordinates.size()), result;
    for (std::size_t e = 0; e < system.incidences.size(); ++e)
        result.push_back(at.equation(e, row));
    return result;
}

} // namespace

TEST_CASE("the equations hold at the true cameras and depths, exactly, and not at others") {
    for (const std::string& notation : problems) {
        CAPTURE(notation);
        const auto [instance, system] = good_instance(notation);
        std::vector<Rational> coordinates = instance.coordinates;
        REQUIRE(coordinates.size() == system.camera_coordinates() + system.depths);
        REQUIRE(coordinates.size() == system.incidences.size());
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
        const auto [instance, system] = good_instance(notation);
        const std::size_t size = instance.coordinates.size();
        std::vector<Rational> place;
        Dice dice(5);
        for (std::size_t i = 0; i < size; ++i)
            place.emplace_back(dice.from_to(-9, 9));
        general::SceneAt<Rational> at(system);
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
        const auto [instance, system] = good_instance(notation);
        // At the true cameras and other depths.
        std::vector<Rational> coordinates = instance.coordinates;
        for (std::size_t k = system.camera_coordinates(); k < coordinates.size(); ++k)
            coordinates[k] += 3;
        const std::vector<Rational> found = values(system, coordinates);
        std::size_t compared = 0;
        for (std::size_t e = 0; e < found.size(); ++e) {
            const auto& [camera, line, place] = system.incidences[e];
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
            const ImageCoordinates& second = system.incidences[e + 1].line;
            const Vector3<Rational> y{Rational(second[2]), Rational(-line[2]), Rational(line[1])};
            const Vector3<Rational> product = cross(z, y);
            CHECK(found[e] == product[0]);
            CHECK(found[e + 1] == product[1]);
            ++compared;
        }
        CHECK((compared > 0 || instance.problem.points.empty()));
    }
}
