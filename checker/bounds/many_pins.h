// Upper bounds by Theorem K (proofs/three_views/5_many_pins.md), in the form of common_centres.h.
// Classes are left out whose degree is exact by another theorem or certificate. The program
// proofs/computations/points_with_many_pins.cpp computes all.
#pragma once

#include <string_view>

namespace checker {
inline constexpr std::string_view many_pin_bounds = R"(
304: 25 26; 352: 98 144 145 146; 400: 93; 432: 80; 448: 37; 464: 39 46 55; 480: 38; 496: 95 107;
512: 42 43 47; 544: 56 59; 560: 73 81; 624: 74; 656: 76 102; 704: 149; 720: 75 99; 768: 82 108;
784: 84 111 128; 800: 87 101; 816: 110; 832: 129; 864: 109; 880: 83 161; 912: 88 150 162; 928: 123;
960: 153; 976: 152; 992: 122 151; 1056: 158; 1072: 157; 1248: 198 217; 1312: 178; 1360: 170; 1440:
172 199; 1488: 174; 1552: 173 185; 1568: 189; 1584: 218; 1680: 190; 1696: 186; 1744: 221; 1840:
222;
)";
} // namespace checker
