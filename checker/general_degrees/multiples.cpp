#include "checker/general_degrees/multiples.h"

#include "checker/cameras/camera_model.h"

namespace checker {
std::size_t at_least(const Problem& problem, std::size_t counted) {
    if (problem.cameras != &calibrated_cameras) return counted;
    const std::size_t factor = std::size_t{1} << problem.view_count();
    return (counted + factor - 1) / factor * factor;
}
} // namespace checker
