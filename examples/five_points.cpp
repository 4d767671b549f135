// The relative pose of two cameras from five points that both see.
#include <pointline/solver.h>

#include <cstdio>

namespace {

const pointline::Intrinsics camera{800, 800, 320, 240};

// What the two views see: five corners of a cube, in pixels.
const pointline::Point seen[5][2] = {{{240.000000, 160.000000}, {236.201067, 68.731297}},
                                     {{400.000000, 160.000000}, {392.252976, 63.600873}},
                                     {{240.000000, 320.000000}, {236.201067, 224.430118}},
                                     {{400.000000, 320.000000}, {392.252976, 223.963716}},
                                     {{386.666667, 173.333333}, {400.301356, 92.780226}}};

pointline::Images images_of_cube() {
    pointline::Images images;
    images.cameras = {camera, camera};
    for (const auto& [first, second] : seen)
        images.features.push_back({{first, {}}, {second, {}}});
    return images;
}

} // namespace

int main() {
    const auto solver = pointline::Solver::make("5*P/P");
    if (!solver) {
        std::fprintf(stderr, "%s\n", solver.error().message.c_str());
        return 1;
    }
    const auto answer = solver->solve(images_of_cube());
    if (!answer) {
        std::fprintf(stderr, "%s\n", answer.error().message.c_str());
        return 1;
    }
    std::printf("%d of %d solutions, %zu real\n", answer->found, answer->degree,
                answer->solutions.size());
    for (const pointline::Solution& solution : answer->solutions) {
        const auto& t = solution.cameras[1].t;
        std::printf("%d points in front of both cameras, t = %9.6f %9.6f %9.6f\n",
                    solution.in_front, t[0], t[1], t[2]);
    }
    return answer->solutions.empty() ? 1 : 0;
}
