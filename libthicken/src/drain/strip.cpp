// SPDX-License-Identifier: LGPL-2.1-or-later
#include "drain/strip.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numeric>

#include "exact/predicates.h"

namespace thicken::drain {
namespace {

// The sign of the area of a triangle in the first two coordinates, exact.
int turn(const Vec3& a, const Vec3& b, const Vec3& c) {
  return exact::orientation2(a, b, c, 2);
}

// Area by the squares of the sides: largest for an equilateral triangle, 0 for a needle.
double quality(const Vec3& a, const Vec3& b, const Vec3& c) {
  const Eigen::Vector2d u = (b - a).head<2>(), v = (c - a).head<2>(), w = (c - b).head<2>();
  const double sides = u.squaredNorm() + v.squaredNorm() + w.squaredNorm();
  return sides > 0 ? (u[0] * v[1] - u[1] * v[0]) / sides : 0;
}

class EarCutter {
 public:
  EarCutter(const std::vector<VertexId>& loop, const std::vector<Vec3>& flat)
      : loop_(loop), flat_(flat), left_(loop.size()) {
    std::iota(left_.begin(), left_.end(), std::size_t{0});
  }

  std::vector<Triangle> run() {
    std::vector<Triangle> triangles;
    while (left_.size() > 3) {
      const std::size_t ear = bestEar();
      if (ear == left_.size()) return {};
      triangles.push_back(triangleAt(ear));
      left_.erase(left_.begin() + static_cast<std::ptrdiff_t>(ear));
    }
    if (!isEar(1)) return {};
    triangles.push_back(triangleAt(1));
    return triangles;
  }

 private:
  [[nodiscard]] std::size_t before(std::size_t i) const {
    return left_[(i + left_.size() - 1) % left_.size()];
  }
  [[nodiscard]] std::size_t after(std::size_t i) const { return left_[(i + 1) % left_.size()]; }
  [[nodiscard]] Triangle triangleAt(std::size_t i) const {
    return {loop_[before(i)], loop_[left_[i]], loop_[after(i)]};
  }
  [[nodiscard]] bool isEar(std::size_t i) const {
    const std::size_t p = before(i), q = left_[i], r = after(i);
    if (turn(flat_[p], flat_[q], flat_[r]) <= 0) return false;
    return std::none_of(left_.begin(), left_.end(), [&](std::size_t s) {
      return s != p && s != q && s != r && turn(flat_[p], flat_[q], flat_[s]) >= 0 &&
             turn(flat_[q], flat_[r], flat_[s]) >= 0 && turn(flat_[r], flat_[p], flat_[s]) >= 0;
    });
  }
  [[nodiscard]] std::size_t bestEar() const {
    std::size_t best = left_.size();
    double most = 0;
    for (std::size_t i = 0; i < left_.size(); ++i) {
      const double q = quality(flat_[before(i)], flat_[left_[i]], flat_[after(i)]);
      if (q > most && isEar(i)) {
        most = q;
        best = i;
      }
    }
    return best;
  }

  const std::vector<VertexId>& loop_;
  const std::vector<Vec3>& flat_;
  std::vector<std::size_t> left_;  // places in loop_ of the vertices that are left
};

}  // namespace

std::vector<Triangle> triangulate(const std::vector<VertexId>& loop, const std::vector<Vec3>& flat) {
  if (loop.size() < 3) return {};
  return EarCutter(loop, flat).run();
}

}  // namespace thicken::drain
