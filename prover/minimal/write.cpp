// The text of certificates of minimality, as certs/FORMAT.md has it in sections 5, 7 and 13.
#include "prover/format/certificate_text.h"
#include "prover/minimal/classification_file.h"
#include "prover/minimal/problem_file.h"
#include "prover/problem/notation.h"

namespace plprove {

namespace {

constexpr std::size_t digits_of_kernel_entries = 1000;
constexpr const char* smaller_problem = "ask about a problem with fewer features";

void append_modulus(CertificateText& text) {
    text.line("modulus", modulus);
}

void append_cameras(CertificateText& text, const Cameras& cameras) {
    for (std::size_t i = 0; i < cameras.size(); ++i)
        text.line("camera", i + 2, "quaternion", coordinates(cameras[i].quaternion), "translation",
                  coordinates(cameras[i].translation));
}

void append_feature(CertificateText& text, const PlacedFeature& placed) {
    std::vector<std::string> pins;
    for (const Vector3& direction : placed.directions) {
        pins.emplace_back("pin");
        pins.push_back(coordinates(direction));
    }
    text.line("feature", notation(placed.feature), "point", coordinates(placed.point), pins);
}

void append_kernel(CertificateText& text, const Minor& minor) {
    for (const std::vector<std::string>& vector : minor.kernel) {
        std::vector<std::string> entries;
        for (const std::string& entry : vector)
            entries.push_back(with_digits(entry, digits_of_kernel_entries, "a kernel entry"));
        text.line("kernel", entries);
    }
}

/// The record of section 5 or 7 with this number, or `-`, and the pool of this index.
void append_record(CertificateText& text, const std::string& number, std::size_t pool,
                   const Minor& minor) {
    const std::string word = name(minor);
    if (word == "minimal") return text.line(word, number, pool + 1, minor.value);
    if (word == "deficient") {
        const Obstruction& why = minor.obstruction;
        text.line(word, number, pool + 1, "rank", camera_dimension - why.deficiency(), "excess",
                  why.excess, "star", why.star);
        text.line("delete rows", minor.deleted_rows, "columns", minor.deleted_columns);
    } else {
        text.line(word, number, pool + 1);
        text.line("delete columns", minor.deleted_columns);
    }
    text.line("minor", minor.value);
    append_kernel(text, minor);
}

void append_verdict(CertificateText& text, const Decision& decision) {
    const int excess = decision.constraints - decision.camera_dimension;
    if (excess == 0)
        text.line("verdict", std::string(name(decision.verdict)));
    else
        text.line("verdict", std::string(name(decision.verdict)), std::abs(excess));
}

void append_step(CertificateText& text, const ReductionStep& step) {
    text.line("reduce", step.position + 1, std::string(name(step.rule)),
              step.after ? notation(*step.after) : "nothing");
}

/// The numbers from 1 of what is counted from 0.
std::vector<std::string> numbered(std::span<const int> numbers) {
    std::vector<std::string> words;
    for (const int number : numbers)
        words.push_back(std::to_string(number + 1));
    return words;
}

std::vector<std::string> numbered_views(ViewSet views) {
    std::vector<std::string> words;
    for (int view = 0; view < most_views; ++view)
        if (contains(views, view)) words.push_back(std::to_string(view + 1));
    return words;
}

/// Writes the claim of a record of section 13.
struct WriteClaim {
    CertificateText& text;

    void operator()(const Minor& minor) const {
        text.line("minimal", minor.value);
        if (!minor.instance.shared.empty()) text.line("shared", coordinates(minor.instance.shared));
        for (const Coordinates& camera : minor.instance.cameras)
            text.line("camera", coordinates(camera));
        text.line("scene", coordinates(minor.instance.scene));
    }

    void operator()(const Unbalanced&) const { text.line("unbalanced"); }

    void operator()(const FourCollinear& reason) const {
        text.line("collinear", numbered(reason.points), "views", numbered(reason.views));
    }

    void operator()(const OverconstrainedPart& reason) const {
        text.line("excess", reason.excess);
        const Subproblem& part = reason.part;
        text.line("part views", numbered_views(part.views), "points", numbered(part.points),
                  "lines", numbered(part.lines));
        write_motion(reason.motion);
        const Subproblem& core = reason.motion.core;
        if (core.views != 0)
            text.line("core views", numbered_views(core.views), "points", numbered(core.points),
                      "lines", numbered(core.lines));
    }

    void write_directions(const std::vector<std::array<int, 2>>& joins) const {
        std::vector<std::string> words;
        if (!joins.empty()) words.emplace_back("joins");
        for (const auto& join : joins)
            for (const int point : join)
                words.push_back(std::to_string(point + 1));
        text.line("motion directions", words);
    }

    void write_motion(const CameraMotion& motion) const {
        const std::string motion_of = motion.projective ? "motion projective" : "motion";
        if (motion.kind == MotionKind::none) return text.line(motion_of, "none");
        if (motion.kind == MotionKind::pencils)
            return text.line(motion_of, "pencils", motion.centre + 1);
        if (motion.kind == MotionKind::directions) return write_directions(motion.joins);
        if (motion.kind == MotionKind::camera)
            return text.line(motion_of, "camera", numbered_views(motion.moving));
        if (motion.kind == MotionKind::loose)
            return text.line(motion_of, "loose points", numbered(motion.points), "lines",
                             numbered(motion.lines));
        const std::optional<int> centre = point_of_star(motion);
        if (motion.kind == MotionKind::central && !centre) return write_elements(motion, motion_of);
        text.line(motion_of, centre ? "star " + std::to_string(*centre + 1) : "plane", "views",
                  numbered_views(moving_views(motion)), "points", numbered(motion.points), "lines",
                  numbered(motion.lines));
    }

    void write_elements(const CameraMotion& motion, const std::string& motion_of) const {
        text.line(motion_of, "central points", numbered(motion.points), "lines",
                  numbered(motion.lines));
        for (const CentralElement& element : motion.elements) {
            const char* const kind = element.kind == CentralElement::Centre::point  ? "point"
                                     : element.kind == CentralElement::Centre::line ? "line"
                                     : element.kind == CentralElement::Centre::axis ? "axis"
                                                                                    : "view";
            const bool own = !element.points.empty() || !element.lines.empty();
            const std::vector<std::string> none;
            text.line("about", kind, element.centre + 1, "views", numbered_views(element.views),
                      own ? std::vector<std::string>{"points"} : none, numbered(element.points),
                      own ? std::vector<std::string>{"lines"} : none, numbered(element.lines));
        }
    }
};

std::string problems_file(std::span<const ProblemRecord> certificates, CertificateText text) {
    append_modulus(text);
    for (const ProblemRecord& certificate : certificates) {
        text.line("problem", notation(certificate.problem));
        std::visit(WriteClaim{text}, certificate.claim);
    }
    return certificate_file("problems", text.take(), "certify fewer problems");
}

} // namespace

std::string write(const ClassificationFile& file) {
    CertificateText text;
    text.line(
        "# A certificate for each label class of balanced point-line problems in three views.");
    text.line("# certs/FORMAT.md of the project point-line-certificates explains every line.");
    append_modulus(text);
    for (std::size_t i = 0; i < file.pools.size(); ++i) {
        text.line("pool", i + 1);
        append_cameras(text, file.pools[i].cameras);
        for (const auto& instances : file.pools[i].instances)
            for (const PlacedFeature& placed : instances)
                append_feature(text, placed);
    }
    for (const ClassRecord& record : file.records)
        append_record(text, std::to_string(record.number), record.pool, record.minor);
    return certificate_file("classification", text.take(), "certify fewer classes");
}

std::string write(const ProblemFile& file) {
    const Decision& decision = file.decision;
    CertificateText text;
    text.line("problem", notation(decision.problem));
    for (const ReductionStep& step : decision.reduction.steps)
        append_step(text, step);
    append_verdict(text, decision);
    if (const auto* minor = std::get_if<Minor>(&file.claim)) {
        append_modulus(text);
        text.line("pool", 1);
        append_cameras(text, file.cameras);
        for (const PlacedFeature& placed : file.features)
            append_feature(text, placed);
        append_record(text, decision.classes ? std::to_string(decision.classes->label) : "-", 0,
                      *minor);
    }
    return certificate_file("problem", text.take(), smaller_problem);
}

std::string write(std::span<const ProblemRecord> certificates) {
    return problems_file(certificates, {});
}

std::string write(std::span<const ProblemRecord> certificates, const CameraModel& family) {
    CertificateText text;
    text.line("family", std::string(family_name(family)));
    return problems_file(certificates, std::move(text));
}

} // namespace plprove
