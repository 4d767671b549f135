// The processes that mpirun or srun started together: MPI calls them ranks. A plprove that was
// started alone, or built without MPI, is the only rank.
#pragma once

#include <functional>
#include <optional>
#include <string>

namespace plprove {

struct Message {
    int from = 0; ///< the rank that sent it
    std::string text;
};

/// One rank, and how it talks to the others. Only the thread that joined may call the functions.
struct Ranks {
    int number = 0; ///< of this rank: from 0 to count - 1
    int count = 1;

    /// Sends a short text to another rank. Messages from one rank to another arrive in order.
    std::function<void(int to, const std::string& text)> send;
    /// A message that has arrived, if there is one. Does not wait.
    std::function<std::optional<Message>()> receive;

    /// Rank 0 leads: it plans, speaks, and collects.
    bool leads() const { return number == 0; }
};

/// The only rank: it has nobody to talk to.
Ranks only_rank();

/// How many ranks were started together, as the environment says; 1 outside mpirun and srun.
int ranks_started();

/// The number of this rank, as the environment says; 0 outside mpirun and srun.
int number_of_rank();

/// For what is wrong with all ranks alike, as with their command line: rank 0 says it. Any other
/// one ends here with this status, a second later: mpirun ends them all as soon as one has failed.
void leave_words_to_rank_0(int status);

/// Joins the ranks that were started together. MPI ends with the last copy of the result, and waits
/// there for all ranks. Throws BadInput if there are several, and this plprove was built without
/// MPI. A plprove that was started alone does not start MPI.
Ranks join_ranks();

} // namespace plprove
