#include "prover/problem/spec.h"

#include "prover/problem/complete_visibility.h"
#include "prover/problem/encodings.h"
#include "prover/problem/names.h"
#include "prover/problem/signature.h"
#include "prover/system/words.h"

#include <algorithm>
#include <charconv>

namespace plprove {

namespace {

[[noreturn]] void fail(std::size_t column, const std::string& message) {
    throw NotationError("column " + std::to_string(column) + ": " + message);
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
    if (text[first] == '{') return read_list(text);
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
        return read_list(list);
    }
    if (text.find('/') == std::string_view::npos) {
        if (std::optional<Features> problem = problem_named(text)) return *std::move(problem);
        fail_on_unknown_name(text.substr(first));
    }
    return parse_features(text);
}

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
    const std::vector<Problem> problems = family_problems(calibrated_cameras);
    const auto found = std::ranges::find(problems, text, name);
    if (found == problems.end()) return std::nullopt;
    return *found;
}

} // namespace

Features parse_spec(std::string_view text) {
    Features problem = parse_any_spec(text);
    if (problem.size() > max_features)
        fail(1, "expected at most " + std::to_string(max_features) + " features");
    return problem;
}

std::optional<Problem> parse_general_spec(std::string_view text) {
    const auto trim = [](std::string_view part) {
        const std::size_t first = part.find_first_not_of(" \t");
        if (first == std::string_view::npos) return std::string_view{};
        return part.substr(first, part.find_last_not_of(" \t") + 1 - first);
    };
    text = trim(text);
    const CameraModel& cameras = cameras_of(text);
    const std::string_view rest = trim(text.substr(cameras.prefix.size()));
    if (rest.starts_with('(')) return read_plmp(rest, cameras);
    if (!cameras.prefix.empty() || is_general_notation(text)) return parse_problem(text);
    return problem_of_plmp(text);
}

} // namespace plprove
