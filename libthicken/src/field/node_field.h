// SPDX-License-Identifier: LGPL-2.1-or-later
//
// The field of Definitions 1 and 2 at the nodes that were asked for, and at no others. Nodes far from
// what is contoured are never asked for, so that time and memory follow the area of the contour and not
// the volume of the paper's candidate region (Definition 4).
#pragma once

#include <cstdint>
#include <vector>

#include "field/block_index.h"
#include "field/membership.h"
#include "field/uniform_grid.h"
#include "thicken/run_context.h"

namespace thicken {

class NodeField {
 public:
  enum class State : std::uint8_t { kUnknown, kWanted, kKnown };
  struct Sample {
    double distance = 0;        ///< to S, mm
    float carrierDistance = 0;  ///< to Ŝ, mm, rounded up
    TriangleId closest = 0;     ///< a triangle of S that holds the closest point
    Standing standing = Standing::kFar;
    State state = State::kUnknown;
    [[nodiscard]] bool inside() const { return standing == Standing::kInside; }
  };

  explicit NodeField(const UniformGrid& grid) : grid_(grid) {}

  /// The number of a node (UniformGrid::key); its sample is there after the next evaluate().
  std::uint32_t want(std::uint64_t node) {
    const auto [i, isNew] = index_.insert(node);
    if (isNew) samples_.emplace_back();
    if (samples_[i].state == State::kUnknown) {
      samples_[i].state = State::kWanted;
      wanted_.push_back(i);
    }
    return i;
  }
  [[nodiscard]] const Sample& operator[](std::uint32_t i) const { return samples_[i]; }
  /// Calls visit(place, sample) for every node, in the order in which they were wanted.
  template <class Visit>
  void forEach(Visit visit) const {
    for (std::uint32_t i = 0; i < samples_.size(); ++i)
      visit(grid_.node(UniformGrid::indexOf(key(i))), samples_[i]);
  }
  [[nodiscard]] std::size_t size() const { return samples_.size(); }
  /// The node (UniformGrid::key) of a number.
  [[nodiscard]] std::uint64_t key(std::uint32_t i) const { return index_.keys()[i]; }

  /// What the field has cost: cells that were looked at, in every attempt, and nodes that it is known at.
  void countCells(std::size_t more) { cells_ += more; }
  [[nodiscard]] std::size_t cells() const { return cells_; }

  /// Evaluates the nodes that are wanted.
  void evaluate(const Membership& membership, const RunContext& context, int threads);

  /// Forgets the samples that `changed` may have changed: triangles that Ŝ has won or lost.
  void forget(const ClosestPointTree& changed, const RunContext& context, int threads);

 private:
  UniformGrid grid_;
  BlockIndex index_;
  std::vector<Sample> samples_;
  std::vector<std::uint32_t> wanted_;
  std::size_t cells_ = 0;
};

}  // namespace thicken
