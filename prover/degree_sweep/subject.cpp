#include "prover/degree_sweep/subject.h"

#include "prover/catalogue/degrees.h"
#include "prover/many_views/degrees_on_file.h"
#include "prover/minimal/problem_record.h"
#include "prover/problem/complete_visibility.h"
#include "prover/problem/notation.h"

#include <algorithm>
#include <stdexcept>

namespace plprove {

const SweepItem* SweepSubject::find(std::size_t number) const {
    const auto found = std::ranges::lower_bound(items, number, {}, &SweepItem::number);
    return found != items.end() && found->number == number ? &*found : nullptr;
}

const SweepItem& SweepSubject::at(std::size_t number) const {
    const SweepItem* item = find(number);
    if (item == nullptr)
        throw std::out_of_range("there is no " + one() + " " + std::to_string(number));
    return *item;
}

SweepSubject all_constraint_classes() {
    SweepSubject subject;
    for (const ClassDegree& known : degrees_on_file())
        subject.items.push_back({known.constraint_class, known.degree});
    return subject;
}

SweepSubject minimal_problems_of(const CameraModel& cameras) {
    SweepSubject subject{std::string(family_name(cameras)), {}};
    std::size_t number = 0;
    for (const Problem& problem : family_problems(cameras)) {
        ++number;
        if (!is_minimal(certify(problem))) continue;
        const std::string text = notation(problem);
        const auto known = many_views::degree_on_file(text);
        subject.items.push_back({number, known ? known->degree : 0, text});
    }
    return subject;
}

} // namespace plprove
