#include "prover/reasons/find_central_motion.h"

#include "prover/reasons/reason.h"

#include <bit>

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

/// Generators of a few points and lines; of cameras that are not projective, none.
std::vector<CameraMotion> generators_of_central(const Problem& problem, const Subproblem& part) {
    std::vector<CameraMotion> all{{.kind = MotionKind::central}};
    if (!problem.cameras->all_matrices) return all;
    constexpr std::size_t most_points = 3;
    for (std::size_t i = 0; i < all.size(); ++i) { // grows
        const CameraMotion before = all[i];
        if (!before.lines.empty() || before.points.size() == most_points) continue;
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

} // namespace

std::optional<CameraMotion> find_central_motion(const Problem& problem, const Subproblem& part) {
    // The generators of projective cameras make many choices: small parts of many views are left
    // out.
    constexpr int most_left_out = 3;
    const int left_out = problem.views - std::popcount(part.views);
    if (problem.cameras->all_matrices && left_out > most_left_out) return std::nullopt;
    for (const CameraMotion& generators : generators_of_central(problem, part)) {
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

} // namespace plprove
