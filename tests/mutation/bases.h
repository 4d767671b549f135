// Valid files of the kinds that are mutated, short enough to replay thousands of them.
#pragma once

#include "tests/mutation/mutants.h"

namespace mutation {

struct Base {
    std::string text;
    /// Of a classification file: the classes that it is about, which it numbers 0, 1, ...
    std::vector<std::size_t> classes{};
};

/// The text of a file below certs/.
std::string committed(const std::string& name);

std::vector<Base> classification_bases(); ///< three classes each
std::vector<Base> problem_bases(); ///< every verdict, in two and three views, with reductions
std::vector<Base> general_bases(); ///< each record of both families, without the family
std::vector<Base> degree_bases();  ///< one to three classes, few solutions of each
std::vector<Base> model_bases();   ///< the smallest files of models, some of registrations

/// The records of a degree file, without what precedes.
std::vector<File> records(const File& file);

/// The degree files whose records are mutated: all committed ones.
std::vector<File> committed_degrees();

/// How many solutions a record shows, and of which class.
std::size_t shown(const File& record);
std::size_t class_of(const File& record);

} // namespace mutation
