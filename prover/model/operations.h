// The arrays of a program, and the functions of the language on them. All take the place in the
// text where they are used, and throw ModelError that names it if shapes do not fit.
#pragma once

#include "prover/model/program.h"

#include <map>

namespace plprove::model {

/// Adds operations to a program.
class Operations {
public:
    explicit Operations(Program& program) : program_(&program) {}

    ScalarIndex constant(int value);
    ScalarIndex zero(); ///< the 0 that has no degree
    ScalarIndex add(Operation::Kind kind, ScalarIndex left, ScalarIndex right, Position at);

    Array sum(Operation::Kind kind, const Array& left, const Array& right, Position at);
    Array negative(const Array& array, Position at);
    Array product(const Array& left, const Array& right, Position at);
    Array quotient(const Array& left, const Array& right, Position at);
    Array power(const Array& base, int exponent, Position at);

    /// The function of this name.
    Array call(const std::string& name, const std::vector<Array>& arguments, Position at);
    Array identity(int size);

private:
    using Scalars = std::vector<ScalarIndex>;

    ScalarIndex plus(ScalarIndex a, ScalarIndex b) { return add(Operation::Kind::sum, a, b, at_); }
    ScalarIndex minus(ScalarIndex a, ScalarIndex b) {
        return add(Operation::Kind::difference, a, b, at_);
    }
    ScalarIndex times(ScalarIndex a, ScalarIndex b) {
        return add(Operation::Kind::product, a, b, at_);
    }
    ScalarIndex dot(const Scalars& u, const Scalars& v);
    ScalarIndex determinant(const Array& matrix);
    Array dot(const std::vector<Array>& arguments);
    Array cross(const std::vector<Array>& arguments);
    Array skew(const std::vector<Array>& arguments);
    Array trace(const std::vector<Array>& arguments);
    Array transpose(const std::vector<Array>& arguments);
    Array rotation(const std::vector<Array>& arguments);
    Array matrix_product(const Array& left, const Array& right);

    [[noreturn]] void fail(const std::string& message) const;
    void require(bool holds, const std::string& message) const {
        if (!holds) fail(message);
    }

    Program* program_;
    Position at_;
    std::size_t divisions_ = 0; // so far
    std::map<int, ScalarIndex> constants_;
};

/// "a scalar", "a vector of 3", "a 3 by 4 matrix", "an array of 2 by 3 by 4".
std::string describe_shape(const std::vector<int>& shape);

} // namespace plprove::model
