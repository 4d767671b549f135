// The lower bounds of all degrees, whose certificates are not on file: anyone gets them back.
#include "tests/support/program.h"

#include <doctest/doctest.h>
#include <map>
#include <nlohmann/json.hpp>
#include <set>
#include <sstream>

namespace {

const std::string plprove = PLPROVE;
const std::string plcheck = PLCHECK;
const std::string certs = std::string(SOURCE_DIR) + "/certs";

/// What a name CLASS-SOLUTIONS-SEED.plc in the list of digests says, and the digest.
struct ListedFile {
    int number = 0, solutions = 0, seed = 0;
    std::string name, digest;
};

std::vector<ListedFile> listed_files() {
    std::vector<ListedFile> files;
    for (const std::string& line :
         lines_of(read_file(certs + "/degrees/SHA256SUMS-lower-bounds"))) {
        ListedFile& file = files.emplace_back();
        file.digest = line.substr(0, 64);
        file.name = line.substr(66);
        char dash = 0;
        std::istringstream(file.name) >> file.number >> dash >> file.solutions >> dash >> file.seed;
        file.solutions = std::abs(file.solutions);
        file.seed = std::abs(file.seed);
    }
    return files;
}

/// What degrees.csv says of each class: its degree, and the largest certified lower bound.
struct OnFile {
    int degree = 0, certified = 0;
};

std::map<int, OnFile> degrees_on_file() {
    std::map<int, OnFile> classes;
    for (const std::string& line : lines_of(read_file(certs + "/degrees.csv"))) {
        int number = 0, degree = 0;
        char comma = 0;
        std::istringstream text(line);
        if (!(text >> number >> comma >> degree)) continue;
        OnFile& found = classes[number];
        found.degree = std::max(found.degree, degree);
        if (line.find(",certified,") != std::string::npos)
            found.certified = std::max(found.certified, degree);
    }
    return classes;
}

/// What certs/solutions lists: a problem by PLMP's name, in a name NAME-SOLUTIONS-SEED.plc.
struct ListedProblem {
    std::string name, seed, file, digest;
    int solutions = 0;
};

std::vector<ListedProblem> listed_problems() {
    std::vector<ListedProblem> problems;
    for (const std::string& line :
         lines_of(read_file(certs + "/solutions/SHA256SUMS-lower-bounds"))) {
        ListedProblem& problem = problems.emplace_back();
        problem.digest = line.substr(0, 64);
        problem.file = line.substr(66);
        std::istringstream words(problem.file);
        std::string solutions;
        std::getline(words, problem.name, '-');
        std::getline(words, solutions, '-');
        std::getline(words, problem.seed, '.');
        problem.solutions = std::stoi(solutions);
    }
    return problems;
}

} // namespace

TEST_CASE("the list of lower bounds has for each of its classes the degree on file, and plcheck "
          "reported it") {
    const std::map<int, OnFile> degrees = degrees_on_file();
    std::set<std::string> reported;
    for (const std::string& line : lines_of(read_file(certs + "/degrees/lower-bounds.txt")))
        reported.insert(line);
    std::set<int> classes;
    for (const ListedFile& file : listed_files()) {
        CAPTURE(file.name);
        CHECK(degrees.at(file.number).degree == file.solutions);
        CHECK(degrees.at(file.number).certified == file.solutions);
        CHECK(classes.insert(file.number).second);
        CHECK(reported.contains("class " + std::to_string(file.number) +
                                ": certified to have at least " + std::to_string(file.solutions) +
                                " solutions"));
    }
    CHECK(reported.size() == classes.size());
    CHECK(classes.size() > 1000);
    const std::string page = read_file(std::string(SOURCE_DIR) + "/docs/degrees.md");
    const std::string thousands = std::to_string(classes.size() / 1000);
    const std::string rest = std::to_string(1000 + classes.size() % 1000).substr(1);
    CHECK(page.find("done for " + thousands + "," + rest + " of the 10,073 systems") !=
          std::string::npos);
}

TEST_CASE("plprove gives back the bytes of a dozen certificates of lower bounds, and they hold") {
    constexpr int quick = 1500; // solutions, at most
    constexpr std::size_t dozen = 12;
    std::vector<ListedFile> files;
    for (const ListedFile& file : listed_files())
        if (file.solutions <= quick) files.push_back(file);
    REQUIRE(files.size() >= dozen);
    const TemporaryFolder folder;
    std::map<std::string, ListedFile> chosen;
    std::string names;
    for (std::size_t i = 0; i < dozen; ++i) {
        const ListedFile& file = files[i * (files.size() - 1) / (dozen - 1)];
        const std::string path = (folder / file.name).string();
        const Outcome outcome = run(plprove + " degree " + std::to_string(file.number) +
                                    " --at-least " + std::to_string(file.solutions) + " --seed " +
                                    std::to_string(file.seed) + " -o " + path);
        REQUIRE(outcome.status == 0);
        chosen[path] = file;
        names += " " + path;
    }
    const Outcome checked = run(plcheck + " --json" + names);
    CHECK(checked.status == 0);
    const nlohmann::json report = nlohmann::json::parse(checked.out);
    REQUIRE(report.at("files").size() == dozen);
    for (const nlohmann::json& file : report.at("files")) {
        const ListedFile& listed = chosen.at(file.at("file"));
        CAPTURE(listed.name);
        CHECK(file.at("sha256") == listed.digest);
        CHECK(file.at("degrees").at(0).at("class") == listed.number);
        CHECK(file.at("degrees").at(0).at("certified_at_least") >= listed.solutions);
    }
}

TEST_CASE(
    "the list of lower bounds in general has problems of PLMP with more than 600 solutions, as "
    "certified as their lines say, and plcheck reported it") {
    const std::string table = read_file(certs + "/family-degrees.csv");
    const std::string report = read_file(certs + "/solutions/lower-bounds.txt");
    std::set<std::string> lines;
    for (const std::string& line : lines_of(table)) {
        std::istringstream columns(line);
        std::vector<std::string> row;
        for (std::string column; std::getline(columns, column, ',');)
            row.push_back(column);
        if (row[0] != "plmp" || row[5].empty() || std::stoi(row[5]) <= 600) continue;
        lines.insert(row[1] + ": " + row[5]);
    }
    std::set<std::string> listed;
    for (const ListedProblem& problem : listed_problems()) {
        CAPTURE(problem.file);
        const std::string said = problem.name + ": certified to have at least ";
        const std::size_t place = report.find(said);
        REQUIRE(place != std::string::npos);
        const int certified = std::stoi(report.substr(place + said.size()));
        CHECK(certified >= problem.solutions);
        const std::string notation =
            lines_of(run(plprove + " problem " + problem.name).out)[0].substr(12);
        listed.insert(notation + ": " + std::to_string(certified));
    }
    CHECK(listed == lines);
    CHECK(listed.size() == 6);
    CHECK(lines_of(report).size() == listed.size());
}

TEST_CASE("plprove gives back the bytes of the smallest certificate in general, and it holds") {
    const ListedProblem problem = listed_problems().at(0);
    const TemporaryFolder folder;
    const std::string path = (folder / problem.file).string();
    REQUIRE(run(plprove + " degree " + problem.name + " --at-least " +
                std::to_string(problem.solutions) + " --seed " + problem.seed + " -o " + path)
                .status == 0);
    const Outcome checked = run(plcheck + " --json " + path);
    CHECK(checked.status == 0);
    const nlohmann::json file = nlohmann::json::parse(checked.out).at("files").at(0);
    CHECK(file.at("sha256") == problem.digest);
    CHECK(file.at("solutions").at(0).at("certified_at_least") >= problem.solutions);
}
