// The lower bounds of all degrees, whose certificates are not on file: anyone gets them back.
#include "tests/support/programs.h"

#include <algorithm>
#include <doctest/doctest.h>
#include <iterator>
#include <limits>
#include <map>
#include <nlohmann/json.hpp>
#include <optional>
#include <ranges>
#include <regex>
#include <set>
#include <sstream>

namespace {

/// A line of a list of digests. The file is named PROBLEM-SOLUTIONS-SEED.plc; the problem is the
/// number of a class or a name of PLMP.
struct ListedCertificate {
    std::string file, digest;
    std::string problem, seed;
    int solutions = 0;
};

/// What a list of digests in certs/ has.
std::vector<ListedCertificate> listed_in(const std::string& list) {
    std::vector<ListedCertificate> certificates;
    for (const std::string& line : lines_of(read_file(certs + list))) {
        ListedCertificate& certificate = certificates.emplace_back();
        certificate.digest = line.substr(0, 64);
        certificate.file = line.substr(66);
        std::istringstream parts(certificate.file);
        std::string solutions;
        std::getline(parts, certificate.problem, '-');
        std::getline(parts, solutions, '-');
        std::getline(parts, certificate.seed, '.');
        certificate.solutions = std::stoi(solutions);
    }
    return certificates;
}

const std::string of_classes = "degrees/SHA256SUMS-lower-bounds";
const std::string in_general = "solutions/SHA256SUMS-lower-bounds";
const std::string fibres = "degrees/SHA256SUMS-fibres"; // of seed 0, which their names leave out
const std::string of_sweeps = "solutions/SHA256SUMS-sweeps"; // named FAMILY-NUMBER.plc

/// The digests of sweeps by problem, in notation: NUMBER is the place in the list of the family.
std::map<std::string, std::string> digests_of_sweeps() {
    std::map<std::string, std::vector<std::string>> problems; // by family
    std::map<std::string, std::string> digests;
    for (const std::string& line : lines_of(read_file(certs + of_sweeps))) {
        const std::string name = line.substr(66, line.size() - 66 - std::string(".plc").size());
        const std::size_t dash = name.rfind('-');
        const std::string family = name.substr(0, dash);
        std::vector<std::string>& list = problems[family];
        if (list.empty())
            list = lines_of(run(plprove + " list --format notation --family " + family).out);
        digests[list.at(std::stoul(name.substr(dash + 1)) - 1)] = line.substr(0, 64);
    }
    return digests;
}

/// The problems of some families in certs/family-degrees.csv.
std::set<std::string> problems_of_families(const std::set<std::string>& families) {
    std::set<std::string> problems;
    for (const std::string& line : lines_of(read_file(certs + "family-degrees.csv"))) {
        std::istringstream columns(line);
        std::vector<std::string> row;
        for (std::string column; std::getline(columns, column, ',');)
            row.push_back(column);
        if (families.contains(row[0])) problems.insert(row.at(1));
    }
    return problems;
}

/// Lets plprove find the certificate again, and returns the path of the file.
std::string find_again(const ListedCertificate& certificate, const TemporaryFolder& folder) {
    const std::string path = (folder / certificate.file).string();
    const Outcome outcome =
        run(plprove + " degree " + certificate.problem + " --at-least " +
            std::to_string(certificate.solutions) + " --seed " + certificate.seed + " -o " + path);
    REQUIRE(outcome.status == 0);
    return path;
}

/// The degrees of certs/degrees.csv, by class.
std::map<int, int> degrees_by_class() {
    std::map<int, int> degrees;
    for (const std::string& line : lines_of(read_file(certs + "degrees.csv"))) {
        int number = 0, degree = 0;
        char comma = 0;
        std::istringstream text(line);
        if (text >> number >> comma >> degree) degrees[number] = degree;
    }
    return degrees;
}

/// So many of those with at most `quick` solutions, spread evenly over the list.
std::vector<ListedCertificate> spread_over(const std::vector<ListedCertificate>& listed, int quick,
                                           std::size_t count) {
    std::vector<ListedCertificate> small, chosen;
    std::ranges::copy_if(listed, std::back_inserter(small),
                         [&](const auto& certificate) { return certificate.solutions <= quick; });
    REQUIRE(small.size() >= count);
    for (std::size_t i = 0; i < count; ++i)
        chosen.push_back(small[i * (small.size() - 1) / (count - 1)]);
    return chosen;
}

/// The numbers in a column of a table, whose first line has the names.
std::vector<int> column_of(const std::string& table, const std::string& name) {
    std::vector<int> column;
    std::optional<std::size_t> place;
    for (const std::string& line : lines_of(table)) {
        std::istringstream text(line);
        std::vector<std::string> row;
        for (std::string field; std::getline(text, field, ',');)
            row.push_back(field);
        if (place)
            column.push_back(std::stoi(row.at(*place)));
        else
            place = std::ranges::find(row, name) - row.begin();
    }
    return column;
}

} // namespace

TEST_CASE("the list of lower bounds has for each class the degree on file, and plcheck "
          "reported it") {
    const std::map<int, int> degrees = degrees_by_class();
    std::set<std::string> reported;
    for (const std::string& line : lines_of(read_file(certs + "degrees/lower-bounds.txt")))
        reported.insert(line);
    std::set<int> classes;
    for (const ListedCertificate& listed : listed_in(of_classes)) {
        CAPTURE(listed.file);
        const int number = std::stoi(listed.problem);
        CHECK(degrees.at(number) == listed.solutions);
        CHECK(classes.insert(number).second);
        CHECK(reported.contains("class " + listed.problem + ": certified to have at least " +
                                std::to_string(listed.solutions) + " solutions"));
    }
    CHECK(reported.size() == classes.size());
    CHECK(classes.size() == 10'073);
    CHECK(classes.size() == degrees.size());
}

TEST_CASE("plprove gives back the bytes of a dozen certificates of lower bounds, and they hold") {
    constexpr int quick = 1500; // solutions, at most
    constexpr std::size_t dozen = 12;
    const TemporaryFolder folder;
    std::map<std::string, ListedCertificate> chosen;
    std::string names;
    for (const ListedCertificate& listed : spread_over(listed_in(of_classes), quick, dozen)) {
        const std::string path = find_again(listed, folder);
        chosen[path] = listed;
        names += " " + path;
    }
    const Outcome checked = run(plcheck + " --json" + names);
    CHECK(checked.status == 0);
    const nlohmann::json report = nlohmann::json::parse(checked.out);
    REQUIRE(report.at("files").size() == dozen);
    for (const nlohmann::json& file : report.at("files")) {
        const ListedCertificate& listed = chosen.at(file.at("file"));
        CAPTURE(listed.file);
        CHECK(file.at("sha256") == listed.digest);
        CHECK(file.at("degrees").at(0).at("class") == std::stoi(listed.problem));
        CHECK(file.at("degrees").at(0).at("certified_at_least") >= listed.solutions);
    }
}

TEST_CASE("the list of fibres has each class of few solutions, and all of points and lines") {
    const std::map<int, int> degrees = degrees_by_class();
    std::map<int, int> expected, listed;
    for (const auto& [number, degree] : degrees)
        if (degree <= 1000) expected[number] = degree;
    const std::string lines = run(plprove + " list --pl0p --minimal --format csv").out;
    for (const int number : column_of(lines, "constraint_class"))
        expected[number] = degrees.at(number);
    for (const ListedCertificate& fibre : listed_in(fibres))
        listed[std::stoi(fibre.problem)] = fibre.solutions;
    CHECK(listed == expected);
}

TEST_CASE("plprove gives back the bytes of six fibres, which show all solutions") {
    constexpr int quick = 400; // solutions, at most
    constexpr std::size_t six = 6;
    const TemporaryFolder folder;
    for (const ListedCertificate& listed : spread_over(listed_in(fibres), quick, six)) {
        CAPTURE(listed.file);
        const std::string path = (folder / listed.file).string();
        const Outcome found = run(plprove + " degree " + listed.problem + " --fibre -o " + path);
        REQUIRE(found.status == 0);
        const Outcome checked = run(plcheck + " --json " + path);
        CHECK(checked.status == 0);
        const nlohmann::json file = nlohmann::json::parse(checked.out).at("files").at(0);
        CHECK(file.at("sha256") == listed.digest);
        CHECK(file.at("degrees").at(0).at("class") == std::stoi(listed.problem));
        CHECK(file.at("degrees").at(0).at("certified_at_least") == listed.solutions);
    }
}

TEST_CASE(
    "the list of lower bounds in general has problems of PLMP with more than 2,000 solutions, as "
    "certified as their lines say, and plcheck reported it") {
    const std::string table = read_file(certs + "family-degrees.csv");
    const std::string report = read_file(certs + "solutions/lower-bounds.txt");
    std::set<std::string> lines;
    for (const std::string& line : lines_of(table)) {
        std::istringstream columns(line);
        std::vector<std::string> row;
        for (std::string column; std::getline(columns, column, ',');)
            row.push_back(column);
        if (row[0] != "plmp" || row[5].empty() || std::stoi(row[5]) <= 2000) continue;
        lines.insert(row[1] + ": " + row[5]);
    }
    std::set<std::string> listed;
    for (const ListedCertificate& certificate : listed_in(in_general)) {
        CAPTURE(certificate.file);
        const std::string said = certificate.problem + ": certified to have at least ";
        const std::size_t place = report.find(said);
        REQUIRE(place != std::string::npos);
        const int counted = std::stoi(report.substr(place + said.size()));
        CHECK(counted >= certificate.solutions);
        const std::string notation =
            lines_of(run(plprove + " problem " + certificate.problem).out)[0].substr(12);
        const std::string first = notation.substr(0, notation.find(' '));
        const int factor = 2 << std::ranges::count(first, '/');
        const int certified = (counted + factor - 1) / factor * factor; // by Theorem G
        listed.insert(notation + ": " + std::to_string(certified));
    }
    CHECK(listed == lines);
    CHECK(listed.size() == 6);
    CHECK(lines_of(report).size() == listed.size());
}

TEST_CASE("the list of certificates of sweeps has each problem of some families that the table "
          "of degrees has") {
    const std::map<std::string, std::string> digests = digests_of_sweeps();
    const std::set<std::string> on_file = problems_of_families(
        {"upright-focal", "shared-focal", "focal", "shared-focal-center", "shared-k"});
    CHECK(digests.size() == 393);
    CHECK(std::ranges::equal(digests | std::views::keys, on_file));
}

TEST_CASE("docs/families.md has the table of the degrees on file") {
    struct Counts {
        int minimal = 0, least = std::numeric_limits<int>::max(), most = 0;
        int by_theorem = 0, by_evidence = 0, bounded = 0;
    };
    std::map<std::string, Counts> families;
    for (const char* family : {"upright", "upright-shared-focal", "upright-focal", "shared-focal",
                               "focal", "shared-focal-center", "shared-k"}) {
        const std::string list = plprove + " list --minimal --count --family " + family;
        families[family].minimal = std::stoi(run(list).out);
    }
    const std::regex form(R"(([^,]*),[^,]*,(\d+),([^,]*),([^,]*),.*)");
    for (const std::string& line : lines_of(read_file(certs + "family-degrees.csv"))) {
        std::smatch cells;
        if (!std::regex_match(line, cells, form) || !families.contains(cells[1])) continue;
        Counts& counts = families[cells[1]];
        if (cells[3] != "exact") {
            ++counts.bounded;
            continue;
        }
        ++(cells[4] == "certified" ? counts.by_theorem : counts.by_evidence);
        counts.least = std::min(counts.least, std::stoi(cells[2]));
        counts.most = std::max(counts.most, std::stoi(cells[2]));
    }
    const auto cell = [](int count) { return count == 0 ? "" : std::to_string(count) + ' '; };
    const std::string page = read_file(SOURCE_DIR "/docs/families.md");
    for (const auto& [family, counts] : families) {
        const int all = counts.by_theorem + counts.by_evidence;
        const std::string range =
            all == 0 ? ""
                     : std::to_string(counts.least) + " to " + std::to_string(counts.most) + ' ';
        const std::string row = "| `" + family + "` | " + std::to_string(counts.minimal) + " | " +
                                cell(all) + "| " + range + "| " + cell(counts.by_theorem) + "| " +
                                cell(counts.by_evidence) + "| " + cell(counts.bounded) + "|\n";
        CAPTURE(row);
        CHECK(page.find(row) != std::string::npos);
    }
}

TEST_CASE("plprove gives back the bytes of certificates of sweeps, and they hold") {
    const std::map<std::string, std::string> digests = digests_of_sweeps();
    const TemporaryFolder folder;
    const std::string path = (folder / "solutions.plc").string();
    for (const char* problem :
         {"upright-focal: 3*PL/PL/PL + a/a/a", "shared-focal: P/P/P + Pabcdef/Pabcdef/Pabcdef",
          "focal: 3*PL/PL/PL + Pabc/Pabc/Pabc"}) {
        CAPTURE(problem);
        nlohmann::json file;
        for (const char* seed : {"1", "2", "3"}) { // the sweep has used one of these
            const std::string command = plprove + " degree '" + problem + "' --target 300 --seed ";
            REQUIRE(run(command + seed + " -o " + path).status == 0);
            const Outcome checked = run(plcheck + " --json " + path);
            CHECK(checked.status == 0);
            file = nlohmann::json::parse(checked.out).at("files").at(0);
            if (file.at("sha256") == digests.at(problem)) break;
        }
        CHECK(file.at("sha256") == digests.at(problem));
        CHECK(file.at("solutions").at(0).at("certified_at_least") > 1);
    }
}

TEST_CASE("plprove gives back the bytes of the smallest certificate in general, and it holds") {
    const ListedCertificate smallest = listed_in(in_general).at(0);
    const TemporaryFolder folder;
    const Outcome checked = run(plcheck + " --json " + find_again(smallest, folder));
    CHECK(checked.status == 0);
    const nlohmann::json file = nlohmann::json::parse(checked.out).at("files").at(0);
    CHECK(file.at("sha256") == smallest.digest);
    CHECK(file.at("solutions").at(0).at("certified_at_least") >= smallest.solutions);
}
