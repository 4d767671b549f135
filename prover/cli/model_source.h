// Files with models, as commands read them.
#pragma once

#include "prover/model/certificate.h"

#include <string>
#include <vector>

namespace plprove {

/// The text of a model, and the comments before its first statement.
struct ModelSource {
    std::string text;
    std::vector<std::string> comments;
};

/// Reads a file, or standard input for `-`. Throws BadInput if that cannot be done.
ModelSource read_model_source(const std::string& path);

/// What `work` does with the text of this file; says in which file a model is not well-formed.
template <class Work>
auto in_model_file(const std::string& path, const Work& work) {
    try {
        return work();
    } catch (const model::ModelError& error) {
        throw BadInput((path == "-" ? "standard input" : path) + ", " + error.what());
    }
}

/// How to find all solutions modulo a prime: by a Gröbner basis, or by paths and many digits
/// (lifted_fibre.h).
enum class Fibres : std::uint8_t { by_basis, by_lifting };

/// model::study, with a progress meter.
model::Study studied(const std::string& text, Fibres fibres = Fibres::by_basis);

} // namespace plprove
