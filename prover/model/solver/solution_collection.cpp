#include "prover/model/solver/solution_collection.h"

#include <algorithm>

namespace plprove::model {

namespace {

constexpr double near_of_refined = 1e-7;

bool all_real(const Numbers& numbers) {
    return std::ranges::all_of(numbers, [](const auto& z) { return z.imag() == 0; });
}

/// The solution itself, if it is real: without the imaginary parts that rounding gives it.
std::optional<Numbers> real_one(const Program& program, const Numbers& data,
                                const Numbers& solution) {
    constexpr double tiny = 1e-7;
    Numbers real;
    for (const std::complex<double>& z : solution) {
        if (!(std::abs(z.imag()) < tiny * (1 + std::abs(z)))) return std::nullopt;
        real.emplace_back(z.real());
    }
    auto point = refined(program, data, real);
    if (!point || !approximates(*point, solution, near_at_path_ends)) return std::nullopt;
    for (std::complex<double>& z : *point)
        z = z.real();
    return point;
}

std::vector<double> parts(const Numbers& numbers) {
    std::vector<double> result;
    for (const std::complex<double>& z : numbers)
        result.insert(result.end(), {z.real(), z.imag()});
    return result;
}

} // namespace

Numbers conjugate(Numbers numbers) {
    for (std::complex<double>& z : numbers)
        z = std::conj(z);
    return numbers;
}

SolutionSet<Numbers> no_solutions() {
    return SolutionSet<Numbers>(near_of_refined, Nearness::of_coordinates);
}

SolutionCollection::SolutionCollection(const Program& program, const Numbers& data)
    : program_(program), data_(data), real_data_(all_real(data)), known_(no_solutions()) {}

void SolutionCollection::add(const Numbers& approximation) {
    const auto solution = refined(program_, data_, approximation);
    if (!solution || !keeps_conditions(program_, data_, *solution)) return;
    const auto real = real_data_ ? real_one(program_, data_, *solution) : std::nullopt;
    add_new(real ? *real : *solution, real.has_value());
    if (real_data_ && !real) add_new(conjugate(*solution), false);
}

void SolutionCollection::follow(const Start& start, const TrackedEquations& equations,
                                std::uint64_t seed, unsigned threads) {
    constexpr int most_ways = 4;
    constexpr std::uint64_t stream = 1; // another one than that of monodromy
    Random random(seed, stream);
    Numbers bend(data_.size());
    for (int way = 0; way < most_ways && found_.size() < start.solutions.size(); ++way) {
        const Care care = way == 0 ? Care::usual : Care::careful;
        for (const auto& end :
             follow_all(equations, {start.data, data_, bend}, start.solutions, care, threads))
            if (end) add(*end);
        bend = random_numbers(data_.size(), Field::complex, random);
    }
}

std::vector<ModelSolution> SolutionCollection::counted() && {
    std::ranges::stable_sort(found_, [](const ModelSolution& a, const ModelSolution& b) {
        return a.real != b.real ? a.real : parts(a.unknowns) < parts(b.unknowns);
    });
    SolutionSet<Numbers> seen = no_solutions();
    std::vector<ModelSolution> result;
    for (ModelSolution& solution : found_) {
        const Numbers what_counts = counted_by(solution.unknowns);
        if (seen.find(what_counts)) continue;
        seen.add(what_counts);
        result.push_back(std::move(solution));
    }
    return result;
}

void SolutionCollection::add_new(const Numbers& solution, bool real) {
    if (known_.find(solution)) return;
    known_.add(solution);
    found_.push_back({solution, real, residual_of(program_, data_, solution)});
}

Numbers SolutionCollection::counted_by(const Numbers& unknowns) const {
    return counted_values(program_, data_, unknowns).value_or(unknowns);
}

} // namespace plprove::model
