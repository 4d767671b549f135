#include "prover/model/fraction_ring.h"

#include <algorithm>

namespace plprove::model {

std::optional<Degrees> degrees_of_product(const std::optional<Degrees>& a,
                                          const std::optional<Degrees>& b) {
    if (!a || !b) return std::nullopt;
    Degrees result = *a;
    for (std::size_t i = 0; i < result.size(); ++i)
        result[i] += (*b)[i];
    return result;
}

std::optional<Degrees> degrees_of_sum(const std::optional<Degrees>& a,
                                      const std::optional<Degrees>& b) {
    if (!a) return b;
    if (!b) return a;
    Degrees result = *a;
    for (std::size_t i = 0; i < result.size(); ++i)
        result[i] = std::max(result[i], (*b)[i]);
    return result;
}

} // namespace plprove::model
