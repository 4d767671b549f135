// Programs that are interfered with while they run, and the places where files cannot be written.
#pragma once

#include "tests/support/program.h"

#include <functional>
#include <optional>
#include <string>
#include <sys/types.h>
#include <vector>

using Arguments = std::vector<std::string>;

/// Starts a program in a folder, silent, after `prepare` in the new process; the result is its id.
pid_t start_program(
    const std::string& program, const std::filesystem::path& folder, const Arguments& arguments,
    const std::function<void()>& prepare = [] {});

/// Waits for a process; the result is its status as waitpid() has it.
int wait_for(pid_t child);

/// Runs a script with root's rights over mounts that vanish with it; nothing if the system does not
/// let its users have them.
std::optional<Outcome> run_with_mounts(const std::string& script);

/// The names in a folder, in order, one a line.
std::string names_in(const std::filesystem::path& folder);
