// What functions of libpointline return that can fail.
#pragma once

#include <string>
#include <utility>
#include <variant>

namespace pointline {

enum class Failure {
    bad_problem, ///< no problem, or one that is neither minimal nor camera-minimal
    bad_images,  ///< not what the problem says that the views see, or no finite numbers
    bad_start,   ///< a file that is no start of this problem, or is damaged
    no_estimate, ///< no cameras explain more matches than a sample has
    system       ///< a file that cannot be read or written, or no memory
};

struct Error {
    Failure failure{};
    std::string message; ///< what is wrong, where, and what to do
};

/// A value, or why there is none.
template <class T>
class Result {
public:
    Result(T value) : content_(std::move(value)) {}
    Result(Error error) : content_(std::move(error)) {}

    explicit operator bool() const { return std::holds_alternative<T>(content_); }
    /// Assumes that there is a value.
    const T& operator*() const { return *std::get_if<T>(&content_); }
    const T* operator->() const { return std::get_if<T>(&content_); }
    /// Assumes that there is none.
    const Error& error() const { return *std::get_if<Error>(&content_); }

private:
    std::variant<T, Error> content_;
};

} // namespace pointline
