#include "prover/degree/tracker.h"

namespace plprove {

TrackFunction* fastest_tracker() {
#if defined(__x86_64__)
    if (__builtin_cpu_supports("avx512f")) return avx512::track;
    if (__builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma")) return avx2::track;
#endif
    return portable::track;
}

} // namespace plprove
