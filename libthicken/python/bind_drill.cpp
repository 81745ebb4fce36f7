// SPDX-License-Identifier: LGPL-2.1-or-later
#include <pybind11/stl.h>

#include <array>
#include <utility>
#include <vector>

#include "arrays.h"
#include "bindings.h"
#include "interruptible.h"
#include "thicken/drain.h"

namespace py = pybind11;

namespace thicken::python {
namespace {

py::tuple toTuple(const Vec3& p) {
  return py::make_tuple(p[0], p[1], p[2]);
}

using Triple = std::array<double, 3>;

py::dict drillArrays(const py::object& vertices, const py::object& triangles,
                     const std::vector<Triple>& places, const std::vector<Triple>& axes, double diameter,
                     int sides, int threads, const std::optional<RunContext>& context) {
  if (places.size() != axes.size()) throw py::value_error("places and axes must have the same length");
  const RunContext run = context.value_or(RunContext());
  const TriangleMesh solid = meshFrom(vertices, triangles);
  std::vector<DrainHole> holes(places.size());
  for (std::size_t i = 0; i < holes.size(); ++i) {
    holes[i].place = Vec3(places[i][0], places[i][1], places[i][2]);
    holes[i].axis = Vec3(axes[i][0], axes[i][1], axes[i][2]);
    holes[i].diameter = diameter;
    holes[i].sides = sides;
  }
  DrilledSolid drilled = runInterruptibly(run, [&] { return drill(solid, holes, run, threads); });
  py::dict result;
  result["candidate"] = drilled.candidate;
  result["untouched"] = drilled.untouched;
  result["entry"] = toTuple(drilled.entry);
  result["exit"] = toTuple(drilled.exit);
  result["axis"] = toTuple(drilled.axis);
  result["walled"] = py::make_tuple(drilled.walledFrom, drilled.walledTo);
  result["outline"] = positionArray(std::move(drilled.outline));
  result["vertices"] = positionArray(std::move(drilled.mesh.positions));
  result["triangles"] = triangleArray(drilled.mesh.triangles);
  return result;
}

}  // namespace

void bindDrill(py::module_& module) {
  using py::arg;
  module.def(
      "drill", &drillArrays, arg("vertices"), arg("triangles"), arg("places"), arg("axes"), arg("diameter"),
      py::kw_only(), arg("sides") = 24, arg("threads") = 0, arg("context") = py::none(),
      "Drill a straight hole through the wall of a solid, at the first of `places` where it can be: into "
      "the material that begins nearest to it, the way that its one of `axes` leads. Returns a dict of "
      "vertices, triangles (`untouched` of them first), candidate, entry, exit, axis, outline and walled: "
      "from where to where along the axis the hole has its wall all around.");
}

}  // namespace thicken::python
