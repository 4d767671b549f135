// Work on many things that do not depend on each other, by several threads.
#pragma once

#include <algorithm>
#include <cstddef>
#include <future>
#include <vector>

namespace plprove {

/// Calls work(begin, end) for `parts` parts of 0, ..., count - 1, each in a thread of its own if
/// the system has it; returns when all are done. Throws what `work` throws.
template <class Work>
void in_parts(std::size_t count, unsigned parts, const Work& work) {
    const std::size_t used = std::clamp<std::size_t>(parts, 1, std::max<std::size_t>(count, 1));
    const auto begin_of = [&](std::size_t part) { return part * count / used; };
    std::vector<std::future<void>> others;
    for (std::size_t part = 1; part < used; ++part)
        others.push_back(std::async(work, begin_of(part), begin_of(part + 1)));
    work(begin_of(0), begin_of(1));
    for (std::future<void>& other : others)
        other.get();
}

} // namespace plprove
