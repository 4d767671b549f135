#include "checker/model/dual_extension.h"

#include "checker/file/complaint.h"

namespace checker {
DualExtension::Element DualExtension::unknown(Polynomial value, std::size_t number) const {
    Element result{std::move(value), {}};
    result.change.resize(number + 1, extension_.constant({}));
    result.change.back() = extension_.constant({1});
    return result;
}

DualExtension::Element DualExtension::add(const Element& a, const Element& b) const {
    Element sum{sum_of(a.value, b.value), a.change};
    sum.change.resize(std::max(a.change.size(), b.change.size()), extension_.constant({}));
    for (std::size_t i = 0; i < b.change.size(); ++i)
        sum.change[i] = sum_of(std::move(sum.change[i]), b.change[i]);
    return sum;
}

DualExtension::Element DualExtension::multiply(const Element& a, const Element& b) const {
    Element result{extension_.multiply(a.value, b.value), {}};
    result.change.resize(std::max(a.change.size(), b.change.size()), extension_.constant({}));
    for (std::size_t i = 0; i < a.change.size(); ++i)
        result.change[i] = extension_.multiply(a.change[i], b.value);
    for (std::size_t i = 0; i < b.change.size(); ++i)
        result.change[i] =
            sum_of(std::move(result.change[i]), extension_.multiply(a.value, b.change[i]));
    return result;
}

DualExtension::Element DualExtension::inverse(const Element& a) const {
    if (a.value[0] == Residue{}) throw Refused("the model divides by the constant 0");
    return {extension_.constant(a.value[0].inverse()), {}};
}
} // namespace checker
