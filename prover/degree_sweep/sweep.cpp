#include "prover/degree_sweep/sweep.h"

#include "prover/degree_sweep/rank_messages.h"

#include <thread>

namespace plprove {

namespace {

using Clock = std::chrono::steady_clock;

/// How often the user is told, and signals are looked for.
constexpr std::chrono::milliseconds watch_interval{100};
/// How often a rank looks for messages: a class takes a thousand times as long.
constexpr std::chrono::milliseconds message_interval{1};

/// Does what the message asks for. A rank that asks for a class where none is left waits for the
/// end.
void answer(const Message& message, ClassQueue& queue, const Ranks& ranks) {
    using namespace rank_messages;
    if (says(message.text, done)) {
        queue.done(number_in(message.text));
    } else if (says(message.text, failed)) {
        throw std::runtime_error(std::string(rest_of(message.text)));
    } else if (says(message.text, next)) {
        if (const std::optional<std::size_t> number = queue.next())
            ranks.send(message.from, with(compute, *number));
    }
}

} // namespace

void sweep(const SweepFolder& folder, const SweepPlan& plan, const Ranks& ranks,
           const ComputeDegree& compute, const SweepWatch& watch) {
    ClassQueue queue(plan);
    Workers workers(
        folder, plan.options, plan.threads, compute,
        {[&] { return queue.next(); }, [&](std::size_t number) { queue.done(number); }});
    const auto interval = ranks.count > 1 ? message_interval : watch_interval;
    Clock::time_point due = Clock::now();
    while (queue.unfinished() > 0 && !workers.failure()) {
        while (const std::optional<Message> message = ranks.receive())
            answer(*message, queue, ranks);
        if (Clock::now() >= due) {
            watch.progress(queue.progress());
            workers.between_files(watch.pause);
            due = Clock::now() + watch_interval;
        }
        queue.wait(interval);
    }
    workers.finish();
}

EndOfWork::~EndOfWork() {
    for (int rank = 1; rank < ranks_.count; ++rank)
        ranks_.send(rank, std::string(rank_messages::end));
    for (int left = 1; left < ranks_.count;) {
        const std::optional<Message> message = ranks_.receive();
        if (!message)
            std::this_thread::sleep_for(message_interval);
        else if (rank_messages::says(message->text, rank_messages::left))
            ++left;
    }
}

} // namespace plprove
