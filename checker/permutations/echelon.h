// Independent conditions on motions of the views, modulo q.
#pragma once

#include "checker/permutations/moving_views.h"

namespace checker {
class Echelon {
public:
    /// Whether the condition is independent of those before; it is then one of them.
    bool add(Motion condition) {
        for (const Row& row : rows_) {
            const Residue factor = -condition[row.pivot];
            for (std::size_t i = 0; i < condition.size(); ++i)
                condition[i] = condition[i] + factor * row.condition[i];
        }
        std::size_t pivot = 0;
        while (pivot < condition.size() && condition[pivot] == Residue{})
            ++pivot;
        if (pivot == condition.size()) return false;
        const Residue scale = condition[pivot].inverse();
        for (Residue& entry : condition)
            entry = scale * entry;
        rows_.push_back({pivot, condition});
        return true;
    }

    /// Adds the condition that a point of a plane, which the views determine, is on some line; the
    /// other condition has another line through this point. Whether the two are independent: then
    /// the point moves in two dimensions (proofs/all_permutations.md, Lemma 2).
    bool cut(const Motion& condition, const Motion& other) {
        Echelon both = *this;
        return both.add(condition) && both.add(other) && add(condition);
    }

    /// How many of the conditions are independent of those before; they are added.
    template <class Conditions> std::size_t add_all(const Conditions& conditions) {
        std::size_t added = 0;
        for (const Motion& condition : conditions)
            added += add(condition) ? 1 : 0;
        return added;
    }

    std::size_t size() const { return rows_.size(); }

    /// A motion that satisfies all conditions.
    Motion motion(Drawn& drawn) const {
        Motion result;
        for (Residue& entry : result)
            entry = drawn.number();
        // A row is 0 at the pivots of the rows before it.
        for (auto row = rows_.rbegin(); row != rows_.rend(); ++row) {
            result[row->pivot] = {};
            result[row->pivot] = -Equation{{}, row->condition}.along(result);
        }
        return result;
    }

private:
    struct Row {
        std::size_t pivot = 0;
        Motion condition{}; // 1 there
    };
    std::vector<Row> rows_{};
};
} // namespace checker
