// SPDX-License-Identifier: LGPL-2.1-or-later
#include <pybind11/stl.h>

#include <array>
#include <utility>

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

py::dict drillArrays(const py::object& vertices, const py::object& triangles,
                     const std::array<double, 3>& place, const std::array<double, 3>& axis, double diameter,
                     int sides, int threads, const std::optional<RunContext>& context) {
  const RunContext run = context.value_or(RunContext());
  const TriangleMesh solid = meshFrom(vertices, triangles);
  DrainHole hole;
  hole.place = Vec3(place[0], place[1], place[2]);
  hole.axis = Vec3(axis[0], axis[1], axis[2]);
  hole.diameter = diameter;
  hole.sides = sides;
  DrilledSolid drilled = runInterruptibly(run, [&] { return drill(solid, hole, run, threads); });
  py::dict result;
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
      "drill", &drillArrays, arg("vertices"), arg("triangles"), arg("place"), arg("axis"), arg("diameter"),
      py::kw_only(), arg("sides") = 24, arg("threads") = 0, arg("context") = py::none(),
      "Drill a straight hole through the wall of a solid, at the material that begins nearest to "
      "`place`, the way `axis` leads into it; returns a dict of vertices, triangles (`untouched` of them "
      "first), entry, exit, axis, outline and walled: from where to where along the axis the hole "
      "has its wall all around.");
}

}  // namespace thicken::python
