#include "prover/catalogue/degrees.h"

#include "prover/degree/five_points.h"

#include <algorithm>
#include <charconv>
#include <set>
#include <stdexcept>
#include <tuple>

namespace plprove {

namespace {

constexpr std::string_view column_names = "number,degree,bound,status,source";
constexpr std::size_t number_of_classes = 143494;
constexpr std::array bounds{DegreeBound::at_least, DegreeBound::exact};
constexpr std::array statuses{DegreeStatus::claimed, DegreeStatus::evidence,
                              DegreeStatus::certified};

using Fields = std::array<std::string_view, 5>;

/// The fields of a line, or nothing where there are more or fewer.
std::optional<Fields> split(std::string_view line) {
    Fields fields;
    for (std::size_t i = 0; i + 1 < fields.size(); ++i) {
        const std::size_t comma = line.find(',');
        if (comma == std::string_view::npos) return std::nullopt;
        fields[i] = line.substr(0, comma);
        line.remove_prefix(comma + 1);
    }
    if (line.find(',') != std::string_view::npos) return std::nullopt;
    fields.back() = line;
    return fields;
}

std::optional<int> read_integer(std::string_view text) {
    int value = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error != std::errc{} || end != text.data() + text.size()) return std::nullopt;
    return value;
}

/// The value with this name. Throws std::invalid_argument with what was expected.
template <class Values>
auto named(const Values& values, std::string_view text, const char* expected) {
    const auto found =
        std::ranges::find_if(values, [&](const auto value) { return name(value) == text; });
    if (found == values.end()) throw std::invalid_argument(expected);
    return *found;
}

/// One line of data. Throws std::invalid_argument that says what was expected.
DegreeRecord read_record(std::string_view line) {
    const std::optional<Fields> fields = split(line);
    if (!fields || line.find('"') != std::string_view::npos)
        throw std::invalid_argument("expected five fields without commas or quotes in them");
    const auto& [number_text, degree_text, bound_text, status_text, source] = *fields;
    const std::optional<int> number = read_integer(number_text);
    if (!number || *number < 0 || static_cast<std::size_t>(*number) >= number_of_classes)
        throw std::invalid_argument("expected the number of a label class, 0 to 143493");
    const std::optional<int> degree = read_integer(degree_text);
    if (!degree || *degree < 1) throw std::invalid_argument("expected a positive degree");
    const DegreeBound bound = named(bounds, bound_text, "expected a bound: exact or at-least");
    const DegreeStatus status =
        named(statuses, status_text, "expected a status: certified, evidence or claimed");
    if (source.empty()) throw std::invalid_argument("expected the source of the degree");
    return {static_cast<std::size_t>(*number), *degree, bound, status, std::string(source)};
}

/// Which numbers and statuses have been read.
class Known {
public:
    /// Throws std::invalid_argument if this pair was added before.
    void add(const DegreeRecord& record) {
        const auto bit = static_cast<std::uint8_t>(1U << static_cast<unsigned>(record.status));
        if ((seen_[record.number] & bit) != 0)
            throw std::invalid_argument("this number and status stand above already");
        seen_[record.number] |= bit;
    }

private:
    std::vector<std::uint8_t> seen_ = std::vector<std::uint8_t>(number_of_classes);
};

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

std::string_view name(DegreeBound bound) {
    return bound == DegreeBound::exact ? "exact" : "at-least";
}

std::string in_words(const DegreeRecord& record) {
    return (record.bound == DegreeBound::exact ? "" : "at least ") + std::to_string(record.degree);
}

std::vector<DegreeRecord> parse_degrees(std::span<const std::string_view> lines) {
    std::vector<DegreeRecord> records;
    Known known;
    bool names_read = false;
    for (std::size_t i = 0; i < lines.size(); ++i) {
        if (lines[i].empty() || lines[i].starts_with('#')) continue;
        try {
            if (names_read) {
                records.push_back(read_record(lines[i]));
                known.add(records.back());
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

std::string write_degrees(std::span<const DegreeRecord> records, std::string_view remark) {
    std::string text;
    while (!remark.empty()) {
        const std::string_view line = remark.substr(0, remark.find('\n'));
        (text += line.empty() ? "#" : "# ").append(line) += '\n';
        remark.remove_prefix(std::min(line.size() + 1, remark.size()));
    }
    text.append(column_names) += '\n';
    for (const DegreeRecord& record : records) {
        text += std::to_string(record.number) + ',' + std::to_string(record.degree) + ',';
        (text.append(name(record.bound)) += ',').append(name(record.status)) += ',';
        text += record.source + '\n';
    }
    return text;
}

DegreeTable::DegreeTable(std::vector<DegreeRecord> records, const std::vector<Signature>& classes)
    : records_(std::move(records)) {
    keys_.reserve(records_.size());
    for (std::size_t i = 0; i < records_.size(); ++i) {
        // Files list what they have on a class one after the other.
        const bool repeated = i > 0 && records_[i].number == records_[i - 1].number;
        keys_.push_back({repeated ? keys_.back().constraint_class
                                  : class_number(classes, constraint_representative(
                                                              classes[records_[i].number])),
                         i});
    }
    std::ranges::stable_sort(keys_, {}, &Key::constraint_class);
}

std::vector<DegreeRecord> DegreeTable::find(std::size_t number,
                                            std::size_t constraint_class) const {
    std::vector<DegreeRecord> found;
    auto key = std::ranges::lower_bound(keys_, constraint_class, {}, &Key::constraint_class);
    for (; key != keys_.end() && key->constraint_class == constraint_class; ++key)
        found.push_back(records_[key->index]);
    const auto rank = [&](const DegreeRecord& record) {
        return std::tuple(
            record.status == DegreeStatus::claimed, record.bound != DegreeBound::exact,
            record.status != DegreeStatus::certified, record.number != number, record.number);
    };
    std::ranges::sort(found, {}, rank);
    return found;
}

DegreeTable degrees_of_classes(std::vector<DegreeRecord> records,
                               const std::vector<Signature>& classes,
                               std::span<const std::size_t> constraint_classes) {
    std::set<KindCounts> wanted;
    for (const std::size_t number : constraint_classes)
        wanted.insert(kind_counts(classes[number]));
    std::erase_if(records, [&](const DegreeRecord& record) {
        return !wanted.contains(kind_counts(classes[record.number]));
    });
    return {std::move(records), classes};
}

std::vector<DegreeRecord> degrees_in_two_views(const std::vector<DegreeRecord>& records) {
    const std::size_t extension = five_point_extension();
    const auto found = std::ranges::find_if(records, [&](const DegreeRecord& record) {
        return record.number == extension && record.status == DegreeStatus::certified &&
               record.bound == DegreeBound::exact;
    });
    if (found == records.end()) return {};
    const std::string source = "plcheck: the " + std::to_string(found->degree) +
                               " solutions with a third camera have " +
                               std::to_string(poses_of_five_points) + " relative poses";
    return {{extension, poses_of_five_points, found->bound, found->status, source}};
}

} // namespace plprove
