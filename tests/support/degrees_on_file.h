// The degrees of certs/degrees.csv, by constraint class, for tests.
#pragma once

#include "checker/degrees/constraint_class.h"
#include "tests/support/minimal_classes.h"
#include "tests/support/text.h"

#include <cstdio>
#include <fstream>
#include <map>
#include <set>
#include <string>

/// Those that are complete.
inline std::map<checker::Signature, std::size_t> degrees_on_file() {
    std::ifstream file(CERTS_DIR "/degrees.csv");
    std::map<checker::Signature, std::size_t> degrees;
    for (std::string line; std::getline(file, line);) {
        std::size_t number = 0, degree = 0;
        if (std::sscanf(line.c_str(), "%zu,%zu,exact,", &number, &degree) == 2 &&
            contains(line, ",exact,"))
            degrees[checker::constraint_class(all_classes().representatives[number])] = degree;
    }
    return degrees;
}

/// The classes whose degree is called certified.
inline std::set<checker::Signature> certified_on_file() {
    std::ifstream file(CERTS_DIR "/degrees.csv");
    std::set<checker::Signature> certified;
    for (std::string line; std::getline(file, line);) {
        if (line.starts_with('#') || !contains(line, ",exact,certified,")) continue;
        const checker::Signature& signature = all_classes().representatives[std::stoul(line)];
        certified.insert(checker::constraint_class(signature));
    }
    return certified;
}
