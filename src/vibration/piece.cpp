#include "vibration/piece.h"

namespace bead {
namespace {

constexpr double no_way = 1e-7;  // mm, below this nothing moves

class Joining {
  public:
    void add(Vec2 to, const Piece& like) {
        if (!started_) at_ = to;
        started_ = true;
        if (distance(at_, to) < no_way) return;
        pieces_.push_back({at_, to, like.feed, like.acceleration, like.flow});
        at_ = to;
    }
    std::vector<Piece> take() { return std::move(pieces_); }

  private:
    std::vector<Piece> pieces_;
    Vec2 at_;
    bool started_ = false;
};

}  // namespace

std::vector<Piece> pieces_of(const Toolpath& toolpath, double travel_speed) {
    Joining joining;
    const Piece travel{.feed = travel_speed};
    for (const Path& path : toolpath) {
        if (path.points.empty()) continue;
        const bool prints = path.role != Role::travel;
        const Piece like{.feed = path.speed > 0 ? path.speed : travel_speed,
                         .acceleration = path.acceleration,
                         .flow = prints ? section(path.bead) : 0};
        joining.add(flat(path.points.front()), travel);
        for (const Vec3& point : path.points) joining.add(flat(point), like);
    }
    return joining.take();
}

}  // namespace bead
