// The degrees that Theorem Z proves (proofs/blown_up_cameras.md). From the folder that holds
// checker/ and proofs/:
//
//   c++ -std=c++20 -O2 -I. proofs/computations/blown_up_cameras.cpp -lgmp -o blown_up_cameras
//   ./blown_up_cameras
//
// compares them with the rows of the checker's table, which are of Theorem C. With a file of
// degrees, certs/degrees.csv, it prints them for each class of the file to which the theorem
// applies: its number, the notation of its constraint class, and the degree. Exit status 1 if a row
// of the table is another number.
#include "proofs/computations/blown_up_cameras.h"
#include "proofs/computations/compare_degrees.h"

int main(int argc, char** argv) {
    using namespace proofs::blown_up;
    const Integrals integrals;
    const auto degree = [&](const checker::Signature& problem) { return integrals.of(problem); };
    return proofs::compare_or_print(argc, argv, {"Z", has_degree_by_blow_up, degree});
}
