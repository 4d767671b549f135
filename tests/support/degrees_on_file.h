// The degrees of certs/degrees.csv, by constraint class, for tests.
#pragma once

#include "checker/degrees/constraint_class.h"
#include "tests/support/minimal_classes.h"

#include <cstdio>
#include <fstream>
#include <map>
#include <string>

inline std::map<checker::Signature, std::size_t> degrees_on_file() {
    std::ifstream file(CERTS_DIR "/degrees.csv");
    std::map<checker::Signature, std::size_t> degrees;
    for (std::string line; std::getline(file, line);) {
        std::size_t number = 0, degree = 0;
        if (std::sscanf(line.c_str(), "%zu,%zu", &number, &degree) == 2)
            degrees[checker::constraint_class(all_classes().representatives[number])] = degree;
    }
    return degrees;
}
