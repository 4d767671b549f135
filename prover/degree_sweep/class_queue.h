// The classes that a sweep has to compute, in the order of the plan, given out one by one.
#pragma once

#include "prover/degree_sweep/plan.h"

#include <chrono>
#include <condition_variable>
#include <map>
#include <mutex>
#include <optional>

namespace plprove {

struct SweepProgress {
    std::size_t done = 0, total = 0; ///< classes that lacked a result
    double seconds = 0;              ///< since the sweep began
    double share = 0;                ///< of the cost expected
};

/// Safe to use by several threads at a time.
class ClassQueue {
public:
    explicit ClassQueue(const SweepPlan& plan);

    /// The number of the next class; nothing where none is left.
    std::optional<std::size_t> next();
    /// The result of this class is on file. Throws std::logic_error if it was not given out.
    void done(std::size_t number);

    /// How many classes are not on file yet, given out or not.
    std::size_t unfinished() const;
    SweepProgress progress() const;
    /// Returns when all classes are on file, or after this time.
    void wait(std::chrono::milliseconds time);

private:
    const std::vector<std::size_t> classes_;
    const std::vector<double> shares_;
    const std::chrono::steady_clock::time_point begin_ = std::chrono::steady_clock::now();
    mutable std::mutex mutex_; ///< guards what follows
    std::condition_variable finished_;
    std::size_t next_ = 0;                    ///< index of a class
    std::map<std::size_t, double> given_out_; ///< classes that are being computed, and their shares
    std::size_t done_ = 0;
    double share_ = 0;
};

} // namespace plprove
