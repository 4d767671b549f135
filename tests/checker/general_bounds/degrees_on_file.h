// The degrees that are on file, of minimal problems of families (certs/family-degrees.csv), and of
// problems that three views may see in part (certs/three-views-in-part.csv).
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

/// A line of the other one. The degree is 0 if the problem is not minimal.
struct OnFileInPart {
    std::string problem, label_classes, degree, source;
};

/// Of a kind of cameras.
inline std::vector<OnFileInPart> degrees_in_part_on_file(const std::string& kind) {
    std::ifstream table(SOURCE_DIR "/certs/three-views-in-part.csv");
    std::vector<OnFileInPart> rows;
    for (std::string line; std::getline(table, line);) {
        if (!line.starts_with(kind + ": ")) continue;
        std::istringstream columns(line);
        OnFileInPart& row = rows.emplace_back();
        for (std::string* column : {&row.problem, &row.label_classes, &row.degree, &row.source})
            std::getline(columns, *column, ',');
    }
    return rows;
}
