// SPDX-License-Identifier: LGPL-2.1-or-later
#include "field/node_field.h"

#include <limits>

#include "parallel_for.h"

namespace thicken {

void NodeField::evaluate(const Membership& membership, const RunContext& context, int threads) {
  parallelFor(wanted_.size(), threads, context, 16, [&](std::size_t i) {
    Sample& s = samples_[wanted_[i]];
    const Probe p = membership.probe(grid_.node(UniformGrid::indexOf(index_.keys()[wanted_[i]])));
    s.distance = p.distance;
    s.carrierDistance = static_cast<float>(p.carrierDistance) * (1 + std::numeric_limits<float>::epsilon());
    s.closest = p.triangle;
    s.standing = p.standing;
    s.state = State::kKnown;
  });
  wanted_.clear();
}

void NodeField::forget(const ClosestPointTree& changed, const RunContext& context, int threads) {
  parallelFor(samples_.size(), threads, context, 256, [&](std::size_t i) {
    Sample& s = samples_[i];
    if (s.state == State::kKnown &&
        changed.closest(grid_.node(UniformGrid::indexOf(index_.keys()[i])), s.carrierDistance))
      s.state = State::kUnknown;
  });
}

}  // namespace thicken
