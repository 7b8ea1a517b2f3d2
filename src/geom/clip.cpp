#include "geom/clip.h"

#include <map>
#include <polyclipping/clipper.hpp>

#include "core/expects.h"

namespace bead {
namespace {

namespace cl = ClipperLib;

constexpr double units_per_mm = 1e6;  // 1 nm
constexpr double largest_mm = 4e6;    // Clipper's 64-bit range, with room for offsets
// Where edges nearly coincide Clipper leaves loops of no area, some of them wound the wrong way,
// which its offset would take for the sign that all are.
constexpr double least_area = 1e-4;  // mm²
constexpr double arc_tolerance = 2e-3 * units_per_mm;

cl::IntPoint to_units(Vec2 p) {
    BEAD_EXPECTS(std::abs(p.x) < largest_mm && std::abs(p.y) < largest_mm);
    return {static_cast<cl::cInt>(std::llround(p.x * units_per_mm)),
            static_cast<cl::cInt>(std::llround(p.y * units_per_mm))};
}

Vec2 from_units(const cl::IntPoint& p) {
    return {static_cast<double>(p.X) / units_per_mm, static_cast<double>(p.Y) / units_per_mm};
}

cl::Path to_path(const Polyline& line) {
    cl::Path path;
    path.reserve(line.size());
    for (const Vec2 p : line) path.push_back(to_units(p));
    return path;
}

Polyline from_path(const cl::Path& path) {
    Polyline line;
    line.reserve(path.size());
    for (const cl::IntPoint& p : path) line.push_back(from_units(p));
    return line;
}

cl::Paths to_paths(const std::vector<Polyline>& lines) {
    cl::Paths paths;
    paths.reserve(lines.size());
    for (const Polyline& line : lines) paths.push_back(to_path(line));
    return paths;
}

cl::Paths to_paths(const Region& region) {
    cl::Paths paths;
    for (const Polygon& polygon : region) {
        paths.push_back(to_path(polygon.outer));
        for (const Polyline& hole : polygon.holes) paths.push_back(to_path(hole));
    }
    return paths;
}

Region to_region(const cl::PolyTree& tree) {
    Region region;
    for (const cl::PolyNode* node = tree.GetFirst(); node != nullptr; node = node->GetNext()) {
        if (node->IsHole()) continue;
        Polygon polygon{from_path(node->Contour), {}};
        if (signed_area(polygon.outer) < least_area) continue;
        for (const cl::PolyNode* hole : node->Childs)
            polygon.holes.push_back(from_path(hole->Contour));
        region.push_back(std::move(polygon));
    }
    return region;
}

Region combined(const Region& a, const Region& b, cl::ClipType how) {
    cl::Clipper clipper;
    clipper.AddPaths(to_paths(a), cl::ptSubject, true);
    clipper.AddPaths(to_paths(b), cl::ptClip, true);
    cl::PolyTree tree;
    clipper.Execute(how, tree, cl::pftNonZero, cl::pftNonZero);
    return to_region(tree);
}

std::vector<Polyline> cut(const std::vector<Polyline>& lines, const Region& region,
                          cl::ClipType how) {
    cl::Clipper clipper;
    clipper.AddPaths(to_paths(lines), cl::ptSubject, false);
    clipper.AddPaths(to_paths(region), cl::ptClip, true);
    cl::PolyTree tree;
    clipper.Execute(how, tree, cl::pftNonZero, cl::pftNonZero);
    cl::Paths parts;
    cl::OpenPathsFromPolyTree(tree, parts);
    std::vector<Polyline> result;
    result.reserve(parts.size());
    for (const cl::Path& part : parts) result.push_back(from_path(part));
    return result;
}

}  // namespace

Region united(const Region& a, const Region& b) { return combined(a, b, cl::ctUnion); }
Region intersection(const Region& a, const Region& b) { return combined(a, b, cl::ctIntersection); }
Region difference(const Region& a, const Region& b) { return combined(a, b, cl::ctDifference); }

Region region_of(const std::vector<Polyline>& loops, FillRule fill) {
    const cl::PolyFillType rule = fill == FillRule::even_odd ? cl::pftEvenOdd : cl::pftPositive;
    cl::Clipper clipper;
    clipper.AddPaths(to_paths(loops), cl::ptSubject, true);
    cl::PolyTree tree;
    clipper.Execute(cl::ctUnion, tree, rule, rule);
    return to_region(tree);
}

Region offset(const Region& region, double distance, Corner corner) {
    constexpr double miter_limit = 2;
    cl::ClipperOffset clipper(miter_limit, arc_tolerance);
    clipper.AddPaths(to_paths(region), corner == Corner::miter ? cl::jtMiter : cl::jtRound,
                     cl::etClosedPolygon);
    cl::PolyTree tree;
    clipper.Execute(tree, distance * units_per_mm);
    return to_region(tree);
}

Region opened(const Region& region, double radius) {
    return offset(offset(region, -radius), radius);
}

Region covered_by(const std::vector<WideLine>& lines, Corner corner) {
    constexpr double miter_limit = 2;
    std::map<double, std::vector<const WideLine*>> by_width;
    for (const WideLine& line : lines) by_width[line.width].push_back(&line);
    cl::Clipper all;
    for (const auto& [width, alike] : by_width) {
        cl::ClipperOffset clipper(miter_limit, arc_tolerance);
        for (const WideLine* line : alike) {
            const bool closed =
                line->points.size() > 3 && line->points.front() == line->points.back();
            cl::Path path = to_path(line->points);
            if (closed) path.pop_back();
            const cl::EndType end = closed                    ? cl::etClosedLine
                                    : corner == Corner::round ? cl::etOpenRound
                                                              : cl::etOpenButt;
            clipper.AddPath(path, corner == Corner::round ? cl::jtRound : cl::jtMiter, end);
        }
        cl::Paths bands;
        clipper.Execute(bands, width / 2 * units_per_mm);
        all.AddPaths(bands, cl::ptSubject, true);
    }
    cl::PolyTree tree;
    all.Execute(cl::ctUnion, tree, cl::pftPositive, cl::pftPositive);
    return to_region(tree);
}

std::vector<Polyline> inside_parts(const std::vector<Polyline>& lines, const Region& region) {
    return cut(lines, region, cl::ctIntersection);
}

std::vector<Polyline> outside_parts(const std::vector<Polyline>& lines, const Region& region) {
    return cut(lines, region, cl::ctDifference);
}

}  // namespace bead
