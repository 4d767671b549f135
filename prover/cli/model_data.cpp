#include "prover/cli/model_data.h"

#include "prover/model/names.h"
#include "prover/system/words.h"

#include <algorithm>
#include <nlohmann/json.hpp>
#include <set>

namespace plprove {

namespace {

using Json = nlohmann::ordered_json;
using Shape = std::vector<int>;

/// "a number", "a list of 3 numbers", "5 lists of 3 numbers".
std::string describe(const Shape& shape, std::size_t depth = 0) {
    if (depth == shape.size()) return depth == 0 ? "a number" : "numbers";
    const std::string count = std::to_string(shape[depth]);
    if (depth + 1 == shape.size())
        return (depth == 0 ? "a list of " : "lists of ") + count +
               (shape[depth] == 1 ? " number" : " numbers");
    return (depth == 0 ? "a list of " + count + " " : "lists of " + count + " ") +
           describe(shape, depth + 1);
}

std::string describe(const Json& value) {
    if (value.is_array())
        return "a list of " + std::to_string(value.size()) +
               (value.size() == 1 ? " value" : " values");
    return in_quotes(value.dump(-1, ' ', true, Json::error_handler_t::replace));
}

/// Reads a file of data.
class Reader {
public:
    Reader(const model::Program& program, std::string path)
        : program_(program), path_(std::move(path)) {}

    std::vector<std::complex<double>> read(const std::string& text) {
        const Json file = parsed(text);
        if (!file.is_object())
            throw BadInput(path_ +
                           " is no JSON object: it needs an entry for each name of data, "
                           "such as {" +
                           Json(program_.data_names[0].name).dump() + ": ...}");
        std::vector<std::string> names;
        for (const model::Named& named : program_.data_names)
            names.push_back(named.name);
        for (const auto& [name, value] : file.items())
            if (std::ranges::find(names, name) == names.end())
                throw BadInput(path_ + ": the model has no data " + in_quotes(name) +
                               model::did_you_mean(name, names));
        for (const model::Named& named : program_.data_names) {
            const auto entry = file.find(named.name);
            if (entry == file.end())
                throw BadInput(path_ + " has no entry " + in_quotes(named.name) + ": it needs " +
                               describe(named.value.shape));
            add(*entry, named, 0, named.name);
        }
        return std::move(data_);
    }

private:
    Json parsed(const std::string& text) const {
        std::set<std::string> names;
        const auto refuse_twice = [&](int depth, Json::parse_event_t event, const Json& value) {
            if (event == Json::parse_event_t::key && depth == 1 &&
                !names.insert(value.get<std::string>()).second)
                throw BadInput(path_ + ": the entry " + in_quotes(value.get<std::string>()) +
                               " is there twice: leave one");
            return true;
        };
        try {
            return Json::parse(text, refuse_twice);
        } catch (const Json::exception& error) {
            throw BadInput(path_ + " is no JSON: " + error.what());
        }
    }

    void add(const Json& value, const model::Named& named, std::size_t depth,
             const std::string& place) {
        const Shape& shape = named.value.shape;
        const bool fits =
            depth == shape.size()
                ? value.is_number()
                : value.is_array() && value.size() == static_cast<std::size_t>(shape[depth]);
        if (!fits)
            throw BadInput(path_ + ": found " + describe(value) + " at " + place + ": " +
                           named.name + " is " + describe(shape));
        if (depth == shape.size()) {
            data_.emplace_back(value.get<double>());
            return;
        }
        for (std::size_t i = 0; i < value.size(); ++i)
            add(value[i], named, depth + 1, place + '[' + std::to_string(i + 1) + ']');
    }

    const model::Program& program_;
    std::string path_;
    std::vector<std::complex<double>> data_;
};

} // namespace

std::vector<std::complex<double>>
read_model_data(const model::Program& program, const std::string& text, const std::string& path) {
    return Reader(program, path).read(text);
}

Json nested_lists(const Shape& shape, const std::vector<Json>& numbers, std::size_t first) {
    if (shape.empty()) return numbers[first];
    const Shape inner(shape.begin() + 1, shape.end());
    std::size_t size = 1;
    for (const int count : inner)
        size *= static_cast<std::size_t>(count);
    Json list = Json::array();
    for (std::size_t i = 0; i < static_cast<std::size_t>(shape[0]); ++i)
        list.push_back(nested_lists(inner, numbers, first + i * size));
    return list;
}

std::string model_data_file(const model::Program& program, const std::vector<double>& data) {
    const std::vector<Json> numbers(data.begin(), data.end());
    std::string text;
    std::size_t first = 0;
    for (const model::Named& named : program.data_names) {
        text += (text.empty() ? "{\n  " : ",\n  ") + Json(named.name).dump() + ": " +
                nested_lists(named.value.shape, numbers, first).dump();
        first += named.value.scalars.size();
    }
    return text + "\n}\n";
}

} // namespace plprove
