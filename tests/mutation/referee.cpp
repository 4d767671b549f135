#include "tests/mutation/referee.h"

#include "prover/minimal/decision.h"
#include "tests/mutation/referee_jacobian.h"

#include <algorithm>
#include <bit>

namespace referee {

using plprove::Feature;
using plprove::Features;

namespace {

/// A record as its words say it.
struct Record {
    bool minimal = false, camera_minimal = false;
    std::string number;
    std::size_t pool = 0;
    std::vector<std::size_t> rows, columns; ///< deleted, from 0
    Words stated;                           ///< rank, excesses, star
    mpz_class minor;
    std::vector<std::vector<mpz_class>> kernel;
};

void read_deleted(const Words& words, Record& record) {
    auto* list = &record.columns;
    demand(words.size() > 2 && words[0] == "delete", "a line `delete`");
    for (std::size_t i = 1; i < words.size(); ++i) {
        if (words[i] == "rows" || words[i] == "columns") {
            list = words[i] == "rows" ? &record.rows : &record.columns;
            demand(list->empty(), "each list once");
            continue;
        }
        const std::size_t number = index(words[i]);
        demand(number > 0 && (list->empty() || list->back() + 1 < number), "an ascending list");
        list->push_back(number - 1);
    }
}

Record read_record(const Text& file, std::size_t at) {
    Record record;
    demand(at < file.lines.size(), "a record");
    const Words& head = file.lines[at];
    record.minimal = head[0] == "minimal";
    record.camera_minimal = head[0] == "camera-minimal";
    demand(head.size() >= 3 && (record.minimal || record.camera_minimal || head[0] == "deficient"),
           "a record");
    record.number = head[1];
    record.pool = index(head[2]);
    if (record.minimal) {
        demand(head.size() == 4 && at + 1 <= file.lines.size(), "a minor");
        record.minor = integer(head[3]);
        return record;
    }
    demand(at + 2 < file.lines.size(), "a line `minor`");
    record.stated.assign(head.begin() + 3, head.end());
    read_deleted(file.lines[at + 1], record);
    const Words& minor = file.lines[at + 2];
    demand(minor.size() == 2 && minor[0] == "minor", "a line `minor`");
    record.minor = integer(minor[1]);
    for (at += 3; at < file.lines.size() && file.lines[at][0] == "kernel"; ++at) {
        auto& vector = record.kernel.emplace_back();
        for (std::size_t i = 1; i < file.lines[at].size(); ++i)
            vector.push_back(integer(file.lines[at][i]));
    }
    return record;
}

std::vector<std::size_t> deleted_columns(const Record& record, const Jacobian& j) {
    std::vector<std::size_t> columns = record.columns;
    if (!record.camera_minimal)
        for (std::size_t& column : columns)
            column += j.own;
    demand(columns.empty() || columns.back() < j.own + (record.camera_minimal ? 0 : j.cameras),
           "a column of J");
    demand(record.rows.empty() || record.rows.back() < j.rows.size(), "a row of J");
    return columns;
}

/// Objects unless the record's numbers hold for J; `problem` is what stands behind J.
void examine(const Record& record, const Jacobian& j, const Features& problem) {
    demand(minor_without(j, record.rows, deleted_columns(record, j)) != 0, "a nonzero minor");
    demand(minor_without(j, record.rows, deleted_columns(record, j)) == record.minor, "the minor");
    if (record.minimal) return;
    if (record.camera_minimal) {
        demand(record.rows.empty() && record.stated.empty() && record.kernel.empty(), "no more");
        return;
    }
    const plprove::Obstruction why = plprove::obstruction(problem);
    const auto deficiency = static_cast<std::size_t>(why.deficiency());
    const Words due{"rank",
                    std::to_string(11 - deficiency),
                    "excess",
                    std::to_string(why.excess[0]),
                    std::to_string(why.excess[1]),
                    std::to_string(why.excess[2]),
                    "star",
                    std::to_string(why.star)};
    demand(record.stated == due, "rank, excess and star");
    demand(deficiency > 0 && record.columns.size() == deficiency &&
               record.rows.size() == deficiency && record.kernel.size() == deficiency,
           "the deficiency");
    for (std::size_t i = 0; i < deficiency; ++i) {
        const auto& vector = record.kernel[i];
        demand(vector.size() == j.cameras, "a kernel vector");
        mpz_class divisor = 0;
        for (const mpz_class& entry : vector)
            divisor = gcd(divisor, entry);
        demand(divisor == 1, "a primitive kernel vector");
        for (std::size_t k = 0; k < deficiency; ++k)
            demand(i == k ? vector[record.columns[k]] > 0 : vector[record.columns[k]] == 0,
                   "a kernel vector of the basis");
        std::vector<mpz_class> effect(j.rows.size());
        for (std::size_t r = 0; r < j.rows.size(); ++r)
            for (std::size_t c = 0; c < j.cameras; ++c)
                effect[r] += j.rows[r][j.own + c] * vector[c];
        demand(own_rank(j, &effect) == own_rank(j, nullptr), "a motion that keeps all images");
    }
}

int pins_seen(const Feature& feature, int line, bool with_point_only) {
    int views = 0;
    for (int view = 0; view < feature.views(); ++view)
        views += feature.sees_line(view, line) && (!with_point_only || feature.sees_point(view));
    return views;
}

Feature without(const Feature& feature, int line) {
    Feature rest = feature;
    --rest.lines;
    for (plprove::Sight& sight : rest.sights) {
        std::uint32_t pins = 0;
        for (int i = 0; i < rest.lines; ++i)
            if ((sight.pins >> (i < line ? i : i + 1) & 1U) != 0) pins |= 1U << i;
        sight.pins = pins;
    }
    return rest;
}

/// Whether the table of FORMAT.md, section 7, allows the step.
bool allowed(const std::string& rule, const Feature& f, const std::optional<Feature>& result) {
    int points = 0;
    for (const plprove::Sight& sight : f.sights)
        points += sight.point;
    Feature line = f;
    line.has_point = false;
    for (plprove::Sight& sight : line.sights)
        sight.point = false;
    if (!f.has_point) {
        const int seen = pins_seen(f, 0, false);
        return !result && ((rule == "unseen-line" && seen == 0) ||
                           (rule == "free-line" && (seen == 1 || seen == 2)));
    }
    bool others = false; // a pin that is unseen or fit for a rule about pins
    for (int pin = 0; pin < f.lines; ++pin) {
        const int seen = pins_seen(f, pin, false);
        const bool all_with_point = pins_seen(f, pin, true) == seen;
        const std::string fit = seen == 0                     ? "unseen-line"
                                : seen == 1 && all_with_point ? "pin-seen-once"
                                : seen == 2 && all_with_point ? "pin-seen-twice"
                                                              : "";
        others |= !fit.empty();
        if (fit == rule && result && *result == without(f, pin)) return true;
    }
    if (rule == "unseen-point") {
        for (int pin = 0; pin < f.lines; ++pin)
            if (pins_seen(f, pin, false) == 0) return false;
        if (points > 0 || f.lines == 0) return false;
        return f.lines == 1 ? result && *result == line : !result;
    }
    if (rule == "bare-point") return !result && f.lines == 0 && points <= 1;
    if (rule == "point-on-line")
        return f.views() == 3 && points == 1 && f.lines == 1 && pins_seen(f, 0, false) == 3 &&
               result && *result == line;
    if (rule != "point-and-pin" || result) return false;
    if (f.views() == 3)
        return points == 1 && f.lines == 1 && pins_seen(f, 0, false) - pins_seen(f, 0, true) == 1;
    bool apart = false;
    for (int pin = 0; pin < f.lines; ++pin)
        apart |= pins_seen(f, pin, false) > pins_seen(f, pin, true);
    return points > 0 && apart && !others;
}

/// The problem that the steps leave; `at` is left behind them.
Features reduced(Features problem, const Text& file, std::size_t& at) {
    for (; at < file.lines.size() && file.lines[at][0] == "reduce"; ++at) {
        const Words& words = file.lines[at];
        demand(words.size() == 4, "a step");
        const std::size_t position = index(words[1]);
        demand(position >= 1 && position <= problem.size(), "a position");
        std::optional<Feature> result;
        if (words[3] != "nothing") result = plprove::parse_feature(words[3]);
        const auto place = problem.begin() + static_cast<std::ptrdiff_t>(position - 1);
        demand(allowed(words[2], *place, result), "a rule that applies");
        if (result)
            *place = *result;
        else
            problem.erase(place);
    }
    for (const Feature& feature : problem)
        demand(!plprove::reduce_once(feature), "a reduced problem");
    return problem;
}

std::string number_of(const Features& lifted) {
    const auto signature = lifted.empty() || lifted.front().views() == 2
                               ? std::nullopt
                               : plprove::signature_of(lifted);
    if (!signature) return "-";
    const auto& classes = plprove::label_classes();
    return std::to_string(plprove::class_number(classes, plprove::representative(*signature)));
}

std::vector<Placed> used(const Pool& pool, const plprove::Signature& signature) {
    std::vector<Placed> features;
    for (std::size_t i = 0; i < plprove::feature_count; ++i) {
        int missing = signature[i];
        for (const Placed& placed : pool.features)
            if (missing > 0 && placed.feature == plprove::standard_features()[i]) {
                features.push_back(placed);
                --missing;
            }
        demand(missing == 0, "enough instances");
    }
    return features;
}

/// The pool with this number, from 1, of a classification file.
Pool pool_of(const Text& file, std::size_t number) {
    for (std::size_t at = 0; at < file.lines.size(); ++at)
        if (file.lines[at] == Words{"pool", std::to_string(number)}) return read_pool(file, at, 3);
    throw Objection("a pool");
}

std::string join(const Words& words) {
    std::string text;
    for (const std::string& word : words)
        text += (text.empty() ? "" : " ") + word;
    return text;
}

void examine_problem(const Text& file) {
    demand(file.lines.size() >= 3 && join(file.lines[0]) == "plcert 2 problem" &&
               file.lines[1][0] == "problem",
           "a problem file");
    const Features problem = plprove::parse_features(join(file.lines[1]).substr(8));
    const plprove::Decision decision = plprove::decide(problem);
    std::size_t at = 2;
    const Features lifted = plprove::lifted(reduced(problem, file, at));
    demand(at < file.lines.size() && file.lines[at][0] == "verdict", "a verdict");
    const int excess = std::abs(decision.constraints - decision.camera_dimension);
    const std::string verdict(name(decision.verdict));
    demand(join(file.lines[at]) ==
               "verdict " + verdict + (excess == 0 ? "" : " " + std::to_string(excess)),
           "the verdict");
    if (excess != 0) {
        demand(at + 1 == file.lines.size(), "no evidence");
        return;
    }
    demand(at + 2 < file.lines.size() &&
               join(file.lines[at + 1]) == "modulus 2305843009213693951" &&
               join(file.lines[at + 2]) == "pool 1",
           "modulus and pool");
    at += 2;
    const Pool pool = read_pool(file, at, problem.front().views());
    const Record record = read_record(file, at);
    const bool obstructed = decision.verdict == plprove::Verdict::obstructed;
    demand(record.minimal == (verdict == "minimal") &&
               record.camera_minimal == (verdict == "camera-minimal"),
           "evidence of the verdict");
    demand(at + (record.minimal ? 1 : 3 + record.kernel.size()) == file.lines.size(), "the end");
    demand(record.number == number_of(lifted) && record.pool == 1, "the number of the class");
    const Features& posed = obstructed ? lifted : problem;
    demand(pool.features.size() == posed.size(), "the features of the problem");
    for (std::size_t i = 0; i < posed.size(); ++i)
        demand(pool.features[i].feature == posed[i], "the features of the problem");
    examine(record, jacobian(pool.features, pool.cameras), posed);
}

template <class Examination>
std::optional<std::string> objection(Examination examination) {
    try {
        examination();
    } catch (const std::exception& error) { // an Objection, a NotationError, an empty line
        return error.what();
    }
    return std::nullopt;
}

} // namespace

Text split(std::string_view file) {
    Text text;
    bool goes_on = false;
    for (std::size_t number = 1; !file.empty(); ++number) {
        std::string_view line = file.substr(0, file.find('\n'));
        file.remove_prefix(std::min(line.size() + 1, file.size()));
        if (number > 1 && line.starts_with("#")) continue;
        if (!goes_on) {
            text.lines.emplace_back();
            text.numbers.push_back(number);
        }
        Words& words = text.lines.back();
        do {
            words.emplace_back(line.substr(0, line.find(' ')));
            line.remove_prefix(std::min(words.back().size() + 1, line.size()));
        } while (!line.empty());
        goes_on = words.size() > 1 && words.back() == "\\";
        if (goes_on) words.pop_back();
    }
    return text;
}

std::size_t line_of_record(const Text& file, std::size_t class_number) {
    const std::string number = std::to_string(class_number);
    for (std::size_t i = 0; i < file.lines.size(); ++i) {
        const Words& words = file.lines[i];
        const bool head = words[0] == "minimal" || words[0] == "deficient" || words[0] == "degree";
        if (head && words.size() > 1 && words[1] == number) return file.numbers[i];
    }
    return 0;
}

std::optional<std::string> objection_to_problem(const Text& file) {
    return objection([&] { examine_problem(file); });
}

std::optional<std::string> objection_to_record(const Text& file, std::size_t line,
                                               const plprove::Signature& signature) {
    return objection([&] {
        const auto at = std::ranges::find(file.numbers, line) - file.numbers.begin();
        demand(std::cmp_less(at, file.lines.size()), "the record");
        const Record record = read_record(file, static_cast<std::size_t>(at));
        const Pool pool = pool_of(file, record.pool);
        const Features problem = plprove::problem_of(signature);
        demand(record.minimal == (plprove::obstruction(problem).deficiency() == 0), "the verdict");
        examine(record, jacobian(used(pool, signature), pool.cameras), problem);
    });
}

std::optional<std::uint64_t> true_minor(const Text& file, std::size_t line,
                                        const std::optional<plprove::Signature>& signature) {
    std::optional<std::uint64_t> minor;
    objection([&] {
        const Record record = read_record(file, line);
        const Pool all = [&] {
            if (signature) return pool_of(file, record.pool);
            const auto is_pool = [](const Words& words) { return words[0] == "pool"; };
            auto at = static_cast<std::size_t>(std::ranges::find_if(file.lines, is_pool) -
                                               file.lines.begin());
            const bool two_views = at + 2 < file.lines.size() && file.lines[at + 2][0] != "camera";
            return read_pool(file, at, two_views ? 2 : 3);
        }();
        const Jacobian j = jacobian(signature ? used(all, *signature) : all.features, all.cameras);
        minor = minor_without(j, record.rows, deleted_columns(record, j));
    });
    return minor;
}

} // namespace referee
