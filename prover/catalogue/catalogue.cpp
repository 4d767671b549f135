#include "prover/catalogue/catalogue.h"

#include <algorithm>
#include <bit>

namespace plprove {

namespace {

void add(Counts& sum, const Feature& feature) {
    sum.points += feature.has_point;
    (feature.has_point ? sum.pins : sum.free_lines) += feature.lines;
    if (feature.has_point) sum.most_pins = std::max(sum.most_pins, feature.lines);
    for (std::size_t view = 0; view < 3; ++view) {
        sum.points_in_view[view] += feature.sights[view].point;
        sum.lines_in_view[view] += std::popcount(feature.sights[view].pins);
    }
}

Entry entry_of(std::size_t number, const std::vector<Signature>& classes) {
    Entry entry;
    entry.number = number;
    entry.signature = classes[number];
    entry.obstruction = obstruction(problem_of(entry.signature));
    entry.swap_class = class_number(classes, swap_representative(entry.signature));
    entry.constraint_class = class_number(classes, constraint_representative(entry.signature));
    entry.counts = counts(entry.signature);
    entry.families = families_of(entry.signature, entry.minimal());
    entry.degree = degree_on_file(entry.constraint_class);
    entry.group = group_on_file(entry.constraint_class);
    return entry;
}

} // namespace

Counts counts(const Signature& signature) {
    Counts result;
    const Features problem = problem_of(signature);
    for (const Feature& feature : problem)
        add(result, feature);
    result.shared_points = shared_points(problem);
    for (std::size_t view = 0; view < 3; ++view)
        result.complete_views += result.points_in_view[view] == result.points &&
                                 result.lines_in_view[view] == result.lines();
    return result;
}

std::string_view obstruction_name(const Obstruction& obstruction) {
    const bool epipolar = std::ranges::any_of(obstruction.excess, [](int e) { return e > 0; });
    if (obstruction.star > 0) return epipolar ? "epipolar and star" : "star";
    return epipolar ? "epipolar" : "none";
}

std::vector<Entry> catalogue() {
    const std::vector<Signature> classes = label_classes();
    std::vector<Entry> entries;
    entries.reserve(classes.size());
    for (std::size_t number = 0; number < classes.size(); ++number)
        entries.push_back(entry_of(number, classes));
    return entries;
}

} // namespace plprove
