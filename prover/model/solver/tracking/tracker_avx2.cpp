// Four paths at a time; compiled with the flags of AVX2 and FMA (CMakeLists.txt).
#include "prover/model/solver/tracking/tracker_kernel.h"
