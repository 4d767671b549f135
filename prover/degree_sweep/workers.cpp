#include "prover/degree_sweep/workers.h"

#include "prover/catalogue/degrees.h"

#include <chrono>
#include <new>

namespace plprove {

namespace {

DegreeRun run_of(std::size_t number, DegreeOptions options, const ComputeDegree& compute) {
    options.degree = degree_on_file(number).value_or(0);
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

} // namespace

Workers::Workers(const SweepFolder& folder, const DegreeOptions& options, unsigned threads,
                 const ComputeDegree& compute, ClassSource source)
    : folder_(folder), options_(options), compute_(compute), source_(std::move(source)),
      working_(threads) {
    for (unsigned i = 0; i < threads; ++i)
        threads_.emplace_back([this] { work(); });
}

std::exception_ptr Workers::failure() const {
    const std::lock_guard lock(mutex_);
    return failure_;
}

void Workers::between_files(const std::function<void()>& function) {
    const std::unique_lock nobody_writes(writing_);
    function();
}

void Workers::finish() {
    threads_.clear();
    if (failure_) std::rethrow_exception(failure_);
}

void Workers::work() {
    try {
        while (!stopped_)
            if (!compute_next()) break;
    } catch (...) {
        stopped_ = true;
        const std::lock_guard lock(mutex_);
        if (!failure_) failure_ = std::current_exception();
    }
    --working_;
}

/// Whether there was a class left to compute.
bool Workers::compute_next() {
    const std::optional<std::size_t> number = source_.next();
    if (!number) return false;
    const auto begin = std::chrono::steady_clock::now();
    DegreeRun run = run_of(*number, options_, compute_);
    const std::chrono::duration<double> elapsed = std::chrono::steady_clock::now() - begin;
    const ClassResult result = class_result(std::move(run), options_, elapsed.count());
    {
        const std::shared_lock writes(writing_);
        folder_.save(result);
    }
    source_.done(*number);
    return true;
}

} // namespace plprove
