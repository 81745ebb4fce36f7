// SPDX-License-Identifier: LGPL-2.1-or-later
#include "exact/clear_fans.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>

#include "exact/predicates.h"
#include "mesh/topology.h"
#include "parallel/parallel_for.h"

namespace thicken::exact {
namespace {

// A triangle of a fan by its other corners, in its own order.
struct Blade {
  VertexId from, to;
};

// The triangles around one vertex.
class Fan {
 public:
  static constexpr std::size_t kMost = 24;  // triangles; larger fans are left to the tests of pairs

  explicit Fan(VertexId centre) : centre_(centre) {}

  void add(const Triangle& t) {
    const int k = t[0] == centre_ ? 0 : t[1] == centre_ ? 1 : 2;
    blades_[count_++] = {t[(k + 1) % 3], t[(k + 2) % 3]};
  }

  // Whether each blade ends where the next begins, and the last where the first does.
  [[nodiscard]] bool isClosed() {
    for (std::size_t i = 0; i + 1 < count_; ++i) {
      const auto next = std::find_if(blades_.begin() + i + 1, blades_.begin() + count_,
                                     [&](const Blade& b) { return b.from == blades_[i].to; });
      if (next == blades_.begin() + count_) return false;
      std::swap(*next, blades_[i + 1]);
    }
    return count_ > 2 && blades_[count_ - 1].to == blades_[0].from;
  }

  // Whether all blades face the same way along an axis and go round once.
  [[nodiscard]] bool liesSideBySide(std::span<const Vec3> positions) const {
    const int axis = widestAxis(positions);
    const int upward = axis == 0 ? 2 : axis - 1;  // the second coordinate that orientation2() looks at
    const double level = positions[centre_][upward];
    int sense = 0, passages = 0;
    for (std::size_t i = 0; i < count_; ++i) {
      const Vec3 &p = positions[blades_[i].from], &q = positions[blades_[i].to];
      const int s = orientation2(positions[centre_], p, q, axis);
      if (s == 0 || s == -sense) return false;
      sense = s;
      // A blade spans less than half a turn: of those that go from below to above, or the other way where
      // they turn clockwise, each passes one and the same ray.
      const bool fromBelow = p[upward] < level, toBelow = q[upward] < level;
      passages += fromBelow != toBelow && fromBelow == (s > 0);
    }
    return passages == 1;
  }

 private:
  // The axis that the fan is seen best along; any is a valid one.
  [[nodiscard]] int widestAxis(std::span<const Vec3> positions) const {
    const Vec3& o = positions[centre_];
    Vec3 normal = Vec3::Zero();
    for (std::size_t i = 0; i < count_; ++i)
      normal += (positions[blades_[i].from] - o).cross(positions[blades_[i].to] - o);
    int axis = 0;
    normal.cwiseAbs().maxCoeff(&axis);
    return axis;
  }

  VertexId centre_;
  std::size_t count_ = 0;
  std::array<Blade, kMost> blades_;
};

}  // namespace

bool isClearFan(std::span<const Vec3> positions, VertexId centre, std::span<const Triangle> triangles) {
  if (triangles.size() < 3 || triangles.size() > Fan::kMost) return false;
  Fan fan(centre);
  for (const Triangle& t : triangles) fan.add(t);
  return fan.isClosed() && fan.liesSideBySide(positions);
}

std::vector<std::uint8_t> clearFans(std::span<const Vec3> positions, std::span<const Triangle> triangles,
                                    std::span<const std::uint8_t> fixed, int threads) {
  const mesh::VertexTriangles around = mesh::vertexTriangles(positions.size(), triangles, threads);
  std::vector<std::uint8_t> clear(positions.size(), 0);
  parallel::parallelFor(positions.size(), threads, RunContext(), 1024, [&](std::size_t i) {
    const auto v = static_cast<VertexId>(i);
    const std::span<const TriangleId> ids = around.of(v);
    if (ids.size() < 3 || ids.size() > Fan::kMost) return;
    if (!fixed.empty() && std::ranges::all_of(ids, [&](TriangleId t) { return fixed[t] != 0; })) return;
    Fan fan(v);
    for (const TriangleId t : ids) fan.add(triangles[t]);
    clear[i] = fan.isClosed() && fan.liesSideBySide(positions);
  });
  return clear;
}

}  // namespace thicken::exact
