#include "prover/minimal/dependent_part.h"

#include "prover/minimal/random_instance.h"

#include <algorithm>
#include <bit>
#include <optional>

namespace plprove {

namespace {

/// What may be left out of a part.
struct Item {
    enum class Kind { view, point, line };
    Kind kind = Kind::view;
    int number = 0;
};

std::vector<Item> items_of(const Problem& problem) {
    std::vector<Item> items;
    for (int view = 0; view < problem.views; ++view)
        items.push_back({Item::Kind::view, view});
    for (int point = 0; point < static_cast<int>(problem.points.size()); ++point)
        items.push_back({Item::Kind::point, point});
    for (int line = 0; line < static_cast<int>(problem.lines.size()); ++line)
        items.push_back({Item::Kind::line, line});
    return items;
}

/// The part without the item; nothing if it has no such item, or only two views.
std::optional<Subproblem> without(Subproblem part, const Item& item) {
    if (item.kind == Item::Kind::view) {
        if (!contains(part.views, item.number) || std::popcount(part.views) == 2)
            return std::nullopt;
        part.views &= ~(ViewSet{1} << item.number);
        return part;
    }
    std::vector<int>& numbers = item.kind == Item::Kind::point ? part.points : part.lines;
    if (std::erase(numbers, item.number) == 0) return std::nullopt;
    return part;
}

bool is_dependent(const Problem& problem, const Subproblem& part) {
    const Problem alone = problem_of(problem, part);
    const ResidueMatrix matrix =
        jacobian_modulo_q(alone, random_instance(alone, 1, most_coordinate));
    return static_cast<int>(nmod_mat_rank(matrix.get())) < matrix.rows();
}

} // namespace

std::vector<Subproblem> dependent_parts(const Problem& problem) {
    std::vector<Subproblem> parts;
    if (!is_dependent(problem, whole(problem))) return parts;
    constexpr std::ptrdiff_t most = 4;
    std::vector<Item> items = items_of(problem);
    for (std::ptrdiff_t i = 0; i < most; ++i) {
        // What comes first in the order is left out rather.
        std::rotate(items.begin(), items.begin() + std::ssize(items) / most, items.end());
        std::ranges::reverse(items);
        Subproblem part = whole(problem);
        for (bool changed = true; changed;) {
            changed = false;
            for (const Item& item : items) {
                std::optional<Subproblem> less = without(part, item);
                if (!less || !is_part(problem, *less) || !is_dependent(problem, *less)) continue;
                part = *std::move(less);
                changed = true;
            }
        }
        const bool is_known = std::ranges::any_of(parts, [&](const Subproblem& known) {
            return known.views == part.views && known.points == part.points &&
                   known.lines == part.lines;
        });
        if (!is_known) parts.push_back(std::move(part));
    }
    return parts;
}

} // namespace plprove
