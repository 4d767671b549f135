// Theorem R (proofs/relations.md): the checker's table against what is known of the same degrees in
// other ways, and against the statement of the theorem.
#include "checker/bounds/theorems.h"
#include "proofs/computations/feature_classes.h"
#include "tests/checker/bounds/templates.h"

#include <fstream>
#include <set>

using namespace checker;
using namespace templates;

namespace {
/// The rows, by constraint class.
std::map<Signature, std::size_t> rows() {
    std::map<Signature, std::size_t> found;
    for (const auto& [theorem, problem, bound] : rows_of(central_view_bounds)) {
        const Signature& signature = all_classes().representatives[class_of(problem)];
        CHECK(found.emplace(constraint_class(signature), bound).second);
    }
    return found;
}

/// The degrees on file that are complete, by constraint class.
std::map<Signature, std::size_t> degrees_on_file() {
    std::ifstream file(CERTS_DIR "/degrees.csv");
    std::map<Signature, std::size_t> degrees;
    for (std::string line; std::getline(file, line);) {
        std::size_t number = 0, degree = 0;
        if (std::sscanf(line.c_str(), "%zu,%zu,exact,", &number, &degree) == 2 &&
            contains(line, ",exact,"))
            degrees[constraint_class(all_classes().representatives[number])] = degree;
    }
    return degrees;
}

/// Whether Theorem R speaks of a problem, in its words.
bool has_central_view(const Signature& signature) {
    Views sees_all = all_views;
    unsigned lines_and_pins = 0, points = 0;
    for (std::size_t i = 0; i < feature_count; ++i) {
        const Feature& feature = features[i];
        if (signature[i] == 0) continue;
        if (!feature.free_line) sees_all &= feature.point;
        const bool seen_by_all = feature.point == all_views;
        if (seen_by_all && feature.pins >= 2) return false;
        if (seen_by_all && feature.pins == 0) points += signature[i];
        // A free line, or a pin that all views see.
        if (feature.pins == 1 && feature.pin[0] == all_views) lines_and_pins += signature[i];
    }
    if (sees_all == 0) return false;
    return lines_and_pins == 0 || (lines_and_pins == 1 && points <= 1);
}
} // namespace

TEST_CASE("the table of Theorem R has the classes of which it speaks, but no extensions") {
    const auto table = rows();
    std::set<Signature> extensions;
    for (std::size_t n = 0; n < all_classes().representatives.size(); ++n) {
        const Signature& signature = all_classes().representatives[n];
        if (!is_minimal_class(n)) continue;
        const bool wanted = has_central_view(signature);
        const bool extension = has_five_shared_points(signature);
        if (wanted && extension) extensions.insert(constraint_class(signature));
        if (table.contains(constraint_class(signature)) != (wanted && !extension))
            FAIL(notation(signature));
    }
    CHECK(table.size() == 474);
    CHECK(extensions.size() == 167);
}

TEST_CASE("the degrees of Theorem R are those on file, and multiples of 8") {
    const auto on_file = degrees_on_file();
    CHECK(on_file.size() == 10073);
    for (const auto& [signature, degree] : rows()) {
        CAPTURE(notation(signature));
        CHECK(on_file.at(signature) == degree);
        CHECK(degree % 8 == 0);
    }
}

TEST_CASE("where two views share five points, Theorem R and the templates give the same degree") {
    const DegreeTable table = table_of(committed().bounds);
    std::set<Signature> compared;
    for (std::size_t n = 0; n < all_classes().representatives.size(); ++n) {
        const Signature& signature = all_classes().representatives[n];
        if (!is_minimal_class(n) || !has_five_shared_points(signature)) continue;
        if (!has_central_view(signature)) continue;
        if (!compared.insert(constraint_class(signature)).second) continue;
        CAPTURE(notation(signature));
        CHECK(proofs::degree_by_theorem(signature) == bound_of(table, n));
    }
    CHECK(compared.size() == 167);
}

TEST_CASE("Theorem R gives four problems with three common points the degrees of Theorem U15") {
    std::size_t compared = 0;
    for (const TheoremBound& row : theorem_bounds) {
        const Signature& signature = all_classes().representatives[class_of(row.problem)];
        if (!has_central_view(signature)) continue;
        CAPTURE(row.problem);
        CHECK(row.theorem == "U15");
        CHECK(proofs::degree_by_theorem(signature) == row.bound);
        ++compared;
    }
    CHECK(compared == 4);
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
    CHECK(equations == 172);
}

TEST_CASE("more solutions than Theorem R allows contradict it, and as many make the degree exact") {
    const std::size_t number = class_of("11*P/a/a");
    const Signature key = constraint_class(all_classes().representatives[number]);
    CHECK_FALSE(table_of({}, {{number, 4911, false}}).at(key).exact());
    const DegreeTable exact = table_of({}, {{number, 4912, false}});
    CHECK(exact.at(key).exact());
    CHECK(exact.at(key).at_most->by_theorem());
    CHECK_FALSE(contradiction(exact).has_value());
    CHECK(contradiction(table_of({}, {{number, 4913, false}})).has_value());
}
