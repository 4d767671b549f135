// Computes the degrees of many classes, several at a time, by the threads of one process or of many
// ranks, and keeps each result as soon as it is there. Which thread computes which class, and when,
// has no part in any result.
#pragma once

#include "prover/degree_sweep/class_queue.h"
#include "prover/degree_sweep/workers.h"
#include "prover/system/ranks.h"

#include <functional>

namespace plprove {

/// Called a few times a second by the thread that called sweep().
struct SweepWatch {
    std::function<void(const SweepProgress&)> progress;
    /// While no file is being written: may end the process.
    std::function<void()> pause;
};

/// Computes the classes of the plan, and gives them to the other ranks, if there are any. A class
/// whose computation throws is put on file as one without solutions, with the reason as a
/// note. Throws what writing a file throws, or std::bad_alloc, or std::runtime_error with what
/// another rank threw, once the classes that this process computes are done with.
void sweep(const SweepFolder& folder, const SweepPlan& plan, const Ranks& ranks,
           const ComputeDegree& compute, const SweepWatch& watch);

/// What the ranks that do not lead do: computes the classes that rank 0 gives out, and puts them on
/// file, until rank 0 ends the work. All ranks share the folder. `pause` is that of SweepWatch.
void help_sweep(const SweepFolder& folder, const DegreeOptions& options, unsigned threads,
                const Ranks& ranks, const ComputeDegree& compute,
                const std::function<void()>& pause);

/// Ends the work of the other ranks when it goes, and waits until they are done with the classes
/// that they were computing. Rank 0 has one, whether it comes to a sweep or not.
class EndOfWork {
public:
    explicit EndOfWork(const Ranks& ranks) : ranks_(ranks) {}
    EndOfWork(const EndOfWork&) = delete;
    EndOfWork& operator=(const EndOfWork&) = delete;
    ~EndOfWork();

private:
    const Ranks& ranks_;
};

} // namespace plprove
