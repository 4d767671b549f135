// How plprove ends.
#pragma once

#include <stdexcept>

namespace plprove {

inline constexpr int exit_failure = 1;
inline constexpr int exit_input = 2;
inline constexpr int exit_usage = 3;

/// What the user gave is well-formed, but nothing that the command can work on: status 2.
class BadInput : public std::runtime_error {
public:
    using std::runtime_error::runtime_error;
};

} // namespace plprove
