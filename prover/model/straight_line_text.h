// Polynomials in the data as lines of a program, in the syntax that Python and C++ share.
#pragma once

#include "prover/model/data_polynomial.h"

#include <string>
#include <utility>
#include <vector>

namespace plprove::model {

struct StraightLineText {
    /// Names `_1`, `_2`, ..., and expressions in data and names before them.
    std::vector<std::pair<std::string, std::string>> assignments;
    std::vector<std::string> values; ///< expressions, one for each step that is wanted
};

/// `data` has an expression for each scalar of data.
StraightLineText straight_line_text(const DataProgram& program,
                                    const std::vector<std::size_t>& wanted,
                                    const std::vector<std::string>& data);

} // namespace plprove::model
