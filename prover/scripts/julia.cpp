#include "prover/scripts/model.h"
#include "prover/scripts/scripts.h"

namespace plprove {

namespace {

std::string opening(const Features& problem, int unknowns) {
    const std::string sign = "#";
    return comment(sign, "The point-line problem " + notation(problem)) + "#\n" +
           comment(
               sign,
               "This script sets up the equations of the problem for HomotopyContinuation.jl, with "
               "the images as parameters: " +
                   std::to_string(equation_count(problem)) + " equations in " +
                   std::to_string(unknowns) +
                   " unknowns. It makes a start pair, the images of a random complex scene, "
                   "checks it, and prints the rank of the Jacobian there.") +
           "#\n"
           "# Run it with:  julia FILE\n"
           "# after, once:  julia -e 'using Pkg; Pkg.add(\"HomotopyContinuation\")'\n\n";
}

const char* const definitions = R"script(using HomotopyContinuation, LinearAlgebra, Random

# A camera is a pair of a rotation, up to scale that of the quaternion (1, a, b, c), and a translation.
rotation(a, b, c) = [
    1+a^2-b^2-c^2 2*(a*b-c) 2*(a*c+b)
    2*(a*b+c) 1-a^2+b^2-c^2 2*(b*c-a)
    2*(a*c-b) 2*(b*c+a) 1-a^2-b^2+c^2
]
turn(P, D) = [P[1][i, 1] * D[1] + P[1][i, 2] * D[2] + P[1][i, 3] * D[3] for i in 1:3]
see(P, X) = turn(P, X) + P[2]

# Images. A point is (x, y); a line is y = m*x + c; a line through a seen point needs m only.
line_through(x, e) = [-(x[2]*e[3] - x[3]*e[2]), -(x[1]*e[2] - x[2]*e[1])] / (x[3]*e[1] - x[1]*e[3])
point_image(P, X) = see(P, X)[1:2] / see(P, X)[3]
pin_image(P, X, D) = line_through(see(P, X), turn(P, D))[1:1]
line_image(P, X, D) = line_through(see(P, X), turn(P, D))

# Equations. Each takes what is seen: q a point, m a slope, l a line.
on_line(x, m, c) = x[2] - m*x[1] - c*x[3]
point_equations(P, X, q) = [see(P, X)[1] - q[1]*see(P, X)[3], see(P, X)[2] - q[2]*see(P, X)[3]]
pin_equations(P, D, q, m) = [on_line(turn(P, D), m, q[2] - m*q[1])]
line_equations(P, X, D, l) = [on_line(see(P, X), l[1], l[2]), on_line(turn(P, D), l[1], l[2])]

)script";

/// Writes unknowns as z[1], z[2], ... in the order in which it meets them.
class Numbering {
public:
    std::string join(const std::vector<std::string>& coordinates) {
        std::string text;
        for (const std::string& name : coordinates)
            text += (text.empty() ? "" : ", ") +
                    (name == "1" ? name : "z[" + std::to_string(++count_) + "]");
        return text;
    }
    int count() const { return count_; }

private:
    int count_ = 0;
};

/// The calls for the images of a feature and for its equations.
struct Calls {
    std::vector<std::string> images;
    std::vector<std::string> equations;
};

/// Element `first` (from 1) of a vector, or `size` elements from there.
std::string range(const std::string& name, int first, int size) {
    const std::string begin = std::to_string(first);
    return name + "[" + begin + (size > 1 ? ":" + std::to_string(first + size - 1) : "") + "]";
}

/// With `parameters` used before it, a number that grows by the parameters of the feature.
Calls calls(const Feature& feature, const std::vector<NamedVector>& placed, int& parameters) {
    Calls result;
    std::string point; // the image of the point in the view at hand
    for (const Observation& observation : observations(feature)) {
        const std::string camera_name = "P" + std::to_string(observation.view + 1) + ", ";
        const std::string seen = range("p", parameters + 1, observation.equations());
        const std::string& position = placed[0].name;
        parameters += observation.equations();
        if (observation.kind == Observation::point) {
            point = seen;
            result.images.push_back("point_image(" + camera_name + position + ")");
            result.equations.push_back("point_equations(" + camera_name + position + ", " + seen +
                                       ")");
            continue;
        }
        const std::string& direction = placed[static_cast<std::size_t>(observation.index) + 1].name;
        const std::string line = position + ", " + direction;
        if (observation.kind == Observation::pin) {
            result.images.push_back("pin_image(" + camera_name + line + ")");
            result.equations.push_back("pin_equations(" + camera_name + direction + ", " + point +
                                       ", " + seen + ")");
        } else {
            result.images.push_back("line_image(" + camera_name + line + ")");
            result.equations.push_back("line_equations(" + camera_name + line + ", " + seen + ")");
        }
    }
    return result;
}

std::string closing(int equations, int unknowns) {
    std::string text = "@var z[1:" + std::to_string(unknowns) +
                       "] p[1:" + std::to_string(equations) +
                       "]\n"
                       "F = System(equations(z, p); variables = z, parameters = p)\n\n"
                       "# The start pair: a random scene and its images.\n"
                       "Random.seed!(1)\n"
                       "z0 = randn(ComplexF64, " +
                       std::to_string(unknowns) +
                       ")\n"
                       "p0 = images(z0)\n"
                       "println(\"equations  \", length(equations(z0, p0)))\n"
                       "println(\"unknowns   \", length(z0))\n"
                       "println(\"residual   \", maximum(abs, equations(z0, p0)))\n"
                       "println(\"rank       \", rank(jacobian(F, z0, p0)))\n\n";
    if (equations == unknowns)
        return text +
               comment(
                   "#",
                   "If the rank is that number, the problem is minimal and its degree is the "
                   "number of solutions, which monodromy finds from the start pair (it may take "
                   "long, and it may stop too early):") +
               "# result = monodromy_solve(F, [z0], p0)\n"
               "# println(result)\n"
               "# parameters of your own: solve(F, solutions(result); start_parameters = p0, "
               "target_parameters = p1)\n";
    return text +
           comment("#", "The system is not square, so the problem is not minimal and "
                        "the call that counts the solutions of a minimal one does not apply:") +
           "# result = monodromy_solve(F, [z0], p0)\n";
}

} // namespace

std::string julia_script(const Features& problem) {
    Numbering unknowns;
    if (equation_count(problem) == 0)
        return opening(problem, feature_unknown_count(problem) + camera_unknown_count(problem)) +
               "# No view sees anything: there are no equations.\n";
    int parameters = 0;
    std::vector<std::string> names;
    std::string world;
    std::string images;
    std::string equations;
    for (std::size_t i = 0; i < problem.size(); ++i) {
        const std::string title =
            "# feature " + std::to_string(i + 1) + ": " + notation(problem[i]) + "\n";
        const std::vector<NamedVector> placed = vectors(problem[i], i + 1);
        world += "    " + title;
        for (const NamedVector& vector : placed) {
            names.push_back(vector.name);
            world += "    " + vector.name + " = [" + unknowns.join(vector.coordinates) + "]\n";
        }
        const Calls seen = calls(problem[i], placed, parameters);
        if (seen.images.empty()) continue;
        images += "        " + title + list(seen.images, "        ") + ",\n";
        equations += "        " + title + list(seen.equations, "        ") + ",\n";
    }
    names.push_back("P1");
    world += "    # cameras\n    P1 = (rotation(0, 0, 0), [0, 0, 0])\n";
    for (int view = 1; view < view_count(problem); ++view) {
        const NamedCamera next = camera(view);
        names.push_back(next.name);
        world += "    " + next.name + " = (rotation(" + unknowns.join(next.rotation) + "), [";
        world += unknowns.join(next.translation) + "])\n";
    }
    const std::string tuple = "(\n" + list(names, "        ") + ",\n    )";
    return opening(problem, unknowns.count()) + definitions +
           "# The unknowns z: points X, directions D and cameras P.\nfunction world(z)\n" + world +
           "    return " + tuple +
           "\nend\n\n# The images of a scene: the parameters p.\nfunction images(z)\n    " + tuple +
           " = world(z)\n    return reduce(vcat, [\n" + images +
           "    ])\nend\n\n# The equations of the problem: p are the images of z.\nfunction "
           "equations(z, p)\n    " +
           tuple + " = world(z)\n    return reduce(vcat, [\n" + equations + "    ])\nend\n\n" +
           closing(parameters, unknowns.count());
}

} // namespace plprove
