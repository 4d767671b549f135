#include "prover/solver/exact_json.h"

#include <stdexcept>
#include <vector>

namespace plprove {

namespace {

using Json = nlohmann::json;

/// Builds the value from what the parser meets.
class Builder : public nlohmann::json_sax<Json> {
public:
    Json take() { return std::move(root_); }
    const std::string& error() const { return error_; }

    bool null() override { return add(nullptr); }
    bool boolean(bool value) override { return add(value); }
    bool number_integer(number_integer_t value) override { return add(std::to_string(value)); }
    bool number_unsigned(number_unsigned_t value) override { return add(std::to_string(value)); }
    bool number_float(number_float_t, const string_t& text) override { return add(text); }
    bool string(string_t& value) override { return add(value); }
    bool binary(binary_t&) override { return false; }
    bool start_object(std::size_t) override { return open(Json::object()); }
    bool start_array(std::size_t) override { return open(Json::array()); }
    bool end_object() override { return close(); }
    bool end_array() override { return close(); }

    bool key(string_t& name) override {
        if (open_.back()->contains(name)) {
            error_ = "two members are called \"" + name + "\"";
            return false;
        }
        key_ = name;
        return true;
    }

    bool parse_error(std::size_t, const std::string&,
                     const nlohmann::detail::exception& error) override {
        error_ = error.what();
        return false;
    }

private:
    Json* put(Json value) {
        if (open_.empty()) return &(root_ = std::move(value));
        Json& parent = *open_.back();
        if (parent.is_object()) return &(parent[key_] = std::move(value));
        parent.push_back(std::move(value));
        return &parent.back();
    }

    bool add(Json value) {
        put(std::move(value));
        return true;
    }

    bool open(Json value) {
        constexpr std::size_t deepest = 20; // more than images need; printing recurses
        if (open_.size() == deepest) {
            error_ = "lists and objects stand more than 20 deep in each other";
            return false;
        }
        open_.push_back(put(std::move(value)));
        return true;
    }

    bool close() {
        open_.pop_back();
        return true;
    }

    Json root_;
    std::vector<Json*> open_;
    std::string key_;
    std::string error_;
};

/// The parser's message without its number: `parse error at line 1, column 2: syntax error ...`.
std::string in_short(const std::string& message) {
    const std::size_t number = message.find("] ");
    return number == std::string::npos ? message : message.substr(number + 2);
}

} // namespace

Json parse_exact_json(const std::string& text) {
    Builder builder;
    if (Json::sax_parse(text, &builder)) return builder.take();
    throw std::invalid_argument(in_short(builder.error()));
}

} // namespace plprove
