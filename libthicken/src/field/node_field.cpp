// SPDX-License-Identifier: LGPL-2.1-or-later
#include "field/node_field.h"

#include <limits>

#include "parallel/parallel_for.h"

namespace thicken::field {

using parallel::parallelFor;

void NodeField::evaluate(const Wanted& node, const Membership& membership) {
  Sample& s = samples_[node.number];
  const Probe p = membership.probe(grid_.node(UniformGrid::indexOf(node.key)));
  s.excess = p.excess;
  s.carrierDistance = static_cast<float>(p.carrierDistance) * (1 + std::numeric_limits<float>::epsilon());
  s.closest = p.triangle;
  s.standing = p.standing;
  s.state = State::kKnown;
}

void NodeField::evaluate(const Membership& membership, const RunContext& context, int threads) {
  const std::vector<Wanted> nodes = takeWanted();
  parallelFor(nodes.size(), threads, context, 64, [&](std::size_t i) { evaluate(nodes[i], membership); });
}

void NodeField::forget(const ClosestPointTree& changed, std::span<const std::uint8_t> marked,
                       const RunContext& context, int threads) {
  parallelFor(samples_.size(), threads, context, 256, [&](std::size_t i) {
    Sample& s = samples_[i];
    if (s.state == State::kUnknown) return;
    const bool isMarked = !marked.empty() && marked[s.closest] != 0;
    if (!isMarked && !changed.closest(grid_.node(UniformGrid::indexOf(index_.keys()[i])), s.carrierDistance))
      return;
    s.state = State::kUnknown;
    asked_[i] = 0;
  });
}

}  // namespace thicken::field
