// What stands in the folder of a sweep beside the files of its classes, and what has been damaged
// in them: nothing of it is collected, or collected twice, and --retry mends it.
#include "prover/degree_sweep/collect.h"
#include "prover/system/exit.h"
#include "prover/system/sha256.h"
#include "tests/support/fake_sweep.h"
#include "tests/support/program.h"

#include <algorithm>
#include <doctest/doctest.h>
#include <regex>
#include <sys/stat.h>

using namespace plprove;

namespace {

namespace fs = std::filesystem;

/// A sweep over a few classes to the end, and one of them to damage.
struct SmallSweep {
    TemporaryFolder folder;
    SweepFolder results{folder.path(), all_constraint_classes(), 0};
    std::vector<std::size_t> classes;
    std::size_t number = 0;
    std::string text; ///< of the file of that class
    std::string certificates, degrees;

    SmallSweep() {
        for (const std::size_t one : some_classes())
            if (is_well(one) && fake_engine::degree(one) > 5) classes.push_back(one);
        classes.resize(20);
        number = classes[7];
        run_sweep(results, classes, {0, 0});
        CHECK(collect(results, {}).damaged.empty());
        text = read_file(path());
        certificates = read_file(folder / "degrees.plc");
        degrees = read_file(folder / "degrees.csv");
    }

    fs::path path() const { return results.file_of(number); }

    /// A collection leaves the class out and names it; --retry makes all as it was.
    void check_damaged() {
        const Collected collected = collect(results, {});
        CHECK(collected.damaged == std::vector{number});
        CHECK(collected.certificates == classes.size() - 1);
        CHECK(read_file(folder / "degrees.plc").find("\ndegree " + std::to_string(number) + " ") ==
              std::string::npos);
        CHECK(
            ("\n" + read_file(folder / "degrees.csv")).find("\n" + std::to_string(number) + ",") ==
            std::string::npos);
        run_sweep(results, classes, {0, 0}, 2, true);
        check_as_it_was();
    }

    void check_as_it_was() const {
        CHECK(collect(results, {}).damaged.empty());
        CHECK(read_file(folder / "degrees.plc") == certificates);
        CHECK(read_file(folder / "degrees.csv") == degrees);
    }

    /// The file with the first match replaced.
    std::string changed(const std::string& pattern, const std::string& by) const {
        std::string result = std::regex_replace(text, std::regex(pattern), by,
                                                std::regex_constants::format_first_only);
        REQUIRE(result != text);
        return result;
    }

    /// Replaces the first match in the file, and keeps the digest of the run line right.
    void replace(const std::string& pattern, const std::string& by) const {
        write_file(path(), with_digest(changed(pattern, by)));
    }

    static std::string with_digest(const std::string& file) {
        const std::string mark = "\n# run ", digest_mark = " sha256 ";
        const std::size_t start = file.find(mark) + mark.size();
        const std::size_t end = file.find(digest_mark, start);
        const std::size_t digest = end + digest_mark.size();
        return file.substr(0, digest) + sha256(file.substr(start, end - start)) +
               file.substr(file.find('\n', digest));
    }
};

} // namespace

TEST_CASE("copies of a class's file under other names or in other folders are no results") {
    const SmallSweep sweep;
    const fs::path folder = sweep.path().parent_path();
    const std::string name = sweep.path().filename().string();
    fs::copy_file(sweep.path(), folder / ("0" + name));
    fs::create_directories(folder / "copy");
    fs::copy_file(sweep.path(), folder / "copy" / name);
    fs::copy_file(sweep.path(), folder.parent_path() / name);
    fs::copy(folder, folder.parent_path() / "old");
    CHECK(sweep.results.numbers() == sweep.classes);
    sweep.check_as_it_was();
}

TEST_CASE("a number of a run line that nothing else repeats is guarded by the line's digest") {
    const SmallSweep sweep;
    const std::string degree = std::to_string(fake_engine::degree(sweep.number));
    const std::pair<std::string, std::string> changes[] = {
        {"\"degree\":" + degree, "\"degree\":" + degree + "0"},
        {"\"tracks\":", "\"tracks\":1"},
        {" sha256 [0-9a-f]", " sha256 x"},
        {" sha256 [0-9a-f]*", " sha256 "},
        {" sha256 ", " "}};
    for (const auto& [pattern, by] : changes) {
        CAPTURE(by);
        write_file(sweep.path(), sweep.changed(pattern, by));
        CHECK(!sweep.results.read(sweep.number, false));
        CHECK(collect(sweep.results, {}).damaged == std::vector{sweep.number});
        run_sweep(sweep.results, sweep.classes, {0, 0});
        sweep.check_as_it_was();
    }
}

TEST_CASE("a file of version 1.6 is named and left out, and --retry computes its class again") {
    SmallSweep sweep;
    sweep.replace("\"record\":\"[0-9a-f]*\"",
                  "\"certificate\":5,\"edges\":5,\"trace_exponent\":-11");
    sweep.check_damaged();
}

TEST_CASE("numbers that no run can have are damage, which any sweep mends") {
    const SmallSweep sweep;
    const std::pair<std::string, std::string> changes[] = {
        {"\"complete\":true", "\"complete\":1"}, {"\"degree\":", "\"degree\":-"},
        {"\"degree\":", "\"degree\":1e3"},       {"\"degree\":", "\"degree\":99999999"},
        {"\"tracks\":", "\"tracks\":-1"},        {"\"failed\":", "\"failed\":-1"},
        {"\"seconds\":", "\"seconds\":-1"},      {"\"seed\":0", "\"seed\":-1"},
        {"\"target\":0", "\"target\":-1"},       {"\"seed\":0", "\"seed\":18446744073709551616"}};
    for (const auto& [pattern, by] : changes) {
        CAPTURE(by);
        sweep.replace(pattern, by);
        CHECK(!sweep.results.read(sweep.number, false));
        run_sweep(sweep.results, sweep.classes, {0, 0});
        sweep.check_as_it_was();
    }
}

TEST_CASE("a record with a garbled line is left out of a collection, named, and mended") {
    SmallSweep sweep;
    const std::pair<std::string, std::string> changes[] = {
        {"\nimage ", "\nimags "},
        {"\nimage ", "\nimage  "},
        {"\nimage [^ ]*", "\nimage Pabc/P/P"},
        {" view ", " vi\xC3\xABw "},
        {" point ", " point x"},
        {" point ([-0-9]+) ", " point 0$1 "},
        {" point ([-0-9]+) ", " point "},
        {" point ", " point 1000000000000000000"},
        {"\nimage [^\n]*", ""},
        {"\n(real|pair) ", "\n$1 -"},
        {"\n(real|pair) ", "\n$1 9"},
        {"\n(real|pair) ", "\n"},
        {"\n(real|pair) ([^\n]*)", "\n$1 $2 "},
        {"\nimage ", "\n# image "},
        {"\n(real|pair) ([^\n]*)", "\n$1 $2 7"},
        {" evidence none", " evidence None"}};
    for (const auto& [pattern, by] : changes) {
        CAPTURE(pattern);
        CAPTURE(by);
        sweep.replace(pattern, by);
        sweep.check_damaged();
    }
}

TEST_CASE("a pipe or a folder in the place of a file is named, and nothing hangs") {
    const SmallSweep sweep;
    fs::remove(sweep.path());
    SUBCASE("pipe") {
        REQUIRE(::mkfifo(sweep.path().c_str(), 0600) == 0);
    }
    SUBCASE("folder") {
        fs::create_directory(sweep.path());
    }
    CHECK(!sweep.results.read(sweep.number, true));
    CHECK(collect(sweep.results, {}).damaged == std::vector{sweep.number});
    CHECK_THROWS_WITH_AS(left_to_do(sweep.results, sweep.classes, {0, 0}),
                         doctest::Contains("is no regular file: remove it"), BadInput);
    fs::remove(sweep.path());
    run_sweep(sweep.results, sweep.classes, {0, 0});
    sweep.check_as_it_was();
}
