// SPDX-License-Identifier: LGPL-2.1-or-later
#include "arrays.h"

#include <algorithm>
#include <cstring>
#include <limits>
#include <memory>
#include <string>
#include <string_view>

#include "thicken/error.h"

namespace py = pybind11;

namespace thicken::python {
namespace {

// The arrays below hand the memory of the library's vectors to NumPy as it is.
static_assert(sizeof(Vec3) == 3 * sizeof(double));
static_assert(sizeof(Triangle) == 3 * sizeof(VertexId));
static_assert(sizeof(Region) == 1);

std::string shapeText(const py::array& array) {
  return py::str(py::tuple(array.attr("shape"))).cast<std::string>();
}

/// `source` as a k × 3 array whose dtype is of one of the `kinds` (NumPy's one-letter kinds). An
/// array without elements has no type worth checking: an empty list arrives as float64.
py::array tableOf(const py::handle& source, const char* what, std::string_view kinds, const char* wanted) {
  const py::array array(py::reinterpret_borrow<py::object>(source));
  if (array.size() == 0) return py::array_t<double>(std::vector<py::ssize_t>{0, 3});
  if (kinds.find(array.dtype().kind()) == std::string_view::npos)
    throw py::type_error(std::string(what) + " must be " + wanted + ", not of type " +
                         py::str(array.dtype()).cast<std::string>());
  if (array.ndim() != 2 || array.shape(1) != 3)
    throw py::value_error(std::string(what) + " must have the shape (n, 3), not " + shapeText(array));
  return array;
}

/// Contiguous, in rows; converting an array to it copies where it has to, and raises where it cannot.
template <class T>
using Rows = py::array_t<T, py::array::c_style | py::array::forcecast>;

template <class T>
py::capsule ownerOf(std::unique_ptr<T>& held) {
  py::capsule owner(held.get(), [](void* memory) { delete static_cast<T*>(memory); });
  (void)held.release();
  return owner;
}

}  // namespace

TriangleMesh meshFrom(const py::handle& vertices, const py::handle& triangles) {
  const auto positions = Rows<double>(tableOf(vertices, "vertices", "fiu", "real numbers"));
  const auto indices = Rows<std::int64_t>(tableOf(triangles, "triangles", "iu", "integers"));
  const auto n = static_cast<std::int64_t>(positions.shape(0));
  if (n > std::numeric_limits<VertexId>::max() || indices.shape(0) > std::numeric_limits<TriangleId>::max())
    throw Error(ErrorCode::kTooLarge,
                "The mesh has more elements than 32-bit indices can name; simplify it.");

  TriangleMesh mesh;
  mesh.positions.resize(static_cast<std::size_t>(n));
  std::copy_n(positions.data(), 3 * n, reinterpret_cast<double*>(mesh.positions.data()));
  mesh.triangles.resize(static_cast<std::size_t>(indices.shape(0)));
  const std::int64_t* index = indices.data();
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
    for (VertexId& corner : mesh.triangles[t]) {
      if (*index < 0 || *index >= n)
        throw py::value_error("triangle " + std::to_string(t) + " names vertex " + std::to_string(*index) +
                              ", but there are " + std::to_string(n) + " vertices");
      corner = static_cast<VertexId>(*index++);
    }
  return mesh;
}

py::array positionArray(std::vector<Vec3> positions) {
  auto held = std::make_unique<std::vector<Vec3>>(std::move(positions));
  const auto n = static_cast<py::ssize_t>(held->size());
  const auto* data = reinterpret_cast<const double*>(held->data());
  return py::array_t<double>({n, py::ssize_t{3}}, data, ownerOf(held));
}

py::array triangleArray(const std::vector<Triangle>& triangles) {
  py::array_t<std::int64_t> result({static_cast<py::ssize_t>(triangles.size()), py::ssize_t{3}});
  std::int64_t* out = result.mutable_data();
  for (const Triangle& triangle : triangles) out = std::copy(triangle.begin(), triangle.end(), out);
  return result;
}

py::array regionArray(const std::vector<Region>& regions) {
  py::array_t<std::uint8_t> result(static_cast<py::ssize_t>(regions.size()));
  std::transform(regions.begin(), regions.end(), result.mutable_data(),
                 [](Region region) { return static_cast<std::uint8_t>(region); });
  return result;
}

std::vector<Region> regionsFrom(const RegionArray& array) {
  std::vector<Region> regions;
  for (py::ssize_t i = 0; i < array.size(); ++i) {
    if (array.data()[i] > static_cast<std::uint8_t>(Region::kWall))
      throw py::value_error("regions must be values of Region");
    regions.push_back(static_cast<Region>(array.data()[i]));
  }
  return regions;
}

py::array numberArray(std::vector<double> numbers) {
  auto held = std::make_unique<std::vector<double>>(std::move(numbers));
  const auto n = static_cast<py::ssize_t>(held->size());
  const double* data = held->data();
  return py::array_t<double>({n}, data, ownerOf(held));
}

}  // namespace thicken::python
