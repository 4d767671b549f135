#include "prover/model/solver/expressions.h"

#include <algorithm>

namespace plprove::model {

using Kind = Node::Kind;

Expressions::Expressions() {
    constant(0);
    constant(1);
}

NodeIndex Expressions::add(const Node& node) {
    const auto [place, is_new] =
        known_.try_emplace({node.kind, node.value, node.left, node.right}, nodes_.size());
    if (is_new) nodes_.push_back(node);
    return place->second;
}

NodeIndex Expressions::constant(double value) {
    return add({Kind::constant, value, 0, 0});
}

NodeIndex Expressions::input(Kind kind, std::size_t number) {
    return add({kind, 0, static_cast<NodeIndex>(number), 0});
}

NodeIndex Expressions::sum(NodeIndex a, NodeIndex b) {
    if (a == zero()) return b;
    if (b == zero()) return a;
    if (is_constant(a) && is_constant(b)) return constant(nodes_[a].value + nodes_[b].value);
    if (is_negative(b)) return difference(a, nodes_[b].left);
    if (is_negative(a)) return difference(b, nodes_[a].left);
    return add({Kind::sum, 0, std::min(a, b), std::max(a, b)});
}

NodeIndex Expressions::difference(NodeIndex a, NodeIndex b) {
    if (a == b) return zero();
    if (b == zero()) return a;
    if (a == zero()) return negative(b);
    if (is_constant(a) && is_constant(b)) return constant(nodes_[a].value - nodes_[b].value);
    if (is_negative(b)) return sum(a, nodes_[b].left);
    if (is_negative(a)) return negative(sum(nodes_[a].left, b));
    return add({Kind::difference, 0, a, b});
}

NodeIndex Expressions::product(NodeIndex a, NodeIndex b) {
    if (a == zero() || b == zero()) return zero();
    if (is_constant(a) && is_constant(b)) return constant(nodes_[a].value * nodes_[b].value);
    if (is_constant(b)) std::swap(a, b);
    if (is_constant(a)) {
        const double factor = nodes_[a].value;
        if (factor == 1) return b;
        if (factor == 2) return sum(b, b);
        if (factor < 0) return negative(product(constant(-factor), b));
    }
    if (is_negative(a)) return negative(product(nodes_[a].left, b));
    if (is_negative(b)) return negative(product(a, nodes_[b].left));
    return add({Kind::product, 0, std::min(a, b), std::max(a, b)});
}

NodeIndex Expressions::negative(NodeIndex a) {
    const Node node = nodes_[a];
    if (node.kind == Kind::constant) return constant(0 - node.value);
    if (node.kind == Kind::negative) return node.left;
    if (node.kind == Kind::difference) return difference(node.right, node.left);
    return add({Kind::negative, 0, a, 0});
}

NodeIndex Expressions::reciprocal(NodeIndex a) {
    const Node node = nodes_[a];
    if (node.kind == Kind::constant && node.value != 0) return constant(1 / node.value);
    if (node.kind == Kind::reciprocal) return node.left;
    if (node.kind == Kind::negative) return negative(reciprocal(node.left));
    return add({Kind::reciprocal, 0, a, 0});
}

} // namespace plprove::model
