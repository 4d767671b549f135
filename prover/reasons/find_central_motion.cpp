#include "prover/reasons/find_central_motion.h"

#include "prover/reasons/reason.h"

#include <algorithm>
#include <functional>
#include <iterator>
#include <utility>

namespace plprove {

namespace {

/// Elements of a central motion, chosen so that it has many parameters.
class Elements {
public:
    Elements(const Problem& problem, const Subproblem& part, CameraMotion generators)
        : problem_(problem), part_(part), motion_(std::move(generators)) {
        for (const int line : part.lines)
            add_candidates(CentralElement::Centre::line, line);
        for (int view = 0; view < problem.views; ++view)
            if (contains(part.views, view)) add_candidates(CentralElement::Centre::view, view);
    }

    /// All elements about these points, without those that cost more than they have; then others,
    /// as long as the parameters grow.
    CameraMotion best_about(const std::vector<int>& points) const {
        CameraMotion motion = motion_;
        for (const int point : points)
            for (const CentralElement& element :
                 elements_about(problem_, part_, motion_, CentralElement::Centre::point, point))
                motion.elements.push_back(element);
        while (leave_out_one(motion)) {
        }
        while (add_one(motion)) {
        }
        return motion;
    }

private:
    void add_candidates(CentralElement::Centre kind, int centre) {
        for (const CentralElement& element : elements_about(problem_, part_, motion_, kind, centre))
            candidates_.push_back(element);
    }

    bool leave_out_one(CameraMotion& motion) const {
        const std::optional<int> before = motions(problem_, part_, motion);
        for (std::size_t i = 0; i < motion.elements.size(); ++i) {
            CameraMotion less = motion;
            less.elements.erase(less.elements.begin() + static_cast<std::ptrdiff_t>(i));
            if (motions(problem_, part_, less) <= before) continue;
            motion = less;
            return true;
        }
        return false;
    }

    bool add_one(CameraMotion& motion) const {
        const std::optional<int> before = motions(problem_, part_, motion);
        for (const CentralElement& element : candidates_) {
            motion.elements.push_back(element);
            if (motions(problem_, part_, motion) > before) return true;
            motion.elements.pop_back();
        }
        return false;
    }

    const Problem& problem_;
    const Subproblem& part_;
    CameraMotion motion_;
    std::vector<CentralElement> candidates_;
};

} // namespace

std::vector<CameraMotion> generators_of(const Problem& problem, const Subproblem& part,
                                        MotionKind kind) {
    std::vector<CameraMotion> all{{.kind = kind}};
    if (!problem.cameras->all_matrices) return all;
    constexpr std::size_t most = 3;
    for (std::size_t i = 0; i < all.size(); ++i) { // grows
        const CameraMotion before = all[i];
        if (!before.lines.empty() || before.points.size() == most) continue;
        for (const int point : part.points) {
            if (!before.points.empty() && point <= before.points.back()) continue;
            all.push_back(before);
            all.back().points.push_back(point);
        }
        for (const int line : part.lines) {
            all.push_back(before);
            all.back().lines.push_back(line);
        }
    }
    return all;
}

/// A motion in which some cameras turn about a line of the part, with all that they see.
static std::optional<CameraMotion> find_turn(const Problem& problem, const Subproblem& part) {
    if (!problem.cameras->may_turn) return std::nullopt;
    const CameraMotion none{.kind = MotionKind::central};
    for (const int line : part.lines)
        for (const CentralElement& element :
             elements_about(problem, part, none, CentralElement::Centre::axis, line)) {
            CameraMotion motion = none;
            motion.elements = {element};
            if (excess(problem, part, motion) > 0) return motion;
        }
    return std::nullopt;
}

std::optional<CameraMotion> find_central_motion(const Problem& problem, const Subproblem& part) {
    if (std::optional<CameraMotion> turn = find_turn(problem, part)) return turn;
    for (const CameraMotion& generators : generators_of(problem, part, MotionKind::central)) {
        const Elements elements(problem, part, generators);
        std::vector<std::vector<int>> centres{{}};
        for (const int point : part.points)
            centres.push_back({point});
        for (const std::vector<int>& about : centres) {
            CameraMotion motion = elements.best_about(about);
            if (excess(problem, part, motion) > 0) return motion;
        }
    }
    return std::nullopt;
}

/// Elements about a centre, with these generators of their own.
static std::vector<CentralElement> elements_keeping(const Problem& problem, const Subproblem& part,
                                                    const CameraMotion& generators,
                                                    CentralElement::Centre kind, int centre) {
    std::vector<CentralElement> elements = elements_about(problem, part, generators, kind, centre);
    for (CentralElement& element : elements) {
        element.points = generators.points;
        element.lines = generators.lines;
    }
    return elements;
}

/// Elements about a point with all generators. Of those that move the same views only the first few
/// that have the most parameters.
static std::vector<CentralElement> best_elements(const Problem& problem, const Subproblem& part,
                                                 const std::vector<CameraMotion>& all_generators,
                                                 int point) {
    constexpr std::ptrdiff_t most = 8;
    std::vector<std::pair<int, CentralElement>> found; // with the parameters
    for (const CameraMotion& generators : all_generators)
        for (CentralElement& element :
             elements_keeping(problem, part, generators, CentralElement::Centre::point, point)) {
            const CameraMotion alone{.kind = MotionKind::central, .elements = {element}};
            if (const std::optional<int> parameters = motions(problem, part, alone))
                found.emplace_back(*parameters, std::move(element));
        }
    std::ranges::stable_sort(found, std::greater{}, [](const auto& pair) { return pair.first; });
    std::vector<CentralElement> elements;
    for (auto& [parameters, element] : found)
        if (std::ranges::count(elements, element.views, &CentralElement::views) < most)
            elements.push_back(std::move(element));
    return elements;
}

/// Elements about lines and about cameras, with the generators of the elements of the motion.
static std::vector<CentralElement> other_elements(const Problem& problem, const Subproblem& part,
                                                  const CameraMotion& motion) {
    std::vector<CentralElement> others;
    const auto add = [&](const CentralElement& like, CentralElement::Centre kind, int centre) {
        const CameraMotion generators{
            .kind = MotionKind::central, .points = like.points, .lines = like.lines};
        std::ranges::move(elements_keeping(problem, part, generators, kind, centre),
                          std::back_inserter(others));
    };
    for (const CentralElement& like : motion.elements) {
        for (const int line : part.lines)
            add(like, CentralElement::Centre::line, line);
        for (int view = 0; view < problem.views; ++view)
            if (contains(part.views, view)) add(like, CentralElement::Centre::view, view);
    }
    return others;
}

/// Adds elements one after the other, each the one that leaves the most parameters, as long as one
/// fits; returns what had the most on the way.
static CameraMotion best_with(const Problem& problem, const Subproblem& part, CameraMotion motion,
                              const std::vector<CentralElement>& elements) {
    CameraMotion best = motion;
    while (true) {
        std::optional<int> most;
        CameraMotion next;
        for (const CentralElement& element : elements) {
            CameraMotion more = motion;
            more.elements.push_back(element);
            const std::optional<int> parameters = motions(problem, part, more);
            if (parameters <= most) continue;
            most = parameters;
            next = std::move(more);
        }
        if (!most) return best;
        motion = std::move(next);
        if (most > motions(problem, part, best)) best = motion;
    }
}

std::optional<CameraMotion> find_any_central_motion(const Problem& problem,
                                                    const Subproblem& part) {
    const std::vector<CameraMotion> generators = generators_of(problem, part, MotionKind::central);
    for (const int about : part.points) {
        const std::vector<CentralElement> elements =
            best_elements(problem, part, generators, about);
        for (const CentralElement& first : elements) {
            const CameraMotion alone{.kind = MotionKind::central, .elements = {first}};
            CameraMotion motion = best_with(problem, part, alone, elements);
            if (excess(problem, part, motion) <= 0)
                motion = best_with(problem, part, motion, other_elements(problem, part, motion));
            if (excess(problem, part, motion) > 0) return motion;
        }
    }
    return std::nullopt;
}

} // namespace plprove
