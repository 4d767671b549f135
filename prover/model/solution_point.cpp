#include "prover/model/solution_point.h"

#include "prover/model/fields.h"
#include "prover/model/gradient_ring.h"
#include "prover/model/sparse_rows.h"
#include "prover/model/total_degree.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

namespace plprove::model {

namespace {

using Ring = GradientRing<PrimeField>;
using Values = std::vector<Ring::Scalar>;

/// A point of the space of data and unknowns.
struct Point {
    std::vector<Modular> data, unknowns;

    /// Variables are numbered as in gradients: unknowns, then data.
    Modular& operator[](std::size_t variable) {
        return variable < unknowns.size() ? unknowns[variable] : data[variable - unknowns.size()];
    }
};

Values run(const Program& program, const Point& point, bool by_data) {
    const PrimeField field;
    Ring ring(field, point.data, point.unknowns, by_data);
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
bool newton_step(const Program& program, Point& point, const std::vector<ScalarIndex>& equations,
                 const std::vector<std::size_t>& order) {
    const std::size_t data = order.size();
    std::map<std::size_t, std::uint32_t> place;
    for (std::size_t i = 0; i < data; ++i)
        place[order[i]] = static_cast<std::uint32_t>(i);
    const Values values = run(program, point, true);
    SparseRows rows(data + 1); // the last column has the values
    for (const ScalarIndex scalar : equations) {
        std::vector<std::pair<std::uint32_t, Modular>> entries;
        for (const auto& [variable, slope] : values[scalar].gradient) {
            if (variable < program.unknowns) continue;
            const auto found = place.find(variable - program.unknowns);
            if (found != place.end()) entries.emplace_back(found->second, slope);
        }
        std::ranges::sort(entries, {}, [](const auto& entry) { return entry.first; });
        entries.emplace_back(data, -values[scalar].value);
        SparseRow row;
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
        SparseRow row = rows.reduce(rows.pivot(column), true);
        if (row.columns.back() != data) continue;
        Modular& value = point.data[order[column]];
        value = value + row.entries.back();
    }
    return true;
}

/// Solves all equations at once for data in a random order.
bool solve_for_data(const Program& program, Point& point, RandomResidues& random) {
    return newton_step(program, point, scalars_of(program.equations),
                       random_order(program, random));
}

/// A square root, if there is one: q + 1 is divisible by 4.
std::optional<Modular> square_root(Modular x) {
    constexpr int squarings = 59; // (q + 1)/4 = 2^59
    Modular root = x;
    for (int i = 0; i < squarings; ++i)
        root = root * root;
    if (root * root == x) return root;
    return std::nullopt;
}

/// A root of the polynomial of degree at most 2 with these values at 0, 1, 2 and 3.
std::optional<Modular> root_of(const std::array<Modular, 4>& values) {
    const auto& [e0, e1, e2, e3] = values;
    if (!(e3 - Modular(3) * (e2 - e1) - e0).is_zero()) return std::nullopt;
    const Modular half = Modular(2).inverse();
    const Modular a = (e2 - Modular(2) * e1 + e0) * half, b = e1 - e0 - a;
    if (a.is_zero() && b.is_zero()) return std::nullopt;
    if (a.is_zero()) return -e0 * b.inverse();
    const auto root = square_root(b * b - Modular(4) * a * e0);
    if (!root) return std::nullopt;
    return (*root - b) * half * a.inverse();
}

/// A value of one variable with which the equation holds, as far as it has degree 2 at most in it.
std::optional<Modular> root_in(const Program& program, ScalarIndex equation, Point point,
                               std::size_t variable) {
    std::array<Modular, 4> samples;
    for (int i = 0; i < 4; ++i) {
        point[variable] = Modular(i);
        samples[static_cast<std::size_t>(i)] = run(program, point, false)[equation].value;
    }
    return root_of(samples);
}

/// Solves one equation after the other, each for a variable from `first` on that is not in those
/// before. Leaves out equations without such variables. False if that does not lead to an end.
bool solve_one_by_one(const Program& program, Point& point, std::size_t first,
                      RandomResidues& random) {
    constexpr int most_trials = 10;
    std::vector<bool> occurs(program.unknowns + program.data); // in equations that hold
    for (const ScalarIndex equation : scalars_of(program.equations)) {
        const Values values = run(program, point, true);
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
            point[chosen] = root ? *root : random.residue();
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
bool solve_item_by_item(const Program& program, Point& point) {
    const std::vector<std::vector<std::size_t>> items = items_of_data(program);
    std::vector<std::size_t> item_of(program.data);
    for (std::size_t item = 0; item < items.size(); ++item)
        for (const std::size_t datum : items[item])
            item_of[datum] = item;
    std::vector<std::vector<ScalarIndex>> equations(items.size());
    const Values first = run(program, point, true);
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
bool is_solution(const Program& program, const Values& values) {
    const auto vanishes = [&](const Located& located) {
        return values[located.scalar].value.is_zero();
    };
    return std::ranges::all_of(program.equations, vanishes) &&
           std::ranges::none_of(program.conditions, vanishes);
}

/// The rank of the Jacobian by the unknowns.
std::size_t rank_of(const Program& program, const Values& values) {
    SparseRows jacobian(program.unknowns);
    std::size_t rank = 0;
    for (const Located& equation : program.equations) {
        SparseRow row;
        for (const auto& [variable, slope] : values[equation.scalar].gradient) {
            row.columns.push_back(static_cast<std::uint32_t>(variable));
            row.entries.push_back(slope);
        }
        if (!row.empty() && jacobian.reduce_and_add(row)) ++rank;
    }
    return rank;
}

/// The points are rational functions of random residues whose numerators and denominators have at
/// most the sum s of the degrees of the equations (Cramer's rule). So a minor of the Jacobian has a
/// numerator of degree s (s + 1) at most, and vanishes at a random point with a probability of at
/// most that over q, unless it is 0 (Schwartz and Zippel).
std::size_t digits_of_chance(const Program& program, std::size_t solutions) {
    const auto degrees = static_cast<double>(sum_of_degrees(program));
    const double digits = std::log10(static_cast<double>(modulus) / (degrees * (degrees + 1)));
    return static_cast<std::size_t>(std::max(0., static_cast<double>(solutions) * digits));
}

Fibre fibre_of(const Program& program, const Point& point, RandomResidues& random) {
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
    constexpr int most_trials = 310, first_trials = 10;
    constexpr std::size_t most_seen = 10;
    RandomResidues random(model, stream);
    RanksSeen seen;
    for (int trial = 0; trial < most_trials; ++trial) {
        const bool by_items = trial < first_trials, linear = !by_items && trial % 2 == 0;
        if (linear && seen.solutions == most_seen) continue;
        Point point{random.residues(program.data), random.residues(program.unknowns)};
        const std::vector<Modular> drawn = point.unknowns;
        try {
            // Equations without data are solved for unknowns.
            if (!solve_one_by_one(program, point, 0, random)) continue;
            const bool solved = by_items ? solve_item_by_item(program, point)
                                : linear
                                    ? solve_for_data(program, point, random)
                                    : solve_one_by_one(program, point, program.unknowns, random);
            if (!solved) continue;
            const Values values = run(program, point, false);
            if (!is_solution(program, values)) continue;
            const std::size_t rank = rank_of(program, values);
            if (rank == program.unknowns) return {fibre_of(program, point, random), {}};
            if (!linear || point.unknowns != drawn) continue;
            ++seen.solutions;
            seen.rank = std::max(seen.rank, rank);
        } catch (const NotInvertible&) {
            continue;
        }
    }
    seen.digits = digits_of_chance(program, seen.solutions);
    return {std::nullopt, seen};
}

} // namespace plprove::model
