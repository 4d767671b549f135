#include "prover/catalogue/degrees.h"

#include <algorithm>
#include <charconv>
#include <set>
#include <stdexcept>
#include <tuple>

namespace plprove {

namespace {

constexpr std::string_view column_names = "number,degree,status,source";
constexpr std::size_t number_of_classes = 143494;
constexpr std::array statuses{DegreeStatus::claimed, DegreeStatus::evidence,
                              DegreeStatus::certified};

std::vector<std::string_view> split(std::string_view line) {
    std::vector<std::string_view> fields;
    for (std::size_t comma = line.find(','); comma != std::string_view::npos;
         comma = line.find(',')) {
        fields.push_back(line.substr(0, comma));
        line.remove_prefix(comma + 1);
    }
    fields.push_back(line);
    return fields;
}

std::optional<int> read_integer(std::string_view text) {
    int value = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error != std::errc{} || end != text.data() + text.size()) return std::nullopt;
    return value;
}

/// One line of data. Throws std::invalid_argument that says what was expected.
DegreeRecord read_record(std::string_view line) {
    const std::vector<std::string_view> fields = split(line);
    if (fields.size() != 4 || line.find('"') != std::string_view::npos)
        throw std::invalid_argument("expected four fields without commas or quotes in them");
    const std::optional<int> number = read_integer(fields[0]);
    if (!number || *number < 0 || static_cast<std::size_t>(*number) >= number_of_classes)
        throw std::invalid_argument("expected the number of a label class, 0 to 143493");
    const std::optional<int> degree = read_integer(fields[1]);
    if (!degree || *degree < 1) throw std::invalid_argument("expected a positive degree");
    const auto status = std::ranges::find(statuses, fields[2], name);
    if (status == statuses.end())
        throw std::invalid_argument("expected a status: certified, evidence or claimed");
    if (fields[3].empty()) throw std::invalid_argument("expected the source of the degree");
    return {static_cast<std::size_t>(*number), *degree, *status, std::string(fields[3])};
}

} // namespace

std::string_view name(DegreeStatus status) {
    switch (status) {
    case DegreeStatus::claimed:
        return "claimed";
    case DegreeStatus::evidence:
        return "evidence";
    case DegreeStatus::certified:
        return "certified";
    }
    return {};
}

std::vector<DegreeRecord> parse_degrees(std::span<const std::string_view> lines) {
    std::vector<DegreeRecord> records;
    std::set<std::pair<std::size_t, DegreeStatus>> known;
    bool names_read = false;
    for (std::size_t i = 0; i < lines.size(); ++i) {
        if (lines[i].empty() || lines[i].starts_with('#')) continue;
        try {
            if (names_read) {
                records.push_back(read_record(lines[i]));
                if (!known.emplace(records.back().number, records.back().status).second)
                    throw std::invalid_argument("this number and status stand above already");
            } else if (lines[i] != column_names) {
                throw std::invalid_argument("expected the line " + std::string(column_names));
            }
            names_read = true;
        } catch (const std::invalid_argument& error) {
            throw std::runtime_error("degrees.csv, line " + std::to_string(i + 1) + ": " +
                                     error.what());
        }
    }
    return records;
}

DegreeTable::DegreeTable(std::vector<DegreeRecord> records, const std::vector<Signature>& classes)
    : records_(std::move(records)) {
    for (std::size_t i = 0; i < records_.size(); ++i)
        by_constraint_class_.emplace(
            class_number(classes, constraint_representative(classes[records_[i].number])), i);
}

std::optional<DegreeRecord> DegreeTable::find(std::size_t number,
                                              std::size_t constraint_class) const {
    const auto [first, last] = by_constraint_class_.equal_range(constraint_class);
    if (first == last) return std::nullopt;
    const auto rank = [&](const auto& entry) {
        const DegreeRecord& record = records_[entry.second];
        return std::tuple(record.status, record.number == number,
                          number_of_classes - record.number);
    };
    return records_[std::max_element(first, last, [&](const auto& a, const auto& b) {
                        return rank(a) < rank(b);
                    })->second];
}

} // namespace plprove
