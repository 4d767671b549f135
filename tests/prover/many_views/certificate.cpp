// Certificates of degrees in general: the checker, which shares no source with the prover, finds
// the number of solutions that follows by other means.
#include "prover/many_views/certificate.h"

#include "checker/degrees/krawczyk.h"
#include "checker/replay.h"
#include "prover/many_views/integer_pictures.h"
#include "prover/problem/notation.h"
#include "tests/support/all_classes.h"

#include <doctest/doctest.h>

using namespace plprove;
using namespace plprove::many_views;

namespace {

SolutionsRecord record_of(const std::string& text, int threads = 2) {
    MonodromySettings settings;
    settings.edges = settings.edges_of_few = 5;
    settings.threads = threads;
    const MonodromyResult found = run_monodromy(parse_problem(text), 1, settings);
    return certify(found, found.solutions, 1, threads);
}

/// How many solutions the checker proves.
std::size_t proved(const SolutionsRecord& record) {
    const std::string file = write_solutions(std::span(&record, 1));
    const auto replayed = checker::replay(all_classes(), "file", file);
    const auto& content = std::get<checker::SolutionsFile>(replayed.content);
    for (const checker::Complaint& complaint : content.refusals.first)
        MESSAGE(complaint.line << ": " << complaint.reason);
    return content.counts.size() == 1 ? content.counts[0].solutions : 0;
}

} // namespace

TEST_CASE("the checker certifies degrees that are known by other means") {
    if (!checker::has_arb) return;
    // Ten essential matrices with two rotations each; a cubic (M. Chasles, 1855).
    CHECK(proved(record_of("5*P/P")) == 20);
    CHECK(proved(record_of("projective: 7*P/P")) == 3);
    // Solutions of two calibrated views with the same essential matrix come in pairs.
    CHECK(proved(record_of("3*PL/PL + 2*P/P")) == 16);
}

TEST_CASE("each solution and each pair is written once, whatever the number of threads") {
    const SolutionsRecord one = record_of("5*P/P", 1), three = record_of("5*P/P", 3);
    CHECK(one.count() == 20);
    CHECK(write_solutions(std::span(&one, 1)) == write_solutions(std::span(&three, 1)));
}

TEST_CASE("integer images have different points on each line") {
    // Some seed would give the factors 0, 1 to one of these many dependent points.
    const Problem problem = parse_problem("3*PL/PL/PL/PL + a/a/a/a");
    for (std::uint64_t seed = 1; seed <= 20; ++seed) {
        Random random(seed, 1);
        for (const std::vector<int>& view : random_integer_images(problem, problem.views, random)) {
            CHECK(view[6] != 0);
            CHECK(view[7] != 0);
        }
    }
}
