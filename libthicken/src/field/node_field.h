// SPDX-License-Identifier: LGPL-2.1-or-later
//
// The field of Definitions 1 and 2 at the nodes that were asked for. Nodes far from the contour are never
// asked for. So time and memory go with the area of the contour, not with the volume of the paper's candidate
// region (Definition 4).
#pragma once

#include <algorithm>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "field/block_index.h"
#include "field/membership.h"
#include "field/uniform_grid.h"
#include "thicken/run_context.h"

namespace thicken::field {

class NodeField {
 public:
  enum class State : std::uint8_t { kUnknown, kKnown };
  struct Sample {
    double excess = 0;          ///< mm, of the distance to S over the thickness
    float carrierDistance = 0;  ///< to Ŝ, mm, rounded up
    TriangleId closest = 0;     ///< a triangle of S that holds the closest point
    Standing standing = Standing::kFar;
    State state = State::kUnknown;
    [[nodiscard]] bool inside() const { return standing == Standing::kInside; }
  };

  static constexpr std::size_t kAny = ~std::size_t{0};

  /// `most`: nodes that may be known at a time. The caller has to look at isFull() and to drop() them all.
  explicit NodeField(const UniformGrid& grid, std::size_t most = kAny) : grid_(grid), most_(most) {}

  /// A node that no sample is known of yet.
  struct Wanted {
    std::uint32_t number;
    std::uint64_t key;
  };

  /// The number of a node (UniformGrid::key); its sample is there when it has been evaluated.
  std::uint32_t want(std::uint64_t node) {
    const auto [i, isNew] = index_.insert(node);
    if (isNew) {
      samples_.emplace_back();
      asked_.push_back(0);
    }
    if (asked_[i] == 0) {
      asked_[i] = 1;
      wanted_.push_back({i, node});
    }
    return i;
  }
  /// The nodes that are wanted since the last call, for the caller to evaluate.
  [[nodiscard]] std::vector<Wanted> takeWanted() { return std::exchange(wanted_, {}); }
  /// Makes room, so that samples stay where they are while so many more nodes are wanted: others may be
  /// evaluated and read on other threads at the same time.
  void makeRoom(std::size_t more) {
    if (samples_.capacity() < samples_.size() + more)
      samples_.reserve(std::max(2 * samples_.capacity(), samples_.size() + more));
  }
  /// Evaluates one node. Any thread.
  void evaluate(const Wanted& node, const Membership& membership);

  [[nodiscard]] const Sample& operator[](std::uint32_t i) const { return samples_[i]; }
  /// Calls visit(place, sample) for every node, in the order in which they were wanted.
  template <class Visit>
  void forEach(Visit visit) const {
    for (std::uint32_t i = 0; i < samples_.size(); ++i)
      visit(grid_.node(UniformGrid::indexOf(key(i))), samples_[i]);
  }
  [[nodiscard]] std::size_t size() const { return samples_.size(); }
  [[nodiscard]] bool mayDrop() const { return most_ != kAny; }
  [[nodiscard]] bool isFull() const { return samples_.size() >= most_; }
  /// Forgets all nodes and their numbers, but keeps their memory for others.
  void drop() {
    dropped_ += samples_.size();
    index_.clear();
    samples_.clear();
    asked_.clear();
  }
  /// The same, and frees their memory.
  void release() {
    drop();
    index_ = {};
    samples_ = std::vector<Sample>();
    asked_ = std::vector<std::uint8_t>();
  }
  /// The node (UniformGrid::key) of a number.
  [[nodiscard]] std::uint64_t key(std::uint32_t i) const { return index_.keys()[i]; }

  /// The cost of the field: cells that were looked at, in all attempts, and nodes that were evaluated.
  void countCells(std::size_t more) { cells_ += more; }
  [[nodiscard]] std::size_t cells() const { return cells_; }
  [[nodiscard]] std::size_t nodes() const { return dropped_ + samples_.size(); }

  /// Evaluates all nodes that are wanted.
  void evaluate(const Membership& membership, const RunContext& context, int threads);

  /// Forgets the samples that `changed` may have changed: triangles that Ŝ has won or lost; and those whose
  /// closest triangle of S is marked, unless there are no marks.
  void forget(const ClosestPointTree& changed, std::span<const std::uint8_t> marked,
              const RunContext& context, int threads);

 private:
  UniformGrid grid_;
  std::size_t most_;
  BlockIndex index_;
  std::vector<Sample> samples_;
  std::vector<std::uint8_t> asked_;  ///< per node: its sample is known, or wanted
  std::vector<Wanted> wanted_;
  std::size_t cells_ = 0, dropped_ = 0;
};

}  // namespace thicken::field
