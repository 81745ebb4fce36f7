// SPDX-License-Identifier: LGPL-2.1-or-later
#include "contour/crossings.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "parallel_for.h"

namespace thicken {

namespace {

// Splits one edge at the carrier's crossings; where the labels of a part's ends differ, it crosses.
void crossEdge(const UniformGrid& grid, const Labels& labels, std::uint64_t edge,
               std::span<const SurfaceCrossing> carrier, std::vector<Crossing>& out) {
  const int axis = static_cast<int>(edge & 3);
  const GridIndex n = UniformGrid::indexOf(edge >> 2);
  GridIndex up = n;
  ++up[axis];
  bool label = labels.inside(n);
  double from = grid.coordinate(axis, n[axis]);
  const auto part = [&](double to, bool end) {
    if (label != end) {
      Crossing c;
      c.edge = edge;
      c.jump = int(end) - int(label);
      c.from = from;
      c.to = to;
      out.push_back(c);
    }
    from = to;
  };
  for (const SurfaceCrossing& s : carrier) {
    part(s.at, s.jump < 0);
    label = s.jump > 0;
  }
  part(grid.coordinate(axis, up[axis]), labels.inside(up));
}

class CrossingSolver {
 public:
  CrossingSolver(const UniformGrid& grid, const Membership& membership)
      : grid_(grid), membership_(membership) {}

  void solve(Crossing& c) const {
    const int axis = static_cast<int>(c.edge & 3);
    Vec3 p = grid_.node(UniformGrid::indexOf(c.edge >> 2));
    const auto probe = [&](double x) {
      p[axis] = x;
      return membership_.probe(p);
    };
    double in = c.jump < 0 ? c.from : c.to, out = c.jump < 0 ? c.to : c.from;
    Probe inner = probe(in), outer = probe(out);
    // The ends may lie on the carrier itself, where the probe's sign is rounding.
    if (!inner.inside()) inner.standing = Standing::kInside;
    const double small = kEndOfSearch * grid_.width();
    for (int step = 0; step < kMostSteps && std::abs(out - in) > small; ++step) {
      double share = 0.5;
      const double fIn = inner.distance - membership_.thickness();
      const double fOut = outer.distance - membership_.thickness();
      if (outer.standing == Standing::kFar && fIn < 0 && fOut > 0 && step % 3 != 2)
        share = std::clamp(fIn / (fIn - fOut), 0.02, 0.98);
      const double x = in + share * (out - in);
      const Probe middle = probe(x);
      if (middle.standing != Standing::kFront && middle.standing != Standing::kRim &&
          std::abs(middle.distance - membership_.thickness()) < kCloseEnough * membership_.thickness()) {
        in = out = x;
        inner = outer = middle;
        outer.standing = Standing::kFar;
        break;
      }
      (middle.inside() ? in : out) = x;
      (middle.inside() ? inner : outer) = middle;
    }
    p[axis] = (in + out) / 2;
    c.at = p;
    c.beyond = outer.inside() ? Standing::kFar : outer.standing;
    c.normal = normalOf(c, inner, outer);
  }

 private:
  static constexpr double kEndOfSearch = 1.0 / 128;  // of a cell
  static constexpr double kCloseEnough = 1e-5;       // of r
  static constexpr int kMostSteps = 12;

  [[nodiscard]] Vec3 normalOf(const Crossing& c, const Probe& inner, const Probe& outer) const {
    if (c.beyond == Standing::kFar) return (c.at - inner.closest).stableNormalized();
    if (c.beyond == Standing::kRim) return Vec3::Zero();
    const Vec3 across = outer.closest - inner.closest;  // halfway between two sheets
    constexpr double kApart = 0.5;
    return across.norm() > kApart * inner.distance ? across.stableNormalized() : Vec3::Zero();
  }

  const UniformGrid& grid_;
  const Membership& membership_;
};

}  // namespace

std::vector<Crossing> findCrossings(const UniformGrid& grid, const Labels& labels,
                                    const std::vector<SurfaceCrossing>& carrier, const RunContext& context,
                                    int threads) {
  const std::vector<std::uint64_t> edges = labels.boundaryEdges(context, threads);
  std::vector<Crossing> crossings;
  std::size_t e = 0, s = 0;
  while (e < edges.size() || s < carrier.size()) {
    const bool fromCarrier = e == edges.size() || (s < carrier.size() && carrier[s].edge <= edges[e]);
    const std::uint64_t edge = fromCarrier ? carrier[s].edge : edges[e];
    const std::size_t begin = s;
    while (s < carrier.size() && carrier[s].edge == edge) ++s;
    while (e < edges.size() && edges[e] == edge) ++e;
    crossEdge(grid, labels, edge, std::span(carrier).subspan(begin, s - begin), crossings);
  }
  return crossings;
}

void placeCrossings(std::vector<Crossing>& crossings, const UniformGrid& grid, const Membership& membership,
                    const RunContext& context, int threads) {
  const CrossingSolver solver(grid, membership);
  parallelFor(crossings.size(), threads, context, 64, [&](std::size_t i) { solver.solve(crossings[i]); });
}

}  // namespace thicken
