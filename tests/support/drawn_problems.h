// Problems whose pictures are tested: small and large, in two and three views, with what no view
// sees, and with five points that two views share.
#pragma once

#include <string>
#include <vector>

inline const std::vector<std::string> drawn_problems{
    "2*Pa/Pa/Pa + P/P/P",
    "Pabcdefg/Pabcdefg/Pabcdefg + P/a/a",
    "Pab/b/a + a/P/Pa + 3*P/P/P",
    "11*P/P/-",
    "5*P/P",
    "P/P/P + 4*a/a/a",
    "4*P/P/- + P/P/P + Pa/P/a + P/-/P + a/a/a",
    "3*P/P/P + 2*-/P/P",
    "4*P/-/P + 4*-/P/P + P/P/P",
    "-/-/-(P)",
    "-/-/a + a/b/c + P/P/P(a)",
    "Pabcdefghijklmnopqrstuvwxyz/Pabcdefghijklmnopqrstuvwxyz/b + 3*Pabcdefgh/h/-",
    "4*Pabc/Pabc/Pa + 6*a/a/a + 5*Pa/a/P + 5*P/-/Pa",
    "Pabcdefghi/Pabcdefghi + 40*Pa/a + 3*-/P",
};
