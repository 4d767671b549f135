#include "checker/general_bounds/fixed_forms.h"

#include "checker/file/complaint.h"
#include "checker/general_bounds/resection.h"

#include <algorithm>
#include <numeric>

namespace checker {
/// The image vector of each own depth.
static std::vector<Row3> vectors_of_depths(const SceneSystem& system) {
    std::vector<Row3> vectors;
    for (const auto& [x, depth] : system.places) {
        const bool is_new = depth.size() > vectors.size(); // else it depends on depths before
        if (is_new) vectors.push_back(residues(x));
    }
    return vectors;
}

SceneCoordinates::SceneCoordinates(const SceneSystem& system, const std::vector<FewDepths>& base)
    : x_(vectors_of_depths(system)) {
    std::vector<std::size_t> weight(system.depths);
    for (const FewDepths& few : base)
        for (const std::size_t depth : few.depths)
            weight[depth] += few.order;
    std::vector<std::size_t> order(system.depths);
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::ranges::stable_sort(order, {}, [&](std::size_t depth) { return weight[depth]; });
    for (std::size_t c = 0; c < order.size(); ++c)
        for (std::size_t b = 0; b < c; ++b)
            for (std::size_t a = 0; a < b; ++a) {
                if (!kept_.empty()) continue;
                zero_ = {order[a], order[b], order[c]};
                if (determinant(x_[zero_[0]], x_[zero_[1]], x_[zero_[2]]) == Small{}) continue;
                for (std::size_t depth = 0; depth < system.depths; ++depth)
                    if (std::ranges::count(zero_, depth) == 0) kept_.push_back(depth);
            }
    if (kept_.empty()) throw Refused("view 1 shows everything on a line");
}

SmallRow SceneCoordinates::of(SmallRow own) const {
    const auto& [a, b, c] = zero_;
    const Small inverse = determinant(x_[a], x_[b], x_[c]).inverse();
    SmallRow moved;
    for (const std::size_t depth : kept_) {
        // x is a combination of the three vectors (Cramer); so the motion adds the same of depths.
        const Row3& x = x_[depth];
        const Small sum = determinant(x, x_[b], x_[c]) * own[a] +
                          determinant(x_[a], x, x_[c]) * own[b] +
                          determinant(x_[a], x_[b], x) * own[c];
        moved.push_back(own[depth] - sum * inverse);
    }
    return moved;
}

SmallRow SceneCoordinates::scene(const SmallRow& kept) const {
    SmallRow own(kept.size() + zero_.size());
    for (std::size_t i = 0; i < kept.size(); ++i)
        own[kept_[i]] = kept[i];
    return own;
}

/// Monomials of a degree whose degree in some variables is bounded.
class Monomials {
public:
    struct Bound {
        std::vector<bool> variables{};
        int most = 0;
    };

    Monomials(std::size_t variables, std::vector<Bound> bounds)
        : current_(variables), bounds_(std::move(bounds)), of_variable_(variables),
          of_all_from_(variables) {
        for (std::size_t b = 0; b < bounds_.size(); ++b) {
            bool of_all = true;
            for (std::size_t v = variables; v-- > 0;) {
                if (bounds_[b].variables[v]) of_variable_[v].push_back(b);
                of_all = of_all && bounds_[b].variables[v];
                if (of_all) of_all_from_[v].push_back(b);
            }
        }
    }

    std::vector<Monomial> of_degree(int degree) && {
        choose(0, degree);
        return std::move(found_);
    }

private:
    void choose(std::size_t variable, int left) {
        constexpr std::size_t most_steps = 300'000;
        if (++steps_ > most_steps)
            throw Refused("it takes more than ", most_steps, " steps to find the monomials");
        if (variable == current_.size()) {
            if (left > 0) return;
            constexpr std::size_t most = 10'000;
            if (found_.size() == most) throw Refused("it takes more than ", most, " monomials");
            found_.push_back(current_);
            return;
        }
        const auto leaves_room = [&](std::size_t bound) { return left <= bounds_[bound].most; };
        if (!std::ranges::all_of(of_all_from_[variable], leaves_room)) return;
        int exponent = 0;
        while (fits(variable)) {
            choose(variable + 1, left - exponent);
            if (exponent == left) break;
            current_[variable] = ++exponent;
            change(variable, -1);
        }
        current_[variable] = 0;
        change(variable, exponent);
    }

    /// Whether no bound of a variable is exceeded.
    bool fits(std::size_t variable) const {
        return std::ranges::none_of(of_variable_[variable],
                                    [&](std::size_t bound) { return bounds_[bound].most < 0; });
    }

    void change(std::size_t variable, int by) {
        for (const std::size_t bound : of_variable_[variable])
            bounds_[bound].most += by;
    }

    Monomial current_;
    std::vector<Bound> bounds_;        // what is left of them
    std::vector<Indices> of_variable_; // those of each variable
    std::vector<Indices> of_all_from_; // those of all variables from each one on
    std::vector<Monomial> found_{};
    std::size_t steps_ = 0;
};

/// A form vanishes to an order where only some variables are not 0 if and only if its monomials
/// have at least that degree in the others.
static std::vector<Monomials::Bound> bounds_of(const std::vector<FewDepths>& base,
                                               const SceneCoordinates& coordinates,
                                               const Powers& powers) {
    std::vector<Monomials::Bound> bounds;
    for (const FewDepths& few : base) {
        Monomials::Bound bound{.most =
                                   powers.degree() - powers.cubics * static_cast<int>(few.order)};
        std::size_t variables = 0;
        for (const std::size_t depth : coordinates.kept()) {
            bound.variables.push_back(std::ranges::count(few.depths, depth) > 0);
            variables += bound.variables.back() ? 1 : 0;
        }
        if (variables == few.depths.size()) bounds.push_back(bound);
    }
    return bounds;
}

/// A power series in one variable, up to some order.
using Series = SmallRow;

static Series product(const Series& a, const Series& b) {
    Series c(a.size());
    for (std::size_t i = 0; i < a.size(); ++i)
        for (std::size_t j = 0; i + j < a.size(); ++j)
            c[i + j] = c[i + j] + a[i] * b[j];
    return c;
}

/// Points D_0 + D_1 z + D_2 z^2 + ...
using Curve = std::vector<SmallRow>;

/// The coefficients of all monomials on a curve, below an order: one row for each power.
static std::vector<SmallRow> jets(const std::vector<Monomial>& monomials, int degree,
                                  const Curve& curve, std::size_t order) {
    const std::size_t coordinates = curve[0].size();
    std::vector<std::vector<Series>> powers(coordinates);
    for (std::size_t i = 0; i < coordinates; ++i) {
        Series one(order), coordinate(order);
        one[0] = Small{1};
        for (std::size_t k = 0; k < std::min(order, curve.size()); ++k)
            coordinate[k] = curve[k][i];
        powers[i] = {one};
        for (int k = 0; k < degree; ++k)
            powers[i].push_back(product(powers[i].back(), coordinate));
    }
    std::vector<SmallRow> rows(order, SmallRow(monomials.size()));
    for (std::size_t m = 0; m < monomials.size(); ++m) {
        Series value = powers[0][0];
        for (std::size_t i = 0; i < coordinates; ++i)
            if (monomials[m][i] > 0)
                value = product(value, powers[i][static_cast<std::size_t>(monomials[m][i])]);
        for (std::size_t k = 0; k < order; ++k)
            rows[k][m] = value[k];
    }
    return rows;
}

/// The conditions on forms, as rows over their monomials.
class Conditions {
public:
    Conditions(const std::vector<Monomial>& monomials, const SceneCoordinates& coordinates,
               const Powers& powers, Choices& choices)
        : monomials_(monomials), coordinates_(coordinates), powers_(powers), choices_(choices) {}

    std::size_t rank() const { return space_.rank(); }

    /// That forms vanish at the beginnings of curves, in own depths, that this chooses, until these
    /// say nothing new. The curves go on in any way.
    template <class Choose> void add(std::size_t order, const Choose& choose) {
        constexpr int enough = 2;
        for (int idle = 0; idle < enough;) {
            Curve curve;
            for (const SmallRow& own : choose())
                curve.push_back(coordinates_.of(own));
            curve.push_back(choices_.row(coordinates_.kept().size()));
            const bool is_new = space_.add(jets(monomials_, powers_.degree(), curve,
                                                order * static_cast<std::size_t>(powers_.cubics)));
            idle = is_new ? 0 : idle + 1;
        }
    }

private:
    const std::vector<Monomial>& monomials_;
    const SceneCoordinates& coordinates_;
    const Powers& powers_;
    Choices& choices_;
    RowSpace space_{};
};

std::vector<Monomial> monomials_that_fit(const BaseScenes& base,
                                         const SceneCoordinates& coordinates,
                                         const Powers& powers) {
    return Monomials(coordinates.kept().size(), bounds_of(base.few_depths, coordinates, powers))
        .of_degree(powers.degree());
}

std::size_t rank_of_conditions(const std::vector<Monomial>& monomials, const Problem& problem,
                               const SceneSystem& system, const BaseScenes& base,
                               const SceneCoordinates& coordinates, const Powers& powers,
                               Choices& choices) {
    Conditions conditions(monomials, coordinates, powers, choices);
    const auto is_kept = [&](std::size_t depth) {
        return std::ranges::count(coordinates.kept(), depth) > 0;
    };
    for (const FewDepths& few : base.few_depths) {
        if (std::ranges::all_of(few.depths, is_kept)) continue; // all monomials meet it
        conditions.add(few.order, [&] { return Curve{choose_scene(system, few, choices)}; });
    }
    for (const Pencil& pencil : base.pencils)
        conditions.add(1, [&] { return Curve{choose_scene(system, pencil, choices)}; });
    for (const Tangent& tangent : base.tangents)
        conditions.add(2, [&] { return choose_tangent(problem, system, tangent, choices); });
    return conditions.rank();
}
} // namespace checker
