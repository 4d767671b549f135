// The degrees on file as a linear form on products of features.
//
// Write [f] for the constraint that a feature f puts on the cameras, a product for several features
// together, and deg for the camera-degree. Features with the same constraint, such as `a/P/Pa` and
// `a/Pa/P`, are one letter. The weight of a product is the number of constraints; deg is defined on
// products of weight 11, and 0 where the problem is not minimal.
#pragma once

#include "checker/degrees/constraint_class.h"

#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace laws {

/// A product of letters: how often each feature occurs. Only letters occur.
using Product = checker::Signature;

/// The feature that stands for all features with the same constraint.
inline std::size_t letter(std::size_t feature) {
    return checker::earlier_of_swap[checker::exchanged(feature)];
}

Product operator*(const Product& left, const Product& right);

unsigned weight(const Product& product);

/// All products of that weight.
std::vector<Product> products(unsigned weight);

/// One line of degrees.csv that says what the degree of a class is.
struct DegreeLine {
    std::size_t number = 0; ///< of the label class
    std::int64_t degree = 0;
};

/// The exact degrees in a file such as certs/degrees.csv, evidence or certified. Throws
/// std::runtime_error with what to do if the file cannot be read or a line is not as expected.
std::vector<DegreeLine> read_exact_degrees(const std::filesystem::path& file);

/// A minimal constraint class, with its degree on file.
struct ClassDegree {
    std::size_t number = 0; ///< the smallest number of a label class in it
    std::string notation;   ///< of the representative of that label class
    std::int64_t degree = 0;
};

/// The linear form deg.
class DegreeForm {
public:
    /// Throws std::runtime_error if a minimal constraint class has no degree among the lines, or
    /// two, or a line speaks of a class that is not minimal.
    explicit DegreeForm(const std::vector<DegreeLine>& lines);

    const std::vector<ClassDegree>& classes() const { return classes_; }

    /// The index in classes() of the class of a product of weight 11; nothing if the problem is not
    /// minimal.
    std::optional<std::size_t> class_of(const Product& product) const;

    /// The index in classes() of the class that a label class belongs to; nothing if that is not
    /// minimal.
    std::optional<std::size_t> class_with(std::size_t number) const;

    /// deg of a product of weight 11.
    std::int64_t degree(const Product& product) const {
        const std::optional<std::size_t> index = class_of(product);
        return index ? classes_[*index].degree : 0;
    }

    /// Replaces the degree of a class.
    void set_degree(std::size_t index, std::int64_t degree) { classes_[index].degree = degree; }

private:
    checker::Classification all_ = checker::classify();
    std::vector<ClassDegree> classes_;
    std::map<Product, std::size_t> index_; ///< by the signature that stands for the class
};

} // namespace laws
