// One path at a time, on any machine.
#include "prover/multiview/tracking/tracker_kernel.h"
