// One path at a time, on any machine.
#include "prover/degree/tracking/tracker_kernel.h"
