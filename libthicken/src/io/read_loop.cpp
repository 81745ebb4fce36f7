// SPDX-License-Identifier: LGPL-2.1-or-later
#include <cmath>

#include "io/source_file.h"
#include "io/text_scanner.h"
#include "thicken/trim.h"

namespace thicken {

TrimLoop readLoop(const std::filesystem::path& path) {
  const io::SourceFile file(path);
  io::TextScanner text(file, {.comment = '#'});
  TrimLoop loop;
  while (!text.atEnd()) {
    const double x = text.number("the x coordinate");
    const double y = text.numberInLine("the y coordinate");
    const double z = text.numberInLine("the z coordinate");
    if (!std::isfinite(x) || !std::isfinite(y) || !std::isfinite(z)) text.fail("a coordinate is not finite");
    if (const std::string_view more = text.wordInLine(); !more.empty())
      text.fail(io::quotedWord(more) + " comes after the three numbers of a point");
    loop.emplace_back(x, y, z);
  }
  if (loop.size() > 1 && loop.front() == loop.back()) loop.pop_back();
  if (loop.size() < 3)
    file.fail("holds " + std::to_string(loop.size()) + " points; a loop takes three at least");
  return loop;
}

}  // namespace thicken
