#include "prover/system/ranks.h"

#include <charconv>
#include <chrono>
#include <cstdlib>
#include <optional>
#include <string_view>
#include <thread>

namespace plprove {

namespace {

/// The number that a variable of the environment has.
std::optional<int> number_in(const char* variable) {
    const char* value = std::getenv(variable);
    if (value == nullptr) return std::nullopt;
    const std::string_view text = value;
    int number = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
    if (error != std::errc{} || end != text.data() + text.size()) return std::nullopt;
    return number;
}

} // namespace

int ranks_started() {
    if (const auto by_mpirun = number_in("OMPI_COMM_WORLD_SIZE")) return *by_mpirun;
    if (const auto by_pmi = number_in("PMI_SIZE")) return *by_pmi;
    // Slurm sets the number of tasks for steps without MPI, too: only PMIx says that it starts MPI.
    if (number_in("PMIX_RANK")) return number_in("SLURM_STEP_NUM_TASKS").value_or(1);
    return 1;
}

int number_of_rank() {
    for (const char* variable : {"OMPI_COMM_WORLD_RANK", "PMI_RANK", "PMIX_RANK"})
        if (const auto number = number_in(variable)) return *number;
    return 0;
}

void leave_words_to_rank_0(int status) {
    if (number_of_rank() == 0) return;
    std::this_thread::sleep_for(std::chrono::seconds(1));
    std::exit(status);
}

} // namespace plprove
