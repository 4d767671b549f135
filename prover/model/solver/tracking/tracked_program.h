// The equations of a model and their derivatives, in plain arrays for the inner loops.
#pragma once

#include "prover/tracking/lane_number.h"
#include "prover/tracking/track_settings.h"

#include <cstddef>
#include <cstdint>

namespace plprove::model {

/// What an operation does with the numbers in the places a, b and c.
enum class TrackedKind : std::uint8_t {
    sum,          ///< a + b
    difference,   ///< a - b
    product,      ///< a b
    add,          ///< c + a b
    subtract,     ///< c - a b
    product_less, ///< a b - c
    negative,     ///< -a
    reciprocal    ///< 1 / a
};

/// All refer to places of one array of numbers.
struct TrackedOperation {
    TrackedKind kind = TrackedKind::sum;
    int to = 0;
    int a = 0, b = 0, c = 0;
};

struct TrackedConstant {
    int place = 0;
    double value = 0;
};

struct TrackedCopy {
    int to = 0, from = 0;
};

/// A step of the elimination of unknowns: which one, and the places in a list of the rows that may
/// have it, of the other unknowns in these rows, and of the end of those. The first row is that of
/// the pivot; the other steps that follow do without it.
struct EliminationStep {
    int column = 0;
    int rows = 0, columns = 0, end = 0;
};

/// A datum that moves: its places, and the number of its curve.
struct TrackedDatum {
    int place = 0;
    int speed = -1; ///< -1: no place, as no equation needs it
    int number = 0;
};

/// The first places are those of the unknowns, then comes the matrix: a row is an equation, its
/// columns are the unknowns, the value, and the derivative by time.
struct TrackedProgram {
    int unknowns = 0;
    int places = 0;
    int constants = 0;
    const TrackedConstant* constant = nullptr;
    int data = 0;
    const TrackedDatum* datum = nullptr;
    int operations_at_rest = 0; ///< the first ones: without the derivative by time
    int operations = 0;
    const TrackedOperation* operation = nullptr;
    int copies_at_rest = 0;
    int copies = 0;
    const TrackedCopy* copy = nullptr;
    int zeros = 0; ///< places of the matrix
    const int* zero = nullptr;
    const EliminationStep* step = nullptr; ///< one for each unknown
    const int* index = nullptr;            ///< what these refer to

    int columns() const { return unknowns + 2; }
};

/// A datum on a way: the coefficients of 1, t and t^2, as real and imaginary parts.
struct TrackedCurve {
    double coefficients[3][2];
};

/// How many LaneNumbers a tracker needs to work with.
std::size_t workspace_size(const TrackedProgram& program);

/// Follows each start, `unknowns` complex numbers, to t = 1; starts and ends are arrays of `count`
/// points, outcomes as well. `curves` has one for each scalar of data.
using TrackFunction = TrackCost(const TrackedProgram& program, const TrackedCurve* curves,
                                const TrackSettings& settings, std::size_t count,
                                const double* starts, double* ends, TrackOutcome* outcomes,
                                LaneNumber* workspace);

namespace avx512 {
TrackFunction track;
} // namespace avx512
namespace avx2 {
TrackFunction track;
} // namespace avx2
namespace portable {
TrackFunction track;
} // namespace portable

/// The one with most lanes that this machine can run. All give the same results, to the bit.
TrackFunction* fastest_tracker();

} // namespace plprove::model
