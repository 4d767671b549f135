#include "tests/mutation/general_trial.h"

#include "tests/checker/minimal/image_rank.h"
#include "tests/mutation/edits.h"
#include "tests/mutation/replayed.h"
#include "tests/mutation/table.h"

#include <fstream>
#include <iterator>

namespace {

using namespace mutation;
using checker::ProblemsFile;

const std::string head = "plcert 2 problems\nmodulus 2305843009213693951\n";

/// Each record of the archives, as a file without a family.
std::vector<std::string> files() {
    std::vector<std::string> texts;
    for (const char* name : {"/plmp.plc", "/projective.plc"}) {
        std::ifstream stream(std::string(CERTS_DIR) + name, std::ios::binary);
        for (std::string line; std::getline(stream, line);) {
            if (line.starts_with("problem ")) texts.push_back(head);
            if (!texts.empty() && !line.starts_with("plcert") && !line.starts_with("family") &&
                !line.starts_with("modulus"))
                texts.back() += line + "\n";
        }
    }
    return texts;
}

bool in_record(const File& file) {
    return file.size() > 3;
}

void number_step(File& file, const File&, Random& random) {
    change(
        file, random, [](const Words& words, std::size_t i) { return is_number(words[i]); },
        [&](std::string& word) { step(word, random); });
}

void number_added(File& file, const File&, Random& random) {
    Words& words = any_of(file, random);
    words.insert(at(words, random.below(words.size() + 1)), std::to_string(1 + random.below(7)));
}

void word_removed(File& file, const File&, Random& random) {
    Words& words = any_of(file, random);
    if (words.size() > 1) words.erase(at(words, random.below(words.size())));
}

void symbol(File& file, const File&, Random& random) {
    change_symbol(file, random, "PabLMN-/c(*2");
}

/// A shared or local letter taken from a feature, or added, in all of its views.
void letter(File& file, const File&, Random& random) {
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
void features_swapped(File& file, const File&, Random& random) {
    if (file.size() < 3) return;
    std::vector<std::string*> found;
    for (std::string& word : file[2])
        if (is_feature(word)) found.push_back(&word);
    if (found.size() > 1) std::swap(*any_of(found, random), *any_of(found, random));
}

/// The same claim of another problem.
void foreign_problem(File& file, const File& other, Random&) {
    if (in_record(file) && in_record(other)) file[2] = other[2];
}

/// The same of projective cameras, or of calibrated ones.
void other_cameras(File& file, const File&, Random&) {
    if (!in_record(file) || file[2].size() < 2) return;
    if (file[2][1] == "projective:")
        file[2].erase(at(file[2], 1));
    else
        file[2].insert(at(file[2], 1), "projective:");
}

/// The motion made simpler, or another one.
void motion(File& file, const File&, Random& random) {
    for (Words& words : file) {
        if (words[0] != "motion") continue;
        if (random.below(3) == 0)
            words = {"motion", "none"};
        else if (words[1] == "plane" || random.below(2) == 0)
            words = {"motion", "star", "1", "views", "1", "2", "points", "lines"};
        else
            words = {"motion", "plane", "views", "1", "2", "points", "1", "2", "3", "lines"};
    }
}

void line_removed(File& file, const File&, Random& random) {
    file.erase(at(file, random.below(file.size())));
}

void other_record(File& file, const File& other, Random&) {
    if (in_record(file) && in_record(other))
        std::copy(at(other, 3), other.end(), std::back_inserter(file));
}

constexpr std::array<Mutator, 11> mutators{{{"a number, by one", number_step},
                                            {"a number more", number_added},
                                            {"a word less", word_removed},
                                            {"a symbol of a feature", symbol},
                                            {"a letter of a feature", letter},
                                            {"two features swapped", features_swapped},
                                            {"another problem", foreign_problem},
                                            {"other cameras", other_cameras},
                                            {"another motion", motion},
                                            {"a line less", line_removed},
                                            {"lines of another record", other_record}}};

/// The text with the number that the checker has computed in the place of the one that is claimed,
/// so that other checks have to refuse.
std::string corrected(const std::string& text, const std::string& reason) {
    for (const auto& [says, word] :
         {std::pair{": the minor is ", "\nminimal "}, std::pair{": the excess is ", "\nexcess "}}) {
        const std::size_t at = reason.find(says);
        const std::size_t claimed = text.find(word);
        if (at == reason.npos || claimed == text.npos) continue;
        std::string number = reason.substr(at + std::string_view(says).size());
        number = number.substr(0, number.find(' '));
        const std::size_t place = claimed + std::string_view(word).size();
        const std::size_t end = text.find_first_of(" \n", place);
        return text.substr(0, place) + number + text.substr(end);
    }
    return text;
}

/// The reason without the notation of the problem before it.
std::string without_notation(const std::string& reason) {
    const std::string_view prefix = "projective: ";
    const std::size_t end = reason.find(": ", reason.starts_with(prefix) ? prefix.size() : 0);
    return end == reason.npos ? reason : reason.substr(end + 2);
}

class Trial {
public:
    Trial(const checker::Classification& all, Table& table) : all_(all), table_(table) {}

    void try_one(const std::string& mutator, std::string text) {
        checker::ReplayedFile file = checker::replay(all_, "mutant", text);
        if (const auto refusal = refusal_of(file); refusal && refusal->conforms) {
            text = corrected(text, refusal->reason);
            file = checker::replay(all_, "mutant", text);
        }
        const auto refusal = refusal_of(file);
        Tally& tally = table_.by_mutator[mutator];
        ++tally.mutants;
        ++(refusal ? tally.refused : tally.accepted);
        if (refusal) {
            const std::string& all = refusal->reason;
            const std::string reason = refusal->conforms ? without_notation(all) : all;
            ++table_.by_reason[kind_of(reason, refusal->conforms)];
        }
        for (const auto& [notation, problem, minimal] : proved_by<ProblemsFile>(file).verdicts) {
            ++table_.verdicts;
            const bool fills = image_rank(problem, dice_) == image_dimension(problem);
            const bool balanced = image_dimension(problem) == scene_dimension(problem);
            if (minimal != (fills && balanced)) table_.unsound.push_back(notation + "\n" + text);
        }
    }

private:
    const checker::Classification& all_;
    Table& table_;
    Dice dice_{2026};
};

} // namespace

int try_problems_in_general(const checker::Classification& all, std::size_t mutants,
                            std::uint64_t seed) {
    const std::vector<std::string> bases = files();
    Table untouched;
    Trial first(all, untouched);
    for (const std::string& base : bases)
        first.try_one("none", base);
    Table table;
    Trial trial(all, table);
    Random random(seed);
    for (std::size_t done = 0, turn = 0; done < mutants; ++turn) {
        const std::string& base = bases[random.below(bases.size())];
        const File other = split(bases[random.below(bases.size())]);
        const Mutator& mutator = mutators[turn % mutators.size()];
        File file = split(base);
        mutator.apply(file, other, random);
        const std::string text = join(file);
        if (text == base) continue;
        trial.try_one(std::string(mutator.name), text);
        ++done;
    }
    print("Files of problems in general", "certificates of problems", table);
    return outcome(bases.size(), untouched, table);
}
