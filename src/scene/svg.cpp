#include "scene/svg.h"

#include <fmt/format.h>

#include <cmath>
#include <cstdint>
#include <cstdlib>

namespace bead {
namespace {

// A length in thousandths.
std::string thousandths(std::int64_t value) {
    const auto size = std::abs(value);
    std::string text = fmt::format("{}{}", value < 0 ? "-" : "", size / 1000);
    if (size % 1000 == 0) return text;
    text += fmt::format(".{:03}", size % 1000);
    text.erase(text.find_last_not_of('0') + 1);
    return text;
}

std::int64_t rounded(double value) { return std::llround(value * 1000); }

}  // namespace

std::string decimal(double value) { return thousandths(rounded(value)); }

std::string escaped(std::string_view text) {
    std::string safe;
    for (const char c : text) {
        switch (c) {
            case '&':
                safe += "&amp;";
                break;
            case '<':
                safe += "&lt;";
                break;
            case '>':
                safe += "&gt;";
                break;
            case '"':
                safe += "&quot;";
                break;
            default:
                safe += static_cast<unsigned char>(c) < 0x20 ? ' ' : c;
        }
    }
    return safe;
}

std::string stroke_data(std::span<const Vec3> points) {
    std::string data;
    std::int64_t x = 0, y = 0;
    int steps = -1;
    for (const Vec3& point : points) {
        const std::int64_t next_x = rounded(point.x), next_y = rounded(-point.y);
        if (steps >= 0 && next_x == x && next_y == y) continue;
        const std::string_view before = steps < 0 ? "M" : steps == 0 ? "l" : " ";
        data += fmt::format("{}{} {}", before, thousandths(next_x - x), thousandths(next_y - y));
        x = next_x;
        y = next_y;
        ++steps;
    }
    return steps > 0 ? data : "";
}

std::string content_name(std::string_view content) {
    std::uint64_t hash = 14695981039346656037U;  // FNV-1a
    for (const char c : content) hash = (hash ^ static_cast<unsigned char>(c)) * 1099511628211U;
    return fmt::format("b{:016x}", hash);
}

}  // namespace bead
