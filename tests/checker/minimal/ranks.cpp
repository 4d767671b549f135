// Problems in general, by a second method: minors, verdicts and reasons against ranks that FLINT
// computes of another Jacobian; and the label classes of three calibrated views.
#include "checker/minimal/block.h"
#include "checker/reasons/part.h"
#include "checker/replay.h"
#include "tests/checker/minimal/image_rank.h"
#include "tests/support/all_classes.h"
#include "tests/support/file.h"

#include <doctest/doctest.h>

using namespace checker;

namespace {

Placement random_placement(const Problem& problem, Dice& dice) {
    Placement placement;
    const auto coordinates = [&](std::size_t count) {
        checker::Numbers numbers;
        for (std::size_t i = 0; i < count; ++i)
            numbers.push_back(dice.from_to(-999'999, 999'999));
        return numbers;
    };
    placement.scene = coordinates(scene_size(problem));
    for (int view = 1; view < std::popcount(problem.views); ++view)
        placement.cameras.push_back(
            coordinates(problem.cameras == &checker::projective_cameras ? 12 : 7));
    if (problem.cameras == &checker::projective_cameras)
        std::ranges::copy(checker::Numbers{0, 0, 0, 1}, placement.cameras[0].begin());
    return placement;
}

Indices random_subset(std::size_t size, Dice& dice) {
    Indices subset;
    const std::size_t kept = 1 + dice.below(4);
    for (std::size_t i = 0; i < size; ++i)
        if (dice.below(5) <= kept) subset.push_back(i);
    return subset;
}

Selection whole(const Problem& problem) {
    Selection all{.views = problem.views};
    for (std::size_t p = 0; p < problem.points.size(); ++p)
        all.points.push_back(p);
    for (std::size_t n = 0; n < problem.lines.size(); ++n)
        all.lines.push_back(n);
    return all;
}

/// A few points and lines of the part.
Selection random_generators(const Selection& part, Dice& dice) {
    Selection generators;
    for (const std::size_t p : part.points)
        if (dice.one_in(3)) generators.points.push_back(p);
    for (const std::size_t n : part.lines)
        if (dice.one_in(6)) generators.lines.push_back(n);
    return generators;
}

/// The views that move with this one about a centre: those that see the same points as views that
/// move, other than the centre and generators.
Views moving_with(const Problem& problem, const Selection& part, const Element& centre,
                  Views first) {
    const Views resting =
        centre.kind == Element::Centre::view ? Views{1} << centre.centre : Views{0};
    Views moving = first;
    for (Views before = 0; before != moving;) {
        before = moving;
        for (const std::size_t p : part.points) {
            const bool is_centre = centre.kind == Element::Centre::point && centre.centre == p;
            const Views seen = problem.points[p].seen_by & part.views;
            if ((seen & moving) != 0 && !is_centre && !contains(centre.moved.points, p))
                moving |= seen & ~resting;
        }
    }
    return moving;
}

/// Elements about one point or line, or the centre of one view, and perhaps one about another. All
/// have these generators, or each has others.
std::vector<Element> random_elements(const Problem& problem, const Selection& part,
                                     const Selection& generators, Dice& dice) {
    std::vector<Element> elements;
    const bool own = problem.cameras->all_matrices && dice.one_in(2);
    Views taken = 0;
    for (std::size_t tries = 1 + dice.below(2); tries > 0; --tries) {
        Element centre{.kind = static_cast<Element::Centre>(dice.below(3)), .moved = generators};
        const Indices views{0, 1, 2, 3, 4, 5};
        const Indices& among = centre.kind == Element::Centre::point  ? part.points
                               : centre.kind == Element::Centre::line ? part.lines
                                                                      : views;
        if (among.empty()) continue;
        centre.centre = among[dice.below(among.size())];
        for (Views view = 1; view <= part.views; view <<= 1) {
            const bool itself = centre.kind == Element::Centre::view &&
                                centre.centre < most_views && view >> centre.centre == 1;
            if ((part.views & ~taken & view) == 0 || itself || dice.one_in(3)) continue;
            if (own) centre.moved = random_generators(part, dice);
            centre.moved.views = moving_with(problem, part, centre, view);
            taken |= centre.moved.views;
            elements.push_back(centre);
        }
        taken = 0;
    }
    return elements;
}

Motion random_motion(const Problem& problem, const Selection& part, Dice& dice, Motion::Kind kind) {
    Motion motion{.kind = kind};
    Views moving = part.views & static_cast<Views>(dice.below(problem.views + 1));
    if (dice.one_in(2) || moving == 0) moving = part.views;
    if (problem.cameras->all_matrices) motion.moved = random_generators(part, dice);
    if (motion.kind == Motion::Kind::plane) motion.moved.views = moving;
    if (motion.kind == Motion::Kind::central)
        motion.elements = random_elements(problem, part, motion.moved, dice);
    return motion;
}

/// Of a random central motion of the whole problem; 0 if it keeps no images.
int central_parameters_of(const Problem& problem, Dice& dice) {
    const Selection part = whole(problem);
    const Motion motion = random_motion(problem, part, dice, Motion::Kind::central);
    try {
        return excess_of(problem, part, motion) - surplus(problem);
    } catch (const checker::Refused&) {
        return 0;
    }
}

checker::ProblemsFile replayed(const std::string& name) {
    const std::string bytes = read(CERTS_DIR "/" + name);
    const checker::ReplayedFile file = checker::replay(all_classes(), name, bytes);
    const auto* content = std::get_if<ProblemsFile>(&file.content);
    REQUIRE(content);
    CHECK(content->refusals.count == 0);
    return *content;
}

} // namespace

TEST_CASE(
    "dimensions are those of the images: a problem whose points and lines are free fills them") {
    Dice dice(1);
    for (int tries = 0; tries < 500; ++tries) {
        const Problem problem = random_problem(dice, false);
        const int expected =
            static_cast<int>(image_dimension(problem)) - static_cast<int>(scene_dimension(problem));
        CHECK(surplus(problem) == expected);
        CHECK(image_rank(problem, dice) <=
              std::min(image_dimension(problem), scene_dimension(problem)));
    }
}

TEST_CASE(
    "det J is 0 exactly where the ranks of FLINT say that a balanced problem is not minimal") {
    Dice dice(2);
    int minimal = 0, not_minimal = 0;
    while (minimal < 150 || not_minimal < 150) {
        const Problem problem = random_problem(dice, dice.one_in(3));
        if (surplus(problem) != 0) continue;
        const bool full = image_rank(problem, dice) == image_dimension(problem);
        const Placement placement = random_placement(problem, dice);
        CHECK((jacobian_determinant(problem, placement) != checker::Residue{}) == full);
        ++(full ? minimal : not_minimal);
    }
}

TEST_CASE("the excess of a part is the number of conditions on its images, by the rank of FLINT") {
    Dice dice(3);
    int proved = 0, by_motion = 0;
    while (proved < 150 || by_motion < 50) {
        const Problem problem = random_problem(dice, dice.one_in(2));
        Selection part{problem.views, random_subset(problem.points.size(), dice),
                       random_subset(problem.lines.size(), dice)};
        if (dice.one_in(3)) part.views &= static_cast<Views>(dice.below(problem.views + 1));
        if (std::popcount(part.views) < 2) continue;
        const std::array kinds{Motion::Kind::none, Motion::Kind::plane, Motion::Kind::central};
        const Motion motion = random_motion(problem, part, dice, kinds[dice.below(3)]);
        int excess = 0;
        try {
            excess = excess_of(problem, part, motion);
        } catch (const checker::Refused&) {
            continue;
        }
        if (excess < 1) continue;
        const auto conditions = static_cast<int>(image_dimension(problem)) -
                                static_cast<int>(image_rank(problem, dice));
        CHECK(conditions >= excess);
        ++proved;
        if (excess_of(problem, part, {}) < excess) ++by_motion;
    }
}

TEST_CASE("by FLINT, images stay in as many ways at least as a central motion has parameters") {
    Dice dice(5);
    int compared = 0, all_ways = 0;
    while (compared < 30) {
        const Problem problem = random_problem(dice, dice.one_in(2));
        if (surplus(problem) < 0) continue;
        int most = 0; // parameters of some motions
        for (int tries = 0; tries < 30; ++tries)
            most = std::max(most, central_parameters_of(problem, dice));
        if (most == 0) continue;
        const auto ways = static_cast<int>(scene_dimension(problem)) -
                          static_cast<int>(image_rank(problem, dice));
        CHECK(most <= ways);
        ++compared;
        if (most == ways) ++all_ways;
    }
    CHECK(all_ways >= 5);
}

TEST_CASE("by FLINT, elements that keep subspaces of their own make just as many conditions") {
    Dice dice(6);
    struct Sliding {
        Views views;
        Indices kept; // points
    };
    const auto conditions_are = [&](const std::string& notation, std::size_t centre,
                                    const std::vector<Sliding>& cameras) {
        CAPTURE(notation);
        const Problem problem = problem_of("projective: " + notation);
        Motion motion{.kind = Motion::Kind::central};
        for (const auto& [views, kept] : cameras)
            motion.elements.push_back({.centre = centre, .moved = {views, kept, {}}});
        const auto conditions = static_cast<int>(image_dimension(problem)) -
                                static_cast<int>(image_rank(problem, dice));
        CHECK(excess_of(problem, whole(problem), motion) == conditions);
    };
    // Cameras 1 and 4 keep planes that meet in the line of the first two points. A line costs one
    // condition in each of the two views, as each plane has a point of it, but may move itself.
    const std::string point = "P/P/P/P", rest = "P/P/P/- + -/P/P/P + Pabcd/Pabcd/Pabcd/Pabcd";
    const std::vector<Sliding> two{{1, {0, 1, 2}}, {8, {0, 1, 3}}};
    for (const char* line :
         {"", " + a/a/a/a", " + a/a/a/-", " + a/a/-/-", " + a/-/-/a", " + a/a/-/a", " + a/-/a/a"})
        conditions_are("2*" + point + " + " + rest + line, 4, two);
    for (const char* with_line : {"Pa/P/P/Pa", "Pa/Pa/P/Pa", "Pa/Pa/Pa/Pa"})
        conditions_are(with_line + (" + " + point + " + " + rest), 4, two);
    // All move, the third in one more way than the others: a motion of space takes the fewer.
    const std::string pins = "Pabcdefghij/Pabcdefghij/Pabcdefghij";
    for (const char* line : {"", " + a/a/a", " + a/a/-", " + -/a/a"}) {
        const std::string notation = "2*P/P/P + P/P/- + " + pins + line;
        conditions_are(notation, 3, {{1, {0, 1, 2}}, {2, {0, 1, 2}}, {4, {0, 1}}});
        conditions_are(notation, 3, {{2, {0, 1, 2}}, {4, {0, 1}}});
    }
    // Camera 1 keeps a line, camera 4 the plane of it and a point.
    conditions_are("-/-/P/-/P/- + -/P/-/-/-/P + -/a/a/P/a/Pa + L/PL/PL/PL/PL/PL + "
                   "2*PL/PL/L/L/PL/PL + PL/L/PL/PL/L/L + Pabc/Pabc/Pabc/Pabc/Pabc/Pabc",
                   7, {{1, {4, 5}}, {8, {2, 3, 6}}});
}

TEST_CASE("each verdict of the two archives is that of the ranks of FLINT") {
    Dice dice(4);
    for (const char* name : {"plmp.plc", "projective.plc"})
        for (const auto& [notation, problem, minimal] : replayed(name).verdicts) {
            CAPTURE(notation);
            CHECK((image_rank(problem, dice) == image_dimension(problem)) == minimal);
        }
}

TEST_CASE("label classes have the same verdict as problems in general") {
    Dice dice(5);
    int not_minimal = 0;
    for (int tries = 0; tries < 1500; ++tries) {
        const checker::Signature& signature =
            all_classes().representatives[dice.below(all_classes().representatives.size())];
        const std::string notation = checker::notation(signature);
        CAPTURE(notation);
        const Problem problem = problem_of(notation);
        CHECK(surplus(problem) == 0);
        const checker::Residue minor =
            jacobian_determinant(problem, random_placement(problem, dice));
        const bool minimal = checker::obstruction(signature).minimal();
        CHECK((minor != checker::Residue{}) == minimal);
        not_minimal += minimal ? 0 : 1;
    }
    CHECK(not_minimal > 5);
}
