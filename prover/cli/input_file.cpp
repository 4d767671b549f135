#include "prover/cli/input_file.h"

#include "prover/system/exit.h"

#include <filesystem>
#include <fstream>
#include <iterator>

namespace plprove {

bool names_file(const std::string& argument) {
    std::error_code none;
    return std::filesystem::is_regular_file(argument, none);
}

std::string content_of(const std::string& path) {
    std::ifstream file(path, std::ios::binary);
    std::string text(std::istreambuf_iterator<char>(file), {});
    if (!file) throw BadInput("cannot read " + path + ": does it exist?");
    return text;
}

} // namespace plprove
