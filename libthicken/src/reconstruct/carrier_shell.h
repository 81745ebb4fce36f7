// SPDX-License-Identifier: LGPL-2.1-or-later
//
// Which triangles of the sweep's shell the carrier has. Where triangles meet, pieces of shell become open:
// the contour replaces them. Where that does not help the carrier takes them back.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "exact/box_tree.h"
#include "reconstruct/assembly.h"
#include "sweep/sweep.h"

namespace thicken::reconstruct {

class CarrierShell {
 public:
  /// `keep`, `openable`: flags per triangle of `swept`: the carrier has it; it may become open. Spikes, and
  /// what hangs on by a vertex alone, are opened at once. `width`: of the contour's cells, mm.
  CarrierShell(const sweep::SweepResult& swept, std::span<const std::uint8_t> openable,
               std::vector<std::uint8_t> keep, double width, int threads);

  [[nodiscard]] const std::vector<std::uint8_t>& keep() const { return keep_; }
  /// Area of the shell that was open when this was made, mm².
  [[nodiscard]] double openAtFirst() const { return openAtFirst_; }

  /// Opens every openable triangle within `reach` mm of one that meets others, and what would otherwise leave
  /// a non-manifold vertex. No triangle is opened twice, and none larger than 1000 squares of a cell. All of
  /// it is undone if the open area would exceed both that at first and kManyBesideSweep cells. Returns
  /// whether any was opened.
  bool open(const Assembly& assembly, std::span<const TriangleId> meeting, double reach);

  /// Takes back open pieces near the contour's triangles that meet; near all that meet where none is the
  /// contour's. The reach begins with `first` mm and grows until there is a piece. Returns whether there was
  /// one.
  bool takeBack(const Assembly& assembly, std::span<const TriangleId> meeting, double first);

  /// Takes back all of it. Returns whether there was anything.
  bool takeAllBack();

 private:
  [[nodiscard]] std::vector<TriangleId> near(const TriangleMesh& mesh, TriangleId t, double reach) const;
  void separateFans();

  const sweep::SweepResult& swept_;
  std::span<const std::uint8_t> openable_;
  std::vector<std::uint8_t> keep_;
  double width_;
  double openAtFirst_ = 0;
  std::vector<std::uint8_t> opened_;  ///< once
  exact::BoxTree tree_;               ///< of what may become open
};

}  // namespace thicken::reconstruct
