// What cycles show of a group: the prover says what the checker will, of all cycles that there are.
#include "prover/groups/cycle_types.h"
#include "checker/fibres/frobenius.h"

#include <doctest/doctest.h>

namespace {

using plprove::CycleType;

/// All ascending lists of numbers with this sum that begin with `first` or more.
std::vector<CycleType> partitions(int sum, int first = 1) {
    std::vector<CycleType> all;
    if (sum == 0) all.emplace_back();
    for (int length = first; length <= sum; ++length)
        for (CycleType rest : partitions(sum - length, length)) {
            rest.insert(rest.begin(), length);
            all.push_back(rest);
        }
    return all;
}

checker::CycleType for_checker(const CycleType& lengths) {
    return {lengths.begin(), lengths.end()};
}

} // namespace

TEST_CASE("of any two permutations the prover knows what the checker will find") {
    for (const int degree : {2, 3, 4, 5, 6, 7, 8, 9, 11}) {
        int symmetric = 0, alternating = 0;
        const std::vector<CycleType> types = partitions(degree);
        for (const bool transitive : {false, true})
            for (const CycleType& a : types)
                for (const CycleType& b : types) {
                    const std::string group = plprove::group_shown_by({a, b}, degree, transitive);
                    const auto orbits =
                        transitive ? checker::Orbits::one : checker::Orbits::unknown;
                    CHECK(group == checker::group_shown_by({for_checker(a), for_checker(b)},
                                                           static_cast<std::size_t>(degree),
                                                           orbits));
                    if (group == "S" + std::to_string(degree)) ++symmetric;
                    if (group.starts_with(">=")) ++alternating;
                }
        CHECK(symmetric > 0);
        CHECK((alternating > 0) == (degree > 2));
    }
}

TEST_CASE("as few permutations as will do, the first ones") {
    const std::vector<CycleType> types{{1, 2, 5}, {3, 5}, {1, 7}, {3, 5}, {8}};
    using Places = std::vector<std::size_t>;
    const auto chosen = [&](const std::string& group, std::size_t most, bool transitive = false,
                            Places among = {0, 1, 2, 3, 4}) {
        return plprove::fewest_that_show(among.size(), most, [&](const Places& places) {
            std::vector<CycleType> own;
            for (const std::size_t place : places)
                own.push_back(types[among[place]]);
            return plprove::group_shown_by(own, 8, transitive) == group;
        });
    };
    CHECK(chosen("S8", 2) == Places{1, 4});
    CHECK(chosen("S8", 2, true) == Places{0, 1});
    CHECK(chosen(">=A8", 3) == Places{0, 4});
    CHECK(chosen("S8", 1).empty());
    CHECK(chosen("S8", 2, true, {1, 3}).empty());
    CHECK(chosen("S8", 3, true, {1, 3, 0}) == Places{0, 2});
}
