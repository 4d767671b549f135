// One path at a time, with twice the digits, on any machine.
#include "prover/three_views/tracking/refined_values_kernel.h"
