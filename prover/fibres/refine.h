// Solutions for integer images, to as many digits as one likes, by Newton's method.
#pragma once

#include "prover/fibres/camera_images.h"
#include "prover/fibres/many_digits.h"

namespace plprove {

/// A solution and, unless it is real, its complex conjugate.
struct RefinedSolution {
    bool real = true;
    std::vector<BigComplex> coordinates;
};

/// The solutions of a certificate, to more and more bits.
class Refinement {
public:
    /// To some hundred bits. Throws std::runtime_error where Newton's method does not converge from
    /// the starting values.
    explicit Refinement(const DegreeCertificate& certificate);

    /// To about twice as many bits. Throws std::runtime_error where a step loses too many.
    void double_digits();

    slong bits() const { return bits_; }
    const std::vector<RefinedSolution>& solutions() const { return solutions_; }

private:
    CameraImages images_;
    slong bits_;
    std::vector<RefinedSolution> solutions_;
};

} // namespace plprove
