#include "prover/degree_sweep/sweep.h"

#include <atomic>
#include <chrono>
#include <condition_variable>
#include <exception>
#include <mutex>
#include <new>
#include <numeric>
#include <shared_mutex>
#include <thread>

namespace plprove {

namespace {

using Clock = std::chrono::steady_clock;

/// How often the user is told, and signals are looked for.
constexpr std::chrono::milliseconds watch_interval{100};

double seconds_since(Clock::time_point begin) {
    return std::chrono::duration<double>(Clock::now() - begin).count();
}

DegreeRun run_of(const SweepItem& item, DegreeOptions options, const ComputeDegree& compute) {
    options.degree = item.degree;
    try {
        return compute(item.number, options);
    } catch (const std::bad_alloc&) {
        throw; // says nothing about the item
    } catch (const std::exception& error) {
        DegreeRun failed;
        failed.number = item.number;
        failed.problem = item.problem;
        failed.notes = {std::string("the computation failed: ") + error.what()};
        return failed;
    }
}

/// The threads of a sweep. Each takes an item, computes it, puts the result on file, and takes the
/// next one.
class Workers {
public:
    Workers(const SweepFolder& folder, const SweepPlan& plan, const ComputeDegree& compute)
        : folder_(folder), plan_(plan), compute_(compute),
          whole_cost_(std::accumulate(plan.costs.begin(), plan.costs.end(), 0.0)),
          working_(plan.threads) {
        for (unsigned i = 0; i < plan.threads; ++i)
            threads_.emplace_back([this] { work(); });
    }
    Workers(const Workers&) = delete;
    Workers& operator=(const Workers&) = delete;
    /// Waits for the items that are being computed.
    ~Workers() { stopped_ = true; }

    SweepProgress progress() const {
        const std::lock_guard lock(mutex_);
        return {done_, plan_.numbers.size(), seconds_since(begin_), cost_ / whole_cost_};
    }

    /// Calls a function while no thread writes a file.
    void between_files(const std::function<void()>& function) {
        const std::unique_lock nobody_writes(writing_);
        function();
    }

    /// Whether all threads have ended, now or within this time.
    bool ended_within(std::chrono::milliseconds time) {
        std::unique_lock lock(mutex_);
        return ended_.wait_for(lock, time, [&] { return working_ == 0; });
    }

    /// Once all have ended: throws what one of them threw.
    void require_success() const {
        if (failure_) std::rethrow_exception(failure_);
    }

private:
    void work() {
        std::exception_ptr failure;
        try {
            for (std::size_t i = next_++; i < plan_.numbers.size() && !stopped_; i = next_++)
                compute(i);
        } catch (...) {
            failure = std::current_exception();
            stopped_ = true;
        }
        const std::lock_guard lock(mutex_);
        if (!failure_) failure_ = failure;
        --working_;
        ended_.notify_all();
    }

    void compute(std::size_t index) {
        const Clock::time_point begin = Clock::now();
        DegreeRun run = run_of(folder_.subject().at(plan_.numbers[index]), plan_.options, compute_);
        const SweepResult result =
            sweep_result(std::move(run), plan_.options, seconds_since(begin));
        {
            const std::shared_lock writes(writing_);
            folder_.save(result);
        }
        const std::lock_guard lock(mutex_);
        ++done_;
        cost_ += plan_.costs[index];
    }

    const SweepFolder& folder_;
    const SweepPlan& plan_;
    const ComputeDegree& compute_;
    const double whole_cost_;
    const Clock::time_point begin_ = Clock::now();
    std::atomic<std::size_t> next_ = 0; ///< index of an item
    std::atomic<bool> stopped_ = false; ///< no thread takes another item
    std::shared_mutex writing_; ///< shared by the threads that write, not with between_files()
    mutable std::mutex mutex_;  ///< guards what follows
    std::condition_variable ended_;
    unsigned working_;
    std::size_t done_ = 0;
    double cost_ = 0;
    std::exception_ptr failure_;
    std::vector<std::jthread> threads_; // last: they use all the others
};

} // namespace

void sweep(const SweepFolder& folder, const SweepPlan& plan, const ComputeDegree& compute,
           const SweepWatch& watch) {
    Workers workers(folder, plan, compute);
    do {
        watch.progress(workers.progress());
        workers.between_files(watch.pause);
    } while (!workers.ended_within(watch_interval));
    workers.require_success();
}

} // namespace plprove
