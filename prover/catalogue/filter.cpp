#include "prover/catalogue/filter.h"

#include <algorithm>
#include <charconv>

namespace plprove {

namespace {

/// A number without sign, at most six digits.
std::optional<int> read_count(std::string_view text) {
    if (text.empty() || text.size() > 6 ||
        text.find_first_not_of("0123456789") != std::string_view::npos)
        return std::nullopt;
    int value = 0;
    std::from_chars(text.data(), text.data() + text.size(), value);
    return value;
}

bool in(const std::optional<Range>& range, int value) {
    return !range || range->contains(value);
}

bool in_views(const std::optional<Views>& wanted, Views seen) {
    std::ranges::sort(seen);
    return !wanted || *wanted == seen;
}

bool matches_flags(const Filter& filter, const Entry& entry) {
    const Families& member = entry.families;
    const std::pair<bool, bool> conditions[] = {
        {filter.minimal, entry.minimal()},
        {filter.not_minimal, !entry.minimal()},
        {filter.terminal, entry.terminal()},
        {filter.pl0p, member.pl0p},
        {filter.one_pin, member.at_most_one_pin},
        {filter.complete_visibility, entry.counts.complete_views == 3},
        {filter.five_point, member.five_point_extension},
        {filter.registration, member.registration},
        {filter.trifocal, member.trifocal_linear},
    };
    return std::ranges::all_of(
        conditions, [](const auto& condition) { return !condition.first || condition.second; });
}

bool matches_counts(const Filter& filter, const Entry& entry) {
    const Counts& counts = entry.counts;
    return in(filter.points, counts.points) && in(filter.lines, counts.lines()) &&
           in(filter.pins, counts.pins) && in(filter.free_lines, counts.free_lines) &&
           in(filter.most_pins, counts.most_pins) &&
           in(filter.complete_views, counts.complete_views) && in(filter.rank, entry.rank()) &&
           in_views(filter.points_in_views, counts.points_in_view) &&
           in_views(filter.lines_in_views, counts.lines_in_view);
}

bool matches_obstruction(const std::optional<ObstructionFilter>& wanted,
                         const Obstruction& obstruction) {
    if (!wanted) return true;
    const bool epipolar = std::ranges::any_of(obstruction.excess, [](int e) { return e > 0; });
    switch (*wanted) {
    case ObstructionFilter::none:
        return obstruction.deficiency() == 0;
    case ObstructionFilter::epipolar:
        return epipolar;
    case ObstructionFilter::star:
        return obstruction.star > 0;
    case ObstructionFilter::any:
        return obstruction.deficiency() > 0;
    }
    return false;
}

/// Of a number that not every class has.
bool matches_known(const std::optional<Range>& wanted, const std::optional<int>& known) {
    return !wanted || (known && wanted->contains(*known));
}

bool matches_parts(const Filter& filter, const Signature& signature) {
    const auto contains_it = [&](const Part& part) { return contains(signature, part); };
    const auto is_contained_in_it = [&](const Part& part) { return is_contained(signature, part); };
    return (!filter.contains || std::ranges::any_of(*filter.contains, contains_it)) &&
           (!filter.contained_in || std::ranges::any_of(*filter.contained_in, is_contained_in_it));
}

} // namespace

std::optional<Range> parse_range(std::string_view text) {
    const std::size_t dots = text.find("..");
    if (dots == std::string_view::npos) {
        const std::optional<int> value = read_count(text);
        if (!value) return std::nullopt;
        return Range{*value, *value};
    }
    const std::string_view low = text.substr(0, dots);
    const std::string_view high = text.substr(dots + 2);
    if (low.empty() && high.empty()) return std::nullopt;
    const std::optional<int> least = low.empty() ? 0 : read_count(low);
    const std::optional<int> most = high.empty() ? Range{}.most : read_count(high);
    if (!least || !most || *least > *most) return std::nullopt;
    return Range{*least, *most};
}

std::optional<Views> parse_views(std::string_view text) {
    Views views{};
    for (std::size_t i = 0; i < views.size(); ++i) {
        const std::size_t end = i + 1 < views.size() ? text.find(',') : text.size();
        if (end == std::string_view::npos) return std::nullopt;
        const std::optional<int> value = read_count(text.substr(0, end));
        if (!value) return std::nullopt;
        views[i] = *value;
        text.remove_prefix(std::min(end + 1, text.size()));
    }
    std::ranges::sort(views);
    return views;
}

bool matches(const Filter& filter, const Entry& entry) {
    return matches_flags(filter, entry) && matches_counts(filter, entry) &&
           matches_obstruction(filter.obstruction, entry.obstruction) &&
           matches_known(filter.degree, entry.degree) &&
           matches_known(filter.width, entry.width()) && matches_parts(filter, entry.signature);
}

} // namespace plprove
