// Elimination templates: multiples of the equations of a registration problem that express all
// monomials up to a degree by those of a basis. The number of solutions is at most the number of
// elements of the basis (proofs/registrations.md, section 5).
#pragma once

#include "prover/solver/templates/equations.h"

#include <optional>
#include <utility>

namespace plprove::templates {

struct Template {
    Frame frame = Frame::general;
    RegistrationData data;
    BiDegree degree{};              // of the monomials that are the columns
    std::vector<std::size_t> basis; // indices of columns
    /// The rows: for equations, by index, the indices of the monomials that they are multiplied by.
    std::vector<std::pair<std::size_t, std::vector<std::size_t>>> rows;
};

/// A template with as small a basis as degrees up to 5, or 6 on circles, give, the smallest
/// such; with this frame and data. Nothing if there is none.
std::optional<Template> find_template(const RegistrationData& data, Frame frame);

/// Of all frames that suit the type; the first of the smallest. Nothing if there is none.
std::optional<Template> best_template(const Registration& type);

} // namespace plprove::templates
