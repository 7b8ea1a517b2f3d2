#include "scene/layer_picture.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "scene/drawing.h"
#include "scene/looks.h"
#include "scene/svg.h"

namespace bead {
namespace {

// Pixels.
constexpr double page_width = 1200, margin = 28, gap = 20, padding = 14;
constexpr double tallest_panel = 720;
constexpr double title_height = 46, panel_title_height = 30, caption_height = 28;
constexpr double legend_height = 50;
constexpr double longest_bar = 150;

constexpr std::string_view ink = "#1f2933", faint_ink = "#5b6670";

struct Page {
    double panel_width = 0, panel_height = 0;  // px
    double title = 0, panel_title = 0,
           caption = 0;  // px, heights; 0 where no panel has such a text
    double scale = 1;    // px per mm
    [[nodiscard]] double panels_top() const { return margin + title + panel_title; }
    [[nodiscard]] double legend_top() const { return panels_top() + panel_height + caption; }
    [[nodiscard]] double height() const { return legend_top() + legend_height + margin / 2; }
};

// The scale at which the widest and the highest layer fit.
Page page_for(std::span<const Panel> panels, const std::string& title) {
    Vec2 largest{1, 1};
    for (const Panel& panel : panels) {
        const Vec2 size = extent(panel.layer).size();
        largest = {std::max(largest.x, size.x), std::max(largest.y, size.y)};
    }
    const double count = std::max(1.0, double(panels.size()));
    Page page;
    page.panel_width = (page_width - 2 * margin - (count - 1) * gap) / count;
    page.scale = std::min((page.panel_width - 2 * padding) / largest.x,
                          (tallest_panel - 2 * padding) / largest.y);
    page.panel_height = page.scale * largest.y + 2 * padding;
    page.title = title.empty() ? 0 : title_height;
    const auto any = [&](auto text) {
        return !std::ranges::all_of(panels, &std::string::empty, text);
    };
    page.panel_title = any(&Panel::title) ? panel_title_height : 0;
    page.caption = any(&Panel::caption) ? caption_height : 0;
    return page;
}

struct Lettering {
    double size = 13;  // px
    std::string_view colour = ink;
    std::string_view weight = "normal", anchor = "start";
};

std::string words(double x, double y, std::string_view text, const Lettering& letters) {
    if (text.empty()) return "";
    return fmt::format(
        "<text x=\"{}\" y=\"{}\" font-size=\"{}\" font-weight=\"{}\" fill=\"{}\" "
        "text-anchor=\"{}\">{}</text>\n",
        decimal(x), decimal(y), decimal(letters.size), letters.weight, letters.colour,
        letters.anchor, escaped(text));
}

std::string panel_at(double left, const Panel& panel, const Page& page) {
    const double top = page.panels_top();
    const Frame inside{left + padding / 2, top + padding / 2, page.panel_width - padding,
                       page.panel_height - padding};
    return words(left + 2, top - 11, panel.title, {.size = 16, .weight = "600"}) +
           fmt::format(
               "<rect x=\"{}\" y=\"{}\" width=\"{}\" height=\"{}\" rx=\"6\" "
               "fill=\"#fbfaf7\" stroke=\"#e4e0d8\"/>\n",
               decimal(left), decimal(top), decimal(page.panel_width), decimal(page.panel_height)) +
           drawing(panel.layer, inside, page.scale) +
           words(left + 2, top + page.panel_height + 21, panel.caption,
                 {.size = 14, .colour = faint_ink});
}

std::string sample(double x, double y, const Look& look) {
    if (look.role == Role::travel)
        return fmt::format(
            "<path d=\"M{} {}h26\" stroke=\"{}\" stroke-width=\"1\" "
            "stroke-dasharray=\"4 3\"/>\n",
            decimal(x), decimal(y), look.body);
    const std::string line =
        fmt::format("<path d=\"M{} {}h18\" stroke-linecap=\"round\" ", decimal(x + 4), decimal(y));
    return fmt::format(
        "{0}stroke=\"{1}\" stroke-width=\"9\"/>\n{0}stroke=\"{2}\" "
        "stroke-width=\"7\"/>\n",
        line, look.edge, look.body);
}

// The roles that occur, the outermost first.
std::string legend(std::span<const Panel> panels, const Page& page) {
    constexpr double sample_width = 34, letter_width = 7, between = 20;  // px, a little generous
    const double y = page.legend_top() + legend_height / 2;
    double x = margin + 2;
    std::string svg;
    for (auto row = looks.rbegin(); row != looks.rend(); ++row) {
        const Look& look = *row;
        const bool occurs = std::ranges::any_of(panels, [&](const Panel& panel) {
            return std::ranges::any_of(panel.layer, [&](const Path& path) {
                return path.role == look.role && is_drawn(path);
            });
        });
        if (!occurs) continue;
        svg += sample(x, y, look);
        svg += words(x + sample_width, y + 4.5, look.name, {});
        x += sample_width + letter_width * double(look.name.size()) + between;
    }
    return svg;
}

// The longest of 1, 2, 5, 10, 20, 50 … mm that is no longer than `longest` (mm).
double round_length(double longest) {
    const double power = std::pow(10, std::floor(std::log10(longest)));
    for (const double digit : {5.0, 2.0})
        if (digit * power <= longest) return digit * power;
    return power;
}

std::string scale_bar(const Page& page) {
    const double length = round_length(longest_bar / page.scale);
    const double right = page_width - margin - 2, left = right - length * page.scale;
    const double y = page.legend_top() + legend_height / 2;
    return fmt::format(
               "<path d=\"M{0} {2}v8M{0} {3}H{1}M{1} {2}v8\" fill=\"none\" stroke=\"{4}\" "
               "stroke-width=\"1.5\"/>\n",
               decimal(left), decimal(right), decimal(y - 4), decimal(y), ink) +
           words(left - 10, y + 4.5, decimal(length) + " mm", {.anchor = "end"});
}

}  // namespace

std::string layer_picture(std::span<const Panel> panels, const std::string& title) {
    const Page page = page_for(panels, title);
    std::string svg = fmt::format(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{0}\" height=\"{1}\" "
        "viewBox=\"0 0 {0} {1}\" font-family=\"Helvetica, Arial, 'DejaVu Sans', sans-serif\">\n"
        "<rect width=\"{0}\" height=\"{1}\" fill=\"#ffffff\"/>\n",
        decimal(page_width), decimal(page.height()));
    svg += words(margin + 2, margin + 20, title, {.size = 22, .weight = "600"});
    double left = margin;
    for (const Panel& panel : panels) {
        svg += panel_at(left, panel, page);
        left += page.panel_width + gap;
    }
    return svg + legend(panels, page) + scale_bar(page) + "</svg>\n";
}

}  // namespace bead
