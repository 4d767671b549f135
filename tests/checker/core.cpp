// The parts of the checker against laws, known counts and second methods.
#include "checker/jacobian.h"
#include "checker/report.h"

#include <doctest/doctest.h>

#include <numeric>
#include <random>
#include <set>

using namespace checker;

namespace {

const Classification& classes() {
    static const Classification all = classify();
    return all;
}

Signature image(const Signature& signature, const Map& map) {
    Signature result{};
    for (std::size_t i = 0; i < feature_count; ++i)
        result[i] = signature[map[i]];
    return result;
}

std::size_t index(std::string_view notation) {
    std::size_t i = 0;
    while (features.at(i).notation != notation)
        ++i;
    return i;
}

/// Reproducible integers from -bound to bound.
struct Random {
    std::mt19937_64 engine{20};
    std::int64_t operator()(std::int64_t bound) {
        return std::uniform_int_distribution<std::int64_t>(-bound, bound)(engine);
    }
};

/// The determinant over the integers, by Bareiss's method.
mpz_class exact_determinant(Rows m) {
    mpz_class sign = 1, previous = 1;
    for (std::size_t c = 0; c < m.size(); ++c) {
        std::size_t pivot = c;
        while (pivot < m.size() && m[pivot][c] == 0)
            ++pivot;
        if (pivot == m.size()) return 0;
        if (pivot != c) sign = -sign;
        std::swap(m[c], m[pivot]);
        for (std::size_t r = c + 1; r < m.size(); ++r)
            for (std::size_t k = m.size(); k-- > c;)
                m[r][k] = (m[c][c] * m[r][k] - m[r][c] * m[c][k]) / previous;
        previous = m[c][c];
    }
    return sign * previous;
}

std::uint64_t modulo(const mpz_class& x) {
    return mpz_fdiv_ui(x.get_mpz_t(), modulus);
}

/// A random point of the domain: coordinates of features and of cameras 2 and 3.
Numbers random_vectors(const Feature& feature, Random& random) {
    Numbers numbers;
    for (std::size_t i = 0; i < 3 * (feature.pins + 1); ++i)
        numbers.push_back(random(9999));
    for (std::size_t i = 5; i < numbers.size(); i += 3)
        if (numbers[i] == 0) numbers[i] = 1;
    return numbers;
}

const Numbers cameras{1, 2, -1, 3, 5, -2, 4, 2, -3, 1, 1, -4, 7, 3};

} // namespace

TEST_CASE("the known numbers of signatures and classes") {
    CHECK(classes().signatures == 845161);
    CHECK(classes().representatives.size() == 143494);
    const std::set<std::size_t> swap_classes(classes().swap_class.begin(),
                                             classes().swap_class.end());
    CHECK(swap_classes.size() == 76446);
    for (std::size_t n = 0; n < classes().swap_class.size(); ++n) {
        const std::size_t first = classes().swap_class[n];
        REQUIRE(first <= n);
        REQUIRE(classes().swap_class[first] == first);
    }
    CHECK(notation(classes().representatives[2394]) == "2*Pa/Pa/Pa + P/P/P");
    CHECK(notation(classes().representatives[6722]) == "3*P/P/P + a/a/a");
}

TEST_CASE(
    "representatives decrease, are balanced, and their orbits make up all balanced signatures") {
    std::size_t signatures = 0;
    for (std::size_t n = 0; n < classes().representatives.size(); ++n) {
        const Signature& s = classes().representatives[n];
        if (n > 0) REQUIRE(s < classes().representatives[n - 1]);
        unsigned weight = 0;
        for (std::size_t i = 0; i < feature_count; ++i)
            weight += s[i] * features[i].weight();
        REQUIRE(weight == 11);
        std::set<Signature> orbit;
        for (const Map& map : relabelings)
            orbit.insert(image(s, map));
        REQUIRE(6 % orbit.size() == 0);
        REQUIRE(*orbit.rbegin() == s);
        signatures += orbit.size();
    }
    CHECK(signatures == classes().signatures);
}

TEST_CASE("weights, relabelings and swaps are those of the paper's table") {
    const std::array<unsigned, feature_count> weights{10, 9, 8, 7, 6, 5, 4, 3, 3, 3, 3, 2, 2, 2,
                                                      2,  2, 2, 2, 1, 1, 1, 1, 1, 1, 1, 1, 1};
    for (std::size_t i = 0; i < feature_count; ++i)
        CHECK(features[i].weight() == weights[i]);

    Map expected{};
    std::iota(expected.begin(), expected.end(), 0U);
    for (const std::size_t i : {12U, 14U, 16U})
        std::swap(expected[i], expected[i + 1]);
    CHECK(swaps == expected);

    const Map rotation{0,  1,  2,  3,  4,  5,  6,  7,  10, 8,  9,  11, 16, 17,
                       13, 12, 15, 14, 20, 18, 19, 23, 21, 22, 26, 24, 25};
    const Map reflection{0,  1,  2,  3,  4,  5,  6,  7,  8,  10, 9,  11, 13, 12,
                         16, 17, 14, 15, 18, 20, 19, 21, 23, 22, 24, 26, 25};
    CHECK(std::count(relabelings.begin(), relabelings.end(), rotation) == 1);
    CHECK(std::count(relabelings.begin(), relabelings.end(), reflection) == 1);
    CHECK(std::set<Map>(relabelings.begin(), relabelings.end()).size() == 6);
    for (const Map& map : relabelings) // swaps commute with relabelings
        for (std::size_t i = 0; i < feature_count; ++i)
            CHECK(map[swaps[i]] == swaps[map[i]]);
}

TEST_CASE("obstructions: known counts, and the same for all of an orbit and under swaps") {
    std::size_t obstructed = 0, by_excess = 0;
    for (const Signature& s : classes().representatives) {
        const Obstruction found = obstruction(s);
        obstructed += !found.minimal();
        by_excess += found.epipolar() > 0;
        for (const Map& map : relabelings) {
            const Obstruction other = obstruction(image(s, map));
            REQUIRE(other.epipolar() == found.epipolar());
            REQUIRE(other.star == found.star);
        }
        REQUIRE(obstruction(image(s, swaps)).deficiency() == found.deficiency());
    }
    CHECK(obstructed == 2878);
    CHECK(by_excess == 2871);
}

TEST_CASE("what a star obstructs") {
    Signature s{};
    s[index("Pabcdef/Pabcdef/Pabcdef")] = 1;
    s[index("a/a/a")] = 1;
    CHECK(obstruction(s).star == 1);
    s[index("a/a/a")] = 0;
    s[index("a/P/Pa")] = 1;
    CHECK(obstruction(s).star == 0);
    Signature unseen{};
    unseen[index("Pabcde/Pabcde/Pabcde")] = 1;
    unseen[index("-/P/P")] = 3;
    CHECK(obstruction(unseen).star == 1); // view 1 sees nothing but the star
    unseen[index("-/P/P")] = 2;
    unseen[index("P/-/P")] = 1;
    CHECK(obstruction(unseen).star == 0);
}

TEST_CASE("residues obey the laws of a field, and agree with GMP") {
    Random random;
    std::vector<std::uint64_t> values{0, 1, 2, modulus - 1, modulus - 2, std::uint64_t{1} << 60};
    for (int i = 0; i < 1000; ++i)
        values.push_back(random.engine() % modulus);
    for (const std::uint64_t x : values) {
        const std::uint64_t y = values[random.engine() % values.size()];
        const mpz_class product =
            mpz_class(static_cast<unsigned long>(x)) * mpz_class(static_cast<unsigned long>(y));
        CHECK((Residue{x} * Residue{y}).value == modulo(product));
        CHECK((-Residue{x}).value == modulo(-mpz_class(static_cast<unsigned long>(x))));
        if (x != 0) CHECK(Residue{x} * Residue{x}.inverse() == Residue{1});
    }
    const Wide most = Wide{modulus - 1} * (modulus - 1) * 2; // what an elimination can ask for
    CHECK(Residue::of(most).value == 2);
    CHECK(Residue::of(Wide{modulus}).value == 0);
    CHECK(Residue::of((Wide{1} << 123) - 1).value == modulo((mpz_class(1) << 123) - 1));
}

TEST_CASE("determinants agree with exact ones") {
    Random random;
    for (int round = 0; round < 50; ++round) {
        Rows exact(11, std::vector<mpz_class>(11));
        std::array<Row, 11> m{};
        for (std::size_t r = 0; r < 11; ++r) {
            for (std::size_t c = 0; c < 11; ++c) {
                exact[r][c] = round % 2 == 0 ? random(1'000'000'000) : random(1);
                m[r][c] = {modulo(exact[r][c])};
            }
        }
        CHECK(determinant(m).value == modulo(exact_determinant(exact)));
        std::array<Row, 11> swapped = m;
        std::swap(swapped[3], swapped[8]);
        CHECK(determinant(swapped) == -determinant(m));
        m[7] = m[2];
        CHECK(determinant(m) == Residue{});
    }
}

TEST_CASE("rows of the Jacobian are the derivatives of the incidences") {
    // To first order, over the dual numbers: a motion of feature and cameras changes l.x or l.e by
    // what the row says, where l is fixed.
    struct Dual {
        mpz_class value = 0, change = 0;
        Dual operator+(const Dual& b) const { return {value + b.value, change + b.change}; }
        Dual operator*(const Dual& b) const {
            return {value * b.value, value * b.change + change * b.value};
        }
    };
    using Dual3 = std::array<Dual, 3>;
    Random random;
    for (std::size_t i = 0; i < feature_count; ++i) {
        const Feature& feature = features[i];
        const Numbers vectors = random_vectors(feature, random);
        const Rows rows = jacobian_rows(feature, vectors, cameras);
        REQUIRE(rows.size() == feature.equations);
        std::vector<mpz_class> motion(feature.unknowns() + 11);
        for (mpz_class& x : motion)
            x = random(9);

        const auto moving = [&](std::size_t k, std::size_t column, std::size_t columns) {
            Dual3 v;
            for (std::size_t j = 0; j < 3; ++j)
                v[j] = {vectors[3 * k + j], j < columns ? motion[column + j] : mpz_class(0)};
            return v;
        };
        std::size_t row = 0;
        for (std::size_t view = 0; view < 3; ++view) {
            std::array<Dual3, 3> rotated; // (1 + [w]) R, as a matrix of dual numbers
            Dual3 translation;
            const Numbers identity{1, 0, 0, 0, 0, 0, 0};
            const auto camera =
                view == 0 ? std::span<const std::int64_t>(identity)
                          : std::span<const std::int64_t>(cameras).subspan(7 * (view - 1), 7);
            const Rotation fixed = rotation(camera);
            const std::size_t first = feature.unknowns() + (view == 2 ? 5 : 0);
            Vector w{0, 0, 0};
            if (view > 0) w = {motion[first], motion[first + 1], motion[first + 2]};
            for (std::size_t c = 0; c < 3; ++c) {
                const Vector turned = cross(w, {fixed[0][c], fixed[1][c], fixed[2][c]});
                for (std::size_t r = 0; r < 3; ++r)
                    rotated[r][c] = {fixed[r][c], turned[r]};
            }
            for (std::size_t r = 0; r < 3; ++r)
                translation[r] = {camera[4 + r], 0};
            if (view == 1) translation[1].change = motion[first + 3];
            if (view == 1) translation[2].change = motion[first + 4];
            for (std::size_t r = 0; view == 2 && r < 3; ++r)
                translation[r].change = motion[first + 3 + r];

            const auto times = [&](const Dual3& v, std::size_t r) {
                return rotated[r][0] * v[0] + rotated[r][1] * v[1] + rotated[r][2] * v[2];
            };
            const Dual3 point = moving(0, 0, feature.point_unknowns());
            const Dual3 x{times(point, 0) + translation[0], times(point, 1) + translation[1],
                          times(point, 2) + translation[2]};
            const auto check = [&](const Vector& l, const Dual3& v) {
                mpz_class by_row = 0, by_change = 0;
                for (std::size_t k = 0; k < motion.size(); ++k)
                    by_row += rows[row][k] * motion[k];
                for (std::size_t k = 0; k < 3; ++k)
                    by_change += l[k] * v[k].change;
                CHECK(by_row == by_change);
                mpz_class incidence = 0;
                for (std::size_t k = 0; k < 3; ++k)
                    incidence += l[k] * v[k].value;
                CHECK(incidence == 0);
                ++row;
            };
            const bool sees_point = feature.point >> view & 1;
            if (sees_point) check({0, x[2].value, -x[1].value}, x);
            if (sees_point) check({-x[2].value, 0, x[0].value}, x);
            for (std::size_t pin = 0; pin < feature.pins; ++pin) {
                if (!(feature.pin[pin] >> view & 1)) continue;
                const Dual3 d = moving(pin + 1, feature.point_unknowns() + 2 * pin, 2);
                const Dual3 e{times(d, 0), times(d, 1), times(d, 2)};
                const Vector l = cross({x[0].value, x[1].value, x[2].value},
                                       {e[0].value, e[1].value, e[2].value});
                if (!sees_point) check(l, x);
                check(l, e);
            }
        }
        CHECK(row == rows.size());
    }
}

TEST_CASE(
    "minors agree with the exact determinant of the whole of J, rows and columns deleted or not") {
    Random random;
    for (std::size_t n = 100; n < classes().representatives.size(); n += 7001) {
        const Signature& signature = classes().representatives[n];
        std::vector<Block> blocks;
        for (std::size_t i = 0; i < feature_count; ++i)
            for (unsigned k = 0; k < signature[i]; ++k)
                blocks.push_back(eliminate(
                    features[i].unknowns(),
                    jacobian_rows(features[i], random_vectors(features[i], random), cameras)));
        std::vector<const Block*> pointers;
        std::size_t own = 0, first = 0;
        for (const Block& block : blocks) {
            pointers.push_back(&block);
            own += block.unknowns;
        }
        Rows whole;
        for (const Block& block : blocks) {
            for (const auto& row : block.rows) {
                auto& full = whole.emplace_back(own + 11);
                for (std::size_t c = 0; c < row.size(); ++c)
                    full[c < block.unknowns ? first + c : own + c - block.unknowns] = row[c];
            }
            first += block.unknowns;
        }
        REQUIRE(whole.size() == own + 11);
        CHECK(minor(pointers, {}, {}).value == modulo(exact_determinant(whole)));

        const auto size = static_cast<std::int64_t>(whole.size());
        const auto shift = static_cast<std::int64_t>(n % 3);
        const Numbers rows{1 + shift, size / 2, size - shift}, columns{2, 3, 9};
        Rows rest;
        for (std::size_t r = 0; r < whole.size(); ++r) {
            if (std::binary_search(rows.begin(), rows.end(), static_cast<std::int64_t>(r + 1)))
                continue;
            auto& entries = rest.emplace_back();
            for (std::size_t c = 0; c < whole.size(); ++c)
                if (c < own || !std::binary_search(columns.begin(), columns.end(),
                                                   static_cast<std::int64_t>(c - own + 1)))
                    entries.push_back(whole[r][c]);
        }
        CHECK(minor(pointers, rows, columns).value == modulo(exact_determinant(rest)));
    }
}

TEST_CASE("the requirements of section 2") {
    const Feature& feature = features[index("P/Pa/a")];
    const auto reason = [&](const Numbers& vectors, const Numbers& all) -> std::string {
        try {
            jacobian_rows(feature, vectors, all);
            return "";
        } catch (const Refused& refused) {
            return refused.reason;
        }
    };
    const Numbers vectors{1, 2, 3, 4, 5, 6};
    CHECK(reason(vectors, cameras) == "");
    Numbers other = cameras;
    other[4] = 0;
    CHECK(reason(vectors, other) == "the translation of camera 2 begins with 0");
    other = cameras;
    std::fill_n(other.begin() + 7, 4, 0);
    CHECK(reason(vectors, other) == "a quaternion is zero");
    CHECK(reason({1, 2, 0, 4, 5, 6}, cameras) == "an image of the point has third coordinate 0");
    CHECK(reason({1, 2, 3, 4, 5, 0}, cameras) == "a direction has third coordinate 0");
    const Numbers plain{1, 0, 0, 0, 1, 0, 0, 1, 0, 0, 0, 2, 0, 0};
    CHECK(reason({1, 2, 3, 3, 2, 3}, plain) ==
          "the image of a line is zero"); // seen end on by view 3
}

TEST_CASE("a file is read to the letter") {
    const auto complaint = [](const std::string& bytes) {
        const FileReport report = replay(classes(), "file", bytes);
        REQUIRE(!report.conforms);
        REQUIRE(report.complaints.size() == 1);
        CHECK(report.verdicts.empty());
        return say(report.complaints[0].line, ": ", report.complaints[0].reason);
    };
    const std::string head =
        "plcert 1 classification\n# comment   with spaces\nmodulus 2305843009213693951\n";
    const std::string pool =
        "pool 1\ncamera 2 quaternion 1 0 0 1 translation 1 2 3\n"
        "camera 3 quaternion 1 1 0 1 translation 3 2 1\nfeature P/P/P point 1 2 3\n";
    const FileReport good = replay(classes(), "file", head + pool);
    CHECK(good.conforms);
    CHECK(good.refused == 143494);
    CHECK(good.complaints.size() == 20);
    CHECK(good.complaints[0].reason == "class 0: there is no certificate");

    CHECK(complaint("") == "0: found nothing, expected `plcert`");
    CHECK(complaint("plcert 2 classification\n") == "1: found `2`, expected `1`");
    CHECK(complaint("# plcert\n") == "1: found `#`, expected `plcert`");
    CHECK(complaint("plcert 1 classification") ==
          "1: found `plcert 1 classification`, expected a line feed within 16384 bytes");
    CHECK(complaint("plcert 1 classification\r\n")
              .starts_with("1: found `\\x0d`, expected printable ASCII"));
    CHECK(complaint(std::string("plcert\0", 7) + "\n").starts_with("1: found `\\x00`"));
    CHECK(complaint("plcert\t1\n").starts_with("1: found `\\x09`"));
    CHECK(complaint("plcert 1 classificati\xc3\xb6n\n").starts_with("1: found `\\xc3`"));
    CHECK(
        complaint("plcert  1 classification\n").ends_with("expected words separated by one space"));
    CHECK(
        complaint(" plcert 1 classification\n").ends_with("expected words separated by one space"));
    CHECK(
        complaint("plcert 1 classification \n").ends_with("expected words separated by one space"));
    CHECK(complaint("plcert 1 classification\n\n") ==
          "2: found nothing, expected words separated by one space");
    CHECK(complaint("plcert 1 classification more\n") ==
          "1: found `more`, expected the end of the line");
    CHECK(complaint("plcert 1 classification\n") == "1: found nothing, expected `modulus`");
    CHECK(complaint("plcert 1 classification\nmodulus 7\n") ==
          "2: found `7`, expected `2305843009213693951`");
    CHECK(complaint(head + "pool 2\n") == "4: found `2`, expected `1`");
    CHECK(complaint(head + "hello\n") == "4: found `hello`, expected `deficient`");
    CHECK(complaint(head + "#" + std::string(16384, '-') + "\n")
              .ends_with("expected a line feed within 16384 bytes"));
    CHECK(replay(classes(), "file", head + "#" + std::string(16383, '-') + "\n" + pool).conforms);

    const auto with_point = [&](const std::string& x) {
        std::string text = head + pool;
        return complaint(text.replace(text.find("point 1") + 6, 1, x));
    };
    for (const std::string wrong : {"01", "-0", "+1", "1.0", "1e3", "1000000", "-1000000", "0x1",
                                    "--1", "-", "99999999999999999999", "a"})
        CHECK(with_point(wrong) ==
              "7: found `" + wrong + "`, expected an integer from -999999 to 999999");
    CHECK(complaint(head + pool + "feature P/P/P point 1 2\n") ==
          "8: found nothing, expected an integer from -999999 to 999999");
    CHECK(complaint(head + pool + "feature Pa/Pa/Pa point 1 2 3 pin 1 2 3\n")
              .ends_with("expected a feature, in the order of the table"));
    CHECK(complaint(head + pool + "feature P/P point 1 2 3\n")
              .ends_with("expected a feature, in the order of the table"));
    CHECK(complaint(head + pool + "feature P/P/P point 1 2 3 pin 1 2 3\n")
              .ends_with("expected the end of the line"));
    CHECK(complaint(head + pool + "minimal 0 1 0\n")
              .ends_with("expected an integer from 1 to 2305843009213693950"));
    CHECK(complaint(head + pool + "minimal 0 1 2305843009213693951\n")
              .ends_with("expected an integer from 1 to 2305843009213693950"));
    CHECK(complaint(head + pool + "minimal 5 1 1\nminimal 5 1 1\n") == "9: class 5 comes too late");
    CHECK(complaint(head + pool + "minimal 0 1 1\n" + pool) ==
          "9: found `pool`, expected `deficient`");

    std::string many = head;
    for (int n = 1; n <= 100; ++n)
        many += "pool " + std::to_string(n) + pool.substr(6);
    CHECK(complaint(many).ends_with("expected at most 99 pools"));
    many = head + pool;
    for (int n = 1; n <= 1000; ++n)
        many += "feature P/P/P point 1 2 3\n";
    CHECK(complaint(many).ends_with("expected at most 1000 features in a pool"));
    CHECK(complaint(std::string((64 << 20) + 1, '#')) == "0: the file is larger than 64 MiB");
    CHECK(complaint(std::string(64 << 20, '#')).starts_with("1: found `####"));
}

TEST_CASE("hostile bytes do not reach the terminal") {
    CHECK(printable("\x1b[2J\n\\", 40) == "\\x1b[2J\\x0a\\x5c");
    CHECK(printable(std::string(100, 'a'), 40) == std::string(40, 'a') + "...");
    CHECK(printable("\xff", 40) == "\\xff");
}

TEST_CASE("verdicts that contradict each other within a swap&label class are refused, and certify "
          "nothing") {
    std::size_t second = 0;
    while (classes().swap_class[second] == second)
        ++second;
    const std::size_t first = classes().swap_class[second];
    const FileReport one{.name = "one", .verdicts = {{first, 7, {}}}};
    const FileReport other{.name = "other", .verdicts = {{second, 9, {{1, 0, 0}, 0}}}};
    const Report report = summarize(classes(), {one, other});
    CHECK(report.status == 1);
    CHECK(complaints(report) ==
          say("other:9: refused: class ", second, " contradicts its swap&label class\n"));
    CHECK(summarize(classes(), {one}).status == 0);
}

TEST_CASE("without certificates only the enumeration is certified") {
    const Report report = summarize(classes(), {});
    CHECK(report.status == 0);
    for (std::size_t i = 0; i < report.claims.size(); ++i)
        CHECK(report.claims[i].verdict == (i < 3 ? "confirmed" : "not covered by these files"));
}
