// How far monodromy is.
#pragma once

namespace plprove {

struct MonodromyProgress {
    int solutions = 0; ///< known at the first node
    int edges = 0;     ///< along which they are followed
};

} // namespace plprove
