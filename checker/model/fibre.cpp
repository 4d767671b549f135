#include "checker/model/fibre.h"

#include "checker/model/dual_extension.h"

namespace checker {
ModelFibre read_fibre(Reader& reader, const Layout& layout) {
    ModelFibre fibre;
    const std::size_t degree = read_fibre_degree(reader);
    fibre.data = read_residue_line(reader, "data", layout.data.scalars);
    fibre.solutions = read_fibre(reader, degree, layout.unknowns.scalars, layout.unknowns.scalars);
    fibre.distinct = degree;
    if (layout.counted > 0) {
        reader.take("distinct");
        fibre.distinct = static_cast<std::size_t>(reader.integer(1, static_cast<int>(degree)));
        reader.take("by");
        fibre.distinct_by = read_numbers(reader, layout.counted);
        reader.end_line();
    }
    return fibre;
}

std::uint64_t effort_of(const Layout& layout, const ModelFibre& fibre) {
    const std::uint64_t unknowns = layout.unknowns.scalars, degree = fibre.solutions.lower.size();
    const std::uint64_t products = layout.multiplications * (2 * unknowns + 1) +
                                   unknowns * unknowns * unknowns +
                                   (layout.counted > 0 ? degree + layout.counted : 0);
    return 1 + products * degree * degree / 100'000;
}

static Given<DualExtension> values_at(const DualExtension& ring, const Extension& extension,
                                      const Layout& layout, const ModelFibre& fibre) {
    Given<DualExtension> given;
    std::size_t next = 0;
    for (const auto& [name, size] : layout.data.names)
        for (std::size_t i = 0; i < size; ++i)
            given[name].push_back({extension.constant(fibre.data[next++]), {}});
    next = 0;
    for (const auto& [name, size] : layout.unknowns.names)
        for (std::size_t i = 0; i < size; ++i, ++next)
            given[name].push_back(ring.unknown(fibre.solutions.unknowns[next], next));
    return given;
}

static Polynomial distinct_values(const Extension& extension, const Outcome<DualExtension>& outcome,
                                  const ModelFibre& fibre) {
    std::vector<Polynomial> values;
    for (const Fraction<DualExtension::Element>& scalar : outcome.counted) {
        Polynomial value = scalar.numerator.value;
        for (const auto& [divisor, power] : scalar.denominator)
            for (int i = 0; i < power; ++i)
                value =
                    extension.multiply(value, *extension.inverse(outcome.divisors[divisor].value));
        values.push_back(std::move(value));
    }
    const Polynomial tau = combination_of(extension, fibre.distinct_by, values);
    Polynomial values_that_count = minimal_polynomial(extension, tau, fibre.distinct);
    if (!values_that_count.empty() && values_that_count.size() < fibre.distinct)
        throw Refused("the values that count are not proved to be ", fibre.distinct,
                      " different ones");
    return values_that_count;
}

Polynomial check_fibre(const Program& program, const Layout& layout, const ModelFibre& fibre) {
    const std::size_t unknowns = layout.unknowns.scalars;
    if (layout.equations != unknowns)
        throw Refused("the model has ", layout.equations, " equations for ", unknowns,
                      " unknowns: a fibre needs as many");
    const Extension extension(fibre.solutions.lower);
    require_separate_solutions(extension, fibre.solutions);
    DualExtension ring(extension);
    const Given<DualExtension> given = values_at(ring, extension, layout, fibre);
    const Outcome<DualExtension> outcome = Machine<DualExtension>(ring, given).run(program);
    std::vector<std::vector<Polynomial>> jacobian;
    for (std::size_t i = 0; i < unknowns; ++i) {
        if (!is_zero(outcome.equations[i].value)) throw Refused("equation ", i + 1, " is not 0");
        jacobian.push_back(outcome.equations[i].change);
        jacobian.back().resize(unknowns, extension.constant({}));
    }
    for (std::size_t i = 0; i < outcome.conditions.size(); ++i)
        if (!extension.is_unit(outcome.conditions[i].value))
            throw Refused("condition ", i + 1, " has a common factor with g");
    if (!is_regular(extension, std::move(jacobian))) throw Refused("the Jacobian has no inverse");
    return layout.counted > 0 ? distinct_values(extension, outcome, fibre) : fibre.solutions.lower;
}
} // namespace checker
