// Running the built programs as a user would, and temporary folders for their files.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

/// What a command printed and how it ended.
struct Outcome {
    int status = -1; ///< exit status, or 128 + signal
    std::string out;
    std::string err;
};

/// Runs a shell command line.
Outcome run(const std::string& command);
/// Runs it where no file may have content, as if the disk were full. What it says is lost.
Outcome run_with_full_disk(const std::string& command);

/// The whole of a file.
std::string read_file(const std::filesystem::path& path);
void write_file(const std::filesystem::path& path, const std::string& content);

/// The lines of a text without their ends.
std::vector<std::string> lines_of(const std::string& text);
/// The last of them; empty if there is none.
std::string last_line(const std::string& text);

/// A folder that vanishes with the object.
class TemporaryFolder {
public:
    TemporaryFolder();
    TemporaryFolder(const TemporaryFolder&) = delete;
    TemporaryFolder& operator=(const TemporaryFolder&) = delete;
    ~TemporaryFolder();
    std::filesystem::path operator/(const std::string& name) const { return path_ / name; }
    const std::filesystem::path& path() const { return path_; }

private:
    std::filesystem::path path_;
};
