// How a file is replayed: how much effort it may take, by how many threads, and who is told how far
// it is. A file that takes more effort proves nothing; else what it proves depends on none of this.
#pragma once

#include "checker/file/complaint.h"

#include <cstdint>
#include <functional>

namespace checker {
struct Progress {
    std::size_t line = 0;      // of the file
    std::size_t records = 0;   // begun
    std::size_t solutions = 0; // proved
};

/// After this number of refused records the rest of a file is not replayed, but refused: what is
/// wrong takes no longer than that.
inline constexpr std::size_t most_refusals = 100;

/// Is told so after each solution.
using Watch = std::function<void(const Progress&)>;

/// The effort of a minute or so; FORMAT.md, section 6, says what takes how much.
inline constexpr std::uint64_t usual_effort = 100'000;

struct Execution {
    Watch watch = [](const Progress&) {};
    std::size_t threads = 1;             // that prove solutions side by side
    std::uint64_t effort = usual_effort; // that a file may take
};

/// Thrown where a file takes more effort than it may.
struct TooMuchEffort {
    std::size_t line = 0;

    /// What is said instead of all else.
    Refusals refusals() const {
        Refusals all;
        all.add(line, "from here on the file takes more effort than allowed, so nothing of it "
                      "counts: split it between records, or raise --effort");
        return all;
    }
};

/// The records of a file, one after the other: the effort that they take, and which are refused.
class Records {
public:
    Records(Refusals& refusals, const Execution& execution)
        : refusals_(refusals), execution_(execution), effort_(execution.effort) {}

    /// Replays the record that begins at a line by `check`, which throws Refused where it does not
    /// hold: this is said of the line that is reached.
    template <class Check>
    void replay(std::size_t line, const std::string& about, const Check& check) {
        ++progress_.records;
        progress_.line = line;
        execution_.watch(progress_);
        try {
            if (refusals_.count >= most_refusals)
                throw Refused("not replayed, as ", most_refusals, " records are refused before it");
            check();
        } catch (const Refused& refused) {
            refusals_.add(progress_.line, about + refused.reason);
        }
    }

    /// Throws TooMuchEffort, with the line that is reached, if so much is not left.
    void spend(std::uint64_t effort) {
        if (effort > effort_) throw TooMuchEffort{progress_.line};
        effort_ -= effort;
    }

    std::size_t line() const { return progress_.line; }

    void reach(std::size_t line) { progress_.line = line; }

    /// Counts a solution that is proved.
    void add_solution() {
        ++progress_.solutions;
        execution_.watch(progress_);
    }

private:
    Refusals& refusals_;
    const Execution& execution_;
    Progress progress_{};
    std::uint64_t effort_ = 0; // that is left
};
} // namespace checker
