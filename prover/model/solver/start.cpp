#include "prover/model/solver/start.h"

#include "prover/system/exit.h"

namespace plprove::model {

StartSearch::StartSearch(const Program& program, const TrackedEquations& equations,
                         StartSettings settings)
    : program_(program), equations_(equations), settings_(std::move(settings)),
      random_(settings_.seed, 0), first_(first_solution()),
      monodromy_(
          DataLoops(program, equations, first_.data, random_, settings_.threads, settings_.bends),
          near_at_starts, [this](const MonodromyProgress& progress) {
              if (settings_.found) settings_.found(static_cast<std::size_t>(progress.solutions));
          }) {
    monodromy_.add(0, first_.unknowns);
}

/// Where solutions fall into parts that no loop joins, another solution may lead to another part.
void StartSearch::run() {
    const int attempts = settings_.known > 0 ? 40 : 6;
    follow_loops();
    for (int attempt = 0; attempt < attempts && !is_complete(); ++attempt)
        if (add_another()) follow_loops();
}

SolvedData StartSearch::first_solution() {
    auto solved = random_solution(program_, Field::complex, random_);
    if (!solved)
        throw BadInput("no data with a solution were found, where paths could begin: are "
                       "there too few data, or is no solution regular?");
    return std::move(*solved);
}

bool StartSearch::is_complete() const {
    const int first = monodromy_.solutions(0).size(), second = monodromy_.solutions(1).size();
    return settings_.known > 0 ? first >= static_cast<int>(settings_.known)
                               : std::max(first, second) > settings_.most_solutions;
}

void StartSearch::follow_loops() {
    constexpr int edges = 6, edges_of_few = 12, most_edges = 12;
    if (settings_.known > 0)
        monodromy_.reach(static_cast<int>(settings_.known), most_edges);
    else
        monodromy_.until_agreed({edges, edges_of_few, settings_.most_solutions, true});
}

/// Whether another random solution leads to one that is new.
bool StartSearch::add_another() {
    const auto other = random_solution(program_, Field::complex, random_);
    if (!other) return false;
    const Numbers bend = random_numbers(program_.data, Field::complex, random_);
    const auto ends = follow_all(equations_, {other->data, first_.data, bend}, {other->unknowns},
                                 Care::careful, 1);
    if (!ends[0] || monodromy_.solutions().find(*ends[0]) ||
        !keeps_conditions(program_, first_.data, *ends[0]))
        return false;
    monodromy_.add(0, *ends[0]);
    return true;
}

Start find_start(const Program& program, const TrackedEquations& equations,
                 const StartSettings& settings) {
    StartSearch search(program, equations, settings);
    search.run();
    return {search.data(), search.monodromy().solutions().points()};
}

} // namespace plprove::model
