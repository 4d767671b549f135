// Classification files short enough to replay thousands of times a second: the classes are a few of
// all, renumbered. The checker takes the classes as a parameter, so that its code is the same.
#pragma once

#include "checker/problem/classes.h"

#include <array>
#include <span>
#include <string>
#include <string_view>

/// Classes of every kind: minimal ones from either end, with an excess of a pair of views of 1 or
/// more, with several excesses, with stars of 3 to 7 pins, with both.
inline constexpr std::array<std::size_t, 19> short_classes{
    0,    1,    2,     545,   1337,   1832,   2394,   4763,   5093,  5555,
    6722, 7000, 20000, 60000, 100000, 119016, 125451, 130456, 143000};

/// The classes with these numbers, which ascend; their numbers are now 0, 1, ...
inline checker::Classification classification_of(const checker::Classification& all,
                                                 std::span<const std::size_t> numbers) {
    checker::Classification few{.signatures = numbers.size()};
    for (const std::size_t number : numbers)
        few.representatives.push_back(all.representatives[number]);
    for (const auto& signature : few.representatives) {
        std::size_t first = 0; // the first class of the same swap&label class
        while (checker::largest_swapped(few.representatives[first]) !=
               checker::largest_swapped(signature))
            ++first;
        few.swap_class.push_back(first);
    }
    return few;
}

/// Of the text of a classification file, what is about these classes, renumbered, with those
/// instances of features that they use.
std::string shorten(std::string_view archive, const checker::Classification& all,
                    std::span<const std::size_t> numbers);
