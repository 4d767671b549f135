#include "prover/importers/importers.h"

#include "prover/system/exit.h"

#include <filesystem>

namespace plprove::importers {

std::string import_program(std::string_view program, const std::string& path) {
    const std::filesystem::path file = path;
    const auto has = [&](std::string_view word) {
        return program.find(word) != std::string_view::npos;
    };
    const std::string name = file == "-" ? "standard input" : file.filename().string();
    if (file.extension() == ".jl" || (file.extension() != ".m2" && has("@var")))
        return from_julia(program, name);
    if (file.extension() == ".m2" || has("ideal")) return from_macaulay2(program, name);
    throw BadInput(path +
                   " is no program that can be imported: it has neither an ideal of Macaulay2 "
                   "nor variables of HomotopyContinuation.jl (@var)");
}

} // namespace plprove::importers
