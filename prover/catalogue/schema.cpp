#include "prover/catalogue/schema.h"

#include "prover/catalogue/columns.h"
#include "prover/catalogue/paper_counts.h"

#include <vector>

namespace plprove {

namespace {

using Member = Relation::Member;

const char* type_of(const Column& column) {
    const bool is_text = column.kind == ColumnKind::text;
    if (std::string_view(column.name) == "number") return "INTEGER PRIMARY KEY";
    if (column.optional) return is_text ? "TEXT" : "INTEGER";
    return is_text ? "TEXT NOT NULL" : "INTEGER NOT NULL";
}

std::vector<Member> class_members() {
    std::vector<Member> members;
    for (const Column& column : columns())
        members.push_back({column.name, type_of(column), column.meaning});
    return members;
}

constexpr Member feature_members[] = {
    {"feature", "INTEGER PRIMARY KEY", "the authors' index, 0 to 26"},
    {"notation", "TEXT NOT NULL", "what views 1, 2, 3 see"},
    {"terminal_form", "TEXT NOT NULL", "what they see of it in a terminal problem"},
    {"points", "INTEGER NOT NULL", "1, or 0 for the free line"},
    {"pins", "INTEGER NOT NULL", "lines through the point"},
    {"dimension_in_space", "INTEGER NOT NULL", "degrees of freedom in space"},
    {"dimension_in_images", "INTEGER NOT NULL", "degrees of freedom in the three images"},
    {"weight", "INTEGER NOT NULL", "their difference: constraints on the cameras, 11 in a problem"},
};

constexpr Member class_feature_members[] = {
    {"number", "INTEGER NOT NULL REFERENCES classes", "the number of a class"},
    {"feature", "INTEGER NOT NULL REFERENCES features", "a feature of its representative"},
    {"multiplicity", "INTEGER NOT NULL", "how often, at least 1"},
};

constexpr Member about_members[] = {
    {"topic", "TEXT NOT NULL", "what the remark is about"},
    {"remark", "TEXT NOT NULL", "what holds for the catalogue as a whole"},
};

constexpr Member description_members[] = {
    {"relation", "TEXT NOT NULL", "a table or view"},
    {"column", "TEXT", "one of its columns, or NULL for the whole"},
    {"meaning", "TEXT NOT NULL", "what it holds"},
};

constexpr Member swap_members[] = {
    {"swap_class", "", "the smallest number in the class, which represents it"},
    {"classes", "", "how many label classes it has"},
    {"minimal", "", "whether they are minimal"},
    {"terminal_problem", "", "the terminal problem that they become, NULL if not minimal"},
    {"constraint_class", "", "the constraint class that they belong to"},
};

constexpr Member constraint_members[] = {
    {"constraint_class", "", "the smallest number in the class, which represents it"},
    {"classes", "", "how many label classes it has"},
    {"terminal_problems", "", "how many terminal problems share its camera equations"},
    {"minimal", "", "whether its classes are minimal"},
    {"degree", "", "the degree of its classes, NULL if not minimal"},
};

constexpr Member count_members[] = {
    {"quantity", "", "what is counted"},
    {"paper", "", "the paper's number"},
    {"catalogue", "", "the number of rows of this catalogue"},
};

constexpr const char* swap_query = R"(
SELECT c.number, m.classes, c.minimal, c.terminal_problem, c.constraint_class
FROM (SELECT swap_class, count(*) AS classes FROM classes GROUP BY swap_class) AS m
JOIN classes AS c ON c.number = m.swap_class)";

constexpr const char* constraint_query = R"(
SELECT c.number, m.classes, m.terminal_problems, c.minimal, c.degree
FROM (SELECT constraint_class, count(*) AS classes, sum(terminal) AS terminal_problems
      FROM classes GROUP BY constraint_class) AS m
JOIN classes AS c ON c.number = m.constraint_class)";

constexpr const char* sums = R"(
WITH sums AS (
    SELECT count(*) AS classes, sum(minimal) AS minimal, sum(number = swap_class) AS swap_classes,
           sum(terminal) AS terminal, sum(minimal AND pl0p) AS pl0p,
           sum(terminal AND one_pin) AS one_pin, sum(five_point) AS five_point,
           sum(registration) AS registration, sum(terminal AND five_point) AS terminal_five_point,
           sum(terminal AND trifocal) AS trifocal, count(plmp) AS plmp
    FROM classes)
)";

/// A row for each count: its name, the paper's number, and that of the catalogue.
std::string make_count_query() {
    std::string rows;
    for (const PaperCount& count : paper_counts) {
        if (!rows.empty()) rows += "\nUNION ALL ";
        rows += std::string("SELECT '") + count.quantity + "', " + std::to_string(count.claimed) +
                ", " + count.rows + " FROM sums";
    }
    return sums + rows;
}

constexpr const char* index_list[] = {
    "CREATE INDEX by_swap_class ON classes(swap_class)",
    "CREATE INDEX by_constraint_class ON classes(constraint_class, terminal)",
    "CREATE INDEX by_points_and_lines ON classes(points, lines)",
    "CREATE INDEX by_degree ON classes(degree) WHERE degree IS NOT NULL",
};

/// A name of a column in SQL, where `group` is a word of the language.
std::string quoted(const char* name) {
    return '"' + std::string(name) + '"';
}

} // namespace

std::span<const Relation> tables() {
    static const std::vector<Member> members = class_members();
    static const Relation list[] = {
        {"classes", "every label class of balanced problems, one a row", members, ""},
        {"features", "the 27 local features", feature_members, ""},
        {"class_features", "the signatures, feature by feature", class_feature_members,
         "PRIMARY KEY (number, feature)"},
        {"about", "what holds for the catalogue as a whole", about_members, ""},
        {"description", "the meaning of every table, view and column", description_members, ""},
    };
    return list;
}

std::span<const Relation> views() {
    static const std::vector<Member> members = [] {
        std::vector<Member> list = class_members();
        for (Member& member : list)
            member.type = "";
        return list;
    }();
    static const std::string count_query = make_count_query();
    static const Relation list[] = {
        {"minimal_problems", "the minimal classes, with all columns of classes", members,
         "SELECT * FROM classes WHERE minimal"},
        {"terminal_problems",
         "the classes that stand for the terminal problems, with all columns of classes", members,
         "SELECT * FROM classes WHERE terminal"},
        {"swap_classes", "the swap&label classes", swap_members, swap_query},
        {"constraint_classes", "the classes of problems with the same camera equations",
         constraint_members, constraint_query},
        {"counts", "the counts of the paper beside those of this catalogue", count_members,
         count_query.c_str()},
    };
    return list;
}

std::string create_table(const Relation& table) {
    const bool keyed = *table.rest != '\0';
    std::string sql = "CREATE TABLE " + std::string(table.name) + " ( -- " + table.meaning + "\n";
    for (std::size_t i = 0; i < table.members.size(); ++i) {
        const Member& member = table.members[i];
        const bool last = !keyed && i + 1 == table.members.size();
        sql += "    " + quoted(member.name) + " " + member.type + (last ? "" : ",") + " -- " +
               member.meaning + "\n";
    }
    if (keyed) sql += std::string("    ") + table.rest + "\n";
    return sql + (keyed ? ") WITHOUT ROWID" : ")");
}

std::string create_view(const Relation& view) {
    std::string names;
    for (const Member& member : view.members)
        names += (names.empty() ? "" : ", ") + quoted(member.name);
    return "CREATE VIEW " + std::string(view.name) + "(" + names + ") AS -- " + view.meaning +
           "\n" + view.rest;
}

std::span<const char* const> indexes() {
    return index_list;
}

} // namespace plprove
