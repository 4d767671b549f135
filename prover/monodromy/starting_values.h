// Starting values of solutions, as certificates have them (certs/FORMAT.md, sections 9 and 14):
// with as few digits as Newton's method needs to find the solutions again.
#pragma once

#include <algorithm>
#include <cmath>
#include <complex>
#include <cstdint>
#include <span>
#include <vector>

namespace plprove {

/// values / 2^bits are, of each coordinate, the real part, and unless the solution is real the
/// imaginary part.
struct StartingValues {
    bool real = true;
    int bits = 0;
    std::vector<std::int64_t> values;
};

/// How many solutions these are: one that is not real stands for its conjugate, too.
inline int count_solutions(std::span<const StartingValues> solutions) {
    int count = 0;
    for (const StartingValues& solution : solutions)
        count += solution.real ? 1 : 2;
    return count;
}

/// A Point is a range of complex numbers.
template <class Point>
StartingValues starting_values(const Point& point, bool real, int bits) {
    StartingValues result{real, bits, {}};
    const auto put = [&](double x) { result.values.push_back(std::llrint(std::ldexp(x, bits))); };
    for (const std::complex<double>& x : point) {
        put(x.real());
        if (!real) put(x.imag());
    }
    return result;
}

/// The coordinates as multiples of 2^-bits.
template <class Point>
Point rounded(Point point, int bits) {
    const auto round = [&](double x) {
        return std::ldexp(std::nearbyint(std::ldexp(x, bits)), -bits);
    };
    for (std::complex<double>& x : point)
        x = {round(x.real()), round(x.imag())};
    return point;
}

/// Whether the coordinates are written with at most 18 digits.
template <class Point>
bool has_few_digits(const Point& point, int bits) {
    constexpr double limit = 1e18;
    return std::all_of(point.begin(), point.end(), [&](const std::complex<double>& x) {
        return std::ldexp(std::max(std::abs(x.real()), std::abs(x.imag())), bits) < limit;
    });
}

/// How many bits after the binary point are enough to find a solution again; 0: no number is.
struct EnoughBits {
    int sure = 0; ///< two coarser roundings lead to the solution as well: a single success may be
                  ///< luck, as the region that Newton's method converges from has a ragged edge
    int last = 0; ///< with which the last success was
};

/// Tries these numbers of bits, ascending. `find_again(bits, starts, indices)` says of each of the
/// starts, the rounded points with these indices, whether it leads to the solution.
template <class Point, class FindAgain>
std::vector<EnoughBits> enough_bits(const std::vector<Point>& points, std::span<const int> tried,
                                    FindAgain find_again) {
    constexpr int wanted = 3;
    std::vector<EnoughBits> result(points.size());
    std::vector<int> successes(points.size(), 0);
    for (const int bits : tried) {
        std::vector<std::size_t> indices;
        std::vector<Point> starts;
        for (std::size_t i = 0; i < points.size(); ++i)
            if (result[i].sure == 0 && has_few_digits(points[i], bits)) {
                indices.push_back(i);
                starts.push_back(rounded(points[i], bits));
            }
        const std::vector<bool> found = find_again(bits, starts, indices);
        for (std::size_t k = 0; k < indices.size(); ++k) {
            const std::size_t i = indices[k];
            successes[i] = found[k] ? successes[i] + 1 : 0;
            if (found[k]) result[i].last = bits;
            if (successes[i] == wanted) result[i].sure = bits;
        }
    }
    return result;
}

} // namespace plprove
