// join_ranks() by MPI.
#include "prover/system/ranks.h"

#include <chrono>
#include <cstdint>
#include <exception>
#include <memory>
#include <mpi.h>
#include <stdexcept>
#include <thread>

namespace plprove {

namespace {

/// MPI, from its start to its end.
class Session {
public:
    Session() {
        int provided = MPI_THREAD_SINGLE;
        // Ranks compute in threads, but only the first thread talks.
        MPI_Init_thread(nullptr, nullptr, MPI_THREAD_FUNNELED, &provided);
        if (provided >= MPI_THREAD_FUNNELED) return;
        MPI_Finalize();
        throw std::runtime_error("this MPI permits no threads: use Open MPI");
    }
    Session(const Session&) = delete;
    Session& operator=(const Session&) = delete;
    ~Session() {
        if (std::uncaught_exceptions() == 0) MPI_Finalize();
    }

    int number() const {
        int number = 0;
        MPI_Comm_rank(MPI_COMM_WORLD, &number);
        return number;
    }

    int count() const {
        int count = 1;
        MPI_Comm_size(MPI_COMM_WORLD, &count);
        return count;
    }

    /// Looks now and then: MPI itself would wait by asking all the time.
    std::size_t sum(std::size_t given) const {
        constexpr std::chrono::milliseconds interval{20};
        const std::uint64_t part = given;
        std::uint64_t sum = 0;
        MPI_Request request = MPI_REQUEST_NULL;
        MPI_Iallreduce(&part, &sum, 1, MPI_UINT64_T, MPI_SUM, MPI_COMM_WORLD, &request);
        int done = 0;
        while (MPI_Test(&request, &done, MPI_STATUS_IGNORE) == MPI_SUCCESS && done == 0)
            std::this_thread::sleep_for(interval);
        return sum;
    }
};

} // namespace

Ranks join_ranks() {
    if (ranks_started() == 1) return {};
    const auto session = std::make_shared<const Session>();
    return {session->number(), session->count(),
            [session](std::size_t given) { return session->sum(given); }};
}

} // namespace plprove
