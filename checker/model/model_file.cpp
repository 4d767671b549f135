#include "checker/model/model_file.h"

#include "checker/model/elimination.h"

namespace checker {
/// About 0.2 ms each.
static constexpr std::uint64_t products_per_effort = 100'000;

ModelFile replay_model(Reader& reader, const Execution& execution) try {
    ModelFile file;
    const Program program = read_program(reader);
    const Layout layout = layout_of(program);
    file.name = program.name;
    file.text = program.text;
    file.claimed = program.claimed;
    reader.take("modulus 2305843009213693951 $");
    Records records(file.refusals, execution);
    if (layout.equations < layout.unknowns.scalars) { // no Jacobian has the rank that it should
        file.at_most = 0;
        ++file.records;
    }
    std::vector<Polynomial> values; // of each fibre: roots for the values that count
    while (!reader.at_end() && !reader.comes("elimination")) {
        const std::size_t line = reader.line();
        const ModelFibre fibre = read_fibre(reader, layout);
        records.replay(line, "a fibre: ", [&] {
            records.spend(effort_of(layout, fibre));
            values.push_back(check_fibre(program, layout, fibre));
            file.at_least = std::max(file.at_least, fibre.distinct);
            ++file.records;
        });
    }
    std::erase_if(values, [&](const Polynomial& h) { return h.size() != file.at_least; });
    file.cycle_types = cycle_types_of(values, [&](std::uint64_t effort) { records.spend(effort); });
    std::uint64_t products = 0;
    const auto spend = [&](std::uint64_t more) {
        products += more;
        records.spend(products / products_per_effort);
        products %= products_per_effort;
    };
    while (!reader.at_end()) {
        const std::size_t line = reader.line();
        const Elimination elimination = read_elimination(reader, layout);
        records.replay(line, "an elimination: ", [&] {
            records.spend(1);
            const std::size_t bound = check_elimination(program, layout, elimination, spend);
            file.at_most = std::min(file.at_most.value_or(bound), bound);
            ++file.records;
        });
    }
    return file;
} catch (const TooMuchEffort& too_much) {
    return {.refusals = too_much.refusals()};
}
} // namespace checker
