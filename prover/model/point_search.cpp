#include "prover/model/point_search.h"

#include "prover/model/gradient_ring.h"
#include "prover/model/prime_field.h"
#include "prover/model/small_modular.h"
#include "prover/model/sparse_rows.h"

#include <algorithm>
#include <array>
#include <map>
#include <optional>
#include <type_traits>

namespace plprove::model {

namespace {

template <class Number>
constexpr Residue prime_of = std::is_same_v<Number, Modular> ? modulus : small_prime;

template <class Number>
Number drawn(RandomResidues& random) {
    if constexpr (std::is_same_v<Number, Modular>)
        return random.residue();
    else
        return Number(static_cast<std::int64_t>(random.bits() % small_prime));
}

template <class Number>
using Values = std::vector<typename GradientRing<PrimeFieldOf<Number>>::Scalar>;

/// Variables are numbered as in gradients: unknowns, then data.
template <class Number>
Number& at(Point<Number>& point, std::size_t variable) {
    const std::size_t unknowns = point.unknowns.size();
    return variable < unknowns ? point.unknowns[variable] : point.data[variable - unknowns];
}

template <class Number>
Values<Number> run(const Program& program, const Point<Number>& point, bool by_data) {
    const PrimeFieldOf<Number> field;
    GradientRing<PrimeFieldOf<Number>> ring(field, point.data, point.unknowns, by_data);
    std::vector<ScalarIndex> wanted = scalars_of(program.equations);
    for (const std::vector<ScalarIndex>& more : {scalars_of(program.conditions), program.counted})
        wanted.insert(wanted.end(), more.begin(), more.end());
    return evaluate(program, ring, wanted);
}

/// The data, by number, in a random order: those of one name together.
std::vector<std::size_t> random_order(const Program& program, RandomResidues& random) {
    const auto shuffle = [&](auto& list) {
        for (std::size_t i = list.size(); i > 1; --i)
            std::swap(list[i - 1], list[random.bits() % i]);
    };
    std::vector<Named> names = program.data_names;
    shuffle(names);
    std::vector<std::size_t> order;
    for (Named& named : names) {
        shuffle(named.value.scalars);
        for (const ScalarIndex scalar : named.value.scalars)
            order.push_back(program.operations[scalar].left);
    }
    return order;
}

/// One step of Newton's method for these equations, in those of the data that come first. False if
/// the equations do not depend enough on them.
template <class Number>
bool newton_step(const Program& program, Point<Number>& point,
                 const std::vector<ScalarIndex>& equations, const std::vector<std::size_t>& order) {
    const std::size_t data = order.size();
    std::map<std::size_t, std::uint32_t> place;
    for (std::size_t i = 0; i < data; ++i)
        place[order[i]] = static_cast<std::uint32_t>(i);
    const Values<Number> values = run(program, point, true);
    SparseRowsOf<Number> rows(data + 1); // the last column has the values
    for (const ScalarIndex scalar : equations) {
        std::vector<std::pair<std::uint32_t, Number>> entries;
        for (const auto& [variable, slope] : values[scalar].gradient) {
            if (variable < program.unknowns) continue;
            const auto found = place.find(variable - program.unknowns);
            if (found != place.end()) entries.emplace_back(found->second, slope);
        }
        std::ranges::sort(entries, {}, [](const auto& entry) { return entry.first; });
        entries.emplace_back(data, -values[scalar].value);
        SparseRowOf<Number> row;
        for (const auto& [column, entry] : entries) {
            if (entry.is_zero()) continue;
            row.columns.push_back(column);
            row.entries.push_back(entry);
        }
        if (row.empty()) continue;
        rows.reduce_and_add(row);
        if (rows.has_pivot(data)) return false;
    }
    // The data without pivots stay as they are: each pivot is corrected by its last entry.
    for (std::size_t column = 0; column < data; ++column) {
        if (!rows.has_pivot(column)) continue;
        SparseRowOf<Number> row = rows.reduce(rows.pivot(column), true);
        if (row.columns.back() != data) continue;
        Number& value = point.data[order[column]];
        value = value + row.entries.back();
    }
    return true;
}

/// Solves all equations at once for data in a random order.
template <class Number>
bool solve_for_data(const Program& program, Point<Number>& point, RandomResidues& random) {
    return newton_step(program, point, scalars_of(program.equations),
                       random_order(program, random));
}

/// A square root, if there is one: 4 divides the prime plus 1.
template <class Number>
std::optional<Number> square_root(Number x) {
    Number root(1), power = x;
    for (Residue exponent = (prime_of<Number> + 1) / 4; exponent > 0; exponent /= 2) {
        if (exponent % 2 == 1) root = root * power;
        power = power * power;
    }
    if (root * root == x) return root;
    return std::nullopt;
}

/// A root of the polynomial of degree at most 2 with these values at 0, 1, 2 and 3.
template <class Number>
std::optional<Number> root_of(const std::array<Number, 4>& values) {
    const auto& [e0, e1, e2, e3] = values;
    if (!(e3 - Number(3) * (e2 - e1) - e0).is_zero()) return std::nullopt;
    const Number half = Number(2).inverse();
    const Number a = (e2 - Number(2) * e1 + e0) * half, b = e1 - e0 - a;
    if (a.is_zero() && b.is_zero()) return std::nullopt;
    if (a.is_zero()) return -e0 * b.inverse();
    const auto root = square_root(b * b - Number(4) * a * e0);
    if (!root) return std::nullopt;
    return (*root - b) * half * a.inverse();
}

/// A value of one variable with which the equation holds, as far as it has degree 2 at most in it.
template <class Number>
std::optional<Number> root_in(const Program& program, ScalarIndex equation, Point<Number> point,
                              std::size_t variable) {
    std::array<Number, 4> samples;
    for (int i = 0; i < 4; ++i) {
        at(point, variable) = Number(i);
        samples[static_cast<std::size_t>(i)] = run(program, point, false)[equation].value;
    }
    return root_of(samples);
}

/// Solves one equation after the other, each for a variable from `first` on that is not in those
/// before. Leaves out equations without such variables. False if that does not lead to an end.
template <class Number>
bool solve_one_by_one(const Program& program, Point<Number>& point, std::size_t first,
                      RandomResidues& random) {
    constexpr int most_trials = 10;
    std::vector<bool> occurs(program.unknowns + program.data); // in equations that hold
    for (const ScalarIndex equation : scalars_of(program.equations)) {
        const Values<Number> values = run(program, point, true);
        std::vector<std::size_t> candidates;
        bool has_data = false;
        for (const auto& [variable, slope] : values[equation].gradient) {
            has_data = has_data || variable >= program.unknowns;
            if (variable >= first && !occurs[variable]) candidates.push_back(variable);
        }
        if (has_data != (first == program.unknowns)) continue;
        if (candidates.empty()) return false;
        bool solved = false;
        for (int trial = 0; trial < most_trials && !solved; ++trial) {
            const std::size_t chosen = candidates[random.bits() % candidates.size()];
            const auto root = root_in(program, equation, point, chosen);
            at(point, chosen) = root ? *root : drawn<Number>(random);
            solved = root.has_value();
        }
        if (!solved) return false;
        for (const auto& [variable, slope] : values[equation].gradient)
            occurs[variable] = true;
    }
    return true;
}

/// The data, by number, item by item of the lists that the model gives: the scalars of a vector
/// together.
std::vector<std::vector<std::size_t>> items_of_data(const Program& program) {
    std::vector<std::vector<std::size_t>> items;
    for (const Named& named : program.data_names) {
        const auto size = named.value.shape.empty()
                              ? std::size_t{1}
                              : static_cast<std::size_t>(named.value.shape.back());
        for (std::size_t i = 0; i < named.value.scalars.size(); ++i) {
            if (i % size == 0) items.emplace_back();
            items.back().push_back(program.operations[named.value.scalars[i]].left);
        }
    }
    return items;
}

/// Solves each equation for the item that comes last among its data, with the other equations of
/// this item: they are linear in it, if images are given one after the other. False if they are
/// not, or do not determine anything.
template <class Number>
bool solve_item_by_item(const Program& program, Point<Number>& point) {
    const std::vector<std::vector<std::size_t>> items = items_of_data(program);
    std::vector<std::size_t> item_of(program.data);
    for (std::size_t item = 0; item < items.size(); ++item)
        for (const std::size_t datum : items[item])
            item_of[datum] = item;
    std::vector<std::vector<ScalarIndex>> equations(items.size());
    const Values<Number> first = run(program, point, true);
    for (const ScalarIndex equation : scalars_of(program.equations)) {
        std::optional<std::size_t> last;
        for (const auto& [variable, slope] : first[equation].gradient)
            if (variable >= program.unknowns)
                last = std::max(last.value_or(0), item_of[variable - program.unknowns]);
        if (last) equations[*last].push_back(equation);
    }
    for (std::size_t item = 0; item < items.size(); ++item) {
        if (equations[item].empty()) continue;
        if (!newton_step(program, point, equations[item], items[item])) return false;
    }
    return true;
}

/// Whether the equations and conditions hold.
template <class Number>
bool is_solution(const Program& program, const Values<Number>& values) {
    const auto vanishes = [&](const Located& located) {
        return values[located.scalar].value.is_zero();
    };
    return std::ranges::all_of(program.equations, vanishes) &&
           std::ranges::none_of(program.conditions, vanishes);
}

/// The rank of the Jacobian by the unknowns.
template <class Number>
std::size_t rank_of(const Program& program, const Values<Number>& values) {
    SparseRowsOf<Number> jacobian(program.unknowns);
    std::size_t rank = 0;
    for (const Located& equation : program.equations) {
        SparseRowOf<Number> row;
        for (const auto& [variable, slope] : values[equation.scalar].gradient) {
            row.columns.push_back(static_cast<std::uint32_t>(variable));
            row.entries.push_back(slope);
        }
        if (!row.empty() && jacobian.reduce_and_add(row)) ++rank;
    }
    return rank;
}

} // namespace

template <class Number>
std::vector<Number> random_numbers(RandomResidues& random, std::size_t count) {
    std::vector<Number> result(count);
    for (Number& value : result)
        value = drawn<Number>(random);
    return result;
}

template <class Number>
PointsSeen<Number> search_points(const Program& program, RandomResidues& random) {
    constexpr int most_trials = 310, first_trials = 10;
    constexpr std::size_t most_seen = 10;
    const std::size_t largest_rank = std::min(program.equations.size(), program.unknowns);
    PointsSeen<Number> seen;
    for (int trial = 0; trial < most_trials; ++trial) {
        const bool by_items = trial < first_trials, linear = !by_items && trial % 2 == 0;
        if (linear && seen.ranks.solutions == most_seen) continue;
        Point<Number> point;
        point.data = random_numbers<Number>(random, program.data);
        point.unknowns = random_numbers<Number>(random, program.unknowns);
        const std::vector<Number> at_first = point.unknowns;
        try {
            // Equations without data are solved for unknowns.
            if (!solve_one_by_one(program, point, 0, random)) continue;
            const bool solved = by_items ? solve_item_by_item(program, point)
                                : linear
                                    ? solve_for_data(program, point, random)
                                    : solve_one_by_one(program, point, program.unknowns, random);
            if (!solved) continue;
            const Values<Number> values = run(program, point, false);
            if (!is_solution<Number>(program, values)) continue;
            const std::size_t rank = rank_of<Number>(program, values);
            if (!seen.best || rank > seen.rank_of_best) {
                seen.best = point;
                seen.rank_of_best = rank;
            }
            if (rank == largest_rank) break;
            if (!linear || point.unknowns != at_first) continue;
            ++seen.ranks.solutions;
            seen.ranks.rank = std::max(seen.ranks.rank, rank);
        } catch (const NotInvertible&) {
            continue;
        }
    }
    return seen;
}

template PointsSeen<Modular> search_points(const Program&, RandomResidues&);
template PointsSeen<SmallModular> search_points(const Program&, RandomResidues&);
template std::vector<SmallModular> random_numbers(RandomResidues&, std::size_t);

} // namespace plprove::model
