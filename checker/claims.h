// What the claims of the report are about.
#pragma once

#include "checker/report.h"

namespace checker {
/// The minimal classes that come first of their swap&label class stand for the terminal problems.
struct Class {
    bool minimal, first, terminal;
    unsigned excess, star;                // E, S
    unsigned most_pins = 0;               // at a point
    unsigned lines = 0;                   // free ones
    bool five = false, registers = false; // two views share five points; and `determine` the rest
    std::string name{};                   // in PLMP, if every view sees everything
};

/// Compares the degrees in the report's files with the paper. Of the classes, those that are
/// minimal are certified to be so; these are `all` or some.
void add_degree_claims(const Classification& classes, const std::vector<Class>& described, bool all,
                       Report& report);
} // namespace checker
