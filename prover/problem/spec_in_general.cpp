#include "prover/problem/spec.h"

#include "prover/problem/complete_visibility.h"
#include "prover/problem/names.h"
#include "prover/problem/notation.h"
#include "prover/system/words.h"

#include <algorithm>
#include <charconv>

namespace plprove {

namespace {

/// Reads PLMP's encoding without its blanks.
class EncodingReader {
public:
    explicit EncodingReader(std::string_view text) {
        for (const char c : text)
            if (c != ' ' && c != '\t') text_ += c;
    }

    Problem read(const CameraModel& model) {
        take('(');
        const int points = number("the number of points", most_points);
        take(',');
        const int free_lines = number("the number of lines without points", most_lines);
        take(',');
        std::vector<std::vector<int>> lines = list_of_lines(points);
        int views = 0;
        if (peek() == ',') {
            take(',');
            views = number("the number of views", most_views);
            if (views < 2) fail("at least 2 views");
        }
        take(')');
        if (position_ != text_.size()) fail("the end");
        if (points + free_lines + std::ssize(lines) == 0) fail("at least one point or line");
        lines.insert(lines.end(), static_cast<std::size_t>(free_lines), {});
        return views == 0 ? balanced(model, points, lines) : problem(model, views, points, lines);
    }

private:
    [[noreturn]] void fail(const std::string& expected) const {
        const std::string rest = printable(text_.substr(position_, 8), 8);
        throw NotationError("in PLMP's encoding: found " +
                            (rest.empty() ? "the end" : "'" + rest + "'") + ", expected " +
                            expected + ", as in (5,0,{{0,1,3},{0,2,4},{1,2}})");
    }

    char peek() const { return position_ < text_.size() ? text_[position_] : '\0'; }

    void take(char c) {
        if (peek() != c) fail(std::string("'") + c + "'");
        ++position_;
    }

    int number(const std::string& what, int most) {
        int value = 0;
        const char* const start = text_.data() + position_;
        const auto [end, error] = std::from_chars(start, text_.data() + text_.size(), value);
        if (error != std::errc{} || value < 0 || value > most)
            fail(what + ", from 0 to " + std::to_string(most));
        position_ += static_cast<std::size_t>(end - start);
        return value;
    }

    std::vector<std::vector<int>> list_of_lines(int points) {
        std::vector<std::vector<int>> lines;
        take('{');
        while (peek() != '}') {
            if (!lines.empty()) take(',');
            lines.push_back(line(points));
        }
        take('}');
        return lines;
    }

    std::vector<int> line(int points) {
        std::vector<int> result;
        take('{');
        while (peek() != '}') {
            if (!result.empty()) take(',');
            if (points == 0) fail("no point, as there are none");
            result.push_back(number("the number of a point", points - 1));
        }
        take('}');
        std::ranges::sort(result);
        if (std::ranges::adjacent_find(result) != result.end()) fail("each point of a line once");
        return result;
    }

    static Problem problem(const CameraModel& model, int views, int points,
                           const std::vector<std::vector<int>>& lines) {
        const ViewSet all = all_views(views);
        Problem result{&model, views, {}, {}};
        result.points.assign(static_cast<std::size_t>(points), all);
        for (const std::vector<int>& line : lines)
            result.lines.push_back({line, all});
        refuse_invalid(result);
        return *in_order_of_construction(result);
    }

    static Problem balanced(const CameraModel& model, int points,
                            const std::vector<std::vector<int>>& lines) {
        std::vector<Problem> found;
        for (int views = 2; views <= most_views; ++views) {
            Problem candidate = problem(model, views, points, lines);
            if (is_balanced(candidate)) found.push_back(std::move(candidate));
        }
        if (found.size() == 1) return found.front();
        throw NotationError(
            found.empty()
                ? "no number of views makes this problem balanced: write the number after the lines"
                : "several numbers of views make this problem balanced: write one after the lines");
    }

    std::string text_;
    std::size_t position_ = 0;
};

bool is_shared_letter(char c) {
    return c >= 'A' && c <= 'Z' && c != 'P';
}

/// Whether a shared line stands after the `P` of a point, or in two places.
bool has_shared_line(std::string_view text) {
    for (std::size_t i = 0; i < text.size(); ++i) {
        if (!is_shared_letter(text[i])) continue;
        const bool after_point = i > 0 && text[i - 1] == 'P';
        if (after_point || std::ranges::count(text, text[i]) > 1) return true;
    }
    return false;
}

/// Notation that only problems in general have.
bool is_general_notation(std::string_view text) {
    if (text.find('/') == std::string_view::npos) return false;
    const std::string_view first = text.substr(0, text.find('+'));
    return has_shared_line(text) || std::ranges::count(first, '/') > 2;
}

bool looks_like_plmp_name(std::string_view text) {
    constexpr std::size_t underscore = 4;
    if (text.size() <= underscore + 1 || text[underscore] != '_') return false;
    const auto digits = [](std::string_view part) {
        return part.find_first_not_of("0123456789") == std::string_view::npos;
    };
    return digits(text.substr(0, underscore)) && digits(text.substr(underscore + 1));
}

std::optional<Problem> problem_of_plmp(std::string_view text) {
    if (!looks_like_plmp_name(text) || problem_named(text)) return std::nullopt;
    const std::vector<Problem> problems = family_problems(Family::plmp);
    const auto found = std::ranges::find(problems, text, name);
    if (found == problems.end()) return std::nullopt;
    return *found;
}

} // namespace

std::optional<Problem> parse_general_spec(std::string_view text) {
    const auto trim = [](std::string_view part) {
        const std::size_t first = part.find_first_not_of(" \t");
        if (first == std::string_view::npos) return std::string_view{};
        return part.substr(first, part.find_last_not_of(" \t") + 1 - first);
    };
    text = trim(text);
    const CameraModel& cameras = cameras_of(text);
    const std::string_view rest = trim(text.substr(cameras.prefix.size()));
    if (rest.starts_with('(')) return EncodingReader(rest).read(cameras);
    if (!cameras.prefix.empty() || is_general_notation(text)) return parse_problem(text);
    return problem_of_plmp(text);
}

} // namespace plprove
