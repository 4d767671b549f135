// Loops of a model's data, for monodromy.
#pragma once

#include "prover/model/solver/data_way.h"
#include "prover/model/solver/random_solutions.h"
#include "prover/monodromy/monodromy.h"

namespace plprove::model {

/// How far ways between data bend: by numbers of size 1; or by several times the size of the data,
/// as narrow loops may permute few solutions, if any.
enum class Bends : std::uint8_t { usual, wide };

/// Two random data, and ways between them.
class DataLoops {
public:
    using Point = Numbers;
    static constexpr int attempts = 1;

    /// All arguments must outlive the loops.
    DataLoops(const Program& program, const TrackedEquations& equations, Numbers data,
              Random& random, unsigned threads, Bends bends)
        : program_(program), equations_(equations), random_(random), threads_(threads),
          wide_(bends == Bends::wide), data_{std::move(data),
                                             random_numbers(program.data, Field::complex, random)} {
    }

    const Numbers& data(int node) const { return data_[static_cast<std::size_t>(node)]; }
    std::int64_t paths() const { return paths_; }

    void add_edge() {
        Numbers& bend = bends_.emplace_back(random_numbers(program_.data, Field::complex, random_));
        for (std::size_t i = 0; wide_ && i < bend.size(); ++i)
            bend[i] *= 4 * (1 + size(data_[0][i]) + size(data_[1][i]));
    }

    PathEnds<Numbers> follow(Direction direction, const std::vector<Numbers>& starts) {
        return follow(direction, starts, Care::usual);
    }
    PathEnds<Numbers> follow_again(Direction direction, int, const std::vector<Numbers>& starts) {
        return follow(direction, starts, Care::careful);
    }
    static bool leads_elsewhere(int) { return false; }

    std::vector<bool> refused(int node, const std::vector<Numbers>& points, bool) const {
        std::vector<bool> result;
        for (const Numbers& point : points)
            result.push_back(!keeps_conditions(program_, data(node), point));
        return result;
    }
    static std::optional<Numbers> companion(const Numbers&) { return std::nullopt; }

private:
    static double size(const std::complex<double>& z) {
        return std::abs(z.real()) + std::abs(z.imag());
    }

    /// Newton's method refines the ends: else two approximations of one solution, where the
    /// Jacobian is nearly singular, might seem to be two.
    PathEnds<Numbers> follow(Direction direction, const std::vector<Numbers>& starts, Care care) {
        paths_ += std::ssize(starts);
        const Numbers& bend = bends_[static_cast<std::size_t>(direction.edge)];
        const Numbers& to = data(direction.to());
        PathEnds<Numbers> ends =
            follow_all(equations_, {data(direction.from), to, bend}, starts, care, threads_);
        for (auto& end : ends)
            if (end) end = refined(program_, to, *end);
        return ends;
    }

    const Program& program_;
    const TrackedEquations& equations_;
    Random& random_;
    unsigned threads_;
    bool wide_;
    std::array<Numbers, 2> data_;
    std::vector<Numbers> bends_;
    std::int64_t paths_ = 0;
};

using DataMonodromy = Monodromy<DataLoops>;

} // namespace plprove::model
