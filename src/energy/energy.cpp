#include "energy/energy.h"

namespace bead {

Energy& operator+=(Energy& a, const Energy& b) {
    a.bed += b.bed;
    a.hotend += b.hotend;
    a.motors += b.motors;
    a.fans += b.fans;
    a.electronics += b.electronics;
    return a;
}

Energy operator+(Energy a, const Energy& b) { return a += b; }

Energy operator-(const Energy& a, const Energy& b) { return a + -1 * b; }

Energy operator*(double factor, const Energy& energy) {
    return {factor * energy.bed, factor * energy.hotend, factor * energy.motors,
            factor * energy.fans, factor * energy.electronics};
}

double total(const Energy& energy) {
    return energy.bed + energy.hotend + energy.motors + energy.fans + energy.electronics;
}

}  // namespace bead
