// The rank of the joint camera map, written a second way: dual numbers modulo q, homogeneous
// coordinates for points and cameras, no gauge, and every seen point and line with two coordinates.
#pragma once

#include "prover/geometry/flint.h"
#include "prover/problem/problem.h"

#include <array>
#include <random>
#include <vector>

namespace plprove {

/// a + b epsilon modulo q, epsilon^2 = 0.
struct Dual {
    Residue value = 0;
    Residue slope = 0;
};

inline Dual operator+(Dual a, Dual b) {
    const nmod_t q = modulus_context();
    return {nmod_add(a.value, b.value, q), nmod_add(a.slope, b.slope, q)};
}
inline Dual operator-(Dual a, Dual b) {
    const nmod_t q = modulus_context();
    return {nmod_sub(a.value, b.value, q), nmod_sub(a.slope, b.slope, q)};
}
inline Dual operator*(Dual a, Dual b) {
    const nmod_t q = modulus_context();
    return {nmod_mul(a.value, b.value, q),
            nmod_add(nmod_mul(a.value, b.slope, q), nmod_mul(a.slope, b.value, q), q)};
}
inline Dual operator/(Dual a, Dual b) {
    const nmod_t q = modulus_context();
    const Residue inverse = nmod_inv(b.value, q);
    const Residue quotient = nmod_mul(a.value, inverse, q);
    return {quotient, nmod_mul(nmod_sub(a.slope, nmod_mul(quotient, b.slope, q), q), inverse, q)};
}

class SecondJacobian {
public:
    SecondJacobian(const Problem& problem, unsigned seed) : problem_(problem) {
        std::mt19937_64 random(seed);
        while (parameters_.size() < 1000)
            parameters_.push_back(random() % modulus);
    }

    /// The rank at random parameters.
    int rank() {
        const std::size_t images = image_coordinates(0).size();
        const std::size_t parameters = next_;
        ResidueMatrix matrix(static_cast<int>(images), static_cast<int>(parameters));
        for (std::size_t k = 0; k < parameters; ++k) {
            const std::vector<Dual> moved = image_coordinates(k);
            for (std::size_t i = 0; i < images; ++i)
                matrix.at(static_cast<int>(i), static_cast<int>(k)) = moved[i].slope;
        }
        return static_cast<int>(nmod_mat_rank(matrix.get()));
    }

private:
    using Point = std::array<Dual, 4>;
    using Image = std::array<Dual, 3>;
    using Camera = std::array<Point, 3>;

    Dual parameter() {
        const std::size_t number = next_++;
        return {parameters_.at(number), number == moving_ ? Residue{1} : Residue{0}};
    }

    Point free_point() { return {parameter(), parameter(), parameter(), parameter()}; }

    Point on_line(const Point& a, const Point& b) {
        const Dual s = parameter(), t = parameter();
        return {s * a[0] + t * b[0], s * a[1] + t * b[1], s * a[2] + t * b[2], s * a[3] + t * b[3]};
    }

    Camera camera() {
        if (problem_.cameras == &projective_cameras)
            return {free_point(), free_point(), free_point()};
        const Dual a = parameter(), b = parameter(), c = parameter(), d = parameter();
        const Dual two{2, 0};
        return {Point{a * a + b * b - c * c - d * d, two * (b * c - a * d), two * (b * d + a * c),
                      parameter()},
                Point{two * (b * c + a * d), a * a - b * b + c * c - d * d, two * (c * d - a * b),
                      parameter()},
                Point{two * (b * d - a * c), two * (c * d + a * b), a * a - b * b - c * c + d * d,
                      parameter()}};
    }

    static Image image(const Camera& camera, const Point& x) {
        Image result;
        for (std::size_t i = 0; i < 3; ++i)
            result[i] = camera[i][0] * x[0] + camera[i][1] * x[1] + camera[i][2] * x[2] +
                        camera[i][3] * x[3];
        return result;
    }

    static Image join(const Image& a, const Image& b) {
        return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
    }

    /// All image coordinates, while parameter number `moving` moves.
    std::vector<Dual> image_coordinates(std::size_t moving) {
        moving_ = moving;
        next_ = 0;
        std::vector<Point> points;
        for (int i = 0; i < static_cast<int>(problem_.points.size()); ++i) {
            const std::optional<int> on = carrier(problem_, i);
            if (!on) {
                points.push_back(free_point());
                continue;
            }
            const std::vector<int>& base = problem_.lines[static_cast<std::size_t>(*on)].points;
            points.push_back(on_line(points[static_cast<std::size_t>(base[0])],
                                     points[static_cast<std::size_t>(base[1])]));
        }
        std::vector<std::array<Point, 2>> lines;
        for (const Line& line : problem_.lines) {
            const std::size_t count = line.points.size();
            // The last two points, where the prover takes the first two.
            lines.push_back({count >= 1 ? points[static_cast<std::size_t>(line.points[count - 1])]
                                        : free_point(),
                             count >= 2 ? points[static_cast<std::size_t>(line.points[count - 2])]
                                        : free_point()});
        }
        std::vector<Dual> result;
        const auto see = [&](const Image& x) {
            result.push_back(x[0] / x[2]);
            result.push_back(x[1] / x[2]);
        };
        for (int view = 0; view < problem_.views; ++view) {
            const Camera seen_by = camera();
            for (std::size_t i = 0; i < points.size(); ++i)
                if (contains(problem_.points[i], view)) see(image(seen_by, points[i]));
            for (std::size_t i = 0; i < lines.size(); ++i)
                if (contains(problem_.lines[i].seen, view))
                    see(join(image(seen_by, lines[i][0]), image(seen_by, lines[i][1])));
        }
        return result;
    }

    const Problem& problem_;
    std::vector<Residue> parameters_;
    std::size_t next_ = 0;
    std::size_t moving_ = 0;
};

} // namespace plprove
