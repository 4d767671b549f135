// Memory for the path tracker, whatever the lanes.
#pragma once

namespace plprove {

/// The numbers of one coordinate in all lanes: eight complex ones at most, with twice the digits.
struct alignas(64) LaneNumber {
    double parts[32];
};

} // namespace plprove
