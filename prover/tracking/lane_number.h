// Memory for the path tracker, whatever the lanes.
#pragma once

namespace plprove {

/// The numbers of one coordinate in all lanes: eight complex ones at most.
struct alignas(64) LaneNumber {
    double parts[16];
};

} // namespace plprove
