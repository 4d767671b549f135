#include "prover/reasons/find_central_motion.h"

#include "prover/reasons/reason.h"

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

    /// The best choice of the elements about a point; then others, as long as the parameters grow.
    CameraMotion best_choice_about(int point) const {
        const std::vector<CentralElement> all =
            elements_about(problem_, part_, motion_, CentralElement::Centre::point, point);
        CameraMotion best = motion_;
        for (std::size_t chosen = 1; chosen < std::size_t{1} << all.size(); ++chosen) {
            CameraMotion motion = motion_;
            for (std::size_t i = 0; i < all.size(); ++i)
                if ((chosen >> i & 1) != 0) motion.elements.push_back(all[i]);
            if (motions(problem_, part_, motion) > motions(problem_, part_, best)) best = motion;
        }
        while (add_one(best)) {
        }
        return best;
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

std::optional<CameraMotion> find_any_central_motion(const Problem& problem,
                                                    const Subproblem& part) {
    for (const CameraMotion& generators : generators_of(problem, part, MotionKind::central)) {
        const Elements elements(problem, part, generators);
        for (const int about : part.points) {
            CameraMotion motion = elements.best_choice_about(about);
            if (excess(problem, part, motion) > 0) return motion;
        }
    }
    return std::nullopt;
}

} // namespace plprove
