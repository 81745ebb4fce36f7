// SPDX-License-Identifier: LGPL-2.1-or-later
#include "contour/crossings.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>

namespace thicken::contour {

using field::KeyIndex;
using field::Membership;
using field::NodeField;
using field::Probe;
using field::Standing;
using field::SurfaceCrossing;
using field::UniformGrid;

namespace {

constexpr double kEndOfSearch = 1.0 / 128;  // of a cell
constexpr double kCloseEnough = 1e-4;       // of r
constexpr double kNear = 2e-3;              // of r
constexpr double kSteep = 0.25;             // distance from S per way along an edge
constexpr int kMostSteps = 12;

// Closes in on one crossing along its edge.
class CrossingSolver {
 public:
  CrossingSolver(const UniformGrid& grid, const NodeField& field, const Membership& membership)
      : grid_(grid), field_(field), membership_(membership) {}

  [[nodiscard]] Crossing solve(const EdgePart& part) const {
    Search s{static_cast<int>(part.edge & 3), grid_.node(UniformGrid::indexOf(part.edge >> 2))};
    const bool leaves = part.jump < 0;
    s.in = end(s, leaves ? part.from : part.to, leaves ? part.fromNode : part.toNode);
    s.out = end(s, leaves ? part.to : part.from, leaves ? part.toNode : part.fromNode);
    // The ends may lie on the carrier itself, where the probe's sign is rounding.
    if (!s.in.probe.inside()) s.in.probe.standing = Standing::kInside;
    const bool onShell = s.out.probe.standing == Standing::kFar && narrowToShell(s);
    if (!onShell) narrow(s);
    s.p[s.axis] = (s.in.x + s.out.x) / 2;
    Crossing c;
    c.edge = part.edge;
    c.jump = static_cast<std::int8_t>(part.jump);
    c.at = s.p;
    c.beyond = s.out.probe.inside() ? Standing::kFar : s.out.probe.standing;
    c.normal = normalOf(c, s);
    return c;
  }

 private:
  struct End {
    double x = 0;
    Probe probe;  ///< without `closest` where it comes from the field
    bool whole = false;
  };
  struct Search {
    int axis;
    Vec3 p;
    End in{}, out{};
  };

  [[nodiscard]] End probeAt(Search& s, double x) const {
    s.p[s.axis] = x;
    return {x, membership_.probe(s.p), true};
  }

  [[nodiscard]] End end(Search& s, double x, std::uint32_t node) const {
    if (node == KeyIndex::kAbsent) return probeAt(s, x);
    const NodeField::Sample& sample = field_[node];
    End e{x, {}, false};
    e.probe.standing = sample.standing;
    e.probe.excess = sample.excess;
    return e;
  }

  // Newton's steps on the distance from S, which is smooth where the shell is; secants where they leave
  // the bracket. False where the outer end turns out to be something else than too far.
  [[nodiscard]] bool narrowToShell(Search& s) const {
    double x = secant(s);
    for (int step = 0; step < kMostSteps; ++step) {
      const End e = probeAt(s, x);
      const Standing standing = e.probe.standing;
      if (standing != Standing::kInside && standing != Standing::kFar) {
        s.out = e;
        return false;
      }
      (e.probe.inside() ? s.in : s.out) = e;
      const double miss = e.probe.excess, r = e.probe.thickness;
      if (std::abs(miss) < kCloseEnough * r) {
        s.in = s.out = e;
        s.out.probe.standing = Standing::kFar;
        return true;
      }
      if (std::abs(s.out.x - s.in.x) < kEndOfSearch * grid_.width()) return true;
      const double slope = (s.p[s.axis] - e.probe.closest[s.axis]) / e.probe.distance - e.probe.slope[s.axis];
      x -= miss / slope;
      const double low = std::min(s.in.x, s.out.x), high = std::max(s.in.x, s.out.x);
      // One more step of this size needs no look at where it leads: what is left is its square, in r.
      if (std::abs(miss) < kNear * r && std::abs(slope) > kSteep && x >= low && x <= high) {
        s.in = s.out = {x, e.probe, true};
        s.out.probe.standing = Standing::kFar;
        return true;
      }
      if (!(x > low && x < high)) x = step % 3 == 2 ? (s.in.x + s.out.x) / 2 : secant(s);
    }
    return true;
  }

  [[nodiscard]] double secant(const Search& s) const {
    const double in = s.in.probe.excess, out = s.out.probe.excess;
    const double share = in < 0 && out > 0 ? std::clamp(in / (in - out), 0.02, 0.98) : 0.5;
    return s.in.x + share * (s.out.x - s.in.x);
  }

  // Where the closest point jumps from one place of S to another: the bisector of the two places, and
  // halving where that does not close in.
  void narrow(Search& s) const {
    for (int step = 0; step < kMostSteps && std::abs(s.out.x - s.in.x) > kEndOfSearch * grid_.width();
         ++step) {
      double x = (s.in.x + s.out.x) / 2;
      if (s.in.whole && s.out.whole && step % 3 != 2) {
        const double target = bisector(s);
        const double low = std::min(s.in.x, s.out.x), high = std::max(s.in.x, s.out.x);
        const double margin = kEndOfSearch * grid_.width() / 4;
        // A step to the side of the farther end, so that both ends close in.
        const double side = std::abs(target - s.in.x) < std::abs(target - s.out.x) ? margin : -margin;
        const double next = target + (s.out.x > s.in.x ? side : -side);
        if (next > low && next < high) x = next;
      }
      const End e = probeAt(s, x);
      (e.probe.inside() ? s.in : s.out) = e;
    }
  }

  // The coordinate at which both ends' closest points are equally far.
  [[nodiscard]] static double bisector(const Search& s) {
    const Vec3 &a = s.in.probe.closest, &b = s.out.probe.closest;
    Vec3 q = s.p;
    q[s.axis] = 0;
    const double across = 2 * (b[s.axis] - a[s.axis]);
    return across == 0 ? std::numeric_limits<double>::infinity()
                       : ((q - b).squaredNorm() - (q - a).squaredNorm()) / across;
  }

  [[nodiscard]] Vec3 normalOf(const Crossing& c, Search& s) const {
    if (c.beyond == Standing::kRim) return Vec3::Zero();
    if (!s.in.whole) s.in.probe = probeAt(s, s.in.x).probe;
    if (c.beyond == Standing::kFar) {
      const Probe& in = s.in.probe;
      return (c.at - in.closest - in.distance * in.slope).stableNormalized();
    }
    if (!s.out.whole) s.out.probe = probeAt(s, s.out.x).probe;
    const Vec3 across = s.out.probe.closest - s.in.probe.closest;  // halfway between two sheets
    constexpr double kApart = 0.5;
    return across.norm() > kApart * s.in.probe.distance ? across.stableNormalized() : Vec3::Zero();
  }

  const UniformGrid& grid_;
  const NodeField& field_;
  const Membership& membership_;
};

}  // namespace

void crossEdge(const UniformGrid& grid, const NodeField& field, std::uint64_t edge, std::uint32_t low,
               std::uint32_t high, std::span<const SurfaceCrossing> carrier, std::vector<EdgePart>& out) {
  const bool first = field[low].inside(), last = field[high].inside();
  if (carrier.empty() && first == last) return;
  const int axis = static_cast<int>(edge & 3);
  const int n = UniformGrid::indexOf(edge >> 2)[axis];
  EdgePart part;
  part.edge = edge;
  part.from = grid.coordinate(axis, n);
  part.fromNode = low;
  bool label = first;
  const auto endAt = [&](double to, std::uint32_t toNode, bool end) {
    part.to = to;
    part.toNode = toNode;
    part.jump = int(end) - int(label);
    if (label != end) out.push_back(part);
    part.from = to;
    part.fromNode = toNode;
  };
  for (const SurfaceCrossing& s : carrier) {
    endAt(s.at, KeyIndex::kAbsent, s.jump < 0);
    label = s.jump > 0;
  }
  endAt(grid.coordinate(axis, n + 1), high, last);
}

Crossing placed(const EdgePart& part, const UniformGrid& grid, const NodeField& field,
                const Membership& membership) {
  return CrossingSolver(grid, field, membership).solve(part);
}

}  // namespace thicken::contour
