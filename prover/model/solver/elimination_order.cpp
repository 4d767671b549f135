#include "prover/model/solver/elimination_order.h"

#include <algorithm>
#include <optional>

namespace plprove::model {

namespace {

class Elimination {
public:
    explicit Elimination(std::vector<std::vector<bool>> nonzero)
        : nonzero_(std::move(nonzero)), row_left_(nonzero_.size(), true),
          column_left_(nonzero_.size(), true) {}

    EliminationOrder run() {
        EliminationOrder order;
        for (std::size_t count = 0; count < nonzero_.size(); ++count)
            add_step(order, cheapest());
        return order;
    }

private:
    /// What a step concerns.
    struct Front {
        std::size_t column = 0;
        std::vector<std::size_t> rows;
        std::vector<std::size_t> others; ///< columns

        std::size_t cost() const { return rows.size() * (others.size() + 1); }
    };

    Front front_of(std::size_t column) const {
        Front front{column, {}, {}};
        for (std::size_t row = 0; row < nonzero_.size(); ++row)
            if (row_left_[row] && nonzero_[row][column]) front.rows.push_back(row);
        if (front.rows.empty()) // the matrix is singular: a pivot that is 0
            front.rows.push_back(
                static_cast<std::size_t>(std::ranges::find(row_left_, true) - row_left_.begin()));
        for (std::size_t other = 0; other < nonzero_.size(); ++other)
            if (other != column && column_left_[other] &&
                std::ranges::any_of(front.rows,
                                    [&](std::size_t row) { return nonzero_[row][other]; }))
                front.others.push_back(other);
        return front;
    }

    Front cheapest() const {
        std::optional<Front> best;
        for (std::size_t column = 0; column < nonzero_.size(); ++column) {
            if (!column_left_[column]) continue;
            Front front = front_of(column);
            if (!best || front.cost() < best->cost()) best = std::move(front);
        }
        return *best;
    }

    void add_step(EliminationOrder& order, const Front& front) {
        const auto append = [&](const std::vector<std::size_t>& numbers) {
            for (const std::size_t number : numbers)
                order.indices.push_back(static_cast<int>(number));
            return static_cast<int>(order.indices.size());
        };
        const int rows = append({});
        const int columns = append(front.rows);
        order.steps.push_back(
            {static_cast<int>(front.column), rows, columns, append(front.others)});
        for (const std::size_t row : front.rows)
            for (const std::size_t column : front.others)
                nonzero_[row][column] = true;
        row_left_[front.rows.front()] = false;
        column_left_[front.column] = false;
    }

    std::vector<std::vector<bool>> nonzero_;
    std::vector<bool> row_left_, column_left_;
};

} // namespace

EliminationOrder elimination_order(std::vector<std::vector<bool>> nonzero) {
    return Elimination(std::move(nonzero)).run();
}

} // namespace plprove::model
