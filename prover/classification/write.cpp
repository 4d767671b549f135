// The text of certificates, as certs/FORMAT.md section 5 has it.
#include "prover/classification/classification_file.h"
#include "prover/classification/problem_certificate.h"

#include <type_traits>

namespace plprove {

namespace {

class Text {
public:
    /// One line: the words, separated by blanks.
    template <class... Words>
    void line(const Words&... words) {
        (append(words), ...);
        text_.back() = '\n';
    }
    std::string take() { return std::move(text_); }

private:
    void append(const char* word) { (text_ += word) += ' '; }
    void append(const std::string& word) { (text_ += word) += ' '; }
    template <class Integer>
    requires std::is_integral_v<Integer>
    void append(Integer number) { append(std::to_string(number)); }
    template <class Range>
    requires requires(const Range& range) { range.begin(); }
    void append(const Range& range) {
        for (const auto& word : range)
            append(word);
    }

    std::string text_;
};

void append_head(Text& text, const char* kind) {
    text.line("plcert 1", kind);
}

void append_modulus(Text& text) {
    text.line("modulus", modulus);
}

void append_cameras(Text& text, const Cameras& cameras) {
    for (std::size_t i = 0; i < cameras.size(); ++i)
        text.line("camera", i + 2, "quaternion", cameras[i].quaternion, "translation",
                  cameras[i].translation);
}

void append_feature(Text& text, const PlacedFeature& placed) {
    std::vector<std::string> pins;
    for (const Vector3& direction : placed.directions) {
        pins.emplace_back("pin");
        for (const std::int64_t coordinate : direction)
            pins.push_back(std::to_string(coordinate));
    }
    text.line("feature", notation(placed.feature), "point", placed.point, pins);
}

void append_record(Text& text, const std::string& number, std::size_t pool,
                   const MinimalCertificate& certificate) {
    text.line("minimal", number, pool + 1, certificate.minor);
}

void append_record(Text& text, const std::string& number, std::size_t pool,
                   const CameraMinimalCertificate& certificate) {
    text.line("camera-minimal", number, pool + 1);
    text.line("delete columns", certificate.deleted_columns);
    text.line("minor", certificate.minor);
}

void append_record(Text& text, const std::string& number, std::size_t pool,
                   const DeficientCertificate& certificate) {
    const Obstruction& why = certificate.obstruction;
    text.line("deficient", number, pool + 1, "rank", camera_dimension - why.deficiency(), "excess",
              why.excess, "star", why.star);
    text.line("delete rows", certificate.deleted_rows, "columns", certificate.deleted_columns);
    text.line("minor", certificate.minor);
    for (const auto& vector : certificate.kernel)
        text.line("kernel", vector);
}

void append_record(Text&, const std::string&, std::size_t, const std::monostate&) {}

void append_verdict(Text& text, const Decision& decision) {
    const int excess = decision.constraints - decision.camera_dimension;
    if (excess == 0)
        text.line("verdict", std::string(name(decision.verdict)));
    else
        text.line("verdict", std::string(name(decision.verdict)), std::abs(excess));
}

void append_step(Text& text, const ReductionStep& step) {
    text.line("reduce", step.position + 1, std::string(name(step.rule)),
              step.after ? notation(*step.after) : "nothing");
}

} // namespace

std::string write(const ClassificationFile& file) {
    Text text;
    append_head(text, "classification");
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
    return text.take();
}

std::string write(const ProblemCertificate& certificate) {
    const Decision& decision = certificate.decision;
    Text text;
    append_head(text, "problem");
    text.line("problem", notation(decision.problem));
    for (const ReductionStep& step : decision.reduction.steps)
        append_step(text, step);
    append_verdict(text, decision);
    if (std::holds_alternative<std::monostate>(certificate.evidence)) return text.take();
    append_modulus(text);
    text.line("pool", 1);
    append_cameras(text, certificate.cameras);
    for (const PlacedFeature& placed : certificate.features)
        append_feature(text, placed);
    const std::string number =
        decision.classes ? std::to_string(decision.classes->label) : std::string("-");
    std::visit([&](const auto& held) { append_record(text, number, 0, held); },
               certificate.evidence);
    return text.take();
}

} // namespace plprove
