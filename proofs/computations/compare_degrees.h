// What programs of theorems do whose numbers are degrees of constraint classes: they compare them
// with the rows of the checker's table, which are of Theorem C, or print them.
#pragma once

#include "checker/bounds/theorems.h"
#include "checker/degrees/constraint_class.h"

#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <fstream>
#include <functional>
#include <iostream>
#include <set>
#include <string>
#include <string_view>
#include <vector>

namespace proofs {

struct DegreeTheorem {
    std::string_view name;
    std::function<bool(const checker::Signature&)> applies;
    std::function<std::int64_t(const checker::Signature&)> degree; // where it applies
    bool speaks_of_all = false;                                    // of all rows
};

inline checker::Signature constraints_of(const checker::Classification& classes,
                                         std::size_t number) {
    return checker::constraint_class(classes.representatives.at(number));
}

/// The rows of the checker's table to which the theorem applies.
inline std::vector<checker::NumberedBound> rows_of(const checker::Classification& classes,
                                                   const DegreeTheorem& theorem) {
    std::vector<checker::NumberedBound> rows = checker::common_centre_rows();
    std::erase_if(rows, [&](const checker::NumberedBound& row) {
        return !theorem.applies(constraints_of(classes, row.number));
    });
    return rows;
}

/// How many of these rows are not degrees of the theorem.
inline std::size_t count_false_rows(const checker::Classification& classes,
                                    const DegreeTheorem& theorem,
                                    const std::vector<checker::NumberedBound>& rows) {
    std::size_t count = 0;
    for (const auto& [number, bound] : rows) {
        if (theorem.degree(constraints_of(classes, number)) == std::int64_t{bound}) continue;
        std::cerr << "class " << number << ": " << bound << " is not by Theorem " << theorem.name
                  << '\n';
        ++count;
    }
    return count;
}

/// Prints the degrees for each class of the file to which the theorem applies.
inline void print_degrees(std::ifstream& file, const checker::Classification& classes,
                          const DegreeTheorem& theorem) {
    std::set<std::size_t> printed;
    std::cout << "number,constraint_class,degree\n";
    for (std::string line; std::getline(file, line);) {
        std::size_t number = 0;
        if (std::sscanf(line.c_str(), "%zu,", &number) != 1) continue;
        const checker::Signature constraints = constraints_of(classes, number);
        if (!theorem.applies(constraints) || !printed.insert(number).second) continue;
        std::cout << number << ',' << checker::notation(constraints) << ','
                  << theorem.degree(constraints) << '\n';
    }
}

/// The program of a theorem: its exit status.
inline int compare_or_print(int argc, char** argv, const DegreeTheorem& theorem) {
    const checker::Classification classes = checker::classify();
    if (argc == 2) {
        std::ifstream file(argv[1]);
        if (!file) {
            std::cerr << argv[0] << ": cannot read " << argv[1]
                      << ": name a file of degrees, such as certs/degrees.csv\n";
            return 2;
        }
        print_degrees(file, classes, theorem);
        return 0;
    }
    const std::vector<checker::NumberedBound> rows = rows_of(classes, theorem);
    const std::size_t all = checker::common_centre_rows().size();
    const bool speaks = theorem.speaks_of_all ? rows.size() == all : !rows.empty();
    const bool hold = speaks && count_false_rows(classes, theorem, rows) == 0;
    std::cout << "Theorem " << theorem.name << ", " << rows.size() << " of " << all
              << " rows: " << (hold ? "All hold" : "NOT ALL HOLD") << '\n';
    return hold ? 0 : 1;
}

} // namespace proofs
