// Soundness by mutation: the checker refuses a changed file, or what it then certifies is true, as
// the referee finds by other means. Prints who refused what.
//   mutation_tests [MUTANTS [SEED]]
// MUTANTS mutants of classification and problem files, a quarter of this number of files of
// problems in general, and a tenth each of degree files and of files of upper bounds.
#include "prover/minimal/problem_certificate.h"
#include "tests/mutation/degree_trial.h"
#include "tests/mutation/general_trial.h"
#include "tests/mutation/mutants.h"
#include "tests/mutation/referee.h"
#include "tests/mutation/replayed.h"
#include "tests/mutation/short_archive.h"
#include "tests/mutation/table.h"
#include "tests/support/random_problems.h"

#include <fstream>
#include <iostream>
#include <iterator>
#include <sstream>
#include <unordered_map>

namespace {

using mutation::File;
using mutation::Random;

/// A valid file, and the classes that it is about; none for a problem file.
struct Base {
    std::string text;
    checker::Classification classes{};
    std::vector<plprove::Signature> signatures{};
};

plprove::Signature signature(const checker::Signature& counts) {
    plprove::Signature result{};
    for (std::size_t i = 0; i < result.size(); ++i)
        result[i] = static_cast<std::uint8_t>(counts[i]);
    return result;
}

std::vector<Base> classification_bases(const checker::Classification& all) {
    std::ifstream stream(CERTS_DIR "/classification.plc", std::ios::binary);
    const std::string archive{std::istreambuf_iterator<char>(stream), {}};
    std::vector<Base> bases;
    constexpr std::size_t classes_in_a_file = 3;
    for (std::size_t first = 0; first < short_classes.size(); first += classes_in_a_file) {
        const auto numbers =
            std::span(short_classes)
                .subspan(first, std::min(classes_in_a_file, short_classes.size() - first));
        Base base{shorten(archive, all, numbers), classification_of(all, numbers)};
        for (const auto& counts : base.classes.representatives)
            base.signatures.push_back(signature(counts));
        bases.push_back(std::move(base));
    }
    return bases;
}

/// Certificates of every verdict, in two and three views, with and without reductions.
std::vector<Base> problem_bases() {
    std::vector<plprove::Features> problems;
    for (const char* text :
         {"3*P/P/P + a/a/a", "2*Pa/Pa/Pa + P/P/P", "3*P/P/P + P/P/a", "5*P/P", "3*P/P/P", "6*P/P/P",
          "Pabcdefgh/Pabcdefgh/Pabcdefgh", "-/P/P + 4*P/P/P + Pa/P/P + a/a/-",
          "Pabcdefg/Pabcdefg/Pabcdefg + P/P/-", "5*P/P + P/a(b)", "4*P/P + Pa/Pa + a/a + P/-",
          "Pabc/Pabc/Pabc + 5*P/P/-", "6*P/P/- + 5*-/P/P",
          "3*P/P/P + P/P/a + Pa/Pa/P + P/a/- + a/-/a",
          "Pa/-/P(b) + 3*P/P/P + a/a/a + -/-/-(P) + a/a/-(P) + a/b/-", "3*P/P/P + P/a/- + a/a/a(P)",
          "Pabcdef/Pabcdef/Pabcdef + P/a/a + a/-/- + P/-/-"})
        problems.push_back(plprove::parse_features(text));
    for (const std::size_t number : short_classes)
        problems.push_back(plprove::problem_of(plprove::label_classes()[number]));
    plprove::RandomProblems random(17);
    for (int added = 0; added < 24; ++added)
        problems.push_back(random.around_a_class(added / 5));
    std::vector<Base> bases;
    for (const plprove::Features& problem : problems)
        bases.push_back({write(plprove::certify_problem(problem))});
    return bases;
}

/// Gives records the minors that they should have, so that other checks have to refuse.
std::string with_true_minors(const std::string& text, const Base& base) {
    File file = mutation::split(text);
    const referee::Text lines = referee::split(text);
    for (std::size_t i = 0; i < lines.lines.size(); ++i) {
        const auto& words = lines.lines[i];
        const bool minimal = words[0] == "minimal";
        if (!minimal && words[0] != "deficient" && words[0] != "camera-minimal") continue;
        std::optional<plprove::Signature> of_class;
        if (!base.signatures.empty()) {
            const std::size_t number = words.size() > 1
                                           ? std::strtoul(words[1].c_str(), nullptr, 10)
                                           : base.signatures.size();
            if (number >= base.signatures.size()) continue;
            of_class = base.signatures[number];
        }
        const auto minor = referee::true_minor(lines, i, of_class);
        const std::size_t line = lines.numbers[i] - 1 + (minimal ? 0 : 2);
        if (minor && line < file.size()) file[line].back() = std::to_string(*minor);
    }
    return mutation::join(file);
}

class Trial {
public:
    Trial(const checker::Classification& all, Table& table) : all_(all), table_(table) {}

    void mutate(const std::vector<Base>& bases, std::size_t mutants, std::uint64_t seed) {
        Random random(seed);
        for (std::size_t done = 0, tried = 0; done < mutants; ++tried) {
            const Base& base = bases[random.below(bases.size())];
            const Base& other = bases[random.below(bases.size())];
            const auto mutant = mutation::mutant(base.text, other.text, tried, random);
            if (!mutant) continue;
            const std::string text =
                random.below(2) == 0 ? with_true_minors(mutant->text, base) : mutant->text;
            if (text == base.text) continue;
            try_one(base, std::string(mutant->mutator), text);
            ++done;
        }
    }

    void try_one(const Base& base, const std::string& mutator, const std::string& text) {
        const bool problem = base.signatures.empty();
        const checker::ReplayedFile file =
            checker::replay(problem ? all_ : base.classes, "mutant", text);
        const auto refusal = refusal_of(file);
        Tally& tally = table_.by_mutator[mutator];
        ++tally.mutants;
        ++(refusal ? tally.refused : tally.accepted);
        if (refusal) ++table_.by_reason[kind_of(refusal->reason, refusal->conforms)];
        if (problem)
            judge_problem(file, refusal, text);
        else
            judge_classes(file, refusal, base, text);
    }

private:
    void judge_problem(const checker::ReplayedFile& file, const std::optional<Refusal>& refusal,
                       const std::string& text) {
        const auto objection = referee::objection_to_problem(referee::split(text));
        if (!refusal && objection) table_.unsound.push_back(*objection + "\n" + text);
        const bool certified = !proved_by<checker::ProblemFile>(file).verdict.empty();
        if (certified == refusal.has_value())
            table_.unsound.push_back("accepted, but nothing certified, or the reverse\n" + text);
        if (!refusal || objection) return;
        if (++table_.strict[kind_of(refusal->reason, refusal->conforms)] == 1 && refusal->conforms)
            std::cout << "refused although proved: " << refusal->reason << '\n' << text;
    }

    void judge_classes(const checker::ReplayedFile& file, const std::optional<Refusal>& refusal,
                       const Base& base, const std::string& text) {
        const auto verdicts = proved_by<checker::ClassificationFile>(file).verdicts;
        const referee::Text lines = referee::split(text);
        for (const checker::ClassVerdict& verdict : verdicts)
            believe(lines, verdict.number, base, text);
        if (!refusal && verdicts.size() != base.signatures.size())
            table_.unsound.push_back("a class without a certificate\n" + text);
    }

    /// Examines the certificate of a class that the checker has believed. Most are unchanged: what
    /// the referee has found before is remembered.
    void believe(const referee::Text& lines, std::size_t number, const Base& base,
                 const std::string& text) {
        ++table_.verdicts;
        const std::size_t record = referee::line_of_record(lines, number);
        std::string key = std::to_string(number) + "\n";
        bool wanted = true;
        for (std::size_t i = 0; i < lines.lines.size(); ++i) {
            const std::string& first = lines.lines[i][0];
            if (first == "minimal" || first == "deficient") wanted = lines.numbers[i] == record;
            if (!wanted) continue;
            for (const std::string& word : lines.lines[i])
                key += word + " ";
            key += "\n";
        }
        const auto [place, is_new] = found_.try_emplace(key);
        if (is_new)
            place->second = referee::objection_to_record(lines, record, base.signatures[number]);
        if (place->second) table_.unsound.push_back(*place->second + "\n" + text);
    }

    const checker::Classification& all_;
    Table& table_;
    std::unordered_map<std::string, std::optional<std::string>> found_;
};

/// 0 if every base is accepted and no mutant that is accepted proves something false.
int run(const std::string& title, const checker::Classification& all,
        const std::vector<Base>& bases, std::size_t mutants, std::uint64_t seed) {
    Table untouched;
    Trial first(all, untouched);
    for (const Base& base : bases)
        first.try_one(base, "none",
                      "plcert 2 " +
                          std::string(base.signatures.empty() ? "problem\n# the same\n"
                                                              : "classification\n# the same\n") +
                          base.text.substr(base.text.find('\n') + 1));
    Table table;
    Trial(all, table).mutate(bases, mutants, seed);
    print(title, "certificates of classes", table);
    return outcome(bases.size(), untouched, table);
}

/// A record of the archive with a number changed so that it proves nothing: a minor, or what is
/// stated of an obstruction.
std::string spoilt(const std::string& line, Random& random) {
    File file = mutation::split(line);
    auto& words = file[0];
    const bool minimal = words[0] == "minimal";
    std::string& word = minimal ? words[3] : words[std::array{4, 6, 7, 8, 10}[random.below(5)]];
    const std::uint64_t value = std::stoull(word);
    word = std::to_string(minimal ? value ^ (std::uint64_t{1} << random.below(60)) : value + 1);
    return minimal && (word == "0" || word == std::to_string(plprove::modulus))
               ? spoilt(line, random)
               : mutation::join(file);
}

/// Spoils one certificate in seventy of the whole archive, and expects that just these are refused.
int run_archive(const checker::Classification& all, std::size_t times, std::uint64_t seed) {
    std::ifstream stream(CERTS_DIR "/classification.plc", std::ios::binary);
    const std::string archive{std::istreambuf_iterator<char>(stream), {}};
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
        for (const auto& [number, why] : proved_by<checker::ClassificationFile>(file).verdicts)
            certified[number] = true;
        for (std::size_t n = 0; n < expected.size(); ++n)
            wrong += expected[n] != certified[n];
    }
    std::cout << "The whole archive: " << spoilt_records << " certificates spoilt in " << times
              << " files: " << (wrong == 0 ? "just these are refused" : "OTHERS ARE REFUSED")
              << "\n\n";
    return wrong == 0 && spoilt_records > 0 ? 0 : 1;
}

} // namespace

int main(int count, char** values) {
    const std::size_t mutants = count > 1 ? std::stoul(values[1]) : 6000;
    const std::uint64_t seed = count > 2 ? std::stoul(values[2]) : 1;
    const checker::Classification all = checker::classify();
    const int classification = run("Classification files of few classes", all,
                                   classification_bases(all), mutants / 2, seed);
    const int archive = run_archive(all, 1 + mutants / 10'000, seed);
    const int problems = run("Problem files", all, problem_bases(), mutants - mutants / 2, seed);
    const int degrees = try_degree_files(all, mutants / 10, seed);
    const int in_general = try_problems_in_general(all, mutants / 4, seed);
    return classification | archive | problems | degrees | in_general |
           try_bounds(all, mutants / 10, seed);
}
