// plprove list and plprove export as their users run them, and what certs/CATALOGUE.md says of
// them.
#include "prover/catalogue/columns.h"
#include "tests/support/program.h"

#include <doctest/doctest.h>
#include <memory>
#include <nlohmann/json.hpp>
#include <sqlite3.h>

namespace {

const std::string plprove_program = PLPROVE;

/// A database file, opened for reading.
class Database {
public:
    explicit Database(const std::string& path) {
        sqlite3* handle = nullptr;
        REQUIRE(sqlite3_open_v2(path.c_str(), &handle, SQLITE_OPEN_READONLY, nullptr) == SQLITE_OK);
        handle_.reset(handle);
    }

    /// The answer, one line a row, the values joined; the names of the columns first if asked for.
    std::string ask(const std::string& sql, const std::string& joint, bool names) const {
        sqlite3_stmt* raw = nullptr;
        sqlite3_prepare_v2(handle_.get(), sql.c_str(), -1, &raw, nullptr);
        INFO(sql << ": " << sqlite3_errmsg(handle_.get()));
        REQUIRE(raw != nullptr);
        const std::unique_ptr<sqlite3_stmt, decltype(&sqlite3_finalize)> statement(
            raw, &sqlite3_finalize);
        std::string text = names ? row(raw, joint, &sqlite3_column_name) : "";
        while (sqlite3_step(raw) == SQLITE_ROW)
            text += row(raw, joint, &Database::value);
        return text;
    }

private:
    static const char* value(sqlite3_stmt* statement, int column) {
        return reinterpret_cast<const char*>(sqlite3_column_text(statement, column));
    }

    template <class Field>
    static std::string row(sqlite3_stmt* statement, const std::string& joint, Field field) {
        std::string text;
        for (int column = 0; column < sqlite3_column_count(statement); ++column) {
            const char* content = field(statement, column);
            text += (column > 0 ? joint : "") + (content != nullptr ? content : "");
        }
        return text + '\n';
    }

    std::unique_ptr<sqlite3, decltype(&sqlite3_close)> handle_{nullptr, &sqlite3_close};
};

/// The three exports of one run, made once.
struct Exports {
    TemporaryFolder folder;
    std::string database = (folder / "catalogue.db").string();
    std::string csv = (folder / "all.csv").string();
    std::string json = (folder / "all.json").string();
    Outcome outcome =
        run(plprove_program + " export " + database + " --csv " + csv + " --json " + json);
};

const Exports& exports() {
    static const Exports made;
    return made;
}

std::string document() {
    return read_file(SOURCE_DIR "/certs/CATALOGUE.md");
}

/// The contents of the fenced blocks that begin with ```language.
std::vector<std::string> blocks(const std::string& text, const std::string& language) {
    std::vector<std::string> found;
    const std::string fence = "```" + language + "\n";
    for (std::size_t start = text.find(fence); start != std::string::npos;
         start = text.find(fence, start)) {
        start += fence.size();
        found.push_back(text.substr(start, text.find("```", start) - start));
    }
    return found;
}

/// A JSON object as the line of the CSV file.
std::string csv_line(const nlohmann::json& object) {
    std::string line;
    for (const plprove::Column& column : plprove::columns()) {
        const nlohmann::json& value = object.at(column.name);
        if (value.is_boolean()) line += value.get<bool>() ? "1" : "0";
        if (value.is_number()) line += std::to_string(value.get<int>());
        if (value.is_string()) line += value.get<std::string>();
        line += ',';
    }
    line.pop_back();
    return line;
}

} // namespace

TEST_CASE("an export is silent and makes three files and nothing else") {
    CHECK(exports().outcome.status == 0);
    CHECK(exports().outcome.out.empty());
    CHECK(exports().outcome.err.empty());
    CHECK(std::distance(std::filesystem::directory_iterator(exports().folder.path()), {}) == 3);
}

TEST_CASE("database and CSV agree in every row and column") {
    const Database database(exports().database);
    const bool same = database.ask("SELECT * FROM classes ORDER BY number", ",", true) ==
                      read_file(exports().csv);
    CHECK(same);
    CHECK(lines_of(read_file(exports().csv)).size() == 143495);
}

TEST_CASE("JSON and CSV agree in every row and column") {
    const nlohmann::json json = nlohmann::json::parse(read_file(exports().json));
    const std::vector<std::string> csv = lines_of(read_file(exports().csv));
    const nlohmann::json& classes = json.at("classes");
    REQUIRE(classes.size() + 1 == csv.size());
    std::size_t different = 0;
    for (std::size_t i = 0; i < classes.size(); ++i)
        different +=
            csv_line(classes[i]) != csv[i + 1] || classes[i].size() != plprove::columns().size();
    CHECK(different == 0);
    CHECK(json.at("about").at("columns").size() == plprove::columns().size());
}

TEST_CASE("every export is the same bytes each time, in a file or a pipe") {
    const TemporaryFolder folder;
    const auto again = folder / "again";
    CHECK(run("MALLOC_PERTURB_=85 " + plprove_program + " export " + again.string()).status == 0);
    const bool same_database = read_file(again) == read_file(exports().database);
    CHECK(same_database);
    const std::string ask = "cd " + folder.path().string() + " && " + plprove_program;
    CHECK(run(ask + " export --csv - | cmp - " + exports().csv).status == 0);
    CHECK(run(ask + " export --json - | cmp - " + exports().json).status == 0);
}

TEST_CASE("the database is sound: integrity, references, signatures feature by feature") {
    const Database database(exports().database);
    CHECK(database.ask("PRAGMA integrity_check", "", false) == "ok\n");
    CHECK(database.ask("PRAGMA foreign_key_check", "", false).empty());
    CHECK(database.ask("SELECT count(DISTINCT number), sum(multiplicity * weight) "
                       "FROM class_features JOIN features USING (feature)",
                       ",", false) == "143494," + std::to_string(11 * 143494) + "\n");
    CHECK(database.ask("SELECT count(*) FROM classes AS c WHERE points + free_lines <> "
                       "(SELECT sum(multiplicity) FROM class_features AS f "
                       "WHERE f.number = c.number)",
                       ",", false) == "0\n");
    CHECK(database.ask("SELECT count(*), sum(minimal), sum(terminal_problem IS NOT NULL) "
                       "FROM swap_classes",
                       ",", false) == "76446,74575,74575\n");
    CHECK(database.ask("SELECT count(*), sum(minimal), sum(terminal_problems) "
                       "FROM constraint_classes",
                       ",", false) == "10693,10073,74575\n");
}

TEST_CASE("every degree on file is in the database") {
    const Database database(exports().database);
    std::string expected;
    for (const std::string& line : lines_of(read_file(SOURCE_DIR "/certs/degrees.csv")))
        if (!line.empty() && line[0] != '#') expected += line + '\n';
    CHECK(database.ask("SELECT constraint_class AS number, degree FROM constraint_classes "
                       "WHERE degree IS NOT NULL ORDER BY number",
                       ",", true) == expected);
}

TEST_CASE(
    "the database describes each of its tables, views and columns, and so does the document") {
    const Database database(exports().database);
    const char* in_schema = "SELECT m.name, p.name FROM sqlite_schema AS m "
                            "JOIN pragma_table_info(m.name) AS p WHERE m.type IN ('table', 'view')";
    const char* described = "SELECT relation, column FROM description WHERE column IS NOT NULL";
    const auto difference = [&](const std::string& a, const std::string& b) {
        return database.ask(a + " EXCEPT " + b, ".", false);
    };
    CHECK(difference(in_schema, described).empty());
    CHECK(difference(described, in_schema).empty());
    const std::string text = document();
    std::string missing;
    for (const std::string& row :
         lines_of(database.ask("SELECT '| `' || column || '` | ' || meaning || ' |' "
                               "FROM description WHERE column IS NOT NULL UNION "
                               "SELECT '**`' || relation || '`**: ' || meaning FROM description "
                               "WHERE column IS NULL",
                               "", false)))
        if (text.find(row) == std::string::npos) missing += row + '\n';
    CHECK(missing == "");
}

TEST_CASE("the queries in the document have the answers that it gives") {
    const Database database(exports().database);
    const std::vector<std::string> queries = blocks(document(), "sql");
    const std::vector<std::string> answers = blocks(document(), "text");
    CHECK(queries.size() >= 5);
    REQUIRE(queries.size() == answers.size());
    for (std::size_t i = 0; i < queries.size(); ++i)
        CHECK(database.ask(queries[i], " | ", true) == answers[i]);
}

TEST_CASE("every filter of list means its condition in SQL") {
    const Database database(exports().database);
    struct Meaning {
        const char* filter;
        const char* condition;
    };
    const Meaning meanings[] = {
        {"", "1"},
        {"--minimal", "minimal"},
        {"--not-minimal", "NOT minimal"},
        {"--terminal", "terminal"},
        {"--pl0p", "pl0p"},
        {"--one-pin --terminal", "one_pin AND terminal"},
        {"--complete-visibility", "complete_visibility"},
        {"--complete-visibility --minimal", "plmp IS NOT NULL"},
        {"--five-point", "five_point"},
        {"--registration", "registration"},
        {"--trifocal", "trifocal"},
        {"--points 4", "points = 4"},
        {"--points 2..3 --lines ..2", "points BETWEEN 2 AND 3 AND lines <= 2"},
        {"--lines 7..", "lines >= 7"},
        {"--pins 0", "pins = 0"},
        {"--free-lines 2..", "free_lines >= 2"},
        {"--most-pins 3..6", "most_pins BETWEEN 3 AND 6"},
        {"--complete-views 2", "complete_views = 2"},
        {"--rank ..9", "rank <= 9"},
        {"--obstruction none", "obstruction = 'none'"},
        {"--obstruction epipolar", "excess_12 + excess_13 + excess_23 > 0"},
        {"--obstruction star", "star"},
        {"--obstruction any", "obstruction <> 'none'"},
        {"--points-in-views 5,3,5",
         "points_in_1 * points_in_2 * points_in_3 = 75 AND points_in_1 + points_in_2 + "
         "points_in_3 = 13"},
        {"--lines-in-views 0,1,2",
         "lines_in_1 * lines_in_2 * lines_in_3 = 0 AND lines_in_1 + lines_in_2 + lines_in_3 = 3 "
         "AND max(lines_in_1, lines_in_2, lines_in_3) = 2"},
        {"--contains 3*P/P/P",
         "number IN (SELECT number FROM class_features WHERE feature = 7 AND multiplicity >= 3)"},
        {"--contains -/P/P",
         "number IN (SELECT number FROM class_features WHERE feature BETWEEN 18 AND 20)"},
        {"--contained-in '3*P/P/P + 5*a/a/a'",
         "number NOT IN (SELECT number FROM class_features WHERE feature NOT IN (7, 11))"},
        {"--degree 300..", "degree >= 300"},
        {"--degree ..299", "degree <= 299"},
        {"--degree 312", "degree = 312"},
        {"--width ..10", "width <= 10"},
    };
    for (const Meaning& meaning : meanings) {
        CAPTURE(meaning.filter);
        const Outcome list = run(plprove_program + " list " + meaning.filter);
        CHECK(list.status == 0);
        CHECK(list.err.empty());
        const bool same =
            list.out == database.ask(std::string("SELECT number FROM classes WHERE ") +
                                         meaning.condition + " ORDER BY number",
                                     "", false);
        CHECK(same);
    }
}

TEST_CASE("list prints numbers, problems or the columns of the export") {
    CHECK(run(plprove_program + " list --registration --pl0p --format notation").out ==
          "3*P/P/P + 2*-/P/P\n2*P/P/P + a/a/a + 3*-/P/P\nP/P/P + 2*a/a/a + 4*-/P/P\n"
          "3*a/a/a + 5*-/P/P\n");
    CHECK(run(plprove_program + " list --format csv | cmp - " + exports().csv).status == 0);
    const Outcome chicago = run(plprove_program + " list --degree 312");
    CHECK(("\n" + chicago.out).find("\n2394\n") != std::string::npos);
    CHECK(run(plprove_program + " list --points 99").out.empty());
    CHECK(run(plprove_program + " list --format json | cmp - " + exports().json).status == 0);
    CHECK(run(plprove_program + " list --minimal --count").out == "140616\n");
    CHECK(run(plprove_program + " list --points 99 --count").out == "0\n");
    CHECK(run(plprove_program + " list --contains '3*P/P/P + 2*-/P/P' --format notation").out ==
          "3*P/P/P + 2*-/P/P\n");
}

TEST_CASE("wrong filters and exports without a file are refused as usage") {
    for (const char* arguments :
         {"list --points x", "list --points 5..2", "list --points", "list --obstruction E",
          "list --points-in-views 1,2", "list --degree exact", "list --format xml",
          "list --contains P/P", "list --contains foo", "list --count --format csv",
          "list --not-minimal --terminal", "list --minimal --not-minimal", "list nonsense",
          "export", "export a.db b.db"}) {
        CAPTURE(arguments);
        const Outcome outcome = run(plprove_program + " " + arguments);
        CHECK(outcome.status == 3);
        CHECK(outcome.out.empty());
        CHECK(!outcome.err.empty());
    }
    for (const char* command : {"list", "export"}) {
        const Outcome help = run(plprove_program + " " + command + " --help");
        CHECK(help.status == 0);
        CHECK(help.out.find("Examples:") != std::string::npos);
    }
}

TEST_CASE("a reader that leaves early ends the program quietly, with a failure") {
    const TemporaryFolder folder;
    const std::string status = (folder / "status").string();
    for (const char* trap : {"", "trap '' PIPE; "})
        for (const char* arguments : {"list", "export --csv -", "export --json -"}) {
            CAPTURE(arguments);
            const Outcome outcome = run(std::string(trap) + "{ " + plprove_program + " " +
                                        arguments + "; echo $? >" + status + "; } | head -n 1");
            CHECK(outcome.err.empty());
            CHECK(lines_of(outcome.out).size() == 1);
            CHECK(read_file(status) != "0\n");
            CHECK(!read_file(status).empty());
        }
}

TEST_CASE("an export that fails reports it and leaves the old file") {
    const TemporaryFolder folder;
    const auto path = folder / "kept.db";
    write_file(path, "old");
    const Outcome full = run_with_full_disk(plprove_program + " export " + path.string());
    CHECK(full.status == 1);
    CHECK(read_file(path) == "old");
    CHECK(std::distance(std::filesystem::directory_iterator(folder.path()), {}) == 1);
    const Outcome nowhere = run(plprove_program + " export /nowhere/at/all.db");
    CHECK(nowhere.status == 1);
    CHECK(nowhere.err.find("/nowhere/at/all.db") != std::string::npos);
}
