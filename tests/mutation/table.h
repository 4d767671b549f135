// What came of mutants of one kind of file: how many were refused and why, which were accepted and
// are true, which were accepted and prove nothing.
#pragma once

#include <cstddef>
#include <map>
#include <string>
#include <vector>

struct Tally {
    std::size_t mutants = 0, refused = 0, accepted = 0;
};

struct Table {
    std::map<std::string, Tally> by_mutator;
    std::map<std::string, std::size_t> by_reason;
    std::map<std::string, std::size_t> strict; ///< refused although the referee finds a proof
    std::size_t verdicts = 0; ///< certificates that hold, in refused files, too; the referee agrees
    std::vector<std::string> unsound;
};

/// A reason without what varies, numbers and quotations; for a file that conforms to the format, or
/// not.
std::string kind_of(const std::string& reason, bool conforms);

/// The table in words; `certificates` says what holds in these files.
void print(const std::string& title, const std::string& certificates, const Table& table);

/// What is to be seen of the files themselves and of the mutants: 0 if all the former are accepted
/// and no mutant that is accepted proves something false.
int outcome(std::size_t files, const Table& untouched, const Table& table);
