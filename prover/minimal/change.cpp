#include "prover/minimal/change.h"

#include "prover/problem/notation.h"

#include <algorithm>

namespace plprove {

std::string in_words(const Change& change) {
    if (change.added && change.dropped)
        return "put " + notation(*change.added) + " for " + notation(*change.dropped);
    if (change.added) return "add " + notation(*change.added);
    return "drop " + notation(*change.dropped);
}

Features changed(const Features& problem, const Change& change) {
    Features result = problem;
    if (change.dropped) {
        const auto place = std::ranges::find(result, *change.dropped);
        if (change.added)
            *place = *change.added;
        else
            result.erase(place);
    } else if (change.added) {
        result.push_back(*change.added);
    }
    return result;
}

} // namespace plprove
