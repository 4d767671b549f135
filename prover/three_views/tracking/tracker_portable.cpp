// One path at a time, on any machine.
#include "prover/three_views/tracking/tracker_kernel.h"
