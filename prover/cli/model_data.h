// Data of a model as a JSON file: an object with an entry for each name of data, a number or nested
// lists of numbers as its shape says.
#pragma once

#include "prover/model/program.h"

#include <complex>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

namespace plprove {

/// The scalars of data as the program numbers them. Throws BadInput that says what is wrong in
/// which entry of the file `path`, and what belongs there.
std::vector<std::complex<double>> read_model_data(const model::Program& program,
                                                  const std::string& text, const std::string& path);

/// The file with these scalars.
std::string model_data_file(const model::Program& program, const std::vector<double>& data);

/// Nested lists of this shape, of the numbers from the first one on.
nlohmann::ordered_json nested_lists(const std::vector<int>& shape,
                                    const std::vector<nlohmann::ordered_json>& numbers,
                                    std::size_t first);

} // namespace plprove
