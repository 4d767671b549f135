// Theorem 16 of proofs/families.md: each item at its border, and all degrees that monodromy found.
#include "checker/family/degree_bound.h"

#include "checker/general_bounds/hilbert.h"
#include "checker/general_bounds/proved_degrees.h"
#include "checker/general_bounds/three_views.h"
#include "checker/problem/notation.h"
#include "tests/checker/general_bounds/degrees_on_file.h"

#include <array>
#include <doctest/doctest.h>

using namespace checker;

namespace {

using Bound = std::optional<std::size_t>;

Bound bound_of(const std::string& notation) {
    return degree_bound(parse_problem(notation));
}

using Vector = std::array<long, 3>;
using Matrix = std::array<Vector, 3>;

Vector minus(const Vector& a, const Vector& b) {
    return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}

Vector cross(const Vector& a, const Vector& b) {
    return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

long dot(const Vector& a, const Vector& b) {
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

/// A camera with known vertical.
struct UprightView {
    long cosine, sine, scale; ///< the first two in units of 1 / scale
    Vector shift;
    long focal = 2;

    Vector image(const Vector& point) const {
        return {focal * (cosine * point[0] + sine * point[2] + shift[0]),
                focal * (scale * point[1] + shift[1]),
                -sine * point[0] + cosine * point[2] + shift[2]};
    }
};

/// Of these columns of three rows.
template <std::size_t width>
long minor(const std::vector<std::array<long, width>>& rows,
           const std::array<std::size_t, 3>& columns) {
    std::array<Vector, 3> square{};
    for (std::size_t row = 0; row < 3; ++row)
        for (std::size_t column = 0; column < 3; ++column)
            square[row][column] = rows[row][columns[column]];
    return dot(square[0], cross(square[1], square[2]));
}

/// Of two cameras with this rotation from one to the other, up to a factor: with the inverses of
/// the focal lengths.
Matrix fundamental(const Matrix& rotation, long first, long second) {
    constexpr Vector t{4, -7, 3};
    const Vector left{second, second, 1}, right{first, first, 1};
    Matrix f{};
    for (std::size_t i = 0; i < 3; ++i)
        for (std::size_t j = 0; j < 3; ++j) {
            const std::size_t k = (i + 1) % 3, l = (i + 2) % 3;
            f[i][j] = left[i] * right[j] * (t[k] * rotation[l][j] - t[l] * rotation[k][j]);
        }
    return f;
}

long square(long x) {
    return x * x;
}

long square_of(const std::array<long, 2>& vector) {
    return square(vector[0]) + square(vector[1]);
}

} // namespace

TEST_CASE("two axes that share a point bound the degree by one, two that do not share one do not") {
    CHECK(bound_of("projective: PLM/PLM + 2*PL/PL + 2*PM/PM + 2*P/P") == 1U);
    CHECK(bound_of("projective: PLM/PLM/PLM + 2*PL/PL/PL + 2*PMab/PMab/PMab") == 1U);
    CHECK(bound_of("projective: 2*PL/PL/PL + PLa/PLa/PLa + 2*PM/PM/PM + PMa/PMa/PMa") != 1U);
}

TEST_CASE("without another line at the axis, the bound counts the lines that meet subspaces") {
    // Three planes through the axis or fewer: one line. In the last two, there is another axis.
    CHECK(bound_of("projective: 3*PL/PL/PL + 5*a/a/a") == 1U);
    CHECK(bound_of("projective: 2*PL/PL/PL/PL + PLa/PLa/PLa/PLa + 2*Pa/Pa/Pa/Pa") == 1U);
    CHECK(bound_of("projective: 3*PL/PL/PL + 3*PM/PM/PM + a/a/a") == 1U);
    CHECK(bound_of("projective: 3*PL/PL/PL + PM/PM/PM + 2*PMa/PMa/PMa") == 1U);
    // Lines in space that meet four lines: two.
    CHECK(bound_of("projective: 3*PL/PL + 4*P/P") == 2U);
    CHECK(bound_of("projective: 2*PLa/PLa/PLa + PLab/PLab/PLab + 3*a/a/a") == 2U);
    // In dimension 4, six planes; in dimension 6, ten subspaces of dimension 4.
    CHECK(bound_of("projective: 2*PL/PL/PL + PLabcdef/PLabcdef/PLabcdef + 2*a/a/a") == 5U);
    CHECK(bound_of("projective: PL/PL/PL + 2*PLabcde/PLabcde/PLabcde") == 42U);
    // In dimension 4, four planes and a line.
    CHECK(bound_of("projective: 2*PL/PL/PL + PLabcd/PLabcd/PLabcd + Pa/Pa/Pa + a/a/a") == 3U);
}

TEST_CASE(
    "the bound by an axis wants a balanced problem, and no other line of points at the axis") {
    CHECK(bound_of("projective: 3*PL/PL/PL + 6*a/a/a") == std::nullopt);
    CHECK(bound_of("projective: 3*PL/PL/PL + 4*P/P/P") == std::nullopt);
    CHECK(bound_of("projective: 3*PL/PL/PL + Pabcdef/Pabcdef/Pabcdef") == std::nullopt);
    CHECK(bound_of("projective: 2*PL/PL/PL + PLM/PLM/PLM + PM/PM/PM + P/P/P") == std::nullopt);
}

TEST_CASE("two uncalibrated views have at most three solutions") {
    CHECK(bound_of("projective: 7*P/P") == 3U);
    CHECK(bound_of("projective: 6*P/P/P") == std::nullopt);
}

TEST_CASE("two views with a focal length each have at most twice as many as uncalibrated ones") {
    CHECK(bound_of("focal: 7*P/P") == 6U);
    CHECK(bound_of("focal: 3*PL/PL + 4*P/P") == 4U);
    CHECK(bound_of("focal: 6*P/P + P/-") == std::nullopt);
    CHECK(bound_of("focal: 3*PL/PL/PL + 3*a/a/a") == std::nullopt);
    CHECK(bound_of("shared-focal-center: 7*P/P") == std::nullopt);
}

TEST_CASE("the axes say how many solutions two views with a common focal length or with known "
          "verticals have") {
    CHECK(bound_of("shared-focal: 6*P/P") == 30U);
    CHECK(bound_of("shared-focal: 3*PL/PL + 3*P/P") == 20U);
    CHECK(bound_of("shared-focal: PLM/PLM + 2*PL/PL + 2*PM/PM + P/P") == 10U);
    CHECK(bound_of("shared-focal: 3*PL/PL + 3*PM/PM") == 16U);
    CHECK(bound_of("shared-focal: 3*PL/PL + 3*PM/PM + 3*PN/PN") == std::nullopt);
    CHECK(bound_of("shared-focal: 4*P/P/P") == std::nullopt);
    CHECK(bound_of("upright-focal: 5*P/P") == 8U);
    CHECK(bound_of("upright-focal: 3*PL/PL + 2*P/P") == 6U);
    CHECK(bound_of("upright-focal: PLM/PLM + 2*PL/PL + 2*PM/PM") == 4U);
    CHECK(bound_of("upright-focal: 5*a/a/a") == std::nullopt);
}

TEST_CASE("the forms of items 10 and 11 vanish at matrices of two views with focal lengths") {
    // An angle with cosine 3/5, and focal lengths 1/2 and 1/3. The scale of F is free.
    {
        const Matrix f = fundamental({{{3, 0, 4}, {0, 5, 0}, {-4, 0, 3}}}, 2, 3);
        const long one = f[1][0] * f[1][2] * f[2][0], other = f[0][1] * f[0][2] * f[2][1];
        CHECK(f[1][1] == 0);
        CHECK(f[2][2] * (one - other) + square(f[0][2] * f[2][1]) - square(f[1][2] * f[2][0]) == 0);
        CHECK(one != other);
    }
    // The rotation of the quaternion (2, 1, 2, 2), and the focal length 1/2 in both views.
    {
        const Matrix f = fundamental({{{-3, -4, 12}, {12, 3, 4}, {-4, 12, 3}}}, 2, 2);
        const std::array<long, 2> b{f[0][2], f[1][2]}, c{f[2][0], f[2][1]};
        const std::array<long, 2> ub{f[0][0] * b[0] + f[1][0] * b[1],
                                     f[0][1] * b[0] + f[1][1] * b[1]};
        const std::array<long, 2> uc{f[0][0] * c[0] + f[0][1] * c[1],
                                     f[1][0] * c[0] + f[1][1] * c[1]};
        const long beta = b[0] * uc[0] + b[1] * uc[1];
        CHECK(f[2][2] * (square_of(ub) - square_of(uc)) == beta * (square_of(b) - square_of(c)));
        CHECK(beta * (square_of(b) - square_of(c)) != 0);
    }
}

TEST_CASE("known verticals leave few solutions in two views, and where three views see two lines") {
    CHECK(bound_of("upright: 3*P/P") == 4U);
    CHECK(bound_of("upright: P/P/P + 2*a/a/a") == 6U);
    CHECK(bound_of("upright: P/P/P + Pa/Pa/Pa") == 6U);
    CHECK(bound_of("upright: P/P/P/P + 2*a/a/a/a") == std::nullopt);
    CHECK(bound_of("upright: Pa/Pa/Pa") == std::nullopt);
    CHECK(bound_of("upright: P/-/P + a/a/a + Pa/Pa/Pa") == std::nullopt);
    CHECK(bound_of("upright-shared-focal: 4*P/P") == 5U);
    CHECK(bound_of("upright-shared-focal: 3*PL/PL + P/P") == 4U);
    CHECK(bound_of("upright-shared-focal: 2*Pa/Pa/Pa") == 14U);
    CHECK(bound_of("upright-shared-focal: Pa/Pa/Pa + 2*a/a/a") == 14U);
    CHECK(bound_of("upright-shared-focal: 3*PL/PL/PL") == 6U);
    CHECK(bound_of("upright-shared-focal: 2*P/P/P + a/a/a") == 11U);
    CHECK(bound_of("upright-shared-focal: P/P/P/P + Pa/Pa/Pa/Pa") == 26U);
    CHECK(bound_of("upright-shared-focal: 2*P/P/P") == std::nullopt);
    CHECK(bound_of("upright-shared-focal: P/P/P/P + a/a/a/a") == std::nullopt);
    CHECK(bound_of("upright-shared-focal: P/P/P/P/P + Pa/Pa/Pa/Pa/Pa") == std::nullopt);
}

TEST_CASE("the equations of items 12 and 13 hold for what upright views with focal length 2 see") {
    constexpr long x = 4; // the square of the focal length
    // Rotations by two angles and none, with what they multiply lengths by.
    constexpr std::array<UprightView, 3> views{
        {{1, 0, 1, {0, 0, 5}}, {3, 4, 5, {2, -1, 9}}, {5, -12, 13, {-3, 4, 7}}}};
    const Vector p{1, 2, 3}, q{-2, 1, 5}, one{3, -1, 4}, other{2, 2, -1};
    const Vector along = minus(q, p), through{4, along[1], -1}; // of the same height
    const long u = x * (square(along[0]) + square(along[2]));
    const long v = x * (square(through[0]) + square(through[2]));
    const long s = x * (along[0] * through[0] + along[2] * through[2]);
    const long z = 2 * (along[0] * through[2] - along[2] * through[0]);
    CHECK(square(s) + x * square(z) == u * v);
    std::vector<std::array<long, 4>> rows;
    for (const UprightView& view : views) {
        const Vector d = minus(view.image(q), view.image(p));
        const Vector l = cross(view.image(one), view.image(other));
        rows.push_back({dot(l, view.image(p)), dot(l, view.image(q)), l[1] * d[1],
                        l[2] * d[0] - x * l[0] * d[2]});
        const long scale = square(view.scale); // of u, v, s and z
        CHECK(square(d[0]) + x * square(d[2]) == scale * u);

        Vector n = cross(view.image(p), view.image(q));
        Vector k = cross(view.image(p), view.image({p[0] + 4, q[1], p[2] - 1}));
        n[1] *= d[1]; // item 13 has d[1] = 1
        k[1] *= d[1];
        const long a = n[0] * k[2] - n[2] * k[0], b = n[2] * k[2] + x * n[0] * k[0];
        CHECK(square(k[1]) * (square(n[2]) + x * square(n[0])) * u +
                  square(n[1]) * (square(k[2]) + x * square(k[0])) * v -
                  2 * n[1] * k[1] * (b * s + x * a * z) ==
              scale * square(a * s - b * z));
    }
    CHECK(minor(rows, {0, 1, 2}) == 0);
    CHECK(minor(rows, {0, 1, 3}) == 0);
    CHECK(minor(rows, {0, 2, 3}) == 0);
    CHECK(minor(rows, {1, 2, 3}) == 0);
}

TEST_CASE("the equations of Theorem J hold for three collinear points and a line in upright views "
          "with a focal length each, and its zero that is no solution is one") {
    constexpr std::array<UprightView, 3> views{
        {{1, 0, 1, {0, 0, 5}, 1}, {3, 4, 5, {2, -1, 9}, 2}, {5, -12, 13, {-3, 4, 7}, 3}}};
    const Vector p{1, 2, 3}, q{-2, 1, 5}, one{3, -1, 4}, other{2, 2, -1};
    const Vector along = minus(q, p);
    std::vector<std::array<long, 5>> rows;
    for (const UprightView& view : views) {
        const Vector d = minus(view.image(q), view.image(p));
        const Vector l = cross(view.image(one), view.image(other));
        CHECK(square(d[0]) + square(view.focal * d[2]) ==
              square(view.focal * view.scale) * (square(along[0]) + square(along[2])));
        rows.push_back({dot(l, view.image(p)), dot(l, view.image(q)), l[1] * d[1],
                        6 / view.focal * l[2] * d[0] - 6 * view.focal * l[0] * d[2],
                        l[0] * d[0] + l[2] * d[2]});
    }
    CHECK(minor(rows, {0, 1, 2}) == 0);
    CHECK(minor(rows, {0, 1, 3}) == 0);
    CHECK(minor(rows, {0, 1, 4}) == 0);
    CHECK(minor(rows, {0, 2, 3}) == 0);
}

TEST_CASE("the theorem is for projective cameras that all see everything") {
    CHECK(bound_of("5*P/P") == std::nullopt);
    CHECK(bound_of("PLM/PLM + 2*PL/PL + 2*PM/PM") == std::nullopt);
    CHECK(bound_of("projective: PLM/PLM/PLM + 2*PL/PL/PL + 2*PM/PM/PM + P/P/P") == 1U);
    CHECK(bound_of("projective: PLM/PLM/PLM + 2*PL/PL/PL + 2*PM/PM/PM + P/P/-") == std::nullopt);
}

TEST_CASE(
    "no degree that monodromy found is above its bound; the file says `by theorem` where a "
    "theorem bounds it and as many solutions are certified; and the bound is one wherever the "
    "degree is") {
    std::size_t ones = 0, certified = 0, all_certified = 0;
    for (const OnFile& row : family_degrees_on_file()) {
        CAPTURE(row.problem);
        const Bound bound = bound_of(row.problem);
        const std::size_t degree = std::stoul(row.degree);
        if (bound) CHECK(degree <= *bound);
        const auto problem = parse_problem(row.problem);
        const auto proved = proved_degree(problem);
        if (proved) CHECK(proved->at_most == degree);
        const bool by_theorem = bound == degree || degree_in_three_views(problem) == degree ||
                                degree_by_invariants(problem) == degree || proved;
        CHECK(row.source.starts_with("by theorem") == by_theorem);
        if (by_theorem) CHECK(row.certified == row.degree);
        all_certified += by_theorem;
        if (bound == degree) CHECK(row.status == "certified");
        CHECK((row.family == "projective" && degree == 1) == (bound == 1U));
        ones += bound == 1U;
        certified += bound == degree;
    }
    CHECK(ones == 75);
    CHECK(certified == 151);
    CHECK(all_certified == 329);
}
