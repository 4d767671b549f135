// One path at a time, on any machine.
#include "prover/model/solver/tracking/tracker_kernel.h"
