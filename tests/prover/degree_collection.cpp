// What is collected from a sweep: files of the project's own kinds, which call certified what
// plcheck accepted and nothing else.
#include "prover/catalogue/degrees.h"
#include "prover/degree_sweep/collect.h"
#include "prover/degree_sweep/write.h"
#include "prover/system/sha256.h"
#include "tests/support/fake_sweep.h"
#include "tests/support/program.h"

#include <algorithm>
#include <doctest/doctest.h>
#include <nlohmann/json.hpp>

using namespace plprove;

namespace {

/// Writes what plcheck would say of degrees.plc in the folder, if it accepted these classes, and
/// found degrees exact with a classification. Returns its path.
std::filesystem::path report_on(const std::filesystem::path& folder,
                                const std::vector<std::size_t>& accepted,
                                const std::vector<std::pair<std::size_t, int>>& exact = {},
                                int status = 0) {
    const std::filesystem::path classification = folder / "classification.plc";
    write_file(classification, "plcert 2 classification\n");
    const nlohmann::json other = {{"file", classification.string()},
                                  {"kind", "classification"},
                                  {"sha256", sha256(read_file(classification))}};
    nlohmann::json file = {{"file", "elsewhere/degrees.plc"},
                           {"kind", "degrees"},
                           {"sha256", sha256(read_file(folder / "degrees.plc"))}};
    for (const std::size_t number : accepted)
        file["degrees"].push_back({{"class", number}, {"certified_at_least", 1}});
    const nlohmann::json report = {{"status", status},
                                   {"files", nlohmann::json::array({other, file})},
                                   {"certified_exactly", exact}};
    write_file(folder / "report", report.dump());
    return folder / "report";
}

/// The same, read back.
Checked checked(const std::filesystem::path& folder, const std::vector<std::size_t>& accepted,
                const std::vector<std::pair<std::size_t, int>>& exact = {}, int status = 0) {
    return Checked(report_on(folder, accepted, exact, status), folder);
}

/// What a sweep over some classes left in a folder that vanishes with the object.
struct FinishedSweep {
    std::vector<std::size_t> classes = some_classes();
    TemporaryFolder folder;
    SweepFolder results{folder.path(), 0};

    FinishedSweep() { run_sweep(results, classes, {40, 0, true}); }

    std::vector<std::size_t> with_certificate() const {
        std::vector<std::size_t> numbers;
        for (const std::size_t number : classes)
            if (!results.read(number, true)->record.empty()) numbers.push_back(number);
        return numbers;
    }
    std::string certificates() const { return read_file(folder / "degrees.plc"); }
    std::vector<DegreeRecord> degrees() const {
        const std::string csv = read_file(folder / "degrees.csv");
        const std::vector<std::string> lines = lines_of(csv);
        return parse_degrees(std::vector<std::string_view>(lines.begin(), lines.end()));
    }
    /// The classes that degrees.csv calls certified exactly.
    std::vector<std::size_t> certified_exactly() const {
        std::vector<std::size_t> numbers;
        for (const DegreeRecord& record : degrees())
            if (record.status == DegreeStatus::certified && record.bound == DegreeBound::exact)
                numbers.push_back(record.number);
        return numbers;
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
    CHECK(std::ranges::none_of(sweep.degrees(), [](const DegreeRecord& record) {
        return record.status == DegreeStatus::certified;
    }));
}

TEST_CASE("a collection that plcheck accepted is read as the project's own files are") {
    const FinishedSweep sweep;
    const Collected all = collect(sweep.results, {});
    const std::string whole = sweep.certificates();
    const Checked report = checked(sweep.folder.path(), sweep.with_certificate());
    CHECK(collect(sweep.results, {0, {}, report}).certificates == all.certificates);
    CHECK(sweep.certificates() == whole);
    std::size_t certified = 0, previous = 0;
    for (const DegreeRecord& record : sweep.degrees()) {
        CHECK(record.number >= previous);
        previous = record.number;
        if (record.status == DegreeStatus::claimed) continue;
        if (record.status == DegreeStatus::certified) {
            ++certified;
            CHECK(record.bound == DegreeBound::at_least);
            CHECK(has_record(whole, record.number));
        } else if (record.bound == DegreeBound::exact) {
            CHECK(record.degree == fake_engine::degree(record.number));
            CHECK(record.source == "5 edges; trace 1e-11");
        }
    }
    CHECK(certified == all.certificates);
}

TEST_CASE("where plcheck finds lower and upper bound to meet, the degree is certified") {
    const FinishedSweep sweep;
    collect(sweep.results, {});
    const std::vector<std::size_t> accepted = sweep.with_certificate();
    const std::size_t met = accepted.front();
    const int degree = sweep.results.read(met, true)->shown;
    collect(sweep.results, {0, {}, checked(sweep.folder.path(), accepted, {{met, degree}})});
    CHECK(sweep.certified_exactly() == std::vector<std::size_t>{met});
}

TEST_CASE(
    "a degree is certified exactly only from the certificate and the files that were checked") {
    const FinishedSweep sweep;
    collect(sweep.results, {});
    const std::filesystem::path folder = sweep.folder.path();
    std::vector<std::size_t> accepted = sweep.with_certificate();
    const std::size_t met = accepted[0], other = accepted[1];
    const int degree = sweep.results.read(met, true)->shown;
    const auto exact_after = [&](const Checked& report) {
        collect(sweep.results, {0, {}, report});
        return sweep.certified_exactly();
    };
    SUBCASE("one of which plcheck refused something certifies nothing exactly") {
        const Checked report = checked(folder, accepted, {{met, degree}}, 1);
        CHECK(report.refused_something());
        CHECK(report.accepts(*sweep.results.read(met, true)));
        CHECK(exact_after(report).empty());
    }
    SUBCASE("another number than the certificate shows is not believed") {
        CHECK(exact_after(checked(folder, accepted, {{met, degree + 1}})).empty());
    }
    SUBCASE("a class whose certificate plcheck did not accept is not believed") {
        const std::vector<std::pair<std::size_t, int>> exact{
            {met, degree}, {other, sweep.results.read(other, true)->shown}};
        accepted.erase(accepted.begin());
        CHECK(exact_after(checked(folder, accepted, exact)) == std::vector<std::size_t>{other});
    }
    SUBCASE("a certificate that was replaced since is not believed") {
        const Checked report = checked(folder, accepted, {{met, degree}});
        DegreeRun run = fake_engine::compute(met, {40, 1, true});
        sweep.results.save(class_result(std::move(run), {40, 0, true}, 1));
        CHECK(exact_after(report).empty());
    }
    SUBCASE("a classification that changed since, or is gone, is refused") {
        const std::filesystem::path report = report_on(folder, accepted, {{met, degree}});
        write_file(folder / "classification.plc", "another");
        CHECK_THROWS_WITH_AS(Checked(report, folder), doctest::Contains("is not the file"),
                             std::runtime_error);
        std::filesystem::remove(folder / "classification.plc");
        CHECK_THROWS_WITH_AS(Checked(report, folder), doctest::Contains("is not here"),
                             std::runtime_error);
    }
    SUBCASE("a report on files that could not be read is refused") {
        const std::filesystem::path report = report_on(folder, accepted, {{met, degree}}, 2);
        CHECK_THROWS_WITH_AS(Checked(report, folder), doctest::Contains("has status 2"),
                             std::runtime_error);
    }
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
    CHECK(chosen.classes == all.classes);
    const std::string some = sweep.certificates();
    for (const std::size_t number : sweep.classes) {
        const auto result = sweep.results.read(number, true);
        const bool small = result->complete() && result->degree() < 20;
        const bool expected = !result->record.empty() && (small || number == large);
        CHECK(has_record(some, number) == expected);
    }
}

TEST_CASE("nothing is certified but the very certificates that plcheck accepted") {
    const std::vector<std::size_t> classes = some_classes();
    const TemporaryFolder folder;
    const SweepFolder results(folder.path(), 0);
    run_sweep(results, classes, {40, 0, true});
    collect(results, {});
    // One is refused, and one is replaced after the check.
    std::vector<std::size_t> accepted;
    std::ranges::copy_if(classes, std::back_inserter(accepted), is_well);
    const std::size_t refused = accepted.back();
    accepted.pop_back();
    const Checked report = checked(folder.path(), accepted);
    DegreeRun other = fake_engine::compute(accepted[0], {40, 1, true});
    results.save(class_result(std::move(other), {40, 0, true}, 1));
    CHECK(report.accepts(*results.read(accepted[1], true)));
    CHECK(!report.accepts(*results.read(accepted[0], true)));
    CHECK(!report.accepts(*results.read(refused, true)));
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
