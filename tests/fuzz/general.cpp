// Fuzzed: the ways to name a problem in general (notation with shared lines, PLMP's names and
// encoding), its verdict, and the certificate. What is accepted obeys the laws below, and the
// checker accepts its certificate; what is not is refused with a message.
#include "checker/replay.h"
#include "prover/minimal/problem_record.h"
#include "prover/problem/notation.h"
#include "prover/problem/spec.h"
#include "tests/fuzz/require.h"
#include "tests/support/construction.h"

#include <algorithm>
#include <stdexcept>

using namespace plprove;

namespace {

/// Files of problems in general need no classes.
const checker::Classification no_classes;

/// As `plprove certify --list` reads a line.
Problem read(std::string_view text) {
    const std::optional<Problem> named = parse_general_spec(text);
    return named ? *named : parse_problem(text);
}

void require_fit(std::string_view reason) {
    require(reason.size() < 1000, "a long message");
    require(std::ranges::all_of(reason, [](char c) { return c >= ' ' && c <= '~'; }),
            "a message unfit for a terminal");
}

/// Nothing of the problem but the numbers of its lines may change on the way through its notation.
void check_notation(const Problem& problem) {
    require(is_constructible_in_order(problem), "points in no order of construction");
    const std::string text = notation(problem);
    const Problem again = parse_problem(text);
    require(again.points == problem.points && again.views == problem.views &&
                again.cameras == problem.cameras && again.lines.size() == problem.lines.size(),
            "notation does not survive a round trip");
    require(notation(again) == text, "the same problem has two notations");
    require(dimension_in_space(again) == dimension_in_space(problem) &&
                dimension_in_views(again) == dimension_in_views(problem),
            "the numbers of the lines change the dimensions");
}

/// The checker accepts the certificate, and the verdict in it is the one that plprove prints.
void check_certificate(const Problem& problem) {
    ProblemRecord certificate;
    try {
        certificate = certify(problem);
    } catch (const std::runtime_error& error) {
        require_fit(error.what());
        require(is_balanced(problem), "no certificate though only the counts matter");
        return;
    }
    const bool minimal = is_minimal(certificate);
    require(!minimal || is_balanced(problem), "minimal, and not balanced");
    const std::string file = write(std::span(&certificate, 1));
    const checker::ReplayedFile replayed = checker::replay(no_classes, "fuzzed", file);
    const auto* content = std::get_if<checker::ProblemsFile>(&replayed.content);
    require(content != nullptr, "a certificate that does not conform");
    require(content->refusals.count == 0 && content->verdicts.size() == 1,
            "a certificate that the checker refuses");
    require(content->verdicts[0].minimal == minimal, "the checker reads another verdict");
}

/// Whether a certificate takes milliseconds.
bool is_small(const Problem& problem) {
    return problem.points.size() + problem.lines.size() <= 16 && problem.views <= 6;
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    Problem problem;
    try {
        problem = read({reinterpret_cast<const char*>(data), size});
    } catch (const NotationError& error) {
        require_fit(error.what());
        return 0;
    }
    check_notation(problem);
    if (is_small(problem)) check_certificate(problem);
    return 0;
}
