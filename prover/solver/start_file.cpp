// Starts as files: one JSON object, whose member `digest` is the SHA-256 digest of all others.
#include "prover/solver/start.h"
#include "prover/system/exit.h"
#include "prover/system/sha256.h"

#include <nlohmann/json.hpp>

namespace plprove {

namespace {

using Json = nlohmann::ordered_json;

constexpr int format_of_starts = 2;

Json numbers(const Complex& z) {
    return {z.real(), z.imag()};
}

template <class Range>
Json numbers(const Range& range) {
    Json result = Json::array();
    for (const auto& element : range)
        result.push_back(numbers(element));
    return result;
}

void read(const Json& json, Complex& z) {
    if (!json.is_array() || json.size() != 2) throw std::invalid_argument("a complex number");
    z = {json[0].get<double>(), json[1].get<double>()};
    if (!std::isfinite(z.real()) || !std::isfinite(z.imag()))
        throw std::invalid_argument("a finite number");
}

template <class T, std::size_t N>
void read(const Json& json, std::array<T, N>& array) {
    if (!json.is_array() || json.size() != N)
        throw std::invalid_argument("a list of " + std::to_string(N));
    for (std::size_t i = 0; i < N; ++i)
        read(json[i], array[i]);
}

template <class T>
void read(const Json& json, std::vector<T>& list) {
    if (!json.is_array()) throw std::invalid_argument("a list");
    for (const Json& element : json)
        read(element, list.emplace_back());
}

/// Everything but the digest.
Json content(const Start& start) {
    return {{"pointline start", format_of_starts},
            {"class", start.number},
            {"rotation chart", numbers(start.chart.rotation)},
            {"centre chart", numbers(start.chart.centre)},
            {"constants", numbers(start.constants)},
            {"images", numbers(start.images)},
            {"solutions", numbers(start.solutions)}};
}

std::string digest_of(const Json& content) {
    return sha256(content.dump());
}

Start start_of(const Json& json) {
    Start start;
    start.number = json.at("class").get<std::size_t>();
    read(json.at("rotation chart"), start.chart.rotation);
    read(json.at("centre chart"), start.chart.centre);
    read(json.at("constants"), start.constants);
    read(json.at("images"), start.images);
    read(json.at("solutions"), start.solutions);
    if (start.number >= label_classes().size()) throw std::invalid_argument("a label class");
    const CameraSystem system = camera_system(label_classes()[start.number]);
    if (std::ssize(start.constants) != system.constants)
        throw std::invalid_argument("the constants of the class");
    if (start.images.size() != system.free.size())
        throw std::invalid_argument("the images of the class");
    return start;
}

} // namespace

std::string write_start(const Start& start) {
    Json json = content(start);
    json["digest"] = digest_of(json);
    return json.dump() + '\n';
}

Start read_start(const std::string& text, const std::string& name) {
    const auto refuse = [&](const std::string& why) -> Start {
        throw BadInput(name + ": " + why + ": make it again with `plprove start`");
    };
    Json json = Json::parse(text, nullptr, false);
    if (!json.is_object() || !json.contains("pointline start"))
        return refuse("this is no start, or it is damaged");
    if (json["pointline start"] != format_of_starts)
        return refuse("this start is of another version");
    const Json digest = json.value("digest", Json());
    json.erase("digest");
    if (digest != digest_of(json)) return refuse("this start is damaged: its digest differs");
    try {
        const Start start = start_of(json);
        return write_start(start) == text ? start : refuse("this start is damaged");
    } catch (const std::invalid_argument& error) {
        return refuse(std::string("this start is damaged: expected ") + error.what());
    } catch (const Json::exception& error) {
        return refuse(std::string("this start is damaged: ") + error.what());
    }
}

} // namespace plprove
