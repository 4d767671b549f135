#include "prover/problem/notation_in_general.h"

#include <algorithm>

namespace plprove {

namespace {

/// The letters of lines with two points or more, in the order in which they are used.
constexpr std::string_view shared_letters = "LMNOQRSTUVWXYZABCDEFGHIJK";

struct Letter {
    char name;
    ViewSet seen;
};

/// The letters of the lines through a point, as they are written after its `P`: shared lines, then
/// pins. `names` has the letter of each shared line.
std::vector<Letter> letters_of_point(const Problem& problem, int point,
                                     const std::vector<char>& names) {
    std::vector<Letter> shared, pins;
    for (const int number : lines_through(problem, point)) {
        const Line& line = problem.lines[static_cast<std::size_t>(number)];
        if (line.points.size() >= 2)
            shared.push_back({names[static_cast<std::size_t>(number)], line.seen});
        else
            pins.push_back({static_cast<char>('a' + pins.size()), line.seen});
    }
    std::ranges::sort(shared, {}, &Letter::name);
    shared.insert(shared.end(), pins.begin(), pins.end());
    return shared;
}

std::string feature_text(int views, bool has_point, ViewSet seen,
                         const std::vector<Letter>& letters) {
    std::string text;
    for (int view = 0; view < views; ++view) {
        std::string symbol = contains(seen, view) ? "P" : "";
        for (const Letter& letter : letters)
            if (contains(letter.seen, view)) symbol += letter.name;
        text += (view == 0 ? "" : "/") + (symbol.empty() ? "-" : symbol);
    }
    // An unseen point with two lines or more needs no mention.
    std::string unseen = has_point && seen == 0 && letters.size() < 2 ? "P" : "";
    for (const Letter& letter : letters)
        if (letter.seen == 0) unseen += letter.name;
    return unseen.empty() ? text : text + "(" + unseen + ")";
}

} // namespace

std::string notation(const Problem& problem) {
    std::vector<char> names(problem.lines.size(), '?');
    std::size_t used = 0;
    std::vector<std::string> features;
    for (int point = 0; point < static_cast<int>(problem.points.size()); ++point) {
        for (const int number : lines_through(problem, point)) {
            char& name = names[static_cast<std::size_t>(number)];
            const bool shared = problem.lines[static_cast<std::size_t>(number)].points.size() >= 2;
            if (shared && name == '?') name = shared_letters[used++];
        }
        features.push_back(feature_text(problem.views, true,
                                        problem.points[static_cast<std::size_t>(point)],
                                        letters_of_point(problem, point, names)));
    }
    for (const Line& line : problem.lines)
        if (line.points.empty())
            features.push_back(feature_text(problem.views, false, 0, {{'a', line.seen}}));
    std::string text = problem.model == CameraModel::projective ? "projective: " : "";
    for (std::size_t i = 0; i < features.size();) {
        const auto first = features.begin() + static_cast<std::ptrdiff_t>(i);
        const auto next =
            std::find_if(first, features.end(), [&](const auto& f) { return f != *first; });
        const auto count = next - first;
        text += (i == 0 ? "" : " + ") + (count == 1 ? "" : std::to_string(count) + "*") + *first;
        i += static_cast<std::size_t>(count);
    }
    return text;
}

} // namespace plprove
