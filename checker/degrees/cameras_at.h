// The camera equations at some place, over any ring of numbers, for proofs of solutions.
#pragma once

#include "checker/degrees/degeneracy.h"

namespace checker {
/// The camera equations at some place.
template <class T> class CamerasAt {
public:
    explicit CamerasAt(const CameraSystem& system) : system_(system) {}

    void move_to(const std::vector<T>& z) {
        std::copy(z.begin(), z.end(), cameras_.begin());
        back_project(system_, cameras_, space_);
    }

    T equation(std::size_t e, std::vector<T>& row) {
        const T value = evaluate(system_, system_.equations[e], space_, derivatives_);
        std::copy(derivatives_.begin(), derivatives_.end(), row.begin());
        return value;
    }

    std::string_view degeneracy() const { return checker::degeneracy(system_, cameras_, space_); }

private:
    const CameraSystem& system_;
    CameraCoordinates<T> cameras_, derivatives_;
    BackProjections<T> space_;
};
} // namespace checker
