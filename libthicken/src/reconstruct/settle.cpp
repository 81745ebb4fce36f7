// SPDX-License-Identifier: LGPL-2.1-or-later
#include "reconstruct/settle.h"

#include <algorithm>
#include <bit>
#include <functional>
#include <utility>

#include "exact/predicates.h"
#include "mesh/float_lattice.h"
#include "mesh/parallel_sort.h"
#include "mesh/sort_unique.h"

namespace thicken::reconstruct {

using mesh::roundToFloat;
using mesh::sortUnique;
using parallel::parallelFor;

namespace {

using Ids = std::vector<std::uint32_t>;

constexpr std::size_t kGrain = 4096;  // triangles or vertices that a thread takes at a time

std::uint64_t hashOf(const TriangleMesh& mesh, const Triangle& t) {
  std::uint64_t h = 0;
  for (const VertexId v : t)
    for (const double x : mesh.positions[v]) {
      h = (h ^ std::bit_cast<std::uint64_t>(x)) * 0x9e3779b97f4a7c15u;
      h ^= h >> 32;
    }
  return h;
}

class Settler {
 public:
  Settler(Assembly& assembly, std::span<const Vec3> target, std::span<const Vec3> up, double step,
          const ProvedTriangles& proved, std::size_t most, const RunContext& context, int threads)
      : a_(assembly),
        target_(target),
        up_(up),
        step_(step),
        most_(most),
        lifts_(assembly.carrierVertices, 0),
        context_(context),
        threads_(threads),
        start_(assembly.mesh.positions.begin() + static_cast<std::ptrdiff_t>(assembly.carrierVertices),
               assembly.mesh.positions.end()),
        share_(start_.size(), 1),
        around_(mesh::vertexTriangles(assembly.mesh.positions.size(), assembly.mesh.triangles, threads)) {
    parallelFor(start_.size(), threads, context, kGrain,
                [&](std::size_t i) { position(i) = roundToFloat(target[i]); });
    clear_ = proved.among(assembly.mesh, threads);
    for (TriangleId t = 0; t < assembly.carrierTriangles; ++t)
      if (!isDivided(t)) clear_[t] = 1;
  }

  Ids run() {
    exact::PairSearch search(a_.mesh, most_, threads_);
    pairs_ = search.all(clear_, context_, threads_);
    findFlat();
    metBefore_ = pairs_.size() + flat_.size();
    for (int round = 0; round < kBackwards + kRelaxations && !done(); ++round) {
      context_.throwIfCancelled();
      const int relaxation = round - kBackwards;
      if (relaxation >= 0 && relaxation % kPatience == 0 && isHopeless()) break;
      std::vector<VertexId> moved;
      if (round < kBackwards)
        moved = goBack(involved(0, false), round + 1 == kBackwards);
      else if (relaxation % kBetweenLifts == 0)
        moved = lift();
      if (moved.empty())
        moved = relax(involved(std::max(relaxation, 0) % 4 / 2, relaxation >= kContourAlone));
      if (moved.empty()) break;
      retest(search, moved);
    }
    return meeting();
  }

 private:
  static constexpr int kBackwards = 3;
  static constexpr int kRelaxations = 16;
  static constexpr int kBetweenLifts = 2;
  static constexpr int kContourAlone = 8;  // relaxations before the ends of walls move with it
  static constexpr int kMostLifts = 3;
  // Where a great many meet, rounds that do not make them much fewer are the last.
  static constexpr int kPatience = 4;
  static constexpr std::size_t kMany = 5000;
  static constexpr double kFewer = 2.0 / 3;

  Vec3& position(std::size_t i) { return a_.mesh.positions[a_.carrierVertices + i]; }
  // Whether rounding may have moved the triangle out of the plane of the one that was proved.
  [[nodiscard]] bool isDivided(TriangleId t) const {
    const Triangle& corners = a_.mesh.triangles[t];
    return std::any_of(corners.begin(), corners.end(),
                       [this](VertexId v) { return v >= a_.firstDivided && v < a_.carrierVertices; });
  }
  [[nodiscard]] bool done() const { return pairs_.empty() && flat_.empty(); }
  [[nodiscard]] bool isFlat(TriangleId t) const {
    const auto& [a, b, c] = a_.mesh.triangles[t];
    return exact::collinear(a_.mesh.positions[a], a_.mesh.positions[b], a_.mesh.positions[c]);
  }

  // Whether a great many meet, and not much fewer than when this was asked the last time.
  [[nodiscard]] bool isHopeless() {
    const std::size_t now = pairs_.size() + flat_.size();
    const std::size_t before = std::exchange(metBefore_, now);
    return now > kMany && double(now) > kFewer * double(before);
  }

  void findFlat() {
    std::vector<std::uint8_t> is(a_.mesh.triangles.size());
    parallelFor(is.size(), threads_, context_, kGrain, [&](std::size_t i) {
      const auto t = static_cast<TriangleId>(i);
      is[t] = (t >= a_.carrierTriangles || isDivided(t)) && isFlat(t);
    });
    for (TriangleId t = 0; t < is.size(); ++t)
      if (is[t]) flat_.push_back(t);
  }

  [[nodiscard]] Ids meeting() const {
    Ids ids(flat_);
    for (const auto& [x, y] : pairs_) {
      ids.push_back(x);
      ids.push_back(y);
    }
    sortUnique(ids);
    return ids;
  }

  // The contour's vertices of the triangles that meet, and `rings` of neighbours; ends of walls, too, when
  // lifting them was not enough.
  [[nodiscard]] std::vector<VertexId> involved(int rings, bool walls) const {
    std::vector<VertexId> ids;
    Ids triangles = meeting();
    for (int ring = 0;; ++ring) {
      for (const TriangleId t : triangles)
        for (const VertexId v : a_.mesh.triangles[t])
          if (v >= a_.carrierVertices || (walls && !up_[v].isZero(0))) ids.push_back(v);
      sortUnique(ids);
      if (ring == rings) return ids;
      triangles.clear();
      for (const VertexId v : ids)
        for (const TriangleId t : around_.of(v)) triangles.push_back(t);
      sortUnique(triangles);
    }
  }

  std::vector<VertexId> goBack(std::vector<VertexId> ids, bool wholly) {
    for (const VertexId v : ids) {
      const std::size_t i = v - a_.carrierVertices;
      share_[i] = wholly ? 0 : share_[i] / 2;
      position(i) = roundToFloat(start_[i] + share_[i] * (target_[i] - start_[i]));
    }
    return ids;
  }

  // Draws back the ends of walls that triangles meet at; the strip beside them takes their place.
  std::vector<VertexId> lift() {
    std::vector<VertexId> ids;
    for (const TriangleId t : meeting())
      for (const VertexId v : a_.mesh.triangles[t])
        if (v < a_.carrierVertices && lifts_[v] < kMostLifts && up_[v].norm() > (lifts_[v] + 2) * step_)
          ids.push_back(v);
    sortUnique(ids);
    for (const VertexId v : ids) {
      ++lifts_[v];
      a_.mesh.positions[v] = roundToFloat(a_.mesh.positions[v] + step_ * up_[v].normalized());
    }
    return ids;
  }

  // Each vertex half-way to the mean of its neighbours; the end of a wall, whose neighbours may be far away,
  // by a step at most.
  std::vector<VertexId> relax(std::vector<VertexId> ids) {
    std::vector<Vec3> next(ids.size());
    for (std::size_t k = 0; k < ids.size(); ++k) {
      const VertexId v = ids[k];
      Vec3 sum = Vec3::Zero();
      double count = 0;
      for (const TriangleId t : around_.of(v))
        for (const VertexId w : a_.mesh.triangles[t])
          if (w != v) {
            sum += a_.mesh.positions[w];
            ++count;
          }
      Vec3 way = (sum / count - a_.mesh.positions[v]) / 2;
      if (v < a_.carrierVertices && way.norm() > step_) way *= step_ / way.norm();
      next[k] = roundToFloat(a_.mesh.positions[v] + way);
    }
    for (std::size_t k = 0; k < ids.size(); ++k) a_.mesh.positions[ids[k]] = next[k];
    return ids;
  }

  void retest(exact::PairSearch& search, const std::vector<VertexId>& moved) {
    Ids triangles;
    for (const VertexId v : moved)
      for (const TriangleId t : around_.of(v)) triangles.push_back(t);
    sortUnique(triangles);
    for (const TriangleId t : triangles) clear_[t] = 0;
    const auto hasMoved = [&](TriangleId t) {
      return std::binary_search(triangles.begin(), triangles.end(), t);
    };
    std::erase_if(pairs_,
                  [&](const exact::TrianglePair& p) { return hasMoved(p.first) || hasMoved(p.second); });
    std::erase_if(flat_, hasMoved);
    const auto now = search.withMoved(triangles, clear_, context_, threads_);
    pairs_.insert(pairs_.end(), now.begin(), now.end());
    for (const TriangleId t : triangles)
      if (isFlat(t)) flat_.push_back(t);
  }

  Assembly& a_;
  std::span<const Vec3> target_, up_;
  double step_;
  std::size_t most_;
  std::vector<std::uint8_t> lifts_;  ///< per vertex of the carrier
  const RunContext& context_;
  int threads_;
  std::vector<Vec3> start_;
  std::vector<double> share_;
  mesh::VertexTriangles around_;
  std::vector<std::uint8_t> clear_;  ///< of each other; 0 for what has moved
  std::vector<exact::TrianglePair> pairs_;
  Ids flat_;
  std::size_t metBefore_ = 0;  ///< pairs and flat ones, when isHopeless() was asked
};

}  // namespace

std::vector<std::uint8_t> ProvedTriangles::among(const TriangleMesh& mesh, int threads) const {
  std::vector<std::uint8_t> is(mesh.triangles.size(), 0);
  if (hashes_.empty()) return is;
  parallelFor(is.size(), threads, RunContext(), kGrain, [&](std::size_t t) {
    is[t] = std::binary_search(hashes_.begin(), hashes_.end(), hashOf(mesh, mesh.triangles[t]));
  });
  return is;
}

void ProvedTriangles::replace(const TriangleMesh& mesh, std::span<const TriangleId> meeting, int threads) {
  hashes_.resize(mesh.triangles.size());
  parallelFor(hashes_.size(), threads, RunContext(), kGrain,
              [&](std::size_t t) { hashes_[t] = hashOf(mesh, mesh.triangles[t]); });
  std::size_t kept = 0;
  for (std::size_t t = 0, m = 0; t < hashes_.size(); ++t) {
    if (m < meeting.size() && meeting[m] == t)
      ++m;
    else
      hashes_[kept++] = hashes_[t];
  }
  hashes_.resize(kept);
  mesh::parallelSort(hashes_, std::less<>(), threads);
}

std::vector<TriangleId> settle(Assembly& assembly, std::span<const Vec3> target, std::span<const Vec3> up,
                               double step, const ProvedTriangles& proved, std::size_t most,
                               const RunContext& context, int threads) {
  return Settler(assembly, target, up, step, proved, most, context, threads).run();
}

}  // namespace thicken::reconstruct
