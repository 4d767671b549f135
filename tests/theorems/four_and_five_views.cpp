// The facts that Theorem V needs (proofs/four_and_five_views.md) by second methods: fixed points of
// a torus, numbers of forms, and scenes that are seen, which the equations must find. The program
// proofs/computations/four_and_five_views.cpp, which is a test, too, computes the facts themselves.
#include "proofs/computations/schubert_numbers.h"
#include "proofs/computations/star_of_five.h"
#include "proofs/computations/star_of_four.h"
#include "proofs/computations/tangent_cones.h"
#include "proofs/computations/three_points_two_lines.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <vector>

using namespace proofs;

namespace {

constexpr Residue one{1};

/// The sum of all monomials of this degree in two or three numbers.
Residue complete(const ResidueRow& roots, std::size_t degree) {
    ResidueRow sums(degree + 1);
    sums[0] = one;
    for (const Residue root : roots)
        for (std::size_t d = 1; d <= degree; ++d)
            sums[d] = sums[d] + root * sums[d - 1];
    return sums[degree];
}

/// The number of Lemma V2, from the fixed points of a torus: sets of three of 3 m - 1 weights. The
/// special Schubert classes are the Chern classes of the quotient bundle, less constants.
Residue by_fixed_points(std::size_t m, std::size_t pins, std::size_t lines) {
    Residues random(2);
    const ResidueRow weights = random.row(3 * m - 1);
    Residue sum;
    for (std::size_t i = 0; i < weights.size(); ++i) {
        for (std::size_t j = 0; j < i; ++j) {
            for (std::size_t k = 0; k < j; ++k) {
                const ResidueRow roots{weights[i], weights[j], weights[k]};
                const auto h = [&](std::size_t d) { return complete(roots, d); };
                Residue term{1}, below{1};
                for (std::size_t n = 0; n < pins; ++n)
                    term = term * h(m - 2);
                for (std::size_t n = 0; n < lines; ++n)
                    term = term * (h(m - 2) * h(m - 2) - h(m - 1) * h(m - 3));
                for (std::size_t n = 0; n < weights.size(); ++n)
                    for (const Residue root : roots)
                        if (n != i && n != j && n != k) below = below * (root - weights[n]);
                sum = sum + term * below.inverse();
            }
        }
    }
    return sum;
}

ResidueRow combination(const ResidueRow& coefficients, const ResidueMatrix& rows) {
    return product({coefficients}, rows).front();
}

/// A camera of Lemma V4: the images in C^3 / (1, 1, 1) of three vectors that span U.
ResidueMatrix camera_of_frame(const ResidueRow& numbers) {
    const Residue kappa = numbers[0];
    ResidueMatrix images; // of the unit vectors of U
    for (std::size_t i = 0; i < 3; ++i) {
        ResidueRow image(3);
        image[i] = numbers[1 + i];
        image[(i + 2) % 3] = kappa;
        images.push_back({image[0] - image[2], image[1] - image[2]});
    }
    return images;
}

/// The coordinates of a vector with respect to three others, which are scaled so that a fourth
/// vector is their sum.
ResidueRow in_frame(const ResidueMatrix& pins, const ResidueRow& vector) {
    ResidueMatrix system(3);
    for (std::size_t i = 0; i < 3; ++i) {
        for (std::size_t n = 0; n < 3; ++n)
            system[i].push_back(pins[n][i]);
        system[i].push_back(pins[3][i]);
        system[i].push_back(vector[i]);
    }
    ResidueRow coordinates;
    for (const ResidueRow& row : echelon(system).rows)
        coordinates.push_back(row[4] * row[3].inverse());
    return coordinates;
}

ImageStar image_of(const ResidueMatrix& camera, const ResidueMatrix& pins, std::size_t fifth) {
    ImageStar image;
    for (std::size_t i = 0; i < 5; ++i) {
        const ResidueRow y = combination(pins[i < 4 ? i : fifth], camera);
        image[i] = {y[0], y[1]};
    }
    return image;
}

std::array<Residue, 3> triple(const ResidueRow& row) {
    return {row[0], row[1], row[2]};
}

/// How many forms of degree 15 on the plane are no multiples of the minors: the number of zeros.
std::size_t zeros_on_the_plane(const FiveImages& images, Residues& random) {
    const auto monomials = [](const ResidueRow& x, std::size_t degree) {
        ResidueRow values;
        for (std::size_t i = 0; i <= degree; ++i)
            for (std::size_t j = 0; i + j <= degree; ++j) {
                Residue value{1};
                for (std::size_t n = 0; n < degree; ++n)
                    value = value * x[n < i ? 0 : n < i + j ? 1 : 2];
                values.push_back(value);
            }
        return values;
    };
    constexpr std::size_t forms = 136;
    ResidueMatrix values;
    for (std::size_t i = 0; i < forms; ++i) {
        const ResidueRow x = random.row(3);
        values.emplace_back();
        for (const Residue minor : minors_of_cameras(images, triple(x)))
            for (const Residue monomial : monomials(x, 10))
                values.back().push_back(minor * monomial);
    }
    return forms - rank_of(values);
}

/// How many forms of degree 12 in s and 11 in t are no combinations of the minors.
std::size_t zeros_on_the_quadric(const PinsAndLines& images, const Quadric& quadric,
                                 Residues& random) {
    constexpr std::size_t forms = 13 * 12;
    const CombinedMinors minors(random, 12);
    const auto powers = [](const ResidueRow& s, std::size_t degree) {
        ResidueRow values;
        for (std::size_t i = 0; i <= degree; ++i) {
            values.push_back(one);
            for (std::size_t n = 0; n < degree; ++n)
                values.back() = values.back() * s[n < i ? 0 : 1];
        }
        return values;
    };
    ResidueMatrix values;
    for (std::size_t i = 0; i < forms; ++i) {
        const ResidueRow s = random.row(2), t = random.row(2);
        values.emplace_back();
        for (const Residue minor : minors.at(equations_at(images, quadric, s, t)))
            for (const Residue of_s : powers(s, 6))
                for (const Residue of_t : powers(t, 6))
                    values.back().push_back(minor * of_s * of_t);
    }
    return forms - rank_of(values);
}

/// Images of a scene as in Lemma V9: c, e and Y_1, Y_2, Y_3 are its cameras.
PinsAndLines images_of_scene(const ResidueRow& c, const ResidueRow& e, const ResidueMatrix& y,
                             Residues& random) {
    const auto image = [&](const ResidueRow& z, std::size_t v) {
        return std::array<Residue, 3>{z[0] + y[0][v] * z[3], c[v] * z[1] + y[1][v] * z[3],
                                      e[v] * z[2] + y[2][v] * z[3]};
    };
    PinsAndLines images;
    for (std::size_t i = 0; i < 3; ++i) {
        const ResidueRow z = random.row(4);
        for (std::size_t v = 0; v < 4; ++v) {
            images.pin_a[i].push_back(image(z, v)[1]);
            images.pin_b[i].push_back(-image(z, v)[0]);
        }
    }
    for (std::size_t j = 0; j < 2; ++j) {
        const ResidueRow z = random.row(4), w = random.row(4);
        for (std::size_t v = 0; v < 4; ++v) {
            const auto p = image(z, v), r = image(w, v);
            const Residue scale = (p[0] * r[1] - p[1] * r[0]).inverse();
            images.line_a[j].push_back((p[1] * r[2] - p[2] * r[1]) * scale);
            images.line_b[j].push_back((p[2] * r[0] - p[0] * r[2]) * scale);
        }
    }
    return images;
}

} // namespace

TEST_CASE("Lemma V2: fixed points of a torus give the same numbers") {
    struct Case {
        std::size_t m, pins, lines, number;
    };
    for (const Case& c : {Case{4, 0, 6, 16}, {4, 2, 5, 66}, {5, 1, 5, 40}, {3, 1, 7, 21}}) {
        CHECK(schubert_number(c.m, c.pins, c.lines) == static_cast<std::int64_t>(c.number));
        CHECK(by_fixed_points(c.m, c.pins, c.lines) == Residue{c.number});
    }
}

TEST_CASE("Lemmas V2 and V3 give the degrees of Theorem Q in three views") {
    CHECK(schubert_number(3, 1, 7) - 3 * 2 == 15);
    CHECK(schubert_number(3, 3, 6) - 3 * 8 == 23);
    CHECK(tangent_cones_meet_in_0({3, 1, 7}, 0, 3));
    CHECK(tangent_cones_meet_in_0({3, 3, 6}, 0, 3));
}

TEST_CASE("Lemma V3: more pins yield curves, unless there are too many free lines") {
    // (k - 2)(m - 2) >= 3: section 5 of the page.
    CHECK_FALSE(tangent_cones_meet_in_0({3, 5, 5}, 0, 3));
    CHECK_FALSE(tangent_cones_meet_in_0({5, 3, 4}, 0, 3));
    // One line more than in a balanced problem.
    CHECK(tangent_cones_meet_in_0({3, 5, 6}, 0, 3));
    CHECK(tangent_cones_meet_in_0({4, 4, 5}, 0, 3));
    CHECK(tangent_cones_meet_in_0({5, 3, 5}, 0, 3));
}

TEST_CASE("Lemma V7: a star of five pins that is seen is one of 15 zeros") {
    Residues random(4);
    const ResidueMatrix pins = random.matrix(5, 3);
    FiveImages images;
    for (ImageStar& image : images)
        image = image_of(camera_of_frame(random.row(4)), pins, 4);
    const auto x = triple(in_frame(pins, pins[4]));
    CHECK(rank_of(cameras_of_star(images, x)) == 4);
    CHECK(no_curve_of_degenerate_stars(images, random));
    CHECK(zeros_on_the_plane(images, random) == 15);
    for (const auto& point : spurious_points(images))
        CHECK(rank_of(cameras_of_star(images, point)) == 4);
}

TEST_CASE("Lemma V6: a star of six pins that is seen has one companion") {
    Residues random(5);
    const ResidueMatrix pins = random.matrix(6, 3);
    const ResidueRow a = in_frame(pins, pins[4]), b = in_frame(pins, pins[5]);
    std::array<ImageStar, 4> fifth, sixth;
    constexpr std::array<std::array<std::size_t, 2>, 6> places{
        {{0, 1}, {1, 2}, {2, 0}, {1, 0}, {2, 1}, {0, 2}}};
    ResidueMatrix equations;
    for (std::size_t v = 0; v < 4; ++v) {
        const ResidueMatrix camera = camera_of_frame(random.row(4));
        fifth[v] = image_of(camera, pins, 4);
        sixth[v] = image_of(camera, pins, 5);
        equations.emplace_back();
        for (const auto& [i, h] : places) {
            const std::size_t l = 3 - i - h;
            const Residue sign = h == (i + 1) % 3 ? one : -one;
            const auto at = [&](const ImageStar& y, std::size_t n, std::size_t pin) {
                return bracket(y[n], y[pin]);
            };
            equations.back().push_back(sign * at(fifth[v], l, 3) * at(fifth[v], i, 4) *
                                       at(sixth[v], h, 4));
        }
    }
    const ResidueMatrix pencil = kernel_of(equations, 6);
    REQUIRE(pencil.size() == 2);
    ResidueRow seen;
    for (const auto& [i, h] : places)
        seen.push_back(a[i] * b[h]);
    for (const ResidueRow& equation : equations) {
        CHECK(product(equation, seen) == Residue{});
        CHECK(product(equation, ResidueRow(6, one)) == Residue{});
    }
    // w = seen + kappa has the equation kappa (q_1 + q_2 kappa) = 0.
    const auto& w = seen;
    const Residue q1 =
        w[0] * w[1] + w[1] * w[2] + w[2] * w[0] - w[3] * w[4] - w[4] * w[5] - w[5] * w[3];
    const Residue q2 = w[0] + w[1] + w[2] - w[3] - w[4] - w[5];
    const Residue kappa = -q1 * q2.inverse();
    REQUIRE(kappa != Residue{});
    const auto other = [&](std::size_t n) { return w[n] + kappa; };
    // a_1 / a_2 = w_13 / w_23 and a_3 / a_2 = w_31 / w_21.
    const std::array<Residue, 3> companion{other(5) * other(1).inverse(), one,
                                           other(2) * other(3).inverse()};
    ResidueMatrix rows;
    for (const ImageStar& image : fifth)
        rows.push_back(camera_of_star(image, companion));
    CHECK(rank_of(rows) == 4);
    // They see the sixth pin: b_1 / b_2 = w_31 / w_32 and b_3 / b_2 = w_13 / w_12.
    const std::array<Residue, 3> b2{other(2) * other(4).inverse(), one,
                                    other(5) * other(0).inverse()};
    for (std::size_t v = 0; v < 4; ++v) {
        std::array<Residue, 2> y{};
        for (std::size_t i = 0; i < 3; ++i)
            for (std::size_t n = 0; n < 2; ++n)
                y[n] = y[n] + rows[v][2 * i + n] * b2[i];
        CHECK(bracket(y, sixth[v][4]) == Residue{});
    }
}

TEST_CASE("Lemma V8: a star of four pins that is seen is one of 45 zeros") {
    Residues random(7);
    const std::array<ResidueMatrix, 4> free_lines{random.matrix(2, 4), random.matrix(2, 4),
                                                  random.matrix(2, 4), random.matrix(2, 4)};
    FourImages images;
    for (ImageOfStar& image : images) {
        // The point is (1, 0, 0, 0), its image (0, 0, 1).
        const ResidueMatrix rest = random.matrix(3, 3);
        const ResidueMatrix camera{{{}, {}, one}, rest[0], rest[1], rest[2]};
        image.pins[3] = {};
        for (std::size_t i = 0; i < 3; ++i)
            for (std::size_t n = 0; n < 2; ++n) {
                image.pins[i][n] = rest[i][n];
                image.pins[3][n] = image.pins[3][n] + rest[i][n];
            }
        for (std::size_t j = 0; j < 4; ++j) {
            const ResidueRow l = kernel_of(product(free_lines[j], camera), 3).front();
            image.lines[j] = {l[0] * l[2].inverse(), l[1] * l[2].inverse()};
        }
    }
    const StarEquations equations(images, random);
    ResidueRow t; // where the columns of the camera of each view are the pins
    for (std::size_t v = 0; v < 4; ++v) {
        const auto factor = [&](const StarCamera& camera, std::size_t i) {
            return camera[i][0] * images[v].pins[i][0].inverse();
        };
        const auto &f = equations.cameras(v).first, &g = equations.cameras(v).second;
        t.push_back((factor(f, 1) - factor(f, 0)) * (factor(g, 0) - factor(g, 1)).inverse());
    }
    for (const ResidueMatrix& three : equations.vectors(t))
        CHECK(rank_of(three) == 1);
    for (const ResidueMatrix& three : equations.vectors(random.row(4)))
        CHECK(rank_of(three) == 3);
    const QuotientOfStar quotient = quotient_of_star(equations, 3, random);
    CHECK(quotient.dimension == 45);
    CHECK(quotient.spanned_by_lower);
    CHECK(spurious_stars_are_four(equations));
}

TEST_CASE("Lemmas V9 and V10: a scene that is seen is one of 8 zeros on the quadric") {
    Residues random(6);
    const ResidueRow c = random.row(4), e = random.row(4);
    const PinsAndLines images = images_of_scene(c, e, random.matrix(3, 4), random);
    const Quadric quadric(images);
    REQUIRE(quadric.smooth());
    CHECK(quadric.contains(c));
    CHECK(pins_have_rank_2(images, quadric));
    // N(c) has rank 1: its first column is a multiple of s, its first row of t.
    const ResidueMatrix forms = kernel_of({images.line_a[0], images.line_a[1]}, 4);
    ResidueMatrix n(2);
    for (std::size_t i = 0; i < 2; ++i)
        for (const ResidueRow& b : images.line_b)
            n[i].push_back(product(forms[i], by_views(b, c)));
    CHECK(rank_of(equations_at(images, quadric, {n[0][0], n[1][0]}, n[0])) == 5);
    CHECK(rank_of(equations_at(images, quadric, random.row(2), random.row(2))) == 6);
    CHECK(no_curve_of_degenerate_points(images, quadric, random));
    CHECK(zeros_on_the_quadric(images, quadric, random) == 8);
}
