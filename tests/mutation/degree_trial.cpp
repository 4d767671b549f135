#include "tests/mutation/degree_trial.h"

#include "checker/conclusion/degree_bounds.h"
#include "tests/mutation/degree_referee.h"
#include "tests/mutation/mutants.h"
#include "tests/mutation/replayed.h"
#include "tests/mutation/table.h"

#include <algorithm>
#include <fstream>
#include <functional>
#include <iterator>
#include <map>
#include <numeric>
#include <sstream>
#include <unordered_map>

namespace {

using mutation::File;
using mutation::Random;
using Words = std::vector<std::string>;

File committed(const std::string& name) {
    std::ifstream stream(CERTS_DIR "/" + name, std::ios::binary);
    return mutation::split(std::string{std::istreambuf_iterator<char>(stream), {}});
}

/// The records of a degree file, or the templates of a file of upper bounds.
std::vector<File> records(const File& file) {
    std::vector<File> found;
    for (const Words& words : file)
        if (words[0] == "degree" || words[0] == "template")
            found.push_back({words});
        else if (!found.empty())
            found.back().push_back(words);
    return found;
}

std::size_t number_of(const File& record) {
    return std::stoul(record[0][1]);
}

/// How many solutions a record shows.
std::size_t shown(const File& record) {
    std::size_t count = 0;
    for (const Words& words : record)
        count += words[0] == "real" ? 1 : words[0] == "pair" ? 2 : 0;
    return count;
}

/// A text of degree records or templates, as it is and changed, and what holds in it.
class Trial {
public:
    /// Why something that is claimed in the text is not so.
    using Objection = std::function<std::optional<std::string>(const checker::ReplayedFile& file,
                                                               const std::string& text)>;

    Trial(const checker::Classification& classes, Objection objection)
        : classes_(classes), objection_(std::move(objection)) {}

    int run(const std::string& title, const std::string& certificates,
            const std::vector<std::string>& bases, std::size_t mutants, std::uint64_t seed) {
        Table untouched, table;
        for (const std::string& base : bases)
            try_one(base, "none", untouched);
        Random random(seed);
        for (std::size_t done = 0, tried = 0; done < mutants; ++tried) {
            const std::string& base = bases[random.below(bases.size())];
            const std::string& other = bases[random.below(bases.size())];
            const auto mutant = mutation::mutant(base, other, tried, random);
            if (!mutant) continue;
            const std::string text = random.below(4) == 0 ? mutant->text : mended(mutant->text);
            if (text == base) continue;
            try_one(text, std::string(mutant->mutator), table);
            ++done;
        }
        print(title, certificates, table);
        return outcome(bases.size(), untouched, table);
    }

private:
    /// Gives templates ascending lists and the minors that the checker misses, so that other checks
    /// have to refuse.
    std::string mended(const std::string& text) const {
        File file = mutation::split(text);
        for (Words& words : file) {
            if (words.size() < 3 || (words[0] != "basis" && words[0] != "rows")) continue;
            const auto first = words.begin() + (words[0] == "basis" ? 1 : 2);
            std::sort(first, words.end(), [](const std::string& a, const std::string& b) {
                return std::pair(a.size(), a) < std::pair(b.size(), b);
            });
            words.erase(std::unique(first, words.end()), words.end());
        }
        const checker::ReplayedFile replayed =
            checker::replay(classes_, "mutant", mutation::join(file));
        for (const auto& [line, reason] : checker::refusals_of(replayed).first) {
            const std::string before = "the minor is ";
            if (!reason.starts_with(before)) continue;
            const std::string minor =
                reason.substr(before.size(), reason.find(' ', before.size()) - before.size());
            std::size_t place = line;
            while (place < file.size() && (file[place].empty() || file[place][0] != "minor"))
                ++place;
            if (place < file.size() && minor != "0") file[place].back() = minor;
        }
        return mutation::join(file);
    }

    void try_one(const std::string& text, const std::string& mutator, Table& table) const {
        const checker::ReplayedFile file = checker::replay(classes_, "mutant", text);
        const auto refusal = refusal_of(file);
        Tally& tally = table.by_mutator[mutator];
        ++tally.mutants;
        ++(refusal ? tally.refused : tally.accepted);
        table.verdicts += proved_by<checker::DegreeFile>(file).bounds.size() +
                          proved_by<checker::BoundsFile>(file).templates;
        if (refusal) ++table.by_reason[kind_of(refusal->reason, refusal->conforms)];
        if (refusal && !refusal->conforms) return; // then it claims nothing
        if (const auto objection = objection_(file, text))
            table.unsound.push_back(*objection + "\n" + text);
    }

    const checker::Classification& classes_;
    Objection objection_;
};

/// The record with at most `most` of its solutions, from all over the list.
File cut(const File& record, std::size_t most) {
    File result;
    std::vector<const Words*> solutions;
    for (const Words& words : record)
        if (words[0] == "real" || words[0] == "pair")
            solutions.push_back(&words);
        else
            result.push_back(words);
    const std::size_t kept = std::min(most, solutions.size());
    for (std::size_t i = 0; i < kept; ++i)
        result.push_back(*solutions[i * solutions.size() / kept]);
    return result;
}

std::string degree_file(std::vector<File> chosen) {
    std::ranges::sort(chosen, {}, number_of);
    std::string text = "plcert 2 degrees\n";
    for (const File& record : chosen)
        text += mutation::join(record);
    return text;
}

/// Files of one to three classes with few solutions of each, and a whole one.
std::vector<std::string> degree_bases(const std::map<std::size_t, std::vector<File>>& by_class) {
    constexpr std::size_t files = 40, most_solutions = 5, fewest = 64;
    std::vector<std::string> bases;
    std::vector<File> all;
    for (const auto& [number, found] : by_class)
        all.insert(all.end(), found.begin(), found.end());
    for (std::size_t i = 0; i < files; ++i) {
        std::map<std::size_t, File> chosen;
        for (std::size_t k = 0; k <= i % 3; ++k) {
            const File& record = all[(i + files * k) * all.size() / (3 * files)];
            chosen[number_of(record)] = cut(record, most_solutions);
        }
        std::vector<File> list;
        for (const auto& [number, record] : chosen)
            list.push_back(record);
        bases.push_back(degree_file(list));
    }
    bases.push_back(degree_file({*std::ranges::find(all, fewest, shown)}));
    return bases;
}

/// By class, the records of all committed degree files.
std::map<std::size_t, std::vector<File>> committed_degrees() {
    std::map<std::size_t, std::vector<File>> by_class;
    for (const char* name :
         {"one-pin", "points-and-lines", "registrations", "small", "three-points"})
        for (File& record : records(committed("degrees/" + std::string(name) + ".plc")))
            by_class[number_of(record)].push_back(std::move(record));
    return by_class;
}

/// The certificate of a class, whose record begins on a line, and what is claimed, word by word, to
/// remember what was found of it.
std::string key_of(const referee::Text& text, std::size_t line, const checker::LowerBound& bound) {
    std::string key = std::to_string(bound.solutions) + "\n";
    bool wanted = false;
    for (std::size_t i = 0; i < text.lines.size(); ++i) {
        if (text.lines[i][0] == "degree") wanted = text.numbers[i] == line;
        for (std::size_t k = 0; wanted && k < text.lines[i].size(); ++k)
            key += text.lines[i][k] + (k + 1 < text.lines[i].size() ? " " : "\n");
    }
    return key;
}

/// Files of the templates of a few types, small ones above all, and of that of the relative pose,
/// without which nothing is claimed.
std::vector<std::string> bounds_bases() {
    constexpr std::size_t files = 24;
    const File whole = committed("bounds.plc");
    std::vector<File> templates = records(whole);
    const auto is_pose = [](const File& lines) {
        return std::ranges::count(lines[1], "image") == 5;
    };
    const File pose = *std::ranges::find_if(templates, is_pose);
    std::erase_if(templates, is_pose);
    const auto rows = [](const File& lines) {
        return std::accumulate(lines.begin(), lines.end(), std::size_t{0},
                               [](std::size_t sum, const Words& words) {
                                   return words[0] == "rows" ? sum + words.size() - 2 : sum;
                               });
    };
    std::ranges::stable_sort(templates, {}, rows);
    std::vector<std::string> bases;
    for (std::size_t i = 0; i < files; ++i)
        bases.push_back(mutation::join({whole[0], whole[1]}) + mutation::join(templates[i]) +
                        mutation::join(pose) + mutation::join(templates[files + i]));
    return bases;
}

} // namespace

int try_degree_files(const checker::Classification& all, std::size_t mutants, std::uint64_t seed) {
    const auto by_class = committed_degrees();
    std::map<std::size_t, std::size_t> known;
    for (const auto& [number, found] : by_class)
        for (const File& record : found)
            known[number] = std::max(known[number], shown(record));
    std::unordered_map<std::string, std::optional<std::string>> found;
    const auto objection = [&](const checker::ReplayedFile& file,
                               const std::string& text) -> std::optional<std::string> {
        const referee::Text lines = referee::split(text);
        for (const checker::LowerBound& bound : proved_by<checker::DegreeFile>(file).bounds) {
            const auto& [number, solutions] = bound;
            if (known.contains(number) && solutions > known[number])
                return "more solutions than there are";
            const std::size_t line = referee::line_of_record(lines, number);
            const auto [place, is_new] = found.try_emplace(key_of(lines, line, bound));
            if (is_new)
                place->second = referee::objection_to_degree(lines, line, number, solutions);
            if (place->second) return place->second;
        }
        return {};
    };
    return Trial(all, objection)
        .run("Degree files", "lower bounds", degree_bases(by_class), mutants, seed);
}

int try_bounds(const checker::Classification& all, std::size_t mutants, std::uint64_t seed) {
    // A class for each type of registration, with the number of its solutions.
    std::map<std::size_t, std::size_t> degrees;
    std::vector<bool> minimal(all.representatives.size(), false);
    for (const File& record : records(committed("degrees/registrations.plc"))) {
        degrees[number_of(record)] = shown(record);
        minimal[number_of(record)] = true;
    }
    const auto objection = [&](const checker::ReplayedFile& file,
                               const std::string&) -> std::optional<std::string> {
        const checker::DegreeTable table =
            checker::bounds_by_files(all, minimal, {}, proved_by<checker::BoundsFile>(file).bounds);
        for (const auto& [number, degree] : degrees) {
            const auto known = checker::bounds_of(table, all.representatives[number]).at_most;
            if (known && known->solutions < degree)
                return "class " + std::to_string(number) + " has more solutions than " +
                       std::to_string(known->solutions);
        }
        return {};
    };
    return Trial(all, objection)
        .run("Files of upper bounds", "templates", bounds_bases(), mutants, seed);
}
