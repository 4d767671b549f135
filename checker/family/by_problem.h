// The one place that finds a problem among others, whatever the names of their points and lines,
// and counts how many problems there are (FORMAT.md, section 13).
#pragma once

#include "checker/family/isomorphism.h"

namespace checker {
/// A value for each of some problems.
template <class Value> class ByProblem {
public:
    /// That of a problem; null if it has none, or if `most_steps` do not show which one it has.
    const Value* find(const Problem& problem) const {
        const auto alike = entries_.find(invariant(problem));
        if (alike == entries_.end()) return nullptr;
        const Place place = place_of(problem, alike->second);
        return place.is_new ? nullptr : &alike->second[place.index].second;
    }

    /// The same, of a problem that may be new.
    Value& operator[](const Problem& problem) {
        std::vector<Entry>& alike = entries_[invariant(problem)];
        const Place place = place_of(problem, alike);
        if (place.is_new) alike.emplace_back(problem, Value{});
        if (place.is_new && !place.in_doubt) ++count_;
        return alike[place.index].second;
    }

    /// How many problems there are: those that are shown to differ from all before.
    std::size_t count() const { return count_; }

    /// Does something with each problem and its value.
    template <class Use> void for_each(const Use& use) const {
        for (const auto& [key, alike] : entries_)
            for (const auto& [problem, value] : alike)
                use(problem, value);
    }

private:
    /// Of one search: a millisecond or so.
    static constexpr std::size_t most_steps = 20'000;

    using Entry = std::pair<Problem, Value>;

    struct Place {
        std::size_t index = 0; // among those with equal invariants
        bool is_new = false;
        bool in_doubt = false; // whether a new one may be one of the others
    };

    static Place place_of(const Problem& problem, const std::vector<Entry>& alike) {
        std::size_t steps = most_steps;
        Place place;
        for (; place.index < alike.size(); ++place.index) {
            const auto same = isomorphic(problem, alike[place.index].first, steps);
            if (same == true) return place;
            place.in_doubt = place.in_doubt || !same;
        }
        place.is_new = true;
        return place;
    }

    std::map<Invariant, std::vector<Entry>> entries_{};
    std::size_t count_ = 0;
};
} // namespace checker
