// SPDX-License-Identifier: LGPL-2.1-or-later
#include <pybind11/stl.h>

#include <cmath>
#include <utility>

#include "arrays.h"
#include "bindings.h"
#include "thicken/picture.h"

namespace py = pybind11;

namespace thicken::python {
namespace {

using Triple = std::array<double, 3>;
using Numbers = py::array_t<double, py::array::c_style | py::array::forcecast>;

Vec3 vectorOf(const Triple& triple) {
  return {triple[0], triple[1], triple[2]};
}

std::vector<Colour> coloursFrom(const Numbers& colours) {
  if (colours.ndim() != 2 || colours.shape(1) != 3)
    throw py::value_error("colours must have the shape (triangles, 3), or (1, 3)");
  std::vector<Colour> result(static_cast<std::size_t>(colours.shape(0)));
  const double* value = colours.data();
  for (Colour& colour : result)
    for (std::uint8_t& part : colour) {
      if (!(*value >= 0 && *value <= 255)) throw py::value_error("colours must be from 0 to 255");
      part = static_cast<std::uint8_t>(*value++);
    }
  return result;
}

py::bytes drawArrays(const py::object& vertices, const py::object& triangles,
                     const std::optional<Numbers>& colours, const std::optional<RegionArray>& region,
                     const Triple& towards, const Triple& up, std::pair<int, int> size,
                     const std::optional<std::pair<Triple, Triple>>& cut) {
  if (colours.has_value() == region.has_value()) throw py::value_error("give either colours or region");
  const TriangleMesh mesh = meshFrom(vertices, triangles);
  const std::vector<Colour> painted = colours ? coloursFrom(*colours) : coloursOf(regionsFrom(*region));
  View view;
  view.towards = vectorOf(towards);
  view.up = vectorOf(up);
  view.width = size.first;
  view.height = size.second;
  if (cut) view.cut = View::Cut{vectorOf(cut->first), vectorOf(cut->second)};
  const std::string png = [&] {
    const py::gil_scoped_release released;
    return toPng(renderPicture(mesh, painted, view));
  }();
  return {png};
}

}  // namespace

void bindPicture(py::module_& module) {
  using py::arg;
  module.def("render_picture", &drawArrays, arg("vertices"), arg("triangles"), py::kw_only(),
             arg("colours") = py::none(), arg("region") = py::none(), arg("towards"), arg("up"), arg("size"),
             arg("cut") = py::none(), "Draw a mesh; returns the bytes of a PNG file.");
  module.def(
      "view_direction",
      [](const Triple& up, double turn, double rise) {
        const Vec3 towards = viewDirection(vectorOf(up), turn, rise);
        return Triple{towards.x(), towards.y(), towards.z()};
      },
      arg("up"), arg("turn"), arg("rise"),
      "The direction that an eye looks in, turned around a part and risen.");
}

}  // namespace thicken::python
