#include "prover/scripts/model.h"
#include "prover/scripts/scripts.h"

namespace plprove {

namespace {

std::string opening(const Features& problem) {
    const std::string sign = "--";
    return comment(sign, "The point-line problem " + notation(problem)) + "--\n" +
           comment(
               sign,
               "This script sets up the equations of the problem over a finite field, for the "
               "images of a random scene, and computes the rank of their Jacobian at that scene, "
               "which is a solution. The rank is the generic one unless the random numbers are "
               "very unlucky. If it is the number of equations and of unknowns, this proves that "
               "the problem is minimal.") +
           "--\n-- Run it with:  M2 --script FILE\n\n";
}

const char* const definitions = R"script(
-- A camera is a pair of a rotation, up to scale that of the quaternion (1, a, b, c), and a translation.
rotation = (a, b, c) -> {
    {1+a^2-b^2-c^2, 2*(a*b-c), 2*(a*c+b)},
    {2*(a*b+c), 1-a^2+b^2-c^2, 2*(b*c-a)},
    {2*(a*c-b), 2*(b*c+a), 1-a^2-b^2+c^2}};
dot = (l, y) -> l#0*y#0 + l#1*y#1 + l#2*y#2;
turn = (P, D) -> apply(P#0, row -> dot(row, D));
see = (P, X) -> turn(P, X) + P#1;
)script";

const char* const equations = R"script(
-- A random scene, and vectors of polynomials at it.
scene = apply(numgens R, i -> random FF);
atScene = map(FF, R, scene);
imageOf = y -> apply(y, f -> atScene f);
lineThrough = (x, e) -> {x#1*e#2-x#2*e#1, x#2*e#0-x#0*e#2, x#0*e#1-x#1*e#0};

-- With x the image of the point X in the scene: two lines through x contain the image of X.
seesPoint = (P, X) -> (
    x := imageOf see(P, X);
    {dot({0, x#2, -x#1}, see(P, X)), dot({-x#2, 0, x#0}, see(P, X))});
-- With l the image of the line through X with direction D: l contains the image of D, and that of X.
seesPin = (P, X, D) -> (
    l := lineThrough(imageOf see(P, X), imageOf turn(P, D));
    {dot(l, turn(P, D))});
seesLine = (P, X, D) -> (
    l := lineThrough(imageOf see(P, X), imageOf turn(P, D));
    {dot(l, see(P, X)), dot(l, turn(P, D))});
)script";

const char* const ranks = R"script(
-- All equations hold at the scene; the ideal also contains solutions where a quaternion has norm 0.
I = ideal equations;
stopIf = (condition, message) -> if condition then (stderr << message << endl; exit 1);
stopIf(any(equations, f -> atScene f != 0), "the scene is no solution");

J = atScene transpose jacobian matrix {equations};
rankJ = rank J;
rankFeatures = rank J_(toList(0 .. featureUnknowns - 1));
cameraUnknowns = numgens R - featureUnknowns;
-- Camera-minimal: the images are generic, and motions that keep them keep the cameras.
isCameraMinimal = rankJ == #equations and rankJ - rankFeatures == cameraUnknowns;
isMinimal = isCameraMinimal and #equations == numgens R;
answer = b -> if b then "yes" else "no";
<< "equations        " << #equations << endl;
<< "unknowns         " << numgens R << " (" << featureUnknowns << " of features, "
    << cameraUnknowns << " of cameras)" << endl;
<< "rank             " << rankJ << " (" << rankFeatures << " of the feature columns)" << endl;
<< "minimal          " << answer isMinimal << endl;
<< "camera-minimal   " << answer isCameraMinimal << endl;
)script";

std::string braces(const std::vector<std::string>& coordinates) {
    std::string text;
    // A coordinate 1 has to be in the ring, like the others.
    for (const std::string& name : coordinates)
        text += (text.empty() ? "" : ", ") + (name == "1" ? "1_R" : name);
    return "{" + text + "}";
}

std::string call(const Observation& observation, const std::vector<NamedVector>& placed) {
    const std::string at = "(P" + std::to_string(observation.view + 1) + ", " + placed[0].name;
    const std::string& direction = placed[observation.kind == Observation::point
                                              ? 0
                                              : static_cast<std::size_t>(observation.index) + 1]
                                       .name;
    switch (observation.kind) {
    case Observation::point:
        return "seesPoint" + at + ")";
    case Observation::pin:
        return "seesPin" + at + ", " + direction + ")";
    case Observation::line:
        return "seesLine" + at + ", " + direction + ")";
    }
    return {};
}

} // namespace

std::string macaulay2_script(const Features& problem) {
    if (equation_count(problem) == 0)
        return opening(problem) + "-- No view sees anything: there are no equations.\n";
    std::vector<std::string> unknowns;
    std::string features;
    std::string calls;
    for (std::size_t i = 0; i < problem.size(); ++i) {
        const std::string title =
            " feature " + std::to_string(i + 1) + ": " + notation(problem[i]) + "\n";
        const std::vector<NamedVector> placed = vectors(problem[i], i + 1);
        features += "--" + title;
        for (const NamedVector& vector : placed) {
            append_unknowns(unknowns, vector.coordinates);
            features += vector.name + " = " + braces(vector.coordinates) + ";\n";
        }
        std::vector<std::string> seen;
        for (const Observation& observation : observations(problem[i]))
            seen.push_back(call(observation, placed));
        calls += "    --" + title;
        // What no view sees has no equations.
        if (seen.empty()) seen.push_back("{}");
        calls += list(seen, "    ") + (i + 1 < problem.size() ? ",\n" : "");
    }
    std::string cameras = "P1 = {rotation(0_R, 0_R, 0_R), {0_R, 0_R, 0_R}};\n";
    for (int view = 1; view < view_count(problem); ++view) {
        const NamedCamera next = camera(view);
        append_unknowns(unknowns, next.rotation);
        append_unknowns(unknowns, next.translation);
        cameras += next.name + " = {rotation(" + list(next.rotation, "") + "), " +
                   braces(next.translation) + "};\n";
    }
    return opening(problem) +
           "setRandomSeed 1;\nFF = ZZ/2147483647;\n-- The unknowns of the features, then " +
           "those of the cameras.\nfeatureUnknowns = " +
           std::to_string(feature_unknown_count(problem)) + ";\nR = FF[\n" +
           list(unknowns, "    ") + "];\n" + definitions + cameras +
           "\n-- Points X and directions D.\n" + features + equations +
           "\nequations = flatten {\n" + calls + "};\n" + ranks;
}

} // namespace plprove
