// What is known of a problem that is given by equations: a model (docs/models.md).
#pragma once

#include <pointline/result.h>

#include <complex>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace pointline {

/// How many complex solutions there are for generic data, as far as is known.
struct Solutions {
    std::optional<int> at_least;
    std::optional<int> at_most;
};

/// A model. Copies share what is found out once; several threads may ask.
class Model {
public:
    /// Reads the text of a model. Fails where it is none.
    static Result<Model> read(std::string_view text) noexcept;

    const std::string& name() const;
    std::optional<int> claimed() const; ///< by the source
    /// How many scalars, and scalar equations.
    int data() const;
    int unknowns() const;
    int equations() const;

    /// Looks for bounds, which may take long the first time.
    Result<Solutions> solutions() const noexcept;
    /// A file that `plcheck` replays. Fails where nothing was found to certify.
    Result<std::string> certificate() const noexcept;
    /// A Python module that solves the problem for any data. Fails where there is no template.
    Result<std::string> python_solver() const noexcept;

private:
    friend class ModelSolver;
    struct Content;
    explicit Model(std::shared_ptr<Content> content);
    std::shared_ptr<Content> content_;
};

/// A name of data or of unknowns: an array. Without sizes it is a number.
struct NamedArray {
    std::string name;
    std::vector<int> shape;
};

struct ModelSolution {
    std::vector<std::complex<double>> unknowns; ///< of all names in order, arrays by rows
    bool real = false;
    double residual = 0; ///< the largest value of an equation, relative to its terms
};

/// Solutions for some data, different in what counts; real ones first. They are approximate.
struct ModelAnswer {
    std::vector<ModelSolution> solutions;
    int lost = 0; ///< how many fewer these are than for random data
};

/// Solves one model for any data. Several threads may use it.
class ModelSolver {
public:
    /// Finds the solutions for random data, from which paths lead to those for other data. Fails
    /// where equations and unknowns are not equally many, there are no data, or no solution is
    /// found.
    static Result<ModelSolver> make(const Model& model) noexcept;

    const std::vector<NamedArray>& data() const;
    const std::vector<NamedArray>& unknowns() const;
    /// How many solutions there are for random data.
    int found() const;

    /// `data` are the scalars of all names in order, arrays by rows. Fails where they are not as
    /// many as the model has, or not finite.
    Result<ModelAnswer> solve(std::span<const double> data) const noexcept;

private:
    struct Content;
    explicit ModelSolver(std::shared_ptr<const Content> content);
    std::shared_ptr<const Content> content_;
};

} // namespace pointline
