// SPDX-License-Identifier: LGPL-2.1-or-later
#include <Eigen/Geometry>
#include <cmath>
#include <limits>

#include "io/byte_order.h"
#include "io/formats.h"
#include "mesh/float_lattice.h"

namespace thicken::io {
namespace {

// Must not begin with "solid", by which careless readers tell ASCII.
constexpr std::string_view kHeader = "Binary STL, millimetres. Written by thicken.";
constexpr std::size_t kHeaderBytes = 80;

void requireFloats(const TargetFile& file, const TriangleMesh& mesh) {
  for (std::size_t v = 0; v < mesh.positions.size(); ++v) {
    if (!mesh::isFloat(mesh.positions[v])) {
      file.fail("vertex " + std::to_string(v) +
                " has a coordinate that STL, which holds single precision, cannot store unchanged; thicken "
                "in single "
                "precision or write another format");
    }
  }
  if (mesh.triangles.size() > std::numeric_limits<std::uint32_t>::max()) {
    file.fail("the mesh has more triangles than an STL file can count");
  }
}

void appendVector(std::string& bytes, const Vec3& v) {
  for (int k = 0; k < 3; ++k) appendLittle(bytes, static_cast<float>(v[k]));
}

// The unit normal as ADMesh finds it, which takes any other one for an error that it has to fix: from edges
// in single precision, with one product of each pair rounded to it, and none where that is next to nothing.
// Only needles have another one in truth; no reader can tell more of theirs from single precision.
Vec3 storedNormal(const Vec3& a, const Vec3& b, const Vec3& c) {
  const Eigen::Vector3f from = a.cast<float>(), u = b.cast<float>() - from, v = c.cast<float>() - from;
  Vec3 rounded;
  for (int k = 0; k < 3; ++k) {
    const int i = (k + 1) % 3, j = (k + 2) % 3;
    const auto product = static_cast<float>(double(u[i]) * v[j]);
    rounded[k] = static_cast<float>(product - double(u[j]) * v[i]);
  }
  constexpr double kNothing = 1e-12;
  const double length = rounded.norm();
  if (!std::isfinite(length)) return (b - a).cross(c - a).stableNormalized();
  return length < kNothing ? Vec3(Vec3::Zero()) : Vec3(rounded / length);
}

}  // namespace

void writeStl(TargetFile& file, const TriangleMesh& mesh) {
  requireFloats(file, mesh);
  std::string bytes(kHeader);
  bytes.resize(kHeaderBytes, ' ');
  appendLittle(bytes, static_cast<std::uint32_t>(mesh.triangles.size()));
  for (const Triangle& t : mesh.triangles) {
    const Vec3 &a = mesh.positions[t[0]], &b = mesh.positions[t[1]], &c = mesh.positions[t[2]];
    appendVector(bytes, storedNormal(a, b, c));
    for (const Vec3* corner : {&a, &b, &c}) appendVector(bytes, *corner);
    appendLittle(bytes, std::uint16_t{0});  // attributes
    file.writeWhenLong(bytes);
  }
  file.write(bytes);
}

}  // namespace thicken::io
