#include "scene/stacked_areas.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/expects.h"
#include "scene/svg.h"

namespace bead {
namespace {

// Pixels.
constexpr double stack_width = 1000, page_height = 430;
constexpr double stack_left = 70, right = 975, stack_top = 84, bottom = 352;

constexpr std::string_view stack_ink = "#1f2933", stack_faint_ink = "#5b6670", grid_ink = "#e4e0d8";

// What is drawn: 0 … `highest` over 0 … `lasting` s.
struct Scales {
    double highest = 1, lasting = 1;
    [[nodiscard]] double x(double seconds) const {
        return stack_left + (right - stack_left) * seconds / lasting;
    }
    [[nodiscard]] double y(double value) const {
        return bottom - (bottom - stack_top) * value / highest;
    }
};

std::string words(double x, double y, std::string_view text, std::string_view looks) {
    return fmt::format("<text x=\"{}\" y=\"{}\" {}>{}</text>\n", decimal(x), decimal(y), looks,
                       escaped(text));
}

// 1, 2 or 5 times a power of ten, so that about `count` of them make `whole`.
double round_step(double whole, double count) {
    const double ten = std::pow(10, std::floor(std::log10(whole / count)));
    for (const double times : {1.0, 2.0, 5.0})
        if (whole / (times * ten) <= count) return times * ten;
    return 10 * ten;
}

// Of a clock: so that at most nine of them make `whole` s.
double clock_step(double whole) {
    for (const double step : {1., 5., 10., 30., 60., 120., 300., 600., 900., 1800., 3600., 7200.})
        if (whole / step <= 9) return step;
    return 7200 * std::ceil(whole / 9 / 7200);
}

std::string clock(double seconds) {
    const int s = static_cast<int>(std::lround(seconds));
    if (s % 60 != 0) return fmt::format("{}:{:02} min", s / 60, s % 60);
    return s < 3600 ? fmt::format("{} min", s / 60)
                    : fmt::format("{}:{:02} h", s / 3600, s / 60 % 60);
}

std::vector<double> sums_of(const StackedAreas& areas) {
    std::vector<double> sums(areas.bands.front().values.size(), 0.0);
    for (const Band& band : areas.bands) {
        BEAD_EXPECTS(band.values.size() == sums.size());
        for (std::size_t i = 0; i < sums.size(); ++i) sums[i] += band.values[i];
    }
    return sums;
}

std::string grid(const Scales& scales, std::string_view unit) {
    std::string svg;
    const double step = round_step(scales.highest, 6);
    for (double value = 0; value <= scales.highest * 1.0001; value += step) {
        svg += fmt::format("<path d=\"M{} {}H{}\" stroke=\"{}\"/>\n", decimal(stack_left),
                           decimal(scales.y(value)), decimal(right), grid_ink);
        svg += words(stack_left - 8, scales.y(value) + 4, fmt::format("{:g} {}", value, unit),
                     "text-anchor=\"end\"");
    }
    const double tick = clock_step(scales.lasting);
    for (double time = 0; time <= scales.lasting * 1.0001; time += tick)
        svg += words(scales.x(time), bottom + 20, clock(time), "text-anchor=\"middle\"");
    return svg;
}

// From the floor, or the band below, up to the band's own top.
std::string area(const std::vector<double>& below, const std::vector<double>& above,
                 const Scales& scales, double step) {
    std::string d;
    for (std::size_t i = 0; i < above.size(); ++i) {
        const double time = static_cast<double>(i) * step;
        d += fmt::format("{}{} {}H{}", i == 0 ? "M" : "L", decimal(scales.x(time)),
                         decimal(scales.y(above[i])), decimal(scales.x(time + step)));
    }
    for (std::size_t i = below.size(); i-- > 0;) {
        const double time = static_cast<double>(i) * step;
        d += fmt::format("L{} {}H{}", decimal(scales.x(time + step)), decimal(scales.y(below[i])),
                         decimal(scales.x(time)));
    }
    return d + "Z";
}

std::string bands(const StackedAreas& areas, const Scales& scales) {
    std::string svg;
    std::vector<double> below(areas.bands.front().values.size(), 0.0), above = below;
    for (const Band& band : areas.bands) {
        for (std::size_t i = 0; i < above.size(); ++i) above[i] += band.values[i];
        svg += fmt::format("<path d=\"{}\" fill=\"{}\"/>\n", area(below, above, scales, areas.step),
                           band.ink);
        below = above;
    }
    return svg;
}

// The highest band first, as they lie.
std::string legend(const StackedAreas& areas) {
    std::string svg;
    double x = stack_left;
    for (auto band = areas.bands.rbegin(); band != areas.bands.rend(); ++band) {
        svg += fmt::format("<rect x=\"{}\" y=\"54\" width=\"14\" height=\"14\" fill=\"{}\"/>\n",
                           decimal(x), band->ink);
        svg += words(x + 20, 66, band->name, "");
        x += 44 + 7.2 * static_cast<double>(band->name.size());
    }
    return svg;
}

}  // namespace

std::string stacked_areas_svg(const StackedAreas& areas) {
    BEAD_EXPECTS(!areas.bands.empty() && !areas.bands.front().values.empty() && areas.step > 0);
    const std::vector<double> sums = sums_of(areas);
    const double most = std::max(1e-9, *std::ranges::max_element(sums));
    const Scales scales{1.05 * most, static_cast<double>(sums.size()) * areas.step};
    return fmt::format(
               "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {0} {1}\" width=\"{0}\" "
               "height=\"{1}\" font-family=\"system-ui, sans-serif\" font-size=\"13\" "
               "fill=\"{2}\">\n<rect width=\"{0}\" height=\"{1}\" fill=\"#ffffff\"/>\n",
               decimal(stack_width), decimal(page_height), stack_faint_ink) +
           words(stack_left, 36, areas.title,
                 fmt::format("font-size=\"18\" fill=\"{}\"", stack_ink)) +
           legend(areas) + grid(scales, areas.unit) + bands(areas, scales) +
           words(stack_left, page_height - 20, areas.caption, "") + "</svg>\n";
}

}  // namespace bead
