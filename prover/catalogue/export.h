// The catalogue as text and as a database. The bytes depend on the entries alone (for SQLite, on
// the version of the library too). certs/CATALOGUE.md documents all three.
#pragma once

#include "prover/catalogue/catalogue.h"

namespace plprove {

/// A line of column names, then a line for each entry; flags are 0 or 1, what is missing is empty.
std::string to_csv(std::span<const Entry> entries);

/// {"about": ..., "classes": [...]}, one object a line with the columns as members; what is missing
/// is null.
std::string to_json(std::span<const Entry> entries);

/// The image of an SQLite database. Throws std::runtime_error with SQLite's message.
std::string to_sqlite(std::span<const Entry> entries);

} // namespace plprove
