// SPDX-License-Identifier: LGPL-2.1-or-later
#include <pybind11/stl.h>

#include <cstdint>
#include <utility>
#include <vector>

#include "arrays.h"
#include "bindings.h"
#include "from_json.h"
#include "interruptible.h"
#include "thicken/check.h"
#include "thicken/closest_point.h"
#include "thicken/inspect.h"
#include "thicken/report.h"

namespace py = pybind11;

namespace thicken::python {
namespace {

template <class T>
py::array_t<T> arrayOf(const std::vector<T>& values) {
  return py::array_t<T>(static_cast<py::ssize_t>(values.size()), values.data());
}

py::object inspectArrays(const py::object& vertices, const py::object& triangles, int threads,
                         const std::optional<RunContext>& context) {
  const RunContext run = context.value_or(RunContext());
  const TriangleMesh mesh = meshFrom(vertices, triangles);
  const Inspection found = runInterruptibly(run, [&] { return inspect(mesh, run, threads); });
  py::object result = fromJson(toJson(found));
  result["shell_of_triangle"] = arrayOf(found.shellOfTriangle);
  return result;
}

using Flags = py::array_t<std::uint8_t, py::array::c_style | py::array::forcecast>;

py::array wallThicknessArray(const py::object& vertices, const py::object& triangles,
                             const std::optional<Flags>& edges, int threads,
                             const std::optional<RunContext>& context) {
  const RunContext run = context.value_or(RunContext());
  const TriangleMesh mesh = meshFrom(vertices, triangles);
  std::span<const std::uint8_t> isEdge;
  if (edges) isEdge = {edges->data(), static_cast<std::size_t>(edges->size())};
  if (!isEdge.empty() && isEdge.size() != mesh.triangles.size())
    throw py::value_error("edges must have one value for each triangle");
  return numberArray(runInterruptibly(run, [&] { return wallThickness(mesh, run, threads, isEdge); }));
}

struct ClosestArrays {
  std::vector<double> distance;
  std::vector<std::uint32_t> triangle;
  std::vector<std::uint8_t> onRim;
  std::vector<Vec3> point;
};

ClosestArrays closestOf(const TriangleMesh& surface, const std::vector<Vec3>& points, const RunContext& run) {
  const ClosestPointTree tree(weld(surface));
  ClosestArrays found;
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (i % 1024 == 0) run.throwIfCancelled();
    const auto c = tree.closest(points[i]);
    if (!c) throw Error(ErrorCode::kNotFinite, "a point has a coordinate that is not a number");
    found.distance.push_back(c->distance);
    found.triangle.push_back(c->triangle);
    found.onRim.push_back(c->onRim ? 1 : 0);
    found.point.push_back(c->point);
  }
  return found;
}

py::dict closestPoints(const py::object& vertices, const py::object& triangles, const py::object& points,
                       const std::optional<RunContext>& context) {
  const RunContext run = context.value_or(RunContext());
  const TriangleMesh surface = meshFrom(vertices, triangles);
  if (surface.triangles.empty()) throw py::value_error("a surface without triangles has no closest point");
  const TriangleMesh queries = meshFrom(points, py::list());
  ClosestArrays found = runInterruptibly(run, [&] { return closestOf(surface, queries.positions, run); });
  py::dict result;
  result["distance"] = numberArray(std::move(found.distance));
  result["triangle"] = arrayOf(found.triangle);
  result["on_rim"] = arrayOf(found.onRim);
  result["point"] = positionArray(std::move(found.point));
  return result;
}

}  // namespace

void bindInspect(py::module_& module) {
  using py::arg;
  module.def("inspect", &inspectArrays, arg("vertices"), arg("triangles"), py::kw_only(), arg("threads") = 0,
             arg("context") = py::none(),
             "Audit a solid and take stock of its shells; returns a dict of status, volume_mm3, area_mm2, "
             "audit, defects, shells and shell_of_triangle.");
  module.def("wall_thickness", &wallThicknessArray, arg("vertices"), arg("triangles"), py::kw_only(),
             arg("edges") = py::none(), arg("threads") = 0, arg("context") = py::none(),
             "For each triangle of a solid, the way from its middle straight through the material; infinite "
             "where there is no wall, such as at triangles with a value above 0 in `edges`.");
  module.def("closest_points", &closestPoints, arg("vertices"), arg("triangles"), arg("points"),
             py::kw_only(), arg("context") = py::none(),
             "The points of a valid surface that are closest to `points`; returns a dict of distance, "
             "triangle, on_rim and point.");
}

}  // namespace thicken::python
