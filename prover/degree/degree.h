// Camera-degrees: how many complex camera solutions a minimal problem has for generic images, found
// by monodromy, and certificates that there are at least that many (certs/FORMAT.md, section 9).
#pragma once

#include "prover/problem/signature.h"

#include <array>
#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

namespace plprove {

/// How far a run is.
struct DegreeProgress {
    int solutions = 0; ///< found so far
    int edges = 0;     ///< along which they are followed
};

struct DegreeOptions {
    int target = 0;          ///< stop once so many solutions are found; 0: go on until complete
    std::uint64_t seed = 0;  ///< another seed, another sequence of random images and charts
    bool certificate = true; ///< also track the solutions to integer images
    /// Not 0: find a certificate of so many solutions, the quickest way, and nothing else.
    int at_least = 0;
    /// Called now and then by the thread that computes; has no part in the result.
    std::function<void(const DegreeProgress&)> progress = {};
};

/// What one view sees of a feature: integer vectors as in FORMAT.md, section 9.
struct ViewImage {
    std::optional<std::array<std::int64_t, 3>> point;
    std::vector<std::array<std::int64_t, 3>> lines; ///< `toward` if there is a point, else `line`
};

/// The images of one feature, with one entry per view (empty where it sees nothing).
struct FeatureImage {
    Feature feature;
    std::vector<ViewImage> views;
};

/// A starting value for the checker: values / 2^bits; 11 of a real solution, 22 of a pair.
struct ApproximateSolution {
    bool real = false;
    int bits = 0;
    std::vector<std::int64_t> values;
};

/// Evidence that no solution is missing: so many edges permuted the solutions found, and every
/// trace test left a relative residual below 10^trace_exponent; nothing if no image vector can be
/// moved for such a test.
struct CompletenessEvidence {
    int edges = 0;
    std::optional<int> trace_exponent;
};

struct DegreeCertificate {
    std::size_t number = 0; ///< of the label class
    std::optional<CompletenessEvidence> evidence;
    std::vector<FeatureImage> images;
    std::vector<ApproximateSolution> solutions;

    /// How many solutions it shows: pairs count twice.
    int degree() const;
};

/// Of two cameras.
struct PoseCount {
    int poses = 0;
    int essential_matrices = 0;
};

/// What came of tracking one class. `degree` is the number of solutions found, a lower bound that
/// only plcheck certifies; it is complete if there is evidence that it is exact.
struct DegreeRun {
    std::size_t number = 0;
    int degree = 0;
    std::optional<CompletenessEvidence> evidence;
    std::uint64_t tracks = 0;       ///< paths followed, to an end or until lost for good
    std::uint64_t retried = 0;      ///< of these, followed with tighter settings and more digits
    std::uint64_t failed = 0;       ///< of these, lost for good
    std::vector<std::string> notes; ///< why it is not complete, which edges are no bijections, ...
    std::optional<DegreeCertificate> certificate;
    /// Of the solutions found, if two views share five points: the relative poses of these views.
    std::optional<PoseCount> five_point_poses;

    bool complete() const { return evidence.has_value(); }
};

/// The same run for the same class and options on any machine. Assumes that the class is minimal.
DegreeRun compute_degree(std::size_t number, const DegreeOptions& options);

} // namespace plprove
