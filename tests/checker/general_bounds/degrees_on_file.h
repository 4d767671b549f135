// The degrees of minimal problems of families that are on file: certs/family-degrees.csv.
#pragma once

#include <fstream>
#include <sstream>
#include <string>
#include <vector>

/// A line of the file.
struct OnFile {
    std::string family, problem, degree, bound, status, certified, source;
};

inline std::vector<OnFile> family_degrees_on_file() {
    std::ifstream table(SOURCE_DIR "/certs/family-degrees.csv");
    std::vector<OnFile> rows;
    for (std::string line; std::getline(table, line);) {
        if (line.starts_with('#') || line.starts_with("family,")) continue;
        std::istringstream columns(line);
        OnFile& row = rows.emplace_back();
        for (std::string* column : {&row.family, &row.problem, &row.degree, &row.bound, &row.status,
                                    &row.certified, &row.source})
            std::getline(columns, *column, ',');
    }
    return rows;
}
