#include "prover/model/solver/lifted_fibre.h"

#include "prover/model/gradient_ring.h"
#include "prover/model/lifting/eliminant.h"
#include "prover/model/solver/solution_collection.h"
#include "prover/system/exit.h"
#include "prover/system/words.h"

#include <algorithm>
#include <array>
#include <stdexcept>

namespace plprove::model {

namespace {

/// Runs programs on numbers with many digits, without derivatives.
class DigitRing {
public:
    using Scalar = BigComplex;

    DigitRing(const ManyDigits& digits, const std::vector<BigComplex>& data,
              const std::vector<BigComplex>& unknowns)
        : digits_(digits), data_(data), unknowns_(unknowns) {}

    Scalar constant(int value) const { return digits_.constant(value); }
    Scalar zero() const { return constant(0); }
    Scalar datum(std::size_t index) const { return data_[index]; }
    Scalar unknown(std::size_t index) const { return unknowns_[index]; }
    Scalar sum(const Scalar& a, const Scalar& b) const { return digits_.sum(a, b); }
    Scalar difference(const Scalar& a, const Scalar& b) const { return digits_.difference(a, b); }
    Scalar product(const Scalar& a, const Scalar& b) const { return digits_.product(a, b); }
    Scalar quotient(const Scalar& a, const Scalar& b, const Operation& /*which*/) const {
        return product(a, digits_.inverse(b));
    }

private:
    const ManyDigits& digits_;
    const std::vector<BigComplex>& data_;
    const std::vector<BigComplex>& unknowns_;
};

/// The equations of a model for integer data.
class ProgramDigits : public DigitEquations {
public:
    ProgramDigits(const Program& program, const std::vector<int>& data)
        : program_(program), wanted_(scalars_of(program.equations)) {
        for (const int value : data)
            acb_set_si(data_.emplace_back().get(), value);
    }

    std::vector<BigComplex> values(const Point& point, const ManyDigits& digits) const override {
        DigitRing ring(digits, data_, point);
        const auto scalars = evaluate(program_, ring, wanted_);
        std::vector<BigComplex> result;
        for (const ScalarIndex scalar : wanted_)
            result.push_back(scalars[scalar]);
        return result;
    }

    std::vector<std::vector<BigComplex>> slopes(const Point& point,
                                                const ManyDigits& digits) const override {
        GradientRing<ManyDigits> ring(digits, data_, point);
        const auto scalars = evaluate(program_, ring, wanted_);
        std::vector<std::vector<BigComplex>> result;
        for (const ScalarIndex scalar : wanted_) {
            result.emplace_back(program_.unknowns);
            for (const auto& [unknown, slope] : scalars[scalar].gradient)
                result.back()[unknown] = slope;
        }
        return result;
    }

private:
    const Program& program_;
    std::vector<ScalarIndex> wanted_;
    std::vector<BigComplex> data_;
};

/// Of each pair of conjugate solutions one.
std::vector<RefinedSolution> approximations(const std::vector<ModelSolution>& solutions) {
    std::vector<RefinedSolution> result;
    SolutionSet<Numbers> kept = no_solutions();
    for (const ModelSolution& solution : solutions) {
        if (!solution.real && kept.find(conjugate(solution.unknowns))) continue;
        kept.add(solution.unknowns);
        RefinedSolution& refined = result.emplace_back(RefinedSolution{solution.real, {}});
        for (const std::complex<double>& z : solution.unknowns)
            acb_set_d_d(refined.coordinates.emplace_back().get(), z.real(), z.imag());
    }
    return result;
}

/// Integers other than 0, of absolute values up to the bound.
std::vector<int> random_integers(RandomResidues& random, std::size_t count, int bound) {
    std::vector<int> result;
    while (result.size() < count)
        if (const int integer = random.integer(bound); integer != 0) result.push_back(integer);
    return result;
}

/// The fibre of the solutions for these data.
FibreSearch fibre_of_solutions(const Program& program, const std::vector<int>& data,
                               const std::vector<ModelSolution>& solutions, RandomResidues& random,
                               const LiftOptions& options) {
    constexpr int largest_factor = 3;
    // Where solutions are missing, no digits suffice: let that show within hours.
    constexpr slong most_bits = 2'000'000, most_in_all = 400'000'000;
    const std::vector<int> form = random_integers(random, program.unknowns, largest_factor);
    const ProgramDigits equations(program, data);
    try {
        auto exact =
            exact_solutions(Refinement(equations, approximations(solutions)), {form},
                            std::min(most_bits, most_in_all / std::ssize(solutions)), options.bits);
        if (!exact)
            return {{},
                    "the coefficients of a fibre have too many digits, or paths did not find "
                    "all solutions"};
        return fibre_of(program, {data.begin(), data.end()}, form, std::move(exact->solutions),
                        random);
    } catch (const std::runtime_error& error) {
        return {{}, error.what()};
    }
}

} // namespace

FibreSearch lifted_fibre(const Model& model, const Program& program, const LiftOptions& options) {
    // Small numbers make small coefficients, but may be special: solutions are then missing.
    constexpr std::array bounds{2, 4, 9, 30, 99};
    constexpr std::uint64_t stream = 5;
    if (program.data == 0) return {{}, "there are no data that could move solutions to others"};
    const TrackedEquations equations(program);
    Start start;
    try {
        start = find_start(program, equations, {0, options.threads, 0, options.found});
    } catch (const BadInput& error) {
        return {{}, error.what()};
    }
    RandomResidues random(model, stream);
    std::size_t found = 0;
    for (const int bound : bounds) {
        const std::vector<int> data = random_integers(random, program.data, bound);
        const Numbers numbers(data.begin(), data.end());
        SolutionCollection solutions(program, numbers);
        solutions.follow(start, equations, 0, options.threads);
        found = solutions.all().size();
        if (found == start.solutions.size())
            return fibre_of_solutions(program, data, solutions.all(), random, options);
    }
    return {{},
            counted(start.solutions.size(), "solution") + " for random complex data, but " +
                std::to_string(found) + " for integer data"};
}

} // namespace plprove::model
