// Rows of the Jacobian: they are derivatives, and defined only where section 2 of FORMAT.md says.
#include "tests/support/jacobian_points.h"

#include <doctest/doctest.h>

using namespace checker;

namespace {

/// A number that moves: value + change · epsilon with epsilon² = 0.
struct Moving {
    mpz_class value = 0, change = 0;
    Moving operator+(const Moving& b) const { return {value + b.value, change + b.change}; }
    Moving operator*(const Moving& b) const {
        return {value * b.value, value * b.change + change * b.value};
    }
};
using Rotation = std::array<IntegerVector, 3>; // by rows

/// The matrix of section 2.
Rotation rotation_of(const mpz_class& a, const mpz_class& b, const mpz_class& c,
                     const mpz_class& d) {
    return {IntegerVector{a * a + b * b - c * c - d * d, 2 * (b * c - a * d), 2 * (b * d + a * c)},
            IntegerVector{2 * (b * c + a * d), a * a - b * b + c * c - d * d, 2 * (c * d - a * b)},
            IntegerVector{2 * (b * d - a * c), 2 * (c * d + a * b), a * a - b * b - c * c + d * d}};
}

IntegerVector vector_at(const Numbers& numbers, std::size_t place) {
    return {numbers[place], numbers[place + 1], numbers[place + 2]};
}

using MovingVector = Vector3<Moving>;
using Motion = std::vector<mpz_class>; // by the unknowns of a feature, then those of the cameras

IntegerVector values(const Vector3<Dual<mpz_class>>& v) {
    return {v[0].value, v[1].value, v[2].value};
}

IntegerVector values(const MovingVector& v) {
    return {v[0].value, v[1].value, v[2].value};
}

IntegerVector changes(const MovingVector& v) {
    return {v[0].change, v[1].change, v[2].change};
}

/// The vector, whose first coordinates move as the motion says from this place on.
MovingVector moving(const IntegerVector& v, const Motion& motion, std::size_t first,
                    std::size_t moving_coordinates) {
    MovingVector result;
    for (std::size_t i = 0; i < 3; ++i) {
        result[i].value = v[i];
        if (i < moving_coordinates) result[i].change = motion[first + i];
    }
    return result;
}

/// A camera that moves: (1 + [w]) R and t + dt.
struct MovingCamera {
    std::array<MovingVector, 3> rotation; // by rows
    MovingVector translation;

    MovingVector rotate(const MovingVector& x) const {
        return {dot(rotation[0], x), dot(rotation[1], x), dot(rotation[2], x)};
    }
};

/// View 1 rests; so does the first coordinate of the translation of view 2.
MovingCamera moving_camera(std::size_t view, const Motion& motion, std::size_t first) {
    Rotation rotation = rotation_of(1, 0, 0, 0);
    IntegerVector translation;
    if (view > 0) {
        const Numbers& n = three_cameras()[view - 1];
        rotation = rotation_of(n[0], n[1], n[2], n[3]);
        translation = vector_at(n, 4);
    }
    IntegerVector w, dt;
    for (std::size_t i = 0; i < 3; ++i) {
        if (view == 1) w[i] = motion[first + i];
        if (view == 1 && i > 0) dt[i] = motion[first + 2 + i];
        if (view == 2) w[i] = motion[first + 5 + i];
        if (view == 2) dt[i] = motion[first + 8 + i];
    }
    MovingCamera result;
    for (std::size_t column = 0; column < 3; ++column) {
        const IntegerVector fixed{rotation[0][column], rotation[1][column], rotation[2][column]};
        const IntegerVector turned = cross(w, fixed);
        for (std::size_t row = 0; row < 3; ++row)
            result.rotation[row][column] = {fixed[row], turned[row]};
    }
    for (std::size_t i = 0; i < 3; ++i)
        result.translation[i] = {translation[i], dt[i]};
    return result;
}

/// Takes the rows of a feature one by one, and compares each with what the motion changes.
class RowChecker {
public:
    RowChecker(const Rows<mpz_class>& rows, const Motion& motion) : rows_(rows), motion_(motion) {}

    /// The next row is that of l · v = 0, where l is fixed.
    void check(const IntegerVector& l, const MovingVector& v) {
        REQUIRE(next_ < rows_.size());
        mpz_class by_row = 0;
        for (std::size_t k = 0; k < motion_.size(); ++k)
            by_row += rows_[next_][k] * motion_[k];
        CHECK(by_row == dot(l, changes(v)));
        CHECK(dot(l, values(v)) == 0);
        ++next_;
    }

    std::size_t checked() const { return next_; }

private:
    const Rows<mpz_class>& rows_;
    const Motion& motion_;
    std::size_t next_ = 0;
};

/// The reason for which a feature has no Jacobian here; empty if it has one.
std::string reason(std::string_view feature, const Numbers& placement,
                   const std::vector<Numbers>& cameras) {
    try {
        rows_of(features[index_of(feature)], 3, {cameras, placement});
        return "";
    } catch (const Refused& refused) {
        return refused.reason;
    }
}

} // namespace

TEST_CASE("rows of the Jacobian are the derivatives of the incidences") {
    RandomIntegers random;
    for (const Feature& feature : features) {
        const Numbers placement = random_placement(feature, random);
        const Rows<mpz_class> rows = rows_of(feature, 3, {three_cameras(), placement}).rows;
        REQUIRE(rows.size() == feature.equations);
        Motion motion(feature.unknowns() + camera_unknowns);
        for (mpz_class& x : motion)
            x = random(9);
        RowChecker checker(rows, motion);
        const unsigned point_unknowns = feature.point_unknowns();
        for (std::size_t view = 0; view < 3; ++view) {
            const MovingCamera camera = moving_camera(view, motion, feature.unknowns());
            const MovingVector y =
                camera.rotate(moving(vector_at(placement, 0), motion, 0, point_unknowns));
            const MovingVector x = plus(y, camera.translation);
            const bool sees_point = has_view(feature.point, view);
            if (sees_point) checker.check({0, x[2].value, -x[1].value}, x);
            if (sees_point) checker.check({-x[2].value, 0, x[0].value}, x);
            for (std::size_t pin = 0; pin < feature.pins; ++pin) {
                if (!has_view(feature.pin[pin], view)) continue;
                const std::size_t first = point_unknowns + 2 * pin;
                const MovingVector e =
                    camera.rotate(moving(vector_at(placement, 3 * pin + 3), motion, first, 2));
                const IntegerVector l = cross(values(x), values(e));
                if (!sees_point) checker.check(l, x);
                checker.check(l, e);
            }
        }
        CHECK(checker.checked() == rows.size());
    }
}

TEST_CASE("a quaternion turns into its rotation, scaled by its norm") {
    RandomIntegers random;
    for (int round = 0; round < 50; ++round) {
        const Numbers numbers{random(99), random(99), random(99), 1 + random(9) * 2, 1, 2, 3};
        Source<mpz_class> source;
        source.read(numbers);
        const CameraMatrix<Dual<mpz_class>> camera =
            place_camera(calibrated_cameras, source, {}, true);
        Rotation r; // its columns
        for (std::size_t i = 0; i < 3; ++i)
            r[i] = values(camera[i]);
        CHECK(values(camera[3]) == IntegerVector{1, 2, 3});
        const mpz_class a = numbers[0], b = numbers[1], c = numbers[2], d = numbers[3];
        const mpz_class norm = a * a + b * b + c * c + d * d;
        for (std::size_t i = 0; i < 3; ++i)
            for (std::size_t j = 0; j < 3; ++j)
                CHECK(dot(r[i], r[j]) == (i == j ? mpz_class(norm * norm) : mpz_class(0)));
        CHECK(dot(r[0], cross(r[1], r[2])) == norm * norm * norm);
        const IntegerVector axis{b, c, d};
        CHECK(plus(plus(times(b, r[0]), times(c, r[1])), times(d, r[2])) == times(norm, axis));
        const Rotation rows = rotation_of(a, b, c, d);
        for (std::size_t i = 0; i < 3; ++i)
            for (std::size_t j = 0; j < 3; ++j)
                CHECK(r[i][j] == rows[j][i]);
    }
}

TEST_CASE("the requirements of section 2") {
    const std::vector<Numbers> lines{Numbers{1, 2, -1, 3, 5, -2, 4},
                                     Numbers{2, -3, 1, 1, -4, 7, 3}};
    const std::string_view feature = "P/Pa/a";
    CHECK(reason("Pa/a/P", {1, 2, 3, 4, 5, 6}, lines) == "");
    CHECK(reason("P/Pa/a", {1, 2, 3, 4, 5, 6}, lines) == "");
    std::vector<Numbers> other = lines;
    other[0][4] = 0;
    CHECK(reason(feature, {1, 2, 3, 4, 5, 6}, other) ==
          "the translation of camera 2 begins with 0");
    other = lines;
    std::fill_n(other[1].begin(), 4, 0);
    CHECK(reason(feature, {1, 2, 3, 4, 5, 6}, other) == "a quaternion is zero");
    other = lines;
    std::fill_n(other[0].begin(), 4, 0);
    CHECK(reason(feature, {1, 2, 3, 4, 5, 6}, other) == "a quaternion is zero");
    CHECK(reason(feature, {1, 2, 0, 4, 5, 6}, lines) ==
          "an image of the point has third coordinate 0");
    CHECK(reason(feature, {1, 2, 3, 4, 5, 0}, lines) == "a direction has third coordinate 0");
    const std::vector<Numbers> plain{Numbers{1, 0, 0, 0, 1, 0, 0}, Numbers{1, 0, 0, 0, 2, 0, 0}};
    CHECK(reason(feature, {1, 2, 3, 3, 2, 3}, plain) ==
          "the image of a line is zero"); // seen end on by view 3
}
