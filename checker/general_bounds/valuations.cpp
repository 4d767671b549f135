#include "checker/general_bounds/valuations.h"

#include <algorithm>
#include <numeric>
#include <stdexcept>

namespace checker {
static void add_term(Valued& sum, const Exponents& exponents, std::int64_t valuation) {
    const auto [term, is_new] = sum.emplace(exponents, valuation);
    if (!is_new) term->second = std::min(term->second, valuation);
}

Valued operator+(const Valued& f, const Valued& g) {
    Valued sum = f;
    for (const auto& [exponents, valuation] : g)
        add_term(sum, exponents, valuation);
    return sum;
}

Valued operator*(const Valued& f, const Valued& g) {
    Valued product;
    for (const auto& [left, first] : f)
        for (const auto& [right, second] : g) {
            Exponents exponents = left;
            for (const auto& [unknown, exponent] : right)
                exponents[unknown] += exponent;
            std::erase_if(exponents, [](const auto& entry) { return entry.second == 0; });
            add_term(product, exponents, first + second);
        }
    return product;
}

namespace {
std::int64_t product(std::int64_t x, std::int64_t y) {
    std::int64_t result = 0;
    if (__builtin_mul_overflow(x, y, &result))
        throw std::overflow_error("valuations leave 64 bits");
    return result;
}

std::int64_t difference_of(std::int64_t x, std::int64_t y) {
    std::int64_t result = 0;
    if (__builtin_sub_overflow(x, y, &result))
        throw std::overflow_error("valuations leave 64 bits");
    return result;
}

/// A constant, and the coefficients of parameters.
using Affine = std::vector<std::int64_t>;

using Term = Valued::value_type;
using Terms = std::vector<Term>;

/// The valuations of the unknowns that meet what was required so far: affine functions of
/// parameters, which are free or at least 0. Each function is given times a common denominator.
class Region {
public:
    explicit Region(std::size_t unknowns) {
        for (std::size_t i = 0; i < unknowns; ++i) {
            unknowns_.emplace_back(1 + unknowns, 0);
            unknowns_.back()[1 + i] = 1;
            parameters_.push_back({next_name_++, true});
        }
    }

    bool is_point() const { return parameters_.empty(); }
    std::int64_t denominator() const { return denominator_; }

    /// Of a point.
    std::int64_t valuation(std::size_t unknown) const { return unknowns_[unknown][0]; }

    /// The valuation of the first term less that of the second.
    Affine difference(const Term& first, const Term& second) const {
        Affine result(1 + parameters_.size(), 0);
        result[0] = product(first.second - second.second, denominator_);
        const auto add = [&](const Exponents& exponents, int sign) {
            for (const auto& [unknown, exponent] : exponents)
                for (std::size_t k = 0; k < result.size(); ++k)
                    result[k] =
                        difference_of(result[k], product(-sign * exponent, unknowns_[unknown][k]));
        };
        add(first.first, 1);
        add(second.first, -1);
        return result;
    }

    /// Requires that a function is 0. False if it is constant.
    bool restrict_to(const Affine& function) {
        std::size_t best = 0;
        for (std::size_t k = 1; k < function.size(); ++k)
            if (function[k] != 0 &&
                (best == 0 || (parameters_[k - 1].is_free && !parameters_[best - 1].is_free)))
                best = k;
        if (best == 0) return false;
        Row row{next_name_++, function};
        const Parameter leaves = parameters_[best - 1];
        exchange(row, best);
        if (!leaves.is_free) rows_.push_back({leaves.name, row.function});
        for (Affine* other : functions())
            other->erase(other->begin() + static_cast<std::ptrdiff_t>(best));
        parameters_.erase(parameters_.begin() + static_cast<std::ptrdiff_t>(best - 1));
        return true;
    }

    void require_nonnegative(Affine function) { rows_.push_back({next_name_++, function}); }

    /// Whether nothing is left: the dual simplex method with Bland's rule, which ends.
    bool is_empty() {
        for (;;) {
            const Row* worst = nullptr;
            for (const Row& row : rows_)
                if (row.function[0] < 0 && (!worst || row.name < worst->name)) worst = &row;
            if (!worst) return false;
            const std::size_t best = raises(worst->function);
            if (best == 0) return true;
            const auto index = static_cast<std::size_t>(worst - rows_.data());
            Row row = rows_[index];
            rows_.erase(rows_.begin() + static_cast<std::ptrdiff_t>(index));
            const Parameter leaves = parameters_[best - 1];
            const std::size_t name = row.name;
            exchange(row, best);
            parameters_[best - 1] = {name, false};
            if (!leaves.is_free) rows_.push_back({leaves.name, row.function});
        }
    }

private:
    struct Parameter {
        std::size_t name;
        bool is_free;
    };
    /// A function that has to be at least 0.
    struct Row {
        std::size_t name;
        Affine function;
    };

    std::vector<Affine*> functions() {
        std::vector<Affine*> all;
        for (Affine& function : unknowns_)
            all.push_back(&function);
        for (Row& row : rows_)
            all.push_back(&row.function);
        return all;
    }

    /// The place of a parameter that makes the function larger: a free one if there is any, else
    /// that of the least name; 0 if there is none.
    std::size_t raises(const Affine& function) const {
        std::size_t best = 0;
        for (std::size_t k = 1; k < function.size(); ++k) {
            if (parameters_[k - 1].is_free && function[k] != 0) return k;
            if (!parameters_[k - 1].is_free && function[k] > 0 &&
                (best == 0 || parameters_[k - 1].name < parameters_[best - 1].name))
                best = k;
        }
        return best;
    }

    /// The value of the row takes the place of a parameter in all functions, and the row becomes
    /// this parameter. Divisions leave no remainder, as numerators are minors.
    void exchange(Row& row, std::size_t place) {
        const Affine pivot = row.function;
        const std::int64_t sign = pivot[place] < 0 ? -1 : 1;
        for (Affine* function : functions()) {
            const std::int64_t factor = (*function)[place];
            for (std::size_t k = 0; k < function->size(); ++k)
                if (k != place)
                    (*function)[k] = sign *
                                     difference_of(product((*function)[k], pivot[place]),
                                                   product(factor, pivot[k])) /
                                     denominator_;
            (*function)[place] = sign * factor;
        }
        for (std::size_t k = 0; k < pivot.size(); ++k)
            row.function[k] = -sign * pivot[k];
        row.function[place] = sign * denominator_;
        denominator_ = sign * pivot[place];
    }

    std::size_t next_name_ = 0;
    std::int64_t denominator_ = 1;
    std::vector<Parameter> parameters_{};
    std::vector<Affine> unknowns_{};
    std::vector<Row> rows_{};
};

bool is_zero(const Affine& function) {
    return std::ranges::all_of(function, [](std::int64_t value) { return value == 0; });
}

/// All points where each minimum is attained twice, by a search through which terms attain it.
class Search {
public:
    Search(std::size_t unknowns, const std::vector<Condition>& system) : unknowns_(unknowns) {
        for (const Condition& condition : system)
            conditions_.push_back(
                {condition.role, {condition.polynomial.begin(), condition.polynomial.end()}});
    }

    std::optional<std::size_t> count() {
        visit(0, Region(unknowns_));
        if (!is_regular_) return std::nullopt;
        std::size_t sum = 0;
        for (const auto& [point, solutions] : found_)
            sum += solutions;
        return sum;
    }

private:
    struct Listed {
        Role role;
        Terms terms;
    };

    void visit(std::size_t index, const Region& region) {
        if (!is_regular_) return;
        if (index == conditions_.size()) return add(region);
        const Terms& terms = conditions_[index].terms;
        for (std::size_t first = 0; first < terms.size(); ++first)
            visit_minimum(index, region, first);
    }

    /// Where a term attains the minimum of a condition.
    void visit_minimum(std::size_t index, const Region& region, std::size_t first) {
        const Terms& terms = conditions_[index].terms;
        bool is_attained_twice = false;
        for (std::size_t k = 0; k < terms.size(); ++k) {
            if (k == first || !is_zero(region.difference(terms[k], terms[first]))) continue;
            if (k < first) return; // the same region as for the other term
            is_attained_twice = true;
        }
        Region least = region;
        require_least(least, terms, first);
        if (least.is_empty()) return;
        if (is_attained_twice) return visit(index + 1, least);
        for (std::size_t second = first + 1; second < terms.size(); ++second) {
            Region tie = region;
            if (!tie.restrict_to(tie.difference(terms[second], terms[first]))) continue;
            require_least(tie, terms, first);
            if (!tie.is_empty()) visit(index + 1, tie);
        }
    }

    static void require_least(Region& region, const Terms& terms, std::size_t first) {
        for (const Term& term : terms)
            if (const Affine excess = region.difference(term, terms[first]); !is_zero(excess))
                region.require_nonnegative(excess);
    }

    /// The terms that attain the minimum.
    static std::vector<const Term*> least_terms(const Terms& terms, const Region& point) {
        std::vector<const Term*> least;
        for (const Term& term : terms) {
            const std::int64_t excess = least.empty() ? -1 : point.difference(term, *least[0])[0];
            if (excess < 0) least.clear();
            if (excess <= 0) least.push_back(&term);
        }
        return least;
    }

    /// Counts the solutions with the valuations of a point, which is found more than once if a
    /// consequence has more than two least terms.
    void add(const Region& region) {
        is_regular_ = region.is_point();
        if (!is_regular_) return;
        Region binomials(unknowns_); // in the end over their determinant
        for (const Role role : {Role::equation, Role::relation})
            for (const Listed& condition : conditions_) {
                if (condition.role != role) continue;
                const auto least = least_terms(condition.terms, region);
                const bool added =
                    least.size() == 2 && !binomials.is_point() &&
                    binomials.restrict_to(binomials.difference(*least[0], *least[1]));
                if (!added && role == Role::equation) is_regular_ = false;
            }
        is_regular_ = is_regular_ && binomials.is_point();
        if (is_regular_)
            found_[coordinates(region)] = static_cast<std::size_t>(binomials.denominator());
    }

    /// Of a point: equal for equal points.
    std::vector<std::int64_t> coordinates(const Region& point) const {
        std::vector<std::int64_t> all{point.denominator()};
        for (std::size_t i = 0; i < unknowns_; ++i)
            all.push_back(point.valuation(i));
        std::int64_t divisor = 0;
        for (const std::int64_t value : all)
            divisor = std::gcd(divisor, value);
        for (std::int64_t& value : all)
            value /= divisor;
        return all;
    }

    std::size_t unknowns_;
    std::vector<Listed> conditions_{};
    std::map<std::vector<std::int64_t>, std::size_t> found_{};
    bool is_regular_ = true;
};
} // namespace

std::optional<std::size_t> solutions_by_valuations(std::size_t unknowns,
                                                   const std::vector<Condition>& system) {
    return Search(unknowns, system).count();
}
} // namespace checker
