#include "prover/degree_sweep/classes.h"

#include "prover/system/exit.h"

#include <algorithm>
#include <set>

namespace plprove {

namespace {

bool is_minimal(const Signature& signature) {
    return obstruction(problem_of(signature)).deficiency() == 0;
}

bool has_number(const ClassFilter& filter, std::size_t number) {
    return filter.numbers.empty() || std::ranges::any_of(filter.numbers, [&](const Range& range) {
               return range.contains(static_cast<int>(number));
           });
}

/// Adds the constraint classes of the minimal classes with these numbers.
void add_by_number(std::set<std::size_t>& chosen, const ClassFilter& filter) {
    const std::vector<Signature>& classes = label_classes();
    for (std::size_t number = 0; number < classes.size(); ++number)
        if (has_number(filter, number) && is_minimal(classes[number]))
            chosen.insert(class_number(classes, constraint_representative(classes[number])));
}

} // namespace

std::vector<std::size_t> constraint_classes_of(std::span<const ClassFilter> filters) {
    std::set<std::size_t> chosen;
    std::vector<Entry> entries; // made if a filter asks for more than numbers
    for (const ClassFilter& filter : filters) {
        if (filter.by_number_only) {
            add_by_number(chosen, filter);
            continue;
        }
        if (entries.empty()) entries = catalogue();
        for (const Entry& entry : entries)
            if (entry.minimal() && has_number(filter, entry.number) &&
                matches(filter.filter, entry))
                chosen.insert(entry.constraint_class);
    }
    if (chosen.empty())
        throw BadInput("no minimal class passes the filter: see what `plprove list` prints for it");
    return {chosen.begin(), chosen.end()};
}

} // namespace plprove
