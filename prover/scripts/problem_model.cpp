#include "prover/scripts/problem_model.h"

#include "prover/problem/notation.h"
#include "prover/scripts/camera_text.h"
#include "prover/scripts/scene_text.h"

#include <algorithm>

namespace plprove {

std::string problem_model(const Problem& problem, int claimed) {
    ModelText text;
    text.comment("The point-line problem " + notation(problem));
    text.comment("x1_2 is the image of point 1 in view 2. Of points that view 1 sees, w is the "
                 "inverse of the depth; X are other points. y and z are more points of images of "
                 "lines, l are images of lines without seen points.");
    text.line("model point_line_problem");
    if (claimed > 0) text.line("claimed " + std::to_string(claimed));
    const std::string matrix = append_cameras(text, problem);
    append_scene(text, problem, matrix);
    append_counts(text, problem);
    return text.text();
}

Problem best_view_first(Problem problem) {
    const auto points_seen = [&](int view) {
        return std::ranges::count_if(problem.points,
                                     [&](ViewSet seen) { return contains(seen, view); });
    };
    int best = 0;
    for (int view = 1; view < problem.views; ++view)
        if (points_seen(view) > points_seen(best)) best = view;
    const auto exchange = [&](ViewSet& seen) {
        const ViewSet ends = 1U | 1U << static_cast<unsigned>(best);
        if (contains(seen, 0) != contains(seen, best)) seen ^= ends;
    };
    for (ViewSet& seen : problem.points)
        exchange(seen);
    for (Line& line : problem.lines)
        exchange(line.seen);
    return problem;
}

} // namespace plprove
