#include "prover/three_views/degree_text.h"

#include "prover/format/certificate_text.h"
#include "prover/problem/notation.h"

namespace plprove {

namespace {

constexpr std::size_t digits_of_images = 18;
constexpr std::size_t digits_of_solutions = 18;

std::string words_of(const FeatureImage& image) {
    std::string words = notation(image.feature);
    for (const ViewImage& view : image.views) {
        if (!view.point && view.lines.empty()) continue;
        words += " view";
        if (view.point) words += " point " + coordinates(*view.point, digits_of_images);
        for (const std::array<std::int64_t, 3>& line : view.lines)
            words += (view.point ? " toward " : " line ") + coordinates(line, digits_of_images);
    }
    return words;
}

std::string words_of(const StartingValues& solution) {
    std::string words = std::to_string(solution.bits);
    for (const std::int64_t value : solution.values)
        words += ' ' + with_digits(value, digits_of_solutions, "a solution");
    return words;
}

} // namespace

std::string write_images(std::size_t number, std::span<const FeatureImage> images) {
    CertificateText text;
    text.line("degree", number, "evidence none");
    for (const FeatureImage& image : images)
        text.line("image", words_of(image));
    return text.take();
}

std::string write_record(const DegreeCertificate& certificate) {
    CertificateText text;
    for (const StartingValues& solution : certificate.solutions)
        text.line(solution.real ? "real" : "pair", words_of(solution));
    return write_images(certificate.number, certificate.images) + text.take();
}

std::string degree_file(std::string_view records) {
    return certificate_file("degrees", records, "ask for fewer solutions with --target");
}

std::string write_degree_file(std::span<const DegreeCertificate> certificates) {
    std::string records;
    for (const DegreeCertificate& certificate : certificates)
        records += write_record(certificate);
    return degree_file(records);
}

} // namespace plprove
