#include "prover/model/data_polynomial.h"

#include <optional>

namespace plprove::model {

namespace {

/// The integer that a value is, if it is small: another value is so with a probability of 2^-40.
std::optional<int> small_integer(Modular value) {
    constexpr Residue largest = 1U << 20U;
    if (value.value() <= largest) return static_cast<int>(value.value());
    const Residue negative = (-value).value();
    if (negative <= largest) return -static_cast<int>(negative);
    return std::nullopt;
}

} // namespace

DataProgram::Step DataProgram::simplified(const Step& step, Modular value) {
    if (step.kind <= StepKind::datum) return step;
    if (const auto opposite = places_.find((-value).value()); opposite != places_.end())
        return {StepKind::negative, opposite->second, 0, 0};
    const auto is_negative = [&](std::size_t i) { return steps_[i].kind == StepKind::negative; };
    const auto opposite = [&](std::size_t i) { return steps_[i].left; };
    if (step.kind == StepKind::sum && is_negative(step.right))
        return {StepKind::difference, step.left, opposite(step.right), 0};
    if (step.kind == StepKind::sum && is_negative(step.left))
        return {StepKind::difference, step.right, opposite(step.left), 0};
    if (step.kind == StepKind::product && is_negative(step.left))
        return {StepKind::negative,
                this->step({StepKind::product, opposite(step.left), step.right, 0}, -value), 0, 0};
    if (step.kind == StepKind::product && is_negative(step.right))
        return {StepKind::negative,
                this->step({StepKind::product, step.left, opposite(step.right), 0}, -value), 0, 0};
    return step;
}

std::size_t DataProgram::step(const Step& step, Modular value) {
    if (const auto place = places_.find(value.value()); place != places_.end())
        return place->second;
    const Step simple = simplified(step, value); // may add steps
    steps_.push_back(simple);
    places_.emplace(value.value(), steps_.size() - 1);
    return steps_.size() - 1;
}

DataPolynomial DataPolynomial::datum(DataProgram& program, std::size_t index, Modular value) {
    DataPolynomial result;
    result.value_ = value;
    result.program_ = &program;
    result.step_ = program.step({StepKind::datum, index, 0, 0}, value);
    return result;
}

std::size_t DataPolynomial::step(DataProgram& program) const {
    return program_ != nullptr ? step_ : program.step({StepKind::literal, 0, 0, constant_}, value_);
}

DataPolynomial DataPolynomial::combined(StepKind kind, const DataPolynomial& a,
                                        const DataPolynomial& b, const DataPolynomial& result) {
    DataProgram* program = a.program_ != nullptr ? a.program_ : b.program_;
    if (program == nullptr) return result;
    if (const auto integer = small_integer(result.value_)) return DataPolynomial(*integer);
    DataPolynomial combination = result;
    combination.program_ = program;
    combination.step_ = program->step({kind, a.step(*program), b.step(*program), 0}, result.value_);
    return combination;
}

DataPolynomial operator+(const DataPolynomial& a, const DataPolynomial& b) {
    DataPolynomial result;
    result.value_ = a.value_ + b.value_;
    result.constant_ = a.constant_ + b.constant_;
    return DataPolynomial::combined(StepKind::sum, a, b, result);
}

DataPolynomial operator-(const DataPolynomial& a, const DataPolynomial& b) {
    DataPolynomial result;
    result.value_ = a.value_ - b.value_;
    result.constant_ = a.constant_ - b.constant_;
    return DataPolynomial::combined(StepKind::difference, a, b, result);
}

DataPolynomial operator*(const DataPolynomial& a, const DataPolynomial& b) {
    DataPolynomial result;
    result.value_ = a.value_ * b.value_;
    result.constant_ = a.constant_ * b.constant_;
    return DataPolynomial::combined(StepKind::product, a, b, result);
}

DataPolynomial DataPolynomial::inverse() const {
    DataPolynomial result;
    result.value_ = value_.inverse();
    result.constant_ = 1 / constant_;
    return result;
}

} // namespace plprove::model
