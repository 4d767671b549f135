#include "prover/scripts/camera_text.h"

#include "prover/system/exit.h"

#include <algorithm>
#include <array>
#include <string_view>

namespace plprove {

namespace {

/// What a kind of cameras has, as the table of certs/FORMAT.md, section 13, says.
struct Known {
    bool projective = false;
    bool upright = false; ///< turns about the second axis only
    int shared = 0;       ///< numbers of the conic
    bool own = false;     ///< a ratio of focal lengths of each camera

    /// The turn about the camera's axis is not in the rotation: it is (r, s), with the ratio.
    bool turns_apart() const { return own && !upright; }
};

Known known_of(const CameraModel& cameras) {
    struct Row {
        std::string_view name;
        Known kind;
    };
    static constexpr std::array rows{
        Row{"calibrated", {}},
        Row{"projective", {.projective = true}},
        Row{"shared-focal", {.shared = 1}},
        Row{"focal", {.shared = 1, .own = true}},
        Row{"shared-focal-center", {.shared = 3}},
        Row{"shared-k", {.shared = 5}},
        Row{"upright", {.upright = true}},
        Row{"upright-shared-focal", {.upright = true, .shared = 1}},
        Row{"upright-focal", {.upright = true, .shared = 1, .own = true}}};
    const auto row = std::ranges::find(rows, cameras.name, &Row::name);
    if (row == rows.end())
        throw BadInput("no model can be written for " + std::string(cameras.name) +
                       " cameras: write one yourself, as docs/models.md explains");
    return row->kind;
}

void append_conic(ModelText& text, int shared) {
    text.comment("W is the conic (K*transpose(K))^-1 for the calibration matrix K of camera 1, C "
                 "its adjugate. [M | t] is a camera up to a factor: M is a rotation of the conic.");
    if (shared == 1) {
        text.line("unknown e", "the square of the focal length of camera 1");
        text.line("let W = [[1, 0, 0], [0, 1, 0], [0, 0, e]]");
    } else if (shared == 3) {
        text.line("unknown b, c, e");
        text.line("let W = [[1, 0, b], [0, 1, c], [b, c, e]]");
    } else {
        text.line("unknown g, h, b, c, e");
        text.line("let W = [[1, g, b], [g, h, c], [b, c, e]]");
    }
    text.line("let C = [cross(W[2], W[3]), cross(W[3], W[1]), cross(W[1], W[2])]");
    text.line("nonzero det(W)");
}

/// The numbers of a camera without those of its position.
void append_unknowns(ModelText& text, const Known& kind, const std::string& n) {
    std::string names = kind.upright ? "b" + n : "q" + n;
    if (!kind.upright) names += kind.turns_apart() ? " : vector 2" : " : vector 3";
    if (kind.own) names += ", r" + n;
    if (kind.turns_apart()) names += ", s" + n;
    names += n == "2" ? ", d2 : vector 2" : ", t" + n + " : vector 3";
    text.line("unknown " + names);
    if (n == "2") text.line("let t2 = [1, d2[1], d2[2]]", "the scale of space is free");
}

void append_rotation(ModelText& text, const Known& kind, const std::string& n) {
    append_unknowns(text, kind, n);
    const std::string v = kind.upright ? "[0, b" + n + ", 0]" : "q" + n;
    text.line("let R" + n + " = rotation(" + v + ")", "a rotation up to a factor");
}

void append_rotation_of_conic(ModelText& text, const Known& kind, const std::string& n) {
    append_unknowns(text, kind, n);
    const std::string v = kind.upright || kind.turns_apart() ? "v" + n : "q" + n;
    if (kind.upright) text.line("let " + v + " = [0, b" + n + ", 0]");
    if (kind.turns_apart()) text.line("let " + v + " = [q" + n + "[1], q" + n + "[2], 0]");
    std::string matrix = "(det(W) - dot(" + v + ", W*" + v + "))*identity(3) + 2*transpose([" + v +
                         "])*[W*" + v + "] + 2*C*skew(" + v + ")";
    std::string nonzero = "det(W) + dot(" + v + ", W*" + v + ")";
    const std::string r = "r" + n, s = "s" + n;
    if (kind.turns_apart()) {
        matrix =
            "[[" + r + ", -" + s + ", 0], [" + s + ", " + r + ", 0], [0, 0, 1]]*(" + matrix + ")";
        nonzero += ", " + r + "^2 + " + s + "^2";
    } else if (kind.own) {
        matrix = "[[" + r + ", 0, 0], [0, " + r + ", 0], [0, 0, 1]]*(" + matrix + ")";
        nonzero += ", " + r;
    }
    text.line("let M" + n + " = " + matrix);
    text.line("nonzero " + nonzero);
}

void append_matrix(ModelText& text, const std::string& n) {
    if (n == "2") {
        text.comment("Space is moved so that camera 2 has the first row (0, 0, 0, 1).");
        text.line("unknown p2[1..7]");
        text.line("let M2 = [[0, 0, 0], [1, p2[1], p2[2]], [p2[4], p2[5], p2[6]]]");
        text.line("let t2 = [1, p2[3], p2[7]]");
        return;
    }
    text.line("unknown p" + n + "[1..8], t" + n + " : vector 3");
    const std::string p = "p" + n;
    text.line("let M" + n + " = [[1, " + p + "[1], " + p + "[2]], [" + p + "[3], " + p + "[4], " +
              p + "[5]], [" + p + "[6], " + p + "[7], " + p + "[8]]]");
}

/// What determines camera n, and is determined by it.
std::string numbers_of(const Known& kind, const std::string& n) {
    const std::string position = n == "2" ? "d2" : "t" + n;
    if (kind.projective) return n == "2" ? "p2" : "p" + n + ", " + position;
    return (kind.upright ? "b" : "q") + n + (kind.own ? ", r" + n : "") +
           (kind.turns_apart() ? ", s" + n : "") + ", " + position;
}

} // namespace

std::string append_cameras(ModelText& text, const Problem& problem) {
    const Known kind = known_of(*problem.cameras);
    text.line("");
    text.comment("Camera 1 is [I | 0].");
    if (kind.shared > 0) append_conic(text, kind.shared);
    for (int view = 2; view <= problem.views; ++view) {
        const std::string n = std::to_string(view);
        if (kind.projective)
            append_matrix(text, n);
        else if (kind.shared > 0)
            append_rotation_of_conic(text, kind, n);
        else
            append_rotation(text, kind, n);
    }
    return kind.projective || kind.shared > 0 ? "M" : "R";
}

void append_counts(ModelText& text, const Problem& problem) {
    const Known kind = known_of(*problem.cameras);
    text.line("");
    text.comment("Solutions with the same cameras are one.");
    if (kind.shared > 0)
        text.line(kind.shared == 1   ? "count e"
                  : kind.shared == 3 ? "count b, c, e"
                                     : "count g, h, b, c, e");
    for (int view = 2; view <= problem.views; ++view)
        text.line("count " + numbers_of(kind, std::to_string(view)));
}

} // namespace plprove
