// Joules by who draws them, at the wall: the supply's losses are included.
#pragma once

namespace bead {

struct Energy {
    double bed = 0, hotend = 0, motors = 0, fans = 0, electronics = 0;
};
Energy& operator+=(Energy& a, const Energy& b);
Energy operator+(Energy a, const Energy& b);
Energy operator-(const Energy& a, const Energy& b);
Energy operator*(double factor, const Energy& energy);
double total(const Energy& energy);

}  // namespace bead
