#include "prover/solver/templates/equations.h"

#include "prover/minimal/pool.h"
#include "prover/solver/templates/system.h"

namespace plprove::templates {

namespace {

constexpr Vector3 first_axis{1, 0, 0};
constexpr Vector3 third_axis{0, 0, 1};

/// A vector without zeros.
Vector3 draw_vector(SmallIntegers& integers) {
    Vector3 v{};
    for (std::int64_t& coordinate : v)
        do
            coordinate = integers.next();
        while (coordinate == 0);
    return v;
}

RegistrationData::Star draw_star(Frame frame, std::size_t index, int pins,
                                 SmallIntegers& integers) {
    RegistrationData::Star star{draw_vector(integers), draw_vector(integers), {}};
    if (frame == Frame::points && index < 2) {
        star.point = {star.point[0], 0, 0};
        star.image[2] = 0;
    }
    if (index == 0) star.point = {};
    for (int i = 0; i < pins; ++i)
        star.pins.push_back({draw_vector(integers), draw_vector(integers)});
    return star;
}

RegistrationData::Line draw_line(Frame frame, int index, SmallIntegers& integers) {
    const RegistrationData::Line line{draw_vector(integers), draw_vector(integers),
                                      draw_vector(integers)};
    if (frame == Frame::line && index == 0) return {line.point, first_axis, third_axis};
    if (frame == Frame::lines && index == 0) return {{}, first_axis, third_axis};
    if (frame == Frame::lines && index == 1)
        return {{0, 0, line.point[2]}, {line.direction[0], line.direction[1], 0}, line.image};
    return line;
}

} // namespace

bool suits(Frame frame, const Registration& type) {
    if (frame == Frame::line) return type.lines > 0;
    if (frame == Frame::lines) return type.lines == 2 && type.stars.empty() && type.incidences == 0;
    return frame == Frame::general || type.stars.size() >= 2;
}

RegistrationData draw_data(const Registration& type, Frame frame, std::uint64_t seed) {
    SmallIntegers integers(seed, 99);
    RegistrationData data;
    for (const int pins : type.stars)
        data.stars.push_back(draw_star(frame, data.stars.size(), pins, integers));
    for (int i = 0; i < type.lines; ++i)
        data.lines.push_back(draw_line(frame, i, integers));
    for (int i = 0; i < type.incidences; ++i)
        data.incidences.push_back({draw_vector(integers), draw_vector(integers)});
    for (const int rays : type.groups) {
        RegistrationData::Group group{draw_vector(integers), {}};
        for (int i = 0; i < rays; ++i)
            group.rays.push_back({draw_vector(integers), draw_vector(integers)});
        data.groups.push_back(std::move(group));
    }
    return data;
}

Vector3 line_of(const RegistrationData::Star& star, const RegistrationData::Pin& pin) {
    return cross(star.image, pin.toward);
}

std::vector<Equation> equations(const RegistrationData& data, Frame frame) {
    const RotationRing ring(frame);
    System<RotationFunction, RegistrationData> system(data, frame, ring.matrix(), ring.one());
    system.add_minors();
    std::vector<Equation> all;
    for (std::size_t i = 0; i < system.equations().size(); ++i)
        all.push_back({system.equations()[i].polynomial(), system.degrees()[i]});
    return all;
}

} // namespace plprove::templates
