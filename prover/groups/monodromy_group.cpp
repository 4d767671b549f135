#include "prover/groups/monodromy_group.h"

#include "prover/groups/blocks.h"
#include "prover/groups/jordan.h"
#include "prover/groups/stabilizer_chain.h"

#include <algorithm>
#include <sstream>
#include <utility>

namespace plprove {

namespace {

using Kind = GroupStep::Kind;

void multiply(Factored& product, int number, int exponent) {
    for (int prime = 2; number > 1; ++prime)
        for (; number % prime == 0; number /= prime)
            if ((product[prime] += exponent) == 0) product.erase(prime);
}

Factored factorial(int number) {
    Factored result;
    for (int i = 2; i <= number; ++i)
        multiply(result, i, 1);
    return result;
}

void multiply(Factored& product, const Factored& factor, int exponent) {
    for (const auto& [prime, power] : factor)
        if ((product[prime] += power * exponent) == 0) product.erase(prime);
}

/// Whether a transitive group has all even permutations, because some have a cycle of prime length
/// (Jordan). If it has, a search is in vain once in 10,000 times.
bool contains_alternating(const std::vector<Permutation>& generators) {
    constexpr int tries = 100;
    RandomElements elements(generators);
    const int degree = static_cast<int>(generators.front().size());
    for (int i = 0; i < tries; ++i)
        for (const int length : cycle_type(elements.next()))
            if (shows_alternating(degree, length)) return true;
    return false;
}

Kind kind_of_natural(const std::vector<Permutation>& generators) {
    return std::ranges::all_of(generators, is_even) ? Kind::alternating : Kind::symmetric;
}

/// Of the group that the permutations generate.
Factored order_of(const std::vector<Permutation>& generators) {
    Factored result;
    for (const int length : StabilizerChain(generators).orbit_lengths())
        multiply(result, length, 1);
    return result;
}

/// Of a primitive group.
Kind kind_of(const std::vector<Permutation>& generators) {
    const int degree = static_cast<int>(generators.front().size());
    constexpr int small = 8; // no cycle need show it
    if (degree > small)
        return contains_alternating(generators) ? kind_of_natural(generators) : Kind::other;
    Factored rest = factorial(degree);
    multiply(rest, order_of(generators), -1);
    const bool is_natural = rest.empty() || rest == Factored{{2, 1}};
    return is_natural ? kind_of_natural(generators) : Kind::other;
}

/// How some permutations of the group that keep the first block permute its points.
std::vector<Permutation> within_first_block(const std::vector<Permutation>& generators,
                                            const BlockSystem& system) {
    constexpr int wanted = 12;
    std::vector<std::size_t> points;
    std::vector<int> place(system.block_of.size(), 0);
    for (std::size_t i = 0; i < place.size(); ++i)
        if (system.block_of[i] == 0) {
            place[i] = static_cast<int>(points.size());
            points.push_back(i);
        }
    // For each block a permutation that takes it to the first one.
    std::vector<Permutation> back(as_index(system.blocks));
    RandomElements elements(generators);
    std::vector<Permutation> result;
    while (std::ssize(result) < wanted) {
        Permutation element = elements.next();
        const std::size_t block = as_index(system.block_of[as_index(element[points.front()])]);
        if (block != 0 && back[block].empty()) {
            back[block] = inverse(element);
            continue;
        }
        if (block != 0) element = then(element, back[block]);
        Permutation& inside = result.emplace_back();
        for (const std::size_t point : points)
            inside.push_back(place[as_index(element[point])]);
    }
    return result;
}

char letter(Kind kind) {
    if (kind == Kind::symmetric) return 'S';
    return kind == Kind::alternating ? 'A' : 'G';
}

void write(std::ostream& out, const Factored& number) {
    const char* before = "";
    for (const auto& [prime, power] : number) {
        out << std::exchange(before, "*") << prime;
        if (power != 1) out << '^' << power;
    }
}

} // namespace

int MonodromyGroup::degree() const {
    int result = 1;
    for (const GroupStep& step : steps)
        result *= step.solutions;
    return result;
}

bool MonodromyGroup::is_symmetric() const {
    return steps.size() == 1 && steps.front().kind == Kind::symmetric;
}

std::string MonodromyGroup::name() const {
    const bool whole = std::ranges::all_of(steps, [](const GroupStep& step) {
        const bool even =
            step.kind == Kind::alternating && step.index == Factored{{2, step.copies}};
        return even || (step.kind == Kind::symmetric && step.index.empty());
    });
    std::ostringstream out;
    const char* before = whole ? "" : "<";
    for (auto step = steps.rbegin(); step != steps.rend(); ++step)
        out << std::exchange(before, " wr ") << letter(step->kind) << step->solutions;
    return out.str();
}

std::string MonodromyGroup::order() const {
    std::ostringstream out;
    const char* before = "";
    Factored index;
    for (auto step = steps.rbegin(); step != steps.rend(); ++step) {
        out << std::exchange(before, "*") << step->solutions << '!';
        if (step->copies > 1) out << '^' << step->copies;
        multiply(index, step->index, 1);
    }
    if (index.empty()) return out.str();
    const bool is_product = index.size() > 1;
    out << (is_product ? "/(" : "/");
    write(out, index);
    out << (is_product ? ")" : "");
    return out.str();
}

int MonodromyGroup::width() const {
    int result = 1;
    for (const GroupStep& step : steps) {
        Factored all;
        multiply(all, factorial(step.solutions), step.copies);
        if (step.index == all) continue; // the steps before solve it, too
        // Four solutions take a cubic equation and square roots.
        result = std::max(result, step.solutions == 4 ? 3 : step.solutions);
    }
    return result;
}

MonodromyGroup monodromy_group(const std::vector<Permutation>& generators) {
    if (generators.front().size() == 1) return {{{1, 1, Kind::symmetric, {}}}};
    MonodromyGroup result;
    std::vector<Permutation> moved = generators;
    std::vector<Factored> orders;
    while (moved.front().size() > 1) {
        const BlockSystem system = least_blocks(moved);
        GroupStep& step = result.steps.emplace_back();
        const bool is_last = system.blocks == 1;
        step.solutions = is_last ? static_cast<int>(moved.front().size()) : system.block_size();
        step.copies = system.blocks;
        step.kind = kind_of(is_last ? moved : within_first_block(moved, system));
        if (is_last && step.kind != Kind::other) {
            orders.push_back(factorial(step.solutions));
            if (step.kind == Kind::alternating) multiply(orders.back(), 2, -1);
        } else {
            orders.push_back(order_of(moved));
        }
        moved = on_blocks(moved, system);
    }
    orders.emplace_back();
    for (std::size_t i = 0; i < result.steps.size(); ++i) {
        GroupStep& step = result.steps[i];
        multiply(step.index, factorial(step.solutions), step.copies);
        multiply(step.index, orders[i], -1);
        multiply(step.index, orders[i + 1], 1);
    }
    std::ranges::reverse(result.steps);
    return result;
}

bool shows_alternating(const std::vector<Permutation>& generators) {
    return is_transitive(generators) && contains_alternating(generators);
}

std::vector<Permutation> loops_of_edges(const std::vector<Permutation>& bijections) {
    std::vector<Permutation> result;
    for (std::size_t i = 1; i < bijections.size(); ++i)
        result.push_back(then(bijections.front(), inverse(bijections[i])));
    return result;
}

std::optional<MonodromyGroup> symmetric_group_of_edges(const std::vector<Permutation>& bijections) {
    constexpr int fewest = 4;
    if (std::ssize(bijections) < fewest) return std::nullopt;
    for (std::size_t left_out = 0; left_out < bijections.size(); ++left_out) {
        std::vector<Permutation> others = bijections;
        others.erase(others.begin() + static_cast<std::ptrdiff_t>(left_out));
        const std::vector<Permutation> loops = loops_of_edges(others);
        if (std::ranges::all_of(loops, is_even) || !shows_alternating(loops)) return std::nullopt;
    }
    const int degree = static_cast<int>(bijections.front().size());
    return MonodromyGroup{{{degree, 1, Kind::symmetric, {}}}};
}

} // namespace plprove
