// A new kind of cameras is one file: the checker, linked with translating.cpp and a list of kinds
// that has it, decides problems of such cameras and counts their solutions.
#include "checker/cameras/camera_model.h"
#include "checker/degrees/krawczyk.h"
#include "checker/replay.h"
#include "tests/support/text.h"

#include <doctest/doctest.h>

using namespace checker;

namespace {

const Classification no_classes;

/// `holds`, or the first complaint.
std::string outcome(const std::string& kind, const std::string& records) {
    const ReplayedFile file = replay(no_classes, "file", "plcert 2 " + kind + '\n' + records);
    const auto complaint = [](const auto& content) -> std::string {
        if constexpr (requires { content.complaint; })
            return "syntax: " + content.complaint.reason;
        else if constexpr (requires { content.refusals; })
            return content.refusals.count > 0 ? content.refusals.first[0].reason : "holds";
        else
            return "no file";
    };
    return std::visit(complaint, file.content);
}

std::string outcome_of_record(const std::string& record) {
    return outcome("problems", "modulus 2305843009213693951\n" + record);
}

// Two points in two views. An independent program says that det J is -56160 here.
const std::string two_points = R"(problem translating: 2*P/P
minimal 2305843009213637791
camera 2 -3 4
scene 3 -2 5 -4 7 2
)";

// The translation is (1, 2, 3); the depths are 1 and 2.
const std::string solution = R"(problem translating: 2*P/P
view 1 2 1 3 1 2
view 2 4 4 5 5 8
real 0 2 3 1 2
)";

} // namespace

TEST_CASE("the list of kinds has those of the checker and the new ones") {
    std::vector<std::string_view> names;
    for (const CameraModel* model : camera_models())
        names.push_back(model->name);
    CHECK(names == std::vector<std::string_view>{"calibrated", "focal", "projective",
                                                 "shared-focal", "shared-focal-center", "shared-k",
                                                 "upright", "upright-focal", "upright-shared-focal",
                                                 "zooming", "translating"});
}

TEST_CASE("problems of a new kind are decided") {
    CHECK(outcome_of_record(two_points) == "holds");
    CHECK(
        contains(outcome_of_record(with(two_points, "791", "790")), "the minor is 2305843009213"));
    CHECK(contains(outcome_of_record(with(two_points, "camera 2", "camera 0")),
                   "the translation of camera 2 begins with 0"));
    // On one line with the centre of camera 1.
    CHECK(contains(outcome_of_record(with(two_points, "-4 7 2", "6 -4 10")), "the minor is 0"));
    CHECK(outcome_of_record(with(two_points, "camera 2 -3 4", "camera 2 -3 4 5"))
              .starts_with("syntax"));
    CHECK(outcome_of_record("problem translating: 3*P/P\nunbalanced\n") == "holds");
    CHECK(contains(outcome_of_record("problem translating: 2*P/P\nunbalanced\n"), "is balanced"));
    CHECK(outcome_of_record("problem turning: 2*P/P\nunbalanced\n").starts_with("syntax"));
}

TEST_CASE("conditions on images of a new kind are counted") {
    // Three points in two of three views satisfy one condition.
    const std::string part = "problem translating: 3*P/P/- + -/P/P + P/-/P\n"
                             "excess 1\n"
                             "part views 1 2 points 1 2 3 lines\n"
                             "motion none\n";
    CHECK(outcome_of_record(part) == "holds");
    CHECK(contains(outcome_of_record(with(part, "excess 1", "excess 2")), "the excess is 1"));
    CHECK(contains(outcome_of_record(with(part, "none\n", "plane views 2 points lines\n")),
                   "does not keep the image of point 1"));
}

TEST_CASE("solutions of a new kind are counted") {
    if (!has_arb) return;
    CHECK(outcome("solutions", solution) == "holds");
    CHECK(outcome("solutions", with(solution, "real 0 2 3", "real 0 2")).starts_with("syntax"));
    // Of such images in view 2, of the one point in view 1 twice, there are many or none.
    CHECK(contains(outcome("solutions", with(solution, "3 1 2", "1 2 1")), "no inverse"));
}

TEST_CASE("theorems on projective cameras say nothing of a new kind") {
    CHECK(contains(outcome("at-most", "problem translating: 2*P/P\nview 1 2 1 3 1 2\n"
                                      "view 2 4 4 5 5 8\nview 1 1 1 1 2 3\npowers 1 1\n"),
                   "its cameras are translating"));
}
