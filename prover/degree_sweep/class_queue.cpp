#include "prover/degree_sweep/class_queue.h"

#include <stdexcept>
#include <string>

namespace plprove {

namespace {

/// The costs, scaled so that they add up to 1.
std::vector<double> shares_of(std::vector<double> costs) {
    double sum = 0;
    for (const double cost : costs)
        sum += cost;
    for (double& cost : costs)
        cost /= sum;
    return costs;
}

} // namespace

ClassQueue::ClassQueue(const SweepPlan& plan)
    : classes_(plan.classes), shares_(shares_of(plan.costs)) {}

std::optional<std::size_t> ClassQueue::next() {
    const std::lock_guard lock(mutex_);
    if (next_ == classes_.size()) return std::nullopt;
    const std::size_t index = next_++;
    given_out_.emplace(classes_[index], shares_[index]);
    return classes_[index];
}

void ClassQueue::done(std::size_t number) {
    const std::lock_guard lock(mutex_);
    const auto found = given_out_.find(number);
    if (found == given_out_.end())
        throw std::logic_error("class " + std::to_string(number) + " was not given out");
    share_ += found->second;
    given_out_.erase(found);
    ++done_;
    if (done_ == classes_.size()) finished_.notify_all();
}

std::size_t ClassQueue::unfinished() const {
    const std::lock_guard lock(mutex_);
    return classes_.size() - done_;
}

SweepProgress ClassQueue::progress() const {
    const std::chrono::duration<double> elapsed = std::chrono::steady_clock::now() - begin_;
    const std::lock_guard lock(mutex_);
    return {done_, classes_.size(), elapsed.count(), share_};
}

void ClassQueue::wait(std::chrono::milliseconds time) {
    std::unique_lock lock(mutex_);
    finished_.wait_for(lock, time, [&] { return done_ == classes_.size(); });
}

} // namespace plprove
