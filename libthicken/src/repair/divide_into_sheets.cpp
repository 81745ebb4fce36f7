// SPDX-License-Identifier: LGPL-2.1-or-later
#include <algorithm>
#include <numeric>

#include "repair/sheets.h"
#include "thicken/sheets.h"

namespace thicken {
namespace {

// The triangles of one sheet, with the vertices that they use.
Sheet cutOut(const TriangleMesh& surface, const std::vector<TriangleId>& triangles) {
  Sheet sheet;
  std::vector<VertexId> used;
  for (const TriangleId t : triangles)
    used.insert(used.end(), surface.triangles[t].begin(), surface.triangles[t].end());
  std::sort(used.begin(), used.end());
  used.erase(std::unique(used.begin(), used.end()), used.end());
  for (const VertexId v : used) sheet.mesh.positions.push_back(surface.positions[v]);
  for (const TriangleId t : triangles) {
    Triangle own = surface.triangles[t];
    for (VertexId& v : own)
      v = static_cast<VertexId>(std::lower_bound(used.begin(), used.end(), v) - used.begin());
    sheet.mesh.triangles.push_back(own);
  }
  sheet.origin = triangles;
  return sheet;
}

}  // namespace

std::vector<Sheet> divideIntoSheets(const TriangleMesh& surface) {
  const repairing::Workpiece piece(surface);
  const repairing::Sheets sheets = repairing::sheetsOf(piece);
  std::vector<std::vector<TriangleId>> members(surface.triangles.size());
  for (TriangleId t = 0; t < surface.triangles.size(); ++t) members[sheets.sheetOf[t]].push_back(t);
  std::erase_if(members, [](const auto& list) { return list.empty(); });
  std::stable_sort(members.begin(), members.end(), [&](const auto& a, const auto& b) {
    return sheets.areaAt[a.front()] > sheets.areaAt[b.front()];
  });
  std::vector<Sheet> result;
  for (const auto& list : members) result.push_back(cutOut(surface, list));
  return result;
}

}  // namespace thicken
