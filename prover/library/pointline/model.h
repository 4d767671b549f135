// What is known of a problem that is given by equations: a model (docs/models.md).
#pragma once

#include <pointline/result.h>

#include <memory>
#include <optional>
#include <string>
#include <string_view>

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
    struct Content;
    explicit Model(std::shared_ptr<Content> content);
    std::shared_ptr<Content> content_;
};

} // namespace pointline
