// What the proof of Theorem V needs computed (proofs/four_and_five_views.md): intersection numbers
// on Grassmannians, and single examples modulo q = 2^61 - 1. From the folder that holds checker/
// and proofs/:
//
//   c++ -std=c++20 -O2 -I. proofs/computations/four_and_five_views.cpp -lgmp -o four_and_five_views
//
// Each line of the output is a fact and its place in the proof; exit status 1 if one fails. A fact
// marked as a control is no hypothesis: it shows that the computation would notice a bad example.
#include "proofs/computations/report.h"
#include "proofs/computations/schubert_numbers.h"
#include "proofs/computations/star_of_five.h"
#include "proofs/computations/star_of_four.h"
#include "proofs/computations/star_of_three.h"
#include "proofs/computations/tangent_cones.h"
#include "proofs/computations/three_points_two_lines.h"

#include <cstddef>
#include <string>
#include <vector>

namespace {

using namespace proofs;

constexpr unsigned seed = 1;

/// (m - 1)^k for each of the m spurious points.
std::int64_t spurious(const StarAndLines& problem) {
    auto result = static_cast<std::int64_t>(problem.views);
    for (std::size_t i = 0; i < problem.pins; ++i)
        result *= static_cast<std::int64_t>(problem.views) - 1;
    return result;
}

bool all_tangent_cones_meet_in_0(const StarAndLines& problem) {
    for (std::size_t view = 0; view < problem.views; ++view)
        if (!tangent_cones_meet_in_0(problem, view, seed)) return false;
    return true;
}

void free_lines(Report& report, const std::string& name, const StarAndLines& problem,
                std::int64_t number, std::int64_t degree) {
    const std::int64_t found = schubert_number(problem.views, problem.pins, problem.lines);
    report(found == number, "Lemma V2, " + name + ": " + std::to_string(found));
    report(all_tangent_cones_meet_in_0(problem), "Lemma V3, " + name + ": isolated");
    report(found - spurious(problem) == degree,
           "Theorem V, " + name + ": " + std::to_string(found - spurious(problem)));
}

void star_of_five(Report& report) {
    Residues random(seed);
    const FiveImages images = generic_images(random);
    report(no_curve_of_degenerate_stars(images, random), "Lemma V7: finitely many points");
    report(spurious_points_are_nine(images), "Lemma V7, control: nine spurious points");
}

void star_of_four(Report& report) {
    constexpr std::size_t degree = 3;
    Residues random(seed);
    const StarEquations equations(generic_stars(random), random);
    const QuotientOfStar quotient = quotient_of_star(equations, degree, random);
    report(quotient.spanned_by_lower, "Lemma V8: polynomials of degree 2 suffice");
    report(quotient.dimension == 45,
           "Lemma V8: a quotient of dimension " + std::to_string(quotient.dimension));
    report(spurious_stars_are_four(equations), "Lemma V8, control: four spurious points");
}

/// Lemma V12 (b) for E_1 or E_2, and that it is not so for multiples that vanish at a zero.
void multiples_of_one(Report& report, const QuotientOfThreePins& quotient, const FiveViews& images,
                      std::size_t h, Residues& random) {
    const Multidegree& degree = degrees_of_e[h - 1];
    const std::vector<Exponents> e = monomials_of(degree);
    const std::size_t symbols = quotient.number_of_symbols(degree);
    const std::string space = "E_" + std::to_string(h);
    report(symbols == 216 &&
               quotient.rank_with_multiples(degree, random.row(e.size()), random) == symbols,
           "Lemma V12 (b): the multiples of one element of " + space + " suffice");
    const ResidueRow u = vanishing_at(common_kernel(images), e, random);
    report(quotient.rank_with_multiples(degree, u, random) == symbols - 1,
           "Lemma V12, control: not so for an element of " + space + " that vanishes at kappa");
}

void star_of_three(Report& report) {
    Residues random(seed);
    const FiveViews images = generic_views(random);
    std::vector<SparsePolynomial> equations = ThreePinEquations(images).all();
    const QuotientOfThreePins quotient(equations);
    report(quotient.dimension_of_f() == 440 && quotient.dimension() == 36,
           "Lemma V12 (a): codimension " + std::to_string(quotient.dimension()));
    for (std::size_t h = 1; h <= 2; ++h)
        multiples_of_one(report, quotient, images, h, random);
    equations.resize(24);
    report(QuotientOfThreePins(equations).dimension() == 96,
           "Lemma V12, control: codimension 96 for the minors of size 5 alone");
}

void three_points(Report& report) {
    Residues random(seed);
    const PinsAndLines images = generic_pins_and_lines(random);
    const Quadric quadric(images);
    report(quadric.smooth(), "Lemma V10: the quadric is smooth");
    report(quadric.smooth() && pins_have_rank_2(images, quadric), "Lemma V10: rank 2 of pins");
    report(quadric.smooth() && no_curve_of_degenerate_points(images, quadric, random),
           "Lemma V10: finitely many points");
}

} // namespace

int main() {
    Report report;
    free_lines(report, "P + 6*a in four views", {4, 0, 6}, 16, 12);
    free_lines(report, "Pab + 5*a in four views", {4, 2, 5}, 66, 30);
    free_lines(report, "Pa + 5*a in five views", {5, 1, 5}, 40, 20);
    report(!all_tangent_cones_meet_in_0({3, 5, 5}),
           "Lemma V3, control: not so for Pabcde + 5*a in three views");
    star_of_five(report);
    star_of_four(report);
    star_of_three(report);
    three_points(report);
    return report.status();
}
