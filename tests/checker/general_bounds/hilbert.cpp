// Theorem T of proofs/moduli.md: all degrees that monodromy found, and all problems of the theorem,
// by a second method.
#include "checker/general_bounds/hilbert.h"

#include "checker/conclusion/in_general.h"
#include "checker/general_bounds/stability.h"
#include "checker/problem/notation.h"
#include "tests/checker/general_bounds/degrees_on_file.h"
#include "tests/checker/problem/visible_problem.h"

#include <algorithm>
#include <array>
#include <doctest/doctest.h>
#include <functional>
#include <map>
#include <numeric>

using namespace checker;

namespace {

using Degree = std::optional<std::size_t>;
using Pins = std::vector<std::size_t>; // of each point
using Row = std::vector<int>;

Degree degree_of(const std::string& notation) {
    return degree_by_invariants(parse_problem(notation));
}

/// A problem of the theorem.
struct Case {
    unsigned views = 0;
    Pins points{};
    std::size_t free_lines = 0;
    Problem problem{};
};

/// All of them: the ways to have twelve equations in a view. They have nine views less their
/// points.
void add_cases(std::size_t equations, Pins& points, std::vector<Case>& cases) {
    const unsigned views = 9 - static_cast<unsigned>(points.size());
    if (equations % 2 == 0)
        cases.push_back(
            {views, points, equations / 2, visible_problem(views, points, equations / 2)});
    for (std::size_t pins = 0; pins + 2 <= equations; ++pins) {
        if (!points.empty() && pins > points.back()) break;
        points.push_back(pins);
        add_cases(equations - 2 - pins, points, cases);
        points.pop_back();
    }
}

std::vector<Case> all_cases() {
    std::vector<Case> cases;
    Pins points;
    add_cases(12, points, cases);
    return cases;
}

/// All rows that interlace: a[0] >= b[0] >= a[1] >= ... .
void for_each_interlacing(const Row& a, const std::function<void(const Row&)>& use, Row b = {}) {
    if (b.size() + 1 >= a.size()) return use(b);
    b.push_back(0);
    for (b.back() = a[b.size()]; b.back() <= a[b.size() - 1]; ++b.back())
        for_each_interlacing(a, use, b);
}

/// The character of the representation of GL_r with this highest weight, of r entries: it counts
/// the patterns of Gelfand and Tsetlin, by weights.
std::map<Row, long> character(const Row& highest) {
    if (highest.size() == 1) return {{highest, 1}};
    std::map<Row, long> result;
    for_each_interlacing(highest, [&](const Row& next) {
        for (const auto& [weight, count] : character(next)) {
            Row longer = weight;
            longer.push_back(std::accumulate(highest.begin(), highest.end(), 0) -
                             std::accumulate(next.begin(), next.end(), 0));
            result[longer] += count;
        }
    });
    return result;
}

/// How often the representation of GL_k with this highest weight, of three entries, has the weight
/// (n, ..., n): a Kostka number.
long kostka(const Row& highest, std::size_t k, int n) {
    const int boxes = std::accumulate(highest.begin(), highest.end(), 0);
    if (k == 0) return boxes == 0 ? 1 : 0;
    long count = 0;
    Row padded = highest;
    padded.push_back(0);
    for_each_interlacing(padded, [&](const Row& next) {
        const int left = std::accumulate(next.begin(), next.end(), 0);
        if (boxes - left == n) count += kostka(next, k - 1, n);
    });
    return count;
}

using Polynomial = std::map<Row, mpz_class>;

Polynomial point_character(std::size_t pins, int n) {
    Polynomial sum;
    const int boxes = static_cast<int>(pins) * n;
    for (int a = 0; a <= 2 * n; ++a)
        for (int b = 0; b <= a; ++b) {
            const int c = boxes - a - b;
            if (c < 0 || c > b) continue;
            const long multiplicity = kostka({a, b, c}, pins, n);
            if (multiplicity == 0) continue;
            for (const auto& [weight, count] : character({2 * n, a, b, c}))
                sum[weight] += multiplicity * count;
        }
    return sum;
}

Polynomial line_character(int n) {
    Polynomial sum;
    for (const auto& [weight, count] : character({n, n, 0, 0}))
        sum[weight] = count;
    return sum;
}

Polynomial product(const Polynomial& a, const Polynomial& b) {
    Polynomial result;
    for (const auto& [x, c] : a)
        for (const auto& [y, d] : b)
            result[{x[0] + y[0], x[1] + y[1], x[2] + y[2], x[3] + y[3]}] += c * d;
    return result;
}

/// How often a character has det^power: the sum of its coefficients at the weights
/// power + rho - w rho, with the signs of w.
mpz_class times_det(const Polynomial& character, int power) {
    std::array<int, 4> image{0, 1, 2, 3};
    mpz_class sum;
    do {
        Row weight;
        int sign = 1;
        for (int i = 0; i < 4; ++i) {
            weight.push_back(power + image[static_cast<std::size_t>(i)] - i);
            for (int j = 0; j < i; ++j)
                if (image[static_cast<std::size_t>(j)] > image[static_cast<std::size_t>(i)])
                    sign = -sign;
        }
        const auto found = character.find(weight);
        if (found != character.end()) sum += sign * found->second;
    } while (std::next_permutation(image.begin(), image.end()));
    return sum;
}

mpz_class invariants_by_weights(const Case& c, int n) {
    Polynomial all{{{0, 0, 0, 0}, 1}};
    for (const std::size_t pins : c.points)
        all = product(all, point_character(pins, n));
    for (std::size_t line = 0; line < c.free_lines; ++line)
        all = product(all, line_character(n));
    return times_det(all, 3 * n);
}

/// The difference of this order, from the first value on.
mpz_class difference(std::vector<mpz_class> values, std::size_t order) {
    for (; order > 0; --order)
        for (std::size_t i = 0; i + 1 < values.size(); ++i)
            values[i] = values[i + 1] - values[i];
    return values[0];
}

} // namespace

TEST_CASE("all degrees on file to which the theorem applies are those that it gives") {
    std::size_t applies = 0;
    for (const OnFile& row : family_degrees_on_file()) {
        CAPTURE(row.problem);
        const Degree degree = degree_of(row.problem);
        if (!degree) continue;
        ++applies;
        CHECK(*degree == std::stoul(row.degree));
    }
    CHECK(applies == 27);
}

TEST_CASE("known degrees") {
    CHECK(degree_of("projective: 6*a/a/a/a/a/a/a/a/a") == 114U);
    CHECK(degree_of("projective: 5*P/P/P/P + a/a/a/a") == 2U);
    CHECK(degree_of("projective: 6*P/P/P") == 3U);
    CHECK(degree_of("projective: 3*Pab/Pab/Pab/Pab/Pab/Pab") == 12U);
}

TEST_CASE("six lines in space have sixteen invariants of degree one in each: fifteen products of "
          "three pairings, and a determinant") {
    CHECK(invariants(visible_problem(9, {}, 6), 0) == 1);
    CHECK(invariants(visible_problem(9, {}, 6), 1) == 16);
    CHECK(invariants(visible_problem(9, {}, 6), 9) == 802450);
}

TEST_CASE("in all problems of the theorem, the number of invariants is that of characters") {
    const std::vector<Case> cases = all_cases();
    CHECK(cases.size() == 48);
    for (const Case& c : cases) {
        CAPTURE(c.views);
        CAPTURE(c.free_lines);
        for (int n = 0; n <= 2; ++n)
            CHECK(invariants(c.problem, n) == invariants_by_weights(c, n));
    }
}

TEST_CASE("in all problems of the theorem, the invariants are counted by a polynomial of degree at "
          "most the number of views, or there are none; the degree is that number where general "
          "arrangements are stable, and these are the minimal problems") {
    std::size_t none = 0, stable = 0;
    for (const Case& c : all_cases()) {
        CAPTURE(c.views);
        CAPTURE(c.free_lines);
        std::vector<mpz_class> values;
        for (int n = 0; n <= static_cast<int>(c.views) + 2; ++n)
            values.push_back(invariants(c.problem, n).value());
        const Degree degree = degree_by_invariants(c.problem);
        stable += degree.has_value();
        if (values[1] == 0) {
            ++none;
            CHECK(std::ranges::count(values, 0) == c.views + 2);
        } else {
            CHECK(difference(values, c.views) == degree.value_or(0));
            CHECK(difference(values, c.views + 1) == 0);
            CHECK(difference(values, c.views + 2) == 0);
        }
    }
    CHECK(none == 9);
    CHECK(stable == 27); // those on file
}

TEST_CASE("where a point has more than four pins, Lemma T4 says nothing") {
    for (std::size_t pins = 0; pins <= 10; ++pins) {
        CAPTURE(pins);
        CHECK(general_arrangements_are_stable(visible_problem(8, {pins}, 0)) == (pins <= 4));
        if (pins > 4) // also where the theorem's equations are right in number
            CHECK(degree_by_invariants(visible_problem(8, {pins}, (10 - pins) / 2)) ==
                  std::nullopt);
    }
}

TEST_CASE("the theorem says nothing of other problems") {
    for (const std::string notation : {
             "5*P/P + a/a",                           // calibrated
             "projective: 5*P/P/P/P/P + P/P/P/P/-",   // not all views see all
             "projective: 3*PL/PL/PL/PL + 4*a/a/a/a", // a line with three points
             "projective: 6*a/a/a/a/a/a/a/a",         // not balanced
             "projective: 9*a/a/a",                   // eighteen equations in a view
             "projective: 7*P/P",                     // fourteen
         }) {
        CAPTURE(notation);
        const Problem problem = parse_problem(notation);
        CHECK(invariants(problem, 1) == std::nullopt);
        CHECK(degree_by_invariants(problem) == std::nullopt);
    }
}

TEST_CASE(
    "a line with two points is not two pins, though a problem with two such lines, in one view, "
    "is balanced and has the same number of equations") {
    Problem problem = visible_problem(1, {1, 1, 1, 1}, 0);
    CHECK(invariants(visible_problem(5, {1, 1, 1, 1}, 0), 1) == 8);
    problem.lines.resize(2);
    problem.lines[0].points = {0, 1};
    problem.lines[1].points = {2, 3};
    problem.points[1].lines = {0};
    problem.points[2].lines = problem.points[3].lines = {1};
    REQUIRE(surplus(problem) == 0);
    CHECK(invariants(problem, 1) == std::nullopt);
    CHECK(degree_by_invariants(problem) == std::nullopt);
}
