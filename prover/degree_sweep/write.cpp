#include "prover/degree_sweep/write.h"

namespace plprove {

namespace {

template <class Integers>
void append(std::string& text, const Integers& integers) {
    for (const auto integer : integers)
        (text += ' ') += std::to_string(integer);
}

void append_evidence(std::string& text, const std::optional<CompletenessEvidence>& evidence) {
    if (evidence)
        text += " evidence complete edges " + std::to_string(evidence->edges) + " trace " +
                (evidence->trace_exponent ? std::to_string(*evidence->trace_exponent) : "none") +
                '\n';
    else
        text += " evidence none\n";
}

void append_view(std::string& text, const ViewImage& view) {
    if (!view.point && view.lines.empty()) return;
    text += " view";
    if (view.point) append(text += " point", *view.point);
    for (const auto& line : view.lines)
        append(text += view.point ? " toward" : " line", line);
}

} // namespace

std::string write_record(const DegreeCertificate& certificate) {
    std::string text = "degree " + std::to_string(certificate.number);
    append_evidence(text, certificate.evidence);
    for (const FeatureImage& image : certificate.images) {
        text += "image " + notation(image.feature);
        for (const ViewImage& view : image.views)
            append_view(text, view);
        text += '\n';
    }
    for (const ApproximateSolution& solution : certificate.solutions) {
        text += (solution.real ? "real " : "pair ") + std::to_string(solution.bits);
        append(text, solution.values);
        text += '\n';
    }
    return text;
}

std::string write_degree_file(std::span<const DegreeCertificate> certificates) {
    std::string text(degree_file_head);
    for (const DegreeCertificate& certificate : certificates)
        text += write_record(certificate);
    return text;
}

} // namespace plprove
