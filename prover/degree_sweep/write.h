// Certificates of degrees as text: certs/FORMAT.md, section 9.
#pragma once

#include "prover/degree/degree.h"

#include <span>
#include <string>
#include <string_view>

namespace plprove {

/// The first line of a file of such certificates.
inline constexpr std::string_view degree_file_head = "plcert 1 degrees\n";

/// The record of one class, without the first line of the file.
std::string write_record(const DegreeCertificate& certificate);

/// A whole file. Assumes that the numbers of the classes ascend.
std::string write_degree_file(std::span<const DegreeCertificate> certificates);

} // namespace plprove
