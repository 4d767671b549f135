#include "prover/degree_sweep/read_record.h"

#include "prover/problem/notation.h"
#include "prover/problem/signature.h"

#include <charconv>
#include <string>

namespace plprove {

namespace {

constexpr std::int64_t largest_value = 999'999'999'999'999'999;
constexpr std::int64_t most_bits = 200;
constexpr int unknowns = 11;

/// A record is not what it should be; caught in this file.
struct Damaged {};

/// The words of a record, one after another.
class Words {
public:
    explicit Words(std::string_view text) : text_(text) {}

    bool at_end() const { return text_.empty(); }

    /// Whether these words come next; takes them, and one space behind them, if they do.
    bool takes(std::string_view words) {
        if (!text_.starts_with(words)) return false;
        std::string_view rest = text_.substr(words.size());
        if (rest.starts_with(' ')) {
            rest.remove_prefix(1);
            if (rest.starts_with('\n')) return false;
        } else if (!rest.starts_with('\n')) {
            return false;
        }
        text_ = rest;
        return true;
    }

    void take(std::string_view words) {
        if (!takes(words)) throw Damaged();
    }

    /// An integer as std::to_string writes it.
    std::int64_t integer(std::int64_t least, std::int64_t most) {
        const std::string_view word = text_.substr(0, text_.find_first_of(" \n"));
        std::int64_t value = 0;
        std::from_chars(word.data(), word.data() + word.size(), value);
        if (word != std::to_string(value) || value < least || value > most) throw Damaged();
        take(word);
        return value;
    }

    void coordinates() {
        for (int i = 0; i < 3; ++i)
            integer(-largest_value, largest_value);
    }

    void end_line() {
        if (!text_.starts_with('\n')) throw Damaged();
        text_.remove_prefix(1);
    }

private:
    std::string_view text_;
};

void take_image(Words& words, const Feature& feature) {
    words.take("image");
    words.take(notation(feature));
    for (int view = 0; view < feature.views(); ++view) {
        const bool point = feature.sees_point(view);
        int lines = 0;
        for (int line = 0; line < feature.lines; ++line)
            lines += feature.sees_line(view, line) ? 1 : 0;
        if (!point && lines == 0) continue;
        words.take("view");
        if (point) {
            words.take("point");
            words.coordinates();
        }
        for (int line = 0; line < lines; ++line) {
            words.take(point ? "toward" : "line");
            words.coordinates();
        }
    }
    words.end_line();
}

/// Returns for how many solutions the line stands.
int take_solution(Words& words) {
    const bool real = words.takes("real");
    if (!real) words.take("pair");
    words.integer(0, most_bits);
    for (int i = 0; i < (real ? unknowns : 2 * unknowns); ++i)
        words.integer(-largest_value, largest_value);
    words.end_line();
    return real ? 1 : 2;
}

int take_record(Words& words, std::size_t number) {
    words.take("degree");
    words.take(std::to_string(number));
    words.take("evidence none");
    words.end_line();
    for (const Feature& feature : problem_of(label_classes()[number]))
        take_image(words, feature);
    int solutions = 0;
    do
        solutions += take_solution(words);
    while (!words.at_end());
    return solutions;
}

} // namespace

std::optional<int> read_record(std::string_view record, std::size_t number) {
    if (number >= label_classes().size()) return std::nullopt;
    Words words(record);
    try {
        return take_record(words, number);
    } catch (const Damaged&) {
        return std::nullopt;
    }
}

} // namespace plprove
