// SPDX-License-Identifier: LGPL-2.1-or-later
//
// The table of file formats. A new format is one file with its reader or writer, declared here,
// and one line in the table.
#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "io/source_file.h"
#include "io/target_file.h"
#include "thicken/mesh.h"
#include "thicken/options.h"
#include "thicken/result.h"

namespace thicken::io {

/// Readers return the mesh as it stands in the file, not welded. They throw Error(kUnreadable).
using Reader = TriangleMesh (*)(const SourceFile& file);
TriangleMesh readStl(const SourceFile& file);
TriangleMesh readPly(const SourceFile& file);
/// The numbers of a property of the vertices.
std::vector<double> readPlyProperty(const SourceFile& file, const std::string& name);
TriangleMesh readObj(const SourceFile& file);
TriangleMesh readOff(const SourceFile& file);
TriangleMesh read3mf(const SourceFile& file);

/// Writers get finite positions and indices within their range. They throw Error(kUnwritable).
using Writer = void (*)(TargetFile& file, const TriangleMesh& mesh);
void writeStl(TargetFile& file, const TriangleMesh& mesh);
void writePly(TargetFile& file, const TriangleMesh& mesh);
void writeObj(TargetFile& file, const TriangleMesh& mesh);
void writeOff(TargetFile& file, const TriangleMesh& mesh);
void write3mf(TargetFile& file, const TriangleMesh& mesh);
/// The same for several meshes, each an object of its own. `regions`: those of the triangles of each, as
/// colours; empty: none.
using SeveralWriter = void (*)(TargetFile& file, std::span<const TriangleMesh> meshes,
                               std::span<const std::vector<Region>> regions);
void writeObjects3mf(TargetFile& file, std::span<const TriangleMesh> meshes,
                     std::span<const std::vector<Region>> regions);

struct Format {
  std::string_view extension;            ///< with its dot, in lower case
  Reader read;                           ///< nullptr: cannot be read
  Writer write;                          ///< nullptr: cannot be written
  Precision precision;                   ///< of the coordinates as they are written
  SeveralWriter writeSeveral = nullptr;  ///< nullptr: the format holds one mesh, and no colours
};

[[nodiscard]] std::span<const Format> formats();

/// The format that the extension of `path` names in whatever case; nullptr: none.
[[nodiscard]] const Format* formatOf(const std::filesystem::path& path);

}  // namespace thicken::io
