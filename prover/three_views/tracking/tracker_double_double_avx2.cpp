// Four paths at a time, with twice the digits; compiled with the flags of AVX2 and FMA
// (CMakeLists.txt).
#include "prover/three_views/tracking/refined_values_kernel.h"
