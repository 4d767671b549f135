// The degrees that Theorem Z proves (proofs/blown_up_cameras.md). From the folder that holds
// checker/ and proofs/:
//
//   c++ -std=c++20 -O2 -I. proofs/computations/blown_up_cameras.cpp -lgmp -o blown_up_cameras
//   ./blown_up_cameras
//
// compares them with the rows of the checker's table. With a file of degrees, certs/degrees.csv, it
// prints them for each class of the file to which the theorem applies: its number, the notation of
// its constraint class, and the degree. Exit status 1 if a row of the table is not a degree of the
// theorem.
#include "proofs/computations/blown_up_cameras.h"
#include "checker/bounds/theorems.h"
#include "checker/degrees/constraint_class.h"

#include <cstdio>
#include <fstream>
#include <iostream>
#include <set>
#include <string>

namespace {

using proofs::blown_up::has_degree_by_blow_up;
using proofs::blown_up::Integrals;

checker::Signature constraints_of(const checker::Classification& classes, std::size_t number) {
    return checker::constraint_class(classes.representatives.at(number));
}

/// How many rows of the checker's table are not degrees of the theorem.
std::size_t count_false_rows(const checker::Classification& classes, const Integrals& integrals) {
    std::size_t count = 0;
    for (const auto& [number, bound] : checker::blown_up_camera_rows()) {
        const checker::Signature constraints = constraints_of(classes, number);
        const bool holds =
            has_degree_by_blow_up(constraints) && integrals.of(constraints) == std::int64_t{bound};
        if (!holds) std::cerr << "class " << number << ": " << bound << " is not by Theorem Z\n";
        count += !holds;
    }
    return count;
}

void print_degrees(std::ifstream& file, const checker::Classification& classes,
                   const Integrals& integrals) {
    std::set<std::size_t> printed;
    std::cout << "number,constraint_class,degree\n";
    for (std::string line; std::getline(file, line);) {
        std::size_t number = 0;
        if (std::sscanf(line.c_str(), "%zu,", &number) != 1) continue;
        const checker::Signature constraints = constraints_of(classes, number);
        if (!has_degree_by_blow_up(constraints) || !printed.insert(number).second) continue;
        std::cout << number << ',' << checker::notation(constraints) << ','
                  << integrals.of(constraints) << '\n';
    }
}

} // namespace

int main(int argc, char** argv) {
    const checker::Classification classes = checker::classify();
    const Integrals integrals;
    if (argc == 2) {
        std::ifstream file(argv[1]);
        if (!file) {
            std::cerr << "blown_up_cameras: cannot read " << argv[1]
                      << ": name a file of degrees, such as certs/degrees.csv\n";
            return 2;
        }
        print_degrees(file, classes, integrals);
        return 0;
    }
    const std::size_t rows = checker::blown_up_camera_rows().size();
    const std::size_t wrong = count_false_rows(classes, integrals);
    std::cout << "Theorem Z, " << rows << " rows: " << (wrong == 0 ? "All hold" : "NOT ALL HOLD")
              << '\n';
    return wrong == 0 ? 0 : 1;
}
