// SPDX-License-Identifier: LGPL-2.1-or-later
#include "io/formats.h"
#include "io/mesh_text.h"

namespace thicken::io {

void writeObj(TargetFile& file, const TriangleMesh& mesh) {
  std::string text = "# millimetres, written by thicken\n";
  for (const Vec3& p : mesh.positions) {
    text += "v ";
    appendThree(text, p);
    text += '\n';
    file.writeWhenLong(text);
  }
  for (const Triangle& t : mesh.triangles) {
    text += "f ";
    appendThree(text, Triangle{t[0] + 1, t[1] + 1, t[2] + 1});  // counted from 1
    text += '\n';
    file.writeWhenLong(text);
  }
  file.write(text);
}

}  // namespace thicken::io
