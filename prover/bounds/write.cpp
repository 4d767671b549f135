// The text of templates, as certs/FORMAT.md section 10 has it.
#include "prover/bounds/template.h"

namespace plprove::bounds {

namespace {

class Text {
public:
    void words(const std::string& word) { text_ += word + ' '; }
    void words(Residue number) { words(std::to_string(number)); }
    void words(const Vector3& vector) {
        for (const std::int64_t coordinate : vector)
            words(std::to_string(coordinate));
    }
    template <class... Words>
    requires(sizeof...(Words) > 1) void words(const Words&... all) { (words(all), ...); }
    void end_line() { text_.back() = '\n'; }
    std::string take() { return std::move(text_); }

private:
    std::string text_;
};

void append(Text& text, const RegistrationData& data) {
    using namespace std::string_literals;
    for (const auto& star : data.stars) {
        text.words("star point"s, star.point, "image"s, star.image);
        for (const auto& pin : star.pins)
            text.words("pin"s, pin.direction, "toward"s, pin.toward);
        text.end_line();
    }
    for (const auto& line : data.lines) {
        text.words("line point"s, line.point, "direction"s, line.direction, "image"s, line.image);
        text.end_line();
    }
    for (const auto& incidence : data.incidences) {
        text.words("incidence point"s, incidence.point, "line"s, incidence.line);
        text.end_line();
    }
    for (const auto& group : data.groups) {
        text.words("transversals point"s, group.point);
        for (const auto& ray : group.rays)
            text.words("direction"s, ray.direction, "image"s, ray.image);
        text.end_line();
    }
}

void append(Text& text, const Template& proof) {
    text.words("template", name(proof.frame), "degree");
    text.words(static_cast<Residue>(proof.degree[0]));
    if (proof.frame != Frame::general) text.words(static_cast<Residue>(proof.degree[1]));
    text.end_line();
    append(text, proof.data);
    text.words("basis");
    for (const std::size_t monomial : proof.basis)
        text.words(monomial + 1);
    text.end_line();
    for (const auto& [equation, monomials] : proof.rows) {
        text.words("rows", std::to_string(equation + 1));
        for (const std::size_t monomial : monomials)
            text.words(monomial + 1);
        text.end_line();
    }
    text.words("minor", std::to_string(proof.minor));
    text.end_line();
}

} // namespace

std::string write(const std::vector<Template>& templates) {
    Text text;
    text.words("plcert 1 bounds");
    text.end_line();
    text.words("modulus", std::to_string(modulus));
    text.end_line();
    for (const Template& proof : templates)
        append(text, proof);
    return text.take();
}

} // namespace plprove::bounds
