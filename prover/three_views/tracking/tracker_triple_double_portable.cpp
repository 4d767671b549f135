// One path at a time, with three times the digits, on any machine.
#define PLC_TRIPLE_DOUBLE
#include "prover/three_views/tracking/tracker_kernel.h"
