// `plprove group`, and what plcheck makes of its files and of those that are committed.
#include "tests/support/programs.h"

#include <algorithm>
#include <doctest/doctest.h>
#include <map>
#include <nlohmann/json.hpp>
#include <regex>

namespace {

const std::string models = std::string(SOURCE_DIR) + "/models/";
const std::string chicago_group = certs + "groups/2394.plc";

/// The groups that plcheck certifies, by class.
std::map<std::size_t, std::string> certified_groups(const std::string& files,
                                                    const std::string& options = "") {
    const Outcome outcome =
        run(plcheck + " --json " + options + " " + certs + "classification.plc " + files);
    CHECK(outcome.status == 0);
    std::map<std::size_t, std::string> groups;
    for (const auto& [number, group] : nlohmann::json::parse(outcome.out)["certified_groups"]
                                           .get<std::vector<std::pair<std::size_t, std::string>>>())
        groups[number] = group;
    return groups;
}

/// A row of certs/groups.csv, or of certs/family-groups.csv.
struct GroupRow {
    std::string line;
    std::string problem;    ///< in the second file, in notation
    std::size_t number = 0; ///< in the first
    std::string group, order;
    int width = 0;
    std::string status;
};

std::vector<GroupRow> rows_of(const std::string& file) {
    std::vector<GroupRow> rows;
    const std::regex form(
        R"re((\d+|"([^"]*)"),"([^"]*)","([^"]*)",(\d+),"(certified|evidence)")re");
    for (const std::string& line : lines_of(read_file(file))) {
        if (line.starts_with('#') || line.ends_with(",group,order,width,status")) continue;
        CAPTURE(line);
        std::smatch cells;
        REQUIRE(std::regex_match(line, cells, form));
        rows.push_back({line, cells[2], cells[2].matched ? 0 : std::stoul(cells[1]), cells[3],
                        cells[4], std::stoi(cells[5]), cells[6]});
    }
    return rows;
}

std::vector<GroupRow> rows_on_file() {
    return rows_of(certs + "groups.csv");
}

std::string without_commas(std::string text) {
    std::erase(text, ',');
    return text;
}

/// How many solutions each step of a group has, the last step first.
std::vector<int> numbers_in(const std::string& group) {
    std::vector<int> numbers;
    const std::regex number(R"(\d+)");
    for (std::sregex_iterator at(group.begin(), group.end(), number), end; at != end; ++at)
        numbers.push_back(std::stoi(at->str()));
    return numbers;
}

/// A line of certs/groups/SHA256SUMS: fibres that certify a group, and are not committed.
struct ListedGroup {
    std::string digest, number, group;
};

std::vector<ListedGroup> listed_groups() {
    std::vector<ListedGroup> groups;
    const std::regex form(R"re(([0-9a-f]{64})  (\d+)-(\w+)\.plc)re");
    for (const std::string& line : lines_of(read_file(certs + "groups/SHA256SUMS"))) {
        std::smatch cells;
        REQUIRE(std::regex_match(line, cells, form));
        const bool is_half = std::string(cells[3]).ends_with("S2wrS10"); // `<S8 wr S2 wr S10`
        const std::string group =
            std::regex_replace(std::string(cells[3]), std::regex("wr"), " wr ");
        groups.push_back({cells[1], cells[2], (is_half ? "<" : "") + group});
    }
    return groups;
}

/// By Theorem S and by the committed fibres.
const std::map<std::size_t, std::string>& committed_groups() {
    static const auto groups = certified_groups(certs + "groups/*.plc", "--table");
    return groups;
}

} // namespace

TEST_CASE("docs/groups.md has the groups that plcheck certifies by the committed fibres") {
    std::map<std::size_t, std::string> of_files, shown;
    for (const auto& entry : std::filesystem::directory_iterator(certs + "groups")) {
        if (entry.path().extension() != ".plc") continue;
        const std::size_t number = std::stoul(entry.path().stem().string());
        of_files[number] = committed_groups().at(number);
    }
    CHECK(of_files.size() == 13);
    const std::regex row(R"re(\| `[^`]*` \| (\d+) \| (\d+) \| (S\d+) \|.*)re");
    for (const std::string& line : lines_of(read_file(SOURCE_DIR "/docs/groups.md"))) {
        std::smatch cells;
        if (!std::regex_match(line, cells, row)) continue;
        shown[std::stoul(cells[1])] = cells[3];
        CHECK("S" + std::string(cells[2]) == cells[3]);
    }
    CHECK(shown == of_files);
}

TEST_CASE("certs/groups.csv calls those groups certified that plcheck certifies, and so does "
          "plprove problem") {
    std::map<std::size_t, std::string> certified, called_certified;
    std::size_t rows = 0;
    for (const GroupRow& row : rows_on_file()) {
        if (row.status == "certified") called_certified[row.number] = row.group;
        const auto found = committed_groups().find(row.number);
        if (found == committed_groups().end()) continue;
        certified.insert(*found);
        if (++rows % 2000 != 1) continue;
        const std::string number = std::to_string(row.number);
        const nlohmann::json json =
            nlohmann::json::parse(run(plprove + " problem --json " + number).out)["group"];
        CHECK(json["name"] == row.group);
        CHECK(json["order"] == row.order);
        CHECK(json["width"] == row.width);
        CHECK(json["status"] == "certified");
        CHECK(run(plprove + " problem " + number)
                  .out.find("\ngroup       " + row.group + " certified\n") != std::string::npos);
    }
    CHECK(certified.size() == 9923);
    for (const ListedGroup& listed : listed_groups())
        CHECK(certified.emplace(std::stoul(listed.number), listed.group).second);
    CHECK(called_certified == certified);
    CHECK(certified.size() == 10034);
    const auto whole = std::ranges::count_if(
        committed_groups(), [](const auto& group) { return group.second.starts_with('S'); });
    CHECK(without_commas(read_file(SOURCE_DIR "/README.md"))
              .find(std::to_string(whole) + " of them do\nnot decompose") != std::string::npos);
}

TEST_CASE(
    "plprove gives back the bytes of fibres in the list of groups, and plcheck certifies these") {
    const std::vector<ListedGroup> listed = listed_groups();
    const TemporaryFolder folder;
    const std::string file = (folder / "group.plc").string();
    const auto of_pairs = std::ranges::find(listed, "S2 wr S120", &ListedGroup::group);
    REQUIRE(of_pairs != listed.end());
    for (const ListedGroup& one : {listed.front(), listed[listed.size() / 4], *of_pairs}) {
        CAPTURE(one.number);
        CHECK(run(plprove + " group " + one.number + " -o " + file).status == 0);
        const Outcome checked = run(plcheck + " --json " + certs + "classification.plc " + file);
        REQUIRE(checked.status == 0);
        const nlohmann::json report = nlohmann::json::parse(checked.out);
        CHECK(report["files"][1]["sha256"] == one.digest);
        CHECK(report["certified_groups"].dump() == "[[" + one.number + ",\"" + one.group + "\"]]");
    }
    // Now the file is that of pairs. Without one of its three fibres signs or cycles are missing.
    const std::string expect = plcheck + " --expect 'Pabcd/Pabcd/Pabcd + P/P/P + -/P/P' --group ";
    const std::string files = " " + certs + "classification.plc " + file;
    CHECK(run(expect + "'S2 wr S120'" + files).status == 0);
    CHECK(run(expect + "S240" + files).status == 1);
    CHECK(run(expect + "'S2 wr S'" + files).status == 3);
    const std::string whole = read_file(file);
    write_file(file, whole.substr(0, whole.rfind("\ndegree ") + 1));
    CHECK(run(expect + "'S2 wr S120'" + files).status == 1);
}

TEST_CASE("plcheck certifies a group by Theorem S, from the record that the problem is minimal") {
    const TemporaryFolder folder;
    const std::string problem = "'4*-/P/P + 6*a/P/a + a/a/P'";
    const std::string file = (folder / "mine.plc").string();
    CHECK(run(plprove + " problem " + problem + " --certificate " + file).status == 0);
    const std::string expect = plcheck + " --why --expect " + problem + " --group ";
    const Outcome verified = run(expect + "S1000 " + file);
    CHECK(verified.status == 0);
    CHECK(
        verified.out.find("\n- its group is S1000, by Theorem S of proofs/all_permutations.md\n") !=
        std::string::npos);
    CHECK(run(expect + "'>=A1000' " + file).status == 0);
    const Outcome wrong = run(expect + "S999 " + file);
    CHECK(wrong.status == 1);
    CHECK(wrong.out.find("the group is certified to be S1000") != std::string::npos);
    // No condition that knows the third camera: no theorem says anything.
    const Outcome open = run(plcheck + " --expect 'Pab/Pab/Pab + a/Pa/Pa + 3*-/P/P' --group S160 " +
                             certs + "classification.plc");
    CHECK(open.status == 1);
    CHECK(open.out.find("no theorem and no fibres certify its group; add the file that plprove "
                        "group PROBLEM -o FILE writes") != std::string::npos);
}

TEST_CASE("plcheck certifies by Theorem P how third cameras are permuted") {
    const std::string expect = plcheck + " --why --expect 'Pa/Pa/Pa + a/P/Pa + 4*P/-/P + a/a/P' ";
    const std::string file = " " + certs + "classification.plc";
    const Outcome verified = run(expect + "--group '<S8 wr S2 wr S10'" + file);
    CHECK(verified.status == 0);
    CHECK(verified.out.find("\n- its group is <S8 wr S2 wr S10, by Theorem P of "
                            "proofs/five_shared_points.md\n") != std::string::npos);
    CHECK(verified.out.find("has a group of index 2 in S8 wr S2 wr S10") != std::string::npos);
    for (const char* wrong : {"S160", "'>=A160'", "'<S4 wr S2 wr S10'"})
        CHECK(run(expect + "--group " + wrong + file).status == 1);
    for (const char* none : {"'<S8 wr S2 wr S9'", "'<S wr S2 wr S10'", "'<S8'"})
        CHECK(run(expect + "--group " + none + file).status == 3);
    // Only shared points move the third camera: with both views, and with one.
    const auto status = [&](const std::string& problem, const std::string& group) {
        return run(plcheck + " --expect '" + problem + "' --group '" + group + "'" + file).status;
    };
    CHECK(status("P/P/P + 4*-/P/P + 2*P/-/P + 2*P/P/-", "<S32 wr S2 wr S10") == 0);
    CHECK(status("2*a/a/a + 5*-/P/P + 2*P/-/P", "<S16 wr S2 wr S10") == 0);
    // Nothing moves it; and it is found by smaller steps: evidence says `<S2 wr S2 wr S10 wr S10`.
    CHECK(status("3*a/a/a + 5*-/P/P", "<S8 wr S2 wr S10") == 1);
    CHECK(status("a/P/Pa + 5*P/-/P + 4*P/P/-", "<S20 wr S2 wr S10") == 1);
}

TEST_CASE("plcheck certifies by Proposition P6 how five points permute their poses") {
    const std::string files = " " + certs + "plmp.plc " + certs + "solutions/plmp.plc";
    const auto asked = [&](const std::string& problem, const std::string& group) {
        return run(plcheck + " --why --expect '" + problem + "' --group '" + group + "'" + files);
    };
    const Outcome verified = asked("5*P/P", "<S2 wr S10");
    CHECK(verified.status == 0);
    CHECK(verified.out.find("\n- its group is <S2 wr S10, by Theorem P of "
                            "proofs/five_shared_points.md\n") != std::string::npos);
    CHECK(asked("5*P/P", "S20").status == 1);
    CHECK(asked("3*PL/PL + 2*P/P", "<S2 wr S10").status == 1); // three points on a line
    CHECK(run(plcheck + " --expect '5*P/P' --group '<S2 wr S10' " + certs + "plmp.plc").status ==
          1); // nothing says that there are 20
}

TEST_CASE("the groups on file keep to the laws of degrees, parts and families") {
    const std::vector<GroupRow> rows = rows_on_file();
    CHECK(rows.size() > 300);
    std::map<std::size_t, nlohmann::json> classes;
    const nlohmann::json listed =
        nlohmann::json::parse(run(plprove + " list --minimal --format json").out);
    for (const nlohmann::json& entry : listed.at("classes"))
        classes[entry.at("number").get<std::size_t>()] = entry;
    for (const GroupRow& row : rows) {
        CAPTURE(row.number);
        const nlohmann::json& entry = classes.at(row.number);
        const int degree = entry.at("degree").get<int>();
        int product = 1, hardest = 1;
        for (const int step : numbers_in(row.group)) {
            product *= step;
            hardest = std::max(hardest, step == 4 ? 3 : step);
        }
        CHECK(product == degree);
        CHECK(row.width <= hardest);
        if (row.status == "certified" && row.group.starts_with('<')) {
            const std::string m = std::to_string(degree / 20);
            CHECK(row.group == "<S" + m + " wr S2 wr S10");
            CHECK(row.order == m + "!^20*2!^10*10!/2");
        }
        // Five points that two views share have 10 essential matrices, each with a twisted pair.
        // Where two pairs of views share five points, the essential matrices are the first steps.
        const bool has_five_points =
            row.group.ends_with("S2 wr S10") || row.group.ends_with("<S2 wr S2 wr S10 wr S10");
        CHECK(has_five_points == entry.at("five_point").get<bool>());
        // A point with six pins in each view: a quartic and square roots, Theorem 4.
        CHECK((row.width <= 3) == (degree == 64));
    }
}

TEST_CASE("plprove group says by loops what certs/groups.csv has, and adds rows to a table") {
    const nlohmann::json found =
        nlohmann::json::parse(run(plprove + " group 4767 --json").out)["evidence"];
    const auto rows = rows_on_file();
    const auto row = std::ranges::find(rows, 4767U, &GroupRow::number);
    REQUIRE(row != rows.end());
    CHECK(found["group"] == row->group);
    CHECK(found["order"] == row->order);
    CHECK(found["width"] == row->width);
    CHECK(found["steps"] == std::vector<int>{10, 2, 8});
    CHECK(run(plprove + " group 4767")
              .out.find("\ngroup       a subgroup of S8 wr S2 wr S10: evidence, by ") !=
          std::string::npos);

    // Loops agree with Theorem S.
    const nlohmann::json large = nlohmann::json::parse(run(plprove + " group 25707 --json").out);
    CHECK(large["evidence"]["group"] == "S1312");
    CHECK(large["certified_group"] == "S1312");

    // The table goes on where it was: the row of class 4 stays as it is.
    const TemporaryFolder folder;
    const std::string table = (folder / "groups.csv").string();
    write_file(table, "number,group,order,width,status\n4,\"kept\",\"1\",1,\"evidence\"\n");
    const Outcome made = run(plprove + " group --up-to 64 -o " + table);
    CHECK(made.status == 0);
    CHECK(made.err.empty());
    const std::string text = read_file(table);
    CHECK(text.find("\n4,\"kept\",\"1\",1,\"evidence\"\n") != std::string::npos);
    for (const GroupRow& one : rows)
        if (numbers_in(one.group) == std::vector<int>{2, 2, 2, 2, 4} && one.number != 4)
            CHECK(text.find("\n" + one.line + "\n") != std::string::npos);
    // What is taken away from the committed table comes back, byte for byte.
    const std::string committed = read_file(certs + "groups.csv");
    std::string shorter = committed;
    const auto by_loops = std::ranges::find(rows, 546U, &GroupRow::number);
    REQUIRE(by_loops != rows.end());
    shorter.erase(shorter.find(by_loops->line + "\n"), by_loops->line.size() + 1);
    write_file(table, shorter);
    CHECK(run(plprove + " group --up-to 160 -o " + table).status == 0);
    CHECK(read_file(table) == committed);
    write_file(table, "not a table\n");
    const Outcome refused = run(plprove + " group --up-to 64 -o " + table);
    CHECK(refused.status == 2);
    CHECK(refused.err.find("groups.csv:1: not a row of a table of groups: give another file, or a "
                           "new one") != std::string::npos);
    CHECK(read_file(table) == "not a table\n");
}

TEST_CASE("docs/groups.md counts the classes of certs/groups.csv that decompose, and all") {
    std::map<std::string, int> on_file, shown;
    int symmetric = 0;
    const std::vector<GroupRow> rows = rows_on_file();
    for (const GroupRow& row : rows)
        if (row.group.find(" wr ") == std::string::npos)
            ++symmetric;
        else
            ++on_file[row.group + " " + std::to_string(row.width)];
    const std::regex form(R"re(\| \d+ \| (\d+) \| `([^`]*)` \| (\d+) \|)re");
    const std::string page = read_file(SOURCE_DIR "/docs/groups.md");
    for (const std::string& line : lines_of(page)) {
        std::smatch cells;
        if (std::regex_match(line, cells, form))
            shown[std::string(cells[2]) + " " + std::string(cells[3])] += std::stoi(cells[1]);
    }
    CHECK(shown == on_file);
    CHECK(without_commas(page).find("**" + std::to_string(symmetric) + " of the " +
                                    std::to_string(rows.size()) + "**") != std::string::npos);
}

TEST_CASE("problems of other lists have the groups that docs/groups.md shows") {
    const std::regex form(R"re(\| `([^`]*)` \| (\d+) \| `([^`]*)` \| (\d+) \|)re");
    int rows = 0;
    for (const std::string& line : lines_of(read_file(SOURCE_DIR "/docs/groups.md"))) {
        std::smatch cells;
        if (!std::regex_match(line, cells, form)) continue;
        CAPTURE(line);
        ++rows;
        const Outcome outcome = run(plprove + " group --json '" + std::string(cells[1]) + "'");
        REQUIRE(outcome.status == 0);
        const nlohmann::json found = nlohmann::json::parse(outcome.out);
        CHECK(found["degree"] == std::stoi(cells[2]));
        CHECK(found["evidence"]["group"] == std::string(cells[3]));
        CHECK(found["evidence"]["width"] == std::stoi(cells[4]));
    }
    CHECK(rows == 21);
    // A cubic.
    CHECK(run(plprove + " group 'projective: 7*P/P'").out.find("\ngroup       S3: ") !=
          std::string::npos);
}

TEST_CASE("fibres certify the groups of problems in general") {
    const TemporaryFolder folder;
    const std::string file = (folder / "group.plc").string();
    const std::string problem = " 'projective: 7*P/P' ";
    const Outcome found = run(plprove + " group" + problem + "-o " + file);
    CHECK(found.status == 0);
    CHECK(found.err.empty());
    CHECK(found.out.find("\nfibres      S3: certified once plcheck accepts it\ncycles      ") !=
          std::string::npos);
    const std::string expect = plcheck + " --why --expect" + problem + "--degree 3 --group ";
    const Outcome verified = run(expect + "S3 " + file);
    CHECK(verified.status == 0);
    CHECK(verified.out.find("\n- its group is S3, by fibres: proofs/fibres.md\n") !=
          std::string::npos);
    CHECK(run(expect + "S2 " + file).status == 1);
    const std::string text = read_file(file);
    write_file(file, text.substr(0, text.find("\nproblem", 20) + 1)); // one fibre
    CHECK(run(expect + "S3 " + file).status == 1);
    CHECK(run(plcheck + " --expect" + problem + "--degree 3 " + file).status == 0);
    // One solution is one for certain; a fibre does not need loops.
    CHECK(run(plprove + " group 'projective: PLM/PLM + 2*PL/PL + 2*PM/PM + 2*P/P' -o " + file)
              .status == 0);
    // Where the group is smaller, a fibre certifies the number of solutions.
    CHECK(run(plprove + " group five-point -o " + file).status == 1);
    CHECK(run(plcheck + " --expect '5*P/P' --degree 20 " + file).status == 0);
}

TEST_CASE("certs/family-groups.csv calls those groups certified that plcheck certifies") {
    const Outcome checked =
        run(plcheck + " --json " + certs + "plmp.plc " + certs + "projective.plc " + certs +
            "families/*.plc " + certs + "solutions/*.plc");
    REQUIRE(checked.status == 0);
    std::map<std::string, std::string> certified, called_certified;
    std::map<std::string, std::size_t> counted;
    const nlohmann::json report = nlohmann::json::parse(checked.out);
    for (const nlohmann::json& family : report["families"]) {
        counted[family["family"]] = family["certified_groups"].size();
        for (const auto& [problem, group] :
             family["certified_groups"].get<std::vector<std::pair<std::string, std::string>>>())
            certified[problem] = group;
    }
    for (const GroupRow& row : rows_of(certs + "family-groups.csv"))
        if (row.status == "certified" && row.group != "S1")
            called_certified[row.problem] = row.group;
    CHECK(called_certified == certified);
    CHECK(counted["plmp"] == 7);
    CHECK(counted["projective"] == 200);
    CHECK(counted["upright"] + counted["upright-shared-focal"] + counted["upright-focal"] == 30);
    CHECK(counted["shared-focal"] == 1);
    CHECK(counted["focal"] == 3);
}

TEST_CASE("certs/family-groups.csv keeps to the degrees on file, and is counted in "
          "docs/groups.md") {
    std::map<std::string, std::pair<int, std::string>> degrees; // and their status
    const std::regex form(R"re([^,]*,([^,]*),(\d+),exact,(\w+),.*)re");
    for (const std::string& line : lines_of(read_file(certs + "family-degrees.csv"))) {
        std::smatch cells;
        if (std::regex_match(line, cells, form))
            degrees[cells[1]] = {std::stoi(cells[2]), cells[3]};
    }
    const std::vector<GroupRow> rows = rows_of(certs + "family-groups.csv");
    std::map<std::string, int> of_projective, known_in_part, plmp;
    for (const GroupRow& row : rows) {
        CAPTURE(row.line);
        const auto& [degree, status] = degrees.at(row.problem);
        int product = 1;
        for (const int step : numbers_in(row.group))
            product *= step;
        CHECK(product == degree);
        const bool decomposes = row.group.find(" wr ") != std::string::npos;
        CHECK((row.width < degree) == (decomposes || degree == 4));
        if (degree == 1) CHECK(row.status == status);
        auto& counts = row.problem.starts_with("projective:")       ? of_projective
                       : row.problem.find(':') != std::string::npos ? known_in_part
                                                                    : plmp;
        ++counts[degree == 1 ? "one" : decomposes ? "decomposes" : "all"];
    }
    CHECK(of_projective ==
          std::map<std::string, int>{{"all", 200}, {"decomposes", 18}, {"one", 75}});
    CHECK(known_in_part == std::map<std::string, int>{{"all", 57}, {"decomposes", 15}});
    CHECK(plmp == std::map<std::string, int>{{"all", 7}, {"decomposes", 5}});
    const std::string page = read_file(SOURCE_DIR "/docs/groups.md");
    for (const char* words :
         {"75 have one solution, 200 have all permutations", "Fibres\ncertify this for all 200.",
          "\n72 problems of `upright`", "for the 30 whose number"})
        CHECK(page.find(words) != std::string::npos);
}

TEST_CASE("plprove list, plprove problem and plprove group --families say what "
          "certs/family-groups.csv has") {
    const std::vector<GroupRow> rows = rows_of(certs + "family-groups.csv");
    const std::string listed = run(plprove + " list --family shared-focal --format csv").out;
    int shown = 0;
    for (const GroupRow& row : rows) {
        if (!row.problem.starts_with("shared-focal:")) continue;
        const std::string cells =
            row.group + ',' + row.order + ',' + std::to_string(row.width) + ',' + row.status + '\n';
        const std::size_t at = listed.find(',' + row.problem + ',');
        REQUIRE(at != std::string::npos);
        const std::string rest = listed.substr(at, listed.find('\n', at) + 1 - at);
        CHECK(rest.ends_with(',' + cells));
        if (++shown > 2) continue;
        const std::string problem = plprove + " problem '" + row.problem + "'";
        CHECK(run(problem).out.ends_with("\ngroup       " + row.group + ' ' + row.status + '\n'));
        CHECK(nlohmann::json::parse(run(problem + " --json").out)["group"]["order"] == row.order);
    }
    CHECK(shown == 15);
    CHECK(run(plprove + " problem five-point").out.find("\ngroup       <S2 wr S10 certified\n") !=
          std::string::npos);
    // What is taken away from the committed table comes back, byte for byte.
    const TemporaryFolder folder;
    const std::string table = (folder / "groups.csv").string();
    const std::string committed = read_file(certs + "family-groups.csv");
    std::string shorter = committed;
    for (const char* problem :
         {"shared-focal: 3*PL/PL + 3*PM/PM", "projective: 2*Pabcdef/Pabcdef/Pabcdef"}) {
        const auto row = std::ranges::find(rows, problem, &GroupRow::problem);
        REQUIRE(row != rows.end());
        shorter.erase(shorter.find(row->line), row->line.size() + 1);
    }
    write_file(table, shorter);
    CHECK(run(plprove + " group --families --up-to 16 -o " + table).status == 0);
    CHECK(read_file(table) == committed);
    write_file(table, "\"projective: 1*P/P\",\"S1\",\"1!\",1,\"evidence\"\n");
    CHECK(run(plprove + " group --families --up-to 16 -o " + table)
              .err.find("groups.csv:1: not a row of a table of groups") != std::string::npos);
    CHECK(run(plprove + " group --families -o " + table).status == 2);
}

TEST_CASE("plcheck names the groups that it has certified") {
    const Outcome one =
        run(plcheck + ' ' + certs + "classification.plc " + certs + "groups/69.plc");
    CHECK(one.out.find("; the group of class 69 (S240)") != std::string::npos);
    const Outcome two = run(plcheck + ' ' + certs + "classification.plc " + certs +
                            "groups/69.plc " + chicago_group);
    CHECK(two.out.find("; the groups of classes 69 (S240) and 2394 (S312)") != std::string::npos);
}

TEST_CASE("with a record less the group is not known") {
    const std::string file = read_file(chicago_group);
    const std::size_t first = file.find("degree "), second = file.find("\ndegree ", first) + 1;
    const TemporaryFolder folder;
    write_file(folder / "first.plc", file.substr(0, second));
    write_file(folder / "second.plc", file.substr(0, first) + file.substr(second));
    CHECK(certified_groups(chicago_group) == std::map<std::size_t, std::string>{{2394, "S312"}});
    CHECK(certified_groups((folder / "first.plc").string()).empty());
    CHECK(certified_groups((folder / "second.plc").string()).empty());
    // The same record twice shows one permutation only.
    write_file(folder / "twice.plc", file.substr(0, second) + file.substr(first, second - first));
    CHECK(certified_groups((folder / "twice.plc").string()).empty());
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

TEST_CASE("docs/groups.md has the groups of models, certified where plcheck certifies them") {
    std::map<std::string, std::string> certified, shown;
    const Outcome checked = run(plcheck + " --json --table " + certs + "groups/models/*.plc");
    REQUIRE(checked.status == 0);
    const nlohmann::json report = nlohmann::json::parse(checked.out);
    for (const nlohmann::json& file : report["files"])
        certified[file["model"]] = file["certified_group"];
    CHECK(certified.size() > 20);
    const std::regex row(
        R"re(\| \[(\w+)\]\(\.\./models/\w+\.model\) \| (\d+) \| `([^`]*)` \| (\d+) \| (.*) \|)re");
    std::map<std::string, nlohmann::json> decomposing;
    for (const std::string& line : lines_of(read_file(SOURCE_DIR "/docs/groups.md"))) {
        std::smatch cells;
        if (!std::regex_match(line, cells, row)) continue;
        const std::string name = cells[1], group = cells[3];
        if (cells[5] == "certified") shown[name] = group;
        if (!group.starts_with('S') || group.find(' ') != std::string::npos)
            decomposing[name] = {std::stoi(cells[2]), group, std::stoi(cells[4])};
        else
            CHECK("S" + std::string(cells[2]) == group);
    }
    CHECK(shown == certified);
    CHECK(decomposing.size() > 8);
    for (const auto& [name, expected] : decomposing) {
        CAPTURE(name);
        if (expected[0] > 20) continue; // takes long
        const nlohmann::json found =
            nlohmann::json::parse(run(plprove + " group --json " + models + name + ".model").out);
        CHECK(nlohmann::json{found["solutions"], found["evidence"]["group"],
                             found["evidence"]["width"]} == expected);
    }
}

TEST_CASE("plprove group certifies that of a model, and says plainly where it cannot") {
    const TemporaryFolder folder;
    const std::string file = (folder / "group.plc").string();
    const std::string model = models + "p3l.model";
    const Outcome found = run(plprove + " group " + model + " -o " + file);
    CHECK(found.status == 0);
    CHECK(found.err.empty());
    CHECK(found.out.find("\ngroup       S8: evidence, by ") != std::string::npos);
    CHECK(found.out.find("\nfibres      S8: certified once plcheck accepts it\ncycles      ") !=
          std::string::npos);
    CHECK(read_file(file) == read_file(certs + "groups/models/p3l.plc"));
    CHECK(run(plcheck + " --expect " + model + " --degree 8 --group S8 " + file).status == 0);
    const std::string text = read_file(file);
    const std::size_t first = text.find("\nfibre") + 1, second = text.find("\nfibre", first) + 1;
    // Without a fibre, or with a wrong one, there is no group.
    write_file(file, text.substr(0, first) + text.substr(second));
    const Outcome one = run(plcheck + " --expect " + model + " --group S8 " + file);
    CHECK(one.status == 1);
    CHECK(one.out.find("no fibres certify its group; add the file that plprove group ") !=
          std::string::npos);
    std::string wrong = text;
    wrong[text.find("polynomial ", second) + 11] ^= 1; // another digit
    write_file(file, wrong);
    CHECK(run(plcheck + " --expect " + model + " --group S8 " + file).status == 1);
    std::filesystem::remove(file);
    for (const auto& [name, reason] : std::map<std::string, std::string>{
             {"p3p", "the group does not contain all even permutations, by evidence"},
             {"resection", "it has one solution"}}) {
        const Outcome none = run(plprove + " group " + models + name + ".model -o " + file);
        CHECK(none.status == 1);
        CHECK(none.out.find("\nfibres      none, so there is no certificate: " + reason + "\n") !=
              std::string::npos);
        CHECK(!std::filesystem::exists(file));
    }
}

TEST_CASE("a model may fall into parts, and must have data that move") {
    const TemporaryFolder folder;
    const auto group = [&](const std::string& text) {
        write_file(folder / "mine.model", "model mine\n" + text);
        return run(plprove + " group " + (folder / "mine.model").string() + " --json");
    };
    const Outcome parts = group("data a, b\nunknown x\nequation (x^2 - a)*(x^3 - x - b) = 0\n");
    CHECK(parts.status == 0);
    const nlohmann::json found = nlohmann::json::parse(parts.out)["evidence"]["parts"];
    CHECK(found == nlohmann::json::parse(R"([{"solutions": 2, "group": "S2"},
                                             {"solutions": 3, "group": "S3"}])"));
    // Over the rational numbers the Galois group is S3, but no solution moves.
    const Outcome still = group("data a\nunknown x\nequation x^3 = x + 1\n");
    CHECK(nlohmann::json::parse(still.out)["evidence"]["parts"].size() == 3);
    CHECK(group("unknown x\nequation x^3 = x + 1\n").err.find("has no data") != std::string::npos);
    CHECK(group("data a\nunknown x, y\nequation x = a*y\n").status == 2);
    CHECK(group("data a\nequation x = a\n").err.find("mine.model, line 3, column 10") !=
          std::string::npos);
}

TEST_CASE("what has no group to look for is refused with advice") {
    for (const auto& [problem, reason] : std::map<std::string, std::string>{
             {"4*P/P", "is not minimal: give a problem that is"},
             {"projective: 6*P/P/P + 2*a/a/a", "is not on file: give a problem of"},
             {"7*P/P/P", "is not minimal: give a problem that is"},
             {"nonsense", "nonsense"}}) {
        CAPTURE(problem);
        const Outcome outcome = run(plprove + " group '" + problem + "'");
        CHECK(outcome.status == 2);
        CHECK(outcome.err.find(reason) != std::string::npos);
    }
    CHECK(run(plprove + " group 4 --fibres 0").status == 3);
    CHECK(run(plprove + " group").status == 2);
    CHECK(run(plprove + " group 4 --up-to 64 -o table.csv").status == 2);
    CHECK(run(plprove + " group --up-to 64").status == 2);
}
