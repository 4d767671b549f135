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
    if (file.extension() == ".jl" ||
        (file.extension() != ".m2" && file.extension() != ".m" && has("@var")))
        return from_julia(program, name);
    if (file.extension() == ".m") return from_matlab(program, name);
    if (file.extension() == ".m2" || has("ideal")) return from_macaulay2(program, name);
    if (has("create_vars") || has("gbs_Matrix") || has("syms ")) return from_matlab(program, name);
    throw BadInput(path + " is no program that can be imported: it has no ideal of Macaulay2, no "
                          "variables of HomotopyContinuation.jl (@var), and no symbols of Matlab "
                          "(create_vars, gbs_Matrix, syms)");
}

} // namespace plprove::importers
