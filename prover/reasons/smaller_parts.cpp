#include "prover/reasons/smaller_parts.h"

#include "prover/reasons/reason.h"

#include <algorithm>
#include <optional>
#include <vector>

namespace plprove {

Subproblem common_part(const Problem& problem, ViewSet views) {
    Subproblem part{views, {}, {}};
    for (std::size_t i = 0; i < problem.points.size(); ++i)
        if ((problem.points[i] & views) == views) part.points.push_back(static_cast<int>(i));
    for (std::size_t i = 0; i < problem.lines.size(); ++i)
        if ((problem.lines[i].seen & views) == views) part.lines.push_back(static_cast<int>(i));
    return part;
}

Subproblem without_point(const Problem& problem, Subproblem part, int point) {
    std::erase(part.points, point);
    std::erase_if(part.lines, [&](int number) {
        return problem.lines[static_cast<std::size_t>(number)].points == std::vector<int>{point};
    });
    return part;
}

Subproblem without_line(Subproblem part, int line) {
    std::erase(part.lines, line);
    return part;
}

Subproblem densest(const Problem& problem, Subproblem part, const CameraMotion& motion) {
    const auto parameters_to_spare = [&](const Subproblem& candidate) {
        return is_part(problem, candidate) ? excess(problem, candidate, motion) : std::nullopt;
    };
    for (bool changed = true; changed;) {
        changed = false;
        std::vector<Subproblem> candidates;
        for (const int point : part.points)
            candidates.push_back(without_point(problem, part, point));
        for (const int line : part.lines)
            candidates.push_back(without_line(part, line));
        for (const int point : part.points) {
            candidates.push_back(part);
            std::erase(candidates.back().points, point);
        }
        for (const Subproblem& candidate : candidates)
            if (!changed && parameters_to_spare(candidate) > parameters_to_spare(part)) {
                part = candidate;
                changed = true;
            }
    }
    return part;
}

Subproblem seen_in(const Problem& problem, Subproblem part, ViewSet views) {
    part.views = views;
    std::erase_if(part.lines, [&](int number) {
        return (problem.lines[static_cast<std::size_t>(number)].seen & views) == 0;
    });
    std::erase_if(part.points, [&](int point) {
        return (problem.points[static_cast<std::size_t>(point)] & views) == 0 &&
               std::ranges::none_of(part.lines, [&](int line) {
                   return contains(problem.lines[static_cast<std::size_t>(line)], point);
               });
    });
    return part;
}

} // namespace plprove
