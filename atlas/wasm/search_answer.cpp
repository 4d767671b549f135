#include "atlas/wasm/answers.h"

#include "prover/catalogue/spelling.h"
#include "prover/cli/filter_options.h"

#include <algorithm>
#include <sstream>

namespace atlas {

using namespace plprove;

namespace {

/// The columns by which a search may be sorted. A class without a degree, which is not minimal,
/// comes last.
int sort_key(const Entry& entry, const std::string& column) {
    if (column == "degree") return entry.degree.value_or(0);
    if (column == "size") return entry.counts.points + entry.counts.lines();
    if (column == "points") return entry.counts.points;
    if (column == "lines") return entry.counts.lines();
    return static_cast<int>(entry.number);
}

void sort(std::vector<const Entry*>& found, const std::string& column, bool descending) {
    const auto before = [&](const Entry* a, const Entry* b) {
        if (column == "degree" && a->degree.has_value() != b->degree.has_value())
            return a->degree.has_value();
        const int x = sort_key(*a, column);
        const int y = sort_key(*b, column);
        return descending ? x > y : x < y;
    };
    std::stable_sort(found.begin(), found.end(), before);
}

/// The options as a command line. Throws std::invalid_argument.
Filter read_filter(const Json& options) {
    Filter filter;
    CLI::App command;
    command.set_help_flag();
    add_filters(command, filter);
    auto words = options.get<std::vector<std::string>>();
    std::reverse(words.begin(), words.end()); // as CLI11 wants them
    try {
        command.parse(words);
    } catch (const CLI::ParseError& error) {
        throw std::invalid_argument(error.what());
    }
    return filter;
}

Json rows_of(const std::vector<const Entry*>& entries) {
    Json rows = Json::array();
    for (const Entry* entry : entries)
        rows.push_back(row_of(*entry));
    return rows;
}

/// The classes that come of this one when a feature is exchanged for another of the same weight,
/// each once, with the exchange.
Json exchanges(const std::vector<Entry>& all, const Entry& entry) {
    const std::vector<Feature>& features = standard_features();
    std::vector<std::size_t> seen{entry.number};
    Json rows = Json::array();
    for (std::size_t i = 0; i < feature_count; ++i) {
        if (entry.signature[i] == 0) continue;
        for (std::size_t j = 0; j < feature_count; ++j) {
            if (weight(features[i]) != weight(features[j])) continue;
            Signature changed = entry.signature;
            --changed[i];
            ++changed[j];
            const std::size_t number = class_number(label_classes(), representative(changed));
            if (std::find(seen.begin(), seen.end(), number) != seen.end()) continue;
            seen.push_back(number);
            Json row = row_of(all[number]);
            row["dropped"] = notation(features[i]);
            row["added"] = notation(features[j]);
            rows.push_back(row);
        }
    }
    return rows;
}

} // namespace

const std::vector<Entry>& Library::classes() {
    if (classes_.empty()) classes_ = catalogue();
    return classes_;
}

Json row_of(const Entry& entry) {
    Json row = {
        {"number", entry.number},        {"notation", notation(entry.signature)},
        {"minimal", entry.minimal()},    {"obstruction", obstruction_name(entry.obstruction)},
        {"points", entry.counts.points}, {"lines", entry.counts.lines()}};
    if (entry.degree) row["degree"] = *entry.degree;
    return row;
}

Json search_answer(Library& library, const Json& request) {
    const Filter filter = read_filter(request.at("filter"));
    std::vector<const Entry*> found;
    for (const Entry& entry : library.classes())
        if (matches(filter, entry)) found.push_back(&entry);
    const std::size_t total = found.size();
    sort(found, request.at("sort"), request.at("descending"));
    const auto first = std::min(total, request.at("first").get<std::size_t>());
    const auto most = std::min(total - first, request.at("most").get<std::size_t>());
    found.erase(found.begin() + static_cast<std::ptrdiff_t>(first + most), found.end());
    found.erase(found.begin(), found.begin() + static_cast<std::ptrdiff_t>(first));
    Json rows = rows_of(found);
    for (std::size_t i = 0; i < found.size(); ++i)
        rows[i]["scene"] = scene_of(problem_of(found[i]->signature));
    return {{"total", total}, {"rows", rows}};
}

Json relatives_answer(Library& library, const Json& request) {
    const std::vector<Entry>& all = library.classes();
    const Entry& entry = all.at(request.at("number").get<std::size_t>());
    std::vector<const Entry*> swap, constraint;
    for (const Entry& other : all) {
        if (other.number == entry.number) continue;
        if (other.swap_class == entry.swap_class)
            swap.push_back(&other);
        else if (other.constraint_class == entry.constraint_class)
            constraint.push_back(&other);
    }
    return {{"swap", rows_of(swap)},
            {"constraint", rows_of(constraint)},
            {"exchanges", exchanges(all, entry)}};
}

} // namespace atlas
