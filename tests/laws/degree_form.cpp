#include "tests/laws/degree_form.h"

#include "checker/minimal/obstruction.h"

#include <fstream>
#include <sstream>
#include <stdexcept>

namespace laws {

Product operator*(const Product& left, const Product& right) {
    Product product = left;
    for (std::size_t i = 0; i < product.size(); ++i)
        product[i] += right[i];
    return product;
}

unsigned weight(const Product& product) {
    unsigned sum = 0;
    for (std::size_t i = 0; i < product.size(); ++i)
        sum += product[i] * checker::features[i].weight();
    return sum;
}

namespace {

/// Adds the products of `chosen` with products of weight `rest` in the letters from `first` on.
void add_products(Product& chosen, std::size_t first, unsigned rest, std::vector<Product>& all) {
    if (rest == 0) {
        all.push_back(chosen);
        return;
    }
    if (first == checker::feature_count) return;
    add_products(chosen, first + 1, rest, all);
    const unsigned one = checker::features[first].weight();
    if (letter(first) != first || one > rest) return;
    ++chosen[first];
    add_products(chosen, first, rest - one, all);
    --chosen[first];
}

} // namespace

std::vector<Product> products(unsigned weight) {
    std::vector<Product> all;
    Product one{};
    add_products(one, 0, weight, all);
    return all;
}

namespace {

/// The fields of a line between commas.
std::vector<std::string> fields_of(const std::string& line) {
    std::vector<std::string> fields;
    std::istringstream stream(line);
    for (std::string field; std::getline(stream, field, ',');)
        fields.push_back(field);
    return fields;
}

} // namespace

std::vector<DegreeLine> read_exact_degrees(const std::filesystem::path& file) {
    std::ifstream stream(file);
    if (!stream) throw std::runtime_error("cannot read " + file.string() + ": name degrees.csv");
    std::vector<DegreeLine> lines;
    bool names_read = false;
    for (std::string line; std::getline(stream, line);) {
        if (line.empty() || line.starts_with('#')) continue;
        const std::vector<std::string> fields = fields_of(line);
        if (fields.size() != 5)
            throw std::runtime_error("five fields expected, write the line anew: " + line);
        const std::string &bound = fields[2], &status = fields[3];
        if (names_read && bound == "exact" && status != "claimed")
            lines.push_back({std::stoul(fields[0]), std::stol(fields[1])});
        names_read = true;
    }
    return lines;
}

namespace {

[[noreturn]] void refuse(const ClassDegree& found, const std::string& what) {
    throw std::runtime_error("class " + std::to_string(found.number) + ", " + found.notation +
                             ", has " + what + ": mend its lines in degrees.csv");
}

} // namespace

DegreeForm::DegreeForm(const std::vector<DegreeLine>& lines) {
    for (std::size_t number = 0; number < all_.representatives.size(); ++number) {
        const checker::Signature& signature = all_.representatives[number];
        if (!checker::obstruction(signature).minimal()) continue;
        const Product product = checker::constraint_class(signature);
        if (index_.emplace(product, classes_.size()).second)
            classes_.push_back({number, checker::notation(signature), 0});
    }
    for (const DegreeLine& line : lines) {
        if (line.number >= all_.representatives.size())
            throw std::runtime_error("there is no class " + std::to_string(line.number) +
                                     ": mend the line in degrees.csv");
        const checker::Signature& signature = all_.representatives[line.number];
        const auto found = index_.find(checker::constraint_class(signature));
        if (found == index_.end())
            refuse({line.number, checker::notation(signature)}, "a degree, but is not minimal");
        ClassDegree& known = classes_[found->second];
        if (known.degree != 0 && known.degree != line.degree) refuse(known, "two degrees");
        known.degree = line.degree;
    }
    for (const ClassDegree& known : classes_)
        if (known.degree == 0) refuse(known, "no exact degree");
}

std::optional<std::size_t> DegreeForm::class_of(const Product& product) const {
    const auto found = index_.find(checker::constraint_class(product));
    if (found == index_.end()) return std::nullopt;
    return found->second;
}

std::optional<std::size_t> DegreeForm::class_with(std::size_t number) const {
    return class_of(all_.representatives[number]);
}

} // namespace laws
