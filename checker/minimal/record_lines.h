// How files write records (FORMAT.md, sections 5 and 13).
#pragma once

#include "checker/file/reader.h"
#include "checker/minimal/record.h"

namespace checker {
/// Takes strictly ascending numbers, up to the word `columns` or the end of the line.
Numbers read_ascending(Reader& reader, int largest);

/// Takes a minor, which is not 0, and the end of its line.
Residue read_minor(Reader& reader);

/// Takes what follows the pool of a record of section 5. Throws Malformed.
MinorClaim read_minor_in_pool(Reader& reader, bool full_rank);

/// Takes what follows the problem of a record of section 13, which begins in this line. Throws
/// Malformed.
Record read_record(Reader& reader, std::size_t line, const Problem& problem);
} // namespace checker
