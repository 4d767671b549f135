// What the mutators of mutants.cpp and degree_mutants.cpp have in common: finding words and lines
// of a file, and changing numbers.
#pragma once

#include "tests/mutation/mutants.h"

#include <algorithm>
#include <functional>
#include <gmpxx.h>
#include <initializer_list>

namespace mutation {

using Words = std::vector<std::string>;

inline bool is_number(std::string_view word) {
    if (word.starts_with('-')) word.remove_prefix(1);
    return !word.empty() && word.find_first_not_of("0123456789") == word.npos;
}

/// 0 for what is not a number: an earlier change may have spoilt it.
inline mpz_class value_of(const std::string& word) {
    return is_number(word) ? mpz_class(word) : mpz_class(0);
}

/// Lines that begin with one of these words.
inline std::vector<std::size_t> lines_of(const File& file,
                                         std::span<const std::string_view> first) {
    std::vector<std::size_t> found;
    for (std::size_t i = 0; i < file.size(); ++i)
        if (std::ranges::find(first, file[i][0]) != first.end()) found.push_back(i);
    return found;
}

inline std::vector<std::size_t> lines_of(const File& file,
                                         std::initializer_list<std::string_view> first) {
    return lines_of(file, std::span(first.begin(), first.size()));
}

template <class Range>
auto& any_of(Range& range, Random& random) {
    return range[random.below(range.size())];
}

template <class List>
auto at(List& list, std::size_t place) {
    return list.begin() + static_cast<std::ptrdiff_t>(place);
}

inline void add(std::string& word, long amount) {
    word = mpz_class(value_of(word) + amount).get_str();
}

/// One more, or one less.
inline void step(std::string& word, Random& random) {
    add(word, random.below(2) == 0 ? 1 : -1);
}

inline void multiply(std::string& word, long factor) {
    word = mpz_class(value_of(word) * factor).get_str();
}

inline bool is_feature(std::string_view word) {
    return word.find('/') != word.npos;
}

using Wanted = std::function<bool(const Words&, std::size_t)>; // of a line, a word in it

/// Where a wanted word stands.
inline std::vector<std::string*> find(File& file, const Wanted& wanted) {
    std::vector<std::string*> found;
    for (Words& words : file)
        for (std::size_t i = 0; i < words.size(); ++i)
            if (wanted(words, i)) found.push_back(&words[i]);
    return found;
}

/// Changes some wanted word.
template <class Change>
void change(File& file, Random& random, const Wanted& wanted, Change change) {
    const auto found = find(file, wanted);
    if (!found.empty()) change(*any_of(found, random));
}

/// A symbol of a feature changed, left out or put in.
inline void change_symbol(File& file, Random& random, std::string_view symbols) {
    change(
        file, random, [](const Words& words, std::size_t i) { return is_feature(words[i]); },
        [&](std::string& word) {
            const std::size_t place = random.below(word.size());
            if (random.below(3) == 0)
                word.erase(place, 1);
            else if (random.below(2) == 0)
                word.insert(place, 1, symbols[random.below(symbols.size())]);
            else
                word[place] = symbols[random.below(symbols.size())];
        });
}

} // namespace mutation
