// plprove with a fake engine. Each class takes PLC_FAKE_ENGINE_MS milliseconds. Of a process with
// PLC_FAKE_ENGINE_STOP=N (under mpirun: of the rank PLC_FAKE_ENGINE_RANK) the N-th class and all
// later ones never end; as the N-th begins, the process gets the signal PLC_FAKE_ENGINE_SIGNAL,
// where there is one. So tests need not hit a moment.
#include "prover/cli/program.h"
#include "tests/fake_engine/fake_engine.h"

#include <atomic>
#include <chrono>
#include <csignal>
#include <cstdlib>
#include <string_view>
#include <thread>
#include <unistd.h>

namespace {

int setting(const char* name) {
    const char* text = std::getenv(name);
    return text == nullptr ? 0 : std::atoi(text);
}

bool is_ignored(int signal) {
    struct sigaction action {};
    return ::sigaction(signal, nullptr, &action) == 0 && action.sa_handler == SIG_IGN;
}

bool this_rank_stops() {
    const char* wanted = std::getenv("PLC_FAKE_ENGINE_RANK");
    const char* rank = std::getenv("OMPI_COMM_WORLD_RANK");
    return wanted == nullptr || (rank != nullptr && std::string_view(rank) == wanted);
}

/// Before the class of this number, counted from 1 in this process. An ignored signal stops
/// nothing.
void stop_at(int begun) {
    const int last = this_rank_stops() ? setting("PLC_FAKE_ENGINE_STOP") : 0;
    if (last == 0 || begun < last) return;
    const int signal = setting("PLC_FAKE_ENGINE_SIGNAL");
    if (signal != 0) {
        if (begun == last) ::kill(::getpid(), signal);
        if (is_ignored(signal)) return;
    }
    std::this_thread::sleep_for(std::chrono::minutes(10)); // the test has failed then
    std::_Exit(99);
}

} // namespace

int main(int argc, char** argv) {
    const std::chrono::milliseconds pause(setting("PLC_FAKE_ENGINE_MS"));
    std::atomic<int> begun = 0;
    return plprove::run_plprove(argc, argv,
                                [&](std::size_t number, const plprove::DegreeOptions& options) {
                                    stop_at(++begun);
                                    std::this_thread::sleep_for(pause);
                                    return fake_engine::compute(number, options);
                                });
}
