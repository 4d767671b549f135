// Straight-line programs as nodes that are shared: additions, multiplications and reciprocals of
// constants, unknowns and data. What is 0 or 1 is folded away, and equal operations are one node.
#pragma once

#include <cstdint>
#include <map>
#include <tuple>
#include <vector>

namespace plprove::model {

/// The number of a node. Nodes come after those that they are computed from.
using NodeIndex = std::uint32_t;

struct Node {
    enum class Kind : std::uint8_t {
        constant,
        unknown,
        datum,
        speed, ///< the derivative of a datum by time
        sum,
        difference,
        product,
        negative,
        reciprocal
    };
    Kind kind = Kind::constant;
    double value = 0; ///< of a constant
    /// Operands; `right` is 0 where there is one. Of an unknown, a datum or a speed, `left` is its
    /// number.
    NodeIndex left = 0, right = 0;

    bool is_input() const { return kind <= Kind::speed; }
    bool is_binary() const { return kind >= Kind::sum && kind <= Kind::product; }
};

class Expressions {
public:
    Expressions();

    NodeIndex zero() const { return 0; }
    NodeIndex one() const { return 1; }
    NodeIndex constant(double value);
    /// An unknown, a datum or a speed, by its number from 0.
    NodeIndex input(Node::Kind kind, std::size_t number);

    NodeIndex sum(NodeIndex a, NodeIndex b);
    NodeIndex difference(NodeIndex a, NodeIndex b);
    NodeIndex product(NodeIndex a, NodeIndex b);
    NodeIndex negative(NodeIndex a);
    NodeIndex reciprocal(NodeIndex a);

    const Node& operator[](NodeIndex index) const { return nodes_[index]; }
    std::size_t size() const { return nodes_.size(); }

private:
    NodeIndex add(const Node& node);
    bool is_constant(NodeIndex a) const { return nodes_[a].kind == Node::Kind::constant; }
    bool is_negative(NodeIndex a) const { return nodes_[a].kind == Node::Kind::negative; }

    std::vector<Node> nodes_;
    std::map<std::tuple<Node::Kind, double, NodeIndex, NodeIndex>, NodeIndex> known_;
};

} // namespace plprove::model
