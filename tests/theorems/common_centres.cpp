// Theorem C of proofs/common_centres.md, by the program's integrals.
#include "proofs/computations/common_centres.h"
#include "proofs/computations/four_pins.h"

#include "tests/checker/bounds/degrees_on_file.h"
#include "tests/support/minimal_classes.h"

#include <doctest/doctest.h>

#include <functional>

using namespace proofs::blown_up;

namespace {

const Integrals& integrals() {
    static const Integrals result = integrals_over_third_blow_up();
    return result;
}

std::int64_t degree(std::string_view problem) {
    const checker::Signature signature =
        checker::constraint_class(all_classes().representatives[class_of(problem)]);
    CHECK(has_degree_by_common_centres(signature));
    return integrals().of(signature);
}

using Charts = std::vector<Chart>;
using Integrand = std::function<Residue(const Chart&)>;

/// The integral over a blow-up.
Residue integral(Charts (*charts)(const FixedPoint&), const Integrand& integrand) {
    Residue sum;
    for (const FixedPoint& at : fixed_points())
        for (const Chart& chart : charts(at))
            sum = sum + at.weight * chart.factor * integrand(chart);
    return sum;
}

Residue power(Residue x, unsigned n) {
    return n == 0 ? Residue{1} : x * power(x, n - 1);
}

/// A divisor of the second blow-up.
Residue some_divisor(const Chart& chart) {
    const FixedPoint& at = *chart.at;
    return Residue{2} * at.h[0] + Residue{3} * at.h[1] + Residue{7} * at.h[2] +
           Residue{5} * at.x[3] + Residue{11} * chart.both[0] + Residue{13} * chart.both[1] +
           Residue{17} * chart.both[2] + Residue{19} * at.image[0] + Residue{23} * at.image[1];
}

} // namespace

TEST_CASE("Theorem C has the degrees of other theorems") {
    CHECK(degree("4*P/a/a + 4*a/P/a + 3*a/a/P") == 43224); // Z
    CHECK(degree("P/P/P + 4*a/a/a") == 360);               // Y
    CHECK(degree("Pab/Pab/Pab + 2*P/P/P") == 224);         // U15
    CHECK(degree("3*P/P/P + a/a/a") == 216);               // U15
    CHECK(degree("3*P/P/P + a/P/Pa") == 272);              // U15
    CHECK(degree("3*P/P/P + -/P/P + P/-/P") == 384);       // U15
}

TEST_CASE("Theorem C: five points that two views share have twenty relative poses") {
    CHECK(degree("5*-/P/P + 5*P/-/P + P/P/-") % 400 == 0);
}

TEST_CASE("Theorem C does not speak of points with four pins") {
    const std::size_t number = class_of("Pabcd/Pabcd/Pabcd + 2*a/a/a");
    CHECK_FALSE(has_degree_by_common_centres(all_classes().representatives[number]));
}

TEST_CASE("Theorem C applies to 9,989 constraint classes, and has their degrees on file") {
    std::size_t count = 0;
    for (const auto& [signature, on_file] : degrees_on_file()) {
        if (!has_degree_by_common_centres(signature)) continue;
        ++count;
        CHECK(integrals().of(signature) == static_cast<std::int64_t>(on_file));
    }
    CHECK(count == 9989);
}

TEST_CASE("the integral is 0 where a problem is not minimal") {
    std::set<checker::Signature> classes;
    for (std::size_t number = 0; number < all_classes().representatives.size(); ++number)
        if (!is_minimal_class(number))
            classes.insert(checker::constraint_class(all_classes().representatives[number]));
    std::size_t count = 0;
    for (const checker::Signature& signature : classes) {
        if (!has_degree_by_common_centres(signature)) continue;
        ++count;
        CHECK(integrals().of(signature) == 0);
    }
    CHECK(count == 614);
}

TEST_CASE("integrals over the third blow-up do not depend on the weights of the torus") {
    const Integrals others = integrals_over_third_blow_up(77);
    for (const auto& problem : {
             signature_of({{"-/P/P", 4}, {"P/-/P", 4}, {"P/P/-", 3}}),
             signature_of({{"P/P/P", 2}, {"a/Pa/Pa", 1}, {"P/a/a", 1}, {"-/P/P", 1}}),
             signature_of({{"Pabc/Pabc/Pabc", 1}, {"P/-/P", 3}, {"P/P/-", 2}}),
         })
        CHECK(integrals().of(problem) == others.of(problem));
    CHECK(integrals().of(signature_of({{"P/P/P", 2}, {"-/P/P", 4}})) == 0);
}

TEST_CASE("three pairs of views have no common centres") {
    const auto all_three = [](const Chart& chart) {
        const Triple& c = chart.same_centre;
        return power(c[0] * c[1] * c[2], 3) * power(some_divisor(chart), 2);
    };
    CHECK(integral(charts_of_third_blow_up, all_three) == Residue{});
    const auto two = [](const Chart& chart) {
        return power(chart.same_centre[0] * chart.same_centre[1], 3) *
               power(some_divisor(chart), 5);
    };
    CHECK(integral(charts_of_third_blow_up, two) != Residue{});
}

TEST_CASE("without its exceptional divisors an integral over the third blow-up is one over the "
          "second") {
    for (const FixedPoint& at : fixed_points())
        for (const Chart& start : charts_over(at))
            for (std::size_t view = 0; view < 3; ++view) {
                const auto locus = centre_without(start, view);
                if (!locus) continue;
                Triple moments{}; // of the classes 1, n, n^2
                for (const Chart& chart : blown_up_in(*locus, view, start))
                    for (unsigned k = 0; k < 3; ++k)
                        moments[k] = moments[k] + chart.factor * power(chart.same_centre[view], k);
                CHECK(moments == Triple{start.factor});
            }
}

TEST_CASE("the loci of common centres are where a map of bundles drops rank") {
    // At fixed points where no weight had to be moved.
    std::size_t inside = 0;
    for (const FixedPoint& at : fixed_points()) {
        const Charts charts = charts_over(at);
        if (charts.size() > 6) continue;
        for (const Chart& chart : charts)
            for (std::size_t view = 0; view < 3; ++view) {
                const Polynomial c = normal_class_of_common_centres(chart, view);
                const auto locus = centre_without(chart, view);
                if (!locus) CHECK(c[3] == Residue{});
                if (!locus) continue;
                ++inside;
                const auto& [a, b, d] = locus->normal;
                CHECK(c[1] == a + b + d);
                CHECK(c[2] == a * b + a * d + b * d);
                CHECK(c[3] == a * b * d);
            }
    }
    CHECK(inside > 0);
}

TEST_CASE("powers of the exceptional divisors are Segre classes of this map") {
    for (std::size_t view = 0; view < 3; ++view)
        for (unsigned n = 1; n < powers; ++n) {
            const Residue above = integral(charts_of_third_blow_up, [&](const Chart& chart) {
                return power(chart.same_centre[view], n) * power(some_divisor(chart), 11 - n);
            });
            const Residue below = integral(charts_over, [&](const Chart& chart) {
                return powers_of_common_centres(chart, view)[n] *
                       power(some_divisor(chart), 11 - n);
            });
            CHECK(above == below);
            CHECK((above == Residue{}) == (n < 3));
        }
}
