// plprove with a fake engine. Each class takes PLC_FAKE_ENGINE_MS milliseconds.
#include "prover/cli/program.h"
#include "tests/fake_engine/fake_engine.h"

#include <chrono>
#include <cstdlib>
#include <thread>

int main(int argc, char** argv) {
    const char* text = std::getenv("PLC_FAKE_ENGINE_MS");
    const std::chrono::milliseconds pause(text == nullptr ? 0 : std::atoi(text));
    return plprove::run_plprove(argc, argv,
                                [&](std::size_t number, const plprove::DegreeOptions& options) {
                                    std::this_thread::sleep_for(pause);
                                    return fake_engine::compute(number, options);
                                });
}
