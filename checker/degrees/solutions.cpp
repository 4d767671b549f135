#include "checker/degrees/solutions.h"

namespace checker {
/// The effort of a proof. It grows with the square of the number of coordinates, 11 for three
/// views; numbers of twice the bits, and more steps, take four times as much. What is refused
/// has been tried with the most bits.
static std::uint64_t effort_of(const Proof& proof, std::size_t coordinates) {
    constexpr std::size_t usual = camera_unknowns * camera_unknowns;
    const std::uint64_t size = (coordinates * coordinates + usual - 1) / usual;
    const auto* box = std::get_if<Box>(&proof);
    if (!box || box->tries == 3) return 16 * size;
    return box->tries == 2 ? 4 * size : size;
}

/// A box with one solution, and the line of its starting values.
struct Found {
    Box box;
    std::size_t line;
};

/// The solutions of a record that are proved so far. No two boxes meet. (There are no more than the
/// degree, so it does not take long to compare them all.)
class ProvedSolutions {
public:
    std::size_t count() const { return found_.size(); }

    /// Adds what is proved of a starting value: a solution, and its conjugate unless it is real.
    /// Throws Refused if nothing is, or if it may be one that is added before.
    void add(const ApproximateSolution& start, const Proof& proof) {
        if (const auto* refused = std::get_if<Refused>(&proof)) throw *refused;
        const Box& box = std::get<Box>(proof);
        add({box, start.line});
        if (start.real) return;
        const Box conjugate = box.conjugate();
        if (box.meets(conjugate)) throw Refused("the pair may be real");
        add({conjugate, start.line});
    }

private:
    void add(const Found& solution) {
        for (const Found& before : found_)
            if (before.box.meets(solution.box))
                throw Refused("this may be the solution of line ", before.line);
        found_.push_back(solution);
    }

    std::vector<Found> found_;
};

bool SolutionsReplay::has_more(const SolutionLines& lines) const {
    return !reader_.at_end() && !reader_.comes(lines.next_record);
}

ApproximateSolution SolutionsReplay::read_solution(const SolutionLines& lines) {
    constexpr std::int64_t largest = 999'999'999'999'999'999;
    ApproximateSolution solution{.line = reader_.line(), .real = reader_.comes("real")};
    reader_.take(solution.real ? "real" : "pair");
    solution.bits = reader_.small_integer(0, 200);
    for (std::size_t i = 0; i < lines.coordinates; ++i) {
        auto& [real, imaginary] = solution.coordinates.emplace_back();
        real = reader_.integer(-largest, largest);
        if (!solution.real) imaginary = reader_.integer(-largest, largest);
    }
    reader_.end_line();
    return solution;
}

/// Reads the solutions that the threads shall prove at a time. What comes after a flaw is proved
/// in vain; so at first these are few, as most flawed records have their flaw early.
std::vector<ApproximateSolution> SolutionsReplay::read_some(const SolutionLines& lines,
                                                            std::size_t proved) {
    const std::size_t most = threads_ == 1 ? 1 : std::clamp(proved, threads_, 64 * threads_);
    std::vector<ApproximateSolution> starts;
    do
        starts.push_back(read_solution(lines));
    while (starts.size() < most && has_more(lines));
    return starts;
}

/// Reads the solutions that are left, one at least if none is read yet.
void SolutionsReplay::skip(const SolutionLines& lines, bool none_is_read) {
    if (none_is_read) read_solution(lines);
    while (has_more(lines))
        read_solution(lines);
}

std::optional<std::size_t> SolutionsReplay::run(const SolutionLines& lines, std::size_t line,
                                                const std::string& about,
                                                const std::function<Certify()>& prepare) {
    std::optional<std::size_t> count;
    records_.replay(line, about + ": ", [&] {
        const Certify certify = prepare();
        ProvedSolutions proved;
        do {
            const auto starts = read_some(lines, proved.count());
            const auto proofs = certify_all(certify, starts, threads_);
            for (std::size_t i = 0; i < starts.size(); ++i) {
                records_.reach(starts[i].line);
                records_.spend(effort_of(proofs[i], lines.coordinates));
                proved.add(starts[i], proofs[i]);
                records_.add_solution();
            }
        } while (has_more(lines));
        count = proved.count();
    });
    if (!count) skip(lines, records_.line() == line);
    return count;
}
} // namespace checker
