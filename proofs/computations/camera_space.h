// The intersection numbers of the space M of cameras, for Theorem R of proofs/relations.md
// (sections 2 to 4 there): a smooth compact variety of dimension 11, by its divisor classes.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <map>

namespace proofs {

/// Classes of divisors on M: xi of the bundle, e of the last blow-up, and for v = 2, 3 those of the
/// relative pose of the views 1 and v: h_v of the rotation, k_v of the epipole, y_v of the blow-up.
/// Two more are not on M, but on X (blow_up.h): b of the point v of C, and x of X itself.
enum Divisor : std::size_t { xi, e, h2, k2, y2, h3, k3, y3, b, x, divisor_count };

/// A product of divisors, by exponents.
using Monomial = std::array<unsigned, divisor_count>;

/// A class on M: a polynomial in the divisors.
using Cycle = std::map<Monomial, std::int64_t>;

/// A class on (P^1)^3: its coefficient at each product of different ones of a_2, a_3, b. Bits 0, 1
/// and 2 of the index say which are in the product.
using CubeClass = std::array<std::int64_t, 8>;

inline CubeClass operator*(const CubeClass& left, const CubeClass& right) {
    CubeClass product{};
    for (std::size_t n = 0; n < 8; ++n)
        for (std::size_t m = 0; m < 8; ++m)
            if ((n & m) == 0)
                product[n | m] += left[n] * right[m]; // each of the three squares to 0
    return product;
}

inline CubeClass power(const CubeClass& base, unsigned exponent) {
    CubeClass result{1};
    for (unsigned n = 0; n < exponent; ++n)
        result = result * base;
    return result;
}

/// The bit of a_v.
inline std::size_t bit_of(unsigned view) {
    return view == 2 ? 1 : 2;
}
inline constexpr std::size_t bit_of_b = 4;

/// h_v = a_v + b and k_v = 2 a_v on the surface Y_v.
inline CubeClass rotation_class(unsigned view) {
    CubeClass result{};
    result[bit_of(view)] = 1;
    result[bit_of_b] = 1;
    return result;
}
inline CubeClass epipole_class(unsigned view) {
    CubeClass result{};
    result[bit_of(view)] = 2;
    return result;
}

/// The part of this degree of the Segre class of Y_v: 1 - 8 a_v - 2 b + 20 a_v b.
inline CubeClass segre_class(unsigned view, unsigned degree) {
    CubeClass result{};
    if (degree == 0) result[0] = 1;
    if (degree == 1) {
        result[bit_of(view)] = -8;
        result[bit_of_b] = -2;
    }
    if (degree == 2) result[bit_of(view) | bit_of_b] = 20;
    return result;
}

inline std::int64_t sign(unsigned exponent) {
    return exponent % 2 == 0 ? 1 : -1;
}

/// The number h^a k^b y^c on the space W of relative poses.
inline std::int64_t on_poses(unsigned h, unsigned k, unsigned y) {
    if (h + k + y != 5) return 0;
    if (y == 0) return h == 3 && k == 2 ? 1 : 0;
    if (y < 3) return 0;
    const CubeClass on_surface =
        power(rotation_class(2), h) * power(epipole_class(2), k) * segre_class(2, y - 3);
    return sign(y - 1) * on_surface[bit_of(2) | bit_of_b];
}

inline std::int64_t binomial(unsigned n, unsigned k) {
    std::int64_t result = 1;
    for (unsigned i = 0; i < k; ++i)
        result = result * (n - i) / (i + 1);
    return result;
}

/// A monomial on the bundle of lines over two poses: xi^(n+1) becomes the sum of all
/// (2 h_3 + k_2)^i (2 h_2 + k_3)^j with i + j = n. `on_base` integrates a monomial without xi.
template <class OnBase>
std::int64_t on_bundle_over(const OnBase& on_base, const Monomial& m) {
    std::int64_t sum = 0;
    for (unsigned i = 0; i + 1 <= m[xi]; ++i) {
        const unsigned j = m[xi] - 1 - i;
        for (unsigned p = 0; p <= i; ++p) {
            for (unsigned q = 0; q <= j; ++q) {
                Monomial term = m;
                term[h2] += q;
                term[k2] += i - p;
                term[h3] += p;
                term[k3] += j - q;
                const std::int64_t terms = (binomial(i, p) * binomial(j, q)) << (p + q);
                sum += terms * on_base(term);
            }
        }
    }
    return sum;
}

/// A monomial without e, on the bundle M' of lines over W x W.
inline std::int64_t on_bundle(const Monomial& m) {
    const auto on_both = [](const Monomial& term) {
        return on_poses(term[h2], term[k2], term[y2]) * on_poses(term[h3], term[k3], term[y3]);
    };
    return on_bundle_over(on_both, m);
}

/// y_v^n, pushed forward from the blow-up to Y_v.
inline CubeClass pushed_forward(unsigned view, unsigned n) {
    if (n < 2) return {};
    CubeClass result = segre_class(view, n - 2);
    for (std::int64_t& coefficient : result)
        coefficient *= sign(n);
    return result;
}

/// A monomial without e on the centre B of the last blow-up.
inline std::int64_t on_centre(const Monomial& m) {
    const CubeClass of_xi{0, 2, 2, 0, 2, 0, 0, 0}; // 2 a_2 + 2 a_3 + 2 b
    const CubeClass of_poses = power(rotation_class(2), m[h2]) * power(rotation_class(3), m[h3]) *
                               power(epipole_class(2), m[k2]) * power(epipole_class(3), m[k3]);
    const CubeClass of_blow_ups = pushed_forward(2, m[y2]) * pushed_forward(3, m[y3]);
    return (power(of_xi, m[xi]) * of_poses * of_blow_ups)[7];
}

/// A monomial with e^n: the normal bundle of B has the Segre class
/// 1 / ((1 + y_2) (1 + y_3) (1 + 2 b)), where b = h_2 - k_2 / 2.
inline std::int64_t on_last_blow_up(const Monomial& m) {
    if (m[e] < 4) return 0;
    const unsigned degree = m[e] - 4;
    std::int64_t sum = 0;
    for (unsigned i = 0; i <= degree; ++i) {
        for (unsigned j = 0; i + j <= degree; ++j) {
            Monomial with_segre = m;
            with_segre[y2] += i;
            with_segre[y3] += j;
            const unsigned rest = degree - i - j;
            if (rest == 0) sum += on_centre(with_segre);
            if (rest != 1) continue; // b^2 = 0
            Monomial with_rotation = with_segre, with_epipole = with_segre;
            ++with_rotation[h2];
            ++with_epipole[k2];
            sum += 2 * on_centre(with_rotation) - on_centre(with_epipole);
        }
    }
    return sign(m[e] - 1) * sign(degree) * sum;
}

/// The degree of a class of dimension 0.
inline std::int64_t degree_of(const Cycle& cycle) {
    std::int64_t sum = 0;
    for (const auto& [monomial, coefficient] : cycle)
        sum += coefficient * (monomial[e] == 0 ? on_bundle(monomial) : on_last_blow_up(monomial));
    return sum;
}

inline Cycle operator+(Cycle left, const Cycle& right) {
    for (const auto& [monomial, coefficient] : right)
        left[monomial] += coefficient;
    return left;
}

inline Cycle operator*(std::int64_t factor, Cycle cycle) {
    for (auto& [monomial, coefficient] : cycle)
        coefficient *= factor;
    return cycle;
}

inline Cycle operator-(const Cycle& left, const Cycle& right) {
    return left + -1 * right;
}

/// Whether the monomial is 0, as W has dimension 5 and C dimension 1.
inline bool vanishes(const Monomial& m) {
    return m[b] > 1 || m[h2] + m[k2] + m[y2] > 5 || m[h3] + m[k3] + m[y3] > 5;
}

inline Cycle operator*(const Cycle& left, const Cycle& right) {
    Cycle product;
    for (const auto& [one, factor] : left) {
        for (const auto& [other, coefficient] : right) {
            Monomial monomial;
            for (std::size_t i = 0; i < divisor_count; ++i)
                monomial[i] = one[i] + other[i];
            if (!vanishes(monomial)) product[monomial] += factor * coefficient;
        }
    }
    return product;
}

inline Cycle power(const Cycle& base, unsigned exponent) {
    Cycle result{{Monomial{}, 1}};
    for (unsigned n = 0; n < exponent; ++n)
        result = result * base;
    return result;
}

/// The class of a divisor.
inline Cycle class_of(Divisor divisor) {
    Monomial monomial{};
    monomial[divisor] = 1;
    return {{monomial, 1}};
}

} // namespace proofs
