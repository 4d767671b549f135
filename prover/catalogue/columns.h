// The columns of the catalogue: name, meaning and value, said once for SQLite, CSV and JSON alike.
#pragma once

#include "prover/catalogue/catalogue.h"

#include <variant>

namespace plprove {

/// Nothing, a number (also 0 or 1 for a flag), or a text.
using Value = std::variant<std::monostate, int, std::string>;

enum class ColumnKind { integer, flag, text };

struct Column {
    const char* name;
    ColumnKind kind;
    bool optional; ///< whether the value may be missing
    const char* meaning;
    Value (*value)(const Entry&);
};

std::span<const Column> columns();

/// What holds for the catalogue as a whole: its origin, and what its words mean.
struct Remark {
    const char* topic;
    const char* text;
};

std::span<const Remark> remarks();

} // namespace plprove
