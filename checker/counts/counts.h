// The numbers of the table, counted from the classes and what is proved of them (FORMAT.md, section
// 6). What the paper claims of them stands elsewhere.
#pragma once

#include "checker/minimal/classification_file.h"

#include <optional>

namespace checker {
/// By class number, what certificates prove; none without one.
using Verdicts = std::vector<std::optional<Obstruction>>;

struct Count {
    std::string_view name;
    std::optional<std::size_t> certified; // none if some class has no certificate
};

/// All counts, in the order of the table.
std::vector<Count> count_classes(const Classification& classes, const Verdicts& verdicts);

/// Whether a class is proved to be minimal.
inline bool is_minimal(const Verdicts& verdicts, std::size_t number) {
    return verdicts[number] && verdicts[number]->minimal();
}
} // namespace checker
