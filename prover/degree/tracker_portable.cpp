// One path at a time, on any machine.
#include "prover/degree/tracker_kernel.h"
