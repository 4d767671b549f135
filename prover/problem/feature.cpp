#include "prover/problem/feature.h"

#include "prover/problem/notation.h"

#include <algorithm>
#include <bit>

namespace plprove {

int dimension_in_space(const Feature& feature) {
    return feature.has_point ? 3 + 2 * feature.lines : 4;
}

int dimension_in_view(const Feature& feature, int view) {
    const Sight& sight = feature.sights[static_cast<std::size_t>(view)];
    const int lines = std::popcount(sight.pins);
    return sight.point ? 2 + lines : 2 * lines;
}

int weight(const Feature& feature) {
    int images = 0;
    for (int view = 0; view < feature.views(); ++view)
        images += dimension_in_view(feature, view);
    return images - dimension_in_space(feature);
}

Feature relabel_views(const Feature& feature, std::span<const int> from) {
    Feature result = feature;
    for (std::size_t view = 0; view < from.size(); ++view)
        result.sights[view] = feature.sights[static_cast<std::size_t>(from[view])];
    return result;
}

char letter_of(const Feature& feature, int line) {
    const auto i = static_cast<std::size_t>(line);
    const std::size_t shared = feature.shared.size();
    return i < shared ? feature.shared[i] : static_cast<char>('a' + (i - shared));
}

ViewSet views_of(const Feature& feature, int line) {
    ViewSet views = 0;
    for (int view = 0; view < feature.views(); ++view)
        if (feature.sees_line(view, line)) views |= ViewSet{1} << view;
    return views;
}

void show_line(Feature& feature, int line, ViewSet views) {
    const std::uint64_t bit = std::uint64_t{1} << line;
    for (int view = 0; view < feature.views(); ++view) {
        std::uint64_t& pins = feature.sights[static_cast<std::size_t>(view)].pins;
        pins = contains(views, view) ? pins | bit : pins & ~bit;
    }
}

Feature canonical(const Feature& feature) {
    // A pin is known by the set of views that see it; sorting these sets forgets the pins' names.
    std::vector<ViewSet> seen_by;
    for (int line = 0; line < feature.lines; ++line)
        seen_by.push_back(views_of(feature, line));
    std::ranges::sort(seen_by, std::greater{});
    Feature result = feature;
    for (int line = 0; line < feature.lines; ++line)
        show_line(result, line, seen_by[static_cast<std::size_t>(line)]);
    return result;
}

bool is_seen(const Feature& feature, int line) {
    return views_of(feature, line) != 0;
}

bool point_is_seen(const Feature& feature) {
    return std::ranges::any_of(feature.sights, &Sight::point);
}

const std::vector<Feature>& standard_features() {
    static const std::vector<Feature> features = [] {
        std::vector<Feature> list;
        for (const char* text : {"Pabcdefg/Pabcdefg/Pabcdefg",
                                 "Pabcdef/Pabcdef/Pabcdef",
                                 "Pabcde/Pabcde/Pabcde",
                                 "Pabcd/Pabcd/Pabcd",
                                 "Pabc/Pabc/Pabc",
                                 "Pab/Pab/Pab",
                                 "Pa/Pa/Pa",
                                 "P/P/P",
                                 "a/Pa/Pa",
                                 "Pa/a/Pa",
                                 "Pa/Pa/a",
                                 "a/a/a",
                                 "a/P/Pa",
                                 "a/Pa/P",
                                 "P/a/Pa",
                                 "Pa/a/P",
                                 "P/Pa/a",
                                 "Pa/P/a",
                                 "-/P/P",
                                 "P/-/P",
                                 "P/P/-",
                                 "P/a/a",
                                 "a/P/a",
                                 "a/a/P",
                                 "Pab/b/a",
                                 "b/Pab/a",
                                 "b/a/Pab"})
            list.push_back(parse_feature(text));
        return list;
    }();
    return features;
}

} // namespace plprove
