#include "prover/cli/program.h"

int main(int argc, char** argv) {
    return plprove::run_plprove(argc, argv, plprove::compute_degree);
}
