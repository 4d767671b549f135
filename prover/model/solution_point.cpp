#include "prover/model/solution_point.h"

#include "prover/model/total_degree.h"

#include <algorithm>
#include <cmath>

namespace plprove::model {

namespace {

/// The points are rational functions of random residues whose numerators and denominators have at
/// most the sum s of the degrees of the equations (Cramer's rule). So a minor of the Jacobian has a
/// numerator of degree s (s + 1) at most, and vanishes at a random point with a probability of at
/// most that over q, unless it is 0 (Schwartz and Zippel).
std::size_t digits_of_chance(const Program& program, std::size_t solutions) {
    const auto degrees = static_cast<double>(sum_of_degrees(program));
    const double digits = std::log10(static_cast<double>(modulus) / (degrees * (degrees + 1)));
    return static_cast<std::size_t>(std::max(0., static_cast<double>(solutions) * digits));
}

Fibre fibre_of(const Program& program, const Point<Modular>& point, RandomResidues& random) {
    constexpr int bound = 999;
    Fibre fibre;
    fibre.data = point.data;
    Modular t;
    for (const Modular value : point.unknowns) {
        fibre.unknowns.push_back(Univariate({value}));
        fibre.form.push_back(random.integer(bound));
        t = t + Modular(fibre.form.back()) * value;
    }
    fibre.polynomial = Univariate({-t, Modular(1)});
    if (!program.counts) return fibre;
    fibre.distinct = 1;
    for (std::size_t i = 0; i < program.counted.size(); ++i)
        fibre.counted_form.push_back(random.integer(bound));
    return fibre;
}

} // namespace

PointSearch find_solution_point(const Model& model, const Program& program) {
    constexpr std::uint64_t stream = 4;
    RandomResidues random(model, stream);
    PointsSeen<Modular> seen = search_points<Modular>(program, random);
    if (seen.best && seen.rank_of_best == program.unknowns)
        return {fibre_of(program, *seen.best, random), {}};
    seen.ranks.digits = digits_of_chance(program, seen.ranks.solutions);
    return {std::nullopt, seen.ranks};
}

} // namespace plprove::model
