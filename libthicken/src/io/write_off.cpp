// SPDX-License-Identifier: LGPL-2.1-or-later
#include "io/formats.h"
#include "io/mesh_text.h"

namespace thicken::io {

void writeOff(TargetFile& file, const TriangleMesh& mesh) {
  std::string text =
      "OFF\n" + std::to_string(mesh.positions.size()) + ' ' + std::to_string(mesh.triangles.size()) + " 0\n";
  for (const Vec3& p : mesh.positions) {
    appendThree(text, p);
    text += '\n';
    file.writeWhenLong(text);
  }
  for (const Triangle& t : mesh.triangles) {
    text += "3 ";
    appendThree(text, t);
    text += '\n';
    file.writeWhenLong(text);
  }
  file.write(text);
}

}  // namespace thicken::io
