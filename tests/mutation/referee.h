// A second opinion on certificate files, by other means than the checker's: claims are decided by
// the prover's decision, Jacobians are built column by column from the motion of each unknown,
// minors and ranks are computed by FLINT from whole matrices, without elimination by features. It
// reads files leniently: a file that it finds proved may still violate the syntax.
#pragma once

#include "prover/problem/signature.h"

#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace referee {

/// A file as lines of words. Comments are gone, and lines that go on in others are one; `numbers`
/// are those of the lines in the file, of the first where one goes on.
struct Text {
    std::vector<std::vector<std::string>> lines;
    std::vector<std::size_t> numbers;
};
Text split(std::string_view file);

/// Why a problem file does not prove what it claims; nothing where it does.
std::optional<std::string> objection_to_problem(const Text& file);

/// Why the record on this line of a classification file does not prove its claim about the class of
/// this signature; nothing where it does.
std::optional<std::string> objection_to_record(const Text& file, std::size_t line,
                                               const plprove::Signature& signature);

/// The line in the file where the record of the class with this number begins, the first one; 0 if
/// there is none. Of a classification or a degree file.
std::size_t line_of_record(const Text& file, std::size_t class_number);

/// The determinant modulo q that the record on this line (an index of `lines`) should state, with
/// the features of its pool that it uses; nothing where that makes no sense.
std::optional<std::uint64_t> true_minor(const Text& file, std::size_t line,
                                        const std::optional<plprove::Signature>& signature);

} // namespace referee
