// Four paths at a time, with twice as many digits; compiled with the flags of AVX2 and FMA
// (CMakeLists.txt).
#define PLC_WIDE
#include "prover/degree/tracker_kernel.h"
