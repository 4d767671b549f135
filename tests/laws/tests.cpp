// Wrong degrees, planted in the committed table, and found by the laws.
#include "checker/minimal/obstruction.h"
#include "tests/laws/hodge.h"
#include "tests/laws/ranks.h"
#include "tests/laws/verdict.h"

#include <algorithm>
#include <doctest/doctest.h>
#include <fstream>
#include <map>
#include <set>
#include <sstream>

using namespace laws;

namespace {

const std::string committed = CERTS_DIR "/degrees.csv";

const DegreeForm& committed_form() {
    static const DegreeForm form(read_exact_degrees(committed));
    return form;
}

/// The committed table with another degree for a class.
DegreeForm with_degree(std::size_t number, std::int64_t degree) {
    DegreeForm form = committed_form();
    form.set_degree(*form.class_with(number), degree);
    return form;
}

} // namespace

TEST_CASE("there are as many products of each weight as multisets of the 21 letters") {
    const std::array<std::size_t, 6> expected{1, 6, 25, 84, 245, 643};
    for (unsigned k = 0; k < expected.size(); ++k)
        CHECK(products(k).size() == expected[k]);
    CHECK(committed_form().classes().size() == 10073);
}

TEST_CASE("one wrong degree is named, with the right one") {
    // 8480 stood in the file once: it counted 3,016 spurious zeros.
    const DegreeForm form = with_degree(52234, 8480);
    const Verdict verdict = check(form);
    CHECK_FALSE(verdict.hold);
    CHECK(verdict.suspects == std::vector<std::size_t>{52234});
    CHECK(std::ranges::any_of(verdict.report, [](const std::string& line) {
        return line.starts_with("suspect: class 52234, ") &&
               line.ends_with("all relations hold with 5464 instead");
    }));
}

TEST_CASE("any wrong degree of a class that a relation contains is named") {
    const std::vector<Equation> all = equations(all_relations(), committed_form());
    CHECK(failures(all, committed_form()).empty());
    const std::vector<ClassDegree>& classes = committed_form().classes();
    const std::vector<bool> guarded = guarded_by_equations(all, classes.size());
    constexpr std::size_t step = 997;
    for (std::size_t index = 500; index < classes.size(); index += step) {
        CAPTURE(classes[index].number);
        REQUIRE(guarded[index]);
        const DegreeForm form = with_degree(classes[index].number, classes[index].degree + 8);
        const std::vector<Suspect> suspects = single_mistakes(all, failures(all, form), form);
        CHECK(std::ranges::any_of(suspects, [&](const Suspect& one) {
            return one.constraint_class == index && one.should_be == classes[index].degree;
        }));
        // Where several are named, no relation contains one of them without the others.
        CHECK(suspects.size() <= 6);
    }
}

TEST_CASE("two wrong degrees are no single mistake, and in most of the relations that fail") {
    const std::vector<Equation> all = equations(all_relations(), committed_form());
    DegreeForm form = with_degree(52234, 8480);
    const std::size_t first = *form.class_with(52234), second = *form.class_with(142849);
    form.set_degree(second, 8);
    const std::vector<std::size_t> failed = failures(all, form);
    CHECK(single_mistakes(all, failed, form).empty());
    const std::vector<std::size_t> named = classes_in_most(all, failed, 10);
    CHECK(std::ranges::count(named, first) + std::ranges::count(named, second) >= 1);
}

TEST_CASE("a wrong degree that no relation contains raises a rank") {
    constexpr std::size_t number = 811; // Pab/Pab/Pab + 2*P/P/P
    const DegreeForm form = with_degree(number, 232);
    const std::vector<Equation> all = equations(all_relations(), form);
    CHECK(failures(all, form).empty());
    const DegreeMatrix matrix(5, form);
    const std::size_t index = *form.class_with(number);
    CHECK(matrix.rank(form, primes[0]) > expected_ranks[5]);
    CHECK(matrix.rank_without(index, form) == expected_ranks[5]);
    CHECK(matrix.guards(index, expected_ranks[5], committed_form()));
}

TEST_CASE("a degree that is much too large contradicts the Hodge index") {
    const auto failing_matrices = [](const DegreeForm& form) {
        return std::ranges::count_if(
            intersection_matrices(form),
            [](const IntersectionMatrix& matrix) { return positive_eigenvalues(matrix) != 1; });
    };
    CHECK(failing_matrices(committed_form()) == 0);
    CHECK(failing_matrices(with_degree(52234, 8480)) > 0);
}

TEST_CASE("degrees are multiples of 8, 40, 80 or 400, depending on the points that views share") {
    const DegreeForm& form = committed_form();
    const std::array<std::size_t, 3> pairs{checker::index_of("-/P/P"), checker::index_of("P/-/P"),
                                           checker::index_of("P/P/-")};
    std::map<std::int64_t, std::set<std::size_t>> classes;
    for (const Product& product : products(checker::camera_unknowns)) {
        const auto index = form.class_of(product);
        if (!index) continue;
        const std::int64_t degree = form.classes()[*index].degree;
        const auto fours = std::ranges::count_if(
            pairs, [&](std::size_t feature) { return product[feature] >= 4; });
        const bool five = std::ranges::any_of(checker::view_pairs, [&](checker::Views pair) {
            return checker::shared_points(product, pair) == 5;
        });
        const auto require_multiple = [&](std::int64_t factor) {
            classes[factor].insert(*index);
            REQUIRE(degree % factor == 0);
        };
        require_multiple(8);
        if (fours >= 1) require_multiple(40);
        if (five) require_multiple(80);
        if (fours >= 2) require_multiple(400);
    }
    CHECK(classes[8].size() == 10073);
    CHECK(classes[40].size() == 1252);
    CHECK(classes[80].size() == 938);
    CHECK(classes[400].size() == 42);
}

TEST_CASE("positive eigenvalues are counted exactly") {
    const auto positive = [](std::size_t size, std::vector<std::int64_t> entries) {
        return positive_eigenvalues({.divisors = size, .entries = std::move(entries)});
    };
    CHECK(positive(2, {1, 2, 2, 1}) == 1);
    CHECK(positive(2, {2, 1, 1, 2}) == 2);
    CHECK(positive(3, {0, 1, 0, 1, 0, 0, 0, 0, 0}) == 1);
    CHECK(positive(2, {-1, 0, 0, 0}) == 0);
    CHECK(positive(2, {1000000001, 1000000000, 1000000000, 1000000000}) == 2);
}

TEST_CASE("the file says `guarded` of just those degrees that a law guards") {
    std::ifstream file(committed);
    std::ostringstream marked, text;
    mark_guarded(file, marked, committed_form(), guarded_classes(committed_form()));
    text << std::ifstream(committed).rdbuf();
    INFO("write the file anew: laws --mark certs/degrees.csv >degrees.csv");
    CHECK((marked.str() == text.str()));
}

TEST_CASE("a table that lacks a class, or contradicts itself, is refused") {
    std::vector<DegreeLine> lines = read_exact_degrees(committed);
    lines.push_back({lines.front().number, lines.front().degree + 8});
    CHECK_THROWS_WITH_AS(DegreeForm{lines},
                         doctest::Contains("has two degrees: mend its lines in degrees.csv"),
                         std::runtime_error);
    const std::size_t last = lines[lines.size() - 2].number;
    std::erase_if(lines, [&](const DegreeLine& line) { return line.number == last; });
    lines.pop_back();
    CHECK_THROWS_WITH_AS(DegreeForm{lines}, doctest::Contains("has no exact degree"),
                         std::runtime_error);
}

namespace {

/// Which classes have a certified exact degree in the committed table.
std::vector<bool> certified_exactly() {
    std::vector<bool> exact(committed_form().classes().size(), false);
    std::ifstream file(committed);
    for (std::string line; std::getline(file, line);)
        if (!line.starts_with('#') && line.find(",exact,certified,") != std::string::npos)
            exact[*committed_form().class_with(std::stoul(line))] = true;
    return exact;
}

} // namespace

TEST_CASE("the Hodge index inequality holds between neighbours, and confines a wrong degree") {
    const auto matrices = intersection_matrices(committed_form());
    const std::vector<HodgeBounds> bounds = bounds_by_others(matrices, committed_form());
    for (std::size_t index = 0; index < bounds.size(); ++index) {
        const std::int64_t degree = committed_form().classes()[index].degree;
        CAPTURE(committed_form().classes()[index].number);
        CHECK(bounds[index].least <= degree);
        if (bounds[index].most) CHECK(*bounds[index].most >= degree);
    }
    // What stood in the file once is beyond what the neighbours allow.
    const HodgeBounds& mistaken = bounds[*committed_form().class_with(52234)];
    REQUIRE(mistaken.most);
    CHECK(*mistaken.most < 8480);
}

TEST_CASE("the Hodge index spreads upper bounds from exact degrees") {
    const auto matrices = intersection_matrices(committed_form());
    const std::vector<bool> exact = certified_exactly();
    CHECK(std::ranges::count(exact, true) == 10073); // so nothing is left to bound
    CHECK(bounded_by_exact(matrices, exact) == 0);
    // From all degrees but one it spreads to that one.
    std::vector<bool> others(exact.size(), true);
    others[*committed_form().class_with(52234)] = false;
    CHECK(bounded_by_exact(matrices, others) == 1);
}
