// Ctrl-C and SIGTERM while there is something to bring to its end first.
#pragma once

namespace plprove {

/// While it lives, SIGINT and SIGTERM wait to be asked for; those that were ignored stay ignored.
/// One at a time.
class Interruption {
public:
    Interruption();
    Interruption(const Interruption&) = delete;
    Interruption& operator=(const Interruption&) = delete;
    ~Interruption();

    /// The signal that came, or 0.
    int pending() const;

    /// Ends the process as that signal does, so that who started it knows.
    [[noreturn]] static void end_by(int signal);
};

} // namespace plprove
