#include "prover/problem/names.h"

#include <algorithm>
#include <cctype>

namespace plprove {

namespace {

constexpr NamedProblem table[] = {
    {"Chicago", "2*Pa/Pa/Pa + P/P/P"},
    {"Cleveland", "3*P/P/P + a/a/a"},
    {"five-point", "5*P/P"},
    {"P3P+five-point", "3*P/P/P + 2*-/P/P"},
    {"P2P1LL+five-point", "2*P/P/P + a/a/a + 3*-/P/P"},
    {"P1P2LL+five-point", "P/P/P + 2*a/a/a + 4*-/P/P"},
    {"P3LL+five-point", "3*a/a/a + 5*-/P/P"},
    {"1024_4", "Pabcd/Pabcd/Pabcd + 2*a/a/a"},
    {"1032_2", "Pab/Pab/Pab + 3*a/a/a"},
    {"1040_0", "P/P/P + 4*a/a/a"},
    {"2005_3", "Pabc/Pabc/Pabc + Pab/Pab/Pab"},
    {"2005_4", "Pabcd/Pabcd/Pabcd + Pa/Pa/Pa"},
    {"2005_5", "Pabcde/Pabcde/Pabcde + P/P/P"},
    {"2013_2", "Pab/Pab/Pab + Pa/Pa/Pa + a/a/a"},
    {"2013_3", "Pabc/Pabc/Pabc + P/P/P + a/a/a"},
    {"2021_1", "Pa/Pa/Pa + P/P/P + 2*a/a/a"},
    {"3002_1", "2*Pa/Pa/Pa + P/P/P"},
    {"3002_2", "Pab/Pab/Pab + 2*P/P/P"},
    {"3010_0", "3*P/P/P + a/a/a"},
};

std::string plain(std::string_view name) {
    std::string result;
    for (const char c : name) {
        const auto code = static_cast<unsigned char>(c);
        if (std::isspace(code) == 0) result += static_cast<char>(std::tolower(code));
    }
    return result;
}

} // namespace

std::span<const NamedProblem> named_problems() {
    return table;
}

std::optional<Features> problem_named(std::string_view name) {
    const std::string wanted = plain(name);
    for (const NamedProblem& named : table)
        if (plain(named.name) == wanted) return parse_features(named.notation);
    return std::nullopt;
}

std::string list_of_names() {
    std::string list;
    for (const NamedProblem& named : table) {
        if (!list.empty()) list += ", ";
        list += named.name;
    }
    return list;
}

} // namespace plprove
