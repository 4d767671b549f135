// proofs/README.md, the map: each page is in it, the pages of a row need no others, their lines are
// as it says, README.md names pages of the map only, and `plcheck --version` leads there.
#include "tests/support/program.h"

#include <algorithm>
#include <doctest/doctest.h>
#include <map>
#include <regex>
#include <set>

namespace {

namespace fs = std::filesystem;
using Pages = std::set<fs::path>;

const fs::path proofs = fs::path(SOURCE_DIR) / "proofs";

/// The targets of the links of a text, relative to its folder, that end with this.
std::vector<fs::path> links(const std::string& text, const fs::path& folder,
                            const std::string& ending) {
    const std::regex link(R"(\]\(([A-Za-z0-9_./-]+)\))");
    std::vector<fs::path> found;
    for (std::sregex_iterator i(text.begin(), text.end(), link), end; i != end; ++i) {
        const std::string target = (*i)[1];
        if (target.ends_with(ending)) found.push_back((folder / target).lexically_normal());
    }
    return found;
}

/// A row of the map: its pages and programs, and how many lines it says the pages have.
struct Row {
    std::string claim;
    Pages pages;
    std::vector<fs::path> programs;
    std::size_t lines = 0;
};

std::vector<std::string> cells(const std::string& line) {
    std::vector<std::string> found;
    std::size_t start = 1;
    for (std::size_t bar = line.find('|', 1); bar != std::string::npos;
         start = bar + 1, bar = line.find('|', start))
        found.push_back(line.substr(start, bar - start));
    return found;
}

/// The pages that a row takes from another one.
const Pages& earlier_row(const std::string& cell, const std::vector<Row>& rows) {
    const std::map<std::string, std::string> named{
        {"the row of Q and T", "Theorems Q and T"},
        {"the row of fixed forms", "by fixed forms"},
        {"the row of classes", "no point with four pins"}};
    for (const auto& [words, claim] : named) {
        if (cell.find(words) == std::string::npos) continue;
        for (const Row& row : rows)
            if (row.claim.find(claim) != std::string::npos) return row.pages;
    }
    static const Pages none;
    return cell.find("the row before") == std::string::npos ? none : rows.back().pages;
}

std::vector<Row> rows_of_map() {
    std::vector<Row> rows;
    for (const std::string& line : lines_of(read_file(proofs / "README.md"))) {
        if (!line.starts_with("| ") || line.starts_with("| claim")) continue;
        const std::vector<std::string> cell = cells(line);
        REQUIRE(cell.size() == 4);
        Row row{cell[0], earlier_row(cell[1], rows), links(cell[3], proofs, ".cpp"), 0};
        for (const fs::path& page : links(cell[1], proofs, ".md"))
            row.pages.insert(page);
        row.lines = std::stoul(std::regex_replace(cell[2], std::regex("[ ,]"), ""));
        rows.push_back(row);
    }
    return rows;
}

/// The pages of a row, and those outside the rows on which no claim rests.
Pages all_pages() {
    Pages pages;
    for (const Row& row : rows_of_map())
        pages.insert(row.pages.begin(), row.pages.end());
    return pages;
}

} // namespace

TEST_CASE("each page of proofs/ is in its map, and each link of the map leads there") {
    const std::string map = read_file(proofs / "README.md");
    const std::vector<fs::path> linked = links(map, proofs, "");
    for (const fs::path& target : linked) {
        CAPTURE(target.string());
        CHECK(fs::exists(target));
    }
    for (const char* folder : {".", "three_views", "results"}) {
        for (const auto& entry : fs::directory_iterator((proofs / folder).lexically_normal())) {
            const fs::path name = entry.path().lexically_normal();
            if (name.extension() != ".md") continue;
            if (name == proofs / "README.md") continue;
            CAPTURE(name.string());
            CHECK(std::ranges::count(linked, name) >= 1);
        }
    }
}

TEST_CASE("the pages of a row of the map link no page of proofs/ that is not in the row") {
    const std::vector<Row> rows = rows_of_map();
    REQUIRE(rows.size() == 32);
    for (const Row& row : rows) {
        CAPTURE(row.claim);
        for (const fs::path& page : row.pages) {
            for (const fs::path& needed : links(read_file(page), page.parent_path(), ".md")) {
                const std::string from_root = needed.lexically_relative(proofs).string();
                if (from_root.starts_with("..") || from_root.ends_with("README.md")) continue;
                CAPTURE(page.string());
                CAPTURE(needed.string());
                CHECK(row.pages.contains(needed));
            }
        }
    }
}

TEST_CASE("the map says how many lines the pages of a row have, within one in twenty") {
    for (const Row& row : rows_of_map()) {
        std::size_t lines = 0;
        for (const fs::path& page : row.pages)
            lines += lines_of(read_file(page)).size();
        CAPTURE(row.claim);
        CAPTURE(lines);
        CHECK(20 * row.lines >= 19 * lines);
        CHECK(20 * row.lines <= 21 * lines);
    }
}

TEST_CASE("README.md names pages of the map only, and plcheck --version leads to both") {
    const Pages pages = all_pages();
    const fs::path root = fs::path(SOURCE_DIR);
    for (const std::string& line : lines_of(read_file(root / "README.md"))) {
        if (!line.starts_with("| ") || line.find("(checker/") == std::string::npos) continue;
        CAPTURE(line);
        for (const fs::path& page : links(line, root, ".md"))
            if (page.string().starts_with(proofs.string()))
                CHECK((pages.contains(page) || page == proofs / "README.md"));
    }
    CHECK(read_file(root / "README.md").find("\n## What you must trust\n") != std::string::npos);
    const std::string version = run(PLCHECK " --version").out;
    CHECK(version.find("README.md (What you must trust)") != std::string::npos);
    CHECK(version.find("proofs/README.md") != std::string::npos);
}
