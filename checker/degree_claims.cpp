// What degree files say of the camera-degrees in the paper. Three words are kept apart: a degree is
// certified to be at least so much, is exactly that by evidence, and is claimed by the paper. Where
// an upper bound meets it, that it is exact is certified, too.
#include "checker/claims.h"

#include <map>
#include <set>

namespace checker {
/// By constraint class (proofs/problems.md, section 8), whose problems have the same degree.
struct Bound {
    std::size_t solutions = 0;    // at least
    bool complete = false;        // no more, by evidence or by an upper bound
    std::size_t upper = SIZE_MAX; // at most
    bool exact() const { return upper == solutions; }
};

/// Of P/a/a and Pab/b/a, and the same in other views, the former; other features are what they are.
static std::size_t exchanged(std::size_t i) {
    const bool two = features[i].pins == 2 && std::popcount(features[i].point) == 1;
    return two ? index_of(features[i].point, {features[i].point ^ 0b111}) : i;
}

/// The same signature for all of a constraint class.
static Signature constraint_class(const Signature& signature) {
    Signature merged{};
    for (std::size_t i = 0; i < feature_count; ++i) merged[exchanged(i)] += signature[i];
    return largest(merged, true);
}

/// Table 2 of the paper: how many terminal problems have a degree, for all degrees below a limit.
struct Table {
    std::string_view name;
    bool one_pin;                // at most one pin a point
    std::size_t limit, problems; // of all degrees
    std::string_view claimed;    // degrees and numbers
};
constexpr std::array<Table, 2> tables{
    {{"terminal", false, 300, 74575,
      "64 13 80 9 144 3 160 547 216 7 224 2 240 159 256 2 264 2 272 11 288 4"},
     {"terminal, at most one pin a point", true, 500, 9533,
      "80 9 160 173 216 4 240 80 256 2 264 2 272 2 288 1 304 5 312 2 320 213 352 3 360 9 368 3 "
      "376 1 384 2 392 9 400 14 408 2 416 6 424 10 432 2 448 7 456 11 464 4 472 1 480 96 488 12 "
      "496 9"}}};

/// How a number compares with the claimed one, if so many problems may still add to it.
static std::string compare(std::size_t claimed, std::size_t found, std::size_t open,
                           std::string_view grounds) {
    if (found > claimed || found + open < claimed) return say("differs, ", grounds);
    return open > 0 ? say("open: ", open, " undecided") : say("agrees, ", grounds);
}

/// The claims of a table on these problems, which have these bounds.
static void add_table(const Table& table,
                      const std::vector<std::pair<std::string, Bound>>& problems,
                      std::vector<DegreeClaim>& claims) {
    struct Line {
        std::size_t claimed = 0, found = 0; // the latter known: certified, or by evidence
        std::string witness{};
    };
    std::map<std::size_t, Line> lines; // by degree
    Line below;                        // the limit
    std::istringstream numbers{std::string(table.claimed)};
    for (std::size_t degree, count; numbers >> degree >> count; below.claimed += count)
        lines[degree].claimed = count;
    for (const auto& [problem, bound] : problems) {
        if (!bound.complete || bound.solutions >= table.limit) continue;
        ++below.found, ++lines[bound.solutions].found;
        lines[bound.solutions].witness = problem;
    }
    const auto count = [&](std::size_t degree, bool open) { // certified; or not decided
        return static_cast<std::size_t>(std::ranges::count_if(problems, [&](const auto& problem) {
            const Bound& bound = problem.second;
            return open ? !bound.complete && bound.solutions <= degree : bound.solutions >= degree;
        }));
    };
    const auto exact = [&](std::size_t from, std::size_t to) {
        return static_cast<std::size_t>(std::ranges::count_if(problems, [&](const auto& problem) {
            const Bound& bound = problem.second;
            return bound.exact() && from <= bound.solutions && bound.solutions <= to;
        }));
    };
    const auto grounds = [&](std::size_t degree) { // of statements on the degrees up to this one
        const bool proved = exact(0, degree) + count(degree + 1, false) == problems.size();
        return proved ? "certified" : "by evidence";
    };
    for (const auto& [degree, line] : lines)
        claims.push_back(
            {say(table.name, ", degree ", degree), say(line.claimed), say(count(degree, false)),
             say(exact(degree, degree)), say(line.found),
             compare(line.claimed, line.found, count(degree, true),
                     exact(degree, degree) > line.claimed ? "certified" : grounds(degree)),
             line.witness});
    const std::size_t open = count(table.limit - 1, true), rest = table.problems - below.claimed;
    const std::size_t least = count(table.limit, false), less = exact(0, table.limit - 1);
    const std::size_t most = problems.size() - least, most_rest = problems.size() - less;
    const auto on = [&](bool proved) { return proved ? "certified" : grounds(table.limit - 1); };
    claims.push_back({say(table.name, ", degree below ", table.limit), say(below.claimed), "-",
                      say(less), say(below.found),
                      compare(below.claimed, below.found, open,
                              on(less > below.claimed || most < below.claimed))});
    claims.push_back({say(table.name, ", degree at least ", table.limit), say(rest), say(least),
                      "-", "-", compare(rest, least, open, on(least > rest || most_rest < rest))});
    const std::size_t complete = problems.size() - count(SIZE_MAX, true);
    claims.push_back({say(table.name, ", of any degree"), say(table.problems), say(count(1, false)),
                      say(exact(0, SIZE_MAX)), say(complete), "-"});
}

/// The claim on one problem; 0 if the paper's text has none.
static DegreeClaim claim_on(const std::string& problem, std::size_t claimed, const Bound& bound) {
    const std::string least = say(bound.solutions), paper = claimed == 0 ? "-" : say(claimed);
    const std::string exact = bound.exact() ? least : "-", known = bound.complete ? least : "-";
    std::string verdict = bound.solutions == claimed ? "agrees, " : "differs, ";
    verdict += bound.solutions > claimed || bound.exact() ? "certified" : "by evidence";
    if (bound.solutions <= claimed && !bound.complete) verdict = "open";
    if (claimed == 0) verdict = "not in the text of the paper";
    if (bound.solutions == 0) verdict = "not covered by these files";
    return {problem, paper, least, exact, known, verdict};
}

void add_degree_claims(const Classification& classes, const std::vector<Class>& described, bool all,
                       Report& report) {
    std::map<Signature, Bound> bounds;
    const auto bound_of = [&](std::size_t n) -> Bound& {
        return bounds[constraint_class(classes.representatives[n])];
    };
    for (const FileReport& file : report.files)
        for (const auto& [number, line, solutions, complete] : file.degrees) {
            Bound& bound = bound_of(number);
            if (solutions > bound.solutions) bound = {solutions, complete};
            if (solutions == bound.solutions) bound.complete |= complete;
        }
    if (bounds.empty()) return;
    for (const FileReport& file : report.files)
        for (std::size_t n = 0; n < file.upper.size(); ++n)
            if (file.upper[n] > 0) bound_of(n).upper = std::min(bound_of(n).upper, file.upper[n]);
    // The degree of an extension of the five-point problem depends only on the type of registration
    // (proofs/upper_bounds.md, Proposition U7): where one class attains the bound, all do.
    for (const FileReport& file : report.files) {
        std::set<Registration> attained;
        for (std::size_t n = 0; n < file.upper.size(); ++n)
            if (file.upper[n] > 0 && bound_of(n).solutions == file.upper[n])
                attained.insert(file.types[n]);
        for (std::size_t n = 0; n < file.upper.size(); ++n)
            if (file.upper[n] > 0 && attained.contains(file.types[n]))
                bound_of(n).solutions = std::max(bound_of(n).solutions, file.upper[n]);
    }
    for (auto& [signature, bound] : bounds) {
        bound.complete |= bound.exact();
        if (bound.solutions <= bound.upper) continue;
        for (FileReport& file : report.files) // whichever of them is wrong, nothing follows
            if (file.kind == "bounds" || file.kind == "degrees") {
                file.degrees.clear(), file.at_most.clear(), file.templates = 0;
                file.refuse(0, say("certificates contradict each other: ", notation(signature),
                                   " has at least ", bound.solutions, " solutions, and at most ",
                                   bound.upper));
            }
        return;
    }
    std::vector<std::pair<std::string, Bound>> terminal, one_pin;
    for (std::size_t n = 0; n < described.size(); ++n) {
        const Class& c = described[n];
        if (!c.minimal) continue;
        const Bound& bound = bound_of(n);
        if (bound.exact()) report.exact.emplace_back(n, bound.solutions);
        const std::string problem = say("class ", n, ": ", notation(classes.representatives[n]));
        if (c.terminal) terminal.emplace_back(problem, bound);
        if (c.terminal && c.most_pins < 2) one_pin.emplace_back(problem, bound);
        const std::size_t registered = c.lines == 1 ? 80 : 160; // section 6 of the paper, in order
        if (c.most_pins == 0)
            report.degrees.push_back(
                claim_on("PL0P, " + problem, c.registers ? registered : 0, bound));
        if (!c.name.empty()) report.degrees.push_back(claim_on(c.name + ", " + problem, 0, bound));
    }
    for (const Table& table : tables)
        if (all) add_table(table, table.one_pin ? one_pin : terminal, report.degrees);
}
} // namespace checker
