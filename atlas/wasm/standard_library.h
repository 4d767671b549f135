// What the C++ library of Debian's Emscripten (LLVM 13) lacks of C++20, as far as checker/ and
// prover/ use it: algorithms on ranges, and the order of arrays, vectors and texts. Each
// calls the algorithm on iterators that C++17 has. The sources are compiled as they are, with this
// file before the first line of each.
#pragma once

#include <algorithm>
#include <array>
#include <compare>
#include <functional>
#include <iterator>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace std {

template <class List>
strong_ordering compare_lists(const List& a, const List& b) {
    for (size_t i = 0; i < a.size() && i < b.size(); ++i) {
        const strong_ordering order = a[i] <=> b[i];
        if (order != strong_ordering::equal) return order;
    }
    return a.size() <=> b.size();
}

template <class T>
strong_ordering operator<=>(const vector<T>& a, const vector<T>& b) {
    return compare_lists(a, b);
}

template <class T, size_t size>
strong_ordering operator<=>(const array<T, size>& a, const array<T, size>& b) {
    return compare_lists(a, b);
}

template <class Character>
strong_ordering operator<=>(basic_string_view<Character> a, basic_string_view<Character> b) {
    return a.compare(b) <=> 0;
}

template <class Character>
strong_ordering operator<=>(const basic_string<Character>& a, const basic_string<Character>& b) {
    return a.compare(b) <=> 0;
}

namespace ranges {

/// Compares what a projection makes of two values.
template <class Compare, class Projection>
auto by(Compare compare, Projection projection) {
    return [compare, projection](const auto& a, const auto& b) {
        return std::invoke(compare, std::invoke(projection, a), std::invoke(projection, b));
    };
}

template <class Range, class Predicate, class Projection = std::identity>
auto find_if(Range&& range, Predicate predicate, Projection projection = {}) {
    return std::find_if(std::begin(range), std::end(range), [&](const auto& element) {
        return std::invoke(predicate, std::invoke(projection, element));
    });
}

template <class Range, class Value, class Projection = std::identity>
auto find(Range&& range, const Value& value, Projection projection = {}) {
    return std::find_if(std::begin(range), std::end(range), [&](const auto& element) {
        return std::invoke(projection, element) == value;
    });
}

template <class Range, class Predicate, class Projection = std::identity>
bool any_of(Range&& range, Predicate predicate, Projection projection = {}) {
    return ranges::find_if(range, predicate, projection) != std::end(range);
}

template <class Range, class Predicate, class Projection = std::identity>
bool none_of(Range&& range, Predicate predicate, Projection projection = {}) {
    return !ranges::any_of(range, predicate, projection);
}

template <class Range, class Predicate>
bool all_of(Range&& range, Predicate predicate) {
    return ranges::none_of(range, std::not_fn(predicate));
}

template <class Range, class Predicate>
auto count_if(Range&& range, Predicate predicate) {
    return std::count_if(std::begin(range), std::end(range), [&](const auto& element) {
        return static_cast<bool>(std::invoke(predicate, element));
    });
}

template <class Range, class Value, class Projection = std::identity>
auto count(Range&& range, const Value& value, Projection projection = {}) {
    return std::count_if(std::begin(range), std::end(range), [&](const auto& element) {
        return std::invoke(projection, element) == value;
    });
}

template <class Range, class Compare = std::less<void>, class Projection = std::identity>
void sort(Range&& range, Compare compare = {}, Projection projection = {}) {
    std::sort(std::begin(range), std::end(range), ranges::by(compare, projection));
}

template <class Range, class Compare = std::less<void>, class Projection = std::identity>
void stable_sort(Range&& range, Compare compare = {}, Projection projection = {}) {
    std::stable_sort(std::begin(range), std::end(range), ranges::by(compare, projection));
}

template <class Iterator, class Compare = std::less<void>, class Projection>
auto max_element(Iterator first, Iterator last, Compare compare, Projection projection) {
    return std::max_element(first, last, ranges::by(compare, projection));
}

template <class Range, class Compare = std::less<void>, class Projection = std::identity>
auto max_element(Range&& range, Compare compare = {}, Projection projection = {}) {
    return std::max_element(std::begin(range), std::end(range), ranges::by(compare, projection));
}

template <class Range, class Compare = std::less<void>, class Projection = std::identity>
auto min_element(Range&& range, Compare compare = {}, Projection projection = {}) {
    return std::min_element(std::begin(range), std::end(range), ranges::by(compare, projection));
}

template <class Range>
auto max(Range&& range) {
    return *std::max_element(std::begin(range), std::end(range));
}

template <class Range, class Value, class Compare = std::less<void>,
          class Projection = std::identity>
auto lower_bound(Range&& range, const Value& value, Compare compare = {},
                 Projection projection = {}) {
    return std::lower_bound(
        std::begin(range), std::end(range), value, [&](const auto& element, const Value& sought) {
            return std::invoke(compare, std::invoke(projection, element), sought);
        });
}

template <class Range, class Value>
bool binary_search(Range&& range, const Value& value) {
    return std::binary_search(std::begin(range), std::end(range), value);
}

template <class Range>
auto adjacent_find(Range&& range) {
    return std::adjacent_find(std::begin(range), std::end(range));
}

template <class First, class Second, class Output>
void set_intersection(First&& first, Second&& second, Output output) {
    std::set_intersection(std::begin(first), std::end(first), std::begin(second), std::end(second),
                          output);
}

template <class First, class Second, class Output>
void set_union(First&& first, Second&& second, Output output) {
    std::set_union(std::begin(first), std::end(first), std::begin(second), std::end(second),
                   output);
}

template <class First, class Second, class Output>
void set_difference(First&& first, Second&& second, Output output) {
    std::set_difference(std::begin(first), std::end(first), std::begin(second), std::end(second),
                        output);
}

template <class First, class Second>
bool includes(First&& first, Second&& second) {
    return std::includes(std::begin(first), std::end(first), std::begin(second), std::end(second));
}

template <class Range, class Output>
void copy(Range&& range, Output output) {
    std::copy(std::begin(range), std::end(range), output);
}

template <class Range, class Output>
void move(Range&& range, Output output) {
    std::move(std::begin(range), std::end(range), output);
}

template <class Range, class Output, class Function>
void transform(Range&& range, Output output, Function function) {
    std::transform(std::begin(range), std::end(range), output,
                   [&](const auto& element) { return std::invoke(function, element); });
}

template <class Iterator, class Value>
void replace(Iterator first, Iterator last, const Value& old_value, const Value& new_value) {
    std::replace(first, last, old_value, new_value);
}

template <class Range, class Predicate, class Value>
void replace_if(Range&& range, Predicate predicate, const Value& new_value) {
    std::replace_if(std::begin(range), std::end(range), predicate, new_value);
}

template <class Range>
auto next_permutation(Range&& range) {
    struct Result {
        bool found;
    };
    return Result{std::next_permutation(std::begin(range), std::end(range))};
}

template <class Range, class Value>
void replace(Range&& range, const Value& old_value, const Value& new_value) {
    std::replace(std::begin(range), std::end(range), old_value, new_value);
}

template <class A, class B>
bool equal(A&& a, B&& b) {
    return std::equal(std::begin(a), std::end(a), std::begin(b), std::end(b));
}

template <class A, class B>
void swap_ranges(A&& a, B&& b) {
    std::swap_ranges(std::begin(a), std::end(a), std::begin(b));
}

template <class Range>
void reverse(Range&& range) {
    std::reverse(std::begin(range), std::end(range));
}

} // namespace ranges
} // namespace std
