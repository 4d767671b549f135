// One path at a time, with twice as many digits, on any machine.
#define PLC_WIDE
#include "prover/degree/tracker_kernel.h"
