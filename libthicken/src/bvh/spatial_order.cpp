// SPDX-License-Identifier: LGPL-2.1-or-later
#include "bvh/spatial_order.h"

#include "mesh/buckets.h"

namespace thicken::bvh {

SpatialOrder::SpatialOrder(std::span<const TriangleId> near, const ClosestPointTree& tree, int threads)
    : items_(mesh::intoBuckets<std::uint32_t>(near.size(), tree.triangleCount(), threads,
                                              [&](std::size_t i, const auto& put) {
                                                put(tree.placeOf(near[i]), static_cast<std::uint32_t>(i));
                                              })
                 .values) {}

}  // namespace thicken::bvh
