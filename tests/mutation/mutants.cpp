#include "tests/mutation/edits.h"

namespace mutation {

namespace {

constexpr std::string_view digits = "0123456789";

bool number(const Words& words, std::size_t i) {
    return is_number(words[i]);
}

/// Lines with vectors: of cameras, of points, lines and pins in space, of images.
constexpr std::array<std::string_view, 3> with_vectors{"camera", "feature", "image"};

/// A coordinate of a vector.
bool coordinate(const Words& words, std::size_t i) {
    return is_number(words[i]) && std::ranges::find(with_vectors, words[0]) != with_vectors.end() &&
           (words[0] != "camera" || i > 2);
}

Wanted number_in(std::initializer_list<std::string_view> first) {
    return [first = std::vector<std::string_view>(first)](const Words& words, std::size_t i) {
        return is_number(words[i]) && std::ranges::find(first, words[0]) != first.end();
    };
}

void negate(std::string& word) {
    multiply(word, -1);
}

void digit(File& file, const File&, Random& random) {
    change(file, random, number, [&](std::string& word) {
        const std::size_t place = random.below(word.size());
        word[place] = digits[random.below(10)];
    });
}

void sign(File& file, const File&, Random& random) {
    change(file, random, number, negate);
}

void by_one(File& file, const File&, Random& random) {
    change(file, random, number, [&](std::string& word) { step(word, random); });
}

void coordinates(File& file, const File&, Random& random) {
    change(file, random, coordinate, [&](std::string& word) {
        if (random.below(4) == 0)
            word = std::to_string(random.below(1'999'999)), add(word, -999'999);
        else
            word = std::to_string(random.below(19)), add(word, -9);
    });
}

/// A point, a direction or a quaternion times -1, 0 or 2: projectively the same, or nothing.
void scaled_vector(File& file, const File&, Random& random) {
    const auto lines = lines_of(file, with_vectors);
    if (lines.empty()) return;
    Words& words = file[any_of(lines, random)];
    std::vector<std::size_t> starts;
    for (std::size_t i = 0; i + 3 < words.size(); ++i)
        if (!is_number(words[i]) && is_number(words[i + 1])) starts.push_back(i + 1);
    if (starts.empty()) return;
    const long factor = std::array{-1L, 0L, 2L}[random.below(3)];
    for (std::size_t i = any_of(starts, random); i < words.size() && is_number(words[i]); ++i)
        multiply(words[i], factor);
}

void indices(File& file, const File&, Random& random) {
    change(file, random,
           number_in({"delete", "pool", "reduce", "camera", "minimal", "deficient", "degree",
                      "real", "pair", "basis", "rows"}),
           [&](std::string& word) { word = std::to_string(random.below(40)); });
}

void deleted_lines(File& file, const File&, Random& random) {
    const auto lines = lines_of(file, {"delete"});
    if (lines.empty()) return;
    Words& words = file[any_of(lines, random)];
    if (words.size() < 3) return; // an earlier change has shortened it
    const std::size_t place = 2 + random.below(words.size() - 2);
    const auto here = at(words, place);
    switch (random.below(3)) {
    case 0:
        words.erase(here);
        return;
    case 1:
        words.insert(here, std::to_string(1 + random.below(30)));
        return;
    default:
        if (is_number(*here)) step(*here, random);
    }
}

void minor(File& file, const File& other, Random& random) {
    const Wanted wanted = [](const Words& words, std::size_t i) {
        return i + 1 == words.size() && (words[0] == "minimal" || words[0] == "minor");
    };
    File copy = other;
    const auto others = find(copy, wanted);
    change(file, random, wanted, [&](std::string& word) {
        if (!is_number(word)) return;
        const mpz_class q("2305843009213693951");
        const mpz_class value(word);
        switch (random.below(5)) {
        case 0:
            word = mpz_class(q - value).get_str();
            return;
        case 1:
            word = mpz_class(q + value).get_str();
            return;
        case 2:
            word = mpz_class(value - q).get_str();
            return;
        case 3:
            word = "0";
            return;
        default:
            if (!others.empty()) word = *any_of(others, random);
        }
    });
}

void kernel(File& file, const File& other, Random& random) {
    const auto lines = lines_of(file, {"kernel"});
    if (lines.empty()) return;
    Words& words = file[any_of(lines, random)];
    if (words.size() < 2) return;
    const auto others = lines_of(other, {"kernel"});
    switch (random.below(6)) {
    case 0: // the same motion, but not primitive
        for (std::size_t i = 1; i < words.size(); ++i)
            multiply(words[i], 2);
        return;
    case 1: // ... but negative
        std::for_each(words.begin() + 1, words.end(), negate);
        return;
    case 2: // nothing moves
        std::fill(words.begin() + 1, words.end(), "0");
        return;
    case 3:
        if (!others.empty()) words = other[any_of(others, random)];
        return;
    case 4: { // another motion of the space, if the other one is in it
        const Words& second = file[any_of(lines, random)];
        for (std::size_t i = 1; i < std::min(words.size(), second.size()); ++i)
            words[i] = mpz_class(value_of(words[i]) + value_of(second[i])).get_str();
        return;
    }
    default:
        step(words[1 + random.below(words.size() - 1)], random);
    }
}

void remove_line(File& file, const File&, Random& random) {
    file.erase(at(file, random.below(file.size())));
}

void repeat_line(File& file, const File&, Random& random) {
    const std::size_t line = random.below(file.size());
    const Words copy = file[line];
    const std::size_t target = random.below(2) == 0 ? line : random.below(file.size() + 1);
    file.insert(at(file, target), copy);
}

void swap_lines(File& file, const File&, Random& random) {
    std::swap(any_of(file, random), any_of(file, random));
}

/// Two placed features, or images of features, trade places or coordinates.
void swap_features(File& file, const File&, Random& random) {
    const auto lines = lines_of(file, {"feature", "image"});
    if (lines.empty()) return;
    Words& a = file[any_of(lines, random)];
    Words& b = file[any_of(lines, random)];
    if (a.size() < 2 || b.size() < 2) return;
    if (random.below(2) == 0) std::swap(a[1], b[1]);
    std::swap(a, b);
}

void swap_words(File& file, const File&, Random& random) {
    Words& words = any_of(file, random);
    std::swap(any_of(words, random), any_of(words, random));
}

void remove_word(File& file, const File&, Random& random) {
    Words& words = any_of(file, random);
    if (words.size() > 1) words.erase(at(words, random.below(words.size())));
}

void repeat_word(File& file, const File&, Random& random) {
    Words& words = any_of(file, random);
    const std::size_t place = random.below(words.size());
    const std::string copy = words[place];
    words.insert(at(words, place), copy);
}

void foreign_word(File& file, const File& other, Random& random) {
    Words& words = any_of(file, random);
    any_of(words, random) = any_of(any_of(other, random), random);
}

void foreign_line(File& file, const File& other, Random& random) {
    const std::size_t line = random.below(file.size());
    const auto alike = lines_of(other, {file[line][0]});
    if (!alike.empty()) file[line] = other[any_of(alike, random)];
}

/// The head of this file, the tail of the other, cut at lines that begin alike.
void splice(File& file, const File& other, Random& random) {
    const std::size_t line = random.below(file.size());
    const auto alike = lines_of(other, {file[line][0]});
    if (alike.empty()) return;
    file.resize(line);
    const std::size_t from = any_of(alike, random);
    file.insert(file.end(), at(other, from), other.end());
}

/// A line that goes on in the next one: as it should, with a comment or an empty line between, or
/// at its end.
void continued(File& file, const File&, Random& random) {
    const std::size_t line = random.below(file.size());
    const Words words = file[line];
    if (words.empty()) return;
    const std::size_t place = 1 + random.below(words.size());
    Words start(words.begin(), at(words, place)), rest(at(words, place), words.end());
    start.push_back("\\");
    std::vector<Words> lines{start};
    const std::size_t kind = random.below(8);
    if (kind == 0) lines.push_back({"#", "a", "comment"});
    if (kind == 1) lines.push_back({""});
    if (kind == 2) lines.push_back({"\\"});
    if (!rest.empty()) lines.push_back(rest);
    file.erase(at(file, line));
    file.insert(at(file, line), lines.begin(), lines.end());
}

void comment(File& file, const File&, Random& random) {
    file.insert(at(file, random.below(file.size() + 1)), {"#", "a", "comment"});
}

void byte(File& file, const File&, Random& random) {
    std::string& word = any_of(any_of(file, random), random);
    if (word.empty()) return;
    word[random.below(word.size())] = static_cast<char>(random.below(256));
}

constexpr std::array of_any_file{Mutator{"digit", digit},
                                 Mutator{"sign", sign},
                                 Mutator{"plus or minus 1", by_one},
                                 Mutator{"coordinate", coordinates},
                                 Mutator{"scaled vector", scaled_vector},
                                 Mutator{"index", indices},
                                 Mutator{"deleted rows, columns", deleted_lines},
                                 Mutator{"minor", minor},
                                 Mutator{"kernel", kernel},
                                 Mutator{"line missing", remove_line},
                                 Mutator{"line repeated", repeat_line},
                                 Mutator{"lines swapped", swap_lines},
                                 Mutator{"features swapped", swap_features},
                                 Mutator{"words swapped", swap_words},
                                 Mutator{"word missing", remove_word},
                                 Mutator{"word repeated", repeat_word},
                                 Mutator{"word of another file", foreign_word},
                                 Mutator{"line of another file", foreign_line},
                                 Mutator{"splice of two files", splice},
                                 Mutator{"line continued", continued},
                                 Mutator{"comment", comment},
                                 Mutator{"byte", byte}};

} // namespace

File split(std::string_view text) {
    File file;
    while (!text.empty()) {
        std::string_view line = text.substr(0, text.find('\n'));
        text.remove_prefix(std::min(line.size() + 1, text.size()));
        Words& words = file.emplace_back();
        while (!line.empty()) {
            words.emplace_back(line.substr(0, line.find(' ')));
            line.remove_prefix(std::min(words.back().size() + 1, line.size()));
        }
    }
    return file;
}

std::string join(const File& file) {
    std::string text;
    for (const Words& words : file) {
        for (std::size_t i = 0; i < words.size(); ++i)
            (text += i == 0 ? "" : " ") += words[i];
        text += '\n';
    }
    return text;
}

std::optional<Mutant> mutant(const std::string& base, const std::string& other, std::size_t turn,
                             Random& random) {
    static const std::vector<Mutator> all = [] {
        std::vector<Mutator> list(of_any_file.begin(), of_any_file.end());
        for (const auto& more :
             {problem_mutators(), general_mutators(), degree_mutators(), model_mutators()})
            list.insert(list.end(), more.begin(), more.end());
        return list;
    }();
    const File foreign = split(other);
    const Mutator& mutator = all[turn % all.size()];
    File file = split(base);
    mutator.apply(file, foreign, random);
    if (join(file) == base) return {};
    if (random.below(8) == 0 && !file.empty()) any_of(all, random).apply(file, foreign, random);
    const std::string text = join(file);
    if (text == base) return {};
    return Mutant{mutator.name, text};
}

} // namespace mutation
