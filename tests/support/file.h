// The bytes of a file, which has to be there.
#pragma once

#include <doctest/doctest.h>

#include <fstream>
#include <iterator>
#include <string>

inline std::string read(const std::string& path) {
    std::ifstream file(path, std::ios::binary);
    CAPTURE(path);
    REQUIRE(file);
    return {std::istreambuf_iterator<char>(file), {}};
}
