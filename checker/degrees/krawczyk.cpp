#include "checker/degrees/krawczyk.h"

#ifndef PLC_ARB
namespace checker {
const bool has_arb = false;
Box certify(const CameraSystem&, const ApproximateSolution&) {
    throw Refused("this plcheck was built without Arb");
}
std::vector<Proof> certify_all(const Certify&, std::span<const ApproximateSolution>, std::size_t) {
    throw Refused("this plcheck was built without Arb");
}
} // namespace checker
#else
#include "checker/degrees/cameras_at.h"
#include "checker/degrees/krawczyk_operator.h"

#include <atomic>
#include <future>

namespace checker {
const bool has_arb = true;

Box certify(const CameraSystem& system, const ApproximateSolution& start) {
    return prove_box<CamerasAt>(system, start);
}

std::vector<Proof> certify_all(const Certify& certify, std::span<const ApproximateSolution> starts,
                               std::size_t threads) {
    std::vector<Proof> proofs(starts.size());
    std::atomic<std::size_t> next = 0; // start that no thread has taken
    const auto work = [&] {
        for (std::size_t i = next++; i < starts.size(); i = next++)
            try {
                proofs[i] = certify(starts[i]);
            } catch (const Refused& refused) {
                proofs[i] = refused;
            }
    };
    std::vector<std::future<void>> others;
    try {
        while (others.size() + 1 < std::min(threads, starts.size()))
            others.push_back(std::async(std::launch::async, [&] {
                work();
                flint_cleanup(); // what Arb keeps for a thread
            }));
    } catch (const std::system_error&) {
        // The system gives no more threads: fewer do it.
    }
    work();
    for (std::future<void>& other : others)
        other.get();
    return proofs;
}
} // namespace checker
#endif
