// SPDX-License-Identifier: LGPL-2.1-or-later
#include <limits>

#include "io/byte_order.h"
#include "io/formats.h"

namespace thicken::io {
namespace {

std::string headerOf(const TriangleMesh& mesh) {
  // Most readers expect int; uint only where it takes it.
  const bool wide = mesh.positions.size() > std::size_t{std::numeric_limits<std::int32_t>::max()};
  return "ply\nformat binary_little_endian 1.0\ncomment millimetres, written by thicken\nelement vertex " +
         std::to_string(mesh.positions.size()) +
         "\nproperty double x\nproperty double y\nproperty double z\nelement face " +
         std::to_string(mesh.triangles.size()) + "\nproperty list uchar " + (wide ? "uint" : "int") +
         " vertex_indices\nend_header\n";
}

}  // namespace

void writePly(TargetFile& file, const TriangleMesh& mesh) {
  std::string bytes = headerOf(mesh);
  for (const Vec3& p : mesh.positions) {
    for (int k = 0; k < 3; ++k) appendLittle(bytes, p[k]);
    file.writeWhenLong(bytes);
  }
  for (const Triangle& t : mesh.triangles) {
    appendLittle(bytes, std::uint8_t{3});
    for (const VertexId v : t) appendLittle(bytes, v);
    file.writeWhenLong(bytes);
  }
  file.write(bytes);
}

}  // namespace thicken::io
