#include "infill/spaced_lines.h"

#include <algorithm>
#include <cmath>

namespace bead {
namespace {

constexpr double nearly = 0.98;  // of the spacing, that a seed must keep

// Points in buckets: is one nearer than …?
class Crowd {
  public:
    Crowd(const Box2& box, double bucket) : low_(box.low), bucket_(bucket) {
        columns_ = static_cast<long>(box.size().x / bucket) + 1;
        rows_ = static_cast<long>(box.size().y / bucket) + 1;
        buckets_.resize(static_cast<std::size_t>(columns_ * rows_));
    }
    void add(Vec2 p) { buckets_[at(column(p), row(p))].push_back(p); }
    [[nodiscard]] bool is_near(Vec2 p, double reach) const {
        const long wide = static_cast<long>(std::ceil(reach / bucket_));
        for (long j = std::max(row(p) - wide, 0L); j <= std::min(row(p) + wide, rows_ - 1); ++j)
            for (long i = std::max(column(p) - wide, 0L);
                 i <= std::min(column(p) + wide, columns_ - 1); ++i)
                for (const Vec2 q : buckets_[at(i, j)])
                    if (distance(p, q) < reach) return true;
        return false;
    }

  private:
    [[nodiscard]] long column(Vec2 p) const {
        return std::clamp(static_cast<long>((p.x - low_.x) / bucket_), 0L, columns_ - 1);
    }
    [[nodiscard]] long row(Vec2 p) const {
        return std::clamp(static_cast<long>((p.y - low_.y) / bucket_), 0L, rows_ - 1);
    }
    [[nodiscard]] std::size_t at(long i, long j) const {
        return static_cast<std::size_t>(j * columns_ + i);
    }

    Vec2 low_;
    double bucket_;
    long columns_ = 1, rows_ = 1;
    std::vector<std::vector<Vec2>> buckets_;
};

class Spacer {
  public:
    Spacer(const TensorField& field, const Region& region, PrincipalFamily family,
           const SpacedOptions& options)
        : options_(options),
          family_(family),
          crowd_(bounds(region), options.largest / 4),
          tracer_(field, region, stopping(options.trace)) {}

    void grow_from(Vec2 seed) {
        if (!try_at(seed)) return;
        for (std::size_t next = lines_.size() - 1; next < lines_.size(); ++next) {
            const Polyline parent = lines_[next];
            for (std::size_t i = 1; i + 1 < parent.size(); i += 4) {
                const Vec2 way = parent[i + 1] - parent[i - 1];
                const Vec2 aside = left_of(way) / std::max(length(way), 1e-9);
                for (const double sign : {1.0, -1.0})
                    try_at(parent[i] + sign * options_.spacing(parent[i]) * aside);
            }
        }
    }
    std::vector<Polyline> lines() && { return std::move(lines_); }

  private:
    TraceOptions stopping(TraceOptions trace) {
        trace.stop = [this](Vec2 p) {
            return crowd_.is_near(p, options_.end_at * options_.spacing(p));
        };
        return trace;
    }

    bool try_at(Vec2 seed) {
        if (!tracer_.contains(seed) || crowd_.is_near(seed, nearly * options_.spacing(seed)))
            return false;
        const std::optional<TracedLine> line = tracer_.line(seed, family_);
        if (!line || length(line->points) < options_.shortest) return false;
        for (const Vec2 p : line->points) crowd_.add(p);
        lines_.push_back(line->points);
        return true;
    }

    SpacedOptions options_;
    PrincipalFamily family_;
    Crowd crowd_;
    PrincipalTracer tracer_;
    std::vector<Polyline> lines_;
};

}  // namespace

std::vector<Polyline> spaced_lines(const TensorField& field, const Region& region,
                                   PrincipalFamily family, const std::vector<Vec2>& seeds,
                                   const SpacedOptions& options) {
    Spacer spacer(field, region, family, options);
    for (const Vec2 seed : seeds) spacer.grow_from(seed);
    return std::move(spacer).lines();
}

}  // namespace bead
