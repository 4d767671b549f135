#include "checker/minimal/problem_record.h"

namespace checker {
/// Takes strictly ascending numbers up to the word, or to the end of the line. They count from 1.
static Indices read_list(Reader& reader, std::size_t largest, std::string_view end) {
    Indices list;
    while (!reader.at_end() && !reader.comes(end)) {
        const std::size_t least = list.empty() ? 1 : list.back() + 2;
        const auto number = reader.integer(static_cast<int>(least), static_cast<int>(largest));
        list.push_back(static_cast<std::size_t>(number) - 1);
    }
    return list;
}

/// Takes VIEW VIEW ..., at least `least` of them, up to the word or to the end of the line.
static Views read_views(Reader& reader, const Problem& problem, std::size_t least,
                        std::string_view end) {
    const auto all = static_cast<std::size_t>(std::popcount(problem.views));
    const Indices list = read_list(reader, all, end);
    if (list.size() < least) reader.fail(end, say("at least ", least, " views"));
    Views views = 0;
    for (const std::size_t view : list)
        views |= 1U << view;
    return views;
}

/// Takes `views ... points ... lines ...` and the end of the line.
static Selection read_selection(Reader& reader, const Problem& problem, std::size_t least_views) {
    Selection selection;
    reader.take("views");
    selection.views = read_views(reader, problem, least_views, "points");
    reader.take("points");
    selection.points = read_list(reader, problem.points.size(), "lines");
    reader.take("lines");
    selection.lines = read_list(reader, problem.lines.size(), "");
    reader.end_line();
    return selection;
}

static MinorClaim read_minor(Reader& reader, const Problem& problem) {
    MinorClaim claim;
    claim.minor.value = static_cast<std::uint64_t>(reader.integer(1, modulus - 1));
    reader.end_line();
    std::string pattern = "camera";
    for (std::size_t i = 0; i < problem.cameras->numbers; ++i)
        pattern += " @";
    for (int view = 1; view < problem.view_count(); ++view)
        claim.placement.cameras.push_back(reader.take(pattern + " $"));
    reader.take("scene");
    for (std::size_t left = scene_size(problem); left > 0; --left)
        claim.placement.scene.push_back(reader.small_integer(-999'999, 999'999));
    reader.end_line();
    return claim;
}

static CollinearClaim read_collinear(Reader& reader, const Problem& problem) {
    CollinearClaim claim;
    claim.points = read_list(reader, problem.points.size(), "views");
    if (claim.points.size() != 4) reader.fail("views", "four points");
    reader.take("views");
    claim.views = read_views(reader, problem, 2, "");
    if (std::popcount(claim.views) != 2) reader.fail("", "two views");
    reader.end_line();
    return claim;
}

static PartClaim read_part(Reader& reader, const Problem& problem) {
    PartClaim claim;
    claim.excess = reader.small_integer(1, 999'999);
    reader.take("$ part");
    claim.part = read_selection(reader, problem, 2);
    reader.take("motion");
    const std::string_view kind = reader.word();
    if (kind == "none") {
        reader.end_line();
        return claim;
    }
    if (kind != "plane" && kind != "star") reader.fail(kind, "`none`, `plane` or `star`");
    claim.motion.kind = kind == "star" ? Motion::Kind::star : Motion::Kind::plane;
    if (kind == "star") {
        const auto points = static_cast<int>(problem.points.size());
        claim.motion.centre = static_cast<std::size_t>(reader.small_integer(1, points)) - 1;
    }
    claim.motion.moved = read_selection(reader, problem, 1);
    return claim;
}

ProblemRecord read_problem_record(Reader& reader) {
    ProblemRecord record{.line = reader.line()};
    reader.take("problem");
    record.problem = read_notation(reader);
    const Problem& problem = record.problem.problem;
    const std::string_view kind = reader.word();
    if (kind == "minimal")
        record.claim = read_minor(reader, problem);
    else if (kind == "collinear")
        record.claim = read_collinear(reader, problem);
    else if (kind == "excess")
        record.claim = read_part(reader, problem);
    else if (kind == "unbalanced") {
        reader.end_line();
        record.claim = UnbalancedClaim{};
    } else
        reader.fail(kind, "`minimal`, `unbalanced`, `collinear` or `excess`");
    return record;
}

static void check(const Problem& problem, const MinorClaim& claim) {
    const int excess = surplus(problem);
    if (excess != 0)
        throw Refused("it is not balanced: the images have dimension ", excess, " more");
    const std::string_view objection = problem.cameras->objection(claim.placement.cameras[0]);
    if (!objection.empty()) throw Refused(objection);
    const Residue minor = jacobian_determinant(problem, claim.placement);
    if (minor != claim.minor) throw Refused("the minor is ", minor.value, " modulo q");
}

static void check(const Problem& problem, const UnbalancedClaim&) {
    if (surplus(problem) == 0) throw Refused("it is balanced");
}

static void check(const Problem& problem, const CollinearClaim& claim) {
    check_collinear(problem, claim.points, claim.views);
}

static void check(const Problem& problem, const PartClaim& claim) {
    check_part(problem, claim);
}

void check_record(const ProblemRecord& record) {
    const Problem& problem = record.problem.problem;
    std::visit([&](const auto& claim) { check(problem, claim); }, record.claim);
}
} // namespace checker
