// The text of certificates, as certs/FORMAT.md section 5 has it.
#include "prover/format/certificate_text.h"
#include "prover/minimal/classification_file.h"
#include "prover/minimal/problem_certificate.h"

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

} // namespace plprove
