#include "prover/system/atomic_file.h"

#include <cerrno>
#include <cstdio>
#include <fcntl.h>
#include <random>
#include <string>
#include <system_error>
#include <unistd.h>
#include <utility>

namespace plprove {

namespace {

namespace fs = std::filesystem;

constexpr mode_t rights_of_new_files = 0666; // the user's umask takes from these

[[noreturn]] void fail(int error, const fs::path& path) {
    throw std::system_error(error, std::generic_category(), "cannot write " + path.string());
}

fs::path folder_of(const fs::path& path) {
    return path.has_parent_path() ? path.parent_path() : fs::path(".");
}

/// A name in the folder of `path` that no other process has thought of.
std::string unused_name(const fs::path& path) {
    std::random_device random;
    char suffix[2 * 8 + 1];
    std::snprintf(suffix, sizeof suffix, "%08x%08x", random(), random());
    return (folder_of(path) / ".plprove-").string() + suffix;
}

/// An open file that is being written for `path`, which names the file in messages.
class OpenFile {
public:
    OpenFile(int descriptor, const fs::path& path) : path_(path), descriptor_(descriptor) {
        if (descriptor_ < 0) fail(errno, path_);
    }
    OpenFile(const OpenFile&) = delete;
    OpenFile& operator=(const OpenFile&) = delete;
    ~OpenFile() {
        if (descriptor_ >= 0) ::close(descriptor_);
    }

    int descriptor() const { return descriptor_; }

    void write(std::string_view content) {
        while (!content.empty()) {
            const auto written = ::write(descriptor_, content.data(), content.size());
            if (written < 0 && errno == EINTR) continue;
            if (written < 0) fail(errno, path_);
            content.remove_prefix(static_cast<std::size_t>(written));
        }
    }

private:
    const fs::path& path_;
    int descriptor_;
};

/// The file before it has its name. Where the file system permits, it has no name at all, and the
/// kernel drops it with the process; elsewhere it has a hidden one, and is removed unless the
/// process is killed.
class TemporaryFile {
public:
    /// `path` is what messages call the target.
    TemporaryFile(const fs::path& target, const fs::path& path)
        : target_(target), path_(path), file_(open(), path) {}
    TemporaryFile(const TemporaryFile&) = delete;
    TemporaryFile& operator=(const TemporaryFile&) = delete;
    ~TemporaryFile() {
        if (!name_.empty()) ::unlink(name_.c_str());
    }

    void write(std::string_view content) {
        file_.write(content);
        if (::fsync(file_.descriptor()) < 0) fail(errno, path_);
    }

    void move_to_target() {
        if (!name_.empty() || !link(target_)) replace_target();
        sync_folder();
    }

private:
    int open() {
        const int nameless = ::open(folder_of(target_).c_str(), O_TMPFILE | O_WRONLY | O_CLOEXEC,
                                    rights_of_new_files);
        if (nameless >= 0 && ::access(link_to(nameless).c_str(), F_OK) == 0) return nameless;
        if (nameless >= 0) ::close(nameless); // without /proc it could not be named
        name_ = unused_name(target_);
        const int named =
            ::open(name_.c_str(), O_CREAT | O_EXCL | O_WRONLY | O_CLOEXEC, rights_of_new_files);
        if (named < 0) name_.clear();
        return named;
    }

    static std::string link_to(int descriptor) {
        return "/proc/self/fd/" + std::to_string(descriptor);
    }

    /// Gives the nameless file a name; false if something has this name already.
    bool link(const fs::path& name) {
        if (::linkat(AT_FDCWD, link_to(file_.descriptor()).c_str(), AT_FDCWD, name.c_str(),
                     AT_SYMLINK_FOLLOW) == 0)
            return true;
        if (errno != EEXIST) fail(errno, path_);
        return false;
    }

    /// Only rename() replaces an old file at a stroke, and it takes a name.
    void replace_target() {
        if (name_.empty()) {
            std::string name = unused_name(target_);
            if (!link(name)) fail(errno, path_);
            name_ = std::move(name);
        }
        if (::rename(name_.c_str(), target_.c_str()) < 0) fail(errno, path_);
        name_.clear();
    }

    /// The name itself survives a power failure only once the folder is on the disk.
    void sync_folder() const {
        const int folder = ::open(folder_of(target_).c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
        if (folder < 0) return;
        ::fsync(folder);
        ::close(folder);
    }

    fs::path target_;
    const fs::path& path_;
    std::string name_; // before file_, which may be given one when it is opened
    OpenFile file_;
};

} // namespace

void write_atomically(const fs::path& path, std::string_view content) {
    std::error_code ignored; // opening the file says better what is wrong
    const fs::file_status status = fs::status(path, ignored);
    if (fs::exists(status) && !fs::is_regular_file(status)) {
        OpenFile device(::open(path.c_str(), O_WRONLY | O_CLOEXEC), path);
        return device.write(content);
    }
    TemporaryFile file(fs::exists(status) ? fs::canonical(path) : path, path);
    file.write(content);
    file.move_to_target();
}

} // namespace plprove
