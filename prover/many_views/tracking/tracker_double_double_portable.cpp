// One path at a time, with twice the digits, on any machine.
#define PLC_DOUBLE_DOUBLE
#include "prover/many_views/tracking/tracker_kernel.h"
