#include "tests/packaging/installation.h"

#include <stdexcept>

const std::filesystem::path& installed() {
    static const TemporaryFolder folder;
    static const Outcome outcome =
        run("cmake --install " BUILD_DIR " --prefix " + folder.path().string());
    if (outcome.status != 0) throw std::runtime_error("cmake --install failed: " + outcome.err);
    return folder.path();
}

bool has_program(const std::string& name) {
    return run("command -v " + name).status == 0;
}
