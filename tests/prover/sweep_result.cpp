// What a sweep keeps of a class, as a file: written as FORMAT.md has it, and read back.
#include "prover/degree_sweep/sweep_result.h"
#include "prover/degree_sweep/family_degree.h"
#include "prover/problem/complete_visibility.h"
#include "prover/problem/notation.h"
#include "prover/three_views/degree_text.h"
#include "prover/three_views/integer_vectors.h"
#include "tests/support/fake_sweep.h"
#include "tests/support/program.h"

#include <doctest/doctest.h>
#include <nlohmann/json.hpp>
#include <regex>
#include <sstream>

using namespace plprove;

TEST_CASE("a certificate is written as FORMAT.md has it") {
    DegreeCertificate certificate;
    certificate.number = 6722;
    const Feature bent = parse_feature("Pa/P/a");
    certificate.images = {
        {bent,
         {ViewImage{IntegerVector{1, 2, 3}, {{4, 5, 6}}}, ViewImage{IntegerVector{-7, 8, 9}, {}},
          ViewImage{std::nullopt, {{0, 1, -1}}}}},
        {parse_feature("-/P/P"),
         {ViewImage{}, ViewImage{IntegerVector{1, 1, 1}, {}},
          ViewImage{IntegerVector{2, 2, 1}, {}}}}};
    certificate.solutions = {{true, 10, {1, -2, 3}}, {false, 0, {0, 5}}};
    CHECK(write_degree_file(std::span(&certificate, 1)) ==
          "plcert 2 degrees\n"
          "degree 6722 evidence none\n"
          "image Pa/P/a view point 1 2 3 toward 4 5 6 view point -7 8 9 view line 0 1 -1\n"
          "image -/P/P view point 1 1 1 view point 2 2 1\n"
          "real 10 1 -2 3\n"
          "pair 0 0 5\n");
    CHECK(write_degree_file({}) == "plcert 2 degrees\n");
}

TEST_CASE("what the sweep writes conforms to the grammar, line by line") {
    const std::string integer = "(0|-?[1-9][0-9]*)";
    const std::string triple = "( " + integer + "){3}";
    const std::regex grammar("plcert 2 degrees|# run \\{.*\\} sha256 [0-9a-f]{64}"
                             "|degree " +
                             integer +
                             " evidence none"
                             "|image [-Pa-z/]+( view( point" +
                             triple + "( toward" + triple + ")*|( line" + triple +
                             ")+))+|real [0-9]+( " + integer + "){11}|pair [0-9]+( " + integer +
                             "){22}");
    const DegreeOptions options{30, 3};
    for (const std::size_t number : {2394U, 6722U, 100005U, 142849U}) {
        if (!is_well(number)) continue;
        const std::string text =
            write(sweep_result(fake_engine::compute(number, options), options, 1.5));
        CHECK(text.back() == '\n');
        for (const std::string& line : lines_of(text)) {
            CAPTURE(line);
            CHECK(std::regex_match(line, grammar));
            CHECK(line.size() <= 16384);
        }
    }
}

TEST_CASE("a result is read back as it was written") {
    const TemporaryFolder folder;
    const DegreeOptions options{20, 7};
    for (const std::size_t number : some_classes()) {
        if (fake_engine::throws(number)) continue;
        const SweepResult result =
            sweep_result(fake_engine::compute(number, options), options, 0.25);
        write_file(folder / "file", write(result));
        const auto head = read_sweep_result(folder / "file", false);
        const auto whole = read_sweep_result(folder / "file", true);
        REQUIRE(head);
        REQUIRE(whole);
        CHECK(head->record.empty());
        CHECK(whole->record == result.record);
        CHECK(write(*whole) == write(result));
        CHECK(whole->run.complete == result.run.complete);
        CHECK(whole->run.degree == result.run.degree);
    }
}

TEST_CASE("a fibre does for approximations, but these do not for a fibre") {
    const std::size_t number = class_with(is_well);
    DegreeOptions all, fibre;
    fibre.fibre = true;
    all.degree = fibre.degree = fake_engine::degree(number);
    const SweepResult boxes = sweep_result(fake_engine::compute(number, all), all, 1);
    DegreeRun run = fake_engine::compute(number, fibre);
    run.record = "degree 4 evidence none\n";
    const SweepResult found = sweep_result(run, fibre, 1);
    CHECK(fulfils(boxes, all));
    CHECK(!fulfils(boxes, fibre));
    CHECK(!attempted(boxes, fibre));
    CHECK(fulfils(found, all));
    CHECK(fulfils(found, fibre));
    CHECK(found.record == run.record);

    DegreeRun in_vain;
    in_vain.number = number;
    const SweepResult both = merged(boxes, sweep_result(in_vain, fibre, 1));
    CHECK(both.record == boxes.record);
    CHECK(!fulfils(both, fibre));
    CHECK(attempted(both, fibre));
    CHECK(merged(boxes, found).record == found.record);

    std::istringstream file(write(merged(boxes, found)));
    const auto again = parse_sweep_result(file, true);
    REQUIRE(again);
    CHECK(fulfils(*again, fibre));
    CHECK(attempted(*again, all));
    CHECK(again->record == found.record);
}

TEST_CASE("a damaged result is no result") {
    const TemporaryFolder folder;
    const std::size_t number =
        class_with([](std::size_t n) { return is_well(n) && fake_engine::degree(n) > 5; });
    const std::string text = write(sweep_result(fake_engine::compute(number, {}), {}, 1));
    const auto reads = [&](const std::string& changed) {
        write_file(folder / "file", changed);
        return read_sweep_result(folder / "file", true).has_value();
    };
    CHECK(reads(text));
    const std::string rest = text.substr(text.find('\n'));
    CHECK(!reads("plcert 1 degrees" + rest));
    CHECK(!reads("plcert 3 degrees" + rest));
    CHECK(!reads(""));
    CHECK(!reads("plcert 2 degrees\n"));
    CHECK(!reads(text.substr(0, text.find('{') + 20)));
    const std::size_t record = text.find("\ndegree ");
    for (const std::size_t size :
         {text.size() - 1, text.rfind('\n', text.size() - 2) + 1, record + 1, record + 9})
        CHECK(!reads(text.substr(0, size)));
    CHECK(!reads(std::regex_replace(text, std::regex("\"number\":[0-9]+"), "\"number\":\"x\"")));
    CHECK(!reads(std::regex_replace(text, std::regex("\"number\":[0-9]+"), "\"number\":1")));
    CHECK(!reads(std::regex_replace(text, std::regex("\"tracks\":[0-9]+,"), "")));
    CHECK(!read_sweep_result(folder / "nothing", true));
    // One under another class's name, or another seed's.
    const SweepFolder sweeps(folder.path(), all_constraint_classes(), 0);
    std::filesystem::create_directories(sweeps.file_of(number).parent_path());
    write_file(sweeps.file_of(number), text);
    CHECK(sweeps.read(number, true));
    write_file(sweeps.file_of(number),
               std::regex_replace(text, std::regex("\"seed\":0"), "\"seed\":1"));
    CHECK(!sweeps.read(number, true));
    const std::vector<std::size_t> classes{number};
    CHECK(left_to_do(sweeps, classes, {}) == 1);
    run_sweep(sweeps, classes, {});
    CHECK(sweeps.read(number, true));
}

TEST_CASE("a result of a family is a file of solutions, and belongs to its problem alone") {
    const TemporaryFolder folder;
    const SweepSubject upright = minimal_problems_of(*family_named("upright"));
    REQUIRE(upright.items.size() == 4);
    const SweepItem& item = upright.items[0];
    CHECK(item.problem == "upright: 3*P/P");
    const SweepFolder results(folder.path(), upright, 0);
    results.save(sweep_result(compute_family_degree(item, {}), {}, 1));
    const std::string text = read_file(results.file_of(item.number));
    CHECK(text.starts_with(
        "plcert 2 solutions\n# run {\"number\":1,\"problem\":\"upright: 3*P/P\","));
    CHECK(text.find("\nproblem upright: 3*P/P\n") != std::string::npos);
    REQUIRE(results.read(item.number, true));
    CHECK(results.read(item.number, true)->run.degree == 4);

    std::istringstream as_classes("plcert 2 degrees" + text.substr(text.find('\n')));
    CHECK(!parse_sweep_result(as_classes, true));
    SweepSubject other = upright;
    other.items[0].problem = upright.items[1].problem;
    CHECK(!SweepFolder(folder.path(), other, 0).read(item.number, true));
}

TEST_CASE("a long list of notes is cut so that the line stays short") {
    DegreeRun run;
    run.number = 5;
    run.notes.assign(1000, "a note with an umlaut, \xC3\xA4, and a \"quote\"");
    const std::string line = run_line(sweep_result(run, {}, 0));
    CHECK(line.size() <= 16000);
    CHECK(line.size() > 15000);
    CHECK(nlohmann::json::parse(line)["notes"].size() > 100);
}
