// SPDX-License-Identifier: LGPL-2.1-or-later
//
// Pictures of meshes, drawn without a window: an orthographic view of flat triangles, lit from the upper left
// behind the eye. The same bytes on every machine with the same zlib.
#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "thicken/mesh.h"
#include "thicken/result.h"

namespace thicken {

/// Red, green and blue, 0 to 255.
using Colour = std::array<std::uint8_t, 3>;

struct Picture {
  int width = 0, height = 0;   ///< pixels
  std::vector<Colour> pixels;  ///< row by row, from the upper left
};

/// What the eye meets where a cut goes through material, and where an open mesh shows its back.
inline constexpr Colour kBackColour{70, 74, 82};

struct View {
  Vec3 towards{-0.7094, -0.4096,
               -0.5736};          ///< the direction that the eye looks in; viewDirection(up, 30, 35)
  Vec3 up{0, 0, 1};               ///< what points up in the picture; not along `towards`
  int width = 640, height = 480;  ///< pixels; 1 to 8192
  /// What lies on the side of this plane that its normal points to is taken away. The normal has to face the
  /// eye.
  struct Cut {
    Vec3 point, normal;
  };
  std::optional<Cut> cut;
};

/// The direction that an eye looks in that has gone `turn` degrees around a part that grows along `up`, and
/// `rise` degrees above it.
[[nodiscard]] Vec3 viewDirection(const Vec3& up, double turn, double rise);

/// The colours that the three regions of a solid are shown in.
[[nodiscard]] Colour colourOf(Region region) noexcept;
[[nodiscard]] std::vector<Colour> coloursOf(std::span<const Region> regions);

/// Draws the triangles that face the eye, each in its colour, as large as the picture allows; `colours` has
/// one for each triangle, or one for all. Backs are of kBackColour. Throws Error(kInvalidArgument) for a view
/// out of range. Cost: O(triangles + pixels covered).
[[nodiscard]] Picture renderPicture(const TriangleMesh& mesh, std::span<const Colour> colours,
                                    const View& view = {});

/// Draws several solids together, in the colours of their regions; `regions` has those of each, or is empty:
/// all of one colour.
[[nodiscard]] Picture renderSolids(std::span<const TriangleMesh> solids,
                                   std::span<const std::vector<Region>> regions, const View& view = {});

/// Pictures of the same height as one, side by side.
[[nodiscard]] Picture besideEachOther(std::span<const Picture> pictures);

/// The bytes of a PNG file.
[[nodiscard]] std::string toPng(const Picture& picture);

/// Writes a PNG file whole or not at all. Throws Error(kUnwritable).
void writePicture(const std::filesystem::path& path, const Picture& picture);

}  // namespace thicken
