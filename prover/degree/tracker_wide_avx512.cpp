// Eight paths at a time, with twice as many digits; compiled with the flags of AVX-512
// (CMakeLists.txt).
#define PLC_WIDE
#include "prover/degree/tracker_kernel.h"
