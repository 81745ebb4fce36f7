// SPDX-License-Identifier: LGPL-2.1-or-later
#include "trim/plane_cut.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <optional>

namespace thicken::trimming {

using mesh::kNone;

namespace {

// A cut that is longer than this many times the distance of its ends is no way between them: a half circle
// takes 1.6, the way over a ridge as high as it is wide 3.
constexpr double kLongestDetour = 4;

// A path that is met after a way of more than this many times the distance of the ends was not between them:
// the cut leads elsewhere, such as to the other side of a plate.
constexpr double kLongestDirect = 1.5;

// How far `p` is from the line through a and b.
double heightOver(const Vec3& a, const Vec3& b, const Vec3& p) {
  const double length = (b - a).norm();
  return length > 0 ? (b - a).cross(p - a).norm() / length : (p - a).norm();
}

class Cut {
 public:
  Cut(const DividedSurface& surface, const PathMarks& marks, VertexId from, VertexId to, const Vec3& up,
      double tolerance)
      : surface_(surface),
        marks_(marks),
        from_(from),
        to_(to),
        origin_(surface.at(from)),
        ahead_(surface.at(to) - origin_),
        right_(ahead_.cross(up).stableNormalized()),
        tolerance_(tolerance),
        last_(origin_) {}

  Way follow() {
    std::optional<VertexId> at = from_;
    while (at && way_.end != WayEnd::kArrived) at = leave(*at);
    return std::move(way_);
  }

 private:
  // The signed distance from the plane. The cut leads forward where what is right of it has values of at
  // least 0 and what is left of it has others.
  [[nodiscard]] double side(VertexId v) const { return (surface_.at(v) - origin_).dot(right_); }

  std::nullopt_t stop(WayEnd end, const Vec3& place, VertexId met = kNone) {
    const bool isElsewhere = length_ > kLongestDirect * ahead_.norm();
    const bool isPath = end == WayEnd::kCrosses || end == WayEnd::kTouches;
    way_.end = isPath && isElsewhere ? WayEnd::kStrays : end;
    way_.place = place;
    way_.met = met;
    return std::nullopt;
  }

  // Adds a point; false where the way has become too long.
  bool add(WayPoint point) {
    length_ += (point.place - last_).norm();
    last_ = point.place;
    way_.points.push_back(std::move(point));
    if (length_ <= kLongestDetour * ahead_.norm() + 4 * tolerance_) return true;
    stop(WayEnd::kStrays, last_);
    return false;
  }

  std::optional<VertexId> arriveAt(VertexId v) {
    if (v == to_) {
      way_.points.push_back({v, {}, surface_.at(v)});
      way_.end = WayEnd::kArrived;
      return v;
    }
    if (v == from_) return stop(WayEnd::kStrays, surface_.at(v));  // once around
    if (marks_.hasVertex(v)) return stop(WayEnd::kTouches, surface_.at(v), v);
    if (std::find(passed_.begin(), passed_.end(), v) != passed_.end())
      return stop(WayEnd::kStrays, surface_.at(v));
    passed_.push_back(v);
    if (!add({v, {}, surface_.at(v)})) return std::nullopt;
    return v;
  }

  // From a vertex to the next one on the way.
  std::optional<VertexId> leave(VertexId v) {
    std::optional<EdgeOf> best;
    double bestAhead = 0;
    for (const EdgeOf& e : surface_.linkOf(v)) {
      const VertexId right = surface_.from(e), left = surface_.to(e);
      if (right == to_ || left == to_) return arriveAt(to_);
      if (!(side(right) >= 0 && side(left) < 0)) continue;
      const double ahead = (crossing(right, left) - surface_.at(v)).stableNormalized().dot(ahead_);
      if (best && ahead <= bestAhead) continue;
      best = e;
      bestAhead = ahead;
    }
    if (!best) return stop(WayEnd::kLeaves, surface_.at(v));
    return passEdges(*best);
  }

  [[nodiscard]] Vec3 crossing(VertexId right, VertexId left) const {
    const double r = side(right), l = side(left);
    return surface_.at(right) + r / (r - l) * (surface_.at(left) - surface_.at(right));
  }

  // From triangle to triangle, beginning across the edge `e`, to the next vertex on the way.
  std::optional<VertexId> passEdges(EdgeOf e) {
    for (;;) {
      const VertexId right = surface_.from(e), left = surface_.to(e);
      const Vec3 x = crossing(right, left);
      if (const VertexId v = near(x, right, left); v != kNone) return arriveAt(v);
      if (marks_.hasEdge(right, left)) return stop(WayEnd::kCrosses, x, right);
      const EdgeOf back = surface_.twin(e);
      if (back.triangle == kNone) return stop(WayEnd::kLeaves, x);
      if (!add({kNone, {right, left}, x})) return std::nullopt;
      const VertexId third = surface_.opposite(back);
      if (third == to_) return arriveAt(third);
      // `back` leads from left to right; the edge after it from right to the third corner.
      e = {back.triangle, (back.corner + (side(third) < 0 ? 1 : 2)) % 3};
    }
  }

  // The end of an edge that the way, which comes from the last point to `x`, passes within the tolerance.
  [[nodiscard]] VertexId near(const Vec3& x, VertexId right, VertexId left) const {
    const double r = std::min((surface_.at(right) - x).norm(), heightOver(last_, x, surface_.at(right)));
    const double l = std::min((surface_.at(left) - x).norm(), heightOver(last_, x, surface_.at(left)));
    if (std::min(r, l) > tolerance_) return kNone;
    return r <= l ? right : left;
  }

  const DividedSurface& surface_;
  const PathMarks& marks_;
  VertexId from_, to_;
  Vec3 origin_, ahead_, right_;
  double tolerance_;
  Vec3 last_;
  double length_ = 0;
  std::vector<VertexId> passed_;
  Way way_;
};

}  // namespace

Way planeCut(const DividedSurface& surface, const PathMarks& marks, VertexId from, VertexId to,
             const Vec3& up, double tolerance) {
  return Cut(surface, marks, from, to, up, tolerance).follow();
}

}  // namespace thicken::trimming
