#include "prover/problem/five_points.h"

#include "prover/problem/notation.h"
#include "prover/problem/signature.h"

namespace plprove {

std::size_t five_point_extension() {
    const auto signature = signature_of(parse_features("2*P/P/P + a/a/a + 3*-/P/P"));
    return class_number(label_classes(), representative(*signature));
}

} // namespace plprove
