// Two points that all views see, and a line (proofs/upper_bounds.md, section 11): the numbers of
// Theorem U17, what its proof says of one example, and the degrees by monodromy.
#include "checker/algebra/modular.h"
#include "checker/algebra/vector3.h"
#include "prover/degree/degree.h"
#include "tests/support/class_with_bound.h"

#include <doctest/doctest.h>
#include <flint/nmod_poly.h>

#include <array>
#include <complex>
#include <functional>
#include <random>
#include <vector>

using namespace plprove;

namespace {

/// A class on (P^1)^3 x B, by the h_v in it, as bits: on B a number, multiples of delta, delta' and
/// eta, and a number of points.
struct OnB {
    int one = 0;
    std::array<int, 3> divisor{};
    int points = 0;
};
using Class = std::array<OnB, 8>;

Class operator*(const Class& a, const Class& b) {
    constexpr int meet[3][3] = {{1, 2, 1}, {2, 1, 1}, {1, 1, 0}};
    Class product{};
    for (std::size_t n = 0; n < 8; ++n)
        for (std::size_t m = 0; m < 8; ++m) {
            if (n & m) continue; // h_v h_v = 0
            OnB& sum = product[n | m];
            sum.one += a[n].one * b[m].one;
            sum.points += a[n].one * b[m].points + a[n].points * b[m].one;
            for (std::size_t i = 0; i < 3; ++i) {
                sum.divisor[i] += a[n].one * b[m].divisor[i] + a[n].divisor[i] * b[m].one;
                for (std::size_t j = 0; j < 3; ++j)
                    sum.points += a[n].divisor[i] * b[m].divisor[j] * meet[i][j];
            }
        }
    return product;
}

/// The part of this degree.
Class part(const Class& all, int degree) {
    Class result{};
    for (std::size_t n = 0; n < 8; ++n) {
        const int rest = degree - std::popcount(n);
        if (rest == 0) result[n].one = all[n].one;
        if (rest == 1) result[n].divisor = all[n].divisor;
        if (rest == 2) result[n].points = all[n].points;
    }
    return result;
}

/// c(N - F) in the degree in which the planes of these views have a relation: N is trivial of this
/// rank, plus two line bundles of these divisors on B.
Class relation(const std::vector<unsigned>& views, int trivial,
               const std::array<std::array<int, 3>, 2>& divisors) {
    Class total{};
    total[0].one = 1;
    for (const auto& divisor : divisors) {
        Class factor{};
        factor[0] = {1, divisor, 0};
        total = total * factor;
    }
    for (const unsigned v : views) { // 1 / (1 - 2 h)
        Class factor{};
        factor[0].one = 1, factor[1U << v].one = 2;
        total = total * factor;
    }
    return part(total, trivial + 2 - static_cast<int>(views.size()) + 1);
}

constexpr std::array<std::array<int, 3>, 2> both{{{1, 0, 0}, {0, 1, 0}}}; // delta, delta'
constexpr std::array<std::array<int, 3>, 2> once{{{0, 0, 1}, {0, 0, 1}}}; // eta, twice

using checker::Residue;
constexpr Residue zero{}, unit{1};

/// A vector in the coordinates of alpha, beta and n; a line, by its products with these.
using Triple = checker::Vector3<Residue>;

/// A line in a view.
struct Seen {
    std::size_t view;
    Triple line;
};
using Condition = std::vector<Seen>;

/// Random images modulo q, and the forms that (7) has for them.
class Example {
public:
    explicit Example(std::uint64_t seed) : random_(seed) {
        for (std::size_t v = 0; v < 3; ++v)
            point_[v] = {number(), number(), zero}, factor_[v] = number();
    }

    Triple vector() { return {number(), number(), number()}; }
    Condition line() { return {{0, vector()}, {1, vector()}, {2, vector()}}; }
    /// A line through a point that is not on n = 0.
    Seen through(std::size_t view, const Triple& point) {
        const Residue a = number(), b = number();
        return {view, {a, b, -(a * point[0] + b * point[1]) * point[2].inverse()}};
    }
    Condition pin() { // orthogonal to x, which has no coordinate at n
        Condition planes = line();
        for (auto& [v, l] : planes)
            l[1] = -(l[0] * point_[v][0]) * point_[v][1].inverse();
        return planes;
    }

    /// Of two free lines and another condition: whether A_1 = A_2 = Q_2 = K = 0 has six simple
    /// solutions where Q_1, the b_v and the factors w are not 0.
    bool six_zeros(const Condition& first, const Condition& second, const Condition& third);

private:
    using Camera = std::array<Triple, 2>; // b_v; s_v

    Residue number() { return {random_() % checker::modulus}; }

    /// The coefficients of w in (7).
    std::array<Residue, 4> row(const Seen& plane, const Camera& camera) const {
        const auto& [v, l] = plane;
        const auto& [a, a1, a2] = l;
        const Residue b = camera[0][v], s = camera[1][v], nu = a * s + a2 * b;
        return {factor_[v] * (a * point_[v][0] + a1 * point_[v][1]), a, nu,
                nu * s + a2 * s * b - Residue{4} * a1 * b * b};
    }

    /// The factors w of a free line, from the first two equations.
    Triple factors(const Condition& planes) const {
        std::array<Triple, 2> m;
        for (std::size_t v = 0; v < 3; ++v)
            for (std::size_t i = 0; i < 2; ++i)
                m[i][v] = row(planes[v], {})[i];
        return checker::cross(m[0], m[1]);
    }

    /// A or Q of a free line: the left side of this equation of (7).
    Residue side(const Condition& planes, std::size_t equation, const Camera& camera) const {
        const Triple w = factors(planes);
        Residue sum;
        for (std::size_t v = 0; v < 3; ++v)
            sum = sum + w[v] * row(planes[v], camera)[equation];
        return sum;
    }

    /// The camera with these b_v and s_1 = 0 at which the A of both lines vanish.
    Camera camera(const Triple& b, const Condition& first, const Condition& second) const {
        const auto equation =
            [&](const Condition& planes) { // coefficients of s_2, s_3, and the rest
                return Triple{side(planes, 2, {Triple{}, Triple{zero, unit, zero}}),
                              side(planes, 2, {Triple{}, Triple{zero, zero, unit}}),
                              side(planes, 2, {b, Triple{}})};
            };
        const auto [s2, s3, scale] = checker::cross(equation(first), equation(second));
        return {b, Triple{zero, s2 * scale.inverse(), s3 * scale.inverse()}};
    }

    std::mt19937_64 random_;
    std::array<Triple, 3> point_{}; // x_v
    Triple factor_{};               // p_v
};

/// A polynomial modulo q, from its values at 0, 1, ..., of which there are enough.
class Polynomial {
public:
    explicit Polynomial(const std::function<Residue(Residue)>& value) {
        constexpr std::size_t count = 40;
        std::array<mp_limb_t, count> x, y;
        for (std::size_t n = 0; n < count; ++n)
            x[n] = n, y[n] = value({n}).value;
        nmod_poly_init(polynomial_, checker::modulus);
        nmod_poly_interpolate_nmod_vec(polynomial_, x.data(), y.data(), count);
    }
    Polynomial(const Polynomial&) = delete;
    Polynomial& operator=(const Polynomial&) = delete;
    ~Polynomial() { nmod_poly_clear(polynomial_); }

    slong degree() const { return nmod_poly_degree(polynomial_); }
    bool squarefree() const { return nmod_poly_is_squarefree(polynomial_) != 0; }
    bool coprime(const Polynomial& other) const {
        nmod_poly_t gcd;
        nmod_poly_init(gcd, checker::modulus);
        nmod_poly_gcd(gcd, polynomial_, other.polynomial_);
        const bool one = nmod_poly_degree(gcd) == 0;
        nmod_poly_clear(gcd);
        return one;
    }

private:
    nmod_poly_t polynomial_;
};

bool Example::six_zeros(const Condition& first, const Condition& second, const Condition& third) {
    using checker::minus, checker::times;
    const auto form = [&](const Condition& planes, const Triple& b) { // Q, where all A are 0
        return side(planes, 3, camera(b, first, second));
    };
    // A point of the conic Q_2 = 0: a square root of the discriminant, as q = 3 modulo 4.
    Triple start{zero, zero, unit};
    for (bool found = false; !found;) {
        start = {zero, start[1] + unit, unit};
        const Triple along{unit, zero, zero};
        const Residue c = form(second, start), a = form(second, along),
                      b = a + c - form(second, minus(start, along)),
                      discriminant = b * b - Residue{4} * a * c;
        Residue root = discriminant;
        for (int n = 0; n < 59; ++n)
            root = root * root; // the power 2^59 = (q + 1) / 4
        found = root * root == discriminant;
        start[0] = (root - b) * (a + a).inverse();
    }
    CHECK(form(second, start) == zero);
    for (const Condition& line : {first, second})
        CHECK(side(line, 2, camera(start, first, second)) == zero);
    // The other point of the conic on the line through it in this direction.
    const auto point = [&](Residue z) {
        const Triple direction{unit, z, zero};
        const Residue q = form(second, direction);
        const Residue mixed = q - form(second, minus(start, direction));
        return minus(times(q, start), times(mixed, direction));
    };
    const auto rows = [&](Residue z) {
        std::vector<std::vector<Residue>> all;
        const std::size_t skipped = third.size() == 3; // a pin has no first coordinate
        for (const Seen& plane : third) {
            const auto r = row(plane, camera(point(z), first, second));
            all.emplace_back(r.begin() + skipped, r.end());
        }
        return all;
    };
    const Polynomial determinants([&](Residue z) { return checker::determinant(rows(z)); });
    const Polynomial excluded([&](Residue z) {
        const Triple b = point(z);
        Residue product = form(first, b) * b[0] * b[1] * b[2];
        for (std::size_t plane = 0; plane < third.size(); ++plane) { // the factors w
            auto minor = rows(z);
            minor.erase(minor.begin() + static_cast<std::ptrdiff_t>(plane));
            for (auto& entries : minor)
                entries.pop_back();
            product = product * checker::determinant(std::move(minor));
        }
        for (const Condition& line : {first, second})
            for (const Residue w : factors(line))
                product = product * w;
        return product;
    });
    return determinants.degree() == 6 && determinants.squarefree() &&
           determinants.coprime(excluded);
}

} // namespace

TEST_CASE("two points: the bounds are intersection numbers less zeros that are no elements") {
    const Class line = relation({0, 1, 2}, 2, both), pin = relation({0, 1, 2}, 1, both);
    const Class by_two = relation({1, 1, 2, 2}, 2, once), by_one = relation({0, 0, 1, 2}, 2, both);
    const auto number = [&](const Class& third) { return (line * line * third)[7].points; };
    CHECK(number(pin) == 672);
    CHECK(number(by_two) == 704);
    CHECK(number(by_one) == 800);
    const auto degree = [](const Features& features, int bound) {
        return compute_degree(class_with_bound(features, bound), {}).degree;
    };
    constexpr int escaping = 8 * 12, centred = 8 * 6, coplanar = 8 * 4;
    const int with_pin = (672 - escaping - centred) / 2;
    const int with_two = (704 - escaping - 2 * centred) / 2;
    const int with_one = (800 - escaping - 2 * centred) / 2;
    const int with_pinned = (704 - escaping - 2 * centred - coplanar) / 2;
    CHECK(degree({{"Pa/Pa/Pa", 1}, {"P/P/P", 1}, {"a/a/a", 2}}, with_pin) == with_pin);
    CHECK(degree({{"P/P/P", 2}, {"a/a/a", 2}, {"-/P/P", 1}}, with_two) == with_two);
    CHECK(degree({{"P/P/P", 2}, {"a/a/a", 2}, {"P/a/a", 1}}, with_one) == with_one);
    CHECK(degree({{"P/P/P", 2}, {"a/Pa/Pa", 1}, {"a/a/a", 1}}, with_pinned) == with_pinned);
    class_with_bound({{"P/P/P", 2}, {"a/a/a", 2}, {"Pab/b/a", 1}}, with_one); // exchanged
}

TEST_CASE("two points: six simple zeros where two lines and another condition meet the boundary") {
    Example images(11);
    const Condition line = images.line(), other = images.line();
    const Triple y = images.vector(), z = images.vector();
    const Condition by_two{images.through(1, y), images.through(1, y), images.through(2, z),
                           images.through(2, z)};
    const Condition by_one{images.through(0, y), images.through(0, y), images.line()[1],
                           images.line()[2]};
    CHECK(images.six_zeros(line, other, images.pin()));
    CHECK(images.six_zeros(line, other, by_two));
    CHECK(images.six_zeros(line, other, by_one));
    // The point is on the second line.
    const Condition through{images.line()[0], images.through(1, y), images.through(2, z)};
    CHECK(images.six_zeros(line, through, by_two));
    // It notices where K = 0 is no condition: both planes of a view are the same.
    const Condition twice{by_two[0], by_two[0], by_two[2], by_two[3]};
    CHECK_FALSE(images.six_zeros(line, other, twice));
}

TEST_CASE("two points: frames of the plane that their images span") {
    using Complex = std::complex<double>;
    using Vector = checker::Vector3<Complex>;
    using checker::cross, checker::dot, checker::minus, checker::times;
    std::mt19937_64 random(5);
    std::normal_distribution<double> normal;
    const auto number = [&] { return Complex(normal(random), normal(random)); };
    const auto near = [](Complex a, double b) { return std::abs(a - b) < 1e-9; };
    for (int trial = 0; trial < 20; ++trial) {
        const Vector x{number(), number(), number()}, y{number(), number(), number()};
        const Complex root =
            std::sqrt(dot(x, y) * dot(x, y) - dot(x, x) * dot(y, y)); // of x + r y isotropic
        const Vector first = minus(x, times((dot(x, y) + root) / dot(y, y), y));
        const Vector second = minus(x, times((dot(x, y) - root) / dot(y, y), y));
        const Vector beta = times(0.5 / dot(first, second), second);
        const Vector n = times(Complex(0, 2), cross(first, beta));
        const Complex t = number();
        const Vector e = minus(times(t, first), times(-1.0 / t, beta));
        const Vector f = minus(times(t, first), times(1.0 / t, beta));
        const Vector plus = minus(f, times(Complex(-1), n)), less = minus(f, n);
        CHECK(near(dot(e, e), 1));
        for (const Vector& isotropic : {plus, less}) {
            CHECK(near(dot(isotropic, isotropic), 0));
            CHECK(near(dot(isotropic, e), 0));
        }
        CHECK(near(dot(plus, less), -2));
        CHECK(near(dot(e, cross(plus, less)) * Complex(0, 1), 2));
        const Vector l{number(), number(), number()};
        CHECK(near(dot(l, l) - dot(l, e) * dot(l, e) + dot(l, plus) * dot(l, less), 0)); // (6)
    }
}
