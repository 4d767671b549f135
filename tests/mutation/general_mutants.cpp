#include "tests/mutation/edits.h"

namespace mutation {

namespace {

bool in_record(const File& file) {
    return file[0].back() == "problems" && file.size() > 3;
}

void number_added(File& file, const File&, Random& random) {
    if (!in_record(file)) return;
    Words& words = any_of(file, random);
    words.insert(at(words, random.below(words.size() + 1)), std::to_string(1 + random.below(7)));
}

/// A shared or local letter taken from a feature, or added, in all of its views.
void letter(File& file, const File&, Random& random) {
    if (!in_record(file)) return;
    const std::string letters = "aLM";
    const char one = letters[random.below(letters.size())];
    change(
        file, random, [](const Words& words, std::size_t i) { return is_feature(words[i]); },
        [&](std::string& word) {
            std::string changed;
            const bool removes = word.find(one) != word.npos;
            for (const char c : word) {
                if (c != one) changed += c;
                if (c == 'P' && !removes) changed += one;
            }
            word = changed;
        });
}

/// The features in another order: other numbers for the same points and lines.
void features_reordered(File& file, const File&, Random& random) {
    if (!in_record(file)) return;
    std::vector<std::string*> found;
    for (std::string& word : file[2])
        if (is_feature(word)) found.push_back(&word);
    if (found.size() > 1) std::swap(*any_of(found, random), *any_of(found, random));
}

/// The same claim of another problem.
void foreign_problem(File& file, const File& other, Random&) {
    if (in_record(file) && in_record(other)) file[2] = other[2];
}

/// The same of calibrated cameras, or of others.
void other_cameras(File& file, const File&, Random& random) {
    if (!in_record(file) || file[2].size() < 2) return;
    const std::vector<std::string> prefixes{
        "projective:", "focal:", "shared-focal:", "shared-k:", "upright:", "upright-focal:"};
    if (file[2][1].ends_with(':'))
        file[2].erase(at(file[2], 1));
    else
        file[2].insert(at(file[2], 1), any_of(prefixes, random));
}

/// The motion made simpler, or another one.
void motion(File& file, const File&, Random& random) {
    for (Words& words : file) {
        if (words[0] != "motion" || words.size() < 2) continue;
        const auto chosen = random.below(6);
        if (chosen == 0)
            words = {"motion", "none"};
        else if (chosen == 1)
            words = {"motion", "directions"};
        else if (chosen < 4 && words[1] == "projective")
            words.erase(at(words, 1));
        else if (chosen < 4)
            words.insert(at(words, 1), "projective");
        else if (words[1] == "plane" || random.below(2) == 0)
            words = {"motion", "star", "1", "views", "1", "2", "points", "lines"};
        else
            words = {"motion", "plane", "views", "1", "2", "points", "1", "2", "3", "lines"};
    }
}

void other_record(File& file, const File& other, Random&) {
    if (in_record(file) && in_record(other))
        file.insert(file.end(), other.begin() + 3, other.end());
}

constexpr std::array all{Mutator{"a number more", number_added},
                         Mutator{"letter of a feature", letter},
                         Mutator{"features reordered", features_reordered},
                         Mutator{"a problem in general", foreign_problem},
                         Mutator{"other cameras", other_cameras},
                         Mutator{"another motion", motion},
                         Mutator{"lines of another record", other_record}};

} // namespace

std::span<const Mutator> general_mutators() {
    return all;
}

} // namespace mutation
