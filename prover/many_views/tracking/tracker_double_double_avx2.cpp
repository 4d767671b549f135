// Four paths at a time, with twice the digits; compiled with the flags of AVX2 and FMA
// (CMakeLists.txt).
#define PLC_DOUBLE_DOUBLE
#include "prover/many_views/tracking/tracker_kernel.h"
