#include "prover/problem/encodings.h"

#include "prover/problem/notation.h"
#include "prover/problem/signature.h"

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
        if (position_ != text_.size()) fail(column(), "expected the end after the list");
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
        const char open = peek();
        if (open != '{' && open != '(') {
            const char* start = text_.data() + position_;
            const auto [end, error] =
                std::from_chars(start, text_.data() + text_.size(), item.number);
            if (error != std::errc{}) fail(column(), "expected '{' or a number");
            item.is_number = true;
            position_ += static_cast<std::size_t>(end - start);
            return item;
        }
        const char close = open == '(' ? ')' : '}';
        ++position_;
        skip_blanks();
        while (peek() != close) {
            if (!item.items.empty()) {
                if (peek() != ',') fail(column(), std::string("expected ',' or '") + close + "'");
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

Features problem_of_macaulay2(const NestedList& list) {
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

int number(const NestedList& item, const std::string& what, int least, int most) {
    if (!item.is_number || item.number < least || item.number > most)
        fail(item.column, "expected " + what + ", from " + std::to_string(least) + " to " +
                              std::to_string(most) + ", as in (5,0,{{0,1,3},{0,2,4},{1,2}})");
    return item.number;
}

std::vector<int> points_of_line(const NestedList& list, int points) {
    if (!list.items.empty() && points == 0) fail(list.column, "there are no points");
    std::vector<int> line = numbers(list, "the number of a point, counted from 0", 0, points - 1);
    std::ranges::sort(line);
    if (std::ranges::adjacent_find(line) != line.end())
        fail(list.column, "expected each point of a line once");
    return line;
}

/// The problem in which all views see everything.
Problem visible_problem(const CameraModel& cameras, int views, int points,
                        const std::vector<std::vector<int>>& lines) {
    const ViewSet all = all_views(views);
    Problem result{&cameras, views, {}, {}};
    result.points.assign(static_cast<std::size_t>(points), all);
    for (const std::vector<int>& line : lines)
        result.lines.push_back({line, all});
    refuse_invalid(result);
    return *in_order_of_construction(result);
}

/// The same in the number of views that makes it balanced.
Problem balanced_problem(const CameraModel& cameras, int points,
                         const std::vector<std::vector<int>>& lines) {
    std::vector<Problem> found;
    for (int views = 2; views <= most_views; ++views) {
        Problem candidate = visible_problem(cameras, views, points, lines);
        if (is_balanced(candidate)) found.push_back(std::move(candidate));
    }
    if (found.size() == 1) return found.front();
    throw NotationError(
        found.empty()
            ? "no number of views makes this problem balanced: write the number after the lines"
            : "several numbers of views make this problem balanced: write one after the lines");
}

} // namespace

Features read_list(std::string_view text) {
    const NestedList list = ListReader(text).read();
    if (!list.items.empty() && list.items[0].is_number) {
        if (list.items.size() != feature_count)
            fail(list.column,
                 "expected a signature of 27 numbers, found " + std::to_string(list.items.size()));
        return problem_of_counts(numbers(list, "a multiplicity from 0 to 99", 0, 99));
    }
    return problem_of_macaulay2(list);
}

Problem read_plmp(std::string_view text, const CameraModel& cameras) {
    const NestedList list = ListReader(text).read();
    const std::vector<NestedList>& items = list.items;
    if (items.size() < 3 || items.size() > 4 || items[2].is_number)
        fail(list.column, "expected numbers of points and of free lines, and lines, as in "
                          "(5,0,{{0,1,3},{0,2,4},{1,2}})");
    const int points = number(items[0], "the number of points", 0, most_points);
    const int free_lines = number(items[1], "the number of lines without points", 0, most_lines);
    std::vector<std::vector<int>> lines;
    for (const NestedList& line : items[2].items)
        lines.push_back(points_of_line(line, points));
    lines.insert(lines.end(), static_cast<std::size_t>(free_lines), {});
    if (points + std::ssize(lines) == 0) fail(list.column, "expected at least one point or line");
    if (items.size() == 3) return balanced_problem(cameras, points, lines);
    const int views = number(items[3], "the number of views", 2, most_views);
    return visible_problem(cameras, views, points, lines);
}

} // namespace plprove
