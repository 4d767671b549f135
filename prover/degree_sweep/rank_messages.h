// What ranks say to each other in a sweep. Each message is a word, and perhaps more.
#pragma once

#include <charconv>
#include <cstddef>
#include <stdexcept>
#include <string>
#include <string_view>

namespace plprove::rank_messages {

// To rank 0.
inline constexpr std::string_view next = "next";     ///< a thread has nothing to do
inline constexpr std::string_view done = "done";     ///< and the number of a class: it is on file
inline constexpr std::string_view failed = "failed"; ///< and the reason
inline constexpr std::string_view left = "left";     ///< the last one of a rank

// From rank 0.
inline constexpr std::string_view compute = "compute"; ///< and the number of a class
inline constexpr std::string_view end = "end";         ///< of the work

inline std::string with(std::string_view word, std::string_view more) {
    std::string text(word);
    return text.append(" ").append(more);
}

inline std::string with(std::string_view word, std::size_t number) {
    return with(word, std::to_string(number));
}

/// Whether the message begins with this word.
inline bool says(std::string_view message, std::string_view word) {
    return message.substr(0, message.find(' ')) == word;
}

/// What follows the first word.
inline std::string_view rest_of(std::string_view message) {
    const std::size_t space = message.find(' ');
    return space == std::string_view::npos ? "" : message.substr(space + 1);
}

/// The number that follows the first word. Throws std::runtime_error if none does.
inline std::size_t number_in(std::string_view message) {
    const std::string_view digits = rest_of(message);
    std::size_t number = 0;
    const char* const last = digits.data() + digits.size();
    const auto [stop, error] = std::from_chars(digits.data(), last, number);
    if (error == std::errc{} && stop == last) return number;
    throw std::runtime_error("a rank says \"" + std::string(message) +
                             "\": start all ranks from the same plprove");
}

} // namespace plprove::rank_messages
