// SPDX-License-Identifier: LGPL-2.1-or-later
#include <zip.h>

#include <map>
#include <string>

#include "scratch_folder.h"
#include "thicken/io.h"

namespace thicken {
namespace {

using namespace test;
namespace fs = std::filesystem;

constexpr auto kRelationships =
    R"(<Relationships xmlns="http://schemas.openxmlformats.org/package/2006/relationships"><Relationship Id="a"
Target="/3D/3dmodel.model" Type="http://schemas.microsoft.com/3dmanufacturing/2013/01/3dmodel"/></Relationships>)";
const std::string kHead = R"(<?xml version="1.0" encoding="UTF-8"?>
<model xmlns="http://schemas.microsoft.com/3dmanufacturing/core/2015/02"
 xmlns:p="http://schemas.microsoft.com/3dmanufacturing/production/2015/06"
 xmlns:b="http://schemas.microsoft.com/3dmanufacturing/beamlattice/2017/02")";
const std::string kTriangle = R"(<mesh><vertices><vertex x="0" y="0" z="0"/><vertex x="1" y="0" z="0"/>
<vertex x="0" y="2" z="0"/></vertices><triangles><triangle v1="0" v2="1" v3="2"/></triangles></mesh>)";
const std::string kOne = R"(<object id="1">)" + kTriangle + "</object>";

std::string modelOf(const std::string& objects, const std::string& items,
                    const std::string& attributes = {}) {
  return kHead + attributes + "><resources>" + objects + "</resources><build>" + items + "</build></model>";
}

fs::path package(const ScratchFolder& folder, const std::map<std::string, std::string>& parts) {
  const fs::path path = folder / "a.3mf";
  fs::remove(path);
  int error = 0;
  zip_t* archive = zip_open(path.c_str(), ZIP_CREATE | ZIP_TRUNCATE, &error);
  for (const auto& [name, text] : parts)
    zip_file_add(archive, name.c_str(), zip_source_buffer(archive, text.data(), text.size(), 0),
                 ZIP_FL_ENC_UTF_8);
  EXPECT_EQ(zip_close(archive), 0);
  return path;
}

fs::path model(const ScratchFolder& folder, const std::string& xml) {
  return package(folder, {{"_rels/.rels", kRelationships}, {"3D/3dmodel.model", xml}});
}

TEST(Read3mf, ReadsTheObjectsThatAreToBeBuilt) {
  const ScratchFolder folder;
  const TriangleMesh mesh = readMesh(model(
      folder, modelOf(kOne + R"(<object id="2">)" + kTriangle + "</object>", R"(<item objectid="1"/>)")));
  EXPECT_EQ(mesh.positions, (std::vector<Vec3>{{0, 0, 0}, {1, 0, 0}, {0, 2, 0}}));
  EXPECT_EQ(mesh.triangles, (std::vector<Triangle>{{0, 1, 2}}));
}

TEST(Read3mf, PlacesComponentsAndItems) {
  const ScratchFolder folder;
  // A quarter turn about z that sends x to y, then 10 along x; the item another 100 along z.
  const std::string objects =
      kOne + R"(<object id="2"><components><component objectid="1" transform="0 1 0 -1 0 0 0 0 1 10 0 0"/>
      <component objectid="1"/></components></object>)";
  const TriangleMesh mesh = readMesh(
      model(folder, modelOf(objects, R"(<item objectid="2" transform="1 0 0 0 1 0 0 0 1 0 0 100"/>)")));
  ASSERT_EQ(mesh.triangles.size(), 2u);
  EXPECT_EQ(mesh.positions[0], Vec3(10, 0, 100));
  EXPECT_EQ(mesh.positions[1], Vec3(10, 1, 100));
  EXPECT_EQ(mesh.positions[2], Vec3(8, 0, 100));
  EXPECT_EQ(mesh.positions[4], Vec3(1, 0, 100));
}

TEST(Read3mf, MirroredObjectsKeepTheirOutside) {
  const ScratchFolder folder;
  const TriangleMesh mesh =
      readMesh(model(folder, modelOf(kOne, R"(<item objectid="1" transform="1 0 0 0 1 0 0 0 -1 0 0 0"/>)")));
  const Triangle t = mesh.triangles.at(0);
  EXPECT_EQ(mesh.positions[t[1]], Vec3(0, 2, 0));
  EXPECT_EQ(mesh.positions[t[2]], Vec3(1, 0, 0));
}

TEST(Read3mf, IsInMillimetresWhateverTheUnit) {
  const ScratchFolder folder;
  const auto widthIn = [&](const std::string& unit) {
    return readMesh(model(folder, modelOf(kOne, R"(<item objectid="1"/>)", " unit=\"" + unit + "\"")))
        .positions[1]
        .x();
  };
  EXPECT_EQ(widthIn("millimeter"), 1);
  EXPECT_EQ(widthIn("micron"), 0.001);
  EXPECT_EQ(widthIn("centimeter"), 10);
  EXPECT_EQ(widthIn("inch"), 25.4);
  EXPECT_EQ(widthIn("foot"), 304.8);
  EXPECT_EQ(widthIn("meter"), 1000);
  EXPECT_TRUE(namesItsUnit("a.3MF"));
  EXPECT_FALSE(namesItsUnit("a.stl"));
}

TEST(Read3mf, FollowsThePathsOfTheProductionExtension) {
  const ScratchFolder folder;
  const std::string root = modelOf(
      R"(<object id="7"><components><component p:path="/3D/more/a.model" objectid="1"/></components></object>)",
      R"(<item objectid="7"/><item p:path="/3D/more/a.model" objectid="1" transform="1 0 0 0 1 0 0 0 1 0 0 5"/>)",
      R"( requiredextensions="p")");
  const TriangleMesh mesh = readMesh(package(
      folder,
      {{"_rels/.rels", kRelationships}, {"3D/3dmodel.model", root}, {"3D/more/a.model", modelOf(kOne, "")}}));
  EXPECT_EQ(mesh.triangles.size(), 2u);
  EXPECT_EQ(mesh.positions.back(), Vec3(0, 2, 5));
}

TEST(Read3mf, LeavesSupportsOutAndSaysSo) {
  const ScratchFolder folder;
  const std::string support = R"(<object id="2" type="support">)" + kTriangle + "</object>";
  const MeshFile file =
      readMeshFile(model(folder, modelOf(kOne + support, R"(<item objectid="1"/><item objectid="2"/>)")));
  EXPECT_EQ(file.mesh.triangles.size(), 1u);
  ASSERT_EQ(file.warnings.size(), 1u);
  EXPECT_CONTAINS(file.warnings[0], "1 objects that support others");
}

TEST(Read3mf, ReadsBackSeveralSolidsWithColours) {
  const ScratchFolder folder;
  const std::vector<TriangleMesh> meshes{twoTriangles(), {{{7, 0, 0}, {8, 0, 0}, {7, 1, 0.1}}, {{0, 1, 2}}}};
  writeMeshes(folder / "b.3mf", meshes,
              std::vector<std::vector<Region>>{{Region::kShell, Region::kWall}, {Region::kOriginal}});
  const TriangleMesh mesh = readMesh(folder / "b.3mf");
  EXPECT_EQ(mesh.triangles, (std::vector<Triangle>{{0, 1, 2}, {0, 2, 3}, {4, 5, 6}}));
  EXPECT_EQ(mesh.positions.back(), Vec3(7, 1, 0.1));
}

TEST(Read3mf, SaysWhatIsWrongWithAModel) {
  const ScratchFolder folder;
  const std::string item = R"(<item objectid="1"/>)";
  const auto object = [](const std::string& inner) { return "<object id=\"1\">" + inner + "</object>"; };
  const std::string vertex = R"(<mesh><vertices><vertex x="0" y="0" z="0"/></vertices>)";
  const std::vector<std::pair<std::string, std::string>> wrong{
      {modelOf(kOne, ""), "nothing to build"},
      {modelOf(kOne, R"(<item objectid="3"/>)"), "names the object 3"},
      {modelOf(kOne + kOne, item), "two objects with the id 1"},
      {modelOf(object(vertex + "</mesh>"), item), "has no triangles"},
      {modelOf(object(vertex + R"(<triangles><triangle v1="0" v2="0" v3="1"/></triangles></mesh>)"), item),
       "names vertex 1; the object has 1"},
      {modelOf(object(vertex + R"(<triangles><triangle v1="0" v2="0" v3="-1"/></triangles></mesh>)"), item),
       "no vertex -1"},
      {modelOf(object(vertex + R"(<triangles><triangle v1="0" v2="0"/></triangles></mesh>)"), item),
       "\"v3\" is missing"},
      {modelOf(object(R"(<mesh><vertices><vertex x="0,5" y="0" z="0"/></vertices></mesh>)"), item),
       "\"0,5\" is no number (x)"},
      {modelOf(R"(<vertex x="0" y="0" z="0"/>)", item), "outside of any object"},
      {modelOf(kOne, R"(<item objectid="1" transform="1 0 0 0 1 0 0 0 1"/>)"), "has 9 numbers"},
      {modelOf(kOne, R"(<item objectid="1" transform="1 0 0 0 1 0 0 0 1 0 0 u"/>)"), "no row of 12 numbers"},
      {modelOf(kOne, item, " unit=\"parsec\""), "\"parsec\" is no unit"},
      {modelOf(kOne, item, " requiredextensions=\"b\""), "requires the extension"},
      {modelOf(R"(<object id="1"><components><component objectid="1"/></components></object>)", item),
       "contain themselves"},
      {modelOf(kOne, R"(<item objectid="1" p:path="/3D/none.model"/>)"), "no part \"3D/none.model\""},
      {kHead + "><resources>", "this is no XML"},
      {"<html></html>", "holds no 3MF model"},
      {"no XML at all", "this is no XML"},
      {"<!DOCTYPE a [<!ENTITY b \"b\">]>" + modelOf(kOne, item), "document type"},
  };
  for (const auto& [xml, words] : wrong) {
    SCOPED_TRACE(words);
    EXPECT_CONTAINS(refusalOf(model(folder, xml)), words);
  }
}

TEST(Read3mf, SaysWhatIsWrongWithAPackage) {
  const ScratchFolder folder;
  EXPECT_CONTAINS(refusalOf(folder.put("a.3mf", "solid a")), "is no zip archive");
  EXPECT_CONTAINS(refusalOf(folder.put("a.3mf", "PK\3\4 and no more")), "damaged zip archive");
  EXPECT_CONTAINS(refusalOf(package(folder, {{"a.txt", "a"}})), "no 3MF package");
  EXPECT_CONTAINS(refusalOf(package(folder, {{"_rels/.rels", "<Relationships/>"}})), "name no 3D model");
  EXPECT_CONTAINS(refusalOf(package(folder, {{"_rels/.rels", kRelationships}})),
                  "no part \"3D/3dmodel.model\"");
  writeMesh(folder / "b.3mf", twoTriangles());
  std::string bytes = bytesOf(folder / "b.3mf");
  const std::size_t at = bytes.find("3D/3dmodel.model") + 40;
  bytes[at] = static_cast<char>(bytes[at] ^ 0x55);
  EXPECT_FALSE(refusalOf(folder.put("c.3mf", bytes)).empty());
  for (const std::size_t length : {bytes.size() - 1, bytes.size() / 2, std::size_t{60}})
    EXPECT_FALSE(refusalOf(folder.put("d.3mf", bytes.substr(0, length))).empty()) << length;
}

TEST(Read3mf, RefusesFewComponentsThatStandForVeryMany) {
  const ScratchFolder folder;
  std::string objects = kOne;
  for (int id = 2; id < 12; ++id) {
    objects += "<object id=\"" + std::to_string(id) + "\"><components>";
    for (int i = 0; i < 10; ++i) objects += "<component objectid=\"" + std::to_string(id - 1) + "\"/>";
    objects += "</components></object>";
  }
  try {
    (void)readMesh(model(folder, modelOf(objects, R"(<item objectid="11"/>)")));
    ADD_FAILURE();
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), ErrorCode::kTooLarge);
    EXPECT_CONTAINS(std::string(error.what()), "a million objects");
  }
}

}  // namespace
}  // namespace thicken
