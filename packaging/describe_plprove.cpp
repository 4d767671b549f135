// Prints what plprove takes, for the makers of manual pages and completion.
#include "prover/cli/program.h"

#include <iostream>

int main() {
    std::cout << plprove::describe_plprove() << std::flush;
    return std::cout ? 0 : 1;
}
