// Problems in general, by a second method: minors, verdicts and reasons against ranks that FLINT
// computes of another Jacobian; and the label classes of three calibrated views.
#include "checker/minimal/block.h"
#include "checker/reasons/part.h"
#include "checker/replay.h"
#include "tests/checker/minimal/image_rank.h"
#include "tests/support/all_classes.h"

#include <doctest/doctest.h>
#include <fstream>
#include <iterator>

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

Motion random_motion(const Problem& problem, const Selection& part, Dice& dice) {
    Motion motion;
    motion.kind =
        std::array{Motion::Kind::none, Motion::Kind::plane, Motion::Kind::star}[dice.below(3)];
    if (!part.points.empty()) motion.centre = part.points[dice.below(part.points.size())];
    motion.moved.views = part.views & static_cast<Views>(dice.below(problem.views + 1));
    if (dice.one_in(2)) motion.moved.views = part.views;
    if (motion.moved.views == 0) motion.moved.views = part.views;
    if (problem.cameras != &checker::projective_cameras) return motion;
    for (const std::size_t p : part.points)
        if (dice.one_in(3)) motion.moved.points.push_back(p);
    for (const std::size_t n : part.lines)
        if (dice.one_in(6)) motion.moved.lines.push_back(n);
    return motion;
}

checker::ProblemsFile replayed(const std::string& name) {
    std::ifstream stream(std::string(CERTS_DIR) + '/' + name, std::ios::binary);
    const std::string bytes{std::istreambuf_iterator<char>(stream), {}};
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
        const Motion motion = random_motion(problem, part, dice);
        if (motion.kind == Motion::Kind::star && part.points.empty()) continue;
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
