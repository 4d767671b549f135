// CSV and JSON.
#include "prover/catalogue/columns.h"
#include "prover/catalogue/export.h"

#include <nlohmann/json.hpp>

namespace plprove {

namespace {

/// A field of RFC 4180: in quotes where it must be.
std::string csv_field(const Value& value) {
    if (const int* number = std::get_if<int>(&value)) return std::to_string(*number);
    const std::string* field = std::get_if<std::string>(&value);
    if (field == nullptr) return {};
    if (field->find_first_of(",\"\n\r") == std::string::npos) return *field;
    std::string quoted = "\"";
    for (const char c : *field)
        quoted += c == '"' ? std::string("\"\"") : std::string(1, c);
    return quoted + '"';
}

std::string json_text(const std::string& text) {
    return nlohmann::json(text).dump();
}

std::string json_value(const Value& value, ColumnKind kind) {
    if (const int* number = std::get_if<int>(&value)) {
        if (kind == ColumnKind::flag) return *number != 0 ? "true" : "false";
        return std::to_string(*number);
    }
    if (const std::string* text = std::get_if<std::string>(&value)) return json_text(*text);
    return "null";
}

void append_json_object(std::string& text, const Entry& entry) {
    char separator = '{';
    for (const Column& column : columns()) {
        ((text += separator) += '"') += column.name;
        (text += "\":") += json_value(column.value(entry), column.kind);
        separator = ',';
    }
    text += '}';
}

} // namespace

std::string to_csv(std::span<const Entry> entries) {
    std::string text;
    for (const Column& column : columns())
        (text += column.name) += ',';
    text.back() = '\n';
    for (const Entry& entry : entries) {
        for (const Column& column : columns())
            (text += csv_field(column.value(entry))) += ',';
        text.back() = '\n';
    }
    return text;
}

std::string to_json(std::span<const Entry> entries) {
    nlohmann::ordered_json about;
    for (const Remark& remark : remarks())
        about[remark.topic] = remark.text;
    for (const Column& column : columns())
        about["columns"][column.name] = column.meaning;
    std::string text = "{\"about\":" + about.dump() + ",\n\"classes\":[";
    const char* separator = "\n";
    for (const Entry& entry : entries) {
        text += separator;
        append_json_object(text, entry);
        separator = ",\n";
    }
    return text + "\n]}\n";
}

} // namespace plprove
