// `plprove solve` for models.
#pragma once

#include "prover/cli/command.h"

namespace plprove {

struct ModelSolveRequest {
    std::string model;
    std::string data;
    std::string path; ///< for the answer
    bool json = false;
    bool real = false; ///< leaves out solutions that are not real
    unsigned threads = 1;
};

/// Whether the argument names a file with a model.
bool names_model(const std::string& argument);

/// Solves the model for the data. The status of the program: 0 if there are solutions.
int solve_model(const ModelSolveRequest& request, const Deliver& deliver);

/// Writes data that have a real solution.
int write_example_data(const std::string& model, const std::string& path, const Deliver& deliver);

} // namespace plprove
