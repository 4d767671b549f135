#include "prover/model/solver/derivatives.h"

#include "prover/model/evaluation.h"

#include <algorithm>
#include <set>

namespace plprove::model {

namespace {

using Kind = Node::Kind;

/// Runs programs on nodes (evaluation.h).
struct NodeRing {
    using Scalar = NodeIndex;

    Expressions* nodes;

    Scalar constant(int value) const { return nodes->constant(value); }
    Scalar zero() const { return nodes->zero(); }
    Scalar datum(std::size_t number) const { return nodes->input(Kind::datum, number); }
    Scalar unknown(std::size_t number) const { return nodes->input(Kind::unknown, number); }
    Scalar sum(Scalar a, Scalar b) const { return nodes->sum(a, b); }
    Scalar difference(Scalar a, Scalar b) const { return nodes->difference(a, b); }
    Scalar product(Scalar a, Scalar b) const { return nodes->product(a, b); }
    Scalar quotient(Scalar a, Scalar b, const Operation& /*which*/) const {
        return nodes->product(a, nodes->reciprocal(b));
    }
};

/// The graph of operations. Its vertices are the nodes, then time, then one for each equation; an
/// edge has the derivative of its end by its beginning.
class Graph {
public:
    Graph(Expressions& nodes, const std::vector<NodeIndex>& equations)
        : nodes_(nodes), time_(nodes.size()), before_(time_ + 1 + equations.size()),
          after_(before_.size()) {
        for (std::size_t e = 0; e < equations.size(); ++e)
            add_edge(equations[e], sink(e), nodes.one());
        // Nodes come after their operands: those that have an edge by now are needed.
        for (std::size_t v = time_; v-- > 0;)
            if (!after_[v].empty()) add_edges_to(v);
    }

    /// Leaves edges from unknowns and time to equations only.
    void eliminate_all() {
        for (std::size_t v = 0; v < time_; ++v)
            if (is_inner(v)) queue_.emplace(cost(v), v);
        while (!queue_.empty()) {
            const std::size_t vertex = queue_.begin()->second;
            queue_.erase(queue_.begin());
            eliminate(vertex);
        }
    }

    /// The derivative of an equation by a node, or by time.
    NodeIndex derivative(std::size_t equation, std::size_t source) const {
        const auto& edges = before_[sink(equation)];
        const auto found = edges.find(source);
        return found == edges.end() ? nodes_.zero() : found->second;
    }
    std::size_t time() const { return time_; }

private:
    std::size_t sink(std::size_t equation) const { return time_ + 1 + equation; }
    bool is_inner(std::size_t v) const {
        return !after_[v].empty() && nodes_[static_cast<NodeIndex>(v)].kind != Kind::unknown;
    }
    std::size_t cost(std::size_t v) const { return before_[v].size() * after_[v].size(); }

    void add_edge(std::size_t from, std::size_t to, NodeIndex factor) {
        if (factor == nodes_.zero()) return;
        const auto [edge, is_new] = before_[to].try_emplace(from, factor);
        if (!is_new) edge->second = nodes_.sum(edge->second, factor);
        after_[from].insert(to);
    }

    void add_edges_to(std::size_t v) {
        const auto index = static_cast<NodeIndex>(v);
        const Node node = nodes_[index];
        const auto add = [&](NodeIndex from, NodeIndex factor) {
            if (nodes_[from].kind != Kind::constant) add_edge(from, v, factor);
        };
        switch (node.kind) {
        case Kind::constant:
        case Kind::unknown:
        case Kind::speed:
            return;
        case Kind::datum:
            return add_edge(time_, v, nodes_.input(Kind::speed, node.left));
        case Kind::sum:
        case Kind::difference:
            add(node.left, nodes_.one());
            return add(node.right, nodes_.constant(node.kind == Kind::sum ? 1 : -1));
        case Kind::product:
            add(node.left, node.right);
            return add(node.right, node.left);
        case Kind::negative:
            return add(node.left, nodes_.constant(-1));
        case Kind::reciprocal:
            return add(node.left, nodes_.negative(nodes_.product(index, index)));
        }
    }

    void eliminate(std::size_t vertex) {
        const auto before = std::move(before_[vertex]);
        const auto after = std::move(after_[vertex]);
        std::set<std::size_t> touched(after.begin(), after.end());
        for (const auto& [from, factor] : before)
            touched.insert(from);
        for (const std::size_t v : touched)
            if (v < time_) queue_.erase({cost(v), v});
        for (const std::size_t to : after) {
            const NodeIndex outer = before_[to].at(vertex);
            before_[to].erase(vertex);
            for (const auto& [from, factor] : before)
                add_edge(from, to, nodes_.product(outer, factor));
        }
        for (const auto& [from, factor] : before)
            after_[from].erase(vertex);
        for (const std::size_t v : touched)
            if (v < time_ && is_inner(v)) queue_.emplace(cost(v), v);
    }

    Expressions& nodes_;
    std::size_t time_; ///< also how many nodes are vertices
    std::vector<std::map<std::size_t, NodeIndex>> before_;
    std::vector<std::set<std::size_t>> after_;
    std::set<std::pair<std::size_t, std::size_t>> queue_;
};

} // namespace

std::vector<NodeIndex> nodes_of(const Program& program, const std::vector<ScalarIndex>& scalars,
                                Expressions& nodes) {
    NodeRing ring{&nodes};
    const std::vector<NodeIndex> values = evaluate(program, ring, scalars);
    std::vector<NodeIndex> result;
    for (const ScalarIndex scalar : scalars)
        result.push_back(values[scalar]);
    return result;
}

std::vector<DerivedEquation> derived_equations(const Program& program, Expressions& nodes) {
    const std::vector<NodeIndex> equations =
        nodes_of(program, scalars_of(program.equations), nodes);
    std::vector<NodeIndex> unknowns;
    for (std::size_t i = 0; i < program.unknowns; ++i)
        unknowns.push_back(nodes.input(Kind::unknown, i));
    Graph graph(nodes, equations);
    graph.eliminate_all();
    std::vector<DerivedEquation> result;
    for (std::size_t e = 0; e < equations.size(); ++e) {
        DerivedEquation& equation = result.emplace_back();
        equation.value = equations[e];
        for (const NodeIndex unknown : unknowns)
            equation.by_unknown.push_back(graph.derivative(e, unknown));
        equation.by_time = graph.derivative(e, graph.time());
    }
    return result;
}

} // namespace plprove::model
