// Shows on a terminal how far a replay is: records, solutions, and how long it still takes.
#pragma once

#include "checker/replay.h"

#include <chrono>

namespace checker {
class ProgressBar {
public:
    /// Of files whose sizes add up to `bytes`. Draws nothing unless it is to be shown.
    ProgressBar(std::uintmax_t bytes, bool shown) : bytes_left_(bytes), shown_(shown) {}

    /// Begins a file of these bytes; what was drawn goes.
    void begin(std::string_view bytes);

    /// Draws, a few times a second.
    void update(const Progress& progress);

    /// What was drawn goes.
    void clear();

private:
    using Clock = std::chrono::steady_clock;

    std::string time_left(double bytes_done) const;

    std::uintmax_t bytes_left_; // of this file and those after it
    bool shown_;
    bool drawn_ = false;
    std::size_t bytes_ = 0, lines_ = 0; // of this file
    Clock::time_point start_{};         // of this file
    Clock::time_point last_{};          // when it was drawn
};
} // namespace checker
