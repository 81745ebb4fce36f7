// SPDX-License-Identifier: LGPL-2.1-or-later
//
// Reading and writing mesh files. The format follows from the extension of the path, whatever its
// case: .stl (binary and ASCII in, binary out), .ply (ASCII and binary, both byte orders, in;
// binary double out), .obj, .off and .3mf.
#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include "thicken/mesh.h"
#include "thicken/options.h"
#include "thicken/result.h"

namespace thicken {

/// Reads the triangles of a file; polygons are triangulated; the mesh is welded. Coordinates keep
/// the file's precision. Throws Error(kUnreadable) with a sentence that names the file, the place
/// in it and the reason.
[[nodiscard]] TriangleMesh readMesh(const std::filesystem::path& path);

/// A mesh with what was passed over when it was read, in sentences: bytes after the last triangle, statements
/// that are not known, an end that is missing.
struct MeshFile {
  TriangleMesh mesh;
  std::vector<std::string> warnings;
};

/// As readMesh(), which keeps the warnings to itself.
[[nodiscard]] MeshFile readMeshFile(const std::filesystem::path& path);

/// A property of the vertices of a .ply file, by its name: a number for each vertex of readMesh(). Throws
/// Error(kUnreadable) where the format or the file has none, kInvalidArgument where corners in one place have
/// different ones.
[[nodiscard]] std::vector<double> readVertexProperty(const std::filesystem::path& path,
                                                     const std::string& name);

/// Writes a mesh whole or not at all: into a temporary file beside `path`, which is renamed when
/// it is complete. Throws Error(kUnwritable).
void writeMesh(const std::filesystem::path& path, const TriangleMesh& mesh);

/// The files that writeMeshes() writes: `path` where it is one or the format holds several objects (.3mf),
/// else numbered ones, part-1.stl, part-2.stl, … for part.stl.
[[nodiscard]] std::vector<std::filesystem::path> pathsOfMeshes(const std::filesystem::path& path,
                                                               std::size_t count);

/// Writes several meshes, each an object or a file of its own. None of the files appears before all are
/// complete. `regions`: of solids, for each mesh those of its triangles, which become colours; only for
/// formats with colours, holdsColours(). Throws Error(kUnwritable).
void writeMeshes(const std::filesystem::path& path, std::span<const TriangleMesh> meshes,
                 std::span<const std::vector<Region>> regions = {});

/// Whether the format of `path` stores colours of triangles: .3mf.
[[nodiscard]] bool holdsColours(const std::filesystem::path& path);

/// Removes the temporary files of all calls of writeMesh() under way, which may then fail. For a
/// signal handler that is about to end the process; safe there. Nothing else needs it: writeMesh()
/// removes its temporary file itself, whatever goes wrong.
void abandonWrites() noexcept;

/// Throws Error(kUnreadable / kUnwritable) for a path whose extension is not known.
void requireReadable(const std::filesystem::path& path);
void requireWritable(const std::filesystem::path& path);

/// Whether files of the format of `path` tell the unit of their numbers, so that they are read as mm: .3mf.
[[nodiscard]] bool namesItsUnit(const std::filesystem::path& path);

/// The precision that the format of `path` stores: kSingle for .stl, else kDouble.
[[nodiscard]] Precision storedPrecision(const std::filesystem::path& path);

}  // namespace thicken
