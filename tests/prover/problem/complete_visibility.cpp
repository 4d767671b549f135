// The families of completely visible problems: complete, and counted a second way.
#include "prover/minimal/problem_record.h"
#include "prover/problem/notation.h"
#include "prover/problem/skeleton.h"
#include "tests/prover/minimal/second_jacobian.h"

#include <algorithm>
#include <bit>
#include <doctest/doctest.h>
#include <fstream>
#include <functional>
#include <map>
#include <numeric>
#include <set>
#include <sstream>

using namespace plprove;

namespace {

using Lines = std::vector<unsigned>; // sets of points

/// Whether removing points, each on at most one line of three remaining points or more, leaves
/// nothing.
bool is_constructible(const Lines& lines, int points) {
    unsigned left = (1U << points) - 1;
    for (bool changed = true; changed && left != 0;) {
        changed = false;
        for (int point = 0; point < points; ++point) {
            if ((left >> point & 1U) == 0) continue;
            const auto carriers = std::ranges::count_if(lines, [&](unsigned line) {
                return (line >> point & 1U) != 0 && std::popcount(line & left) >= 3;
            });
            if (carriers > 1) continue;
            left &= ~(1U << point);
            changed = true;
        }
    }
    return left == 0;
}

Lines smallest_renaming(const Lines& lines, int points) {
    std::vector<int> order(static_cast<std::size_t>(points));
    std::iota(order.begin(), order.end(), 0);
    std::optional<Lines> best;
    do {
        Lines renamed;
        for (const unsigned line : lines) {
            unsigned image = 0;
            for (int point = 0; point < points; ++point)
                if ((line >> point & 1U) != 0)
                    image |= 1U << order[static_cast<std::size_t>(point)];
            renamed.push_back(image);
        }
        std::ranges::sort(renamed);
        if (!best || renamed < *best) best = renamed;
    } while (std::ranges::next_permutation(order).found);
    return *best;
}

/// All sets of lines of three points or more where any two lines share at most one point, up to
/// renaming: the linear spaces.
std::set<Lines> linear_spaces(int points) {
    std::set<Lines> found;
    Lines lines;
    const std::function<void(unsigned)> extend = [&](unsigned next) {
        found.insert(smallest_renaming(lines, points));
        for (unsigned line = next; line < 1U << points; ++line) {
            const bool fits =
                std::popcount(line) >= 3 && std::ranges::all_of(lines, [&](unsigned l) {
                    return std::popcount(l & line) <= 1;
                });
            if (!fits) continue;
            lines.push_back(line);
            extend(line + 1);
            lines.pop_back();
        }
    };
    extend(0);
    return found;
}

std::string committed(const std::string& name) {
    std::ifstream in(std::string(CERTS_DIR "/") + name, std::ios::binary);
    std::ostringstream text;
    text << in.rdbuf();
    return text.str();
}

std::vector<ProblemRecord> certificates_of(const CameraModel& family) {
    std::vector<ProblemRecord> certificates;
    for (const Problem& problem : family_problems(family))
        certificates.push_back(certify(problem));
    return certificates;
}

} // namespace

TEST_SUITE_BEGIN("problems in general: families");

TEST_CASE("skeletons are the linear spaces that can be constructed, up to isomorphism") {
    const std::vector<std::vector<Skeleton>> all = skeletons(6);
    const std::size_t spaces[] = {1, 1, 1, 2, 3, 5, 10}; // OEIS A001200
    for (int points = 0; points <= 6; ++points) {
        const std::set<Lines> found = linear_spaces(points);
        CHECK(found.size() == spaces[points]);
        const auto constructible = std::ranges::count_if(
            found, [&](const Lines& lines) { return is_constructible(lines, points); });
        CHECK(std::ssize(all[static_cast<std::size_t>(points)]) == constructible);
    }
}

TEST_CASE("Burnside's lemma counts the ways to distribute pins") {
    // Three collinear points and one more, two pins: the symmetries permute the three points.
    const Skeleton skeleton{{0, 0, 0, 0}, {{0, 1, 2}}};
    // Orbits: pins (2 0 0 | 0), (1 1 0 | 0), (1 0 0 | 1), (0 0 0 | 2).
    CHECK(with_pins(skeleton, 2).size() == 4);
    // Without lines: the partitions of 6 into at most 4 parts.
    CHECK(with_pins({{0, 0, 0, 0}, {}}, 6).size() == 9);
}

TEST_CASE("no problem is balanced beyond the bounds: equations of proofs/families.md") {
    for (int views = 3; views <= 40; ++views)
        for (int points = 0; points <= 12; ++points)
            for (int s = 0; s <= 60; ++s) {
                // s = p + f_p + 2 f + a with f_p free points, f_p >= min(2, p).
                if (s < points + std::min(points, 2)) continue;
                if (points == 0 && s % 2 != 0) continue;
                if ((s - 6) * (views - 2) == 5 - points) {
                    CHECK(views <= 6);
                    CHECK(points <= 4);
                }
                if ((s - 11) * (views - 2) == 7 - points) {
                    CHECK((points == 7 || views <= 9));
                    CHECK(points <= 8);
                    CHECK((points < 8 || views == 3));
                }
            }
}

TEST_CASE("the families are balanced, completely visible, and no two problems are isomorphic") {
    for (const CameraModel* family : camera_models()) {
        std::set<std::string> texts;
        for (const Problem& problem : family_problems(*family)) {
            CAPTURE(notation(problem));
            CHECK(is_balanced(problem));
            CHECK(texts.insert(notation(problem)).second);
            for (const Line& line : problem.lines) {
                CHECK(line.seen == all_views(problem.views));
                CHECK(line.points.size() != 2);
            }
        }
    }
}

TEST_CASE("every verdict of two families agrees with a rank, written a second way") {
    // tests/families/ranks.py does the same for cameras known in part.
    for (const CameraModel* family : {&calibrated_cameras, &projective_cameras})
        for (const ProblemRecord& certificate : certificates_of(*family)) {
            CAPTURE(notation(certificate.problem));
            const int corank = dimension_in_views(certificate.problem) -
                               SecondJacobian(certificate.problem, 5).rank();
            CHECK(is_minimal(certificate) == (corank == 0));
            if (const auto* part = std::get_if<OverconstrainedPart>(&certificate.claim))
                CHECK(part->excess <= corank);
        }
}

TEST_CASE("minimal problems: the papers' numbers, 30 and 291") {
    std::map<int, int> plmp;
    for (const ProblemRecord& certificate : certificates_of(calibrated_cameras))
        plmp[certificate.problem.views] += is_minimal(certificate) ? 1 : 0;
    CHECK(plmp == std::map<int, int>{{2, 3}, {3, 17}, {4, 6}, {5, 3}, {6, 1}});
    int counted = 0, in_three_views = 0;
    for (const ProblemRecord& certificate : certificates_of(projective_cameras)) {
        if (!is_minimal(certificate)) continue;
        const bool seven_in_three =
            certificate.problem.points.size() >= 7 && certificate.problem.views == 3;
        ++(seven_in_three ? in_three_views : counted);
    }
    CHECK(counted == 291);
    CHECK(in_three_views == 2);
}

/// The same points and lines in `views` views that see everything.
Problem in_views(Problem problem, int views) {
    problem.views = views;
    std::ranges::fill(problem.points, all_views(views));
    for (Line& line : problem.lines)
        line.seen = all_views(views);
    return problem;
}

TEST_CASE("seven points: the verdict of three views holds for any number of views") {
    int problems = 0;
    for (const ProblemRecord& certificate : certificates_of(projective_cameras)) {
        if (certificate.problem.points.size() != 7 || certificate.problem.views != 3) continue;
        ++problems;
        CAPTURE(notation(certificate.problem));
        for (int views = 4; views <= most_views; ++views) {
            const Problem more = in_views(certificate.problem, views);
            CHECK(is_balanced(more));
            CHECK(is_minimal(certify(more)) == is_minimal(certificate));
        }
        // What proofs/families.md, Theorem 11, uses of the archive.
        const auto* reason = std::get_if<OverconstrainedPart>(&certificate.claim);
        if (reason == nullptr) continue;
        CHECK(reason->part.points == whole(certificate.problem).points);
        CHECK(reason->part.lines == whole(certificate.problem).lines);
        CHECK(moving_views(reason->motion) == all_views(3));
        const bool plane = reason->motion.kind == MotionKind::plane;
        CHECK(reason->excess >= (plane ? 3 * 3 - 4 - 1 : 2));
    }
    CHECK(problems == 26);
}

TEST_CASE("not minimal, without four points on a line or six in a plane: the paper's 149") {
    int not_minimal = 0, counted = 0;
    for (const ProblemRecord& certificate : certificates_of(projective_cameras)) {
        const Problem& problem = certificate.problem;
        if (is_minimal(certificate) || problem.points.size() >= 7) continue;
        ++not_minimal;
        const bool four = std::ranges::any_of(
            problem.lines, [](const Line& line) { return line.points.size() >= 4; });
        // Points in general position on the lines of a plane: three lines, each of three points,
        // and six points, without four on a line.
        const auto lines_of_three = std::ranges::count_if(
            problem.lines, [](const Line& line) { return line.points.size() == 3; });
        const bool plane = problem.points.size() == 6 && lines_of_three == 3;
        counted += four || plane ? 0 : 1;
    }
    CHECK(not_minimal == 330);
    CHECK(counted == 149);
}

TEST_CASE("the committed archives are what the prover writes") {
    CHECK(write(certificates_of(calibrated_cameras), calibrated_cameras) == committed("plmp.plc"));
    CHECK(write(certificates_of(projective_cameras), projective_cameras) ==
          committed("projective.plc"));
}

TEST_SUITE_END();
