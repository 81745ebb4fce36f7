// SPDX-License-Identifier: LGPL-2.1-or-later
//
// One exception type crosses the border of the library. It carries a code that programs can branch
// on, a sentence that a designer understands, and the places in the input that caused it.
#pragma once

#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "thicken/mesh.h"
#include "thicken/result.h"

namespace thicken {

enum class ErrorCode {
  kInvalidArgument,   ///< usage: an option out of its range
  kUnreadable,        ///< a file that cannot be read, or that is not what its name says
  kUnwritable,        ///< a file that cannot be written
  kEmpty,             ///< no triangles
  kNotFinite,         ///< NaN, infinite, too large for the stored precision, or too small but not 0
  kNotManifold,       ///< an edge of three or more triangles, a vertex of two or more fans
  kNotOriented,       ///< neighbouring triangles of opposite sense, or a one-sided surface
  kDegenerate,        ///< a triangle without area, or the same triangle twice
  kSelfIntersecting,  ///< triangles that meet elsewhere than at shared vertices and edges
  kTooLarge,          ///< more elements than 32-bit indices can name
  kMemoryLimit,       ///< not even the least that the run needs fits the limit
  kTimeLimit,         ///< the run took longer than RunContext::setTimeLimit() allows
  kNoSolid,           ///< no valid solid within the limits
  kArithmetic,        ///< the process does not compute as exact decisions need it
  kCancelled,         ///< RunContext::cancel() was called
  kInternal,          ///< a broken invariant of the library itself
};

/// The code as it is printed and documented: "not-manifold", "self-intersecting", …
[[nodiscard]] std::string_view name(ErrorCode code) noexcept;

/// The exit status of the `thicken` program for a code: 2 usage, 3 input refused, 4 no valid solid
/// within the limits, 5 cancelled, 6 file not read or not written.
[[nodiscard]] int exitStatus(ErrorCode code) noexcept;

/// One finding about a mesh: what, which elements, where. Lists hold at most kMaxListed ids;
/// `count` is the number of all of them.
struct Defect {
  static constexpr std::size_t kMaxListed = 1000;

  ErrorCode code = ErrorCode::kInternal;
  std::string sentence;  ///< complete, with the ids or coordinates of the place and what to do
  std::size_t count = 0;
  std::vector<VertexId> vertices;
  std::vector<std::array<VertexId, 2>> edges;
  std::vector<TriangleId> triangles;  ///< for intersections: pairs in sequence (a0,b0,a1,b1,…)
  Vec3 place = Vec3::Zero();          ///< mm, a point at the first element
};

class Error : public std::runtime_error {
 public:
  Error(ErrorCode code, const std::string& sentence, std::vector<Defect> defects = {});

  [[nodiscard]] ErrorCode code() const noexcept { return code_; }
  [[nodiscard]] const std::vector<Defect>& defects() const noexcept { return defects_; }

  /// What is known of the surface that was refused or could not be thickened; nothing where the run
  /// ended before the surface was looked at.
  [[nodiscard]] const std::optional<SurfaceFacts>& input() const noexcept { return input_; }
  void setInput(const SurfaceFacts& facts) { input_ = facts; }

  /// What was repaired before the run failed.
  [[nodiscard]] const std::optional<RepairFacts>& repair() const noexcept { return repair_; }
  void setRepair(RepairFacts facts) { repair_ = std::move(facts); }

  /// Bytes of memory that would have been enough to come as far as the run did, and for kMemoryLimit to go
  /// on; 0: not known.
  [[nodiscard]] std::size_t enoughMemory() const noexcept { return enoughMemory_; }
  void setEnoughMemory(std::size_t bytes) noexcept { enoughMemory_ = bytes; }

  /// With kTimeLimit: an estimate of the seconds that would have been enough; 0: not known.
  [[nodiscard]] double enoughSeconds() const noexcept { return enoughSeconds_; }
  void setEnoughSeconds(double seconds) noexcept { enoughSeconds_ = seconds; }

 private:
  ErrorCode code_;
  std::vector<Defect> defects_;
  std::optional<SurfaceFacts> input_;
  std::optional<RepairFacts> repair_;
  std::size_t enoughMemory_ = 0;
  double enoughSeconds_ = 0;
};

}  // namespace thicken
