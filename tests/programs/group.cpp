// `plprove group`, and what plcheck makes of its files and of those that are committed.
#include "tests/support/programs.h"

#include <doctest/doctest.h>
#include <map>
#include <nlohmann/json.hpp>
#include <regex>

namespace {

const std::string chicago_group = certs + "groups/2394.plc";

/// The groups that plcheck certifies, by class.
std::map<std::size_t, std::string> certified_groups(const std::string& files) {
    const Outcome outcome = run(plcheck + " --json " + certs + "classification.plc " + files);
    CHECK(outcome.status == 0);
    std::map<std::size_t, std::string> groups;
    for (const auto& [number, group] : nlohmann::json::parse(outcome.out)["certified_groups"]
                                           .get<std::vector<std::pair<std::size_t, std::string>>>())
        groups[number] = group;
    return groups;
}

const std::map<std::size_t, std::string>& committed_groups() {
    static const auto groups = certified_groups(certs + "groups/*.plc");
    return groups;
}

} // namespace

TEST_CASE("docs/groups.md has the groups that plcheck certifies by the committed fibres") {
    const std::map<std::size_t, std::string>& certified = committed_groups();
    CHECK(certified.size() > 4);
    std::map<std::size_t, std::string> shown;
    const std::regex row(R"re(\| `[^`]*` \| (\d+) \| (\d+) \| (S\d+) \|.*)re");
    for (const std::string& line : lines_of(read_file(SOURCE_DIR "/docs/groups.md"))) {
        std::smatch cells;
        if (!std::regex_match(line, cells, row)) continue;
        shown[std::stoul(cells[1])] = cells[3];
        CHECK("S" + std::string(cells[2]) == cells[3]);
    }
    CHECK(shown == certified);
}

TEST_CASE(
    "plprove problem says the groups that plcheck certifies, and certs/groups.csv has no more") {
    const std::map<std::size_t, std::string>& certified = committed_groups();
    for (const auto& [number, group] : certified) {
        const Outcome report = run(plprove + " problem --json " + std::to_string(number));
        CHECK(nlohmann::json::parse(report.out)["group"] ==
              nlohmann::json{{"name", group}, {"status", "certified"}});
        CHECK(run(plprove + " problem " + std::to_string(number))
                  .out.find("\ngroup       " + group + " certified\n") != std::string::npos);
    }
    std::size_t rows = 0;
    for (const std::string& line : lines_of(read_file(certs + "groups.csv"))) {
        if (line.starts_with('#') || line == "number,group") continue;
        ++rows;
        const std::size_t comma = line.find(',');
        CHECK('"' + certified.at(std::stoul(line.substr(0, comma))) + '"' ==
              line.substr(comma + 1));
    }
    CHECK(rows > 0);
    CHECK(run(plprove + " problem 6720").out.find("\ngroup ") == std::string::npos);
}

TEST_CASE("with a record less the group is not known, or not to be all permutations") {
    const std::string file = read_file(chicago_group);
    const std::size_t first = file.find("degree "), second = file.find("\ndegree ", first) + 1;
    const TemporaryFolder folder;
    write_file(folder / "first.plc", file.substr(0, second));
    write_file(folder / "second.plc", file.substr(0, first) + file.substr(second));
    CHECK(certified_groups(chicago_group) == std::map<std::size_t, std::string>{{2394, "S312"}});
    // The first record has the factor of degree 271.
    CHECK(certified_groups((folder / "first.plc").string()) ==
          std::map<std::size_t, std::string>{{2394, ">=A312"}});
    CHECK(certified_groups((folder / "second.plc").string()).empty());
}

TEST_CASE("fibres of a problem whose group is smaller are certified lower bounds") {
    const TemporaryFolder folder;
    const std::string file = (folder / "fibre.plc").string();
    const Outcome found = run(plprove + " group 4 --fibres 1 -o " + file);
    CHECK(found.status == 1);
    CHECK(found.out.find("\ncycles      ") != std::string::npos);
    CHECK(found.err.empty());
    CHECK(run(plprove + " group 4 --fibres 1 -o -").out == read_file(file));
    const Outcome checked = run(plcheck + ' ' + file);
    CHECK(checked.status == 0);
    CHECK(checked.out.find("- class 4: certified to have at least 64 solutions\n") !=
          std::string::npos);
    const Outcome expected =
        run(plcheck + " --expect 'Pabcdef/Pabcdef/Pabcdef + a/P/Pa' --group S64 " + certs +
            "classification.plc " + file);
    CHECK(expected.status == 1);
    CHECK(expected.out.find("no fibres certify its group") != std::string::npos);
}

TEST_CASE("what has no group to look for is refused with advice") {
    for (const auto& [problem, reason] : std::map<std::string, std::string>{
             {"5*P/P", "is not minimal in three calibrated views: give a problem that is"},
             {"7*P/P/P", "is not minimal in three calibrated views: give a problem that is"},
             {"nonsense", "nonsense"}}) {
        CAPTURE(problem);
        const Outcome outcome = run(plprove + " group '" + problem + "'");
        CHECK(outcome.status == 2);
        CHECK(outcome.err.find(reason) != std::string::npos);
    }
    CHECK(run(plprove + " group 4 --fibres 0").status == 3);
}
