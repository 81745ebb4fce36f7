// SPDX-License-Identifier: LGPL-2.1-or-later
#include <pybind11/stl.h>

#include <algorithm>
#include <utility>

#include "arrays.h"
#include "bindings.h"
#include "from_json.h"
#include "interruptible.h"
#include "thicken/check.h"
#include "thicken/repair.h"
#include "thicken/report.h"
#include "thicken/sheets.h"

namespace py = pybind11;

namespace thicken::python {
namespace {

py::dict repairArrays(const py::object& vertices, const py::object& triangles, std::optional<double> distance,
                      std::optional<double> bridge, std::optional<double> longestHole, int threads,
                      const std::optional<RunContext>& context) {
  const RunContext run = context.value_or(RunContext());
  const TriangleMesh mesh = meshFrom(vertices, triangles);
  RepairResult mended = runInterruptibly(run, [&] {
    return repair(weld(mesh), {distance, bridge, longestHole}, run, threads);
  });
  py::dict result;
  result["report"] = fromJson(toJson(mended.facts));
  result["vertices"] = positionArray(std::move(mended.mesh.positions));
  result["triangles"] = triangleArray(mended.mesh.triangles);
  py::array_t<std::int64_t> origin(static_cast<py::ssize_t>(mended.origin.size()));
  std::transform(mended.origin.begin(), mended.origin.end(), origin.mutable_data(),
                 [](TriangleId t) { return t == RepairResult::kAdded ? std::int64_t{-1} : std::int64_t{t}; });
  result["origin"] = std::move(origin);
  return result;
}

py::list sheetArrays(const py::object& vertices, const py::object& triangles) {
  const TriangleMesh mesh = meshFrom(vertices, triangles);
  std::vector<Sheet> sheets = [&mesh] {
    const py::gil_scoped_release released;
    return divideIntoSheets(weld(mesh));
  }();
  py::list result;
  for (Sheet& sheet : sheets) {
    const py::array corners = triangleArray(sheet.mesh.triangles);
    result.append(py::make_tuple(positionArray(std::move(sheet.mesh.positions)), corners));
  }
  return result;
}

}  // namespace

void bindRepair(py::module_& module) {
  using py::arg;
  module.def(
      "repair_mesh", &repairArrays, arg("vertices"), arg("triangles"), py::kw_only(),
      arg("weld") = py::none(), arg("bridge") = py::none(), arg("fill_holes") = py::none(),
      arg("threads") = 0, arg("context") = py::none(),
      "Make a valid surface of a defective one; returns a dict of vertices, triangles, origin and report.");
  module.def("divide_into_sheets", &sheetArrays, arg("vertices"), arg("triangles"),
             "The sheets of a surface with edges of three and more triangles; returns a list of vertices and "
             "triangles, the largest first.");
}

}  // namespace thicken::python
