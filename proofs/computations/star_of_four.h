// Lemma V8 of proofs/stars_in_several_views.md: a point with four pins and four free lines in four
// views, as equations for one number in each view; one example modulo q = 2^61 - 1.
#pragma once

#include "proofs/computations/residue_matrices.h"
#include "proofs/computations/star_of_five.h"

#include <array>
#include <cstddef>
#include <vector>

namespace proofs {

using Direction = std::array<Residue, 2>;

/// What one view shows, modulo the image of the point: the directions of four pins, and covectors
/// of four free lines.
struct ImageOfStar {
    std::array<Direction, 4> pins{}, lines{};
};

/// A map from vectors with three coordinates to directions: its columns.
using StarCamera = std::array<Direction, 3>;

/// Cameras that see the four pins, in the directions of the unit vectors and (1, 1, 1), as a view
/// shows them: first + t second.
struct CamerasOfView {
    StarCamera first{}, second{};

    CamerasOfView(const ImageOfStar& image, Residues& random) {
        ResidueRow c;
        for (std::size_t i = 0; i < 3; ++i)
            c.push_back(bracket(image.pins[i], image.pins[3]));
        const ResidueMatrix basis = kernel_of({c}, 3);
        for (StarCamera* camera : {&first, &second}) {
            const ResidueRow factors = product({random.row(2)}, basis).front();
            for (std::size_t i = 0; i < 3; ++i)
                (*camera)[i] = {factors[i] * image.pins[i][0], factors[i] * image.pins[i][1]};
        }
    }

    StarCamera at(Residue t) const {
        StarCamera camera = first;
        for (std::size_t i = 0; i < 3; ++i)
            for (std::size_t n = 0; n < 2; ++n)
                camera[i][n] = camera[i][n] + t * second[i][n];
        return camera;
    }
};

using FourImages = std::array<ImageOfStar, 4>;

inline FourImages generic_stars(Residues& random) {
    FourImages images;
    for (ImageOfStar& image : images)
        for (auto* directions : {&image.pins, &image.lines})
            for (Direction& direction : *directions)
                direction = {random.next(), random.next()};
    return images;
}

/// The equations of Lemma V8 for the four numbers t, one for each view.
class StarEquations {
public:
    /// The cameras of all views, by random parameters.
    StarEquations(const FourImages& images, Residues& random) : images_(images) {
        for (const ImageOfStar& image : images)
            cameras_.emplace_back(image, random);
    }

    const CamerasOfView& cameras(std::size_t view) const { return cameras_[view]; }

    /// Three vectors for each free line i, one for each pair of the others: multiples of one if t
    /// belongs to a solution.
    std::array<ResidueMatrix, 4> vectors(const ResidueRow& t) const {
        std::array<ResidueMatrix, 4> result;
        for (std::size_t i = 0; i < 4; ++i)
            for (std::size_t j = 0; j < 4; ++j)
                for (std::size_t k = 0; k < j; ++k)
                    if (i != j && i != k)
                        result[i].push_back(
                            combination_of_rows(minors(rows(t, j, k)), rows(t, i, j)));
        return result;
    }

    /// All minors of size 2 of these: 36 polynomials, of degree 2 in each of the four numbers.
    ResidueRow at(const ResidueRow& t) const {
        ResidueRow values;
        for (const ResidueMatrix& three : vectors(t))
            for (std::size_t a = 0; a < 3; ++a)
                for (std::size_t b = 0; b < a; ++b)
                    for (std::size_t n = 0; n < 3; ++n) {
                        const std::size_t o = (n + 1) % 3;
                        values.push_back(three[a][n] * three[b][o] - three[a][o] * three[b][n]);
                    }
        return values;
    }

private:
    /// For each view the difference of the covectors of two lines, composed with the camera.
    ResidueMatrix rows(const ResidueRow& t, std::size_t i, std::size_t j) const {
        ResidueMatrix result;
        for (std::size_t v = 0; v < 4; ++v) {
            const Direction &l = images_[v].lines[i], &other = images_[v].lines[j];
            const Residue n0 = l[0] - other[0], n1 = l[1] - other[1];
            result.emplace_back();
            for (const Direction& column : cameras_[v].at(t[v]))
                result.back().push_back(n0 * column[0] + n1 * column[1]);
        }
        return result;
    }

    /// The relation between four vectors: their minors of size 3 with signs.
    static ResidueRow minors(const ResidueMatrix& four) {
        ResidueRow result;
        for (std::size_t omitted = 0; omitted < 4; ++omitted) {
            ResidueMatrix three = four;
            three.erase(three.begin() + static_cast<std::ptrdiff_t>(omitted));
            const Residue minor = determinant_of(three);
            result.push_back(omitted % 2 == 0 ? minor : -minor);
        }
        return result;
    }

    static ResidueRow combination_of_rows(const ResidueRow& factors, const ResidueMatrix& rows) {
        return product({factors}, rows).front();
    }

    FourImages images_;
    std::vector<CamerasOfView> cameras_{};
};

/// The values of all monomials of degree at most d in each of the numbers.
inline ResidueRow monomials_of(const ResidueRow& t, std::size_t degree) {
    ResidueRow values{Residue{1}};
    for (const Residue number : t) {
        ResidueRow more;
        Residue power{1};
        for (std::size_t i = 0; i <= degree; ++i) {
            for (const Residue value : values)
                more.push_back(value * power);
            power = power * number;
        }
        values = more;
    }
    return values;
}

/// How many polynomials of degree at most d in each number are independent modulo the products of
/// the equations with monomials; and whether those of degree at most d - 1 span all of these.
struct QuotientOfStar {
    std::size_t dimension = 0;
    bool spanned_by_lower = false;
};

/// A polynomial is given by its values at generic points, one for each monomial.
inline QuotientOfStar quotient_of_star(const StarEquations& equations, std::size_t degree,
                                       Residues& random) {
    std::size_t monomials = 1;
    for (std::size_t v = 0; v < 4; ++v)
        monomials *= degree + 1;
    ResidueMatrix products, with_lower; // a row for each point
    for (std::size_t i = 0; i < monomials; ++i) {
        const ResidueRow t = random.row(4);
        products.emplace_back();
        const ResidueRow factors = monomials_of(t, degree - 2);
        for (const Residue value : equations.at(t))
            for (const Residue factor : factors)
                products.back().push_back(value * factor);
        with_lower.push_back(monomials_of(t, degree - 1));
        for (const Residue value : products.back())
            with_lower.back().push_back(value);
    }
    return {monomials - rank_of(products), rank_of(with_lower) == monomials};
}

/// The four t for which all cameras take the direction of one pin to 0: both cameras of a view take
/// it to multiples of the direction that the view shows.
inline ResidueMatrix spurious_stars(const StarEquations& equations) {
    ResidueMatrix points(4);
    for (std::size_t i = 0; i < 4; ++i) {
        const auto of_pin = [&](const StarCamera& camera) {
            return i < 3 ? camera[i][0] : camera[0][0] + camera[1][0] + camera[2][0];
        };
        for (std::size_t v = 0; v < 4; ++v) {
            const CamerasOfView& cameras = equations.cameras(v);
            points[i].push_back(-of_pin(cameras.first) * of_pin(cameras.second).inverse());
        }
    }
    return points;
}

/// Whether these are four different points, where the vectors of all lines are 0.
inline bool spurious_stars_are_four(const StarEquations& equations) {
    const ResidueMatrix points = spurious_stars(equations);
    for (std::size_t i = 0; i < 4; ++i) {
        for (const ResidueMatrix& three : equations.vectors(points[i]))
            if (rank_of(three) != 0) return false;
        for (std::size_t j = 0; j < i; ++j)
            if (points[i] == points[j]) return false;
    }
    return true;
}

} // namespace proofs
