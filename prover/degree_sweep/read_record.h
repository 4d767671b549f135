// Reading a record of a file of degrees back, to see whether it is whole.
#pragma once

#include <cstddef>
#include <optional>
#include <string_view>

namespace plprove {

/// How many solutions a record shows: pairs count twice. Nothing where the text is no record of
/// this class as write_record() writes it: certs/FORMAT.md, section 9, byte for byte. Whether the
/// solutions hold is for plcheck to find out.
std::optional<int> read_record(std::string_view record, std::size_t number);

} // namespace plprove
