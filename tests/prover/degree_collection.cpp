// What is collected from a sweep: files of the project's own kinds, which call certified what
// plcheck accepted and nothing else.
#include "prover/catalogue/degrees.h"
#include "prover/degree_sweep/collect.h"
#include "prover/system/sha256.h"
#include "prover/three_views/degree_text.h"
#include "tests/support/fake_sweep.h"
#include "tests/support/program.h"

#include <algorithm>
#include <doctest/doctest.h>
#include <nlohmann/json.hpp>
#include <sstream>

using namespace plprove;

namespace {

/// How many solutions the double of plcheck certifies of a class.
int certified_of(std::size_t number) {
    return 1 + static_cast<int>(number % 5);
}

/// Writes what plcheck would say of degrees.plc in the folder, if it accepted these classes.
/// Returns its path.
std::filesystem::path report_on(const std::filesystem::path& folder,
                                const std::vector<std::size_t>& accepted, int status = 0) {
    nlohmann::json file = {{"file", "elsewhere/degrees.plc"},
                           {"kind", "degrees"},
                           {"sha256", sha256(read_file(folder / "degrees.plc"))}};
    for (const std::size_t number : accepted)
        file["degrees"].push_back(
            {{"class", number}, {"certified_at_least", certified_of(number)}});
    const nlohmann::json report = {{"status", status}, {"files", nlohmann::json::array({file})}};
    write_file(folder / "report", report.dump());
    return folder / "report";
}

/// The same, read back.
Checked checked(const std::filesystem::path& folder, const std::vector<std::size_t>& accepted,
                int status = 0) {
    return Checked(report_on(folder, accepted, status), folder);
}

/// A line of degrees.csv.
struct Row {
    std::size_t number = 0;
    int degree = 0, found = 0, certified = 0;
};

/// What a sweep over some classes left in a folder that vanishes with the object.
struct FinishedSweep {
    std::vector<std::size_t> classes = some_classes();
    TemporaryFolder folder;
    SweepFolder results{folder.path(), all_constraint_classes(), 0};

    FinishedSweep() { run_sweep(results, classes, {40, 0}); }

    std::vector<std::size_t> with_certificate() const {
        std::vector<std::size_t> numbers;
        for (const std::size_t number : classes)
            if (!results.read(number, true)->record.empty()) numbers.push_back(number);
        return numbers;
    }
    std::string certificates() const { return read_file(folder / "degrees.plc"); }
    std::vector<Row> rows() const {
        std::vector<Row> rows;
        for (const std::string& line : lines_of(read_file(folder / "degrees.csv"))) {
            Row row;
            std::istringstream text(line);
            char comma = 0;
            if (text >> row.number >> comma >> row.degree >> comma >> row.found >> comma >>
                row.certified)
                rows.push_back(row);
        }
        return rows;
    }
};

bool has_record(const std::string& file, std::size_t number) {
    return file.find("\ndegree " + std::to_string(number) + " ") != std::string::npos;
}

} // namespace

TEST_CASE("a collection calls nothing certified that plcheck has not seen") {
    const FinishedSweep sweep;
    const Collected collected = collect(sweep.results, {});
    CHECK(collected.files == std::vector<std::string>{"degrees.plc"});
    CHECK(collected.certificates == sweep.with_certificate().size());
    CHECK(sweep.rows().size() == collected.items);
    for (const Row& row : sweep.rows()) {
        CHECK(row.certified == 0);
        CHECK(row.degree == degree_on_file(row.number));
        CHECK(row.found == sweep.results.read(row.number, true)->run.degree);
    }
}

TEST_CASE("a collection that plcheck accepted is read as the project's own files are") {
    const FinishedSweep sweep;
    const Collected all = collect(sweep.results, {});
    const std::string whole = sweep.certificates();
    const Checked report = checked(sweep.folder.path(), sweep.with_certificate());
    CHECK(collect(sweep.results, {0, {}, report}).certificates == all.certificates);
    CHECK(sweep.certificates() == whole);
    const std::vector<Row> rows = sweep.rows();
    CHECK(std::ranges::is_sorted(rows, {}, &Row::number));
    for (const Row& row : rows) // what plcheck certified, whatever the run found
        CHECK(row.certified == (has_record(whole, row.number) ? certified_of(row.number) : 0));
}

TEST_CASE("a report in which plcheck refused something certifies what it accepted") {
    const FinishedSweep sweep;
    collect(sweep.results, {});
    std::vector<std::size_t> accepted = sweep.with_certificate();
    const std::size_t refused = accepted.front();
    accepted.erase(accepted.begin());
    const Checked report = checked(sweep.folder.path(), accepted, 1);
    CHECK(report.refused_something());
    collect(sweep.results, {0, {}, report});
    for (const Row& row : sweep.rows())
        CHECK((row.certified > 0) == (std::ranges::count(accepted, row.number) == 1));
    CHECK(std::ranges::count(sweep.rows(), refused, &Row::number) == 1);
}

TEST_CASE("a report on files that could not be read is refused") {
    const FinishedSweep sweep;
    collect(sweep.results, {});
    const std::filesystem::path report =
        report_on(sweep.folder.path(), sweep.with_certificate(), 2);
    CHECK_THROWS_WITH_AS(Checked(report, sweep.folder.path()), doctest::Contains("has status 2"),
                         std::runtime_error);
}

TEST_CASE("the parts of a collection have the same records in the same order, none too large") {
    const FinishedSweep sweep;
    collect(sweep.results, {});
    const std::string whole = sweep.certificates();
    const std::size_t size = 40'000;
    const Collected parts = collect(sweep.results, {}, size);
    CHECK(parts.files.size() > 3);
    const std::string head = degree_file("");
    std::string joined = head;
    for (const std::string& file : parts.files) {
        const std::string part = read_file(sweep.folder / file);
        CHECK(part.size() <= size);
        CHECK(part.starts_with(head));
        joined += part.substr(head.size());
    }
    CHECK(joined == whole);
}

TEST_CASE("a collection has the certificates that were chosen, and replaces an earlier one") {
    const FinishedSweep sweep;
    const Collected all = collect(sweep.results, {}, 40'000);
    CHECK(std::filesystem::exists(sweep.folder / "degrees-2.plc"));
    const std::size_t large =
        class_with([](std::size_t n) { return is_well(n) && fake_engine::degree(n) >= 40; });
    const Collected chosen = collect(sweep.results, {20, {large}, {}});
    CHECK(chosen.files.size() == 1);
    CHECK(!std::filesystem::exists(sweep.folder / "degrees-2.plc"));
    CHECK(chosen.certificates < all.certificates);
    CHECK(chosen.items == all.items);
    const std::string some = sweep.certificates();
    for (const std::size_t number : sweep.classes) {
        const auto result = sweep.results.read(number, true);
        const bool small = result->run.complete && result->run.degree < 20;
        const bool expected = !result->record.empty() && (small || number == large);
        CHECK(has_record(some, number) == expected);
    }
}

TEST_CASE("nothing is certified but the very certificates that plcheck accepted") {
    const std::vector<std::size_t> classes = some_classes();
    const TemporaryFolder folder;
    const SweepFolder results(folder.path(), all_constraint_classes(), 0);
    run_sweep(results, classes, {40, 0});
    collect(results, {});
    // One is refused, and one is replaced after the check.
    std::vector<std::size_t> accepted;
    std::ranges::copy_if(classes, std::back_inserter(accepted), is_well);
    const std::size_t refused = accepted.back();
    accepted.pop_back();
    const Checked report = checked(folder.path(), accepted);
    DegreeRun other = fake_engine::compute(accepted[0], {40, 1});
    results.save(sweep_result(std::move(other), {40, 0}, 1));
    const auto certified = [&](std::size_t number) {
        return report.certified(*results.read(number, true));
    };
    CHECK(certified(accepted[1]) == certified_of(accepted[1]));
    CHECK(certified(accepted[0]) == 0);
    CHECK(certified(refused) == 0);
    CHECK(collect(results, {0, {}, report}).certificates == accepted.size() - 1);
    // The file is another one now, and the report stale.
    CHECK_THROWS_WITH_AS(Checked(folder / "report", folder.path()),
                         doctest::Contains("is not the file"), std::runtime_error);
    for (const char* text : {"", "{", "{}", "{\"files\": 3}", "{\"files\": [{}]}"}) {
        write_file(folder / "report", text);
        CHECK_THROWS_WITH_AS(Checked(folder / "report", folder.path()),
                             doctest::Contains("no report"), std::runtime_error);
    }
    CHECK_THROWS_WITH_AS(Checked(folder / "nothing", folder.path()),
                         doctest::Contains("cannot read"), std::runtime_error);
}
