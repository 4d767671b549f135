// Ranks in one process: each is used by a thread of its own.
#pragma once

#include "prover/system/ranks.h"

#include <deque>
#include <mutex>
#include <vector>

namespace plprove {

class FakeRanks {
public:
    explicit FakeRanks(int count) : boxes_(static_cast<std::size_t>(count)) {}

    Ranks rank(int number) {
        return {number, static_cast<int>(boxes_.size()),
                [this, number](int to, const std::string& text) {
                    const std::lock_guard lock(mutex_);
                    boxes_.at(static_cast<std::size_t>(to)).push_back({number, text});
                },
                [this, number] { return take(boxes_.at(static_cast<std::size_t>(number))); }};
    }

private:
    std::optional<Message> take(std::deque<Message>& box) {
        const std::lock_guard lock(mutex_);
        if (box.empty()) return std::nullopt;
        Message message = box.front();
        box.pop_front();
        return message;
    }

    std::mutex mutex_; ///< guards the boxes
    std::vector<std::deque<Message>> boxes_;
};

} // namespace plprove
