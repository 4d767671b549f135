// The file that certifies the classification: certificates of all label classes, with the pools of
// coordinates they use.
#pragma once

#include "prover/minimal/minor.h"
#include "prover/minimal/pool.h"

#include <functional>

namespace plprove {

/// The class with this number is posed in the pool with this index.
struct ClassRecord {
    std::size_t number = 0;
    std::size_t pool = 0;
    Minor minor;
};

/// A record for each label class, ascending.
struct ClassificationFile {
    std::vector<Pool> pools;
    std::vector<ClassRecord> records;
};

/// Called with the number of classes done, now and then.
using Progress = std::function<void(std::size_t done)>;

/// Certifies the given label classes (all of them: label_classes()), numbered in order. A class
/// whose minor vanishes in one pool is tried in the next. Throws std::runtime_error where the pools
/// are used up: then a class has a smaller generic rank than its obstruction explains.
ClassificationFile certify_classification(const std::vector<Signature>& classes,
                                          const Progress& progress);

/// The text of the file (certs/FORMAT.md, section 5, "classification").
std::string write(const ClassificationFile& archive);

} // namespace plprove
