// What section 9 of proofs/calibrated_moduli.md says by evidence: integrals over a blow-up of M,
// compared with the degrees on file.
#include "proofs/computations/blown_up_moduli.h"

#include "checker/problem/classes.h"
#include "tests/checker/bounds/degrees_on_file.h"

#include <doctest/doctest.h>
#include <map>
#include <sstream>
#include <string>

using namespace proofs::blown_up;

namespace {

/// A summand of a notation without its number, such as `a/Pa/Pa`.
Feature parse(const std::string& text) {
    Feature feature;
    std::map<char, unsigned> lines;
    std::istringstream views(text);
    unsigned bit = 1;
    for (std::string seen; std::getline(views, seen, '/'); bit <<= 1)
        for (const char name : seen) {
            if (name == 'P') feature.point |= bit;
            if (name >= 'a' && name <= 'z') lines[name] |= bit;
        }
    feature.has_point = feature.point != 0;
    for (const auto& [name, seen_by] : lines)
        feature.lines.push_back(seen_by);
    return feature;
}

std::vector<std::string> features_of(const std::string& notation) {
    std::vector<std::string> features;
    std::istringstream words(notation);
    for (std::string word; words >> word;) {
        if (word == "+") continue;
        const std::size_t star = word.find('*');
        const bool many = star != std::string::npos;
        features.insert(features.end(), many ? std::stoul(word) : 1,
                        many ? word.substr(star + 1) : word);
    }
    return features;
}

/// The integral of the product of the classes.
class Integrals {
public:
    std::int64_t of(const std::string& notation) {
        std::vector<const std::vector<Residue>*> factors;
        for (const std::string& feature : features_of(notation))
            factors.push_back(&values_of(feature));
        Residue sum;
        for (std::size_t i = 0; i < points_.size(); ++i) {
            Residue product = points_[i].weight;
            for (const auto* factor : factors)
                product = product * (*factor)[i];
            sum = sum + product;
        }
        const auto value = static_cast<std::int64_t>(sum.value);
        const auto q = static_cast<std::int64_t>(checker::modulus);
        return value > q / 2 ? value - q : value;
    }

private:
    const std::vector<Residue>& values_of(const std::string& feature) {
        std::vector<Residue>& values = values_[feature];
        if (values.empty())
            for (const FixedPoint& point : points_)
                values.push_back(class_at(point, parse(feature)));
        return values;
    }

    std::vector<FixedPoint> points_ = fixed_points();
    std::map<std::string, std::vector<Residue>> values_{};
};

} // namespace

TEST_CASE("evidence: on the blow-up of M the integral is the degree of all problems with complete "
          "visibility but one, of which a point has five pins") {
    Integrals integrals;
    CHECK(integrals.of("Pabcd/Pabcd/Pabcd + Pa/Pa/Pa") == 240);
    CHECK(integrals.of("Pabcd/Pabcd/Pabcd + 2*a/a/a") == 480);
    CHECK(integrals.of("Pabc/Pabc/Pabc + Pab/Pab/Pab") == 480);
    CHECK(integrals.of("Pabc/Pabc/Pabc + P/P/P + a/a/a") == 328);
    CHECK(integrals.of("Pab/Pab/Pab + Pa/Pa/Pa + a/a/a") == 432);
    CHECK(integrals.of("Pab/Pab/Pab + 2*P/P/P") == 224);
    CHECK(integrals.of("Pab/Pab/Pab + 3*a/a/a") == 552);
    CHECK(integrals.of("2*Pa/Pa/Pa + P/P/P") == 312);
    CHECK(integrals.of("Pa/Pa/Pa + P/P/P + 2*a/a/a") == 264);
    CHECK(integrals.of("3*P/P/P + a/a/a") == 216);
    CHECK(integrals.of("P/P/P + 4*a/a/a") == 360);
    CHECK(integrals.of("Pabcde/Pabcde/Pabcde + P/P/P") != 64);
}

TEST_CASE("evidence: it is the degree on file of 3,050 constraint classes") {
    Integrals integrals;
    std::size_t equal = 0, greater = 0;
    for (const auto& [signature, degree] : degrees_on_file()) {
        const std::int64_t integral = integrals.of(checker::notation(signature));
        equal += integral == static_cast<std::int64_t>(degree);
        greater += integral > static_cast<std::int64_t>(degree);
    }
    CHECK(equal == 3050);
    CHECK(greater == 6079);
}

TEST_CASE("evidence: integrals of products of too small degree are zero") {
    Integrals integrals;
    for (const std::string problem : {"a/a/a", "-/P/P", "P/P/P + a/Pa/Pa", "2*a/a/a + 3*P/a/a"})
        CHECK(integrals.of(problem) == 0);
}
