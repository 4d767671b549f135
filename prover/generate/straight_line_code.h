// Expressions (prover/model/solver/expressions.h) as statements of C++.
#pragma once

#include "prover/model/solver/expressions.h"

#include <string>
#include <vector>

namespace plprove::generate {

/// A number with all its digits, as a literal of type double.
std::string literal(double value);

/// Writes what wanted nodes need, each value once: names `v1`, `v2`, ... for what is used more than
/// once, or long. Unknowns, data and speeds are items of the arrays `u`, `d` and `speed`.
class StraightLineCode {
public:
    /// All nodes that will be written: one that is written twice is listed twice.
    StraightLineCode(const model::Expressions& nodes, const std::vector<model::NodeIndex>& wanted);

    /// Definitions of the names that this node needs and that were not written before: lines that
    /// begin with `indent`.
    std::string definitions(model::NodeIndex wanted, const std::string& indent);

    /// The node as an expression, when its definitions are written.
    const std::string& expression(model::NodeIndex wanted) const { return texts_[wanted].text; }

    /// Whether inputs of this kind are needed.
    bool needs(model::Node::Kind kind) const;

private:
    struct Text {
        std::string text;
        bool is_sum = false;
        bool is_done = false;

        std::string as_factor() const { return is_sum ? "(" + text + ")" : text; }
    };

    Text text_of(model::NodeIndex index) const;

    const model::Expressions& nodes_;
    std::vector<int> uses_;
    std::vector<Text> texts_;
    std::size_t names_ = 0;
};

} // namespace plprove::generate
