// Writes mutants of certificate files, and what the checker makes of each: for mutation/judge,
// which asks the second checker.
//   mutation_tests [MUTANTS [SEED [KIND]]]
// MUTANTS mutants of classification and problem files, a quarter of this number of files of
// problems in general, and of files of models, and a tenth of degree files. With KIND, MUTANTS of
// this kind alone. Before the mutants come the files as they are. For each file a line of JSON,
// then its bytes:
//   kind, mutator ("none" for a file as it is), bytes, classes (of a classification: those that it
//   numbers 0, 1, ...), conforms, refusal (the first; null if all holds), claims (what holds, as
//   the judge spells it), objection of the referee of degree files or models (null if none), and
//   undecided: whether the checker refuses the file for its effort alone.
// At last spoils records of the whole archive, and expects that just these are refused: else
// status 1.
#include "checker/report/report.h"
#include "prover/geometry/flint.h"
#include "tests/mutation/bases.h"
#include "tests/mutation/degree_referee.h"
#include "tests/mutation/edits.h"
#include "tests/mutation/short_archive.h"

#include <algorithm>
#include <iostream>
#include <map>
#include <nlohmann/json.hpp>
#include <regex>
#include <sstream>

namespace {

using namespace mutation;
using Claims = std::vector<std::string>;

Claims claims_of(const checker::ClassificationFile& file) {
    Claims claims;
    for (const auto& [number, obstruction] : file.verdicts)
        claims.push_back(checker::say(number, obstruction.minimal() ? " minimal" : " deficient"));
    return claims;
}

Claims claims_of(const checker::ProblemFile& file) {
    if (file.verdict.empty()) return {};
    const std::string number = file.of_class ? std::to_string(file.of_class->number) : "-";
    return {file.problem + ": " + file.verdict + ", class " + number};
}

Claims claims_of(const checker::ProblemsFile& file) {
    Claims claims;
    for (const checker::ProblemVerdict& verdict : file.verdicts)
        claims.push_back(verdict.notation + (verdict.minimal ? ": minimal" : ": not minimal"));
    return claims;
}

Claims claims_of(const checker::ModelFile& file) {
    if (file.records == 0) return {};
    Claims claims{checker::say(checker::counted(file.records, "record"))};
    if (file.at_least > 0) claims.push_back(checker::say("at least ", file.at_least));
    if (file.at_most) claims.push_back(checker::say("at most ", *file.at_most));
    return claims;
}

/// Why a claim about a committed model is not true: its number of solutions is another one. That is
/// what the committed file proves; of registrations the upper bound, which solutions attain.
class ModelReferee {
public:
    ModelReferee() {
        for (const Base& base : model_bases()) {
            const checker::ReplayedFile file = checker::replay({}, "model", base.text);
            if (const auto* model = model_in(file))
                known_[model->text] = model->at_most.value_or(model->at_least);
        }
    }

    std::optional<std::string> objection(const checker::ReplayedFile& file) const {
        const auto* model = model_in(file);
        const auto known = model ? known_.find(model->text) : known_.end();
        if (known == known_.end()) return {};
        if (model->at_least > known->second)
            return checker::say("at least ", model->at_least, " of ", known->second, " solutions");
        if (model->at_most && *model->at_most < known->second)
            return checker::say("at most ", *model->at_most, " of ", known->second, " solutions");
        return {};
    }

private:
    static const checker::ModelFile* model_in(const checker::ReplayedFile& file) {
        return std::get_if<checker::ModelFile>(&file.content);
    }

    std::map<std::string, std::size_t> known_;
};

Claims claims_of(const checker::DegreeFile& file) {
    Claims claims;
    for (const checker::LowerBound& bound : file.bounds)
        claims.push_back(checker::say("class ", bound.number, ": at least ", bound.solutions));
    return claims;
}

/// Of kinds that the judge has no other opinion on.
template <class Other>
Claims claims_of(const Other&) {
    return {};
}

/// Why a file is refused, and on which line: it does not conform, or a record does not hold.
std::optional<checker::Complaint> refusal_of(const checker::ReplayedFile& file) {
    if (const auto* malformed = std::get_if<checker::Malformed>(&file.content))
        return malformed->complaint;
    const checker::Refusals& refusals = checker::refusals_of(file);
    return refusals.count == 0 ? std::nullopt : std::optional(refusals.first[0]);
}

/// Makes the lists of eliminations ascend, so that other checks have to refuse.
void sort_lists(File& file) {
    for (auto& words : file) {
        if (words.size() < 3 || (words[0] != "basis" && words[0] != "rows")) continue;
        const auto first = words.begin() + (words[0] == "basis" ? 1 : 2);
        std::sort(first, words.end(), [](const std::string& a, const std::string& b) {
            return std::pair(a.size(), a) < std::pair(b.size(), b);
        });
        words.erase(std::unique(first, words.end()), words.end());
    }
}

/// Puts the number that a refusal says in the place of the one that its record claims.
void correct(File& file, const checker::Complaint& complaint) {
    static const std::regex computed("the (?:minor|excess) is ([1-9][0-9]*)");
    std::smatch number;
    if (!std::regex_search(complaint.reason, number, computed)) return;
    // The only record of a problem is refused where reading ends.
    const std::size_t start = file[0].back() == "problem" ? 0 : complaint.line - 1;
    const auto claim = std::find_if(at(file, start), file.end(), [](const auto& words) {
        return words[0] == "minimal" || words[0] == "minor" || words[0] == "excess";
    });
    if (claim != file.end()) claim->back() = number[1];
}

/// Writes files, and what the checker makes of them.
class Trial {
public:
    explicit Trial(const checker::Classification& all) : all_(all) {}

    void run(const std::string& kind, const std::vector<Base>& bases, std::size_t mutants,
             std::uint64_t seed) {
        Random random(seed);
        // Many times what the models take that are mutated, and little for the second checker.
        effort_ = kind == "model" ? 1'000 : checker::usual_effort;
        for (const Base& base : bases)
            try_one(kind, base, "none", base.text);
        for (std::size_t done = 0, tried = 0; done < mutants; ++tried) {
            const Base& base = bases[random.below(bases.size())];
            const Base& other = bases[random.below(bases.size())];
            const auto mutant = mutation::mutant(base.text, other.text, tried, random);
            if (!mutant) continue;
            const bool as_it_is = kind == "degrees" || random.below(2) == 0;
            const std::string text = as_it_is ? mutant->text : mended(base, mutant->text);
            if (text == base.text) continue;
            try_one(kind, base, mutant->mutator, text);
            ++done;
        }
    }

private:
    checker::ReplayedFile replay(const Base& base, const std::string& text) const {
        if (base.classes.empty()) return checker::replay(all_, "mutant", text, {.effort = effort_});
        return checker::replay(classification_of(all_, base.classes), "mutant", text);
    }

    /// The text with the numbers that the checker computes where it claims others, so that other
    /// checks have to refuse.
    std::string mended(const Base& base, const std::string& text) const {
        File file = split(text);
        sort_lists(file);
        const checker::ReplayedFile replayed = replay(base, join(file));
        for (const checker::Complaint& complaint : checker::refusals_of(replayed).first)
            correct(file, complaint);
        return join(file);
    }

    void try_one(const std::string& kind, const Base& base, std::string_view mutator,
                 const std::string& text) {
        const checker::ReplayedFile file = replay(base, text);
        const auto refusal = refusal_of(file);
        nlohmann::json row{
            {"kind", kind},
            {"mutator", mutator},
            {"bytes", text.size()},
            {"classes", base.classes},
            {"conforms", !std::holds_alternative<checker::Malformed>(file.content)},
            {"refusal", nullptr},
            {"claims",
             std::visit([](const auto& content) { return claims_of(content); }, file.content)},
            {"objection", nullptr},
            {"undecided", refusal && refusal->reason.find("more effort") != std::string::npos}};
        if (refusal) row["refusal"] = refusal->reason;
        if (const auto* degrees = std::get_if<checker::DegreeFile>(&file.content))
            if (const auto objection = referee_.objection(text, degrees->bounds))
                row["objection"] = *objection;
        if (const auto objection = models_.objection(file)) row["objection"] = *objection;
        std::cout << row.dump(-1, ' ', true, nlohmann::json::error_handler_t::replace) << '\n'
                  << text;
    }

    const checker::Classification& all_;
    std::uint64_t effort_ = checker::usual_effort; // that a file may take
    DegreeReferee referee_;
    ModelReferee models_;
};

/// A record of the archive with a number changed so that it proves nothing: a minor, or what is
/// stated of an obstruction.
std::string spoilt(const std::string& line, Random& random) {
    File file = split(line);
    auto& words = file[0];
    const bool minimal = words[0] == "minimal";
    std::string& word = minimal ? words[3] : words[std::array{4, 6, 7, 8, 10}[random.below(5)]];
    const std::uint64_t value = std::stoull(word);
    word = std::to_string(minimal ? value ^ (std::uint64_t{1} << random.below(60)) : value + 1);
    return minimal && (word == "0" || word == std::to_string(plprove::modulus))
               ? spoilt(line, random)
               : join(file);
}

/// Spoils one certificate in seventy of the whole archive, and says whether just these are refused.
bool spoil_archive(const checker::Classification& all, std::size_t times, std::uint64_t seed) {
    const std::string archive = committed("classification.plc");
    Random random(seed);
    std::size_t spoilt_records = 0;
    std::size_t wrong = 0;
    for (std::size_t i = 0; i < times; ++i) {
        std::vector<bool> expected(all.representatives.size(), true);
        std::string text;
        std::istringstream lines(archive);
        for (std::string line; std::getline(lines, line);) {
            const bool deficient = line.starts_with("deficient ");
            if ((!deficient && !line.starts_with("minimal ")) ||
                random.below(deficient ? 7 : 70) != 0) {
                text += line + "\n";
                continue;
            }
            expected[std::stoul(line.substr(line.find(' ')))] = false;
            text += spoilt(line + "\n", random);
            ++spoilt_records;
        }
        std::vector<bool> certified(expected.size(), false);
        const checker::ReplayedFile file = checker::replay(all, "spoilt", text);
        if (const auto* content = std::get_if<checker::ClassificationFile>(&file.content))
            for (const auto& [number, why] : content->verdicts)
                certified[number] = true;
        for (std::size_t n = 0; n < expected.size(); ++n)
            wrong += expected[n] != certified[n];
    }
    std::cerr << "The whole archive: " << spoilt_records << " certificates spoilt in " << times
              << " files: " << (wrong == 0 ? "just these are refused" : "OTHERS ARE REFUSED")
              << "\n";
    return wrong == 0 && spoilt_records > 0;
}

} // namespace

int main(int count, char** values) {
    const std::size_t mutants = count > 1 ? std::stoul(values[1]) : 2000;
    const std::uint64_t seed = count > 2 ? std::stoul(values[2]) : 1;
    const checker::Classification all = checker::classify();
    Trial trial(all);
    const std::string_view only = count > 3 ? values[3] : "";
    const auto run = [&](std::string_view kind, const auto& bases_of, std::size_t share) {
        if (only.empty() || kind == only)
            trial.run(std::string(kind), bases_of(), only.empty() ? share : mutants, seed);
    };
    run("classification", classification_bases, mutants / 2);
    run("problem", problem_bases, mutants - mutants / 2);
    run("problems", general_bases, mutants / 4);
    run("degrees", degree_bases, mutants / 10);
    run("model", model_bases, mutants / 4);
    return spoil_archive(all, 1 + mutants / 10'000, seed) ? 0 : 1;
}
