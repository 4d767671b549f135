#include "prover/many_views/way.h"

#include <algorithm>

namespace plprove::many_views {

namespace {

void copy(const Complex& from, double (&to)[2]) {
    to[0] = from.real();
    to[1] = from.imag();
}

bool is_zero(const Polynomial& polynomial) {
    return std::ranges::all_of(polynomial.coefficients(),
                               [](const Complex& c) { return c == Complex(0); });
}

} // namespace

Way::Way(const System& system, const Images<Complex>& from, const Images<Complex>& to) {
    const Problem& problem = system.problem();
    way_.form = problem.cameras->tracked;
    if (way_.form == TrackedForm::polynomials) add_entries(*problem.cameras);
    way_.depths = static_cast<int>(system.depths());
    way_.shared = problem.cameras->shared;
    way_.numbers = problem.cameras->numbers;
    way_.unknowns = static_cast<int>(system.unknowns());
    for (std::size_t view = 1; view < from.size(); ++view)
        add_camera(system, view);
    equations_.resize(cameras_.size());
    for (const auto& equation : incidences(problem, straight_way(from, to))) {
        const auto& [x, y, z] = equation.l;
        equations_[equation.view - 1].push_back({place_of(equation), {add(x), add(y), add(z)}});
    }
    for (std::size_t v = 0; v < cameras_.size(); ++v) {
        cameras_[v].equations = static_cast<int>(equations_[v].size());
        cameras_[v].equation = equations_[v].data();
    }
    way_.cameras = static_cast<int>(cameras_.size());
    way_.camera = cameras_.data();
    way_.places = static_cast<int>(places_.size());
    way_.place = places_.data();
}

/// The entries of the camera matrix that are not 0, each with its derivatives.
void Way::add_entries(const CameraModel& model) {
    std::vector<NumberPolynomial> numbers;
    for (int k = 0; k < model.all_numbers(); ++k)
        numbers.push_back(NumberPolynomial::number(k));
    const auto matrix = model.polynomials(numbers.data());
    const auto add = [&](int entry, int number, const NumberPolynomial& polynomial) {
        std::vector<TrackedMonomial>& monomials = monomials_.emplace_back();
        for (const auto& [factors, coefficient] : polynomials_.emplace_back(polynomial).terms)
            monomials.push_back({static_cast<double>(coefficient), static_cast<int>(factors.size()),
                                 factors.data()});
        if (!monomials.empty())
            entries_.push_back(
                {entry, number, static_cast<int>(monomials.size()), monomials.data()});
    };
    for (std::size_t i = 0; i < 12; ++i) {
        const NumberPolynomial& entry = matrix[i / 4][i % 4];
        add(static_cast<int>(i), -1, entry);
        for (int k = 0; k < model.all_numbers(); ++k)
            add(static_cast<int>(i), k, entry.derivative(k));
    }
    way_.entries = static_cast<int>(entries_.size());
    way_.entry = entries_.data();
}

void Way::add_camera(const System& system, std::size_t view) {
    const CameraChart::Chart& chart = system.chart().chart(view);
    TrackedCamera camera;
    camera.coordinates = static_cast<int>(chart.basis.cols());
    camera.first_coordinate = static_cast<int>(system.depths() + system.chart().offset(view));
    std::vector<TrackedBasisEntry>& basis = bases_.emplace_back();
    for (Eigen::Index number = 0; number < chart.origin.size(); ++number) {
        copy(chart.origin[number], camera.origin[number]);
        for (Eigen::Index coordinate = 0; coordinate < chart.basis.cols(); ++coordinate) {
            const Complex factor = chart.basis(number, coordinate);
            if (factor == Complex(0)) continue;
            TrackedBasisEntry& entry = basis.emplace_back();
            entry.number = static_cast<int>(number);
            entry.coordinate = static_cast<int>(coordinate);
            copy(factor, entry.factor);
        }
    }
    camera.basis_entries = static_cast<int>(basis.size());
    camera.basis = basis.data();
    cameras_.push_back(camera);
}

TrackedPolynomial Way::add(const Polynomial& polynomial) {
    auto& coefficients = coefficients_.emplace_back();
    for (const Complex& c : polynomial.coefficients())
        coefficients.push_back({c.real(), c.imag()});
    static_assert(sizeof(Coefficients::value_type) == sizeof(double[2]));
    return {static_cast<int>(coefficients.size()),
            reinterpret_cast<const double(*)[2]>(coefficients.data())};
}

/// The index of the equation's place, which several equations share.
int Way::place_of(const Incidence<Polynomial>& equation) {
    const auto place = std::pair(equation.x, equation.depth);
    const auto known = std::ranges::find(known_places_, place);
    if (known != known_places_.end()) return static_cast<int>(known - known_places_.begin());
    known_places_.push_back(place);
    std::vector<int>& unknowns = unknowns_.emplace_back();
    std::vector<TrackedPolynomial>& factors = factors_.emplace_back();
    for (std::size_t k = 0; k < equation.depth.size(); ++k) {
        if (is_zero(equation.depth[k])) continue;
        unknowns.push_back(static_cast<int>(k));
        factors.push_back(add(equation.depth[k]));
    }
    TrackedPlace& tracked = places_.emplace_back();
    for (std::size_t i = 0; i < 3; ++i)
        tracked.x[i] = add(equation.x[i]);
    tracked.depths = static_cast<int>(unknowns.size());
    tracked.unknowns = unknowns.data();
    tracked.factors = factors.data();
    return static_cast<int>(places_.size()) - 1;
}

} // namespace plprove::many_views
