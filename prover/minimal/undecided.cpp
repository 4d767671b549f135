#include "prover/minimal/undecided.h"

#include "prover/minimal/random_instance.h"
#include "prover/reasons/reason.h"

namespace plprove {

namespace {

/// Reads motions, the columns of a matrix: its rows belong to the columns of the Jacobian.
class Motions {
public:
    explicit Motions(const ResidueMatrix& jacobian)
        : matrix_(jacobian.columns(), jacobian.columns()),
          count_(static_cast<int>(nmod_mat_nullspace(matrix_.get(), jacobian.get()))) {}

    int count() const { return count_; }

    /// Whether any motion has an entry other than 0 in the next rows.
    bool next(int rows) {
        bool any = false;
        for (const int end = row_ + rows; row_ < end; ++row_)
            for (int motion = 0; motion < count_; ++motion)
                any = any || matrix_.at(row_, motion) != 0;
        return any;
    }

private:
    ResidueMatrix matrix_;
    int count_;
    int row_ = 0;
};

/// Which points and lines the motions move, and then which cameras.
void read(Motions& motions, Undecided& found) {
    const Problem& problem = found.problem;
    std::vector<bool> moves;
    const auto any_moves = [&](std::span<const int> points) {
        return std::ranges::any_of(
            points, [&](int point) { return moves[static_cast<std::size_t>(point)]; });
    };
    for (int point = 0; point < static_cast<int>(problem.points.size()); ++point) {
        const std::optional<int> on = carrier(problem, point);
        bool moved = motions.next(on ? 1 : 3);
        if (on) // of a line through two points before it
            moved |=
                any_moves(std::span(problem.lines[static_cast<std::size_t>(*on)].points).first(2));
        moves.push_back(moved);
        if (moved) found.moving_points.push_back(point);
    }
    for (std::size_t i = 0; i < problem.lines.size(); ++i) {
        const std::vector<int>& points = problem.lines[i].points;
        const bool turned = motions.next(points.empty() ? 4 : points.size() == 1 ? 2 : 0);
        if (turned || any_moves(points)) found.moving_lines.push_back(static_cast<int>(i));
    }
    motions.next(problem.cameras->shared);
    for (int view = 1; view < problem.views; ++view)
        if (motions.next(view == 1 ? problem.cameras->unknowns_of_second
                                   : problem.cameras->unknowns))
            found.moving_views.push_back(view);
}

} // namespace

Undecided look_at(const Problem& problem) {
    const auto jacobian_at = [&](unsigned seed) {
        return jacobian_modulo_q(problem, random_instance(problem, seed, most_coordinate));
    };
    const ResidueMatrix first = jacobian_at(1);
    Undecided found{.problem = problem, .parameters = first.columns()};
    Motions motions(first);
    read(motions, found);
    found.ranks = {found.parameters - motions.count(),
                   static_cast<int>(nmod_mat_rank(jacobian_at(2).get())),
                   static_cast<int>(nmod_mat_rank(jacobian_at(3).get()))};
    return found;
}

std::string explanation(const Undecided& problem) {
    const std::string all = std::to_string(problem.parameters);
    return "the images put " + all + " conditions on " + all +
           " parameters of cameras and scene; at three random places " +
           std::to_string(problem.ranks[0]) + ", " + std::to_string(problem.ranks[1]) + " and " +
           std::to_string(problem.ranks[2]) +
           " of them are independent, and no known reason says why. At the first place no image "
           "changes while these move: cameras" +
           numbers_from_one(problem.moving_views) + ", points" +
           numbers_from_one(problem.moving_points) + ", lines" +
           numbers_from_one(problem.moving_lines);
}

} // namespace plprove
