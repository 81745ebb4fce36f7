// SPDX-License-Identifier: LGPL-2.1-or-later
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

void writeArrays(const std::filesystem::path& path, const py::object& vertices, const py::object& triangles) {
  const TriangleMesh mesh = meshFrom(vertices, triangles);
  const py::gil_scoped_release released;
  writeMesh(path, mesh);
}

}  // namespace

void bindFiles(py::module_& module) {
  using py::arg;
  module.def("read_mesh", &readArrays, arg("path"),
             "Read .stl, .ply, .obj or .off; returns vertices and triangles, equal corners welded.");
  module.def("write_mesh", &writeArrays, arg("path"), arg("vertices"), arg("triangles"),
             "Write .stl, .ply, .obj, .off or .3mf, by the extension, whole or not at all.");
}

}  // namespace thicken::python
