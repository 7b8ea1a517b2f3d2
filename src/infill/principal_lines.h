// Lines along the principal directions of a tensor field, traced by Runge and Kutta's method of
// fourth order with steps of one length. A direction has no sign: each stage takes the one that
// goes on as the stage before it went. The field is asked for tensors, never for angles, so that it
// may be interpolated.
//
//     const PrincipalTracer tracer(field, inset_region, {.step = 0.25, .scale = 3.5});
//     const std::optional<TracedLine> line = tracer.line({60, 15}, PrincipalFamily::first);
#pragma once
#include <cstdint>
#include <functional>
#include <optional>

#include "field/tensor.h"
#include "infill/edge_bands.h"

namespace bead {

using TensorField = std::function<PlaneTensor(Vec2)>;

enum class PrincipalFamily : std::uint8_t { first, second };

// A unit vector along the family at a place; its sign is free.
inline Vec2 direction(PlaneTensor t, PrincipalFamily family) {
    const Vec2 first = unit(principal(t).angle);
    return family == PrincipalFamily::first ? first : left_of(first);
}

struct TraceOptions {
    double step = 0.25;       // mm
    double scale = 1;         // half the largest difference of principal values in the field
    double isotropic = 1e-3;  // of the scale: below it all directions are alike
    double longest = 2000;    // mm, each way
    // More reasons to stop, asked at every point but the seed; none if empty.
    std::function<bool(Vec2)> stop{};
};

enum class TraceEnd : std::uint8_t {
    boundary,   // on the region's edge, exactly
    isotropic,  // at a point without direction, or where the stages disagree
    closed,     // back where it began
    stopped,    // by the option
    too_long,
};

struct TracedLine {
    Polyline points;  // closed lines repeat their first point
    TraceEnd begin = TraceEnd::boundary, end = TraceEnd::boundary;
};

class PrincipalTracer {
  public:
    PrincipalTracer(TensorField field, const Region& region, TraceOptions options);

    // Through the seed, both ways. Nothing if it lies outside, or where there is no direction.
    [[nodiscard]] std::optional<TracedLine> line(Vec2 seed, PrincipalFamily family) const;
    [[nodiscard]] bool contains(Vec2 p) const { return edges_.contains(p); }

  private:
    struct Half {
        Polyline points;  // after the seed
        TraceEnd end = TraceEnd::too_long;
    };
    [[nodiscard]] std::optional<Vec2> way_at(Vec2 p, Vec2 before, PrincipalFamily family) const;
    [[nodiscard]] std::optional<Vec2> runge_kutta(Vec2 p, Vec2 before, PrincipalFamily family,
                                                  double h) const;
    [[nodiscard]] bool leaves(Vec2 from, Vec2 to) const;
    [[nodiscard]] Vec2 end_on_edge(Vec2 at, Vec2 way, PrincipalFamily family) const;
    [[nodiscard]] std::optional<Vec2> crossing(Vec2 from, Vec2 to) const;
    [[nodiscard]] Half half(Vec2 seed, Vec2 way, PrincipalFamily family) const;

    TensorField field_;
    EdgeBands edges_;
    TraceOptions options_;
};

}  // namespace bead
