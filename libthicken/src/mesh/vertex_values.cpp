// SPDX-License-Identifier: LGPL-2.1-or-later
#include "mesh/vertex_values.h"

#include <fmt/format.h>

#include <unordered_map>

#include "mesh/place_text.h"
#include "thicken/error.h"

namespace thicken {

namespace {

struct PlaceHash {
  std::size_t operator()(const Vec3& p) const {
    std::size_t hash = 0;
    for (const double x : p) hash = (hash ^ std::hash<double>()(x)) * 0x9e3779b97f4a7c15u;
    return hash;
  }
};

}  // namespace

std::vector<double> valuesAt(const TriangleMesh& from, std::span<const double> values, const TriangleMesh& to,
                             std::string_view what) {
  std::unordered_map<Vec3, double, PlaceHash> at;
  at.reserve(from.positions.size());
  for (std::size_t v = 0; v < from.positions.size(); ++v) {
    const auto [place, isNew] = at.emplace(from.positions[v], values[v]);
    if (!isNew && place->second != values[v])
      throw Error(ErrorCode::kInvalidArgument,
                  fmt::format("vertices at {} have different values of {}, {:.6g} and {:.6g}; corners in one "
                              "place are one vertex",
                              text(from.positions[v]), what, place->second, values[v]));
  }
  std::vector<double> there;
  there.reserve(to.positions.size());
  for (const Vec3& p : to.positions) {
    const auto place = at.find(p);
    if (place == at.end())
      throw Error(
          ErrorCode::kInvalidArgument,
          fmt::format("the surface got a new vertex at {}, which has no value of {}; mend the surface "
                      "first, and give the repaired one values",
                      text(p), what));
    there.push_back(place->second);
  }
  return there;
}

}  // namespace thicken
