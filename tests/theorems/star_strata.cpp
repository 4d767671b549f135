// Lemmas N4 to N6 of proofs/five_pins.md by counting: how many images of a feature given cameras
// see, over two finite fields. The growth of these numbers is the dimension.
#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <random>
#include <string>
#include <vector>

namespace {

/// Small enough for products to fit.
using Prime = int;
constexpr Prime small = 7, large = 13;

/// Coordinates 1 to 3 are those of Q, the others those of the three line bundles.
using Vector = std::array<int, 6>;
using Vectors = std::vector<Vector>;

int inverse(int x, Prime p) {
    int power = 1;
    for (int i = 0; i < p - 2; ++i)
        power = power * x % p;
    return power;
}

Vector combination(const std::vector<int>& factors, const Vectors& all, Prime p) {
    Vector sum{};
    for (std::size_t i = 0; i < all.size(); ++i)
        for (std::size_t k = 0; k < 6; ++k)
            sum[k] = (sum[k] + factors[i] * all[i][k]) % p;
    return sum;
}

int value(const Vector& form, const Vector& at, Prime p) {
    int sum = 0;
    for (std::size_t k = 0; k < 6; ++k)
        sum += form[k] * at[k];
    return sum % p;
}

/// The reduced row echelon form, without zero rows, and the places of its leading entries.
struct Echelon {
    Vectors rows;
    std::vector<std::size_t> leads;
};

Echelon echelon(Vectors rows, Prime p) {
    std::vector<std::size_t> leads;
    for (std::size_t c = 0; c < 6 && leads.size() < rows.size(); ++c) {
        const std::size_t rank = leads.size();
        std::size_t place = rank;
        while (place < rows.size() && rows[place][c] == 0)
            ++place;
        if (place == rows.size()) continue;
        std::swap(rows[rank], rows[place]);
        rows[rank] = combination({inverse(rows[rank][c], p)}, {rows[rank]}, p);
        for (std::size_t r = 0; r < rows.size(); ++r)
            if (r != rank) rows[r] = combination({1, p - rows[r][c]}, {rows[r], rows[rank]}, p);
        leads.push_back(c);
    }
    rows.resize(leads.size());
    return {rows, leads};
}

std::size_t rank_of(const Vectors& rows, Prime p) {
    return echelon(rows, p).rows.size();
}

Vectors joined(Vectors all, const Vectors& more) {
    all.insert(all.end(), more.begin(), more.end());
    return all;
}

/// A basis of the vectors on which these forms vanish.
Vectors kernel(const Vectors& forms, Prime p) {
    const auto [rows, leads] = echelon(forms, p);
    Vectors basis;
    for (std::size_t c = 0; c < 6; ++c) {
        if (std::ranges::find(leads, c) != leads.end()) continue;
        Vector vector{};
        vector[c] = 1;
        for (std::size_t r = 0; r < rows.size(); ++r)
            vector[leads[r]] = (p - rows[r][c]) % p;
        basis.push_back(vector);
    }
    return basis;
}

/// One vector of each line of the space with this basis.
Vectors points_of(const Vectors& basis, Prime p) {
    Vectors points;
    std::vector<int> factors(basis.size());
    const std::function<void(std::size_t, bool)> choose = [&](std::size_t i, bool started) {
        if (i == basis.size()) {
            if (started) points.push_back(combination(factors, basis, p));
            return;
        }
        for (int x = 0; x < (started ? p : 2); ++x) {
            factors[i] = x;
            choose(i + 1, started || x != 0);
        }
    };
    choose(0, false);
    return points;
}

constexpr Vector q1{1}, q2{0, 1}, q3{0, 0, 1}, o1{0, 0, 0, 1}, o2{0, 0, 0, 0, 1},
    o3{0, 0, 0, 0, 0, 1};

/// The forms E_v. The first two of a view are those on R_v.
using Cameras = std::array<Vectors, 3>;

/// All regular cameras whose a_v are not on a line, or are on a line, by a choice of bases.
const Cameras off_line{{{q2, q3, o1}, {q1, q3, o2}, {q1, q2, o3}}};
const Cameras on_line{{{q2, q3, o1}, {q1, q3, o2}, {Vector{1, 1}, q3, o3}}};

/// V is where the two forms W vanish.
struct Scene {
    Prime p = 0;
    Cameras cameras;
    Vectors w, v;
};

/// How many zeros there are of linear equations that leave this dimension.
double points_in(std::size_t dimension, Prime p) {
    return (std::pow(p, static_cast<double>(dimension)) - 1) / (p - 1);
}

/// How many images of a free line, where l_1 does not contain p_1 if this is asked for. The images
/// l_3 to given l_1 and l_2 are a linear system.
double images_of_free_line(const Scene& s, bool off_p1) {
    double sum = 0;
    for (const Vector& m1 : points_of(s.cameras[0], s.p)) {
        if (off_p1 && rank_of(joined(s.w, {m1}), s.p) == 2) continue;
        for (const Vector& m2 : points_of(s.cameras[1], s.p)) {
            const Vectors forms = joined(s.w, {m1, m2});
            const bool independent = rank_of(forms, s.p) == 4;
            const std::size_t system =
                independent ? 7 - rank_of(joined(forms, s.cameras[2]), s.p) : 3;
            sum += points_in(system, s.p);
        }
    }
    return sum;
}

/// Two forms of a view that vanish on X.
using Pencil = std::array<Vector, 2>;

/// All x_v other than o_v that contain P_v X, each by the forms of the view that vanish there.
std::vector<Pencil> images_in_view(const Scene& s, const Vectors& view, const Vector& at) {
    const Vector image{value(view[0], at, s.p), value(view[1], at, s.p), value(view[2], at, s.p)};
    const Vectors images = image == Vector{} ? points_of({q1, q2, q3}, s.p) : Vectors{image};
    std::vector<Pencil> result;
    for (const Vector& x : images) {
        if (x[0] == 0 && x[1] == 0) continue;
        const Vectors forms = kernel({x, o1, o2, o3}, s.p);
        const auto of_view = [&](const Vector& m) {
            return combination({m[0], m[1], m[2]}, view, s.p);
        };
        result.push_back({of_view(forms[0]), of_view(forms[1])});
    }
    return result;
}

/// Whether all l_1, l_2, l_3 through these x_1, x_2, x_3 are images of a pin of X. They are so
/// where the restrictions of three forms to V, which vanish on X, are dependent: a trilinear
/// condition.
bool all_images(const Scene& s, const std::array<Pencil, 3>& pencils) {
    for (const Vector& m1 : pencils[0])
        for (const Vector& m2 : pencils[1])
            for (const Vector& m3 : pencils[2])
                if (rank_of(joined(s.w, {m1, m2, m3}), s.p) == 5) return false;
    return true;
}

/// Whether the lambda_v A_v of all views have the kernel q_3 = 0, which is the line of the a_v for
/// the cameras on_line. Lemma N3 excludes this. It does not occur for the others.
bool excluded(const Scene& s, const std::array<Pencil, 3>& pencils) {
    return std::ranges::all_of(pencils, [&](const Pencil& x) {
        return rank_of({x[0], x[1], q3}, s.p) == 2;
    });
}

/// How many (X, x_1, x_2, x_3) there are: with b = 2 and b = 3 in the proof of Lemma N6, by whether
/// x_1 = p_1.
struct Counts {
    std::array<double, 2> at_p1{}, elsewhere{};
};

Counts images_of_point(const Scene& s) {
    Counts counts;
    for (const Vector& at : points_of(s.v, s.p)) {
        std::array<std::vector<Pencil>, 3> images;
        for (std::size_t view = 0; view < 3; ++view)
            images[view] = images_in_view(s, s.cameras[view], at);
        for (const Pencil& x1 : images[0]) {
            const bool at_p1 = rank_of(joined(s.w, {x1[0], x1[1]}), s.p) == 2;
            for (const Pencil& x2 : images[1])
                for (const Pencil& x3 : images[2])
                    if (!excluded(s, {x1, x2, x3}))
                        ++(at_p1 ? counts.at_p1 : counts.elsewhere)[all_images(s, {x1, x2, x3})];
        }
    }
    return counts;
}

/// By which power of the prime a number grows; -1 if it is 0.
int dimension(double at_small, double at_large) {
    if (at_large == 0) return -1;
    return static_cast<int>(
        std::lround(std::log(at_large / at_small) / std::log(1.0 * large / small)));
}

/// W is spanned by a general form of each of these spaces.
using Position = std::array<Vectors, 2>;

Vectors random_forms(Prime p, const Position& position) {
    static std::mt19937_64 random(1);
    Vectors w;
    for (const Vectors& space : position) {
        std::vector<int> factors;
        for (std::size_t i = 0; i < space.size(); ++i)
            factors.push_back(1 + static_cast<int>(random() % static_cast<unsigned>(p - 1)));
        w.push_back(combination(factors, space, p));
    }
    return rank_of(w, p) == 2 ? w : random_forms(p, position);
}

/// The sum of the dimensions of all W + E_v and W + E_u + E_v.
std::size_t generality(const Vectors& w, const Cameras& cameras, Prime p) {
    std::size_t sum = 0;
    for (std::size_t v = 0; v < 3; ++v) {
        const Vectors pair = joined(cameras[v], cameras[(v + 1) % 3]);
        sum += rank_of(joined(w, cameras[v]), p) + rank_of(joined(w, pair), p);
    }
    return sum;
}

/// The most general of some random W: few elements of a small field are general.
Scene general_scene(Prime p, const Cameras& cameras, const Position& position) {
    Vectors best;
    for (int i = 0; i < 10; ++i) {
        const Vectors w = random_forms(p, position);
        if (best.empty() || generality(w, cameras, p) > generality(best, cameras, p)) best = w;
    }
    return Scene{p, cameras, best, kernel(best, p)};
}

/// The dimensions of what images_of_free_line and images_of_point count.
struct Dimensions {
    int line = 0, line_off_p1 = 0;
    std::array<int, 2> at_p1{}, elsewhere{};
    bool operator==(const Dimensions&) const = default;
};

Dimensions dimensions(const Cameras& cameras, const Position& position) {
    const Scene s = general_scene(small, cameras, position),
                t = general_scene(large, cameras, position);
    const auto of_line = [&](bool off_p1) {
        return dimension(images_of_free_line(s, off_p1), images_of_free_line(t, off_p1));
    };
    const Counts at_small = images_of_point(s), at_large = images_of_point(t);
    Dimensions all{of_line(false), of_line(true), {}, {}};
    for (std::size_t i = 0; i < 2; ++i) {
        all.at_p1[i] = dimension(at_small.at_p1[i], at_large.at_p1[i]);
        all.elsewhere[i] = dimension(at_small.elsewhere[i], at_large.elsewhere[i]);
    }
    return all;
}

const Vectors& everything() {
    static const Vectors all{q1, q2, q3, o1, o2, o3};
    return all;
}

} // namespace

TEST_CASE("Lemmas N4 and N6: no excess where the ranks are 2 and 3") {
    const Vectors forms_on_q{q1, q2, q3}, off_third{q1, q2, q3, o1, o2};
    for (const Cameras& cameras : {off_line, on_line}) {
        std::vector<Position> positions{{everything(), everything()}, {cameras[0], everything()},
                                        {Vectors{q3}, everything()},  {Vectors{q3}, forms_on_q},
                                        {forms_on_q, everything()},   {forms_on_q, forms_on_q},
                                        {off_third, off_third}};
        // For a_v on a line q_3 is in all E_v, and this W is in E_3.
        if (cameras == off_line) positions.push_back({Vectors{q3}, cameras[2]});
        for (const Position& position : positions) {
            const Dimensions found = dimensions(cameras, position);
            CHECK(found.line <= 4);
            CHECK(found.at_p1 == std::array{-1, -1}); // no camera has rank 1
            CHECK(found.elsewhere[0] <= 3);
            CHECK(found.elsewhere[1] == -1);
        }
    }
}

TEST_CASE("Lemma N5: where two kernels are in a plane, a point has excess without a free line") {
    for (const Cameras& cameras : {off_line, on_line})
        CHECK(dimensions(cameras, {cameras[0], cameras[1]}) == Dimensions{4, 4, {-1, -1}, {3, 2}});
}

TEST_CASE("Lemmas N4 and N6: a camera of rank 1") {
    for (const Cameras& cameras : {off_line, on_line}) {
        const Dimensions expected{5, 4, {-1, 3}, {4, -1}};
        CHECK(dimensions(cameras, {cameras[0], cameras[0]}) == expected);
        CHECK(dimensions(cameras, {Vectors{q3}, cameras[0]}) == expected);
    }
}
