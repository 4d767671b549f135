#include "checker/minimal/record_lines.h"

#include <algorithm>
#include <iterator>

namespace checker {
Residue read_minor(Reader& reader) {
    const Residue minor{static_cast<std::uint64_t>(reader.integer(1, modulus - 1))};
    reader.end_line();
    return minor;
}

Numbers read_ascending(Reader& reader, int largest) {
    Numbers list;
    do {
        const int least = list.empty() ? 1 : list.back() + 1;
        list.push_back(reader.small_integer(least, largest));
    } while (!reader.at_end() && !reader.comes("columns"));
    return list;
}

MinorClaim read_minor_in_pool(Reader& reader, bool full_rank) {
    MinorClaim claim;
    if (!full_rank) {
        claim.stated = reader.take("rank # excess # # # star # $ delete rows");
        claim.deleted_rows = read_ascending(reader, 999'999);
        reader.take("columns");
        claim.deleted_columns = read_ascending(reader, camera_unknowns);
        reader.take("$ minor");
    }
    claim.minor = read_minor(reader);
    while (!full_rank && (claim.kernel.empty() || reader.comes("kernel"))) {
        if (claim.kernel.size() == camera_unknowns)
            reader.fail("kernel", "at most 11 kernel vectors");
        reader.take("kernel");
        for (mpz_class& entry : claim.kernel.emplace_back(camera_unknowns))
            entry = reader.big_integer(1000);
        reader.end_line();
    }
    return claim;
}

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
    if (list.size() < least)
        reader.fail(reader.at_end() ? "" : end, say("at least ", least, " views"));
    Views views = 0;
    for (const std::size_t view : list)
        views |= 1U << view;
    return views;
}

/// Takes `points ... lines ...` and the end of the line.
static Selection read_points_and_lines(Reader& reader, const Problem& problem) {
    Selection selection;
    reader.take("points");
    selection.points = read_list(reader, problem.points.size(), "lines");
    reader.take("lines");
    selection.lines = read_list(reader, problem.lines.size(), "");
    reader.end_line();
    return selection;
}

/// Takes `views ... points ... lines ...` and the end of the line.
static Selection read_selection(Reader& reader, const Problem& problem, std::size_t least_views) {
    reader.take("views");
    const Views views = read_views(reader, problem, least_views, "points");
    Selection selection = read_points_and_lines(reader, problem);
    selection.views = views;
    return selection;
}

/// Takes the word, so many numbers, and the end of the line.
static Numbers read_numbers(Reader& reader, std::string_view word, std::size_t count) {
    reader.take(word);
    Numbers numbers;
    while (numbers.size() < count)
        numbers.push_back(reader.small_integer(-999'999, 999'999));
    reader.end_line();
    return numbers;
}

/// Takes a minor, and the cameras and the scene where J has it.
static MinorClaim read_placed_minor(Reader& reader, const Problem& problem) {
    MinorClaim claim{.minor = read_minor(reader)};
    const CameraModel& cameras = *problem.cameras;
    if (cameras.shared > 0) claim.placement.shared = read_numbers(reader, "shared", cameras.shared);
    for (int view = 1; view < problem.view_count(); ++view)
        claim.placement.cameras.push_back(read_numbers(reader, "camera", cameras.numbers));
    claim.placement.scene = read_numbers(reader, "scene", scene_size(problem));
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

static std::size_t read_point(Reader& reader, const Problem& problem) {
    const auto points = static_cast<int>(problem.points.size());
    return static_cast<std::size_t>(reader.small_integer(1, points)) - 1;
}

/// Takes `joins` and pairs of points, if they come.
static Indices read_joins(Reader& reader, const Problem& problem) {
    Indices joins;
    if (!reader.comes("joins")) return joins;
    reader.take("joins");
    do {
        joins.push_back(read_point(reader, problem));
        joins.push_back(read_point(reader, problem));
    } while (!reader.at_end());
    return joins;
}

/// All numbers that are in one of two ascending lists.
static Indices united(const Indices& a, const Indices& b) {
    Indices all;
    std::ranges::set_union(a, b, std::back_inserter(all));
    return all;
}

/// Takes the lines `about ...`. What generates the W of all elements is among the generators of
/// each.
static std::vector<Element> read_elements(Reader& reader, const Problem& problem,
                                          const Selection& of_all) {
    constexpr std::size_t most = 24;                                         // two of each view
    constexpr std::array<std::string_view, 4> names{"point", "line", "view", // as Element::Centre
                                                    "axis"};
    std::vector<Element> elements;
    do {
        reader.take("about");
        const std::string_view name = reader.word();
        const auto found = std::ranges::find(names, name);
        if (found == names.end()) reader.fail(name, "`point`, `line`, `view` or `axis`");
        Element element{.kind = static_cast<Element::Centre>(found - names.begin())};
        const std::array<std::size_t, 4> limits{problem.points.size(), problem.lines.size(),
                                                static_cast<std::size_t>(problem.view_count()),
                                                problem.lines.size()};
        const std::size_t limit = limits[static_cast<std::size_t>(element.kind)];
        element.centre =
            static_cast<std::size_t>(reader.small_integer(1, static_cast<int>(limit))) - 1;
        reader.take("views");
        const Views views = read_views(reader, problem, 1, "points");
        Selection own;
        if (reader.at_end())
            reader.end_line();
        else
            own = read_points_and_lines(reader, problem);
        element.moved = {views, united(of_all.points, own.points), united(of_all.lines, own.lines)};
        elements.push_back(element);
    } while (reader.comes("about") && elements.size() < most);
    return elements;
}

/// Takes what follows `star`: each moving view is an element about the point.
static void read_star(Reader& reader, const Problem& problem, Motion& motion) {
    const std::size_t centre = read_point(reader, problem);
    motion.moved = read_selection(reader, problem, 1);
    const auto& [views, points, lines] = motion.moved;
    for (Views view = 1; view <= views; view <<= 1)
        if ((views & view) != 0)
            motion.elements.push_back({.centre = centre, .moved = {view, points, lines}});
}

static Motion read_motion(Reader& reader, const Problem& problem) {
    constexpr std::array<std::string_view, 7> names{"none",    "loose",      "camera",
                                                    "plane", // in the order of Motion::Kind
                                                    "central", "directions", "pencils"};
    Motion motion;
    reader.take("motion");
    motion.projective = reader.comes("projective");
    if (motion.projective) reader.take("projective");
    const std::string_view name = reader.word();
    const bool star = name == "star";
    const auto found = std::ranges::find(names, star ? "central" : name);
    if (found == names.end())
        reader.fail(name, "`none`, `loose`, `camera`, `plane`, `star`, `central`, `directions` or "
                          "`pencils`");
    motion.kind = static_cast<Motion::Kind>(found - names.begin());
    switch (motion.kind) {
    case Motion::Kind::none:
        reader.end_line();
        break;
    case Motion::Kind::loose:
        motion.moved = read_points_and_lines(reader, problem);
        break;
    case Motion::Kind::camera:
        motion.moved.views = 1U << (reader.small_integer(1, problem.view_count()) - 1);
        reader.end_line();
        break;
    case Motion::Kind::plane:
        motion.moved = read_selection(reader, problem, 1);
        break;
    case Motion::Kind::central:
        if (star) {
            read_star(reader, problem, motion);
        } else {
            motion.moved = read_points_and_lines(reader, problem);
            motion.elements = read_elements(reader, problem, motion.moved);
        }
        break;
    case Motion::Kind::directions:
        motion.joins = read_joins(reader, problem);
        reader.end_line();
        if (!reader.comes("core")) break;
        reader.take("core");
        motion.core = read_selection(reader, problem, 2);
        break;
    case Motion::Kind::pencils:
        motion.moved.points = {read_point(reader, problem)};
        reader.end_line();
    }
    return motion;
}

static PartClaim read_part(Reader& reader, const Problem& problem) {
    PartClaim claim;
    claim.excess = reader.small_integer(1, 999'999);
    reader.take("$ part");
    claim.part = read_selection(reader, problem, 2);
    claim.motion = read_motion(reader, problem);
    return claim;
}

Record read_record(Reader& reader, std::size_t line, const Problem& problem) {
    const std::string_view kind = reader.word();
    if (kind == "minimal") return {line, read_placed_minor(reader, problem)};
    if (kind == "collinear") return {line, read_collinear(reader, problem)};
    if (kind == "excess") return {line, read_part(reader, problem)};
    if (kind != "unbalanced") reader.fail(kind, "`minimal`, `unbalanced`, `collinear` or `excess`");
    reader.end_line();
    return {line, UnbalancedClaim{}};
}
} // namespace checker
