// join_ranks() by MPI.
#include "prover/system/ranks.h"

#include <memory>
#include <mpi.h>
#include <stdexcept>

namespace plprove {

namespace {

constexpr int tag = 0;

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
    ~Session() { MPI_Finalize(); }

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

    void send(int to, const std::string& text) const {
        MPI_Send(text.data(), static_cast<int>(text.size()), MPI_CHAR, to, tag, MPI_COMM_WORLD);
    }

    std::optional<Message> receive() const {
        int arrived = 0;
        MPI_Status status;
        MPI_Iprobe(MPI_ANY_SOURCE, tag, MPI_COMM_WORLD, &arrived, &status);
        if (arrived == 0) return std::nullopt;
        int size = 0;
        MPI_Get_count(&status, MPI_CHAR, &size);
        Message message{status.MPI_SOURCE, std::string(static_cast<std::size_t>(size), '\0')};
        MPI_Recv(message.text.data(), size, MPI_CHAR, message.from, tag, MPI_COMM_WORLD,
                 MPI_STATUS_IGNORE);
        return message;
    }
};

} // namespace

Ranks join_ranks() {
    if (ranks_started() == 1) return only_rank();
    const auto session = std::make_shared<const Session>();
    return {session->number(), session->count(),
            [session](int to, const std::string& text) { session->send(to, text); },
            [session] { return session->receive(); }};
}

} // namespace plprove
