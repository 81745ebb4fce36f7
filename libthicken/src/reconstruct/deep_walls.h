// SPDX-License-Identifier: LGPL-2.1-or-later
//
// Walls that reach deeper than the sweep's. In the sweep a copy on the rim is often drawn back for the sake
// of the shell beside it alone, and that shell is open here. kEnd tells where these walls end. Walls beside
// kept shell end where the shell does (`sweep/retreat`).
#pragma once

#include <cstddef>
#include <span>
#include <utility>
#include <vector>

#include "job/job.h"
#include "reconstruct/carrier.h"

namespace thicken::reconstruct {

class DeepWalls {
 public:
  DeepWalls(const job::Job& job, const sweep::SweepResult& swept);

  /// Places the walls' lower vertices as deep as exact tests against S, each other and the kept pieces
  /// of shell (whose own vertices stay where the sweep has them) allow. Never deeper than before.
  void fit(std::span<const std::uint8_t> keep);

  /// Draws back the lower vertices among `vertices` of the sweep by `step` mm, each a few times at most, so
  /// that the contour has room to make the wall's end itself. Returns whether any moved.
  bool lift(std::span<const VertexId> vertices, double step);

  /// Of the sweep's vertices.
  [[nodiscard]] const std::vector<Vec3>& positions() const { return at_; }

  /// Per vertex of the sweep: from a wall's lower vertex to the rim vertex that it hangs on; 0 for others.
  [[nodiscard]] std::vector<Vec3> up() const;

 private:
  [[nodiscard]] double deepest(VertexId low, VertexId base) const;
  [[nodiscard]] std::pair<std::vector<Triangle>, std::size_t> nearWalls(
      std::span<const std::uint8_t> keep) const;
  void listBottom();
  void limitSlope();
  void shorten();
  void place(VertexId v);
  void placeAll();

  const job::Job& job_;
  const sweep::SweepResult& swept_;
  bool fitted_ = false;
  std::vector<VertexId> low_;                         ///< lower vertices of the walls
  std::vector<std::array<VertexId, 2>> bottomEdges_;  ///< between two of them that one wall triangle has
  std::vector<std::uint8_t> lifts_;
  std::vector<VertexId> base_;  ///< per vertex of the sweep; kNone: does not move
  std::vector<double> way_;     ///< mm from the base, at full share
  std::vector<double> share_;   ///< of the way beyond the sweep's
  std::vector<Vec3> at_;
};

}  // namespace thicken::reconstruct
