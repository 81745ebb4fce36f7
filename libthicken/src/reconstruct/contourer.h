// SPDX-License-Identifier: LGPL-2.1-or-later
//
// The contour that closes a carrier's rim. Carriers come one after another, each with more of the sweep than
// the one before. Values of the field and crossings that still hold are not computed again.
#pragma once

#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "contour/dual_surface.h"
#include "contour/follow.h"
#include "field/node_field.h"
#include "job/job.h"
#include "reconstruct/carrier.h"
#include "reconstruct/working_set.h"

namespace thicken::reconstruct {

struct Contour {
  std::vector<contour::Crossing> crossings;
  std::vector<contour::RimWay> ways;
  contour::DualSurface dual;
};

class Contourer {
 public:
  /// `job` and `cut` (null: none) must outlive the contourer.
  Contourer(const job::Job& job, double width, const WorkingSet& working, const Cut* cut);

  /// The contour that closes `carrier`, whose first triangles are those of the surface. `seeds` are for parts
  /// of the contour that touch no rim. Throws kNoSolid where the contour leaves the zone of the cut.
  [[nodiscard]] Contour contour(const Carrier& carrier, const field::Membership& membership,
                                const contour::Seeds& seeds);

  /// Keeps where the crossings of the last contour lie, for the next one.
  void remember(std::vector<contour::Crossing> crossings);

  [[nodiscard]] const field::UniformGrid& grid() const { return grid_; }
  /// Of the last contour; a lean working set leaves no nodes in it.
  [[nodiscard]] const field::NodeField& field() const { return *field_; }

 private:
  using Corners = std::array<Vec3, 3>;

  void startGrid();
  [[nodiscard]] Contour attempt(const Carrier& carrier, const field::Membership& membership,
                                const contour::Seeds& seeds);
  void forgetChanges(std::vector<Corners> beyondSurface, std::span<const std::uint8_t> covered);
  [[nodiscard]] const contour::Crossing* recalled(const contour::EdgePart& part) const;

  const job::Job& job_;
  double width_;
  WorkingSet working_;
  const Cut* cut_;
  int shifts_ = -1;
  field::UniformGrid grid_;
  std::optional<field::SurfaceCrossings> onSurface_;
  std::optional<field::NodeField> field_;
  std::vector<Corners> beyondSurface_;  ///< triangles of the last carrier that are not S's, sorted
  std::vector<std::uint8_t> covered_;   ///< triangles of S, in the last carrier
  std::optional<ClosestPointTree> changed_;
  std::vector<contour::Crossing> last_;
};

}  // namespace thicken::reconstruct
