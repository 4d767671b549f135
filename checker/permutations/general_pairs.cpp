#include "checker/permutations/general_pairs.h"

namespace checker {
namespace {
/// The resultant of two binary forms of the same degree, by their coefficients: not 0 if they have
/// no zero in common, over any field.
template <std::size_t n>
Residue resultant(const std::array<Residue, n>& f, const std::array<Residue, n>& g) {
    constexpr std::size_t degree = n - 1;
    SquareMatrix sylvester(2 * degree);
    for (std::size_t row = 0; row < degree; ++row)
        for (std::size_t i = 0; i < n; ++i) {
            sylvester[row][row + i] = f[i];
            sylvester[degree + row][row + i] = g[i];
        }
    return determinant(sylvester);
}

using Quadratic = std::array<Residue, 3>;
using Quartic = std::array<Residue, 5>;

/// Of two binary forms.
template <std::size_t n>
std::array<Residue, 2 * n - 1> product(const std::array<Residue, n>& f,
                                       const std::array<Residue, n>& g) {
    std::array<Residue, 2 * n - 1> result{};
    for (std::size_t i = 0; i < n; ++i)
        for (std::size_t j = 0; j < n; ++j)
            result[i + j] = result[i + j] + f[i] * g[j];
    return result;
}

template <std::size_t n>
std::array<Residue, n> sum(std::array<Residue, n> f, const std::array<Residue, n>& g,
                           Residue factor) {
    for (std::size_t i = 0; i < n; ++i)
        f[i] = f[i] + factor * g[i];
    return f;
}

/// Whether the four zeros of a binary form differ: its partial derivatives have none in common.
bool has_four_zeros(const Quartic& f) {
    std::array<Residue, 4> by_first{}, by_second{};
    for (std::size_t i = 0; i < 4; ++i) {
        by_first[i] = Residue{4 - i} * f[i];
        by_second[i] = Residue{i + 1} * f[i + 1];
    }
    return resultant(by_first, by_second) != Residue{};
}

/// Whether the ratios of these numbers do.
bool moves_in_two_dimensions(std::span<const Equation> numbers, const Echelon& cameras) {
    Echelon ratios = cameras;
    std::size_t moving = 0;
    const Equation& first = numbers.front();
    for (const Equation& other : numbers.subspan(1)) {
        Motion ratio;
        for (std::size_t k = 0; k < ratio.size(); ++k)
            ratio[k] = first.value * other.derivatives[k] - other.value * first.derivatives[k];
        moving += ratios.add(ratio) ? 1 : 0;
    }
    return moving >= 2;
}

ResidueVector unit(std::size_t i) {
    ResidueVector result{};
    result[i] = Residue{1};
    return result;
}
} // namespace

bool pin_is_general(const NormalsOfPin& normals, const Echelon& cameras, Drawn& drawn) {
    std::array<Equation, 8> form; // trilinear
    for (std::size_t i = 0; i < 8; ++i)
        form[i] =
            MovingViews::pencil({normals[0][i & 1], normals[1][i >> 1 & 1], normals[2][i >> 2]});
    if (!moves_in_two_dimensions(form, cameras)) return false;
    // Eliminate the direction in view 3 from the form and how it moves: a determinant of bidegree
    // (2, 2) in the others. Its coefficients in the second are quadratic forms in the first.
    const Motion motion = cameras.motion(drawn);
    const auto linear = [&](std::size_t second, std::size_t third, bool moved) {
        const Equation& zero = form[2 * second + 4 * third];
        const Equation& one = form[1 + 2 * second + 4 * third];
        return moved ? std::array{zero.along(motion), one.along(motion)}
                     : std::array{zero.value, one.value};
    };
    const auto coefficient = [&](std::size_t second, std::size_t moved) {
        return sum(product(linear(second, 0, false), linear(moved, 1, true)),
                   product(linear(second, 1, false), linear(moved, 0, true)), -Residue{1});
    };
    const Quadratic middle = sum(coefficient(0, 1), coefficient(1, 0), Residue{1});
    return has_four_zeros(
        sum(product(middle, middle), product(coefficient(0, 0), coefficient(1, 1)), -Residue{4}));
}

bool known_pin_is_general(const std::array<ResidueVector, 2>& normals, std::size_t u,
                          const Echelon& cameras, Drawn& drawn) {
    // The coordinates of both normals in the frame of the two other views.
    std::array<std::array<Equation, 2>, 3> coordinates;
    std::vector<Equation> all;
    for (std::size_t a = 0; a < 3; ++a)
        for (std::size_t k = 0; k < 2; ++k) {
            std::array<ResidueVector, 3> vectors;
            vectors[u] = normals[k];
            vectors[(u + 1) % 3] = unit((a + 1) % 3);
            vectors[(u + 2) % 3] = unit((a + 2) % 3);
            coordinates[a][k] = MovingViews::pencil(vectors);
            all.push_back(coordinates[a][k]);
        }
    if (!moves_in_two_dimensions(all, cameras)) return false;
    // For no direction in view u the plane keeps its normal: two minors have no zero in common.
    const Motion motion = cameras.motion(drawn);
    const auto minor = [&](std::size_t a, std::size_t b) {
        const auto normal = [&](std::size_t c) {
            return std::array{coordinates[c][0].value, coordinates[c][1].value};
        };
        const auto moved = [&](std::size_t c) {
            return std::array{coordinates[c][0].along(motion), coordinates[c][1].along(motion)};
        };
        return sum(product(normal(a), moved(b)), product(normal(b), moved(a)), -Residue{1});
    };
    return resultant(minor(0, 1), minor(0, 2)) != Residue{};
}

bool line_is_general(const BilinearForm& form, const Echelon& cameras, Drawn& drawn) {
    const auto value = [&](std::size_t a, std::size_t b) { return form[a][b].value; };
    if (value(0, 0) * value(1, 1) == value(0, 1) * value(1, 0)) return false;
    // Of the form and how it moves: whether their two common zeros are equal.
    const auto discriminant = [&](const Motion& motion) {
        const auto moved = [&](std::size_t a, std::size_t b) { return form[a][b].along(motion); };
        const Residue first = value(0, 0) * moved(0, 1) - value(0, 1) * moved(0, 0);
        const Residue last = value(1, 0) * moved(1, 1) - value(1, 1) * moved(1, 0);
        const Residue middle = value(0, 0) * moved(1, 1) + value(1, 0) * moved(0, 1) -
                               value(0, 1) * moved(1, 0) - value(1, 1) * moved(0, 0);
        return middle * middle - Residue{4} * first * last;
    };
    // A quadratic form of the motion. On the span of two motions it is no square.
    const Motion one = cameras.motion(drawn), two = cameras.motion(drawn);
    const Residue of_one = discriminant(one), of_two = discriminant(two);
    const Residue mixed = discriminant(sum(one, two, Residue{1})) - of_one - of_two;
    return mixed * mixed != Residue{4} * of_one * of_two;
}

bool epipolar_form_is_general(const MovingViews& views, std::size_t i, std::size_t j,
                              const Motion& motion) {
    SquareMatrix moved(3), with_motion(3);
    for (std::size_t row = 0; row < 3; ++row)
        for (std::size_t column = 0; column < 3; ++column) {
            const Equation entry = views.epipolar({i, unit(row)}, {j, unit(column)});
            moved[row][column] = entry.along(motion);
            with_motion[row][column] = entry.value + moved[row][column];
        }
    const Residue last = determinant(moved);
    return last != Residue{} && determinant(with_motion) != last;
}

bool tensor_is_general(const MovingViews& views, std::size_t i, const Motion& motion,
                       Drawn& drawn) {
    const std::size_t j = i == 0 ? 1 : 0, k = i == 2 ? 1 : 2;
    // A curve of pairs of planes: a point s of it takes the first of each pair plus s times the
    // second.
    const std::array planes{drawn.vector(), drawn.vector()};
    const std::array others{drawn.vector(), drawn.vector()};
    std::array<Quadratic, 3> tensor{}, moved{}; // by coordinates of the ray
    for (std::size_t t = 0; t < 3; ++t)
        for (std::size_t a = 0; a < 2; ++a)
            for (std::size_t b = 0; b < 2; ++b) {
                const Equation entry =
                    views.incidence({i, unit(t)}, {j, planes[a]}, {k, others[b]});
                tensor[t][a + b] = tensor[t][a + b] + entry.value;
                moved[t][a + b] = moved[t][a + b] + entry.along(motion);
            }
    const auto minor = [&](std::size_t s, std::size_t t) {
        return sum(product(tensor[s], moved[t]), product(tensor[t], moved[s]), -Residue{1});
    };
    return resultant(minor(0, 1), minor(0, 2)) != Residue{};
}
} // namespace checker
