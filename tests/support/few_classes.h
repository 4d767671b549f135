// The certificates of five classes, taken from the archive and renumbered. The checker is given
// these classes instead of all, and runs as always.
#pragma once

#include "tests/support/all_classes.h"

#include <fstream>
#include <sstream>
#include <vector>

/// The committed archive of all classes.
inline const std::string& archive() {
    static const std::string bytes = [] {
        std::ifstream in(CERTS_DIR "/classification.plc", std::ios::binary);
        std::ostringstream text;
        text << in.rdbuf();
        return text.str();
    }();
    return bytes;
}

/// A star, a minimal class, Chicago, epipolar excess 1, and excess 6.
inline const std::vector<std::size_t> few_numbers{0, 4, 2394, 5093, 130456};

inline checker::Classification few_classes() {
    checker::Classification few{.signatures = few_numbers.size()};
    for (const std::size_t number : few_numbers) {
        few.swap_class.push_back(few.representatives.size());
        few.representatives.push_back(all_classes().representatives[number]);
    }
    return few;
}

/// The pool of the archive and the records of the five classes, with new numbers.
inline const std::string& few_certificates() {
    static const std::string text = [] {
        std::map<std::string, std::size_t> renumbered;
        for (std::size_t i = 0; i < few_numbers.size(); ++i)
            renumbered[std::to_string(few_numbers[i])] = i;
        std::istringstream lines(archive());
        std::string result;
        bool wanted = true;
        for (std::string line; std::getline(lines, line);) {
            std::istringstream words(line);
            std::string kind, number, rest;
            words >> kind >> number;
            if (kind == "minimal" || kind == "deficient") {
                const auto place = renumbered.find(number);
                wanted = place != renumbered.end();
                std::getline(words, rest);
                if (wanted) line = kind + ' ' + std::to_string(place->second) + rest;
            }
            if (wanted) result += line + "\n";
        }
        return result;
    }();
    return text;
}
