// Pinhole cameras that are calibrated in part (FORMAT.md, sections 13 and 14): [M | t] with a
// rotation M of the conic ω that the shared numbers make, ω = I if there are none. M = (a² det ω -
// v·ωv) I + 2 v (ωv)ᵀ + 2 a adj ω [v]×.
#pragma once

#include "checker/cameras/camera_model.h"

#include <algorithm>

namespace checker {
template <class T> using Conic = std::array<Vector3<T>, 3>;

template <class T> Conic<T> conic(std::span<const T> n, const T& zero, const T& one) {
    if (n.empty()) return {{{one, zero, zero}, {zero, one, zero}, {zero, zero, one}}};
    if (n.size() == 1) return {{{one, zero, zero}, {zero, one, zero}, {zero, zero, n[0]}}};
    if (n.size() == 3) return {{{one, zero, n[0]}, {zero, one, n[1]}, {n[0], n[1], n[2]}}};
    return {{{one, n[0], n[2]}, {n[0], n[1], n[3]}, {n[2], n[3], n[4]}}};
}

/// The columns of M.
template <class T>
std::array<Vector3<T>, 3> turned(const Conic<T>& w, const T& a, const Vector3<T>& v) {
    const Conic<T> adjugate{cross(w[1], w[2]), cross(w[2], w[0]), cross(w[0], w[1])};
    const Vector3<T> wv{dot(w[0], v), dot(w[1], v), dot(w[2], v)};
    const T diagonal = a * a * dot(w[0], adjugate[0]) - dot(v, wv);
    const T zero = diagonal - diagonal, twice_a = a + a;
    const std::array<Vector3<T>, 3> across{Vector3<T>{zero, v[2], zero - v[1]},
                                           Vector3<T>{zero - v[2], zero, v[0]},
                                           Vector3<T>{v[1], zero - v[0], zero}}; // v × e_j
    std::array<Vector3<T>, 3> columns;
    for (std::size_t j = 0; j < 3; ++j) {
        const Vector3<T> spread{dot(adjugate[0], across[j]), dot(adjugate[1], across[j]),
                                dot(adjugate[2], across[j])};
        columns[j] = plus(times(wv[j] + wv[j], v), times(twice_a, spread));
        columns[j][j] = columns[j][j] + diagonal;
    }
    return columns;
}

/// An upright camera has v = (0, v_2, 0). If it has a focal length of its own, r times that of
/// camera 1, it multiplies the first two rows of M by r. One that is not upright has (r, s)
/// instead, a focal length and a turn about the camera's axis; so v = (v_1, v_2, 0) will do.
template <std::size_t shared_numbers, bool upright, bool own_focal> struct Pinhole {
    static constexpr std::size_t turn = upright ? 2 : own_focal ? 3 : 4;
    static constexpr std::size_t own = !own_focal ? 0 : upright ? 1 : 2;
    static constexpr std::size_t numbers = turn + 3 + own;

    /// `fixed`, `first_of_t` and `next` take numbers in their order.
    template <class T, class Fixed, class FirstOfT, class Next>
    static CameraMatrix<T> matrix(std::span<const T> shared, const T& zero, const T& one,
                                  const Fixed& fixed, const FirstOfT& first_of_t,
                                  const Next& next) {
        const T a = fixed();
        Vector3<T> v{zero, next(), zero};
        if constexpr (!upright) v = {v[1], next(), own_focal ? zero : next()};
        auto [x, y, z] = turned(conic(shared, zero, one), a, v);
        const T t = first_of_t();
        const Vector3<T> translation{t, next(), next()};
        if constexpr (own_focal) {
            const T r = next(), s = upright ? zero : next();
            for (Vector3<T>* column : {&x, &y, &z}) {
                const auto& [first, second, third] = *column;
                *column = {r * first - s * second, s * first + r * second, third};
            }
        }
        return {x, y, z, translation};
    }

    template <class T>
    static CameraMatrix<Dual<T>> place(Source<T>& source, SharedNumbers<T> shared, bool second) {
        const auto fixed = [&] { return source.fixed(); };
        const auto next = [&] { return source.unknown(); };
        const auto first_of_t = [&] { return second ? fixed() : next(); };
        return matrix<Dual<T>>(shared, constant<T>(T{}), constant<T>(T{1}), fixed, first_of_t,
                               next);
    }

    static CameraMatrix<CoordinatePolynomial> of_solution(bool second) {
        std::size_t number = 0;
        const CoordinatePolynomial one = CoordinatePolynomial::constant(1);
        const auto next = [&] { return CoordinatePolynomial::coordinate(number++); };
        const auto fixed = [&] { return one; };
        const auto first_of_t = [&] { return second ? one : next(); };
        std::vector<CoordinatePolynomial> shared;
        while (shared.size() < shared_numbers)
            shared.push_back(next());
        return matrix<CoordinatePolynomial>(shared, {}, one, fixed, first_of_t, next);
    }

    static std::string_view objection(std::span<const int> numbers, bool second) {
        const auto is_zero = [](int number) { return number == 0; };
        if (std::ranges::all_of(numbers.first(turn), is_zero)) return "a rotation is zero";
        return second && numbers[turn] == 0 ? "the translation of camera 2 begins with 0" : "";
    }

    static CameraModel model(std::string_view name, std::string_view prefix) {
        return {.name = name,
                .prefix = prefix,
                .numbers = numbers,
                .shared = shared_numbers,
                .unknowns = static_cast<int>(numbers) - 1,
                .unknowns_of_second = static_cast<int>(numbers) - 2,
                .may_turn = !upright,
                .objection = objection,
                .place_modulo = place<Residue>,
                .place = place<mpz_class>,
                .of_solution = of_solution};
    }
};
} // namespace checker
