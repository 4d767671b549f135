// What a sweep keeps and collects, in process, with a fake engine.
#include "prover/catalogue/degrees.h"
#include "prover/cli/filter_options.h"
#include "prover/degree_sweep/classes.h"
#include "prover/degree_sweep/collect.h"
#include "prover/degree_sweep/sweep.h"
#include "prover/degree_sweep/write.h"
#include "prover/system/sha256.h"
#include "tests/fake_engine/fake_engine.h"
#include "tests/support/program.h"

#include <doctest/doctest.h>
#include <nlohmann/json.hpp>
#include <numeric>
#include <regex>

using namespace plprove;

namespace {

const SweepWatch unwatched{[](const SweepProgress&) {}, [] {}};

std::vector<std::size_t> some_classes() {
    std::vector<std::size_t> classes = minimal_constraint_classes();
    classes.resize(300);
    return classes;
}

void run_sweep(const SweepFolder& folder, const std::vector<std::size_t>& classes,
               const DegreeOptions& options, unsigned threads = 2, bool retry = false) {
    SweepPlan plan = plan_sweep(folder, classes, options, retry);
    plan.threads = threads;
    sweep(folder, plan, fake_engine::compute, unwatched);
}

std::size_t left_to_do(const SweepFolder& folder, const std::vector<std::size_t>& classes,
                       const DegreeOptions& options, bool retry = false) {
    return plan_sweep(folder, classes, options, retry).classes.size();
}

/// A class that the fake engine computes without fault, with this remainder of its degree.
std::size_t class_with(const std::function<bool(std::size_t)>& condition) {
    for (const std::size_t number : minimal_constraint_classes())
        if (condition(number)) return number;
    throw std::logic_error("no such class");
}

bool is_well(std::size_t number) {
    return !fake_engine::throws(number) && !fake_engine::falls_short(number);
}

/// What plcheck would say of degrees.plc in the folder, if it accepted these classes, and found
/// degrees exact: read back.
Checked checked(const std::filesystem::path& folder, const std::vector<std::size_t>& accepted,
                const std::vector<std::pair<std::size_t, int>>& exact = {}) {
    nlohmann::json file = {{"file", "elsewhere/degrees.plc"},
                           {"sha256", sha256(read_file(folder / "degrees.plc"))}};
    for (const std::size_t number : accepted)
        file["degrees"].push_back({{"class", number}, {"certified_at_least", 1}});
    const std::filesystem::path path = folder / "report";
    write_file(path, nlohmann::json(
                         {{"files", nlohmann::json::array({file})}, {"certified_exactly", exact}})
                         .dump());
    return Checked(path, folder);
}

} // namespace

TEST_CASE("a certificate is written as FORMAT.md has it") {
    DegreeCertificate certificate;
    certificate.number = 6722;
    certificate.evidence = {6, -9};
    const Feature bent = parse_feature("Pa/P/a");
    certificate.images = {
        {bent,
         {ViewImage{std::array{1, 2, 3}, {{4, 5, 6}}}, ViewImage{std::array{-7, 8, 9}, {}},
          ViewImage{std::nullopt, {{0, 1, -1}}}}},
        {parse_feature("-/P/P"),
         {ViewImage{}, ViewImage{std::array{1, 1, 1}, {}}, ViewImage{std::array{2, 2, 1}, {}}}}};
    certificate.solutions = {{true, 10, {1, -2, 3}}, {false, 0, {0, 5}}};
    CHECK(write_degree_file(std::span(&certificate, 1)) ==
          "plcert 2 degrees\n"
          "degree 6722 evidence complete edges 6 trace -9\n"
          "image Pa/P/a view point 1 2 3 toward 4 5 6 view point -7 8 9 view line 0 1 -1\n"
          "image -/P/P view point 1 1 1 view point 2 2 1\n"
          "real 10 1 -2 3\n"
          "pair 0 0 5\n");
    certificate.evidence.reset();
    CHECK(write_record(certificate).starts_with("degree 6722 evidence none\nimage "));
    CHECK(write_degree_file({}) == "plcert 2 degrees\n");
}

TEST_CASE("what the sweep writes conforms to the grammar, line by line") {
    const std::string integer = "(0|-?[1-9][0-9]*)";
    const std::string triple = "( " + integer + "){3}";
    const std::regex grammar("plcert 2 degrees|# run \\{.*\\}"
                             "|degree " +
                             integer + " evidence (none|complete edges " + integer +
                             " trace -[1-9][0-9]?)"
                             "|image [-Pa-z/]+( view( point" +
                             triple + "( toward" + triple + ")*|( line" + triple +
                             ")+))+|real [0-9]+( " + integer + "){11}|pair [0-9]+( " + integer +
                             "){22}");
    const DegreeOptions options{30, 3, true};
    for (const std::size_t number : {2394U, 6722U, 100005U, 142849U}) {
        if (!is_well(number)) continue;
        const std::string text =
            write(class_result(fake_engine::compute(number, options), options, 1.5));
        CHECK(text.back() == '\n');
        for (const std::string& line : lines_of(text)) {
            CAPTURE(line);
            CHECK(std::regex_match(line, grammar));
            CHECK(line.size() <= 16384);
        }
    }
}

TEST_CASE("there are 10,073 constraint classes, each named by its first member") {
    const std::vector<std::size_t> classes = minimal_constraint_classes();
    CHECK(classes.size() == 10073);
    const std::vector<ClassFilter> everything{parse_class_filter("minimal")};
    CHECK(constraint_classes_of(everything) == classes);
    const std::vector<ClassFilter> by_number{parse_class_filter("0..143493")};
    CHECK(constraint_classes_of(by_number) == classes);
}

TEST_CASE("filters choose the constraint classes that have a member which passes") {
    const auto chosen = [](std::initializer_list<const char*> texts) {
        std::vector<ClassFilter> filters;
        for (const char* text : texts)
            filters.push_back(parse_class_filter(text));
        return constraint_classes_of(filters);
    };
    CHECK(chosen({"pl0p"}).size() == 51);
    CHECK(chosen({"--pl0p"}) == chosen({"pl0p"}));
    CHECK(chosen({"complete-visibility"}).size() == 12);
    CHECK(chosen({"2394"}) == std::vector<std::size_t>{2394});
    CHECK(chosen({"#2394, 6723"}).size() == 2);
    CHECK(chosen({"2394,6723"}) == chosen({"6723", "2394"}));
    CHECK(chosen({"pl0p 6700..6800"}).size() < 51);
    CHECK(chosen({"one-pin points ..3", "--most-pins 3.."}).size() ==
          chosen({"one-pin points ..3"}).size() + chosen({"most-pins 3.."}).size());
    // Two problems of one constraint class: an exchange apart.
    const auto number_of = [](const char* problem) {
        return std::to_string(
            class_number(label_classes(), representative(*signature_of(parse_problem(problem)))));
    };
    CHECK(chosen({number_of("5*P/a/a + 4*a/P/a + 2*a/a/P").c_str()}) ==
          chosen({number_of("4*P/a/a + Pab/b/a + 4*a/P/a + 2*a/a/P").c_str()}));
    for (const char* none : {"0", "points 99", "not-minimal"}) {
        CAPTURE(none);
        CHECK_THROWS_AS(chosen({none}), std::invalid_argument);
    }
    for (const char* wrong : {"", " ", "nonsense", "--nonsense", "points", "points x", "5..2",
                              "1,,2", "-1", "pl0p=3x", "1234567"}) {
        CAPTURE(wrong);
        CHECK_THROWS_AS(parse_class_filter(wrong), std::invalid_argument);
    }
}

TEST_CASE("a result is read back as it was written") {
    const TemporaryFolder folder;
    const DegreeOptions options{20, 7, true};
    for (const std::size_t number : some_classes()) {
        if (fake_engine::throws(number)) continue;
        const ClassResult result =
            class_result(fake_engine::compute(number, options), options, 0.25);
        write_file(folder / "file", write(result));
        const auto head = read_class_result(folder / "file", false);
        const auto whole = read_class_result(folder / "file", true);
        REQUIRE(head);
        REQUIRE(whole);
        CHECK(head->record.empty());
        CHECK(whole->record == result.record);
        CHECK(write(*whole) == write(result));
        CHECK(whole->complete() == result.complete());
        CHECK(whole->certified == result.run.degree);
    }
}

TEST_CASE("a damaged result is no result") {
    const TemporaryFolder folder;
    const std::size_t number =
        class_with([](std::size_t n) { return is_well(n) && fake_engine::degree(n) > 5; });
    const std::string text = write(class_result(fake_engine::compute(number, {}), {}, 1));
    const auto reads = [&](const std::string& changed) {
        write_file(folder / "file", changed);
        return read_class_result(folder / "file", true).has_value();
    };
    CHECK(reads(text));
    const std::string rest = text.substr(text.find('\n'));
    CHECK(reads("plcert 1 degrees" + rest)); // of version 1.0
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
    CHECK(!read_class_result(folder / "nothing", true));
    // One under another class's name, or another seed's.
    const SweepFolder sweeps(folder.path(), 0);
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

TEST_CASE("a long list of notes is cut so that the line stays short") {
    DegreeRun run;
    run.number = 5;
    run.notes.assign(1000, "a note with an umlaut, \xC3\xA4, and a \"quote\"");
    const std::string line = run_line(class_result(run, {}, 0));
    CHECK(line.size() <= 16000);
    CHECK(line.size() > 15000);
    CHECK(nlohmann::json::parse(line)["notes"].size() > 100);
}

TEST_CASE("results do not depend on the number of threads") {
    const std::vector<std::size_t> classes = some_classes();
    const TemporaryFolder one, four;
    const SweepFolder by_one(one.path(), 0), by_four(four.path(), 0);
    run_sweep(by_one, classes, {30, 0, true}, 1);
    run_sweep(by_four, classes, {30, 0, true}, 4);
    const Collected collected = collect(by_one, {});
    CHECK(collected.classes > 0);
    CHECK(collect(by_four, {}).solutions == collected.solutions);
    for (const char* file : {"degrees.csv", "degrees.plc"})
        CHECK(read_file(one / file) == read_file(four / file));
}

TEST_CASE("what is on file is not computed again, unless more is asked for") {
    const std::vector<std::size_t> classes = some_classes();
    const TemporaryFolder folder;
    const SweepFolder results(folder.path(), 0);
    const auto count = [&](const auto& condition) {
        return static_cast<std::size_t>(std::ranges::count_if(classes, condition));
    };
    const std::size_t well = count(is_well);
    const auto above = [&](int degree) {
        return count([&](std::size_t n) { return is_well(n) && fake_engine::degree(n) >= degree; });
    };
    CHECK(left_to_do(results, classes, {20, 0, true}) == classes.size());
    run_sweep(results, classes, {20, 0, true});
    CHECK(left_to_do(results, classes, {20, 0, true}) == 0);
    CHECK(left_to_do(results, classes, {20, 0, true}, true) == classes.size() - well);
    CHECK(left_to_do(results, classes, {10, 0, true}) == classes.size() - well);
    CHECK(left_to_do(results, classes, {30, 0, true}) == classes.size() - well + above(20));
    CHECK(left_to_do(results, classes, {0, 0, true}) == classes.size() - well + above(20));
    CHECK(left_to_do(SweepFolder(folder.path(), 1), classes, {20, 1, true}) == classes.size());
    run_sweep(results, classes, {0, 0, false});
    CHECK(left_to_do(results, classes, {0, 0, false}) == 0);
    CHECK(left_to_do(results, classes, {30, 0, true}) == classes.size() - well + above(21));
    CHECK(left_to_do(results, classes, {20, 0, true}) == 0);
    // Neither the exact degree nor the certificate of the first sweep is lost, nor by a later one.
    run_sweep(results, classes, {25, 0, true});
    for (const std::size_t number : classes) {
        if (!is_well(number)) continue;
        const auto result = results.read(number, true);
        REQUIRE(result);
        CHECK(result->complete());
        CHECK(result->degree() == fake_engine::degree(number));
        CHECK(result->certified == std::min(fake_engine::degree(number), 25));
    }
}

TEST_CASE("a class that fails is on file with the reason, and the others are not held up") {
    const std::vector<std::size_t> classes = some_classes();
    const TemporaryFolder folder;
    const SweepFolder results(folder.path(), 0);
    run_sweep(results, classes, {});
    CHECK(results.numbers() == classes);
    const auto failing = std::ranges::find_if(classes, fake_engine::throws);
    const auto short_one = std::ranges::find_if(classes, fake_engine::falls_short);
    REQUIRE(failing != classes.end());
    REQUIRE(short_one != classes.end());
    CHECK(results.read(*failing, true)->run.notes.front().find("does not like") !=
          std::string::npos);
    CHECK(!fulfils(*results.read(*failing, true), {}));
    CHECK(!fulfils(*results.read(*short_one, true), {}));
    collect(results, {});
    const std::string csv = "\n" + read_file(folder / "degrees.csv");
    CHECK(csv.find("\n" + std::to_string(*failing) + ",") == std::string::npos);
    CHECK(csv.find("\n" + std::to_string(*short_one) + ",1,at-least,evidence,") !=
          std::string::npos);
}

TEST_CASE("the classes that are expected to be small come first") {
    const std::vector<std::size_t> classes = some_classes();
    const TemporaryFolder folder;
    const SweepFolder results(folder.path(), 0);
    run_sweep(results, classes, {0, 0, false});
    const SweepPlan plan = plan_sweep(results, classes, {0, 0, true}, false);
    CHECK(plan.classes.size() == classes.size());
    CHECK(std::ranges::is_sorted(plan.costs));
    CHECK(plan.costs.front() < plan.costs.back());
}

TEST_CASE("a contradicted completeness is none") {
    ClassResult result;
    result.run.degree = 10;
    result.run.evidence = {5, -9};
    result.certified = 10;
    CHECK(result.complete());
    result.certified = 11;
    CHECK(!result.complete());
    CHECK(result.degree() == 11);
}

TEST_CASE("a collection is read as the project's own files are, in parts and as chosen") {
    const std::vector<std::size_t> classes = some_classes();
    const TemporaryFolder folder;
    const SweepFolder results(folder.path(), 0);
    run_sweep(results, classes, {40, 0, true});
    const auto read_degrees = [&] {
        const std::string csv = read_file(folder / "degrees.csv");
        std::vector<std::string_view> lines;
        for (std::string_view rest = csv; !rest.empty();
             rest.remove_prefix(lines.back().size() + 1))
            lines.push_back(rest.substr(0, rest.find('\n')));
        return parse_degrees(lines);
    };
    const Collected all = collect(results, {});
    const std::string whole = read_file(folder / "degrees.plc");
    CHECK(all.files == std::vector<std::string>{"degrees.plc"});
    std::size_t certified = 0, previous = 0;
    std::vector<std::size_t> all_classes; // that have a certificate
    for (const std::size_t number : classes)
        if (!results.read(number, true)->record.empty()) all_classes.push_back(number);
    CHECK(std::ranges::none_of(read_degrees(), [](const DegreeRecord& record) {
        return record.status == DegreeStatus::certified;
    }));
    CHECK(collect(results, {0, {}, checked(folder.path(), all_classes)}).certificates ==
          all.certificates);
    CHECK(read_file(folder / "degrees.plc") == whole);
    for (const DegreeRecord& record : read_degrees()) {
        CHECK(record.number >= previous);
        previous = record.number;
        if (record.status == DegreeStatus::claimed) continue;
        if (record.status == DegreeStatus::certified) {
            ++certified;
            CHECK(record.bound == DegreeBound::at_least);
            CHECK(whole.find("\ndegree " + std::to_string(record.number) + " ") !=
                  std::string::npos);
        } else if (record.bound == DegreeBound::exact) {
            CHECK(record.degree == fake_engine::degree(record.number));
            CHECK(record.source == "5 edges; trace 1e-11");
        }
    }
    CHECK(certified == all.certificates);
    // Where plcheck finds lower and upper bound to meet, the degree is certified.
    const std::size_t met = all_classes.front();
    const int degree = fake_engine::degree(met);
    collect(results, {0, {}, checked(folder.path(), all_classes, {{met, degree}})});
    std::size_t exact = 0;
    for (const DegreeRecord& record : read_degrees())
        if (record.status == DegreeStatus::certified && record.bound == DegreeBound::exact) {
            ++exact;
            CHECK(record.number == met);
            CHECK(record.degree == degree);
        }
    CHECK(exact == 1);
    // In parts: the same records in the same order, no part too large.
    const std::size_t size = 40'000;
    const Collected parts = collect(results, {}, size);
    CHECK(parts.files.size() > 3);
    std::string joined = degree_file("");
    for (const std::string& file : parts.files) {
        const std::string part = read_file(folder / file);
        CHECK(part.size() <= size);
        CHECK(part.starts_with(degree_file("")));
        joined += part.substr(degree_file("").size());
    }
    CHECK(joined == whole);
    // Chosen ones; the parts of the earlier collection are gone.
    const std::size_t large =
        class_with([](std::size_t n) { return is_well(n) && fake_engine::degree(n) >= 40; });
    const Collected chosen = collect(results, {20, {large}, {}});
    CHECK(chosen.files.size() == 1);
    CHECK(!std::filesystem::exists(folder / "degrees-2.plc"));
    CHECK(chosen.certificates < all.certificates);
    CHECK(chosen.classes == all.classes);
    const std::string some = read_file(folder / "degrees.plc");
    for (const std::size_t number : classes) {
        const auto result = results.read(number, true);
        const bool expected = !result->record.empty() &&
                              ((result->complete() && result->degree() < 20) || number == large);
        CHECK((some.find("\ndegree " + std::to_string(number) + " ") != std::string::npos) ==
              expected);
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

TEST_CASE("a folder is locked once") {
    const TemporaryFolder folder;
    {
        const FolderLock lock(folder / "new");
        CHECK_THROWS_WITH_AS(FolderLock(folder / "new"), doctest::Contains("another sweep"),
                             std::runtime_error);
    }
    CHECK_NOTHROW(FolderLock(folder / "new"));
}
