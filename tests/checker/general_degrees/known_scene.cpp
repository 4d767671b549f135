#include "tests/checker/general_degrees/known_scene.h"

#include "checker/general_degrees/scene_at.h"
#include "tests/checker/minimal/image_rank.h"

#include <doctest/doctest.h>

using namespace checker;

namespace {

using Camera = KnownCamera;

Camera calibrated(bool second, Dice& dice, std::vector<mpq_class>& coordinates) {
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

Camera projective(bool second, Dice& dice, std::vector<mpq_class>& coordinates) {
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

Places random_places(const Problem& problem, Dice& dice) {
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
    for (const Line& line : problem.lines)
        for (std::size_t n = line.points.size(); n < 2; ++n)
            add();
    return places;
}

/// What a camera sees of the places, each image multiplied by 1 up to `most`. A dependent point has
/// such factors that its image is the same.
Numbers view_of(const Problem& problem, const Places& places, const Camera& camera, int most,
                Dice& dice) {
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

KnownScene instance_of(const std::string& notation, unsigned seed) {
    Dice dice(seed);
    KnownScene instance{.problem = problem_of(notation)};
    const Problem& problem = instance.problem;
    instance.cameras.push_back({{{1, 0, 0, 0}, {0, 1, 0, 0}, {0, 0, 1, 0}}});
    for (int view = 1; view < std::popcount(problem.views); ++view) {
        const auto make = problem.cameras == &checker::projective_cameras ? projective : calibrated;
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

} // namespace

KnownScene known_scene(const std::string& notation) {
    for (unsigned seed = 1; seed < 1000; ++seed)
        try {
            const KnownScene scene = instance_of(notation, seed);
            const SceneSystem system = scene_system(scene.problem, scene.views);
            SceneAt<mpq_class> at(system);
            at.move_to(scene.coordinates);
            if (at.degeneracy().empty()) return scene;
        } catch (const Refused&) {
            continue; // too special
        }
    FAIL("no instance");
    return {};
}
