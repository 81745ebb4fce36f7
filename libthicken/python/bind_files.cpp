// SPDX-License-Identifier: LGPL-2.1-or-later
#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>

#include "arrays.h"
#include "bindings.h"
#include "thicken/io.h"

namespace py = pybind11;

namespace thicken::python {
namespace {

py::tuple readArrays(const std::filesystem::path& path) {
  TriangleMesh mesh = [&path] {
    const py::gil_scoped_release released;
    return readMesh(path);
  }();
  const py::array corners = triangleArray(mesh.triangles);
  return py::make_tuple(positionArray(std::move(mesh.positions)), corners);
}

void writeArrays(const std::filesystem::path& path, const py::object& vertices, const py::object& triangles,
                 const std::optional<RegionArray>& region) {
  const TriangleMesh mesh = meshFrom(vertices, triangles);
  std::vector<std::vector<Region>> regions;
  if (region) regions.push_back(regionsFrom(*region));
  const py::gil_scoped_release released;
  writeMeshes(path, std::span(&mesh, 1), regions);
}

}  // namespace

void bindFiles(py::module_& module) {
  using py::arg;
  module.def("read_mesh", &readArrays, arg("path"),
             "Read .stl, .ply, .obj, .off or .3mf; returns vertices and triangles, equal corners welded.");
  module.def("write_mesh", &writeArrays, arg("path"), arg("vertices"), arg("triangles"), py::kw_only(),
             arg("region") = py::none(),
             "Write .stl, .ply, .obj, .off or .3mf, by the extension, whole or not at all.");
}

}  // namespace thicken::python
