#include "tests/mutation/edits.h"

namespace mutation {

namespace {

/// The certificate under another problem's name.
void foreign_problem(File& file, const File& other, Random&) {
    if (file[0].back() != "problem" || other.size() < 2) return;
    file[1] = other[1];
}

/// A symbol of a feature changed, in the name of the problem, a step or the pool.
void feature_symbol(File& file, const File&, Random& random) {
    change_symbol(file, random, file[0].back() == "problems" ? "PabLMN-/c(*2" : "Pab-/c(");
}

/// The same feature changed everywhere: a consistent lie.
void feature_everywhere(File& file, const File& other, Random& random) {
    const Wanted wanted = [](const Words& words, std::size_t i) { return is_feature(words[i]); };
    const auto found = find(file, wanted);
    File copy = other;
    const auto others = find(copy, wanted);
    if (found.empty() || others.empty()) return;
    const auto name = [](const std::string& word) { return word.substr(word.find('*') + 1); };
    const std::string from = name(*any_of(found, random));
    const std::string to = name(*any_of(others, random));
    for (std::string* word : found)
        if (const std::size_t at = word->find(from);
            at != word->npos && at + from.size() == word->size())
            word->replace(at, from.size(), to);
}

void multiplicity(File& file, const File&, Random& random) {
    if (file.size() < 2 || file[1][0] != "problem") return;
    std::string& word = any_of(file[1], random);
    if (!is_feature(word)) return;
    const std::size_t star = word.find('*');
    word = std::to_string(random.below(7)) + "*" + word.substr(star == word.npos ? 0 : star + 1);
}

void verdict(File& file, const File&, Random& random) {
    static const std::vector<std::string> names{"minimal",          "camera-minimal",
                                                "obstructed",       "under-constrained",
                                                "over-constrained", "deficient"};
    change(
        file, random,
        [](const Words& words, std::size_t i) {
            return (words[0] == "verdict" && i == 1) ||
                   std::ranges::find(names, words[i]) != names.end();
        },
        [&](std::string& word) { word = any_of(names, random); });
}

/// Verdict and evidence renamed together.
void both_verdicts(File& file, const File&, Random& random) {
    const bool camera = random.below(2) == 0;
    for (Words& words : file)
        for (std::string& word : words)
            if (word == "minimal" || word == "camera-minimal")
                word = camera ? "camera-minimal" : "minimal";
}

void steps(File& file, const File& other, Random& random) {
    static const std::vector<std::string> rules{"unseen-line",    "free-line",    "pin-seen-once",
                                                "pin-seen-twice", "unseen-point", "bare-point",
                                                "point-on-line",  "point-and-pin"};
    const auto lines = lines_of(file, {"reduce"});
    const auto others = lines_of(other, {"reduce"});
    const std::size_t kind = random.below(6);
    if (kind == 0 || lines.empty()) { // one more
        const auto verdicts = lines_of(file, {"verdict"});
        if (verdicts.empty()) return;
        Words step{"reduce", std::to_string(1 + random.below(5)), any_of(rules, random), "nothing"};
        if (!others.empty() && random.below(2) == 0) step = other[any_of(others, random)];
        file.insert(at(file, verdicts[0]), step);
        return;
    }
    Words& words = file[any_of(lines, random)];
    if (words.size() < 3) return;
    if (kind == 1)
        words[2] = any_of(rules, random);
    else if (kind == 2 && is_number(words[1]))
        step(words[1], random);
    else if (kind == 3)
        words.back() = "nothing";
    else if (kind == 4)
        file.erase(at(file, any_of(lines, random)));
    else
        std::swap(words, file[any_of(lines, random)]);
}

constexpr std::array all{Mutator{"another problem's name", foreign_problem},
                         Mutator{"symbol of a feature", feature_symbol},
                         Mutator{"feature everywhere", feature_everywhere},
                         Mutator{"multiplicity", multiplicity},
                         Mutator{"verdict", verdict},
                         Mutator{"verdict and evidence", both_verdicts},
                         Mutator{"reduction step", steps}};

} // namespace

std::span<const Mutator> problem_mutators() {
    return all;
}

} // namespace mutation
