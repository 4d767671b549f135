// Camera-degrees: the numbers of complex camera solutions of minimal problems for generic images. A
// theorem gives the number (certs/degrees.csv); here the solutions themselves are found, by
// monodromy, as certificates that they exist (certs/FORMAT.md, section 9).
#pragma once

#include "prover/monodromy/progress.h"
#include "prover/problem/signature.h"

#include <array>
#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

namespace plprove {

struct DegreeOptions {
    int target = 0;          ///< stop once this many solutions are found; 0: find all
    std::uint64_t seed = 0;  ///< another seed, another sequence of random images and charts
    bool certificate = true; ///< keep the certificate
    int at_least = 0;        ///< not 0: find this many solutions, whatever the degree is
    /// Called now and then by the thread that computes; has no part in the result.
    std::function<void(const MonodromyProgress&)> progress = {};
    int degree = 0; ///< that a theorem gives: the number of all solutions
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

struct DegreeCertificate {
    std::size_t number = 0; ///< of the label class
    std::vector<FeatureImage> images;
    std::vector<ApproximateSolution> solutions;

    /// How many solutions it shows: pairs count twice.
    int degree() const;
};

/// What came of tracking one class.
struct DegreeRun {
    std::size_t number = 0;
    int degree = 0;   ///< how many solutions were found: certified once plcheck accepts them
    bool all = false; ///< whether this is the number that the theorem gives
    std::uint64_t tracks = 0;       ///< paths followed, to an end or until lost for good
    std::uint64_t retried = 0;      ///< of these, followed with tighter settings and more digits
    std::uint64_t failed = 0;       ///< of these, lost for good
    std::vector<std::string> notes; ///< why nothing came of it
    std::optional<DegreeCertificate> certificate;

    bool complete() const { return all; }
};

/// Finds what the options ask for, or the solutions that it can. The same run for the same class
/// and options on any machine. Assumes that the class is minimal.
DegreeRun compute_degree(std::size_t number, const DegreeOptions& options);

} // namespace plprove
