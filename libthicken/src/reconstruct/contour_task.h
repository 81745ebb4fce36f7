// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "job/job.h"
#include "reconstruct/cut.h"
#include "reconstruct/reconstruction.h"
#include "reconstruct/working_set.h"
#include "sweep/sweep.h"

namespace thicken::reconstruct {

/// A carrier, and how the contour that closes it is to be made.
struct ContourTask {
  std::vector<std::uint8_t> keep;        ///< per triangle of the sweep: part of the carrier
  double area = 0;                       ///< of the rest, mm²
  double width = 0;                      ///< of the cells, mm
  std::size_t crossings = 0;             ///< that it makes at most
  WorkingSet working;                    ///< for so many
  bool mayKeepShell = false;             ///< whether the carrier may be given more of the sweep's shell
  std::vector<std::uint8_t> openable{};  ///< per triangle of the sweep: may become open; empty: its shell
  std::vector<std::uint8_t> left{};  ///< per triangle of the sweep: kept for want of better where it is kept;
                                     ///< empty: where `keep` does not have it
  int refined = 0;                   ///< times that finer cells were taken
  std::size_t meeting = 0;           ///< triangles that met before they were
  std::optional<Cut> cut{};          ///< where the sweep is a window of a boundary
  std::size_t* allowance = nullptr;  ///< what attempts at a boundary may cost yet, in triangles; null: any
};

/// The type of complete(). Parts of a task are completed by it, too; passing it on avoids a circle of
/// includes.
using Complete = std::optional<Reconstruction>(const job::Job& job, const sweep::SweepResult& swept,
                                               ContourTask task);

}  // namespace thicken::reconstruct
