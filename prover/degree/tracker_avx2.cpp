// The tracker with the lanes of this instruction set; compiled with its flags (CMakeLists.txt).
#include "prover/degree/lanes.h"
#include "prover/degree/tracker.h"

namespace plprove::avx2 {

#define PLC_UNROLLED _Pragma("GCC unroll 16")
#include "prover/degree/tracker_kernel.h"

TrackCost track(const TrackedSystem& system, const TrackedImages& images,
                const TrackSettings& settings, std::size_t count, const CameraPoint* starts,
                CameraPoint* ends, TrackOutcome* outcomes) {
    return Tracker(system, images, settings, count, starts, ends, outcomes).run();
}

} // namespace plprove::avx2
