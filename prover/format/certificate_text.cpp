#include "prover/format/certificate_text.h"

#include "prover/format/version.h"

namespace plprove {

namespace {

constexpr std::string_view continuation = " \\";

template <class Integer>
std::string written_coordinates(std::span<const Integer> values, std::size_t digits) {
    std::string text;
    for (const Integer value : values) {
        if (!text.empty()) text += ' ';
        text += with_digits(std::int64_t{value}, digits, "a coordinate");
    }
    return text;
}

} // namespace

std::string first_line(std::string_view kind) {
    std::string line = "plcert ";
    line.append(format_version).append(" ").append(kind);
    return line + '\n';
}

void append_line(std::string& text, std::string_view line) {
    while (line.size() > longest_line) {
        const std::size_t end = line.rfind(' ', longest_line - continuation.size());
        if (end == std::string_view::npos)
            throw FormatLimit(
                "a word of the certificate does not fit into a line of " +
                std::to_string(longest_line) +
                " bytes, the most that the format allows: ask about a smaller problem");
        text.append(line.substr(0, end)).append(continuation) += '\n';
        line.remove_prefix(end + 1);
    }
    text.append(line) += '\n';
}

std::string certificate_file(std::string_view kind, std::string_view lines,
                             std::string_view advice) {
    std::string file = first_line(kind);
    const std::size_t bytes = file.size() + lines.size();
    if (bytes <= largest_file) return file.append(lines);
    std::string message = "the certificate file would have " + std::to_string(bytes) +
                          " bytes, and the format allows " + std::to_string(largest_file) +
                          " (64 MiB): ";
    throw FormatLimit(message.append(advice));
}

std::string with_digits(std::string value, std::size_t most, std::string_view what) {
    const std::size_t digits = value.size() - (value.starts_with('-') ? 1 : 0);
    if (digits <= most) return value;
    std::string message(what);
    throw FormatLimit(message + " of the certificate has " + std::to_string(digits) +
                      " digits, and the format allows " + std::to_string(most) +
                      ": ask about a smaller problem, or try another seed");
}

std::string with_digits(std::int64_t value, std::size_t most, std::string_view what) {
    return with_digits(std::to_string(value), most, what);
}

std::string coordinates(std::span<const std::int64_t> values, std::size_t digits) {
    return written_coordinates(values, digits);
}

std::string coordinates(std::span<const int> values, std::size_t digits) {
    return written_coordinates(values, digits);
}

} // namespace plprove
