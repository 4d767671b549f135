// The threads of a process that computes degrees. Each takes a class, computes it, puts the result
// on file, and takes the next one.
#pragma once

#include "prover/degree_sweep/folder.h"

#include <atomic>
#include <exception>
#include <functional>
#include <mutex>
#include <shared_mutex>
#include <thread>

namespace plprove {

/// compute_degree, or another engine in its place. Called by several threads at a time.
using ComputeDegree = std::function<DegreeRun(std::size_t, const DegreeOptions&)>;

/// Where the threads get their classes from. Both functions are called by several threads at a
/// time.
struct ClassSource {
    /// The number of the next class; nothing where none is left. May wait.
    std::function<std::optional<std::size_t>()> next;
    /// Told once the result of a class is on file.
    std::function<void(std::size_t)> done;
};

class Workers {
public:
    Workers(const SweepFolder& folder, const DegreeOptions& options, unsigned threads,
            const ComputeDegree& compute, ClassSource source);
    Workers(const Workers&) = delete;
    Workers& operator=(const Workers&) = delete;
    /// Waits for the classes that are being computed.
    ~Workers() { stopped_ = true; }

    /// How many threads still work.
    unsigned working() const { return working_; }
    /// What a thread threw, if one did: a file could not be written, or there is no memory left.
    /// Then no thread takes another class.
    std::exception_ptr failure() const;
    /// Calls a function while no thread writes a file.
    void between_files(const std::function<void()>& function);
    /// Waits for the threads. Throws what one of them threw.
    void finish();

private:
    void work();
    bool compute_next();

    const SweepFolder& folder_;
    DegreeOptions options_;
    const ComputeDegree& compute_;
    ClassSource source_;
    std::atomic<bool> stopped_ = false;
    std::atomic<unsigned> working_;
    std::shared_mutex writing_; ///< shared by the threads that write, not with between_files()
    mutable std::mutex mutex_;  ///< guards the failure
    std::exception_ptr failure_;
    std::vector<std::jthread> threads_; // last: they use all the others
};

} // namespace plprove
