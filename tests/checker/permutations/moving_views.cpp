// How equations of images change when the views move, by a second method and by laws.
#include "checker/algebra/dual.h"
#include "checker/permutations/echelon.h"

#include <doctest/doctest.h>

using namespace checker;

namespace {

using Changing = Vector3<Dual<Residue>>;

/// The numbers with their derivatives by the 12 numbers of a motion.
Dual<Residue> with(Residue value, std::size_t unknown) {
    Dual<Residue> result{value, std::vector<Residue>(12)};
    result.change[unknown] = Residue{1};
    return result;
}

Changing constants(const ResidueVector& v) {
    return {constant(v[0]), constant(v[1]), constant(v[2])};
}

/// A vector that turns with its view.
Changing turning(const Seen& seen) {
    if (seen.view == 0) return constants(seen.vector);
    const std::size_t first = 3 * (seen.view - 1);
    const Changing turn{with({}, first), with({}, first + 1), with({}, first + 2)};
    return plus(constants(seen.vector), cross(constants(seen.vector), turn));
}

/// The difference of two centres.
Changing moving(const MovingViews& views, std::size_t from, std::size_t to) {
    Changing result = constants(views.baseline(from, to));
    for (std::size_t i = 0; i < 3; ++i) {
        if (to != 0) result[i] = result[i] + with({}, 6 + 3 * (to - 1) + i);
        if (from != 0) result[i] = result[i] - with({}, 6 + 3 * (from - 1) + i);
    }
    return result;
}

bool same(const Equation& equation, Dual<Residue> expected) {
    expected.change.resize(12);
    return equation.value == expected.value &&
           std::ranges::equal(equation.derivatives, expected.change);
}

} // namespace

TEST_CASE("equations of images know how they change when the views move") {
    Drawn drawn;
    const MovingViews views(drawn);
    const std::array<std::size_t, 3> orders[] = {{0, 1, 2}, {1, 2, 0}, {2, 0, 1}, {1, 0, 2}};
    for (const auto& [i, j, k] : orders) {
        const Seen ray{i, drawn.vector()}, second{j, drawn.vector()}, third{k, drawn.vector()};
        CHECK(same(views.epipolar(ray, second),
                   dot(moving(views, i, j), cross(turning(ray), turning(second)))));
        const Changing d = turning(ray), m = turning(second), n = turning(third);
        CHECK(
            same(views.incidence(ray, second, third), dot(m, moving(views, j, i)) * dot(n, d) -
                                                          dot(n, moving(views, k, i)) * dot(m, d)));
    }
    const std::array normals{drawn.vector(), drawn.vector(), drawn.vector()};
    CHECK(same(
        MovingViews::pencil(normals),
        dot(turning({0, normals[0]}), cross(turning({1, normals[1]}), turning({2, normals[2]})))));
}

TEST_CASE("what relative poses know of three views is what there is to know") {
    Drawn drawn;
    const MovingViews views(drawn);
    const auto all = [&](std::initializer_list<std::pair<std::size_t, std::size_t>> pairs) {
        Echelon known;
        for (const auto& [i, j] : pairs)
            known.add_all(views.relative_pose(i, j));
        return known;
    };
    CHECK(all({{0, 1}}).size() == 5);
    CHECK(all({{1, 2}}).size() == 5);
    CHECK(all({{0, 1}, {0, 2}}).size() == 10); // but for how long the baselines are
    Echelon known = all({{0, 1}, {0, 2}, {1, 2}});
    CHECK(known.size() == 11);

    // The images of an object change with relative poses only. Those of two views know one pose.
    const ResidueVector point = drawn.vector();
    const Seen first{0, views.from(0, point)}, second{1, views.from(1, point)};
    CHECK(views.epipolar(first, second).value == Residue{});
    Echelon of_two = all({{0, 1}});
    CHECK(!of_two.add(views.epipolar(first, second).derivatives));
    CHECK(of_two.add(views.epipolar(first, {2, views.from(2, point)}).derivatives));
    const Equation meet = views.incidence(first, {1, drawn.normal_to(second.vector)},
                                          {2, drawn.normal_to(views.from(2, point))});
    CHECK(meet.value == Residue{});
    CHECK(!known.add(meet.derivatives));

    // A motion satisfies what it is made for.
    const Motion motion = of_two.motion(drawn);
    CHECK(views.epipolar(first, second).along(motion) == Residue{});
    CHECK(meet.along(motion) != Residue{});
}
