#include "prover/problem/spec.h"

#include "prover/problem/names.h"
#include "prover/problem/signature.h"
#include "prover/system/words.h"

#include <algorithm>
#include <cctype>
#include <charconv>

namespace plprove {

namespace {

/// A nested list of integers, as Macaulay2 writes it: `{{1,2},{{0,1},{1}}}`.
struct NestedList {
    bool is_number = false;
    int number = 0;
    std::size_t column = 1;
    std::vector<NestedList> items;
};

[[noreturn]] void fail(std::size_t column, const std::string& message) {
    throw NotationError("column " + std::to_string(column) + ": " + message);
}

class ListReader {
public:
    explicit ListReader(std::string_view text) : text_(text) {}

    NestedList read() {
        NestedList list = read_item(0);
        skip_blanks();
        if (position_ != text_.size()) fail(column(), "expected the end after the last '}'");
        return list;
    }

private:
    static constexpr int max_depth = 8;

    std::size_t column() const { return position_ + 1; }
    char peek() const { return position_ < text_.size() ? text_[position_] : '\0'; }
    void skip_blanks() {
        while (std::isspace(static_cast<unsigned char>(peek())) != 0)
            ++position_;
    }

    NestedList read_item(int depth) {
        skip_blanks();
        if (depth > max_depth) fail(column(), "lists nested too deeply");
        NestedList item;
        item.column = column();
        if (peek() != '{') {
            const char* start = text_.data() + position_;
            const auto [end, error] =
                std::from_chars(start, text_.data() + text_.size(), item.number);
            if (error != std::errc{}) fail(column(), "expected '{' or a number");
            item.is_number = true;
            position_ += static_cast<std::size_t>(end - start);
            return item;
        }
        ++position_;
        skip_blanks();
        while (peek() != '}') {
            if (!item.items.empty()) {
                if (peek() != ',') fail(column(), "expected ',' or '}'");
                ++position_;
            }
            item.items.push_back(read_item(depth + 1));
            skip_blanks();
        }
        ++position_;
        return item;
    }

    std::string_view text_;
    std::size_t position_ = 0;
};

std::vector<int> numbers(const NestedList& list, const std::string& what, int least, int most) {
    if (list.is_number) fail(list.column, "expected a list, " + what);
    std::vector<int> result;
    for (const NestedList& item : list.items) {
        if (!item.is_number || item.number < least || item.number > most)
            fail(item.column, "expected " + what);
        result.push_back(item.number);
    }
    return result;
}

/// One view of the Macaulay2 encoding: which lines and which points it sees.
struct EncodedView {
    std::vector<int> lines;
    std::vector<int> points;
};

EncodedView encoded_view(const NestedList& list, std::size_t lines, std::size_t points) {
    if (list.is_number || list.items.size() != 2)
        fail(list.column, "expected a view {seen lines, seen points}");
    EncodedView view{numbers(list.items[0], "0 or 1 for each line", 0, 1),
                     numbers(list.items[1], "0 or 1 for each point", 0, 1)};
    if (view.lines.size() != lines)
        fail(list.items[0].column, "expected " + std::to_string(lines) + " entries, one a line");
    if (view.points.size() != points)
        fail(list.items[1].column, "expected " + std::to_string(points) + " entries, one a point");
    return view;
}

Feature free_line(std::size_t line, const std::vector<EncodedView>& views) {
    Feature feature{false, 1, {}};
    for (const EncodedView& view : views)
        feature.sights.push_back({false, view.lines[line] != 0 ? 1U : 0U});
    return feature;
}

Feature point_with_pins(std::size_t point, const std::vector<int>& lines,
                        const std::vector<EncodedView>& views, std::size_t column) {
    Feature feature{true, 0, std::vector<Sight>(views.size())};
    for (std::size_t v = 0; v < views.size(); ++v)
        feature.sights[v].point = views[v].points[point] != 0;
    for (std::size_t line = 0; line < lines.size(); ++line) {
        if (lines[line] != static_cast<int>(point)) continue;
        if (feature.lines == max_pins) fail(column, "expected at most 26 pins at a point");
        for (std::size_t v = 0; v < views.size(); ++v)
            if (views[v].lines[line] != 0) feature.sights[v].pins |= 1U << feature.lines;
        ++feature.lines;
    }
    for (const Sight& sight : feature.sights)
        if (!sight.point && (sight.pins & (sight.pins - 1)) != 0)
            fail(column, "a view sees two lines of point " + std::to_string(point) +
                             " but not the point (Definition 1 of the paper)");
    return feature;
}

Features problem_of_encoding(const NestedList& list) {
    if (list.items.size() != 2 || list.items[0].is_number || list.items[1].is_number)
        fail(list.column, "expected {lines, {view, view, view}}");
    constexpr int most = 999;
    const std::vector<int> lines =
        numbers(list.items[0], "the index of a point, or -1 for a free line", -1, most);
    const std::vector<NestedList>& views = list.items[1].items;
    if (views.size() < 2 || views.size() > 3) fail(list.items[1].column, "expected 2 or 3 views");
    if (views[0].items.size() != 2) fail(views[0].column, "expected {seen lines, seen points}");
    const std::size_t points = views[0].items[1].items.size();
    for (std::size_t i = 0; i < lines.size(); ++i)
        if (lines[i] >= static_cast<int>(points))
            fail(list.items[0].items[i].column,
                 "there are only " + std::to_string(points) + " points, counted from 0");
    std::vector<EncodedView> encoded;
    for (const NestedList& view : views)
        encoded.push_back(encoded_view(view, lines.size(), points));
    Features problem;
    for (std::size_t point = 0; point < points; ++point)
        problem.push_back(point_with_pins(point, lines, encoded, list.items[1].column));
    for (std::size_t line = 0; line < lines.size(); ++line)
        if (lines[line] < 0) problem.push_back(free_line(line, encoded));
    if (problem.empty()) fail(list.column, "expected at least one point or line");
    return problem;
}

Features problem_of_counts(const std::vector<int>& counts) {
    Features problem;
    for (std::size_t i = 0; i < feature_count; ++i)
        problem.insert(problem.end(), static_cast<std::size_t>(counts[i]), standard_features()[i]);
    if (problem.empty()) fail(1, "the signature is zero: expected at least one feature");
    return problem;
}

Features problem_of_list(const NestedList& list) {
    if (!list.items.empty() && list.items[0].is_number) {
        if (list.items.size() != feature_count)
            fail(list.column,
                 "expected a signature of 27 numbers, found " + std::to_string(list.items.size()));
        return problem_of_counts(numbers(list, "a multiplicity from 0 to 99", 0, 99));
    }
    return problem_of_encoding(list);
}

Features problem_of_number(std::string_view digits, std::size_t column) {
    const std::vector<Signature>& classes = label_classes();
    std::size_t number = 0;
    const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), number);
    if (error != std::errc{} || end != digits.data() + digits.size() || number >= classes.size())
        fail(column,
             "expected the number of a label class, 0 to " + std::to_string(classes.size() - 1));
    return problem_of(classes[number]);
}

[[noreturn]] void fail_on_unknown_name(std::string_view text) {
    std::vector<std::string> names;
    for (const NamedProblem& named : named_problems())
        names.emplace_back(named.name);
    const std::optional<std::string> meant = most_similar(std::string(text), names);
    throw NotationError(in_quotes(text) + " is no name of a problem" +
                        (meant ? ": did you mean " + *meant + "?"
                               : ", and notation has a '/' between views: write "
                                 "'P/P/P + 4*a/a/a', or one of the names " +
                                     list_of_names()));
}

Features parse_any_spec(std::string_view text) {
    const std::size_t first = text.find_first_not_of(" \t");
    if (first == std::string_view::npos)
        fail(1, "expected a problem, such as '2*Pa/Pa/Pa + P/P/P', 2394 or Chicago");
    text = text.substr(0, text.find_last_not_of(" \t") + 1);
    if (text[first] == '{') return problem_of_list(ListReader(text).read());
    if (text[first] == '#') return problem_of_number(text.substr(first + 1), first + 2);
    const bool digits_only = text.find_first_not_of("0123456789", first) == std::string_view::npos;
    if (digits_only) return problem_of_number(text.substr(first), first + 1);
    if (text.find_first_not_of("0123456789 ,\t") == std::string_view::npos) {
        // A signature without braces: commas or blanks.
        std::string list(1, '{');
        list += text;
        list += '}';
        if (list.find(',') == std::string::npos)
            std::ranges::replace(list.begin() + static_cast<std::ptrdiff_t>(first) + 1,
                                 list.end() - 1, ' ', ',');
        return problem_of_list(ListReader(list).read());
    }
    if (text.find('/') == std::string_view::npos) {
        if (std::optional<Features> problem = problem_named(text)) return *std::move(problem);
        fail_on_unknown_name(text.substr(first));
    }
    return parse_features(text);
}

} // namespace

Features parse_spec(std::string_view text) {
    Features problem = parse_any_spec(text);
    if (problem.size() > max_features)
        fail(1, "expected at most " + std::to_string(max_features) + " features");
    return problem;
}

} // namespace plprove
