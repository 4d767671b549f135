// What programs of this folder print: facts, one a line, and whether all hold.
#pragma once

#include <cstdlib>
#include <iostream>
#include <string>

namespace proofs {

class Report {
public:
    void operator()(bool holds, const std::string& fact) {
        std::cout << (holds ? "holds   " : "FAILS   ") << fact << '\n';
        all_ = all_ && holds;
    }

    /// Prints the last line. The exit status of the program.
    int status() const {
        std::cout << (all_ ? "All hold.\n" : "Some fail.\n");
        return all_ ? EXIT_SUCCESS : EXIT_FAILURE;
    }

private:
    bool all_ = true;
};

} // namespace proofs
