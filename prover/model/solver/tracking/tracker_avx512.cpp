// Eight paths at a time; compiled with the flags of AVX-512 (CMakeLists.txt).
#include "prover/model/solver/tracking/tracker_kernel.h"
