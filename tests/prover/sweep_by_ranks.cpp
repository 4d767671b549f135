// Sweeps that ranks share: here the ranks are threads, and messages wait in boxes. That the order
// is largest first, that a rank which fails ends the work of all, and that no result depends on
// ranks.
#include "tests/support/fake_ranks.h"
#include "tests/support/fake_sweep.h"
#include "tests/support/program.h"

#include <algorithm>
#include <doctest/doctest.h>

using namespace plprove;

namespace {

/// Runs a sweep by `count` ranks, with two threads each.
void sweep_by_ranks(const SweepFolder& folder, const SweepPlan& plan, int count,
                    const ComputeDegree& compute) {
    FakeRanks ranks(count);
    std::vector<std::jthread> helpers;
    for (int number = 1; number < count; ++number)
        helpers.emplace_back([&, number] {
            help_sweep(folder, plan.options, 2, ranks.rank(number), compute, [] {});
        });
    const Ranks first = ranks.rank(0);
    const EndOfWork end(first);
    sweep(folder, plan, first, compute, unwatched);
}

SweepPlan plan_of(const SweepFolder& folder, const std::vector<std::size_t>& classes) {
    SweepPlan plan = largest_first(plan_sweep(folder, classes, {30, 0, true}, false));
    plan.threads = 2;
    return plan;
}

} // namespace

TEST_CASE("results do not depend on the number of ranks") {
    const std::vector<std::size_t> classes = some_classes();
    const TemporaryFolder one, many;
    const SweepFolder by_one(one.path(), 0), by_many(many.path(), 0);
    run_sweep(by_one, classes, {30, 0, true}, 1);
    std::atomic<int> computed = 0;
    sweep_by_ranks(by_many, plan_of(by_many, classes), 4,
                   [&](std::size_t number, const DegreeOptions& options) {
                       ++computed;
                       return fake_engine::compute(number, options);
                   });
    CHECK(computed == std::ssize(classes));
    CHECK(by_many.numbers() == classes);
    for (const std::size_t number : classes) {
        const auto expected = by_one.read(number, true), result = by_many.read(number, true);
        CHECK(result->record == expected->record);
        CHECK(result->run.degree == expected->run.degree);
        CHECK(result->run.notes == expected->run.notes);
    }
}

TEST_CASE("a rank without work to give ends the others") {
    const TemporaryFolder folder;
    const SweepFolder results(folder.path(), 0);
    sweep_by_ranks(results, plan_of(results, {}), 3, fake_engine::compute);
    CHECK(results.numbers().empty());
}

TEST_CASE("a rank that fails ends the work of all, with its reason, and results are kept") {
    const std::vector<std::size_t> classes = some_classes();
    const TemporaryFolder folder;
    const SweepFolder results(folder.path(), 0);
    const SweepPlan plan = plan_of(results, classes);
    const std::size_t bad = plan.classes[40];
    const auto compute = [&](std::size_t number, const DegreeOptions& options) {
        if (number == bad) throw std::bad_alloc();
        return fake_engine::compute(number, options);
    };
    CHECK_THROWS_WITH(sweep_by_ranks(results, plan, 3, compute), doctest::Contains("bad_alloc"));
    const std::vector<std::size_t> kept = results.numbers();
    CHECK(kept.size() >= 1);
    CHECK(std::ranges::find(kept, bad) == kept.end());
    sweep_by_ranks(results, plan_of(results, classes), 3, fake_engine::compute);
    CHECK(results.numbers() == classes);
}

TEST_CASE("ranks that see another folder are told to share one") {
    const TemporaryFolder folder;
    const SweepFolder results(folder.path(), 0), elsewhere(folder / "elsewhere", 0);
    SweepPlan plan = plan_of(results, some_classes());
    plan.threads = 0; // all classes go to the other rank
    FakeRanks ranks(2);
    std::jthread helper([&] {
        help_sweep(elsewhere, plan.options, 1, ranks.rank(1), fake_engine::compute, [] {});
    });
    const Ranks first = ranks.rank(0);
    const EndOfWork end(first);
    CHECK_THROWS_WITH(sweep(results, plan, first, fake_engine::compute, unwatched),
                      doctest::Contains("name a folder that all machines share"));
}

TEST_CASE("largest first is the opposite order, with the classes of unknown size at its head") {
    const std::vector<std::size_t> classes = some_classes();
    const TemporaryFolder folder;
    const SweepFolder results(folder.path(), 0);
    run_sweep(results, classes, {0, 0, false});
    SweepPlan plan = plan_sweep(results, classes, {0, 0, true}, false);
    const SweepPlan reversed = largest_first(plan);
    CHECK(std::ranges::is_sorted(reversed.costs, std::greater<>()));
    CHECK(reversed.costs.front() > reversed.costs.back());
    std::ranges::reverse(plan.classes);
    CHECK(reversed.classes == plan.classes);
    CHECK(reversed.on_file == plan.on_file);
}

TEST_CASE("a queue gives out each class once, and counts what is on file") {
    SweepPlan plan;
    plan.classes = {7, 3, 5};
    plan.costs = {5, 3, 2};
    ClassQueue queue(plan);
    CHECK(queue.next() == 7);
    CHECK(queue.next() == 3);
    CHECK_THROWS_WITH_AS(queue.done(5), "class 5 was not given out", std::logic_error);
    queue.done(3);
    CHECK(queue.unfinished() == 2);
    CHECK(queue.progress().share == doctest::Approx(0.3));
    CHECK(queue.next() == 5);
    CHECK(!queue.next());
    queue.done(7);
    queue.done(5);
    CHECK_THROWS_AS(queue.done(5), std::logic_error);
    CHECK(queue.unfinished() == 0);
    CHECK(queue.progress().done == 3);
    CHECK(queue.progress().share == doctest::Approx(1));
}
