#include "tests/mutation/bases.h"

#include "prover/minimal/problem_file.h"
#include "tests/mutation/short_archive.h"
#include "tests/support/random_problems.h"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <map>
#include <sstream>

namespace mutation {

namespace {

using Words = std::vector<std::string>;

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

/// A degree file with these records, by the numbers of their classes.
std::string degree_file(const std::map<std::size_t, File>& chosen) {
    std::string text = "plcert 2 degrees\n";
    for (const auto& [number, record] : chosen)
        text += join(record);
    return text;
}

} // namespace

std::string committed(const std::string& name) {
    std::ifstream stream(CERTS_DIR "/" + name, std::ios::binary);
    return {std::istreambuf_iterator<char>(stream), {}};
}

std::vector<Base> classification_bases() {
    const std::string archive = committed("classification.plc");
    const checker::Classification all = checker::classify();
    std::vector<Base> bases;
    constexpr std::size_t classes_in_a_file = 3;
    for (std::size_t first = 0; first < short_classes.size(); first += classes_in_a_file) {
        const auto numbers =
            std::span(short_classes)
                .subspan(first, std::min(classes_in_a_file, short_classes.size() - first));
        bases.push_back({shorten(archive, all, numbers), {numbers.begin(), numbers.end()}});
    }
    return bases;
}

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

std::vector<Base> general_bases() {
    std::vector<Base> bases;
    for (const char* name :
         {"plmp.plc", "projective.plc", "families/focal.plc", "families/shared-focal-center.plc",
          "families/upright-shared-focal.plc"}) {
        std::istringstream stream(committed(name));
        for (std::string line; std::getline(stream, line);) {
            if (line.starts_with("problem "))
                bases.push_back({"plcert 2 problems\nmodulus 2305843009213693951\n"});
            if (!bases.empty() && !line.starts_with("plcert") && !line.starts_with("family") &&
                !line.starts_with("modulus"))
                bases.back().text += line + "\n";
        }
    }
    return bases;
}

std::vector<File> records(const File& file) {
    std::vector<File> found;
    for (const Words& words : file)
        if (words[0] == "degree")
            found.push_back({words});
        else if (!found.empty())
            found.back().push_back(words);
    return found;
}

std::size_t shown(const File& record) {
    std::size_t count = 0;
    for (const Words& words : record)
        count += words[0] == "real" ? 1 : words[0] == "pair" ? 2 : 0;
    return count;
}

std::size_t class_of(const File& record) {
    return std::stoul(record[0][1]);
}

/// The records with solutions, not those with fibres.
std::vector<File> committed_degrees() {
    std::vector<File> all;
    for (const char* name :
         {"one-pin", "points-and-lines", "registrations", "small", "three-points"})
        for (File& record : records(split(committed("degrees/" + std::string(name) + ".plc"))))
            if (shown(record) > 0) all.push_back(std::move(record));
    std::ranges::stable_sort(all, {}, class_of);
    return all;
}

std::vector<Base> degree_bases() {
    constexpr std::size_t files = 40, most_solutions = 5, fewest = 64;
    const std::vector<File> all = committed_degrees();
    std::vector<Base> bases;
    for (std::size_t i = 0; i < files; ++i) {
        std::map<std::size_t, File> chosen;
        for (std::size_t k = 0; k <= i % 3; ++k) {
            const File& record = all[(i + files * k) * all.size() / (3 * files)];
            chosen[class_of(record)] = cut(record, most_solutions);
        }
        bases.push_back({degree_file(chosen)});
    }
    const File& whole = *std::ranges::find(all, fewest, shown);
    bases.push_back({degree_file({{class_of(whole), whole}})});
    for (int copy = 0; copy < 4; ++copy) // so that a tenth of all mutants is of fibres
        for (const char* name : {"degrees-fibre.plc", "degrees-two-fibres.plc"})
            bases.push_back({committed(std::string("vectors/") + name)});
    return bases;
}

/// The smallest files of a folder of certificates.
static std::vector<Base> smallest_of(const std::string& folder, std::size_t files) {
    std::vector<Base> bases;
    for (const auto& entry : std::filesystem::directory_iterator(CERTS_DIR "/" + folder))
        if (entry.is_regular_file())
            bases.push_back({committed(folder + "/" + entry.path().filename().string())});
    std::ranges::sort(bases, {},
                      [](const Base& base) { return std::pair(base.text.size(), base.text); });
    bases.resize(std::min(files, bases.size()));
    return bases;
}

std::vector<Base> model_bases() {
    std::vector<Base> bases = smallest_of("models", 40);
    const std::vector<Base> bounds = smallest_of("models/registrations", 10);
    bases.insert(bases.end(), bounds.begin(), bounds.end());
    return bases;
}

} // namespace mutation
