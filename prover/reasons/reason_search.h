// The best reason seen so far, and what a search considers of one part.
#pragma once

#include "prover/reasons/reason.h"

namespace plprove {

class ReasonSearch {
public:
    explicit ReasonSearch(const Problem& problem) : problem_(problem) {}

    void consider(const Subproblem& part, const CameraMotion& motion);

    /// Motions of these cameras: by planes, then towards or about each point.
    void consider_motions(const Subproblem& part, ViewSet moving);

    /// Each point with some of the lines through it, and each line with some of its points. Then as
    /// many of these together as have parameters, lines alone first.
    void consider_loose(const Subproblem& part);

    bool found() const { return best_.has_value(); }

    std::optional<OverconstrainedPart> take() { return std::move(best_); }

private:
    /// Motions with these points among the generators, and up to `more` lines.
    void consider_with_lines(const Subproblem& part, CameraMotion& motion, std::size_t first,
                             int more);

    /// Each point and each line by itself that may be loose, with what goes with it.
    std::vector<CameraMotion> single_loose(const Subproblem& part) const;

    const Problem& problem_;
    std::optional<OverconstrainedPart> best_;
};

} // namespace plprove
