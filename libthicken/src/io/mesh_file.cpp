// SPDX-License-Identifier: LGPL-2.1-or-later
#include <algorithm>
#include <memory>
#include <new>
#include <string>

#include "io/formats.h"
#include "mesh/vertex_values.h"
#include "thicken/check.h"
#include "thicken/error.h"
#include "thicken/io.h"

namespace thicken {
namespace {

// ".stl, .ply and .obj": the formats that have `part`, a reader or a writer.
template <class Part>
std::string supported(Part io::Format::*part) {
  std::vector<std::string_view> names;
  for (const io::Format& format : io::formats()) {
    if (format.*part) names.push_back(format.extension);
  }
  std::string list;
  for (std::size_t i = 0; i < names.size(); ++i) {
    if (i > 0) list += i + 1 < names.size() ? ", " : " and ";
    list += names[i];
  }
  return list;
}

template <class Part>
const io::Format& require(const std::filesystem::path& path, Part io::Format::*part, ErrorCode code,
                          const std::string& done) {
  const io::Format* format = io::formatOf(path);
  if (format && format->*part) return *format;
  const std::string extension = path.extension().string();
  throw Error(code, io::quoted(path) + ": " +
                        (extension.empty() ? "the name has no extension that tells the format"
                                           : "files of type " + extension + " cannot be " + done) +
                        "; the formats that can be " + done + " are " + supported(part) + ".");
}

const io::Format& readable(const std::filesystem::path& path) {
  return require(path, &io::Format::read, ErrorCode::kUnreadable, "read");
}

const io::Format& writable(const std::filesystem::path& path) {
  return require(path, &io::Format::write, ErrorCode::kUnwritable, "written");
}

void requireStorable(const TriangleMesh& mesh, const std::filesystem::path& path) {
  for (std::size_t v = 0; v < mesh.positions.size(); ++v) {
    if (!mesh.positions[v].allFinite()) {
      throw Error(ErrorCode::kUnwritable, io::quoted(path) + ": vertex " + std::to_string(v) +
                                              " of the mesh has a coordinate that is not finite.");
    }
  }
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    if (std::ranges::max(mesh.triangles[t]) >= mesh.positions.size()) {
      throw Error(ErrorCode::kUnwritable, io::quoted(path) + ": triangle " + std::to_string(t) +
                                              " of the mesh names a vertex that the mesh does not have.");
    }
  }
}

void requireColours(const std::filesystem::path& path, std::span<const TriangleMesh> meshes,
                    std::span<const std::vector<Region>> regions) {
  if (regions.empty()) return;
  if (!holdsColours(path))
    throw Error(ErrorCode::kUnwritable, io::quoted(path) + ": only .3mf files hold the regions as colours.");
  bool fits = regions.size() == meshes.size();
  for (std::size_t i = 0; fits && i < meshes.size(); ++i)
    fits = regions[i].size() == meshes[i].triangles.size();
  if (!fits)
    throw Error(ErrorCode::kUnwritable, io::quoted(path) + ": there is not a region for each triangle.");
}

}  // namespace

void requireReadable(const std::filesystem::path& path) {
  readable(path);
}

void requireWritable(const std::filesystem::path& path) {
  writable(path);
}

bool namesItsUnit(const std::filesystem::path& path) {
  const io::Format* format = io::formatOf(path);
  return format != nullptr && format->read == io::read3mf;
}

Precision storedPrecision(const std::filesystem::path& path) {
  const io::Format* format = io::formatOf(path);
  return format ? format->precision : Precision::kDouble;
}

TriangleMesh readMesh(const std::filesystem::path& path) {
  return readMeshFile(path).mesh;
}

MeshFile readMeshFile(const std::filesystem::path& path) {
  const io::Format& format = readable(path);
  MeshFile result;
  try {
    {
      const io::SourceFile file(path);  // the bytes go before the welding
      result.mesh = format.read(file);
      result.warnings = file.passedOver();
    }
    result.mesh = weld(result.mesh);
    return result;
  } catch (const std::bad_alloc&) {
    throw Error(ErrorCode::kMemoryLimit,
                io::quoted(path) + ": the memory of this machine does not suffice to read the file.");
  }
}

std::vector<double> readVertexProperty(const std::filesystem::path& path, const std::string& name) {
  if (readable(path).read != &io::readPly)
    throw Error(ErrorCode::kUnreadable, io::quoted(path) + ": only .ply files have properties of vertices.");
  const io::SourceFile file(path);
  const TriangleMesh mesh = io::readPly(file);
  return mesh::valuesAt(mesh, io::readPlyProperty(file, name), weld(mesh), "\"" + name + "\"");
}

std::vector<std::filesystem::path> pathsOfMeshes(const std::filesystem::path& path, std::size_t count) {
  const io::Format& format = writable(path);
  if (count == 1 || format.writeSeveral) return {path};
  std::vector<std::filesystem::path> paths;
  for (std::size_t i = 1; i <= count; ++i) {
    std::filesystem::path name = path.stem();
    name += "-" + std::to_string(i);
    name += path.extension();
    paths.push_back(path.parent_path() / name);
  }
  return paths;
}

bool holdsColours(const std::filesystem::path& path) {
  const io::Format* format = io::formatOf(path);
  return format != nullptr && format->writeSeveral != nullptr;
}

void writeMeshes(const std::filesystem::path& path, std::span<const TriangleMesh> meshes,
                 std::span<const std::vector<Region>> regions) {
  const io::Format& format = writable(path);
  requireColours(path, meshes, regions);
  for (const TriangleMesh& mesh : meshes) requireStorable(mesh, path);
  std::vector<std::unique_ptr<io::TargetFile>> files;
  for (const std::filesystem::path& name : pathsOfMeshes(path, meshes.size()))
    files.push_back(std::make_unique<io::TargetFile>(name));
  if (format.writeSeveral)
    format.writeSeveral(*files.front(), meshes, regions);
  else
    for (std::size_t i = 0; i < files.size(); ++i) format.write(*files[i], meshes[i]);
  for (const auto& file : files) file->commit();
}

void writeMesh(const std::filesystem::path& path, const TriangleMesh& mesh) {
  const io::Format& format = writable(path);
  requireStorable(mesh, path);
  io::TargetFile file(path);
  format.write(file, mesh);
  file.commit();
}

}  // namespace thicken
