// The text of certificates of minimality, as certs/FORMAT.md has it in sections 5, 7 and 13.
#include "prover/format/certificate_text.h"
#include "prover/minimal/classification_file.h"
#include "prover/minimal/problem_certificate.h"
#include "prover/minimal/problem_record.h"
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

void append_record(CertificateText& text, const std::string& number, std::size_t pool,
                   const MinimalCertificate& certificate) {
    text.line("minimal", number, pool + 1, certificate.minor);
}

void append_record(CertificateText& text, const std::string& number, std::size_t pool,
                   const CameraMinimalCertificate& certificate) {
    text.line("camera-minimal", number, pool + 1);
    text.line("delete columns", certificate.deleted_columns);
    text.line("minor", certificate.minor);
}

void append_record(CertificateText& text, const std::string& number, std::size_t pool,
                   const DeficientCertificate& certificate) {
    const Obstruction& why = certificate.obstruction;
    text.line("deficient", number, pool + 1, "rank", camera_dimension - why.deficiency(), "excess",
              why.excess, "star", why.star);
    text.line("delete rows", certificate.deleted_rows, "columns", certificate.deleted_columns);
    text.line("minor", certificate.minor);
    for (const std::vector<std::string>& vector : certificate.kernel) {
        std::vector<std::string> entries;
        for (const std::string& entry : vector)
            entries.push_back(with_digits(entry, digits_of_kernel_entries, "a kernel entry"));
        text.line("kernel", entries);
    }
}

void append_record(CertificateText&, const std::string&, std::size_t, const std::monostate&) {}

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

struct WriteEvidence {
    CertificateText& text;

    void operator()(const FullRank& evidence) const {
        text.line("minimal", evidence.minor);
        for (const std::vector<std::int64_t>& camera : evidence.instance.cameras)
            text.line("camera", coordinates(camera));
        text.line("scene", coordinates(evidence.instance.scene));
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
    }

    void write_motion(const CameraMotion& motion) const {
        if (motion.kind == MotionKind::none) return text.line("motion none");
        const std::string kind = motion.kind == MotionKind::plane
                                     ? "plane"
                                     : "star " + std::to_string(motion.centre + 1);
        text.line("motion", kind, "views", numbered_views(motion.moving), "points",
                  numbered(motion.points), "lines", numbered(motion.lines));
    }
};

std::string problems_file(std::span<const ProblemRecord> certificates, CertificateText text) {
    append_modulus(text);
    for (const ProblemRecord& certificate : certificates) {
        text.line("problem", notation(certificate.problem));
        std::visit(WriteEvidence{text}, certificate.evidence);
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
    for (const Record& record : file.records)
        std::visit(
            [&](const auto& held) {
                append_record(text, std::to_string(record.number), record.pool, held);
            },
            record.certificate);
    return certificate_file("classification", text.take(), "certify fewer classes");
}

std::string write(const ProblemCertificate& certificate) {
    const Decision& decision = certificate.decision;
    CertificateText text;
    text.line("problem", notation(decision.problem));
    for (const ReductionStep& step : decision.reduction.steps)
        append_step(text, step);
    append_verdict(text, decision);
    if (std::holds_alternative<std::monostate>(certificate.evidence))
        return certificate_file("problem", text.take(), smaller_problem);
    append_modulus(text);
    text.line("pool", 1);
    append_cameras(text, certificate.cameras);
    for (const PlacedFeature& placed : certificate.features)
        append_feature(text, placed);
    const std::string number =
        decision.classes ? std::to_string(decision.classes->label) : std::string("-");
    std::visit([&](const auto& held) { append_record(text, number, 0, held); },
               certificate.evidence);
    return certificate_file("problem", text.take(), smaller_problem);
}

std::string write(std::span<const ProblemRecord> certificates) {
    return problems_file(certificates, {});
}

std::string write(std::span<const ProblemRecord> certificates, const Family& family) {
    CertificateText text;
    text.line("family", std::string(family.name));
    return problems_file(certificates, std::move(text));
}

} // namespace plprove
