// Certificates of degrees as text: certs/FORMAT.md, section 9.
#pragma once

#include "prover/three_views/degree.h"

#include <span>
#include <string>
#include <string_view>

namespace plprove {

/// The lines of a record before its solutions. Throws FormatLimit if the format does not allow
/// them.
std::string write_images(std::size_t number, std::span<const FeatureImage> images);

/// The record of one class, without the first line of the file. Throws FormatLimit if the format
/// does not allow it.
std::string write_record(const DegreeCertificate& certificate);

/// A whole file of records, whose classes ascend. Throws FormatLimit if it is too large.
std::string degree_file(std::string_view records);

/// The same for these certificates.
std::string write_degree_file(std::span<const DegreeCertificate> certificates);

} // namespace plprove
