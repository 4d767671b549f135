#include "prover/model/solver/random_solutions.h"

namespace plprove::model {

Numbers random_numbers(std::size_t count, Field field, Random& random) {
    Numbers numbers;
    for (std::size_t i = 0; i < count; ++i)
        numbers.push_back(random.number(field));
    return numbers;
}

std::optional<SolvedData> random_solution(const Program& program, Field field, Random& random) {
    // For seven lines through a point, 40 were too few for one seed of three.
    constexpr int most_attempts = 400;
    for (int attempt = 0; attempt < most_attempts; ++attempt) {
        SolvedData near;
        near.unknowns = random_numbers(program.unknowns, field, random);
        near.data = random_numbers(program.data, field, random);
        if (auto solved = solved_for_data(program, near)) return solved;
    }
    return std::nullopt;
}

} // namespace plprove::model
