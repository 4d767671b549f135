#include "prover/many_views/upper_bound.h"

#include "prover/format/certificate_text.h"
#include "prover/problem/notation.h"

namespace plprove::many_views {

UpperBoundRecord propose_upper_bound(const Problem& problem, const Powers& powers,
                                     std::uint64_t seed) {
    constexpr std::uint64_t stream = 3; // another one than those of monodromy and its certificates
    constexpr int further_for_each = 3; // views of the problem but the first
    Random random(seed, stream);
    const int views = problem.views + further_for_each * (problem.views - 1);
    return {problem, random_integer_images(problem, views, random), powers};
}

std::string write_upper_bounds(std::span<const UpperBoundRecord> records) {
    constexpr std::size_t digits_of_images = 9;
    CertificateText text;
    for (const UpperBoundRecord& record : records) {
        text.line("problem", notation(record.problem));
        for (const std::vector<int>& view : record.views)
            text.line("view", coordinates(view, digits_of_images));
        text.line("powers", record.powers.cubics, record.powers.linear);
    }
    return certificate_file("at-most", text.take(), "ask for fewer problems");
}

} // namespace plprove::many_views
