// The text of templates, as certs/FORMAT.md section 10 has it.
#include "prover/format/certificate_text.h"
#include "prover/solver/templates/template.h"

namespace plprove::templates {

namespace {

/// The word, and the vector that it announces.
std::string named(const char* word, const Vector3& vector) {
    return word + (' ' + coordinates(vector));
}

std::vector<std::size_t> numbered_from_one(std::vector<std::size_t> indices) {
    for (std::size_t& index : indices)
        ++index;
    return indices;
}

void append(CertificateText& text, const RegistrationData& data) {
    for (const auto& star : data.stars) {
        std::vector<std::string> pins;
        for (const auto& pin : star.pins) {
            pins.push_back(named("pin", pin.direction));
            pins.push_back(named("toward", pin.toward));
        }
        text.line("star", named("point", star.point), named("image", star.image), pins);
    }
    for (const auto& line : data.lines)
        text.line("line", named("point", line.point), named("direction", line.direction),
                  named("image", line.image));
    for (const auto& incidence : data.incidences)
        text.line("incidence", named("point", incidence.point), named("line", incidence.image));
    for (const auto& group : data.groups) {
        std::vector<std::string> rays;
        for (const auto& ray : group.rays) {
            rays.push_back(named("direction", ray.direction));
            rays.push_back(named("image", ray.image));
        }
        text.line("transversals", named("point", group.point), rays);
    }
}

void append(CertificateText& text, const Template& proof) {
    std::vector<int> degree{proof.degree[0]};
    if (proof.frame != Frame::general) degree.push_back(proof.degree[1]);
    text.line("template", name(proof.frame), "degree", degree);
    append(text, proof.data);
    text.line("basis", numbered_from_one(proof.basis));
    for (const auto& [equation, monomials] : proof.rows)
        text.line("rows", equation + 1, numbered_from_one(monomials));
    text.line("minor", proof.minor);
}

} // namespace

std::string write(const std::vector<Template>& templates) {
    CertificateText text;
    text.line("modulus", modulus);
    for (const Template& proof : templates)
        append(text, proof);
    return certificate_file("bounds", text.take(), "write fewer templates");
}

} // namespace plprove::templates
