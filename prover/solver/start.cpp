#include "prover/solver/start.h"

#include "prover/catalogue/degrees.h"
#include "prover/solver/placement.h"
#include "prover/system/atomic_file.h"
#include "prover/system/exit.h"
#include "prover/three_views/camera_loops.h"

#include <cstdlib>
#include <fstream>
#include <iterator>
#include <system_error>

namespace plprove {

namespace {

namespace fs = std::filesystem;

/// With these random numbers.
Start attempt_start(const CameraSystem& system, std::size_t number, int degree, std::uint64_t seed,
                    std::uint64_t attempt) {
    constexpr int most_edges = 10;
    // No certificate will find out that something is no solution.
    constexpr double suspicious = 1e-6;
    auto monodromy =
        camera_monodromy(CameraLoops(system, seed, number + (attempt << 32U), suspicious));
    monodromy.reach(degree, most_edges);
    const CameraLoops& loops = monodromy.loops();
    return {number, loops.chart(), loops.constants(), loops.images(),
            monodromy.solutions().points()};
}

int degree_of(std::size_t number) {
    const std::vector<Signature>& classes = label_classes();
    return degree_on_file(class_number(classes, constraint_representative(classes[number])))
        .value();
}

} // namespace

Start find_start(std::size_t number, std::uint64_t seed) {
    constexpr std::uint64_t most_attempts = 3;
    const CameraSystem system = camera_system(label_classes()[number]);
    const int degree = degree_of(number);
    Start best = attempt_start(system, number, degree, seed, 0);
    for (std::uint64_t attempt = 1; attempt < most_attempts && best.degree() != degree; ++attempt) {
        Start again = attempt_start(system, number, degree, seed, attempt);
        if (again.degree() == degree) best = std::move(again);
    }
    return well_placed(std::move(best), seed);
}

namespace {

/// The folder that the variable names, if its path is absolute.
std::optional<fs::path> folder_in(const char* variable) {
    const char* value = std::getenv(variable);
    if (value == nullptr || !fs::path(value).is_absolute()) return std::nullopt;
    return fs::path(value);
}

std::optional<Start> start_in(const fs::path& file, std::size_t number) {
    std::ifstream stream(file, std::ios::binary);
    if (!stream) return std::nullopt;
    const std::string text(std::istreambuf_iterator<char>(stream), {});
    try {
        Start start = read_start(text, file.string());
        if (start.number == number) return start;
    } catch (const BadInput&) {
        // Made again, and replaced.
    }
    return std::nullopt;
}

} // namespace

std::optional<fs::path> start_cache() {
    if (const auto cache = folder_in("XDG_CACHE_HOME")) return *cache / "pointline";
    if (const auto home = folder_in("HOME")) return *home / ".cache" / "pointline";
    return std::nullopt;
}

Start cached_start(std::size_t number) {
    const auto folder = start_cache();
    if (!folder) return find_start(number, 0);
    const fs::path file = *folder / (std::to_string(number) + ".start");
    if (auto start = start_in(file, number)) return *start;
    Start start = find_start(number, 0);
    std::error_code ignored;
    fs::create_directories(*folder, ignored);
    try {
        write_atomically(file, write_start(start));
    } catch (const std::system_error&) {
        // A cache that cannot be written is none.
    }
    return start;
}

} // namespace plprove
