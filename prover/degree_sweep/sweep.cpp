#include "prover/degree_sweep/sweep.h"

#include "prover/catalogue/degrees.h"

#include <atomic>
#include <chrono>
#include <condition_variable>
#include <exception>
#include <limits>
#include <mutex>
#include <new>
#include <shared_mutex>
#include <thread>

namespace plprove {

namespace {

using Clock = std::chrono::steady_clock;

constexpr std::chrono::milliseconds watch_interval{100};

double seconds_since(Clock::time_point begin) {
    return std::chrono::duration<double>(Clock::now() - begin).count();
}

DegreeRun run_of(std::size_t number, const DegreeOptions& options, const ComputeDegree& compute) {
    try {
        return compute(number, options);
    } catch (const std::bad_alloc&) {
        throw; // says nothing about the class
    } catch (const std::exception& error) {
        DegreeRun failed;
        failed.number = number;
        failed.notes = {std::string("the computation failed: ") + error.what()};
        return failed;
    }
}

/// The threads of a sweep and what they share.
class Workers {
public:
    Workers(const SweepFolder& folder, const SweepPlan& plan, const ComputeDegree& compute)
        : folder_(folder), plan_(plan), compute_(compute), working_(plan.threads) {
        for (unsigned i = 0; i < plan.threads; ++i)
            threads_.emplace_back([this] { work(); });
    }
    Workers(const Workers&) = delete;
    Workers& operator=(const Workers&) = delete;
    ~Workers() { stopped_ = true; }

    /// Until all threads are done, or one has failed.
    void watch(const SweepWatch& watch) {
        const Clock::time_point begin = Clock::now();
        std::unique_lock lock(mutex_);
        while (working_ > 0 && !failure_) {
            SweepProgress progress = progress_;
            lock.unlock();
            progress.total = plan_.classes.size();
            progress.seconds = seconds_since(begin);
            watch.progress(progress);
            {
                const std::unique_lock nobody_writes(writing_);
                watch.pause();
            }
            lock.lock();
            changed_.wait_for(lock, watch_interval, [&] { return working_ == 0 || failure_; });
        }
    }

    /// Waits for the threads. Throws what one of them threw.
    void finish() {
        threads_.clear();
        if (failure_) std::rethrow_exception(failure_);
    }

private:
    void work() {
        try {
            while (!stopped_)
                if (!compute_next()) break;
        } catch (...) {
            stopped_ = true;
            const std::lock_guard lock(mutex_);
            if (!failure_) failure_ = std::current_exception();
        }
        const std::lock_guard lock(mutex_);
        --working_;
        changed_.notify_all();
    }

    /// Whether there was a class left to compute.
    bool compute_next() {
        const std::size_t index = next_++;
        if (index >= plan_.classes.size()) return false;
        const Clock::time_point begin = Clock::now();
        DegreeRun run = run_of(plan_.classes[index], plan_.options, compute_);
        const double seconds = seconds_since(begin);
        const ClassResult result = class_result(std::move(run), plan_.options, seconds);
        {
            const std::shared_lock writes(writing_);
            folder_.save(result);
        }
        const std::lock_guard lock(mutex_);
        ++progress_.done;
        progress_.share += costs_[index];
        return true;
    }

    /// The costs of the plan, scaled so that they add up to 1.
    static std::vector<double> shares(std::vector<double> costs) {
        double sum = 0;
        for (const double cost : costs)
            sum += cost;
        for (double& cost : costs)
            cost /= sum;
        return costs;
    }

    const SweepFolder& folder_;
    const SweepPlan& plan_;
    const ComputeDegree& compute_;
    const std::vector<double> costs_ = shares(plan_.costs);
    std::atomic<std::size_t> next_ = 0;
    std::atomic<bool> stopped_ = false;
    std::shared_mutex writing_; ///< shared by the threads that write, not with who may end it all
    std::mutex mutex_;          ///< guards the four below
    std::condition_variable changed_;
    SweepProgress progress_;
    unsigned working_;
    std::exception_ptr failure_;
    std::vector<std::jthread> threads_; // last: they use all the others
};

} // namespace

SweepPlan plan_sweep(const SweepFolder& folder, const std::vector<std::size_t>& classes,
                     const DegreeOptions& options, bool retry) {
    const DegreeTable on_file(parse_degrees(degree_lines()), label_classes());
    constexpr double unknown = std::numeric_limits<double>::infinity();
    std::vector<std::pair<double, std::size_t>> wanted;
    double largest = 1; // of the known ones
    for (const std::size_t number : classes) {
        const std::optional<ClassResult> result = folder.read(number, false);
        if (result && (fulfils(*result, options) || (!retry && attempted(*result, options))))
            continue;
        double expected = result ? result->degree() : 0;
        if (expected == 0)
            for (const DegreeRecord& record : on_file.find(number, number))
                expected = std::max<double>(expected, record.degree);
        largest = std::max(largest, expected);
        wanted.emplace_back(expected > 0 ? expected : unknown, number);
    }
    std::ranges::sort(wanted);
    if (options.target > 0) largest = options.target;
    SweepPlan plan;
    plan.options = options;
    plan.on_file = classes.size() - wanted.size();
    for (const auto& [expected, number] : wanted) {
        plan.classes.push_back(number);
        plan.costs.push_back(std::min(expected, largest));
    }
    return plan;
}

void sweep(const SweepFolder& folder, const SweepPlan& plan, const ComputeDegree& compute,
           const SweepWatch& watch) {
    Workers workers(folder, plan, compute);
    workers.watch(watch);
    workers.finish();
}

} // namespace plprove
