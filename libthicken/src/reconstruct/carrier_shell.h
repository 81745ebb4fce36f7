// SPDX-License-Identifier: LGPL-2.1-or-later
//
// Which of the sweep's shell the carrier has. Where triangles meet, pieces of it are given over to the
// contour, or taken back from it.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "exact/box_tree.h"
#include "reconstruct/assembly.h"
#include "sweep/sweep.h"

namespace thicken {

class CarrierShell {
 public:
  /// `keep`, `openable`: flags per triangle of `swept`, of what the carrier has and of what may be given
  /// over. Takes what hangs on by a vertex, and spikes, off the carrier. `width`: of the contour's cells, mm.
  CarrierShell(const SweepResult& swept, std::span<const std::uint8_t> openable,
               std::vector<std::uint8_t> keep, double width, int threads);

  [[nodiscard]] const std::vector<std::uint8_t>& keep() const { return keep_; }
  /// What the carrier did not have before any was given over, mm².
  [[nodiscard]] double openAtFirst() const { return openAtFirst_; }

  /// Gives pieces within `reach` mm of the triangles that meet over to the contour, with all that its own rim
  /// would pinch. Returns whether there were any; each is given over once, and large ones, of a great many
  /// cells, not at all, nor what would leave more to the contour than it was to make at first, or than many
  /// cells.
  bool giveOver(const Assembly& assembly, std::span<const TriangleId> meeting, double reach);

  /// Takes back the pieces near those of the contour's triangles that meet, or near all that do where none is
  /// the contour's, within `first` mm or farther, until there is something new. Returns whether there was.
  bool takeBack(const Assembly& assembly, std::span<const TriangleId> meeting, double first);

  /// Takes back all of it. Returns whether there was anything.
  bool takeAllBack();

 private:
  [[nodiscard]] std::vector<TriangleId> near(const TriangleMesh& mesh, TriangleId t, double reach) const;
  void separateFans();

  const SweepResult& swept_;
  std::span<const std::uint8_t> openable_;
  std::vector<std::uint8_t> keep_;
  double width_;
  double openAtFirst_ = 0;
  std::vector<std::uint8_t> givenOver_;  ///< once
  exact::BoxTree tree_;                  ///< of what may be given over
};

}  // namespace thicken
