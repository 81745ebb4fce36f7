// SPDX-License-Identifier: LGPL-2.1-or-later
#include "repair/sense.h"

#include <array>
#include <cstdint>
#include <limits>
#include <numeric>
#include <utility>
#include <vector>

#include "mesh/half_edges.h"
#include "repair/seam.h"

namespace thicken::repairing {

using mesh::HalfEdge;
using mesh::HalfEdges;

namespace {

// A triangle across an edge; `turned`: the two have to differ for one sense.
struct Link {
  TriangleId to;
  bool turned;
  double length;
};

class Links {
 public:
  Links(const Workpiece& piece, const HalfEdges& edges) : offset_(piece.mesh.triangles.size() + 1, 0) {
    struct Joint {
      TriangleId a, b;
      bool turned;
      double length;
    };
    std::vector<Joint> joints;
    edges.forEachEdge(
        [&](VertexId a, VertexId b, std::span<const HalfEdge> uses, std::span<const HalfEdge> back) {
          if (uses.size() + back.size() != 2) return;
          const TriangleId other = back.empty() ? uses[1].triangle() : back[0].triangle();
          joints.push_back({uses[0].triangle(), other, back.empty(),
                            (piece.mesh.positions[a] - piece.mesh.positions[b]).norm()});
          ++offset_[uses[0].triangle() + 1];
          ++offset_[other + 1];
        });
    std::partial_sum(offset_.begin(), offset_.end(), offset_.begin());
    links_.resize(offset_.back());
    std::vector<std::uint32_t> next(offset_.begin(), offset_.end() - 1);
    for (const Joint& j : joints) {
      links_[next[j.a]++] = {j.b, j.turned, j.length};
      links_[next[j.b]++] = {j.a, j.turned, j.length};
    }
  }
  [[nodiscard]] std::span<const Link> of(TriangleId t) const {
    return std::span(links_).subspan(offset_[t], offset_[t + 1] - offset_[t]);
  }

 private:
  std::vector<std::uint32_t> offset_;
  std::vector<Link> links_;
};

using Labels = std::vector<std::uint8_t>;  // per triangle: 1 where it is to be turned over

// Labels along a breadth-first tree from `seed`; returns the triangles in the order of the visit.
std::vector<TriangleId> spread(const Links& links, TriangleId seed, Labels& labels,
                               std::vector<std::uint32_t>& round, std::uint32_t now) {
  std::vector<TriangleId> order{seed};
  labels[seed] = 0;
  round[seed] = now;
  for (std::size_t i = 0; i < order.size(); ++i)
    for (const Link& link : links.of(order[i])) {
      if (round[link.to] == now) continue;
      round[link.to] = now;
      labels[link.to] = labels[order[i]] ^ static_cast<std::uint8_t>(link.turned);
      order.push_back(link.to);
    }
  return order;
}

bool fails(const Labels& labels, TriangleId t, const Link& link) {
  return (labels[t] ^ labels[link.to]) != static_cast<std::uint8_t>(link.turned);
}

// Sum of the lengths of the edges, counted twice, at which the labels leave two senses.
double seamLength(const Links& links, const std::vector<TriangleId>& part, const Labels& labels) {
  double sum = 0;
  for (const TriangleId t : part)
    for (const Link& link : links.of(t))
      if (fails(labels, t, link)) sum += link.length;
  return sum;
}

// Turns triangles over as long as a single one makes the seam shorter.
void shorten(const Links& links, const std::vector<TriangleId>& part, Labels& labels) {
  // A gain of less than this share of what is compared may be rounding, and could go on for ever.
  constexpr double kLeastGain = 1e-9;
  std::vector<TriangleId> open(part.rbegin(), part.rend());
  while (!open.empty()) {
    const TriangleId t = open.back();
    open.pop_back();
    double wrong = 0, right = 0;
    for (const Link& link : links.of(t)) (fails(labels, t, link) ? wrong : right) += link.length;
    if (wrong <= right + kLeastGain * (wrong + right)) continue;
    labels[t] ^= 1;
    for (const Link& link : links.of(t)) open.push_back(link.to);
  }
}

// The labels of a one-sided part with the shortest seam of those that are tried: the input's own
// senses, and trees from places far from one another.
void layShortestSeam(const Links& links, const std::vector<TriangleId>& part, Labels& labels,
                     std::vector<std::uint32_t>& round, std::uint32_t& now) {
  constexpr int kSeeds = 8;
  Labels best = labels, tried = labels;
  double least = std::numeric_limits<double>::infinity();
  TriangleId seed = part.back();
  for (int i = 0; i <= kSeeds; ++i) {
    std::vector<TriangleId> order = part;
    if (i == 0) {
      for (const TriangleId t : part) tried[t] = 0;
    } else {
      order = spread(links, seed, tried, round, ++now);
      seed = order[order.size() - 1 - (i % 2 == 0 ? order.size() / 3 : 0)];
    }
    shorten(links, order, tried);
    const double length = seamLength(links, part, tried);
    if (length < least) {
      least = length;
      best = tried;
    }
  }
  labels = std::move(best);
}

// Turns the smaller share of the part over.
void turnOver(Workpiece& piece, const std::vector<TriangleId>& part, const Labels& labels) {
  std::array<double, 2> area{0, 0};
  std::array<std::size_t, 2> count{0, 0};
  for (const TriangleId t : part) {
    area[labels[t]] += piece.area(t);
    ++count[labels[t]];
  }
  if (count[0] == 0 || count[1] == 0) return;
  const std::uint8_t smaller = area[1] <= area[0];
  for (const TriangleId t : part)
    if (labels[t] == smaller) piece.turn(t);
}

}  // namespace

void makeSenseConsistent(Workpiece& piece) {
  const std::size_t count = piece.mesh.triangles.size();
  bool cut = false;
  {
    const HalfEdges edges(piece.mesh.positions.size(), piece.mesh.triangles, piece.present);
    const Links links(piece, edges);
    Labels labels(count, 0);
    std::vector<std::uint32_t> round(count, 0);
    std::uint32_t now = 1;
    for (TriangleId t = 0; t < count; ++t) {
      if (piece.present[t] == 0 || round[t] != 0) continue;
      const std::vector<TriangleId> part = spread(links, t, labels, round, now);
      if (seamLength(links, part, labels) > 0) {
        layShortestSeam(links, part, labels, round, now);
        cut = true;
      }
      turnOver(piece, part, labels);
    }
  }
  if (cut) cutAlongSeams(piece);
}

}  // namespace thicken::repairing
