// How long a sweep over all classes takes on 1 to 4,096 ranks, by simulation.
//
//     simulate_ranks RUNS...
//
// RUNS are files with a JSON object a line that has the number of a class, its degree, and the
// seconds that one core took: runs.jsonl of a sweep. A class that none of them has is taken to need
// as long per solution as the one that they have whose degree is nearest. The simulated sweep does
// what plprove degrees does under mpirun: rank 0 gives the classes out by their degrees on file,
// largest first, and a rank that is done waits for the next message. The program also says how
// smallest first would do.
#include "prover/catalogue/degrees.h"
#include "prover/degree_sweep/classes.h"

#include <algorithm>
#include <fstream>
#include <functional>
#include <iomanip>
#include <iostream>
#include <iterator>
#include <map>
#include <nlohmann/json.hpp>
#include <numeric>
#include <queue>
#include <stdexcept>
#include <vector>

namespace {

using namespace plprove;

/// Between the end of a class and the start of the next one: two ranks look for messages every
/// millisecond.
constexpr double seconds_of_messages = 0.001;

struct Class {
    int degree = 0;
    double seconds = 0;
};

/// The classes that were measured, by number, and the seconds a solution of each, by degree.
struct Measurement {
    std::map<std::size_t, Class> classes;
    std::multimap<int, double> rates;

    /// As long per solution as the class whose degree is nearest.
    double estimate(int degree) const {
        auto above = rates.lower_bound(degree);
        if (above == rates.end()) above = std::prev(above);
        const auto below = above == rates.begin() ? above : std::prev(above);
        const bool above_is_nearer = above->first - degree < degree - below->first;
        return degree * (above_is_nearer ? above : below)->second;
    }
};

void add(const char* path, Measurement& measurement) {
    std::ifstream file(path);
    if (!file) throw std::runtime_error(std::string("cannot read ") + path);
    for (std::string line; std::getline(file, line);) {
        const nlohmann::json run = nlohmann::json::parse(line);
        const Class one{run.at("degree").get<int>(), run.at("seconds").get<double>()};
        if (one.degree == 0) continue;
        if (measurement.classes.emplace(run.at("number").get<std::size_t>(), one).second)
            measurement.rates.emplace(one.degree, one.seconds / one.degree);
    }
}

/// All classes, the largest degree first.
std::vector<Class> classes_with(const Measurement& measurement) {
    std::vector<Class> classes;
    for (const std::size_t number : minimal_constraint_classes()) {
        Class one;
        one.degree = degree_on_file(number).value();
        const auto measured = measurement.classes.find(number);
        one.seconds = measured == measurement.classes.end() ? measurement.estimate(one.degree)
                                                            : measured->second.seconds;
        classes.push_back(one);
    }
    std::ranges::sort(classes, std::greater<>(), &Class::degree);
    return classes;
}

/// When the last rank is done, if each takes the next class as soon as it is free.
double time_of_sweep(const std::vector<Class>& classes, std::size_t ranks) {
    std::priority_queue<double, std::vector<double>, std::greater<>> free_at;
    for (std::size_t i = 0; i < ranks; ++i)
        free_at.push(0);
    double end = 0;
    for (const Class& one : classes) {
        const double done = free_at.top() + seconds_of_messages + one.seconds;
        free_at.pop();
        free_at.push(done);
        end = std::max(end, done);
    }
    return end;
}

void print_table(std::vector<Class> classes) {
    const double work = std::transform_reduce(classes.begin(), classes.end(), 0.0, std::plus<>(),
                                              [](const Class& one) { return one.seconds; });
    const double longest = std::ranges::max_element(classes, {}, &Class::seconds)->seconds;
    std::cout << std::fixed << std::setprecision(1) << classes.size() << " classes, " << work / 3600
              << " core hours; the longest takes " << longest << " s, which is the limit from "
              << std::setprecision(0) << work / longest << " ranks on\n\n"
              << "   ranks   seconds  efficiency   smallest first: seconds  efficiency\n";
    for (std::size_t ranks = 1; ranks <= 4096; ranks *= 2) {
        const double largest_first = time_of_sweep(classes, ranks);
        std::ranges::reverse(classes);
        const double smallest_first = time_of_sweep(classes, ranks);
        std::ranges::reverse(classes);
        const auto efficiency = [&](double seconds) {
            return work / seconds / static_cast<double>(ranks);
        };
        std::cout << std::setw(8) << ranks << std::setprecision(1) << std::setw(10) << largest_first
                  << std::setprecision(3) << std::setw(12) << efficiency(largest_first)
                  << std::setprecision(1) << std::setw(26) << smallest_first << std::setprecision(3)
                  << std::setw(12) << efficiency(smallest_first) << '\n';
    }
}

} // namespace

int main(int argc, char** argv) {
    try {
        Measurement measurement;
        for (int i = 1; i < argc; ++i)
            add(argv[i], measurement);
        if (measurement.classes.empty())
            throw std::runtime_error("usage: simulate_ranks RUNS..., the runs.jsonl of sweeps");
        std::cout << measurement.classes.size() << " classes measured\n";
        print_table(classes_with(measurement));
        return 0;
    } catch (const std::exception& error) {
        std::cerr << "simulate_ranks: " << error.what() << '\n';
        return 1;
    }
}
