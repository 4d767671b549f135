// Filters of the catalogue: conditions on a class, which must all hold.
#pragma once

#include "prover/catalogue/catalogue.h"
#include "prover/catalogue/part.h"

#include <limits>
#include <vector>

namespace plprove {

/// least..most, both included.
struct Range {
    int least = 0;
    int most = std::numeric_limits<int>::max();

    bool contains(int value) const { return least <= value && value <= most; }
};

/// Reads `N`, `N..M`, `N..` or `..M`; nothing where the text is none of these or the range is
/// empty.
std::optional<Range> parse_range(std::string_view text);

/// What the three views see, in ascending order: classes do not know which view is which.
using Views = std::array<int, 3>;

/// Reads `A,B,C`; nothing where the text is not three such numbers.
std::optional<Views> parse_views(std::string_view text);

enum class ObstructionFilter { none, epipolar, star, any };

/// A condition that is false or empty is no condition.
struct Filter {
    bool minimal = false;
    bool not_minimal = false;
    bool terminal = false;
    bool pl0p = false;
    bool one_pin = false;
    bool complete_visibility = false;
    bool five_point = false;
    bool registration = false;
    bool trifocal = false;
    std::optional<Range> points, lines, pins, free_lines, most_pins, complete_views, rank, degree,
        width;
    std::optional<Views> points_in_views, lines_in_views;
    std::optional<ObstructionFilter> obstruction;
    /// Features, in all orders of the views: a class has those, and no others than these.
    std::optional<std::vector<Part>> contains, contained_in;
};

/// A family of classes: those that pass the filter and, if ranges are given, are numbered in one.
struct ClassFilter {
    Filter filter;
    std::vector<Range> numbers;
    bool by_number_only = false; ///< whether the filter has no condition
};

bool matches(const Filter& filter, const Entry& entry);

} // namespace plprove
