// The integral of proofs/calibrated_six_views.md, section 8, modulo a prime.
#include "tests/theorems/number_modulo_prime.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <doctest/doctest.h>
#include <functional>
#include <map>
#include <string>
#include <utility>
#include <vector>

namespace {

using theorems::Number;

/// A class on a component of the fixed points, a point or a line: a + b k with k^2 = 0.
struct Class {
    Number a, b;
    Class(std::int64_t n) : a(n) {}
    Class(Number first, Number second = {}) : a(first), b(second) {}
    friend Class operator+(Class x, Class y) { return {x.a + y.a, x.b + y.b}; }
    friend Class operator-(Class x, Class y) { return {x.a - y.a, x.b - y.b}; }
    friend Class operator*(Class x, Class y) { return {x.a * y.a, x.a * y.b + x.b * y.a}; }
    Class inverse() const { return {Number(1) / a, Number(0) - b / (a * a)}; }
};

Class power(Class x, unsigned exponent) {
    return exponent == 0 ? Class(1) : x * power(x, exponent - 1);
}

using Classes = std::vector<Class>;

/// The complete symmetric polynomials of degree 0 to 6.
Classes symmetric(const Classes& roots) {
    Classes h(7, Class(0));
    h[0] = Class(1);
    for (const Class& root : roots)
        for (unsigned k = 1; k < h.size(); ++k)
            h[k] = h[k] + root * h[k - 1];
    return h;
}

std::int64_t factorial(unsigned n) {
    return n == 0 ? 1 : n * factorial(n - 1);
}

std::int64_t sign(unsigned n) {
    return n % 2 == 0 ? 1 : -1;
}

Class minus_two(unsigned k) {
    return power(Class(-2), k);
}

/// Formula (6), for a centre of this codimension, with the h_k of its roots.
Class blown_up(Class d, const Classes& h, unsigned codimension) {
    Class sum(0);
    for (unsigned k = codimension; k <= 6; ++k)
        sum = sum + Class(factorial(6) / (factorial(k) * factorial(6 - k))) * power(d, 6 - k) *
                        minus_two(k) * h[k - codimension];
    return Class(-sign(codimension)) * sum;
}

/// Formula (7).
Class crossing(Class d, const Classes& roots, const Classes& others) {
    const auto r = static_cast<unsigned>(roots.size()), o = static_cast<unsigned>(others.size());
    const Classes h = symmetric(roots), g = symmetric(others);
    Class sum(0);
    for (unsigned k = r; k <= 6; ++k)
        for (unsigned l = o; k + l <= 6; ++l)
            sum = sum + Class(factorial(6) / (factorial(k) * factorial(l) * factorial(6 - k - l))) *
                            power(d, 6 - k - l) * minus_two(k + l) * h[k - r] * g[l - o];
    return Class(sign(r + o)) * sum;
}

/// The classes at a component of the fixed points, where w has the weight `plane`.
struct At {
    std::array<Class, 3> delta;
    Class xi;
    Class w;
    Class eight_l() const { return Class(8) * (delta[0] + delta[1] + delta[2] + xi); }
};

using Weights = std::vector<int>;
using Lines = std::vector<std::pair<unsigned, int>>; // a line of V/d_j, with its weight

/// A tower of bundles: the planes w, w', the weights of each d_i, those of (p_1, p_2).
struct Space {
    unsigned planes = 0;
    std::function<std::array<Weights, 3>(int plane)> directions;
    std::function<Lines(int plane, const std::array<int, 3>& d)> lines;
};

const Weights all{2, 0, -2};

/// Of d_j, for a class of vectors that contains it.
Lines modulo(unsigned j, const Weights& vectors, int d) {
    Lines lines;
    for (const int weight : vectors)
        if (weight != d) lines.emplace_back(j, weight);
    return lines;
}

Lines joined(Lines first, const Lines& second) {
    first.insert(first.end(), second.begin(), second.end());
    return first;
}

Lines all_lines(int, const std::array<int, 3>& d) {
    return joined(modulo(1, all, d[1]), modulo(2, all, d[2]));
}

/// The polarisation, times 1000: of the d_i and of p.
using Polarisation = std::array<int, 4>;

/// Formula (8).
Number integral(const Space& space, const Polarisation& theta,
                const std::function<Class(const At&)>& f) {
    Number sum;
    const Weights planes = space.planes == 0 ? Weights{0} : Weights{1, -1};
    for (const int plane : planes) {
        const std::array<Weights, 3> weights = space.directions(plane);
        for (const int d0 : weights[0])
            for (const int d1 : weights[1])
                for (const int d2 : weights[2]) {
                    const std::array<int, 3> d{d0, d1, d2};
                    Number normal = space.planes == 0 ? 1 : space.planes == 1 ? -2 * plane : -4;
                    for (unsigned i = 0; i < 3; ++i)
                        for (const int other : weights[i])
                            if (other != d[i]) normal = normal * Number(other - d[i]);
                    const Lines lines = space.lines(plane, d);
                    for (const int p : all) {
                        const auto same = std::ranges::count(
                            lines, p, [](const auto& line) { return line.second; });
                        const int weight =
                            theta[0] * d0 + theta[1] * d1 + theta[2] * d2 + theta[3] * p;
                        if (same == 0 || weight <= 0) continue;
                        const Number k = same == 2 ? 1 : 0;
                        Class value = f({{Class(-d0), Class(-d1), Class(-d2)},
                                         Class(Number(-p), k),
                                         Class(-plane)});
                        for (const auto& [j, other] : lines)
                            if (other != p) value = value * Class(Number(other - p), k).inverse();
                        sum = sum + (same == 2 ? value.b : value.a) / normal;
                    }
                }
    }
    return Number(4) * sum;
}

/// A centre at a component: what is added to 8 L, and the roots.
struct Centre {
    Class added;
    Classes roots;
};
using CentreOf = std::function<Centre(const At&)>;

At other_plane(At at) {
    at.w = Class(0) - at.w;
    return at;
}

/// All integrals of section 8, by name.
struct Integrals {
    Polarisation theta;
    std::map<std::string, std::int64_t> of;
    std::int64_t sum = 0;

    void add(const std::string& name, Number number) {
        of[name] = number.small();
        sum += number.small();
    }
    void centre(const std::string& name, const Space& space, const CentreOf& c) {
        add(name, integral(space, theta, [&](const At& at) {
                const Centre here = c(at);
                return blown_up(at.eight_l() + here.added, symmetric(here.roots),
                                static_cast<unsigned>(here.roots.size()));
            }));
    }
    void crossing_of(const std::string& name, const Space& space, const CentreOf& c,
                     const CentreOf& other, bool same_kind = false) {
        const Number all_pairs = integral(space, theta, [&](const At& at) {
            const Centre here = c(at), there = other(other_plane(at));
            return crossing(at.eight_l() + here.added + there.added, here.roots, there.roots);
        });
        add(name, same_kind ? all_pairs / Number(2) : all_pairs);
    }
};

Weights in_plane(int plane) {
    return {0, 2 * plane};
}

/// The directions are all in the plane, but for some.
std::function<std::array<Weights, 3>(int)>
planar_but(std::map<unsigned, std::function<Weights(int)>> others) {
    return [others](int plane) {
        std::array<Weights, 3> weights{in_plane(plane), in_plane(plane), in_plane(plane)};
        for (const auto& [i, weights_of] : others)
            weights[i] = weights_of(plane);
        return weights;
    };
}

/// They are all in both planes, but for some.
std::function<std::array<Weights, 3>(int)>
common_but(std::map<unsigned, std::function<Weights(int)>> others) {
    return [others](int plane) {
        std::array<Weights, 3> weights{Weights{0}, Weights{0}, Weights{0}};
        for (const auto& [i, weights_of] : others)
            weights[i] = weights_of(plane);
        return weights;
    };
}

Weights any(int) {
    return all;
}
Weights isotropic(int plane) {
    return {2 * plane};
}
Weights in_other(int plane) {
    return {0, -2 * plane};
}

Centre all_in_plane_once_more(const At& at, unsigned j) { // A, where d_0, d_o are in both planes
    return {Class(0), {Class(2) * at.w, at.delta[j] + Class(2) * at.w}};
}

Class e(const At& at, unsigned j) {
    return at.delta[j] + Class(2) * at.w;
}
Class s(const At& at) {
    return at.xi + Class(2) * at.w;
}
Class nu(const At& at, unsigned j) {
    return at.xi + e(at, j);
}

CentreOf g_of(unsigned j) {
    return [j](const At& at) -> Centre {
        const unsigned o = 3 - j;
        return {Class(-2) * e(at, j),
                {at.delta[0] + at.delta[o] + Class(2) * at.w - e(at, j), s(at)}};
    };
}

CentreOf s_of(unsigned j) {
    return [j](const At& at) -> Centre {
        const Class l = at.delta[0] + Class(2) * at.w - e(at, j);
        return {Class(-2) * (e(at, j) + l), {nu(at, j), s(at) + at.delta[3 - j] - l, l}};
    };
}

/// S_j0 and S_jo.
CentreOf s_of(unsigned j, unsigned i) {
    return [j, i](const At& at) -> Centre {
        const Class n = i == 0 ? Class(0) : nu(at, j), w = at.w;
        return {
            Class(-4) * e(at, j) - Class(2) * (s(at) + n),
            {Class(4) * w - s(at) - Class(2) * e(at, j), Class(2) * w - e(at, j) - n, s(at) - n}};
    };
}

Integrals integrals(const Polarisation& theta) {
    Integrals result{theta, {}, 0};
    const auto a_of = [](unsigned j) {
        return [j](const At& at) { return all_in_plane_once_more(at, j); };
    };
    const Space scenes{0, [](int) { return std::array<Weights, 3>{all, all, all}; }, all_lines};
    result.add("L", integral(scenes, theta, [](const At& at) { return power(at.eight_l(), 6); }));
    const Space planar{1, planar_but({}), all_lines};
    result.add("A", integral(planar, theta, [](const At& at) {
                   Classes h = symmetric({e(at, 0), e(at, 1), e(at, 2)});
                   // one root less: the tangent space of the line of w
                   for (unsigned k = 6; k > 0; --k)
                       h[k] = h[k] - Class(2) * at.w * h[k - 1];
                   return blown_up(at.eight_l(), h, 2);
               }));
    result.crossing_of("A A", {2, common_but({}), all_lines}, a_of(0), a_of(0), true);
    result.centre("R", {1, planar_but({{0, isotropic}}), all_lines}, [](const At& at) -> Centre {
        const Class n = at.delta[1] + e(at, 2);
        return {Class(-2) * n - Class(4) * s(at),
                {Class(4) * at.w - n - Class(2) * s(at), Class(2) * at.w, n}};
    });
    for (const unsigned j : {1U, 2U}) {
        const unsigned o = 3 - j;
        const std::string name = std::to_string(j);
        const auto in_g = [j, o](int plane, const std::array<int, 3>& d) {
            return joined(modulo(j, all, d[j]), modulo(o, in_plane(plane), d[o]));
        };
        const auto in_s = [j, o](int plane, const std::array<int, 3>& d) {
            return joined(modulo(o, in_plane(plane), d[o]), {{j, 2 * plane}});
        };
        const auto only_j = [j](int, const std::array<int, 3>& d) { return modulo(j, all, d[j]); };
        const auto isotropic_j = [j](int plane, const std::array<int, 3>&) {
            return Lines{{j, 2 * plane}};
        };
        result.centre("G" + name, {1, planar_but({{j, any}}), in_g}, g_of(j));
        result.crossing_of("G A " + name,
                           {2, common_but({{j, in_other}}),
                            [j, o](int plane, const std::array<int, 3>& d) {
                                return joined(modulo(j, all, d[j]), {{o, 2 * plane}});
                            }},
                           g_of(j), a_of(j));
        result.crossing_of("G G " + name, {2, common_but({{j, any}}), only_j}, g_of(j), g_of(j),
                           true);
        result.centre("S" + name, {1, planar_but({{j, any}}), in_s}, s_of(j));
        result.crossing_of("S A " + name,
                           {2, common_but({{j, in_other}}),
                            [j, o](int plane, const std::array<int, 3>&) {
                                return Lines{{o, 2 * plane}, {j, 2 * plane}};
                            }},
                           s_of(j), a_of(j));
        result.crossing_of("S G " + name, {2, common_but({{j, any}}), isotropic_j}, s_of(j),
                           g_of(j));
        result.crossing_of("S" + name + " G" + std::to_string(o),
                           {2, common_but({{j, in_other}, {o, in_plane}}),
                            [o](int plane, const std::array<int, 3>& d) {
                                return modulo(o, in_plane(plane), d[o]);
                            }},
                           s_of(j), g_of(o));
        // d_j and p_j on the line that joins the isotropic points of both planes
        result.crossing_of("S S " + name,
                           {2,
                            common_but({{j,
                                         [](int) {
                                             return Weights{2, -2};
                                         }}}),
                            [j](int, const std::array<int, 3>& d) {
                                return Lines{{j, -d[j]}};
                            }},
                           s_of(j), s_of(j), true);
        result.centre("S" + name + "0", {1, planar_but({{j, any}, {0, isotropic}}), in_g},
                      s_of(j, 0));
        if (theta[j] < theta[o]) continue;
        const std::string both = "S" + name + std::to_string(o);
        const auto in_both = common_but({{j, in_other}, {o, isotropic}});
        result.centre(both, {1, planar_but({{j, any}, {o, isotropic}}), in_g}, s_of(j, o));
        result.crossing_of(both + " G",
                           {2, in_both,
                            [j, o](int plane, const std::array<int, 3>& d) {
                                return joined(modulo(j, in_other(plane), d[j]), {{o, 0}});
                            }},
                           s_of(j, o), g_of(o));
        result.crossing_of(both + " S",
                           {2, in_both,
                            [j](int plane, const std::array<int, 3>& d) {
                                return modulo(j, in_other(plane), d[j]);
                            }},
                           s_of(j, o), s_of(o));
    }
    const Space g_g{
        2, common_but({{1, in_other}, {2, in_plane}}), [](int plane, const std::array<int, 3>& d) {
            return joined(modulo(1, in_other(plane), d[1]), modulo(2, in_plane(plane), d[2]));
        }};
    result.crossing_of("G1 G2", g_g, g_of(1), g_of(2));
    return result;
}

// The control in three views: quaternions q_1, q_2, q_3 and directions, without blow-ups.

/// Polynomials in k_1, k_2, k_3 with squares 0, by sets of these, and in degrees 0 to 2.
using Graded = std::array<std::array<Number, 3>, 8>;

Graded constant(Number n) {
    Graded result{};
    result[0][0] = n;
    return result;
}

/// `zero` in degree 0, and n plus twice k_v in this degree.
Graded linear(Number zero, Number n, unsigned v, unsigned degree) {
    Graded result = constant(zero);
    result[0][degree] = result[0][degree] + n;
    if (v < 3) result[std::size_t{1} << v][degree] = Number(2);
    return result;
}

Graded operator*(const Graded& x, const Graded& y) {
    Graded result{};
    for (std::size_t a = 0; a < 8; ++a)
        for (std::size_t b = 0; b < 8; ++b)
            for (unsigned i = 0; (a & b) == 0 && i < 3; ++i)
                for (unsigned j = 0; i + j < 3; ++j)
                    result[a | b][i + j] = result[a | b][i + j] + x[a][i] * y[b][j];
    return result;
}

Graded inverse(const Graded& x) {
    const Number unit = Number(1) / x[0][0];
    Graded rest = x * constant(Number(0) - unit), sum = constant(1), term = constant(1);
    rest[0][0] = 0;
    for (unsigned i = 0; i < 6; ++i) {
        term = term * rest;
        for (std::size_t a = 0; a < 8; ++a)
            for (unsigned k = 0; k < 3; ++k)
                sum[a][k] = sum[a][k] + term[a][k];
    }
    return sum * constant(unit);
}

/// A point, `pins` lines through it and `lines` others in three views, seven conditions less one
/// for each pin beyond the directions: the integral of a Chern class of the degree 6 - directions.
std::int64_t in_three_views(unsigned pins, unsigned lines) {
    Number sum;
    for (unsigned signs = 0; signs < 8; ++signs) {
        std::array<int, 3> kernel{};
        for (unsigned v = 0; v < 3; ++v)
            kernel[v] = (signs >> v & 1) == 0 ? 1 : -1;
        if (kernel[0] + kernel[1] + kernel[2] < 0) continue;
        Graded product = constant(1);
        for (unsigned v = 0; v < 3; ++v) {
            const Graded normal = linear(0, -2 * kernel[v], 8, 0);
            Graded class_of_normal = normal;
            class_of_normal[std::size_t{1} << v][0] = Number(1);
            product = product * inverse(class_of_normal * class_of_normal);
            for (unsigned i = 1; i < lines; ++i) // the image points modulo one
                product = product * linear(1, -2 * kernel[v], v, 1);
        }
        for (unsigned i = 0; i < pins + lines; ++i) {
            Graded directions{};
            for (const int d : all) {
                Graded term = constant(1);
                for (unsigned v = 0; v < 3; ++v)
                    term = term * linear(0, -2 * kernel[v] - d, v, 0);
                for (const int other : all)
                    if (other != d) term = term * constant(Number(1) / Number(other - d));
                if (i >= pins) { // the inverse of the class of V / d
                    Graded space = constant(1);
                    space[0][2] = Number(-4);
                    term = term * linear(1, d, 8, 1) * inverse(space);
                }
                for (std::size_t a = 0; a < 8; ++a)
                    for (unsigned k = 0; k < 3; ++k)
                        directions[a][k] = directions[a][k] + term[a][k];
            }
            product = product * directions;
        }
        sum = sum + product[7][6 - pins - lines];
    }
    return (Number(4) * sum).small();
}

} // namespace

TEST_CASE("the integral is 186,368, and its parts are those of the table") {
    const Integrals found = integrals({970, 1020, 1011, 1000});
    CHECK(found.sum == 186368);
    CHECK(found.of == std::map<std::string, std::int64_t>{
                          {"L", 491520},    {"A", -272416},   {"A A", 11440},   {"R", -5744},
                          {"G1", -60352},   {"G2", -70048},   {"G A 1", 50640}, {"G A 2", 50640},
                          {"G G 1", -6720}, {"G G 2", -6720}, {"G1 G2", 17920}, {"S1", -18368},
                          {"S2", -20672},   {"S A 1", 13440}, {"S A 2", 13440}, {"S G 1", 160},
                          {"S G 2", 160},   {"S S 1", 320},   {"S S 2", 320},   {"S1 G2", -320},
                          {"S2 G1", 1600},  {"S10", -992},    {"S20", -992},    {"S12", -11488},
                          {"S12 G", 8320},  {"S12 S", 1280}});
}

TEST_CASE("in three views the same formula gives degrees that are known") {
    CHECK(in_three_views(0, 4) == 360);
    CHECK(in_three_views(2, 3) == 552);
}

TEST_CASE("another polarisation has other parts with the same sum") {
    CHECK(integrals({970, 1011, 1020, 1000}).sum == 186368);
}
