#include "tests/mutation/table.h"

#include <algorithm>
#include <iomanip>
#include <iostream>

std::string kind_of(const std::string& reason, bool conforms) {
    std::string kind;
    bool quoted = false;
    const std::size_t expected = reason.find(", expected ");
    for (const char c : expected == reason.npos ? reason : reason.substr(expected + 2)) {
        if (c == '`' && expected == reason.npos) quoted = !quoted;
        if (quoted || c == '`') continue;
        const bool digit =
            (c >= '0' && c <= '9') || (c == '-' && !kind.empty() && kind.back() == ' ');
        if (!digit)
            kind += c;
        else if (kind.empty() || kind.back() != 'N')
            kind += 'N';
    }
    for (const char* stop :
         {"the feature must be", "this is no rule for", "the pool lacks the feature",
          "a rule still applies to", "its pool has too few", "the verdict is",
          "class N: its pool has too few", "the number of the class is",
          "class N: the images must be, in this order, those of"})
        if (kind.starts_with(stop)) kind = stop;
    return (conforms ? "refused: " : "syntax: ") + kind;
}

void print(const std::string& title, const std::string& certificates, const Table& table) {
    Tally sum;
    std::cout << title << "\n\n"
              << std::left << std::setw(26) << "  mutation" << std::right << std::setw(9)
              << "mutants" << std::setw(9) << "refused" << std::setw(20) << "accepted and true"
              << '\n';
    const auto line = [](const std::string& name, const Tally& t) {
        std::cout << "  " << std::left << std::setw(24) << name << std::right << std::setw(9)
                  << t.mutants << std::setw(9) << t.refused << std::setw(20) << t.accepted << '\n';
    };
    for (const auto& [name, tally] : table.by_mutator) {
        line(name, tally);
        sum.mutants += tally.mutants;
        sum.refused += tally.refused;
        sum.accepted += tally.accepted;
    }
    line("all", sum);
    if (table.verdicts > 0)
        std::cout << "  " << table.verdicts << " " << certificates << " held in these files\n";
    std::vector<std::pair<std::size_t, std::string>> reasons;
    for (const auto& [reason, count] : table.by_reason)
        reasons.emplace_back(count, reason);
    std::sort(reasons.rbegin(), reasons.rend());
    std::cout << "\n  first reason of refusal\n";
    for (const auto& [count, reason] : reasons)
        std::cout << std::setw(9) << count << "  " << reason << '\n';
    if (!table.strict.empty()) std::cout << "\n  refused although the referee finds a proof\n";
    for (const auto& [reason, count] : table.strict)
        std::cout << std::setw(9) << count << "  " << reason << '\n';
    std::cout << '\n';
}

int outcome(std::size_t files, const Table& untouched, const Table& table) {
    std::size_t good = 0;
    for (const auto& [name, tally] : untouched.by_mutator)
        good += tally.accepted;
    std::cout << "  " << good << " of " << files << " files are accepted as they are; "
              << table.unsound.size() << " mutants are accepted although they prove nothing\n\n";
    for (const Table* some : {&untouched, &table})
        for (const std::string& file : some->unsound)
            std::cout << "UNSOUND: " << file << '\n';
    return good == files && untouched.unsound.empty() && table.unsound.empty() ? 0 : 1;
}
