// SPDX-License-Identifier: LGPL-2.1-or-later
#include <pybind11/stl.h>

#include <algorithm>
#include <array>
#include <memory>
#include <utility>
#include <vector>

#include "arrays.h"
#include "bindings.h"
#include "from_json.h"
#include "interruptible.h"
#include "thicken/report.h"
#include "thicken/trim.h"

namespace py = pybind11;

namespace thicken::python {
namespace {

TrimLoop loopFrom(const py::handle& points) {
  return meshFrom(points, py::list()).positions;
}

py::dict trimArrays(const py::object& vertices, const py::object& triangles, const py::list& loops,
                    const std::optional<std::array<double, 3>>& keep, int smooth, bool single, int threads,
                    const std::optional<RunContext>& context) {
  const RunContext run = context.value_or(RunContext());
  const TriangleMesh surface = meshFrom(vertices, triangles);
  std::vector<TrimLoop> lines;
  for (const py::handle& loop : loops) lines.push_back(loopFrom(loop));
  TrimOptions options;
  if (keep) options.keep = Vec3((*keep)[0], (*keep)[1], (*keep)[2]);
  options.smooth = smooth;
  options.precision = single ? Precision::kSingle : Precision::kDouble;
  TrimmedSurface part = runInterruptibly(run, [&] { return trim(surface, lines, options, run, threads); });
  py::dict result;
  result["report"] = fromJson(toJson(part.facts));
  result["vertices"] = positionArray(std::move(part.mesh.positions));
  result["triangles"] = triangleArray(part.mesh.triangles);
  py::array_t<std::int64_t> origin(static_cast<py::ssize_t>(part.origin.size()));
  std::copy(part.origin.begin(), part.origin.end(), origin.mutable_data());
  result["origin"] = std::move(origin);
  py::list paths;
  for (TrimLoop& path : part.paths) paths.append(positionArray(std::move(path)));
  result["paths"] = std::move(paths);
  return result;
}

std::unique_ptr<SurfacePaths> pathsOn(const py::object& vertices, const py::object& triangles, int threads) {
  const TriangleMesh surface = meshFrom(vertices, triangles);
  const py::gil_scoped_release released;
  return std::make_unique<SurfacePaths>(surface, threads);
}

py::array pathArray(const SurfacePaths& paths, const py::object& points, bool closed, int smooth) {
  const TrimLoop loop = loopFrom(points);
  TrimLoop path = [&] {
    const py::gil_scoped_release released;
    return paths.path(loop, closed, smooth);
  }();
  return positionArray(std::move(path));
}

}  // namespace

void bindTrim(py::module_& module) {
  using py::arg;
  module.def("trim", &trimArrays, arg("vertices"), arg("triangles"), arg("loops"), py::kw_only(),
             arg("keep") = py::none(), arg("smooth") = 0, arg("single") = true, arg("threads") = 0,
             arg("context") = py::none(),
             "Cut a part out of a surface along closed loops; returns a dict of vertices, triangles, origin, "
             "paths and report.");
  py::class_<SurfacePaths>(module, "SurfacePaths", "Paths on a surface, as trim() takes them.")
      .def(py::init(&pathsOn), arg("vertices"), arg("triangles"), py::kw_only(), arg("threads") = 0)
      .def("path", &pathArray, arg("points"), py::kw_only(), arg("closed") = true, arg("smooth") = 0,
           "The corners of the path through points near the surface.");
}

}  // namespace thicken::python
