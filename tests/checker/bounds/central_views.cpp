// Theorem R (proofs/relations.md): its bounds against what is known of the same degrees in other
// ways, and against the statement of the theorem.
#include "proofs/computations/feature_classes.h"
#include "tests/checker/bounds/degrees_on_file.h"
#include "tests/checker/bounds/templates.h"

#include <fstream>
#include <set>

using namespace checker;
using namespace templates;

namespace {
/// What the statement of Theorem R asks about.
struct CentralView {
    bool features_in_the_table = false;
    unsigned lines_and_pins = 0; // free lines, and pins that all views see
    unsigned points = 0;         // P/P/P
};

CentralView central_view(const Signature& signature) {
    Views sees_all = all_views;
    CentralView found{.features_in_the_table = true};
    for (std::size_t i = 0; i < feature_count; ++i) {
        const Feature& feature = features[i];
        if (signature[i] == 0) continue;
        if (!feature.free_line) sees_all &= feature.point;
        const bool seen_by_all = feature.point == all_views;
        if (seen_by_all && feature.pins >= 2) found.features_in_the_table = false;
        if (seen_by_all && feature.pins == 0) found.points += signature[i];
        if (feature.pins == 1 && feature.pin[0] == all_views) found.lines_and_pins += signature[i];
    }
    found.features_in_the_table &= sees_all != 0;
    return found;
}

/// One class of each of the minimal constraint classes whose features are in the table.
const std::vector<std::size_t>& classes_of_the_table() {
    static const std::vector<std::size_t> numbers = [] {
        std::set<Signature> seen;
        std::vector<std::size_t> found;
        for (std::size_t n = 0; n < all_classes().representatives.size(); ++n) {
            const Signature& signature = all_classes().representatives[n];
            if (!is_minimal_class(n) || !central_view(signature).features_in_the_table) continue;
            if (seen.insert(constraint_class(signature)).second) found.push_back(n);
        }
        return found;
    }();
    return numbers;
}

/// A signature with each view that sees all points as view 1, as Theorem R takes it.
std::vector<Signature> in_view_1(const Signature& signature) {
    std::vector<Signature> found;
    for (const FeatureMap& map : relabelings) {
        const Signature relabeled = proofs::merged(permuted(signature, map));
        if (proofs::has_classes(relabeled)) found.push_back(relabeled);
    }
    return found;
}

/// Whether Theorem R speaks of the signature.
bool has_bound(const Signature& signature) {
    return std::ranges::any_of(in_view_1(signature), [](const Signature& relabeled) {
        return proofs::points_at_the_boundary(relabeled).has_value();
    });
}

/// The bounds by Theorem R, by constraint class; without extensions.
std::map<Signature, std::size_t> bounds() {
    std::map<Signature, std::size_t> found;
    for (const std::size_t n : classes_of_the_table()) {
        const Signature& signature = all_classes().representatives[n];
        if (has_five_shared_points(signature)) continue;
        if (const auto bound = proofs::bound_by_theorem(signature))
            found[constraint_class(signature)] = static_cast<std::size_t>(*bound);
    }
    return found;
}

/// The degree of the product of classes, the same whichever view comes first.
std::size_t product_of(const Signature& signature) {
    std::set<std::int64_t> values;
    for (const Signature& relabeled : in_view_1(signature))
        values.insert(proofs::product_of_classes(relabeled));
    REQUIRE(values.size() == 1);
    return static_cast<std::size_t>(*values.begin());
}
} // namespace

TEST_CASE("Theorem R bounds the classes of which it speaks") {
    const auto table = bounds();
    std::size_t extensions = 0, others = 0;
    for (const std::size_t n : classes_of_the_table()) {
        const Signature& signature = all_classes().representatives[n];
        CAPTURE(notation(signature));
        const bool wanted = has_bound(signature);
        const bool extension = has_five_shared_points(signature);
        if (wanted && extension) ++extensions;
        if (!wanted) ++others;
        CHECK(table.contains(constraint_class(signature)) == (wanted && !extension));
    }
    CHECK(classes_of_the_table().size() == 1154);
    CHECK(table.size() == 916);
    CHECK(extensions == 212);
    CHECK(others == 26);
}

TEST_CASE("features with at most one line or pin that all views see avoid the boundary") {
    std::size_t simple = 0;
    for (const std::size_t n : classes_of_the_table()) {
        const Signature& signature = all_classes().representatives[n];
        const auto [in_table, lines_and_pins, points] = central_view(signature);
        if (lines_and_pins > 1 || (lines_and_pins == 1 && points > 1)) continue;
        CAPTURE(notation(signature));
        CHECK(proofs::degree_by_theorem(signature).has_value());
        ++simple;
    }
    CHECK(simple == 641);
}

TEST_CASE("on M alone the product of classes is the degree only by chance where strata are met") {
    const auto on_file = degrees_on_file();
    std::size_t agree = 0, larger = 0, smaller = 0;
    for (const std::size_t n : classes_of_the_table()) {
        const Signature& signature = all_classes().representatives[n];
        if (proofs::degree_by_theorem(signature)) continue;
        const std::size_t product = product_of(signature);
        const std::size_t degree = on_file.at(constraint_class(signature));
        agree += product == degree ? 1 : 0;
        larger += product > degree ? 1 : 0;
        smaller += product < degree ? 1 : 0;
    }
    CHECK(agree == 16);
    CHECK(larger == 39);
    CHECK(smaller == 102);
}

TEST_CASE("with one line or pin, products exceed degrees by points of the stratum (ii)") {
    // On the surface of all (u_2, u_3), x^2 = y^2 = 0 and xy = 4. For each pair of points P/P/P
    // there are two tangents. The other features have classes x, y and the hyperplane class z of a
    // bundle of planes, in dimension 4; z^(n+2) is pushed forward to the part of degree n of
    // 1/(1-x)(1-y)(1-x-y), that is 1, 2x + 2y, 5xy. A pin seen by all adds no condition.
    const auto boundary_points = [](unsigned x, unsigned y, unsigned z) -> std::size_t {
        if (x > 1 || y > 1 || x + y + z != 4) return 0;
        if (z == 4) return 2 * 5 * 4;
        return 2 * (z == 3 ? 2 * 4 : 4);
    };
    const auto on_file = degrees_on_file();
    std::size_t compared = 0;
    for (const std::size_t n : classes_of_the_table()) {
        const Signature& signature = all_classes().representatives[n];
        const auto [in_table, lines_and_pins, points] = central_view(signature);
        if (lines_and_pins != 1 || points < 2) continue;
        const Signature relabeled = in_view_1(signature).front();
        const auto count = [&](std::string_view feature) { return relabeled[index_of(feature)]; };
        const unsigned all_three = points - 2 + count("Pa/Pa/Pa");
        const unsigned x = count("P/P/-") + count("P/Pa/a") + count("Pa/Pa/a") + all_three;
        const unsigned y = count("P/-/P") + count("P/a/Pa") + count("Pa/a/Pa") + all_three;
        const unsigned z = count("P/a/a") + count("P/a/Pa") + count("P/Pa/a") + count("a/a/a") +
                           count("Pa/a/Pa") + count("Pa/Pa/a") + all_three;
        CAPTURE(notation(signature));
        const std::size_t pairs = points * (points - 1) / 2;
        CHECK(product_of(signature) - on_file.at(constraint_class(signature)) ==
              pairs * boundary_points(x, y, z));
        ++compared;
    }
    CHECK(compared == 20);
}

TEST_CASE("isolated points at the boundary: as many in each view that sees all points") {
    std::size_t classes = 0;
    for (const std::size_t n : classes_of_the_table()) {
        const Signature& signature = all_classes().representatives[n];
        if (proofs::degree_by_theorem(signature) || !has_bound(signature)) continue;
        CAPTURE(notation(signature));
        std::set<unsigned> numbers;
        for (const Signature& relabeled : in_view_1(signature))
            numbers.insert(proofs::points_at_the_boundary(relabeled).value_or(1));
        REQUIRE(numbers.size() == 1);
        CHECK(*numbers.begin() % 8 == 0);
        ++classes;
    }
    CHECK(classes == 131);
}

TEST_CASE("the blow-up changes no product of features that avoid the boundary") {
    std::size_t avoiding = 0, compared = 0;
    for (const std::size_t n : classes_of_the_table()) {
        const Signature& signature = all_classes().representatives[n];
        if (!proofs::degree_by_theorem(signature) || ++avoiding % 10 != 0) continue;
        CAPTURE(notation(signature));
        CHECK(proofs::excess_on_blow_up(in_view_1(signature).front()) == 0);
        ++compared;
    }
    CHECK(compared == 99);
}

TEST_CASE(
    "certified degrees attain the bounds of Theorem R, all but four, and are multiples of 8") {
    const auto on_file = degrees_on_file();
    const auto certified = certified_on_file();
    CHECK(on_file.size() == 10073);
    std::size_t larger = 0;
    for (const auto& row : bounds()) {
        const Signature& signature = row.first;
        const std::size_t bound = row.second;
        CAPTURE(notation(signature));
        CHECK(on_file.at(signature) <= bound);
        CHECK(certified.contains(signature));
        CHECK(bound % 8 == 0);
        larger += on_file.at(signature) < bound ? 1 : 0;
    }
    CHECK(larger == 4);
}

TEST_CASE("where two views share five points, Theorem R and the templates give the same degree") {
    const DegreeTable table = table_of(committed().bounds);
    std::size_t compared = 0;
    for (const std::size_t n : classes_of_the_table()) {
        const Signature& signature = all_classes().representatives[n];
        const auto degree = proofs::degree_by_theorem(signature);
        if (!degree || !has_five_shared_points(signature)) continue;
        CAPTURE(notation(signature));
        CHECK(degree == bound_of(table, n));
        ++compared;
    }
    CHECK(compared == 212);
}

TEST_CASE("intersection numbers of relative poses that are known in other ways") {
    using proofs::on_poses;
    // Powers of E = 2 h + k - y, times those of k.
    const auto number = [](unsigned of_e, unsigned of_k) {
        std::int64_t sum = 0;
        for (unsigned h = 0; h <= of_e; ++h)
            for (unsigned y = 0; h + y <= of_e; ++y)
                sum += proofs::binomial(of_e, h) * proofs::binomial(of_e - h, y) *
                       (proofs::sign(y) << h) * on_poses(h, of_e - h - y + of_k, y);
        return sum;
    };
    CHECK(number(5, 0) == 20); // ten essential matrices with two rotations each
    // For a given epipole three points are three quadrics in the quaternion.
    CHECK(number(3, 2) == 8);
}

TEST_CASE("5 E^3 S = 5 E^4 T - 3 E^5 where one view sees all points") {
    const std::size_t s = index_of("P/a/Pa"), e = index_of("P/-/P"), t = index_of("P/a/a");
    std::set<Signature> problems; // with E^3 S, view 1 sees all points
    for (const Signature& signature : all_classes().representatives)
        for (const FeatureMap& map : relabelings)
            problems.insert(proofs::merged(permuted(signature, map)));
    std::size_t equations = 0;
    for (const Signature& problem : problems) {
        if (problem[s] == 0 || problem[e] < 3) continue;
        const auto degree = proofs::degree_in_view_1(problem);
        if (!degree) continue;
        Signature with_t = problem;
        --with_t[s];
        ++with_t[e];
        Signature with_e = with_t;
        ++with_t[t];
        ++with_e[e];
        CHECK(5 * *degree ==
              5 * *proofs::degree_in_view_1(with_t) - 3 * *proofs::degree_in_view_1(with_e));
        ++equations;
    }
    CHECK(equations == 191);
}
