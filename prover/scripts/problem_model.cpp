#include "prover/scripts/problem_model.h"

#include "prover/problem/notation.h"
#include "prover/scripts/camera_text.h"
#include "prover/scripts/scene_text.h"

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

} // namespace plprove
