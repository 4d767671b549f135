// A second opinion on records of degree files, by other means than the checker's: the prover's
// equations of the class, whose Jacobian is taken from differences; Newton's method with the digits
// of long double; and the prover's measure of nondegeneracy. No proof, but another way to the same
// numbers. Of fibres it computes all anew, by FLINT. The second checker does not read these files.
#pragma once

#include "checker/degrees/degree_file.h"

#include <map>
#include <optional>
#include <string>

namespace mutation {

class DegreeReferee {
public:
    DegreeReferee();

    /// Why one of the bounds is not what the file shows, as far as approximations tell, or is more
    /// than the class has solutions; nothing if all are true.
    std::optional<std::string> objection(const std::string& text,
                                         const std::vector<checker::LowerBound>& bounds);

private:
    std::map<std::size_t, std::size_t> known_; ///< the number of solutions of classes
    /// What was found of a record that claims so many solutions: most are unchanged.
    std::map<std::string, std::optional<std::string>> found_;
};

} // namespace mutation
