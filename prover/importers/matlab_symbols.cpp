#include "prover/importers/matlab_symbols.h"

#include "prover/system/words.h"

#include <algorithm>
#include <set>

namespace plprove::importers {

namespace {

using model::ModelError;
using model::Position;

/// In the format of a name, the place of an index.
constexpr std::string_view place_of_index = "%d";

std::size_t places(const std::string& format) {
    std::size_t count = 0;
    for (std::size_t at = 0; (at = format.find(place_of_index, at)) != std::string::npos; ++at)
        ++count;
    return count;
}

std::string with_index(std::string format, std::size_t index) {
    if (const std::size_t at = format.find(place_of_index); at != std::string::npos)
        format.replace(at, place_of_index.size(), std::to_string(index));
    return format;
}

/// The format with a place for each index that it needs: sym names vectors by one index.
std::string complete(const std::string& function, std::string format, Sizes sizes) {
    if (function == "sym") {
        const bool is_vector = sizes.rows == 1 || sizes.columns == 1;
        if (places(format) == 0) format += is_vector ? "%d" : "%d_%d";
    } else {
        while (places(format) < 2)
            format += place_of_index;
    }
    return format;
}

void refuse_unless_name(const std::string& text, Position at) {
    const auto is_letter = [](char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'); };
    const auto fits = [&](char c) {
        return is_letter(c) || (c >= '0' && c <= '9') || c == '_' || c == '%' || c == '(' ||
               c == ')' || c == ',';
    };
    if (text.empty() || !is_letter(text.front()) || !std::ranges::all_of(text, fits))
        throw ModelError(at, "found " + in_quotes(text) + ", which is no name of a symbol");
}

} // namespace

bool MatlabSymbols::has(const std::string& name) const {
    return std::ranges::any_of(symbols_, [&](const auto& s) { return s.first == name; });
}

std::string MatlabSymbols::new_name(const std::string& name, Position at) {
    constexpr std::size_t most = 1000;
    if (symbols_.size() + random_.size() >= most)
        throw ModelError(at, "a program to import has at most 1000 variables");
    return draft_.new_name(name);
}

Value MatlabSymbols::symbol(const std::string& name, Position at) {
    const auto found =
        std::ranges::find_if(symbols_, [&](const auto& s) { return s.first == name; });
    if (found != symbols_.end()) return Value::scalar(found->second);
    symbols_.emplace_back(name, new_name(name, at));
    return Value::scalar(symbols_.back().second);
}

Array MatlabSymbols::symbols(const std::string& format, Sizes sizes, Position at) {
    Array result{sizes.rows, sizes.columns, {}};
    for (std::size_t j = 1; j <= sizes.columns; ++j)
        for (std::size_t i = 1; i <= sizes.rows; ++i)
            result.entries.push_back(symbol(places(format) == 1
                                                ? with_index(format, std::max(i, j))
                                                : with_index(with_index(format, i), j),
                                            at));
    return result;
}

Array MatlabSymbols::random(const std::string& name, Sizes sizes, Position at) {
    const std::string format = sizes.rows == 1 && sizes.columns == 1   ? name
                               : sizes.rows == 1 || sizes.columns == 1 ? name + "_%d"
                                                                       : name + "_%d_%d";
    Array result{sizes.rows, sizes.columns, {}};
    for (std::size_t j = 1; j <= sizes.columns; ++j)
        for (std::size_t i = 1; i <= sizes.rows; ++i) {
            const std::string entry = places(format) == 1 ? with_index(format, std::max(i, j))
                                                          : with_index(with_index(format, i), j);
            random_.push_back(new_name(entry, at));
            result.entries.push_back(Value::scalar(random_.back()));
        }
    return result;
}

bool MatlabSymbols::has_function(const std::string& name) {
    static const std::set<std::string> names{"sym",   "gbs_Matrix", "create_vars",
                                             "randi", "rand",       "randn"};
    return names.contains(name);
}

std::optional<Array> MatlabSymbols::call(const std::string& name, const std::string& text,
                                         const std::vector<Array>& arguments,
                                         const std::string& target, Position at) {
    if (name == "randi" || name == "rand" || name == "randn")
        return random(target, sizes_of(arguments, name == "randi" ? 1 : 0, at), at);
    if (name == "create_vars") {
        std::vector<Array> column = arguments;
        column.push_back(Array::scalar(constant(1)));
        return symbols("x%d", sizes_of(column, 0, at), at);
    }
    if (name != "gbs_Matrix" && (name != "sym" || text.empty())) return std::nullopt;
    refuse_unless_name(text, at);
    if (arguments.empty()) return Array::scalar(symbol(text, at));
    const Sizes sizes = sizes_of(arguments, 0, at);
    return symbols(complete(name, text, sizes), sizes, at);
}

void MatlabSymbols::set_unknowns(const std::vector<std::string>& names, Position at) {
    for (const std::string& name : names)
        if (!has(name))
            throw ModelError(at, "found the unknown " + in_quotes(name) +
                                     ", which is no symbol of the program");
    unknowns_ = names;
    has_unknowns_ = true;
}

void MatlabSymbols::declare() {
    draft_.data = random_;
    for (const auto& [name, given] : symbols_) {
        const bool unknown =
            !has_unknowns_ || std::ranges::find(unknowns_, name) != unknowns_.end();
        (unknown ? draft_.unknowns : draft_.data).push_back(given);
    }
}

} // namespace plprove::importers
