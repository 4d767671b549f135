#include "prover/model/fibre.h"

#include "prover/model/fields.h"
#include "prover/model/gradient_ring.h"
#include "prover/model/groebner.h"
#include "prover/model/polynomial_ring.h"
#include "prover/model/quotient.h"

#include <algorithm>
#include <array>

namespace plprove::model {

namespace {

/// The most solutions of a fibre that the format allows.
constexpr std::size_t most_solutions = 10'000;

/// Which conditions are made equations, each with a variable for an inverse, so that what violates
/// them is no solution. Divisors are such conditions always.
enum class Saturation : std::uint8_t { divisors, one, all };

/// The equations of a model with fixed data, ready for a Gröbner basis.
struct System {
    std::vector<Polynomial> polynomials;
    std::size_t variables = 0;
};

System system_of(const Program& program, std::span<const Modular> data, Saturation saturation) {
    PolynomialRing ring(data, program.unknowns);
    std::vector<ScalarIndex> wanted = scalars_of(program.equations);
    for (const ScalarIndex scalar : scalars_of(program.conditions))
        wanted.push_back(scalar);
    const auto values = evaluate(program, ring, wanted);
    System system;
    for (const Located& equation : program.equations)
        system.polynomials.push_back(values[equation.scalar]);
    Polynomial product{Modular(1)};
    std::vector<Polynomial> factors;
    for (const Located& condition : program.conditions) {
        const Polynomial& value = values[condition.scalar];
        if (value.is_zero()) throw TooLarge("a condition of the model never holds");
        if (saturation == Saturation::all) ring.inverse(value);
        if (std::ranges::find(factors, value) != factors.end() || value.is_constant()) continue;
        factors.push_back(value);
    }
    if (saturation == Saturation::one) {
        for (const Polynomial& factor : factors)
            product = product * factor;
        ring.inverse(product);
    }
    for (const Polynomial& equation : ring.equations_of_inverses())
        system.polynomials.push_back(equation);
    system.variables = ring.variables();
    return system;
}

/// The solutions of multiplicity 1 of the equations, perhaps some more where conditions fail.
std::optional<Solutions> solutions_of(const System& system, const std::vector<int>& form,
                                      const GroebnerLimits& limits) {
    return solutions_of(groebner_basis(system.polynomials, limits), system.variables, form,
                        most_solutions);
}

using Ring = GradientRing<Algebra>;

/// The solutions at roots of a factor of g.
void restrict(Solutions& solutions, const Univariate& factor) {
    const Algebra algebra(factor);
    for (Univariate& unknown : solutions.unknowns)
        unknown = algebra.reduced(unknown);
    solutions.polynomial = factor;
}

std::vector<Univariate> constants(std::span<const Modular> data) {
    std::vector<Univariate> result;
    for (const Modular value : data)
        result.push_back(Univariate({value}));
    return result;
}

/// Runs the program at the solutions.
std::vector<Ring::Scalar> run(const Program& program, const Algebra& algebra,
                              std::span<const Modular> data, const Solutions& solutions,
                              const std::vector<ScalarIndex>& wanted) {
    Ring ring(algebra, constants(data), solutions.unknowns);
    return evaluate(program, ring, wanted);
}

/// Leaves out the solutions where a condition fails.
void keep_conditions(const Program& program, std::span<const Modular> data, Solutions& solutions) {
    const std::vector<ScalarIndex> wanted = scalars_of(program.conditions);
    const auto values = run(program, Algebra(solutions.polynomial), data, solutions, wanted);
    for (const ScalarIndex scalar : wanted) {
        const Algebra algebra(solutions.polynomial);
        restrict(solutions, algebra.without_common_factors(algebra.reduced(values[scalar].value)));
    }
}

/// Leaves out the solutions where the Jacobian is singular. False if an equation does not hold.
bool keep_regular(const Program& program, std::span<const Modular> data, Solutions& solutions) {
    const Algebra algebra(solutions.polynomial);
    const std::vector<ScalarIndex> wanted = scalars_of(program.equations);
    const auto values = run(program, algebra, data, solutions, wanted);
    std::vector<std::vector<Univariate>> jacobian;
    for (const ScalarIndex scalar : wanted) {
        if (!values[scalar].value.is_zero()) return false;
        jacobian.emplace_back(program.unknowns);
        for (const auto& [unknown, slope] : values[scalar].gradient)
            jacobian.back()[unknown] = slope;
    }
    restrict(solutions, algebra.without_common_factors(determinant(algebra, jacobian)));
    return true;
}

/// The minimal polynomial of x modulo g, or one whose roots are their inverses.
Univariate minimal_polynomial(const Algebra& algebra, const Univariate& x, RandomResidues& random) {
    const std::size_t degree = algebra.polynomial().degree();
    std::vector<Modular> sequence;
    Univariate power = algebra.constant(1);
    const std::vector<Modular> function = random.residues(degree); // linear
    for (std::size_t i = 0; i < 2 * degree; ++i) {
        Modular value;
        for (std::size_t k = 0; k < degree; ++k)
            value = value + function[k] * power.coefficient(k);
        sequence.push_back(value);
        power = algebra.product(power, x);
    }
    return recurrence_of(sequence);
}

std::vector<int> random_form(RandomResidues& random, std::size_t count) {
    constexpr int bound = 999;
    std::vector<int> form(count);
    for (int& coefficient : form)
        coefficient = random.integer(bound);
    return form;
}

void count_distinct(const Program& program, RandomResidues& random, Fibre& fibre) {
    fibre.values = fibre.polynomial;
    if (!program.counts) return;
    const Algebra algebra(fibre.polynomial);
    const Solutions solutions{fibre.polynomial, fibre.unknowns};
    const auto values = run(program, algebra, fibre.data, solutions, program.counted);
    fibre.counted_form = random_form(random, program.counted.size());
    Univariate sum;
    for (std::size_t i = 0; i < program.counted.size(); ++i)
        sum = Algebra::sum(sum, algebra.product(algebra.constant(fibre.counted_form[i]),
                                                values[program.counted[i]].value));
    fibre.values = minimal_polynomial(algebra, sum, random);
    fibre.distinct = fibre.values.degree();
}

/// One way to find the solutions.
struct Attempt {
    Saturation saturation;
    std::size_t operations;
};

FibreSearch search(const Program& program, RandomResidues& random, const Attempt& attempt) {
    std::vector<Modular> data = random.residues(program.data);
    std::vector<int> form = random_form(random, program.unknowns);
    GroebnerLimits limits;
    limits.operations = attempt.operations;
    auto solutions = solutions_of(system_of(program, data, attempt.saturation), form, limits);
    if (!solutions) return {{}, "the equations have no solutions, or infinitely many"};
    return fibre_of(program, std::move(data), std::move(form), std::move(*solutions), random);
}

} // namespace

FibreSearch find_fibre(const Model& model, const Program& program, std::uint64_t stream) {
    constexpr std::array attempts{
        Attempt{Saturation::divisors, 300'000'000}, Attempt{Saturation::one, 3'000'000'000},
        Attempt{Saturation::all, 20'000'000'000}, Attempt{Saturation::divisors, 20'000'000'000}};
    FibreSearch result;
    for (const Attempt& attempt : attempts) {
        RandomResidues random(model, stream);
        try {
            result = search(program, random, attempt);
        } catch (const TooLarge& error) {
            result = {{}, error.what()};
        }
        if (result.fibre) break;
    }
    return result;
}

FibreSearch fibre_of(const Program& program, std::vector<Modular> data, std::vector<int> form,
                     Solutions solutions, RandomResidues& random) {
    if (solutions.polynomial.degree() > 0) keep_conditions(program, data, solutions);
    if (solutions.polynomial.degree() > 0 && !keep_regular(program, data, solutions))
        return {{}, "the equations do not hold at the solutions that were found"};
    if (solutions.polynomial.degree() == 0)
        return {{}, "no solution keeps the conditions and is regular"};
    Fibre fibre;
    fibre.data = std::move(data);
    fibre.form = std::move(form);
    fibre.polynomial = std::move(solutions.polynomial);
    fibre.unknowns = std::move(solutions.unknowns);
    count_distinct(program, random, fibre);
    return {std::move(fibre), {}};
}

} // namespace plprove::model
