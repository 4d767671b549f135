// Camera-degrees: the number of complex camera solutions that a minimal problem has for generic
// images. A theorem gives it (certs/degrees.csv). Here the solutions themselves are found, by
// monodromy, for certificates that they exist (certs/FORMAT.md, section 9).
#pragma once

#include "prover/monodromy/progress.h"
#include "prover/monodromy/starting_values.h"
#include "prover/problem/signature.h"

#include <array>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace plprove {

struct DegreeOptions {
    int target = 0;         ///< stop once this many solutions are found; 0: find all
    std::uint64_t seed = 0; ///< another seed, another sequence of random images and charts
    int at_least = 0;       ///< not 0: find this many solutions, whatever the degree is
    /// Called now and then by the thread that computes; has no part in the result.
    std::function<void(const MonodromyProgress&)> progress = {};
    bool small_images = false; ///< images with few digits
    bool fibre = false;        ///< all solutions at once, modulo q, in place of approximations
    int degree = 0;            ///< that a theorem gives: the number of all solutions
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

struct DegreeCertificate {
    std::size_t number = 0; ///< of the label class
    std::vector<FeatureImage> images;
    std::vector<StartingValues> solutions;

    /// How many solutions it shows.
    int degree() const { return count_solutions(solutions); }
};

/// What came of tracking one class, or one problem of a family.
struct DegreeRun {
    std::size_t number = 0;
    std::string problem{}; ///< of a family, in notation
    int degree = 0;        ///< how many solutions were found: certified once plcheck accepts them
    bool complete = false; ///< whether this is the number that the theorem gives; for a family,
                           ///< evidence of that
    std::uint64_t tracks = 0;       ///< paths followed, to an end or until lost for good
    std::uint64_t retried = 0;      ///< of these, followed with tighter settings and more digits
    std::uint64_t failed = 0;       ///< of these, lost for good
    std::vector<std::string> notes; ///< why nothing came of it
    std::optional<DegreeCertificate> certificate; ///< of these solutions
    std::string record; ///< in place of the certificate, as text: of a fibre, or of a family
};

/// Finds what the options ask for, or the solutions that it can. The same run for the same class
/// and options on any machine. Assumes that the class is minimal.
DegreeRun compute_degree(std::size_t number, const DegreeOptions& options);

} // namespace plprove
