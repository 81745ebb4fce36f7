// SPDX-License-Identifier: LGPL-2.1-or-later
#include "measure/error_bound.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <vector>

#include "exact/domain.h"
#include "measure/proof_part.h"
#include "parallel/parallel_for.h"

namespace thicken::measure {

using job::Job;
using parallel::parallelFor;

namespace {

class ShellProof {
 public:
  ShellProof(const Job& job, double tolerance, double rounding)
      : tree_(job.tree),
        thickness_(job.thickness),
        tolerance_(tolerance),
        rounding_(rounding),
        oneSided_(job.options.side != Side::kBoth),
        smallest_(std::sqrt(job.thickness.most() * tolerance) / 64) {}

  [[nodiscard]] Corner cornerAt(const Vec3& p) const {
    const auto c = tree_.closest(p);
    return {p, c->triangle, c->distance, c->onRim, c->feature == Feature::kFace, thickness_.at(*c)};
  }

  // An error that there is for certain, up to the tolerance. Where the thickness varies the bound is not to
  // be tighter than asked: parts would have to be far smaller for it.
  void expect(double error) {
    known_ = error;
    goal_ = thickness_.isConstant() ? std::min(tolerance_, error + tolerance_ / 8) : tolerance_;
  }

  // The corner that is farthest off, if any is by more than the tolerance: no part around it would be let
  // pass, however small.
  [[nodiscard]] ErrorBound cornerOff(const std::array<Corner, 3>& triangle) const {
    return cornerOff(triangle, normalOf({triangle[0].at, triangle[1].at, triangle[2].at}));
  }

  // The bound over one triangle of the shell, which faces out of the solid.
  [[nodiscard]] ErrorBound boundOf(const std::array<Corner, 3>& triangle) const {
    const Corners t = {triangle[0].at, triangle[1].at, triangle[2].at};
    const Vec3 out = normalOf(t);
    ErrorBound bound{0, t[0]};
    std::vector<Part> waiting{{triangle}};
    for (std::size_t parts = 0; !waiting.empty(); ++parts) {
      Part part = waiting.back();
      waiting.pop_back();
      const bool last = parts >= kMostParts;
      if (!part.nearEnough && !provedNear(part, last, bound)) return bound;
      if (!part.farEnough && !provedFar(part, out, last, bound)) return bound;
      if (!part.nearEnough || !part.farEnough) divide(part, waiting);
    }
    return bound;
  }

 private:
  static constexpr std::size_t kMostParts = 50000;

  static void raise(ErrorBound& bound, double to, const Vec3& place) {
    if (to > bound.most) bound = {to, place};
  }

  [[nodiscard]] ErrorBound cornerOff(const std::array<Corner, 3>& triangle, const Vec3& out) const {
    ErrorBound bound{0, triangle[0].at};
    for (const Corner& c : triangle) {
      const bool isFar = c.distance - rounding_ > c.thickness + tolerance_;
      const bool isNear =
          !c.onRim && c.distance + rounding_ < c.thickness - tolerance_ && !endsHalfway(c.at, out);
      if (isFar || isNear) raise(bound, std::abs(c.excess()), c.at);
    }
    return bound;
  }

  // Whether no point is farther than asked, or that is still open; false where one is.
  bool provedNear(Part& part, bool last, ErrorBound& bound) const {
    const Corner* farthest = &part.corner[0];
    for (const Corner& c : part.corner)
      if (c.excess() > farthest->excess()) farthest = &c;
    if (farthest->distance - rounding_ > farthest->thickness + tolerance_) {
      bound = {farthest->excess(), farthest->at};
      return false;
    }
    const double least = thicknessOver(part).least;
    double error = farthestFrom(part) + rounding_ - least;
    if (error > goal_) {
      const Corner middle = cornerAt(middleOf(cornersOf(part)));
      error = std::min(error, farthestFrom(part, middle.nearest) + rounding_ - least);
    }
    if (error > goal_ && isBelowOne(part)) error = farthest->excess() + rounding_;
    if (error > goal_ && !last && longestEdge(part).second > smallest_) return true;
    raise(bound, error, farthest->at);
    part.nearEnough = true;
    return error <= tolerance_;
  }

  // The same for no point being nearer than asked.
  bool provedFar(Part& part, const Vec3& out, bool last, ErrorBound& bound) const {
    const Corners t = cornersOf(part);
    const Vec3 middle = middleOf(t);
    const double r = thicknessOver(part).most;
    double error = r + rounding_ - tree_.distance(t, r - known_);
    if (error > tolerance_ && isBelowOne(part))
      error =
          rounding_ - std::min({part.corner[0].excess(), part.corner[1].excess(), part.corner[2].excess()});
    if (error > tolerance_) {
      const double radius = radiusOf(t, middle);
      if (radius <= tolerance_ && isOfRim(part, middle)) {
        part.farEnough = true;
        return true;
      }
      if (!endsHalfway(t, middle, radius, out)) {
        if (const ErrorBound off = cornerOff(part.corner, out); off.most > tolerance_) {
          bound = off;
          return false;
        }
        const bool open = !last && radius > tolerance_ / 8;
        if (!open) bound = {error, middle};
        return open;
      }
      error = tolerance_;
    }
    raise(bound, error, middle);
    part.farEnough = true;
    return true;
  }

  [[nodiscard]] double farthestFrom(const Corners& t, TriangleId s) const {
    return std::max({tree_.distanceTo(s, t[0]), tree_.distanceTo(s, t[1]), tree_.distanceTo(s, t[2])});
  }
  [[nodiscard]] double farthestFrom(const Part& part, TriangleId s) const {
    return farthestFrom(cornersOf(part), s);
  }
  [[nodiscard]] double farthestFrom(const Part& part) const {
    double least = farthestFrom(part, part.corner[0].nearest);
    for (int k = 1; k < 3; ++k)
      if (part.corner[k].nearest != part.corner[k - 1].nearest)
        least = std::min(least, farthestFrom(part, part.corner[k].nearest));
    return least;
  }

  // What the closest points of a part ask for that is at most `farthest` mm from S.
  [[nodiscard]] Range thicknessOver(const Corners& t, double farthest) const {
    if (thickness_.isConstant()) return {thickness_.least(), thickness_.most()};
    const Vec3 middle = middleOf(t);
    const double radius = radiusOf(t, middle);
    Range range{thickness_.most(), thickness_.least()};
    const ClosestPoint nearest = *tree_.closest(middle);
    const double slack = radius * radius + 8 * farthest * rounding_;
    tree_.near(t, farthest + 2 * rounding_, [&](TriangleId s) {
      const Vec3 q = tree_.closestOn(s, middle);
      // The square of the distance of p from s is convex in p: at least its tangent at the middle m. That
      // from the closest point c of m is |m − c|² + 2 (m − c)·(p − m) + |p − m|². Where the first exceeds the
      // second for all p within the radius, no closest point of the part is in s.
      const double more = (q - middle).squaredNorm() - nearest.distance * nearest.distance;
      if (more > 2 * (q - nearest.point).norm() * radius + slack) return;
      const double there = thickness_.at(s, q);
      const double change = thickness_.slope(s).norm() * radius;
      range.least = std::min(range.least, there - change);
      range.most = std::max(range.most, there + change);
    });
    return {std::max(range.least, thickness_.least()), std::min(range.most, thickness_.most())};
  }
  [[nodiscard]] Range thicknessOver(const Part& part) const {
    if (thickness_.isConstant()) return {thickness_.least(), thickness_.most()};
    return thicknessOver(cornersOf(part), farthestFrom(part));
  }

  // Whether all closest points of a part are inside of one triangle.
  [[nodiscard]] bool isBelowOne(const Part& part) const {
    if (thickness_.isConstant()) return false;
    const TriangleId one = part.corner[0].nearest;
    for (const Corner& c : part.corner)
      if (!c.onFace || c.nearest != one) return false;
    bool isAlone = true;
    tree_.near(cornersOf(part), farthestFrom(part) + 2 * rounding_,
               [&](TriangleId s) { isAlone &= s == one; });
    return isAlone;
  }

  [[nodiscard]] bool isOfRim(const Part& part, const Vec3& middle) const {
    return part.corner[0].onRim && part.corner[1].onRim && part.corner[2].onRim && cornerAt(middle).onRim;
  }

  // Whether ∂H is within the tolerance of all of the part.
  [[nodiscard]] bool endsHalfway(const Corners& t, const Vec3& middle, double radius, const Vec3& out) const {
    if (!oneSided_) return false;
    for (const Vec3& way : {out, awayFromSheet(middle)}) {
      const Vec3 by = (tolerance_ - rounding_) * way;
      if (allInside(moved(t, -by)) && allOutside(moved(t, by))) return true;
      if (endsNear(middle, tolerance_ - rounding_ - radius, way)) return true;
    }
    return false;
  }

  // The same for a point.
  [[nodiscard]] bool endsHalfway(const Vec3& p, const Vec3& out) const {
    if (!oneSided_) return false;
    return endsNear(p, tolerance_, out) || endsNear(p, tolerance_, awayFromSheet(p));
  }

  // The way out of the solid, seen from the nearest place of S.
  [[nodiscard]] Vec3 awayFromSheet(const Vec3& p) const {
    const auto c = tree_.closest(p);
    const Vec3 from = p - c->point, away = from.stableNormalized();
    return from.dot(c->pseudonormal) < 0 ? away : Vec3(-away);
  }

  // Whether ∂H is within `reach` of a point, on the straight line along `way`: some of it is in H, and some
  // not.
  [[nodiscard]] bool endsNear(const Vec3& p, double reach, const Vec3& way) const {
    // Not as far as S: behind it everything is outside, and a shell that is stuck there has no thickness.
    reach = std::min(reach, tree_.distance(p) / 2);
    if (reach <= 0) return false;
    const bool inside = isInside(p);
    for (const double at : {1.0, 0.5, 0.25})
      if (isInside(p - at * reach * way) != inside || isInside(p + at * reach * way) != inside) return true;
    return false;
  }

  [[nodiscard]] bool isInside(const Vec3& p) const {
    const ClosestPoint c = *tree_.closest(p);
    return insideThickened(p, c, thickness_.at(c));
  }

  // Some triangle that has all points behind it is nearer than all others are, and not farther than asked.
  [[nodiscard]] bool allInside(const Corners& t) const {
    const Vec3 middle = middleOf(t);
    const auto c = tree_.closest(middle);
    if (!insideThickened(middle, *c, thickness_.at(*c))) return false;
    const double most = farthestFrom(t, c->triangle) + 2 * rounding_;
    return most <= thicknessOver(t, most).least &&
           tree_.distance(t, most, ClosestPointTree::Except::kBehind) == most;
  }

  // Some triangle that has all points before it is, or else all are farther than asked.
  [[nodiscard]] bool allOutside(const Corners& t) const {
    const Vec3 middle = middleOf(t);
    const auto c = tree_.closest(middle);
    if (insideThickened(middle, *c, thickness_.at(*c))) return false;
    const double most = std::min(thickness_.most(), farthestFrom(t, c->triangle)) + 2 * rounding_;
    return tree_.distance(t, most, ClosestPointTree::Except::kBefore) == most;
  }

  [[nodiscard]] static std::pair<int, double> longestEdge(const Part& part) {
    std::pair<int, double> longest{0, -1};
    for (int k = 0; k < 3; ++k) {
      const double length = (part.corner[(k + 1) % 3].at - part.corner[k].at).norm();
      if (length > longest.second) longest = {k, length};
    }
    return longest;
  }

  void divide(const Part& part, std::vector<Part>& to) const {
    const int k = longestEdge(part).first, next = (k + 1) % 3;
    const Corner between = cornerAt((part.corner[k].at + part.corner[next].at) / 2);
    Part first = part, second = part;
    first.corner[next] = between;
    second.corner[k] = between;
    to.push_back(second);
    to.push_back(first);
  }

  const ClosestPointTree& tree_;
  const job::Thickness& thickness_;
  double tolerance_;
  double rounding_;  // mm: roundingOf()
  bool oneSided_;
  double smallest_;  // edge: what is not proved by then is as far as the tolerance but for a ten-thousandth
  double known_ = 0, goal_ = 0;
};

// More than the rounding of any distance here, mm. With e = 2^-53, coordinates below M and edges below L ≤ 4
// M:
//
// - The corner of a part is the middle of an edge, rounded by e M a coordinate. A part is divided at its
// longest
//   edge, from L down to `smallest_` or tolerance / 8: fewer than 128 times, even from 1e9 mm to 1e-9 mm. So
//   it is off the triangle that it is a part of by less than 128 √3 e M = 2.5e-14 M.
// - The distance from a point to a triangle is off by less than 16 e M + kMostTilt L = 2.7e-13 M
//   (bvh/triangle_distance.h).
// - Edges that are nearly parallel (bvh/triangle_gap.h): the nearest place along them is found with an error
//   that makes the squared distance too large by less than 16 e L times the distance of the edges' ends,
//   which is below 3 L where they matter. That divided by twice the distance, which is about r, is 24 e L² /
//   r = 2.7e-15 L² / r.
//
// Both factors are rounded up, to more than three times as much. L is the longest edge of the solid, which
// has all triangles of S, or else, on both sides, the diagonal of the box around it, which has S inside.
double roundingOf(const TriangleMesh& solid, Side side, double r) {
  constexpr double kOfCoordinates = 1e-12, kOfParallels = 1e-14;
  double largest = r, longest2 = 0;
  Eigen::AlignedBox3d box;
  for (const Vec3& p : solid.positions) {
    largest = std::max(largest, p.cwiseAbs().maxCoeff());
    box.extend(p);
  }
  if (side == Side::kBoth && !box.isEmpty()) longest2 = box.diagonal().squaredNorm();
  for (const auto& [a, b, c] : solid.triangles)
    for (const Vec3& edge :
         {Vec3(solid.positions[b] - solid.positions[a]), Vec3(solid.positions[c] - solid.positions[b]),
          Vec3(solid.positions[a] - solid.positions[c])})
      longest2 = std::max(longest2, edge.squaredNorm());
  return kOfCoordinates * largest + kOfParallels * longest2 / r;
}

// The shell's triangles with what S is like from their corners, and the proof for them.
struct ShellToProve {
  std::vector<TriangleId> triangles;
  std::vector<Corner> corner;  // per vertex of the solid
  ShellProof proof;

  ShellToProve(const Job& job, const TriangleMesh& solid, std::span<const Region> region, double tolerance)
      : triangles(shellOf(region)),
        corner(solid.positions.size()),
        proof(job, tolerance, roundingOf(solid, job.options.side, job.thickness.most())) {
    std::vector<std::uint8_t> onShell(corner.size(), 0);
    for (const TriangleId t : triangles)
      for (const VertexId v : solid.triangles[t]) onShell[v] = 1;
    parallelFor(corner.size(), job.threads, job.context, 256, [&](std::size_t v) {
      if (onShell[v]) corner[v] = proof.cornerAt(solid.positions[v]);
    });
    double known = 0;
    for (std::size_t v = 0; v < corner.size(); ++v)
      if (const double error = std::abs(corner[v].excess()); onShell[v] && error <= tolerance)
        known = std::max(known, error);
    proof.expect(known);
  }

  [[nodiscard]] std::array<Corner, 3> cornersOf(const TriangleMesh& solid, std::size_t i) const {
    const auto& [a, b, c] = solid.triangles[triangles[i]];
    return {corner[a], corner[b], corner[c]};
  }

 private:
  static std::vector<TriangleId> shellOf(std::span<const Region> region) {
    std::vector<TriangleId> shell;
    for (TriangleId t = 0; t < region.size(); ++t)
      if (region[t] == Region::kShell) shell.push_back(t);
    return shell;
  }
};

}  // namespace

ErrorBound boundShellError(const Job& job, const TriangleMesh& solid, std::span<const Region> region,
                           double tolerance) {
  exact::requireExactArithmetic();
  const ShellToProve shell(job, solid, region, tolerance);
  const auto worstOf = [&](const auto& boundOf) {
    std::vector<ErrorBound> bounds(shell.triangles.size());
    parallelFor(bounds.size(), job.threads, job.context, 64,
                [&](std::size_t i) { bounds[i] = boundOf(shell.cornersOf(solid, i)); });
    ErrorBound worst;
    for (const ErrorBound& bound : bounds)
      if (bound.most > worst.most) worst = bound;
    return worst;
  };
  // Where a corner is off, there is nothing to prove.
  const ErrorBound off =
      worstOf([&](const std::array<Corner, 3>& triangle) { return shell.proof.cornerOff(triangle); });
  if (off.most > tolerance) return off;
  return worstOf([&](const std::array<Corner, 3>& triangle) { return shell.proof.boundOf(triangle); });
}

std::vector<TriangleId> shellBeyond(const Job& job, const TriangleMesh& solid, std::span<const Region> region,
                                    double tolerance) {
  const ShellToProve shell(job, solid, region, tolerance);
  std::vector<std::uint8_t> isBeyond(shell.triangles.size(), 0);
  parallelFor(isBeyond.size(), job.threads, job.context, 64, [&](std::size_t i) {
    const std::array<Corner, 3> triangle = shell.cornersOf(solid, i);
    isBeyond[i] =
        shell.proof.cornerOff(triangle).most > tolerance || shell.proof.boundOf(triangle).most > tolerance;
  });
  std::vector<TriangleId> beyond;
  for (std::size_t i = 0; i < isBeyond.size(); ++i)
    if (isBeyond[i]) beyond.push_back(shell.triangles[i]);
  return beyond;
}

}  // namespace thicken::measure
