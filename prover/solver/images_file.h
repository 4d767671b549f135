// Images as a JSON file (docs/solve.md).
#pragma once

#include "prover/solver/images.h"

namespace plprove {

/// Reads the images of `problem`; nothing stands for the problem that the file names. `name` names
/// the file in messages. Throws BadInput: what is wrong, and where.
GivenImages read_images(const std::string& text, const std::string& name,
                        const std::optional<ImagedProblem>& problem);

/// The number that is written as a decimal (-1.25e-3) or as a fraction (1/3); nothing if the text
/// is neither, or has more than 100 characters or an exponent beyond 100.
std::optional<mpq_class> exact_number(const std::string& text);

} // namespace plprove
