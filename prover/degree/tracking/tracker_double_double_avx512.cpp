// Eight paths at a time, with twice as many digits; compiled with the flags of AVX-512
// (CMakeLists.txt).
#include "prover/degree/tracking/refined_values_kernel.h"
