// One path at a time, on any machine.
#include "prover/many_views/tracking/tracker_kernel.h"
