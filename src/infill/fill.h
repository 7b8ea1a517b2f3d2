// Fills a region with lines: one file per pattern, one row per pattern in `patterns`.
//
//     const std::vector<Polyline> lines = rectilinear(region, {.spacing = 2.25, .angle = pi / 4});
#pragma once
#include <array>
#include <string_view>
#include <vector>

#include "geom/polygon.h"

namespace bead {

struct FillOptions {
    double spacing = 2;  // mm between lines; curves lay as much line per area
    double angle = 0;    // rad, of the lines (of the curve's axes) from +X
    double link = 1e9;   // mm, longest way along the region's edge that joins the ends of two lines
    Vec2 centre{};  // of the curves, and where lines are counted from: the part's, not the layer's
    double height = 0;  // mm, of the layer: for patterns that change with it
};

// `region` is where centre lines may run; every point of the result lies in it (to 1 µm). Lines lie
// where centre, angle and spacing say, whatever the region (but for concentric), so that layers
// stack. Away from the edge there is 1 / spacing of line per area; links come on top, so a caller
// who wants an exact volume measures the length and corrects the spacing. Closed lines repeat their
// first point. An empty region, or one too small for the pattern, gives no lines.
using Pattern = std::vector<Polyline> (*)(const Region& region, const FillOptions& options);

std::vector<Polyline> rectilinear(const Region& region, const FillOptions& options);
std::vector<Polyline> concentric(const Region& region, const FillOptions& options);
std::vector<Polyline> hilbert(const Region& region, const FillOptions& options);
std::vector<Polyline> archimedean(const Region& region, const FillOptions& options);
std::vector<Polyline> octagram(const Region& region, const FillOptions& options);
std::vector<Polyline> separate_lines(const Region& region, const FillOptions& options);
std::vector<Polyline> grid(const Region& region, const FillOptions& options);
std::vector<Polyline> triangles(const Region& region, const FillOptions& options);
std::vector<Polyline> tri_hexagon(const Region& region, const FillOptions& options);
std::vector<Polyline> cross_curve(const Region& region, const FillOptions& options);
std::vector<Polyline> gyroid(const Region& region, const FillOptions& options);

struct NamedPattern {
    std::string_view name;
    Pattern make;
    bool has_direction;        // whether its lines mostly run one way, so that layers must cross
    double symmetry;           // rad, turning by this gives the same family of lines (pi: lines)
    std::string_view about;    // for --help
    bool keeps_angle = false;  // on odd layers too, where skin and all other patterns turn by 90°
};
// New ones come last: published experiments and the search's usual candidates are the first five.
inline constexpr std::array patterns{
    NamedPattern{"rectilinear", rectilinear, true, pi,
                 "straight lines, ends linked along the wall"},
    NamedPattern{"concentric", concentric, false, 2 * pi,
                 "copies of the outline, one inside the other"},
    NamedPattern{"hilbert", hilbert, false, pi / 2,
                 "Hilbert's curve: one line of short right-angled steps"},
    NamedPattern{"archimedean", archimedean, false, 2 * pi, "a spiral of even pitch, in chords"},
    NamedPattern{"octagram", octagram, false, pi / 4, "nested eight-pointed stars, joined"},
    NamedPattern{"line", separate_lines, true, pi, "straight lines, each by itself"},
    NamedPattern{"grid", grid, false, pi / 2, "lines both ways in every layer: squares"},
    NamedPattern{"triangles", triangles, false, pi / 3, "lines three ways: equal triangles", true},
    NamedPattern{"tri-hexagon", tri_hexagon, false, pi / 3,
                 "lines three ways: hexagons with triangles between", true},
    NamedPattern{"cross", cross_curve, false, pi / 2,
                 "Sierpinski's curve: crosses of short steps, nowhere a long line"},
    NamedPattern{"gyroid", gyroid, false, 2 * pi, "waves that turn with the height", true},
};
inline constexpr std::size_t usual_patterns = 5;  // the first ones

}  // namespace bead
