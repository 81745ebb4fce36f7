// SPDX-License-Identifier: LGPL-2.1-or-later
//
// 3MF core specification 1.3: a zip archive of a model, a thumbnail and what names them. Own XML because
// lib3mf keeps single precision; libzip packs it. The same mesh gives the same bytes: no dates, no names of
// machines.
#include <fmt/format.h>
#include <zip.h>

#include <array>
#include <memory>

#include "io/formats.h"
#include "io/mesh_text.h"
#include "thicken/picture.h"

namespace thicken::io {
namespace {

constexpr std::string_view kContentTypes =
    R"(<?xml version="1.0" encoding="UTF-8"?>
<Types xmlns="http://schemas.openxmlformats.org/package/2006/content-types">
<Default Extension="rels" ContentType="application/vnd.openxmlformats-package.relationships+xml"/>
<Default Extension="model" ContentType="application/vnd.ms-package.3dmanufacturing-3dmodel+xml"/>
<Default Extension="png" ContentType="image/png"/>
</Types>
)";
constexpr std::string_view kRelationships =
    R"(<?xml version="1.0" encoding="UTF-8"?>
<Relationships xmlns="http://schemas.openxmlformats.org/package/2006/relationships">
<Relationship Id="rel0" Target="/3D/3dmodel.model" Type="http://schemas.microsoft.com/3dmanufacturing/2013/01/3dmodel"/>
<Relationship Id="rel1" Target="/Metadata/thumbnail.png" Type="http://schemas.openxmlformats.org/package/2006/relationships/metadata/thumbnail"/>
</Relationships>
)";
constexpr std::string_view kModelBegin =
    R"(<?xml version="1.0" encoding="UTF-8"?>
<model unit="millimeter" xml:lang="en-US" xmlns="http://schemas.microsoft.com/3dmanufacturing/core/2015/02">
<metadata name="Application">thicken</metadata>
<resources>)";

// The colours of the regions as materials, which have the number of their region.
std::string materialsOf(std::size_t id) {
  constexpr std::array<std::pair<const char*, Region>, 3> kMaterials{
      {{"surface", Region::kOriginal}, {"shell", Region::kShell}, {"wall", Region::kWall}}};
  std::string xml = "<basematerials id=\"" + std::to_string(id) + "\">";
  for (const auto& [material, region] : kMaterials) {
    const Colour c = colourOf(region);
    xml +=
        fmt::format("<base name=\"{}\" displaycolor=\"#{:02X}{:02X}{:02X}\"/>", material, c[0], c[1], c[2]);
  }
  return xml + "</basematerials>";
}

// `materials`: the id of the colours; 0: none.
void appendObject(std::string& xml, std::size_t id, const TriangleMesh& mesh, std::span<const Region> regions,
                  std::size_t materials) {
  const bool isColoured = !regions.empty();
  xml += fmt::format("<object id=\"{}\" type=\"model\"", id);
  if (isColoured) xml += fmt::format(" pid=\"{}\" pindex=\"0\"", materials);
  xml += "><mesh><vertices>\n";
  const auto append = [&xml](std::string_view element, std::array<std::string_view, 3> names,
                             const auto& values) {
    xml += element;
    for (int k = 0; k < 3; ++k) {
      xml += names[static_cast<std::size_t>(k)];
      appendNumber(xml, values[static_cast<std::size_t>(k)]);
    }
  };
  for (const Vec3& p : mesh.positions) {
    append("<vertex", {" x=\"", "\" y=\"", "\" z=\""}, std::array{p[0], p[1], p[2]});
    xml += "\"/>\n";
  }
  xml += "</vertices><triangles>\n";
  const std::string material = fmt::format("\" pid=\"{}\" p1=\"", materials);
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    append("<triangle", {" v1=\"", "\" v2=\"", "\" v3=\""}, mesh.triangles[t]);
    if (isColoured) {
      xml += material;
      xml += static_cast<char>('0' + static_cast<int>(regions[t]));
    }
    xml += "\"/>\n";
  }
  xml += "</triangles></mesh></object>";
}

std::string modelOf(std::span<const TriangleMesh> meshes, std::span<const std::vector<Region>> regions) {
  std::string xml(kModelBegin), items;
  const std::size_t materials = meshes.size() + 1;
  if (!regions.empty()) xml += materialsOf(materials);
  for (std::size_t i = 1; i <= meshes.size(); ++i) {
    appendObject(xml, i, meshes[i - 1], regions.empty() ? std::span<const Region>() : regions[i - 1],
                 materials);
    items += "<item objectid=\"" + std::to_string(i) + "\"/>";
  }
  return xml + "</resources>\n<build>" + items + "</build>\n</model>\n";
}

Picture drawn(std::span<const TriangleMesh> meshes, std::span<const std::vector<Region>> regions) {
  View view;
  view.width = view.height = 256;
  return renderSolids(meshes, regions, view);
}

struct FreeSource {
  void operator()(zip_source_t* source) const { zip_source_free(source); }
};
struct DiscardArchive {
  void operator()(zip_t* archive) const { zip_discard(archive); }
};
using Source = std::unique_ptr<zip_source_t, FreeSource>;
using Archive = std::unique_ptr<zip_t, DiscardArchive>;

void require(bool done, const char* reason, const TargetFile& file) {
  if (!done) file.fail(std::string("cannot be packed: ") + reason);
}

// `bytes` must outlive the archive.
void addPart(zip_t* archive, const char* name, std::string_view bytes, const TargetFile& file) {
  Source source(zip_source_buffer(archive, bytes.data(), bytes.size(), 0));
  require(source != nullptr, zip_strerror(archive), file);
  const zip_int64_t index = zip_file_add(archive, name, source.get(), ZIP_FL_ENC_UTF_8);
  require(index >= 0, zip_strerror(archive), file);
  source.release();  // the archive's from here on
  // Level 1 of 9: 6, the default, takes eight times as long for a seventh less.
  require(zip_set_file_compression(archive, static_cast<zip_uint64_t>(index), ZIP_CM_DEFLATE, 1) == 0,
          zip_strerror(archive), file);
  // 1980-01-01 00:00, the beginning of the archive's calendar, in place of now.
  constexpr zip_uint16_t kTime = 0, kDate = (1 << 5) | 1;
  require(zip_file_set_dostime(archive, static_cast<zip_uint64_t>(index), kTime, kDate, 0) == 0,
          zip_strerror(archive), file);
}

void copyTo(TargetFile& file, zip_source_t* source) {
  require(zip_source_open(source) == 0, zip_error_strerror(zip_source_error(source)), file);
  std::string block(std::size_t{1} << 20, '\0');
  for (;;) {
    const zip_int64_t read = zip_source_read(source, block.data(), block.size());
    require(read >= 0, zip_error_strerror(zip_source_error(source)), file);
    if (read == 0) break;
    file.write(std::string_view(block).substr(0, static_cast<std::size_t>(read)));
  }
  zip_source_close(source);
}

}  // namespace

void write3mf(TargetFile& file, const TriangleMesh& mesh) {
  writeObjects3mf(file, std::span(&mesh, 1), {});
}

// Packed in memory, so that libzip makes no temporary file of its own.
void writeObjects3mf(TargetFile& file, std::span<const TriangleMesh> meshes,
                     std::span<const std::vector<Region>> regions) {
  const std::string model = modelOf(meshes, regions), thumbnail = toPng(drawn(meshes, regions));
  zip_error_t error;
  zip_error_init(&error);
  const Source packed(zip_source_buffer_create(nullptr, 0, 0, &error));
  require(packed != nullptr, zip_error_strerror(&error), file);
  zip_source_keep(packed.get());  // one for the archive, one to read it
  Archive archive(zip_open_from_source(packed.get(), ZIP_TRUNCATE, &error));
  require(archive != nullptr, zip_error_strerror(&error), file);
  addPart(archive.get(), "[Content_Types].xml", kContentTypes, file);
  addPart(archive.get(), "_rels/.rels", kRelationships, file);
  addPart(archive.get(), "3D/3dmodel.model", model, file);
  addPart(archive.get(), "Metadata/thumbnail.png", thumbnail, file);
  require(zip_close(archive.get()) == 0, zip_strerror(archive.get()), file);
  archive.release();
  copyTo(file, packed.get());
}

}  // namespace thicken::io
