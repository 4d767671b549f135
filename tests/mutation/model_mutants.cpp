#include "tests/mutation/edits.h"

namespace mutation {

namespace {

/// The lines of the text of a model, from the first statement to the last.
struct Text {
    std::size_t begin = 0;
    std::size_t end = 0;
};

Text text_of(const File& file) {
    if (file.empty() || file[0].back() != "model") return {};
    const auto end = lines_of(file, {"modulus"});
    const std::size_t begin = file.size() > 2 && file[2][0] == "claimed" ? 3 : 2;
    return end.empty() || end[0] <= begin ? Text{} : Text{begin, end[0]};
}

/// A line of the text that is no part of a loop's frame; that of other statements, if such is
/// given.
std::optional<std::size_t> statement_in(const File& file, Random& random,
                                        std::initializer_list<std::string_view> kinds = {}) {
    const Text text = text_of(file);
    std::vector<std::size_t> found;
    for (std::size_t i = text.begin; i < text.end; ++i) {
        const std::string& kind = file[i][0];
        const bool wanted =
            kinds.size() > 0 ? std::ranges::count(kinds, kind) > 0 : kind != "for" && kind != "end";
        if (wanted) found.push_back(i);
    }
    return found.empty() ? std::nullopt : std::optional(any_of(found, random));
}

/// Changes a word of the text that is wanted.
template <class Wanted, class Change>
void change_text(File& file, Random& random, Wanted wanted, Change change) {
    const Text text = text_of(file);
    std::vector<std::string*> found;
    for (std::size_t i = text.begin; i < text.end; ++i)
        for (std::size_t k = 1; k < file[i].size(); ++k)
            if (wanted(file[i], k)) found.push_back(&file[i][k]);
    if (!found.empty()) change(*any_of(found, random));
}

void statement_lost(File& file, const File&, Random& random) {
    if (const auto line = statement_in(file, random)) file.erase(at(file, *line));
}

void statement_again(File& file, const File&, Random& random) {
    const auto line = statement_in(file, random);
    if (!line) return;
    const Words copy = file[*line];
    file.insert(at(file, *line), copy);
}

void foreign_statement(File& file, const File& other, Random& random) {
    const auto line = statement_in(file, random), foreign = statement_in(other, random);
    if (!line || !foreign) return;
    if (random.below(2) == 0)
        file[*line] = other[*foreign];
    else
        file.insert(at(file, *line), other[*foreign]);
}

/// An equation in the place of another one, so that there are as many as before.
void equation_twice(File& file, const File&, Random& random) {
    const auto from = statement_in(file, random, {"equation"});
    const auto to = statement_in(file, random, {"equation"});
    if (from && to) file[*to] = file[*from];
}

/// An equation for a relation, a condition for what counts, or the reverse.
void another_kind(File& file, const File&, Random& random) {
    const auto line = statement_in(file, random, {"equation", "relation", "nonzero", "count"});
    if (!line) return;
    std::string& kind = file[*line][0];
    if (kind == "equation" || kind == "relation")
        kind = kind == "equation" ? "relation" : "equation";
    else
        kind = kind == "count" ? "nonzero" : "count";
}

void constant(File& file, const File&, Random& random) {
    change_text(
        file, random, [](const Words& words, std::size_t k) { return is_number(words[k]); },
        [&](std::string& word) {
            if (random.below(3) == 0)
                word = std::to_string(random.below(9));
            else
                step(word, random);
        });
}

void operation(File& file, const File&, Random& random) {
    static const std::vector<std::string> operations{"+", "-", "*", "/", "=", "~", ",", "^"};
    change_text(
        file, random,
        [](const Words& words, std::size_t k) {
            return std::ranges::count(operations, words[k]) > 0;
        },
        [&](std::string& word) { word = operations[random.below(word == "=" ? 6 : 4)]; });
}

/// A name, or an index, of the text in the place of another one.
void name(File& file, const File&, Random& random) {
    const auto is_name = [](const Words& words, std::size_t k) {
        const char c = words[k].empty() ? ' ' : words[k][0];
        return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z');
    };
    std::string chosen;
    change_text(file, random, is_name, [&](const std::string& word) { chosen = word; });
    change_text(file, random, is_name, [&](std::string& word) { word = chosen; });
}

/// A factor, a power or a further term.
void term(File& file, const File&, Random& random) {
    static const std::vector<Words> terms{{"*", "2"}, {"^", "2"}, {"-", "1"}, {"+", "0"},
                                          {"*", "0"}, {"*", "1"}, {"/", "2"}, {"/", "1"}};
    const auto line =
        statement_in(file, random, {"equation", "let", "nonzero", "relation", "count"});
    if (!line) return;
    Words& words = file[*line];
    const Words& added = any_of(terms, random);
    words.insert(at(words, 1 + random.below(words.size())), added.begin(), added.end());
}

/// What counts is left out, with what fibres say of it; or it is some unknown.
void what_counts(File& file, const File&, Random& random) {
    const auto count = statement_in(file, random, {"count"});
    const auto unknown = statement_in(file, random, {"unknown"});
    if (!unknown || file[*unknown].size() < 2) return;
    const std::string chosen = file[*unknown][1];
    if (count && random.below(2) == 0)
        file[*count] = {"count", chosen};
    else if (count)
        file.erase(at(file, *count));
    else
        file.insert(at(file, text_of(file).end), {"count", chosen});
    if (random.below(4) == 0) return;
    for (const std::size_t line : lines_of(file, {"distinct"}))
        file[line] = {"#", "left", "out"};
    const auto fibres = lines_of(file, {"fibre"}), separated = lines_of(file, {"separated"});
    if (count || fibres.empty() || separated.empty() || file[fibres[0]].size() < 2) return;
    file.insert(at(file, separated[0] + 1),
                {"distinct", std::to_string(1 + random.below(4)), "by", "1"});
}

/// The text of another model, with the same records.
void foreign_text(File& file, const File& other, Random&) {
    const Text own = text_of(file), text = text_of(other);
    if (own.end == 0 || text.end == 0) return;
    file.erase(at(file, 1), at(file, own.end));
    file.insert(at(file, 1), at(other, 1), at(other, text.end));
}

void residue(File& file, const File&, Random& random) {
    if (text_of(file).end == 0) return;
    const Text text = text_of(file);
    std::vector<std::size_t> lines;
    for (std::size_t i = text.end; i < file.size(); ++i)
        for (const std::string_view first :
             {"data", "polynomial", "unknown", "separated", "distinct"})
            if (file[i][0] == first && file[i].size() > 1) lines.push_back(i);
    if (lines.empty()) return;
    Words& words = file[any_of(lines, random)];
    std::string& word = words[1 + random.below(words.size() - 1)];
    if (!is_number(word)) return;
    const mpz_class q("2305843009213693951");
    switch (random.below(4)) {
    case 0:
        step(word, random);
        return;
    case 1:
        word = std::to_string(random.below(2));
        return;
    case 2:
        word = mpz_class(q - value_of(word)).get_str();
        return;
    default:
        word = any_of(words, random);
    }
}

/// All numbers of a line of a fibre in the place of those of another one, or 0.
void line_of_fibre(File& file, const File&, Random& random) {
    const auto lines = lines_of(file, {"polynomial", "unknown"});
    std::vector<std::size_t> own;
    for (const std::size_t line : lines)
        if (file[line].size() > 1 && is_number(file[line][1])) own.push_back(line);
    if (own.empty() || text_of(file).end == 0) return;
    Words& words = file[any_of(own, random)];
    const Words& from = file[any_of(own, random)];
    if (random.below(3) == 0)
        std::fill(words.begin() + 1, words.end(), "0");
    else
        std::copy(from.begin() + 1,
                  from.begin() + static_cast<std::ptrdiff_t>(std::min(from.size(), words.size())),
                  words.begin() + 1);
}

/// A fibre of another degree, of the right shape: a coefficient more, or less, in each line.
void degree(File& file, const File&, Random& random) {
    const auto fibres = lines_of(file, {"fibre"});
    if (fibres.empty() || file[fibres[0]].size() < 2) return;
    std::string& count = file[fibres[0]][1];
    const bool more = random.below(2) == 0 || count == "1";
    add(count, more ? 1 : -1);
    const std::size_t place = 1 + random.below(value_of(count).get_ui() % 1000);
    for (std::size_t i = fibres[0] + 1; i < file.size() && file[i][0] != "elimination"; ++i) {
        Words& words = file[i];
        if (words.size() <= place || (words[0] != "polynomial" && words[0] != "unknown")) continue;
        if (more)
            words.insert(at(words, place), "0");
        else
            words.erase(at(words, place));
    }
}

/// More or fewer values that are distinct.
void distinct(File& file, const File&, Random& random) {
    const auto lines = lines_of(file, {"distinct"});
    if (lines.empty() || file[lines[0]].size() < 2) return;
    Words& words = file[any_of(lines, random)];
    if (random.below(2) == 0)
        step(words[1], random);
    else
        words[1] = std::to_string(1 + random.below(20));
}

/// Records of another model.
void foreign_record(File& file, const File& other, Random& random) {
    const std::string_view kind = random.below(2) == 0 ? "fibre" : "elimination";
    const auto own = lines_of(file, {kind}), others = lines_of(other, {kind});
    if (own.empty() || others.empty() || text_of(file).end == 0) return;
    const auto end_of = [&](const File& in, std::size_t line) {
        const auto next = lines_of(in, {"elimination"});
        return kind == "fibre" && !next.empty() && next[0] > line ? next[0] : in.size();
    };
    file.erase(at(file, own[0]), at(file, end_of(file, own[0])));
    file.insert(at(file, own[0]), at(other, others[0]), at(other, end_of(other, others[0])));
}

constexpr std::array all{Mutator{"statement missing", statement_lost},
                         Mutator{"statement repeated", statement_again},
                         Mutator{"statement of another", foreign_statement},
                         Mutator{"one equation twice", equation_twice},
                         Mutator{"another kind", another_kind},
                         Mutator{"constant or index", constant},
                         Mutator{"operation", operation},
                         Mutator{"name in the text", name},
                         Mutator{"term or factor", term},
                         Mutator{"what counts", what_counts},
                         Mutator{"text of another model", foreign_text},
                         Mutator{"residue", residue},
                         Mutator{"line of a fibre", line_of_fibre},
                         Mutator{"degree of a fibre", degree},
                         Mutator{"distinct values", distinct},
                         Mutator{"record of another model", foreign_record}};

} // namespace

std::span<const Mutator> model_mutators() {
    return all;
}

} // namespace mutation
