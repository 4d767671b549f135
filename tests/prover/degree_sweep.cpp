// What a sweep computes, in which order, and what it does not compute again.
#include "prover/catalogue/degrees.h"
#include "prover/cli/filter_options.h"
#include "prover/degree_sweep/collect.h"
#include "prover/problem/notation.h"
#include "prover/system/exit.h"
#include "tests/support/fake_sweep.h"
#include "tests/support/program.h"

#include <algorithm>
#include <doctest/doctest.h>

using namespace plprove;

TEST_CASE("there are 10,073 constraint classes, each named by its first member") {
    const std::vector<std::size_t> classes = numbers_of_classes();
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
            class_number(label_classes(), representative(*signature_of(parse_features(problem)))));
    };
    CHECK(chosen({number_of("5*P/a/a + 4*a/P/a + 2*a/a/P").c_str()}) ==
          chosen({number_of("4*P/a/a + Pab/b/a + 4*a/P/a + 2*a/a/P").c_str()}));
    for (const char* none : {"0", "points 99", "not-minimal"}) {
        CAPTURE(none);
        CHECK_THROWS_AS(chosen({none}), BadInput);
    }
    for (const char* wrong : {"", " ", "nonsense", "--nonsense", "points", "points x", "5..2",
                              "1,,2", "-1", "pl0p=3x", "1234567"}) {
        CAPTURE(wrong);
        CHECK_THROWS_AS(parse_class_filter(wrong), std::invalid_argument);
    }
}

TEST_CASE("results do not depend on the number of threads") {
    const std::vector<std::size_t> classes = some_classes();
    const TemporaryFolder one, four;
    const SweepFolder by_one(one.path(), all_constraint_classes(), 0);
    const SweepFolder by_four(four.path(), all_constraint_classes(), 0);
    run_sweep(by_one, classes, {30, 0}, 1);
    run_sweep(by_four, classes, {30, 0}, 4);
    const Collected collected = collect(by_one, {});
    CHECK(collected.items > 0);
    CHECK(collect(by_four, {}).solutions == collected.solutions);
    for (const char* file : {"degrees.csv", "degrees.plc"})
        CHECK(read_file(one / file) == read_file(four / file));
}

TEST_CASE("what is on file is not computed again, unless more is asked for") {
    const std::vector<std::size_t> classes = some_classes();
    const TemporaryFolder folder;
    const SweepFolder results(folder.path(), all_constraint_classes(), 0);
    const auto count = [&](const auto& condition) {
        return static_cast<std::size_t>(std::ranges::count_if(classes, condition));
    };
    const std::size_t well = count(is_well);
    const auto above = [&](int degree) {
        return count([&](std::size_t n) { return is_well(n) && fake_engine::degree(n) >= degree; });
    };
    CHECK(left_to_do(results, classes, {20, 0}) == classes.size());
    run_sweep(results, classes, {20, 0});
    CHECK(left_to_do(results, classes, {20, 0}) == 0);
    CHECK(left_to_do(results, classes, {20, 0}, true) == classes.size() - well);
    CHECK(left_to_do(results, classes, {10, 0}) == classes.size() - well);
    CHECK(left_to_do(results, classes, {30, 0}) == classes.size() - well + above(20));
    CHECK(left_to_do(results, classes, {0, 0}) == classes.size() - well + above(20));
    CHECK(left_to_do(SweepFolder(folder.path(), all_constraint_classes(), 1), classes, {20, 1}) ==
          classes.size());
    run_sweep(results, classes, {0, 0});
    CHECK(left_to_do(results, classes, {0, 0}) == 0);
    CHECK(left_to_do(results, classes, {20, 0}) == 0);
    CHECK(left_to_do(results, classes, {30, 0}) == classes.size() - well);
    // No solution of the first sweeps is lost by a later one.
    run_sweep(results, classes, {25, 0});
    for (const std::size_t number : classes) {
        if (!is_well(number)) continue;
        const auto result = results.read(number, true);
        REQUIRE(result);
        CHECK(result->run.complete);
        CHECK(result->run.degree == fake_engine::degree(number));
    }
}

TEST_CASE("a class that fails is on file with the reason, and the others are not held up") {
    const std::vector<std::size_t> classes = some_classes();
    const TemporaryFolder folder;
    const SweepFolder results(folder.path(), all_constraint_classes(), 0);
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
    const std::string degree = std::to_string(degree_on_file(*short_one).value());
    CHECK(csv.find("\n" + std::to_string(*short_one) + ',' + degree + ",1,") != std::string::npos);
}

TEST_CASE("the classes that are expected to be small come first") {
    const std::vector<std::size_t> classes = some_classes();
    const TemporaryFolder folder;
    const SweepFolder results(folder.path(), all_constraint_classes(), 0);
    const SweepPlan plan = plan_sweep(results, classes, {0, 0}, false);
    CHECK(plan.numbers.size() == classes.size());
    CHECK(std::ranges::is_sorted(plan.costs));
    CHECK(plan.costs.front() < plan.costs.back());
}

TEST_CASE("processes share out the classes: each has one owner, and none much more than its part") {
    const std::vector<std::size_t> classes = numbers_of_classes();
    for (const std::size_t processes : {1, 2, 7, 64}) {
        CAPTURE(processes);
        std::vector<std::size_t> all;
        std::vector<int> solutions;
        for (std::size_t process = 0; process < processes; ++process) {
            const std::vector<std::size_t> share =
                share_of(all_constraint_classes(), classes, process, processes);
            solutions.push_back(0);
            for (const std::size_t number : share)
                solutions.back() += degree_on_file(number).value();
            all.insert(all.end(), share.begin(), share.end());
        }
        std::ranges::sort(all);
        CHECK(all == classes);
        const auto [least, most] = std::ranges::minmax(solutions);
        CHECK(most - least <= 43224); // the largest degree
    }
}

TEST_CASE("lack of memory ends a sweep, and results are kept") {
    const std::vector<std::size_t> classes = some_classes();
    const TemporaryFolder folder;
    const SweepFolder results(folder.path(), all_constraint_classes(), 0);
    SweepPlan plan = plan_sweep(results, classes, {30, 0}, false);
    plan.threads = 2;
    const std::size_t bad = plan.numbers[40];
    const auto compute = [&](std::size_t number, const DegreeOptions& options) {
        if (number == bad) throw std::bad_alloc();
        return fake_engine::compute(number, options);
    };
    CHECK_THROWS_AS(sweep(results, plan, compute, unwatched), std::bad_alloc);
    const std::vector<std::size_t> kept = results.numbers();
    CHECK(kept.size() >= 40);
    CHECK(std::ranges::find(kept, bad) == kept.end());
    run_sweep(results, classes, {30, 0});
    CHECK(results.numbers() == classes);
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
