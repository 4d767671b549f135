// Eight paths at a time, with three times the digits; compiled with the flags of AVX-512
// (CMakeLists.txt).
#define PLC_TRIPLE_DOUBLE
#include "prover/three_views/tracking/tracker_kernel.h"
