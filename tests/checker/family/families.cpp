// The families of problems, counted by a second method: all ways to place lines on numbered points,
// and the orbits of their renamings by Burnside's lemma. And what a file of a family must have.
#include "checker/family/family.h"
#include "checker/family/rows.h"
#include "tests/checker/minimal/outcome.h"
#include "tests/support/file.h"

#include <algorithm>
#include <bit>
#include <map>
#include <numeric>

using namespace checker;

namespace {

/// A line with three points or more: the set of its points.
using Mask = unsigned;
using Lines = std::vector<Mask>; // ascending

/// Whether one can take points away one by one, each on one line with two others at most.
bool can_be_built(const Lines& lines, int points) {
    Mask left = (1U << points) - 1;
    for (bool goes_on = true; goes_on;) {
        goes_on = false;
        for (int p = 0; p < points; ++p) {
            const Mask point = 1U << p;
            const auto matters = [&](Mask line) {
                return (line & point) != 0 && std::popcount(line & left) >= 3;
            };
            if ((left & point) == 0 || std::ranges::count_if(lines, matters) > 1) continue;
            left &= ~point;
            goes_on = true;
        }
    }
    return left == 0;
}

/// All sets of lines on numbered points where two lines share at most one point.
void add_lines(std::vector<Lines>& all, Lines& lines, Mask next, int points) {
    if (can_be_built(lines, points)) all.push_back(lines);
    for (; next < 1U << points; ++next) {
        if (std::popcount(next) < 3) continue;
        const auto crosses = [&](Mask line) { return std::popcount(line & next) > 1; };
        if (std::ranges::any_of(lines, crosses)) continue;
        lines.push_back(next);
        add_lines(all, lines, next + 1, points);
        lines.pop_back();
    }
}

Mask renamed(Mask line, const std::vector<int>& names) {
    Mask result = 0;
    for (std::size_t p = 0; p < names.size(); ++p)
        if (line >> p & 1) result |= 1U << names[p];
    return result;
}

bool is_kept(const Lines& lines, const std::vector<int>& names) {
    return std::ranges::all_of(
        lines, [&](Mask line) { return std::ranges::binary_search(lines, renamed(line, names)); });
}

/// The lengths of the cycles of a renaming.
std::vector<int> cycles_of(const std::vector<int>& names) {
    std::vector<int> cycles;
    std::vector<bool> seen(names.size());
    for (std::size_t p = 0; p < names.size(); ++p) {
        int length = 0;
        for (std::size_t q = p; !seen[q]; q = static_cast<std::size_t>(names[q]), ++length)
            seen[q] = true;
        if (length > 0) cycles.push_back(length);
    }
    return cycles;
}

/// In how many ways a renaming keeps `pins` pins: equal numbers of them on the points of a cycle.
int pins_kept(const std::vector<int>& cycles, int pins) {
    std::vector<int> ways(static_cast<std::size_t>(pins) + 1);
    ways[0] = 1;
    for (const int length : cycles)
        for (std::size_t n = static_cast<std::size_t>(length); n < ways.size(); ++n)
            ways[n] += ways[n - static_cast<std::size_t>(length)];
    return ways.back();
}

/// How many points are on a line with two points before them.
int dependent_points(const Lines& lines) {
    int dependent = 0;
    for (const Mask line : lines)
        dependent += std::popcount(line) - 2;
    return dependent;
}

/// By the table of section 13: D = of_each m - motions.
struct Cameras {
    std::string family;
    int of_each = 0, motions = 0;

    int dimension(int m) const { return of_each * m - motions; }
};

const std::vector<Cameras> all_cameras{
    {"plmp", 6, 7},    {"projective", 11, 15},         {"shared-focal", 6, 6},
    {"focal", 7, 7},   {"shared-focal-center", 6, 4},  {"shared-k", 6, 2},
    {"upright", 4, 5}, {"upright-shared-focal", 4, 4}, {"upright-focal", 5, 5}};

/// By the formula of section 13: the dimension of the images less that of scenes and cameras.
int surplus_by_formula(const Cameras& cameras, int m, int p, int d, int f, int a) {
    return m * (2 * p - d + 2 * f + a) - (3 * p - 2 * d + 4 * f + 2 * a + cameras.dimension(m));
}

/// How many sets of lines the renamings of p points keep: by the number of dependent points, and by
/// the cycles of the renaming.
std::map<std::pair<int, std::vector<int>>, int> kept_lines(int p) {
    std::vector<Lines> all;
    Lines none;
    add_lines(all, none, 0, p);
    std::vector<int> names(static_cast<std::size_t>(p));
    std::iota(names.begin(), names.end(), 0);
    std::map<std::pair<int, std::vector<int>>, int> kept;
    do {
        std::vector<int> cycles = cycles_of(names);
        std::ranges::sort(cycles);
        for (const Lines& lines : all)
            if (is_kept(lines, names)) ++kept[{dependent_points(lines), cycles}];
    } while (std::ranges::next_permutation(names).found);
    return kept;
}

int factorial(int p) {
    return p == 0 ? 1 : p * factorial(p - 1);
}

/// The classes of a family with p points in m views, by Burnside's lemma.
int orbits(const Cameras& cameras, int m, int p,
           const std::map<std::pair<int, std::vector<int>>, int>& kept_lines) {
    if (m == 2 && cameras.dimension(2) > 7) return 0;
    const int most = m == 2 ? 0 : 40; // free lines, pins
    int kept = 0;
    for (const auto& [key, sets] : kept_lines)
        for (int f = 0; f <= most; ++f)
            for (int a = 0; a <= (p > 0 ? most : 0); ++a)
                if (surplus_by_formula(cameras, m, p, key.first, f, a) == 0)
                    kept += sets * pins_kept(key.second, a);
    CHECK(kept % factorial(p) == 0);
    return kept / factorial(p);
}

/// By views and points, how many classes the checker has.
std::map<std::pair<int, int>, int> sizes(const std::string& name) {
    std::map<std::pair<int, int>, int> result;
    family(*cameras_of_family(name)).for_each([&](const Problem& problem, auto) {
        ++result[{std::popcount(problem.views), static_cast<int>(problem.points.size())}];
    });
    return result;
}

std::string archive(const char* name) {
    return read(std::string(CERTS_DIR "/") + name);
}

/// The archive without its first line.
std::string rest_of(const char* name) {
    const std::string bytes = archive(name);
    return bytes.substr(bytes.find('\n') + 1);
}

} // namespace

TEST_CASE("the families have one problem for each orbit, with up to six points") {
    for (int p = 0; p <= 6; ++p) {
        const auto kept = kept_lines(p);
        for (const Cameras& cameras : all_cameras) {
            const auto found = sizes(cameras.family);
            for (int m = 2; m <= 12; ++m) {
                CAPTURE(m);
                CAPTURE(p);
                const auto place = found.find({m, p});
                const int size = place == found.end() ? 0 : place->second;
                CHECK(size == orbits(cameras, m, p, kept));
            }
        }
    }
}

TEST_CASE("the families have the bounds that section 13 states, and no problem twice") {
    for (const auto& [name, most_views, most_points] :
         {std::tuple{"plmp", 6, 5}, {"projective", 9, 8}, {"focal", 9, 7}, {"shared-k", 11, 7}}) {
        int views = 0, points = 0;
        for (const auto& [place, size] : sizes(name)) {
            views = std::max(views, place.first);
            points = std::max(points, place.second);
        }
        CHECK(views == most_views);
        CHECK(points == most_points);
        std::vector<Problem> before;
        family(*cameras_of_family(name)).for_each([&](const Problem& problem, auto) {
            std::size_t steps = 1'000'000;
            for (const Problem& other : before)
                if (invariant(problem) == invariant(other))
                    CHECK(isomorphic(problem, other, steps) == false);
            CHECK(isomorphic(problem, problem, steps) == true);
            before.push_back(problem);
        });
    }
}

TEST_CASE("the archives decide all problems of their families") {
    for (const char* name : {"plmp.plc", "projective.plc"})
        CHECK(outcome_of_problems(rest_of(name)) == "holds");
}

TEST_CASE("a problem of the family without a record is missed, and its numbers are not stated") {
    const std::string rest = rest_of("plmp.plc");
    const std::size_t last = rest.rfind("problem ");
    CHECK(
        contains(outcome_of_problems(rest.substr(0, last)), "the family plmp has 1 more problem"));
    const std::string bytes = "plcert 2 problems\n" + rest.substr(0, last);
    const checker::ReplayedFile file = checker::replay(all_classes(), "file", bytes);
    const auto& content = std::get<ProblemsFile>(file.content);
    CHECK(content.verdicts.size() == 38);
    CHECK(content.missing == 1);
    CHECK(rows_of(content).empty());
}

TEST_CASE("a file without a family states no numbers") {
    const std::string rest = rest_of("plmp.plc");
    const std::string bytes = "plcert 2 problems\n" + rest.substr(rest.find("modulus"));
    const checker::ReplayedFile file = checker::replay(all_classes(), "file", bytes);
    CHECK(std::get<ProblemsFile>(file.content).refusals.count == 0);
    CHECK(rows_of(std::get<ProblemsFile>(file.content)).empty());
}

TEST_CASE("a family has each problem once, however it is written, and no others") {
    const std::string twice = "problem PL/PL + PM/PM + PLM/PLM + PL/PL + PM/PM\n";
    CHECK(contains(outcome_of_problems(rest_of("plmp.plc") + twice + "unbalanced\n"),
                   "a record before decides it"));
    for (const char* other : {"projective: 7*P/P", "4*P/P", "5*P/P + a/a", "4*P/P + Pa/Pa",
                              "P/P/- + 3*P/P/P + a/a/a", "3*P/P + 2*PL/PL", "5*P/P/P"}) {
        CAPTURE(other);
        const std::string record = std::string("problem ") + other + "\nunbalanced\n";
        CHECK(contains(outcome_of_problems(rest_of("plmp.plc") + record),
                       "it is not in the family plmp"));
    }
}

TEST_CASE("a record that does not hold leaves its place to another") {
    const std::string rest = rest_of("plmp.plc");
    const std::string wrong = "problem 5*P/P\nunbalanced\nproblem 5*P/P\nminimal";
    const std::string bytes =
        "plcert 2 problems\n" + with(rest, "problem 5*P/P\nminimal", wrong.c_str());
    const checker::ReplayedFile file = checker::replay(all_classes(), "file", bytes);
    const auto& content = std::get<ProblemsFile>(file.content);
    CHECK(content.refusals.count == 1);
    CHECK(content.missing == 0);
}
