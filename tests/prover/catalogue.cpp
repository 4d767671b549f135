// The catalogue as values: known counts, and laws of its entries.
#include "prover/catalogue/catalogue.h"
#include "checker/paper/numbers.h"
#include "prover/catalogue/filter.h"
#include "prover/catalogue/paper_counts.h"
#include "prover/catalogue/spelling.h"
#include "prover/problem/reduction.h"

#include <algorithm>
#include <doctest/doctest.h>
#include <map>
#include <numeric>
#include <set>

using namespace plprove;

namespace {

const std::vector<Entry>& all() {
    static const std::vector<Entry> entries = catalogue();
    return entries;
}

std::ptrdiff_t count(const Filter& filter) {
    return std::ranges::count_if(all(), [&](const Entry& e) { return matches(filter, e); });
}

Filter where(std::initializer_list<bool Filter::*> flags) {
    Filter filter;
    for (const auto flag : flags)
        filter.*flag = true;
    return filter;
}

/// A problem up to relabeling of the views, renaming of pins and order of features.
Features up_to_relabeling(const Features& problem) {
    Features least;
    std::array<int, 3> views{0, 1, 2};
    do {
        Features relabeled;
        for (const Feature& feature : problem)
            relabeled.push_back(canonical(relabel_views(feature, views)));
        std::ranges::sort(relabeled);
        if (least.empty() || relabeled < least) least = relabeled;
    } while (std::ranges::next_permutation(views).found);
    return least;
}

int dangling_pins(const Feature& feature) {
    int dangling = 0;
    for (int line = 0; line < feature.lines; ++line) {
        int seen = 0;
        for (int view = 0; view < feature.views(); ++view)
            seen += feature.sees_line(view, line);
        dangling += seen == 1;
    }
    return dangling;
}

} // namespace

TEST_CASE("the catalogue has the known counts") {
    CHECK(all().size() == 143494);
    CHECK(count(where({&Filter::minimal})) == 140616);
    CHECK(count(where({&Filter::not_minimal})) == 2878);
    CHECK(count(where({&Filter::terminal})) == 74575);
    CHECK(count(where({&Filter::minimal, &Filter::pl0p})) == 51);
    CHECK(count(where({&Filter::terminal, &Filter::pl0p})) == 51);
    CHECK(count(where({&Filter::terminal, &Filter::one_pin})) == 9533);
    CHECK(count(where({&Filter::five_point})) == 6413);
    CHECK(count(where({&Filter::terminal, &Filter::five_point})) == 3615);
    CHECK(count(where({&Filter::registration})) == 61);
    CHECK(count(where({&Filter::terminal, &Filter::trifocal})) == 66);
    CHECK(count(where({&Filter::minimal, &Filter::complete_visibility})) == 12);
    std::set<std::size_t> swap_classes;
    std::set<std::size_t> constraint_classes;
    for (const Entry& entry : all()) {
        swap_classes.insert(entry.swap_class);
        constraint_classes.insert(entry.constraint_class);
    }
    CHECK(swap_classes.size() == 76446);
    CHECK(constraint_classes.size() == 10693);
}

TEST_CASE("the paper's numbers in the catalogue are those that the checker compares with") {
    for (const PaperCount& count : paper_counts) {
        CAPTURE(count.quantity);
        CHECK(std::ranges::count(checker::paper::claimed_counts, std::size_t(count.claimed),
                                 &checker::paper::ClaimedCount::claimed) == 1);
    }
}

TEST_CASE("too many shared points explain 2871 classes, stars alone the other seven") {
    Filter filter;
    filter.obstruction = ObstructionFilter::epipolar;
    CHECK(count(filter) == 2871);
    filter.obstruction = ObstructionFilter::any;
    CHECK(count(filter) == 2878);
    filter.obstruction = ObstructionFilter::star;
    CHECK(count(filter) == 8); // one of them shares too many points besides
    filter.obstruction = ObstructionFilter::none;
    CHECK(count(filter) == 140616);
}

TEST_CASE("swap and constraint classes begin with themselves and have one verdict") {
    bool consistent = true;
    for (const Entry& entry : all())
        for (const std::size_t first : {entry.swap_class, entry.constraint_class}) {
            consistent = consistent && first <= entry.number;
            consistent = consistent && all()[first].minimal() == entry.minimal();
            consistent = consistent && all()[first].constraint_class == entry.constraint_class;
        }
    CHECK(consistent);
}

TEST_CASE("terminal problems up to relabeling are the minimal swap classes") {
    std::map<Features, std::size_t> swap_class_of;
    bool same_class = true;
    for (const Entry& entry : all()) {
        if (!entry.minimal() || (!entry.terminal() && entry.number % 17 != 0)) continue;
        const Features problem = parse_features(terminal_notation(entry.signature));
        const auto [known, fresh] =
            swap_class_of.emplace(up_to_relabeling(problem), entry.swap_class);
        same_class = same_class && (fresh || known->second == entry.swap_class);
    }
    CHECK(same_class);
    CHECK(swap_class_of.size() == 74575);
}

TEST_CASE("a terminal form gives up a constraint for each pin left dangling") {
    std::map<std::string, std::string> changed;
    for (const Feature& feature : standard_features()) {
        const Feature form = terminal(feature);
        CHECK(weight(form) + dangling_pins(form) == weight(feature));
        CHECK(terminal(form) == form);
        if (form != feature) changed[notation(feature)] = notation(form);
    }
    // The nine features that Definition 6 excludes.
    const std::map<std::string, std::string> expected{
        {"a/P/Pa", "a/P/P"},  {"a/Pa/P", "a/P/P"},  {"P/a/Pa", "P/a/P"},
        {"Pa/a/P", "P/a/P"},  {"P/Pa/a", "P/P/a"},  {"Pa/P/a", "P/P/a"},
        {"Pab/b/a", "P/b/a"}, {"b/Pab/a", "b/P/a"}, {"b/a/Pab", "b/a/P"}};
    CHECK(changed == expected);
}

TEST_CASE("a problem is spelled alike from its signature and from its features") {
    bool alike = true;
    for (const Entry& entry : all())
        alike = alike && notation(entry.signature) == notation(problem_of(entry.signature));
    CHECK(alike);
    CHECK(notation(all()[2394].signature) == "2*Pa/Pa/Pa + P/P/P");
    CHECK(terminal_notation(all()[2394].signature) == "2*Pa/Pa/Pa + P/P/P");
}

TEST_CASE("the two features of a swap pair become one term of the terminal problem") {
    const auto signature = signature_of(parse_features("3*P/P/P + P/Pa/a"));
    REQUIRE(signature);
    CHECK(terminal_notation(*signature) == "3*P/P/P + P/P/a");
    const auto both = signature_of(parse_features("2*P/P/P + a/a/a + P/-/P + P/Pa/a + Pa/P/a"));
    REQUIRE(both);
    CHECK(terminal_notation(*both) == "2*P/P/P + a/a/a + 2*P/P/a + P/-/P");
}

TEST_CASE("counts agree with one another and with the excesses") {
    bool consistent = true;
    for (const Entry& entry : all()) {
        const Counts& c = entry.counts;
        const int features = std::accumulate(entry.signature.begin(), entry.signature.end(), 0);
        consistent = consistent && c.points + c.free_lines == features;
        for (std::size_t pair = 0; pair < 3; ++pair) {
            const auto [i, j] = view_pairs[pair];
            consistent = consistent &&
                         entry.obstruction.excess[pair] == std::max(0, c.shared_points[pair] - 5);
            // Inclusion and exclusion: no more points than there are.
            const int union_of_two = c.points_in_view[static_cast<std::size_t>(i)] +
                                     c.points_in_view[static_cast<std::size_t>(j)] -
                                     c.shared_points[pair];
            consistent = consistent && union_of_two <= c.points;
        }
        consistent =
            consistent && (c.complete_views == 3) == (families(entry.signature).plmp.has_value());
    }
    CHECK(consistent);
}

TEST_CASE("minimal classes have the degree of their constraint class, and others have none") {
    CHECK(std::ranges::is_sorted(degrees_on_file(), {}, &ClassDegree::constraint_class));
    bool alike = true;
    std::set<std::size_t> constraint_classes;
    for (const Entry& entry : all()) {
        alike = alike && entry.degree.has_value() == entry.minimal() &&
                entry.degree == all()[entry.constraint_class].degree;
        if (entry.minimal()) constraint_classes.insert(entry.constraint_class);
    }
    CHECK(alike);
    CHECK(constraint_classes.size() == 10073);
    CHECK(degrees_on_file().size() == constraint_classes.size());
    for (const ClassDegree& row : degrees_on_file())
        alike = alike && row.degree > 0 && constraint_classes.contains(row.constraint_class);
    CHECK(alike);
    CHECK(all()[2394].degree == 312);
}

TEST_CASE("a range of degrees has the classes whose degree is in it") {
    Entry entry;
    Filter filter;
    const auto in = [&](const char* range) {
        filter.degree = parse_range(range);
        return matches(filter, entry);
    };
    CHECK(!in("0.."));
    entry.degree = 300;
    for (const char* range : {"300", "300..", "200..", "..300", "..400"})
        CHECK(in(range));
    for (const char* range : {"301..", "299", "..299"})
        CHECK(!in(range));
}

TEST_CASE("ranges and view counts are read or refused whole") {
    const auto is = [](std::string_view text, int least, int most) {
        const auto range = parse_range(text);
        return range && range->least == least && range->most == most;
    };
    CHECK(is("3", 3, 3));
    CHECK(is("2..5", 2, 5));
    CHECK(is("..5", 0, 5));
    CHECK(is("2..", 2, Range{}.most));
    for (const char* text :
         {"", "..", "5..2", "x", "1.5", "-1", "1...2", "1..2..3", "1234567", " 1"})
        CHECK(!parse_range(text));
    CHECK(parse_views("5,3,4") == Views{3, 4, 5});
    for (const char* text : {"", "1,2", "1,2,3,4", "1,,2", "1,2,", "a,b,c", "1, 2,3"})
        CHECK(!parse_views(text));
}
