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

Feature canonical(const Feature& feature) {
    // A pin is known by the set of views that see it; sorting these sets forgets the pins' names.
    std::vector<std::uint32_t> seen_by(static_cast<std::size_t>(feature.lines), 0);
    for (int line = 0; line < feature.lines; ++line)
        for (int view = 0; view < feature.views(); ++view)
            if (feature.sees_line(view, line))
                seen_by[static_cast<std::size_t>(line)] |= 1U << view;
    std::ranges::sort(seen_by, std::greater{});
    Feature result = feature;
    for (int view = 0; view < feature.views(); ++view) {
        std::uint32_t pins = 0;
        for (std::size_t line = 0; line < seen_by.size(); ++line)
            pins |= (seen_by[line] >> view & 1U) << line;
        result.sights[static_cast<std::size_t>(view)].pins = pins;
    }
    return result;
}

bool is_seen(const Feature& feature, int line) {
    return std::ranges::any_of(feature.sights,
                               [&](const Sight& sight) { return (sight.pins >> line & 1U) != 0; });
}

bool point_is_seen(const Feature& feature) {
    return std::ranges::any_of(feature.sights, &Sight::point);
}

namespace {

/// `(Pb)`: the point, where it would not be understood, and the lines that no view sees.
std::string unseen_notation(const Feature& feature) {
    std::string unseen;
    if (feature.has_point && !point_is_seen(feature) && feature.lines < 2) unseen += 'P';
    for (int line = 0; line < feature.lines; ++line)
        if (!is_seen(feature, line)) unseen += static_cast<char>('a' + line);
    return unseen.empty() ? unseen : "(" + unseen + ")";
}

} // namespace

std::string notation(const Feature& feature) {
    std::string text;
    for (int view = 0; view < feature.views(); ++view) {
        if (view > 0) text += '/';
        const std::size_t start = text.size();
        if (feature.sees_point(view)) text += 'P';
        for (int line = 0; line < feature.lines; ++line)
            if (feature.sees_line(view, line)) text += static_cast<char>('a' + line);
        if (text.size() == start) text += '-';
    }
    return text + unseen_notation(feature);
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
