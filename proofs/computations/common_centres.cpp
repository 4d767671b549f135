// The degrees that Theorem C proves (proofs/common_centres.md). From the folder that holds checker/
// and proofs/:
//
//   c++ -std=c++20 -O2 -I. proofs/computations/common_centres.cpp -lgmp -o common_centres
//   ./common_centres
//
// compares them with the rows of the checker's table. With a file of degrees, certs/degrees.csv, it
// prints them for each class of the file to which the theorem applies: its number, the notation of
// its constraint class, and the degree. Exit status 1 if a row of the table is not a degree of the
// theorem.
#include "proofs/computations/common_centres.h"
#include "proofs/computations/compare_degrees.h"

int main(int argc, char** argv) {
    using namespace proofs::blown_up;
    const Integrals integrals = integrals_over_third_blow_up();
    const auto degree = [&](const checker::Signature& problem) { return integrals.of(problem); };
    return proofs::compare_or_print(argc, argv, {"C", has_degree_by_common_centres, degree, true});
}
