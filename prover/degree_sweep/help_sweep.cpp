// What the ranks do that do not lead.
#include "prover/degree_sweep/rank_messages.h"
#include "prover/degree_sweep/sweep.h"

#include <deque>
#include <filesystem>
#include <utility>

namespace plprove {

namespace {

using Clock = std::chrono::steady_clock;

constexpr std::chrono::milliseconds watch_interval{100};
constexpr std::chrono::milliseconds message_interval{1};
/// MPI sends messages of this size without waiting for who receives them.
constexpr std::size_t longest_reason = 1000;

/// Between the threads of this rank, which want classes, and its first thread, which talks.
class Requests {
public:
    /// What rank 0 answers, once it has. Nothing after the end of the work.
    std::optional<std::size_t> next() {
        std::unique_lock lock(mutex_);
        ask(std::string(rank_messages::next));
        answered_.wait(lock, [&] { return ended_ || !classes_.empty(); });
        if (ended_) return std::nullopt;
        const std::size_t number = classes_.front();
        classes_.pop_front();
        return number;
    }

    void done(std::size_t number) {
        const std::lock_guard lock(mutex_);
        ask(rank_messages::with(rank_messages::done, number));
    }

    void give(std::size_t number) {
        const std::lock_guard lock(mutex_);
        classes_.push_back(number);
        answered_.notify_one();
    }

    void end() {
        const std::lock_guard lock(mutex_);
        ended_ = true;
        answered_.notify_all();
    }

    /// What the threads want to have said. Waits until there is something, or for this time.
    std::vector<std::string> messages(std::chrono::milliseconds time) {
        std::unique_lock lock(mutex_);
        asked_.wait_for(lock, time, [&] { return !messages_.empty(); });
        return std::exchange(messages_, {});
    }

private:
    void ask(std::string message) {
        messages_.push_back(std::move(message));
        asked_.notify_one();
    }

    std::mutex mutex_; ///< guards what follows
    std::condition_variable asked_, answered_;
    std::vector<std::string> messages_;
    std::deque<std::size_t> classes_;
    bool ended_ = false;
};

std::string reason_of(const std::exception_ptr& failure) {
    try {
        std::rethrow_exception(failure);
    } catch (const std::exception& error) {
        return std::string(error.what()).substr(0, longest_reason);
    }
}

/// Rank 0 has made the folder before it gives out a class.
void require_shared(const SweepFolder& folder) {
    if (!std::filesystem::is_directory(folder.path()))
        throw std::runtime_error("not every rank sees " + folder.path().string() +
                                 ": name a folder that all machines share");
}

/// Passes on what rank 0 says. Returns whether it ended the work.
bool listen(const Ranks& ranks, Requests& requests) {
    bool ended = false;
    while (const std::optional<Message> message = ranks.receive())
        if (rank_messages::says(message->text, rank_messages::end))
            ended = true;
        else
            requests.give(rank_messages::number_in(message->text));
    if (ended) requests.end();
    return ended;
}

} // namespace

void help_sweep(const SweepFolder& folder, const DegreeOptions& options, unsigned threads,
                const Ranks& ranks, const ComputeDegree& compute,
                const std::function<void()>& pause) {
    Requests requests;
    const auto next = [&] {
        const std::optional<std::size_t> number = requests.next();
        if (number) require_shared(folder);
        return number;
    };
    Workers workers(folder, options, threads, compute,
                    {next, [&](std::size_t number) { requests.done(number); }});
    bool ended = false, complained = false;
    Clock::time_point due = Clock::now();
    while (!ended || workers.working() > 0) {
        for (const std::string& message : requests.messages(message_interval))
            ranks.send(0, message);
        ended = listen(ranks, requests) || ended;
        if (const std::exception_ptr failure = workers.failure(); failure && !complained) {
            ranks.send(0, rank_messages::with(rank_messages::failed, reason_of(failure)));
            complained = true;
        }
        if (Clock::now() >= due) {
            workers.between_files(pause);
            due = Clock::now() + watch_interval;
        }
    }
    ranks.send(0, std::string(rank_messages::left));
}

} // namespace plprove
