#include "mesh/weld.h"

#include <algorithm>
#include <bit>
#include <cstdint>

namespace bead {
namespace {

std::uint64_t bits(double x) { return std::bit_cast<std::uint64_t>(x); }

// The finalizer of MurmurHash3 (A. Appleby), chained over the three coordinates.
std::uint64_t mixed(std::uint64_t h) {
    h = (h ^ (h >> 33)) * 0xff51afd7ed558ccdULL;
    h = (h ^ (h >> 33)) * 0xc4ceb9fe1a85ec53ULL;
    return h ^ (h >> 33);
}

std::uint64_t hash_of(const Vec3& p) {
    return mixed(bits(p.x) + mixed(bits(p.y) + mixed(bits(p.z))));
}

// By bits, so that a point that is not a number equals itself.
bool same(const Vec3& a, const Vec3& b) {
    return bits(a.x) == bits(b.x) && bits(a.y) == bits(b.y) && bits(a.z) == bits(b.z);
}

}  // namespace

Welder::Welder(std::size_t expected)
    : slots_(std::bit_ceil(std::max<std::size_t>(16, 2 * expected)), -1) {
    points_.reserve(expected);
}

std::size_t Welder::slot_of(const Vec3& point) const {
    const std::size_t mask = slots_.size() - 1;
    std::size_t slot = hash_of(point) & mask;
    while (slots_[slot] >= 0 && !same(points_[static_cast<std::size_t>(slots_[slot])], point))
        slot = (slot + 1) & mask;
    return slot;
}

int Welder::index(Vec3 point) {
    point = point + Vec3{};  // -0 becomes 0
    const std::size_t slot = slot_of(point);
    if (slots_[slot] >= 0) return slots_[slot];
    const int index = static_cast<int>(points_.size());
    slots_[slot] = index;
    points_.push_back(point);
    if (2 * points_.size() > slots_.size()) grow();
    return index;
}

void Welder::grow() {
    slots_.assign(2 * slots_.size(), -1);
    for (std::size_t i = 0; i < points_.size(); ++i)
        slots_[slot_of(points_[i])] = static_cast<int>(i);
}

}  // namespace bead
