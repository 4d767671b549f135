#include "tests/bench/evaluations.h"

#include "prover/model/solver/tracking/evaluation.h"
#include "prover/three_views/tracking/evaluation.h"

namespace plprove::bench {

using namespace PLC_LANES;

/// Keeps the compiler from evaluating once for all times.
static void touch(void* values) {
    asm volatile("" : : "r"(values) : "memory");
}

std::uint64_t evaluate_engine(const TrackedSystem& system, const TrackedImages& images,
                              const double* point, int times) {
    Number numbers[camera_dimension];
    for (int k = 0; k < camera_dimension; ++k)
        numbers[k] = constant(point + 2 * k);
    Equations equations;
    for (int i = 0; i < times; ++i) {
        touch(numbers);
        Evaluator(system, images, numbers).evaluate<false>(Real::of(0.3), equations);
        touch(&equations);
    }
    return static_cast<std::uint64_t>(times) * Real::width;
}

std::uint64_t evaluate_model(const model::TrackedProgram& program,
                             const model::TrackedCurve* curves, const double* point,
                             LaneNumber* workspace, int times) {
    auto* places = reinterpret_cast<Number*>(workspace);
    model::PLC_LANES::set_constants(program, places);
    for (int k = 0; k < program.unknowns; ++k)
        places[k] = constant(point + 2 * k);
    for (int i = 0; i < times; ++i) {
        touch(places);
        model::PLC_LANES::evaluate<false>(program, curves, Real::of(0.3), places);
        touch(places);
    }
    return static_cast<std::uint64_t>(times) * Real::width;
}

} // namespace plprove::bench
