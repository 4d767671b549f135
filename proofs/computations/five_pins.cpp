// The numbers of Theorem N (proofs/five_pins.md) but for 2*Pabcdef: intersection numbers. From the
// folder that holds proofs/:
//
//   c++ -std=c++20 -O2 -I. proofs/computations/five_pins.cpp -o five_pins
//
// Each line of the output is a problem and its number. Exit status 1 if one is not as in the
// theorem.
#include "proofs/computations/report.h"
#include "proofs/computations/star_cameras.h"

#include <string>
#include <string_view>

namespace {

struct Case {
    std::string_view problem; // `Pa` stands for `Pa/Pa/Pa`
    proofs::star::ManyPins features;
    std::int64_t degree;
};

const std::vector<Case>& cases() {
    static const std::vector<Case> all{
        {"Pabcdefg + 4*a", {7, {}, 4}, 6},         {"Pabcde + 5*a", {5, {}, 5}, 23},
        {"Pabcdef + Pabcd + a", {6, {4}, 1}, 6},   {"Pabcdef + Pab + 2*a", {6, {2}, 2}, 4},
        {"Pabcdef + P + 3*a", {6, {0}, 3}, 2},     {"2*Pabcde + a", {5, {5}, 1}, 16},
        {"Pabcde + Pabc + 2*a", {5, {3}, 2}, 12},  {"Pabcde + Pa + 3*a", {5, {1}, 3}, 9},
        {"Pabcde + Pabcd + P", {5, {4, 0}, 0}, 4}, {"Pabcde + Pabc + Pa", {5, {3, 1}, 0}, 4},
        {"Pabcde + 2*Pab", {5, {2, 2}, 0}, 4},     {"Pabcde + Pab + P + a", {5, {2, 0}, 1}, 2},
        {"Pabcde + 2*Pa + a", {5, {1, 1}, 1}, 2},  {"Pabcde + 2*P + 2*a", {5, {0, 0}, 2}, 2},
    };
    return all;
}

void check(proofs::Report& report, const std::string& what, const Case& expected) {
    const std::int64_t number = proofs::star::zeros(expected.features);
    report(number == expected.degree,
           what + std::string(expected.problem) + ": " + std::to_string(number));
}

} // namespace

int main() {
    proofs::Report report;
    for (const Case& one : cases())
        check(report, "Theorem N, ", one);
    // No part of the proof: six of these ten zeros are no solutions (proofs/seven_lines.md).
    check(report, "integral for ", {"2*Pabcdef", {6, {6}, 0}, 10});
    return report.status();
}
