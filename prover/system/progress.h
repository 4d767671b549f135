// A progress line on a terminal; nothing in a pipe.
#pragma once

#include <cstddef>
#include <string>

namespace plprove {

/// Shows "label: done of total", and perhaps more, on standard error, rewriting its line; the line
/// is wiped at the end. A total of 0 is not known and not shown. Silent where standard error is no
/// terminal, nor passed on to one by mpirun.
class ProgressLine {
public:
    ProgressLine(std::string label, std::size_t total);
    ProgressLine(const ProgressLine&) = delete;
    ProgressLine& operator=(const ProgressLine&) = delete;
    ~ProgressLine();

    void show(std::size_t done, const std::string& more = "");
    void wipe();

private:
    std::string label_;
    std::size_t total_;
    bool terminal_;
};

} // namespace plprove
