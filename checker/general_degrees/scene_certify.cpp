#include "checker/general_degrees/scene_certify.h"

#ifdef PLC_ARB
#include "checker/degrees/krawczyk_operator.h"
#include "checker/general_degrees/scene_at.h"

namespace checker {
Box certify_cameras(const SceneSystem& system, const ApproximateSolution& start) {
    Box box = prove_box<SceneAt>(system, start);
    box.low.resize(2 * system.camera_coordinates());
    box.high.resize(2 * system.camera_coordinates());
    return box;
}
} // namespace checker
#else
namespace checker {
Box certify_cameras(const SceneSystem&, const ApproximateSolution&) {
    throw Refused("this plcheck was built without Arb");
}
} // namespace checker
#endif
