#include "prover/model/solver/data_way.h"

#include "prover/system/in_parts.h"

#include <algorithm>

namespace plprove::model {

namespace {

TrackSettings settings_for(Care care) {
    TrackSettings settings{.largest_step = 0.2, .smallest_step = 1e-10, .most_steps = 2000};
    if (care == Care::usual) return settings;
    settings.prediction = 1e-6;
    settings.contraction = 0.005;
    settings.largest_step = 0.05;
    settings.most_steps = 20000;
    return settings;
}

std::vector<TrackedCurve> curves_of(const DataWay& way) {
    std::vector<TrackedCurve> curves;
    for (std::size_t i = 0; i < way.from.size(); ++i) {
        const std::complex<double> a = way.from[i], c = way.bend[i], b = way.to[i] - a + c;
        curves.push_back({{{a.real(), a.imag()}, {b.real(), b.imag()}, {-c.real(), -c.imag()}}});
    }
    return curves;
}

} // namespace

PathEnds<Numbers> follow_all(const TrackedEquations& equations, const DataWay& way,
                             const std::vector<Numbers>& starts, Care care, unsigned threads) {
    const std::vector<TrackedCurve> curves = curves_of(way);
    const TrackSettings settings = settings_for(care);
    const auto n = static_cast<std::size_t>(equations.tracked().unknowns);
    PathEnds<Numbers> ends(starts.size());
    in_parts(starts.size(), threads, [&](std::size_t begin, std::size_t end) {
        Numbers from, to((end - begin) * n);
        for (std::size_t i = begin; i < end; ++i)
            from.insert(from.end(), starts[i].begin(), starts[i].end());
        std::vector<TrackOutcome> outcomes(end - begin);
        std::vector<LaneNumber> workspace(workspace_size(equations.tracked()));
        fastest_tracker()(equations.tracked(), curves.data(), settings, end - begin,
                          reinterpret_cast<const double*>(from.data()),
                          reinterpret_cast<double*>(to.data()), outcomes.data(), workspace.data());
        for (std::size_t i = begin; i < end; ++i) {
            if (outcomes[i - begin] != TrackOutcome::arrived) continue;
            const auto first = to.begin() + static_cast<std::ptrdiff_t>((i - begin) * n);
            ends[i] = Numbers(first, first + static_cast<std::ptrdiff_t>(n));
        }
    });
    return ends;
}

} // namespace plprove::model
