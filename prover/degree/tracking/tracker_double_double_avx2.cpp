// Four paths at a time, with twice as many digits; compiled with the flags of AVX2 and FMA
// (CMakeLists.txt).
#include "prover/degree/tracking/refined_values_kernel.h"
