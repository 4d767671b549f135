// `plprove group` of a model.
#pragma once

#include "prover/cli/command.h"

#include <cstdint>
#include <string>

namespace plprove {

struct ModelGroupRequest {
    std::string file; ///< the text of the model
    std::string path; ///< of the certificate; empty if none is asked for
    std::uint64_t seed = 0;
    int fibres = 0; ///< the most that are computed
    bool json = false;
};

/// Prints the group by loops, and writes a certificate if one is asked for. The exit status.
int find_group_of_model(const ModelGroupRequest& request, const Deliver& deliver);

} // namespace plprove
