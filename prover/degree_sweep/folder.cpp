#include "prover/degree_sweep/folder.h"

#include "prover/system/atomic_file.h"
#include "prover/system/exit.h"

#include <algorithm>
#include <cerrno>
#include <charconv>
#include <fcntl.h>
#include <stdexcept>
#include <sys/file.h>
#include <system_error>
#include <unistd.h>

namespace plprove {

namespace fs = std::filesystem;

namespace {

constexpr std::size_t classes_a_folder = 1000;
constexpr mode_t rights_of_new_files = 0666; // the user's umask takes from these

/// The number that a name `2394.plc` has.
std::optional<std::size_t> number_of(const fs::path& path) {
    if (path.extension() != ".plc") return std::nullopt;
    const std::string stem = path.stem();
    std::size_t number = 0;
    const auto [end, error] = std::from_chars(stem.data(), stem.data() + stem.size(), number);
    if (error != std::errc{} || end != stem.data() + stem.size()) return std::nullopt;
    return number;
}

} // namespace

FolderLock::FolderLock(const fs::path& folder) {
    fs::create_directories(folder);
    const fs::path path = folder / "lock";
    descriptor_ = ::open(path.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, rights_of_new_files);
    if (descriptor_ < 0)
        throw std::system_error(errno, std::generic_category(), "cannot write " + path.string());
    if (::flock(descriptor_, LOCK_EX | LOCK_NB) == 0) return;
    const int error = errno;
    ::close(descriptor_);
    if (error == EWOULDBLOCK)
        throw std::runtime_error("another sweep is at work in " + folder.string() +
                                 ": wait for it, or name another folder");
    throw std::system_error(error, std::generic_category(), "cannot lock " + path.string());
}

FolderLock::~FolderLock() {
    ::close(descriptor_);
}

SweepFolder::SweepFolder(fs::path folder, SweepSubject subject, std::uint64_t seed)
    : folder_(std::move(folder)), subject_(std::move(subject)),
      results_(folder_ / ((subject_.family.empty() ? "" : subject_.family + "-") + "seed-" +
                          std::to_string(seed))),
      seed_(seed) {}

fs::path SweepFolder::file_of(std::size_t number) const {
    std::string thousand = std::to_string(number / classes_a_folder);
    thousand.insert(0, 3 - std::min<std::size_t>(thousand.size(), 3), '0');
    return results_ / thousand / (std::to_string(number) + ".plc");
}

void SweepFolder::require_place(std::size_t number) const {
    const fs::path path = file_of(number);
    const fs::file_status status = fs::status(path);
    if (fs::exists(status) && !fs::is_regular_file(status))
        throw BadInput(path.string() + " is no regular file: remove it");
}

std::optional<SweepResult> SweepFolder::read(std::size_t number, bool whole) const {
    std::optional<SweepResult> result = read_sweep_result(file_of(number), whole);
    const bool this_one = result && result->run.number == number && result->seed == seed_ &&
                          result->run.problem == subject_.at(number).problem;
    return this_one ? result : std::nullopt;
}

void SweepFolder::save(SweepResult result) const {
    const fs::path path = file_of(result.run.number);
    if (std::optional<SweepResult> old = read(result.run.number, true))
        result = merged(std::move(*old), std::move(result));
    fs::create_directories(path.parent_path());
    write_atomically(path, write(result));
}

std::vector<std::size_t> SweepFolder::numbers() const {
    std::vector<std::size_t> numbers;
    if (!fs::exists(results_)) return numbers;
    for (const auto& entry : fs::recursive_directory_iterator(results_))
        if (const auto number = number_of(entry.path());
            number && subject_.find(*number) != nullptr &&
            file_of(*number) == entry.path()) // no copy elsewhere, and no 04.plc
            numbers.push_back(*number);
    std::ranges::sort(numbers);
    return numbers;
}

} // namespace plprove
