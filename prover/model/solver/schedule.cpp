#include "prover/model/solver/schedule.h"

#include <algorithm>
#include <array>
#include <span>
#include <utility>

namespace plprove::model {

namespace {

using Kind = Node::Kind;

/// An operation on nodes.
struct Step {
    TrackedKind kind = TrackedKind::sum;
    NodeIndex result = 0;
    std::vector<NodeIndex> operands; ///< a, b, c
};

/// An entry of the matrix.
struct Cell {
    int place = 0;
    NodeIndex node = 0;
};

/// Reorders steps from `first` on, in windows of some hundred, so that many of one kind follow each
/// other that do not depend on each other: a processor computes these side by side, and the kinds
/// change seldom. Values stay near in time to where they are needed.
class Runs {
public:
    explicit Runs(std::size_t nodes) : producer_(nodes) {}

    void gather(std::vector<Step>& steps, std::size_t first) {
        constexpr std::size_t window = 512;
        for (; first < steps.size(); first += window)
            gather(std::span(steps).subspan(first, std::min(window, steps.size() - first)));
    }

private:
    static constexpr std::size_t kinds = static_cast<std::size_t>(TrackedKind::reciprocal) + 1;

    void gather(std::span<Step> steps) {
        for (std::size_t i = 0; i < steps.size(); ++i)
            producer_[steps[i].result] = i + 1;
        std::vector<int> missing(steps.size());
        std::vector<std::vector<std::size_t>> users(steps.size());
        std::array<std::vector<std::size_t>, kinds> ready;
        const auto make_ready = [&](std::size_t i) {
            ready[static_cast<std::size_t>(steps[i].kind)].push_back(i);
        };
        for (std::size_t i = 0; i < steps.size(); ++i) {
            for (const NodeIndex operand : steps[i].operands)
                if (producer_[operand] != 0) {
                    users[producer_[operand] - 1].push_back(i);
                    ++missing[i];
                }
            if (missing[i] == 0) make_ready(i);
        }
        std::vector<Step> ordered;
        while (ordered.size() < steps.size()) {
            auto& run = *std::ranges::max_element(ready, {}, &std::vector<std::size_t>::size);
            const std::vector<std::size_t> taken = std::exchange(run, {});
            for (const std::size_t i : taken)
                for (const std::size_t user : users[i])
                    if (--missing[user] == 0) make_ready(user);
            for (const std::size_t i : taken)
                ordered.push_back(std::move(steps[i]));
        }
        for (const Step& step : ordered)
            producer_[step.result] = 0;
        std::ranges::move(ordered, steps.begin());
    }

    std::vector<std::size_t> producer_; // of a node: the number of its step in the window, from 1
};

/// Operations in an order, with a product and a sum as one operation where the product is needed
/// nowhere else.
class Order {
public:
    Order(const Expressions& nodes, const std::vector<Cell>& cells)
        : nodes_(nodes), uses_(nodes.size()), done_(nodes.size()) {
        for (const Cell& cell : cells)
            ++uses_[cell.node];
        std::vector<bool> needed(nodes.size());
        for (const Cell& cell : cells)
            needed[cell.node] = true;
        for (auto index = static_cast<NodeIndex>(nodes.size()); index-- > 0;) {
            if (!needed[index]) continue;
            for (const NodeIndex operand : operands(index)) {
                ++uses_[operand];
                needed[operand] = true;
            }
        }
    }

    /// Adds what this node needs, depth first, and itself.
    void add(NodeIndex wanted) {
        std::vector<NodeIndex> open{wanted};
        while (!open.empty()) {
            const NodeIndex index = open.back();
            if (done_[index] || nodes_[index].is_input()) {
                open.pop_back();
                continue;
            }
            Step step = step_of(index);
            const std::size_t before = open.size();
            for (const NodeIndex operand : step.operands)
                if (!done_[operand] && !nodes_[operand].is_input()) open.push_back(operand);
            if (open.size() > before) continue;
            done_[index] = true;
            steps_.push_back(std::move(step));
            open.pop_back();
        }
    }

    /// Gathers runs in the steps that came since the last time.
    void gather_runs() {
        Runs(nodes_.size()).gather(steps_, gathered_);
        gathered_ = steps_.size();
    }

    const std::vector<Step>& steps() const { return steps_; }

private:
    std::vector<NodeIndex> operands(NodeIndex index) const {
        const Node& node = nodes_[index];
        if (node.is_input()) return {};
        if (node.is_binary()) return {node.left, node.right};
        return {node.left};
    }

    bool is_fused(NodeIndex index) const {
        return nodes_[index].kind == Kind::product && uses_[index] == 1;
    }

    Step step_of(NodeIndex index) const {
        const Node& node = nodes_[index];
        const auto fused = [&](TrackedKind kind, NodeIndex product, NodeIndex other) {
            return Step{kind, index, {nodes_[product].left, nodes_[product].right, other}};
        };
        switch (node.kind) {
        case Kind::sum:
            if (is_fused(node.right)) return fused(TrackedKind::add, node.right, node.left);
            if (is_fused(node.left)) return fused(TrackedKind::add, node.left, node.right);
            return {TrackedKind::sum, index, operands(index)};
        case Kind::difference:
            if (is_fused(node.right)) return fused(TrackedKind::subtract, node.right, node.left);
            if (is_fused(node.left)) return fused(TrackedKind::product_less, node.left, node.right);
            return {TrackedKind::difference, index, operands(index)};
        case Kind::product:
            return {TrackedKind::product, index, operands(index)};
        case Kind::negative:
            return {TrackedKind::negative, index, operands(index)};
        default:
            return {TrackedKind::reciprocal, index, operands(index)};
        }
    }

    const Expressions& nodes_;
    std::vector<int> uses_;
    std::vector<bool> done_;
    std::vector<Step> steps_;
    std::size_t gathered_ = 0;
};

/// Gives places to values, and takes them back after the last use.
class Places {
public:
    /// The first `reserved` places are those of unknowns and of the matrix.
    Places(const Expressions& nodes, int reserved)
        : nodes_(nodes), place_(nodes.size(), none), last_use_(nodes.size()), next_(reserved) {
        for (NodeIndex index = 0; index < nodes.size(); ++index)
            if (nodes[index].kind == Kind::unknown)
                place_[index] = static_cast<int>(nodes[index].left);
    }

    /// The value of an operation is to be in this entry of the matrix, and stays there; whether it
    /// is not yet in another.
    bool fix(const Cell& cell) {
        if (nodes_[cell.node].is_input() || place_[cell.node] != none) return false;
        place_[cell.node] = cell.place;
        last_use_[cell.node] = forever;
        return true;
    }

    void note_uses(const std::vector<Step>& steps) {
        for (std::size_t i = 0; i < steps.size(); ++i)
            for (const NodeIndex operand : steps[i].operands)
                last_use_[operand] = std::max(last_use_[operand], i);
    }

    /// The place of a value; inputs get one for good.
    int of(NodeIndex index) {
        if (place_[index] == none) place_[index] = next_++;
        return place_[index];
    }

    TrackedOperation placed(const Step& step, std::size_t number) {
        TrackedOperation operation{step.kind, 0, 0, 0, 0};
        int* const to[] = {&operation.a, &operation.b, &operation.c};
        for (std::size_t i = 0; i < step.operands.size(); ++i)
            *to[i] = of(step.operands[i]);
        for (const NodeIndex operand : step.operands)
            if (last_use_[operand] == number && !nodes_[operand].is_input()) release(operand);
        int& place = place_[step.result];
        if (place == none) place = take();
        operation.to = place;
        return operation;
    }

    int count() const { return next_; }
    bool has(NodeIndex index) const { return place_[index] != none; }

private:
    static constexpr int none = -1, released = -2;
    static constexpr std::size_t forever = ~std::size_t{0};

    void release(NodeIndex operand) {
        if (place_[operand] == released) return; // twice in one operation
        free_.push_back(place_[operand]);
        place_[operand] = released;
    }

    int take() {
        if (free_.empty()) return next_++;
        const int place = free_.back();
        free_.pop_back();
        return place;
    }

    const Expressions& nodes_;
    std::vector<int> place_;
    std::vector<std::size_t> last_use_; ///< the number of a step
    std::vector<int> free_;
    int next_;
};

/// The entries of the matrix: those at rest first, row by row.
std::pair<std::vector<Cell>, std::size_t> cells_of(const std::vector<DerivedEquation>& equations) {
    const int n = static_cast<int>(equations.size());
    std::vector<Cell> cells;
    const auto place = [&](int row, int column) { return n + row * (n + 2) + column; };
    for (int row = 0; row < n; ++row) {
        const DerivedEquation& equation = equations[static_cast<std::size_t>(row)];
        for (int column = 0; column < n; ++column)
            cells.push_back(
                {place(row, column), equation.by_unknown[static_cast<std::size_t>(column)]});
        cells.push_back({place(row, n), equation.value});
    }
    const std::size_t at_rest = cells.size();
    for (int row = 0; row < n; ++row)
        cells.push_back({place(row, n + 1), equations[static_cast<std::size_t>(row)].by_time});
    return {std::move(cells), at_rest};
}

void add_inputs(const Expressions& nodes, Places& places, Schedule& schedule) {
    std::map<NodeIndex, TrackedDatum> data; // by number
    for (NodeIndex index = 0; index < nodes.size(); ++index) {
        const Node& node = nodes[index];
        if (!node.is_input() || node.kind == Kind::unknown || !places.has(index)) continue;
        const int place = places.of(index);
        if (node.kind == Kind::constant) {
            schedule.constants.push_back({place, node.value});
            continue;
        }
        TrackedDatum& datum = data.try_emplace(node.left, TrackedDatum{-1, -1, 0}).first->second;
        datum.number = static_cast<int>(node.left);
        (node.kind == Kind::datum ? datum.place : datum.speed) = place;
    }
    for (auto& [number, datum] : data) {
        if (datum.place < 0) datum.place = datum.speed; // which is set after it
        schedule.data.push_back(datum);
    }
}

} // namespace

Schedule scheduled(const Expressions& nodes, const std::vector<DerivedEquation>& equations) {
    const auto [cells, at_rest] = cells_of(equations);
    const int unknowns = static_cast<int>(equations.size());
    Order order(nodes, cells);
    Schedule schedule;
    Places places(nodes, unknowns + static_cast<int>(cells.size()));
    std::vector<Cell> copied;
    for (std::size_t i = 0; i < cells.size(); ++i) {
        const Cell& cell = cells[i];
        order.add(cell.node);
        if (cell.node == nodes.zero())
            schedule.zeros.push_back(cell.place);
        else if (!places.fix(cell))
            copied.push_back(cell);
        if (i + 1 != at_rest) continue;
        order.gather_runs();
        schedule.operations_at_rest = static_cast<int>(order.steps().size());
        schedule.copies_at_rest = static_cast<int>(copied.size());
    }
    order.gather_runs();
    places.note_uses(order.steps());
    for (std::size_t i = 0; i < order.steps().size(); ++i)
        schedule.operations.push_back(places.placed(order.steps()[i], i));
    for (const Cell& cell : copied)
        schedule.copies.push_back({cell.place, places.of(cell.node)});
    add_inputs(nodes, places, schedule);
    schedule.places = places.count();
    return schedule;
}

} // namespace plprove::model
