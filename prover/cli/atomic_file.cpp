#include "prover/cli/atomic_file.h"

#include <cerrno>
#include <cstdlib>
#include <fcntl.h>
#include <string>
#include <sys/stat.h>
#include <system_error>
#include <unistd.h>
#include <utility>

namespace plprove {

namespace {

[[noreturn]] void fail(int error, const std::filesystem::path& path) {
    throw std::system_error(error, std::generic_category(), "cannot write " + path.string());
}

/// A temporary file that vanishes unless it is renamed.
class TemporaryFile {
public:
    explicit TemporaryFile(const std::filesystem::path& target)
        : target_(target), name_(target.string() + ".XXXXXX") {
        descriptor_ = ::mkstemp(name_.data());
        if (descriptor_ < 0) fail(errno, target_);
    }
    TemporaryFile(const TemporaryFile&) = delete;
    TemporaryFile& operator=(const TemporaryFile&) = delete;
    ~TemporaryFile() {
        if (descriptor_ >= 0) ::close(descriptor_);
        if (!name_.empty()) ::unlink(name_.c_str());
    }

    void write(std::string_view content) {
        while (!content.empty()) {
            const auto written = ::write(descriptor_, content.data(), content.size());
            if (written < 0 && errno == EINTR) continue;
            if (written < 0) fail(errno, target_);
            content.remove_prefix(static_cast<std::size_t>(written));
        }
    }

    void rename_to_target() {
        // mkstemp gives the file to its owner alone; the rights should be those of any new file.
        const mode_t mask = ::umask(0);
        ::umask(mask);
        if (::fchmod(descriptor_, 0666 & ~mask) < 0 || ::fsync(descriptor_) < 0)
            fail(errno, target_);
        if (::close(std::exchange(descriptor_, -1)) < 0) fail(errno, target_);
        if (::rename(name_.c_str(), target_.c_str()) < 0) fail(errno, target_);
        name_.clear();
        sync_folder();
    }

private:
    /// The rename itself survives a power failure only once the folder is on the disk.
    void sync_folder() const {
        const std::filesystem::path folder =
            target_.has_parent_path() ? target_.parent_path() : std::filesystem::path(".");
        const int descriptor = ::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
        if (descriptor < 0) return;
        ::fsync(descriptor);
        ::close(descriptor);
    }

    std::filesystem::path target_;
    std::string name_;
    int descriptor_ = -1;
};

} // namespace

void write_atomically(const std::filesystem::path& path, std::string_view content) {
    TemporaryFile file(path);
    file.write(content);
    file.rename_to_target();
}

} // namespace plprove
