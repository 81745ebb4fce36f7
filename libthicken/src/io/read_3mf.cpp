// SPDX-License-Identifier: LGPL-2.1-or-later
//
// 3MF core specification 1.3, with the paths of the production extension: the objects that the package is to
// build, as one mesh. Materials and everything else that has no triangles are passed.
#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <map>
#include <sstream>
#include <utility>

#include "io/foreign_file.h"
#include "io/formats.h"
#include "io/number_text.h"
#include "io/polygon_soup.h"
#include "io/xml_elements.h"

namespace thicken::io {
namespace {

constexpr std::string_view kCore = "http://schemas.microsoft.com/3dmanufacturing/core/2015/02";
constexpr std::string_view kProduction = "http://schemas.microsoft.com/3dmanufacturing/production/2015/06";
constexpr std::string_view kMaterials = "http://schemas.microsoft.com/3dmanufacturing/material/2015/02";
constexpr std::string_view kModelRelationship =
    "http://schemas.microsoft.com/3dmanufacturing/2013/01/3dmodel";
constexpr std::string_view kProductionPath =
    "http://schemas.microsoft.com/3dmanufacturing/production/2015/06|path";
// Components that contain each other would go on for ever, and few of them may stand for very many.
constexpr int kDeepest = 32;
constexpr std::size_t kMostInstances = 1'000'000;

struct Instance {
  std::string path;  // of the part that has the object
  std::int64_t object = 0;
  Eigen::Affine3d place = Eigen::Affine3d::Identity();
  bool isPlaced = false;  // whether `place` is more than the identity
};

struct Object {
  TriangleMesh mesh;
  std::vector<Instance> components;
  bool isPrinted = true;  // and no support
};

struct Model {
  double unit = 1;  // mm
  std::map<std::int64_t, Object> objects;
  std::vector<Instance> items;
};

std::string_view trimmed(std::string_view text) {
  constexpr std::string_view kBlanks = " \t\r\n";
  const std::size_t begin = text.find_first_not_of(kBlanks);
  if (begin == std::string_view::npos) return {};
  return text.substr(begin, text.find_last_not_of(kBlanks) + 1 - begin);
}

// "/3D/a.model" names the part 3D/a.model of the archive.
std::string partName(std::string_view target) {
  while (target.starts_with('/')) target.remove_prefix(1);
  return std::string(target);
}

// The part that the relationships of the package name as the model.
class Relationships : public XmlHandler {
 public:
  void begin(std::string_view /*name*/, const XmlAttributes& attributes) override {
    const char *type = attributes.find("Type"), *to = attributes.find("Target");
    if (type && to && type == kModelRelationship && target.empty()) target = partName(to);
  }
  std::string target;
};

class ModelReader : public XmlHandler {
 public:
  ModelReader(XmlPart& part, std::string path, const SourceFile& file)
      : part_(part), path_(std::move(path)), file_(file) {}

  void begin(std::string_view name, const XmlAttributes& attributes) override {
    if (!name.starts_with(kCore) || name.size() <= kCore.size() || name[kCore.size()] != '|') return;
    name.remove_prefix(kCore.size() + 1);
    if (name == "vertex")
      addVertex(attributes);
    else if (name == "triangle")
      addTriangle(attributes);
    else if (name == "model")
      beginModel(attributes);
    else if (name == "object")
      beginObject(attributes);
    else if (name == "component")
      current("component").components.push_back(instance(attributes));
    else if (name == "item")
      model.items.push_back(instance(attributes));
  }

  void end(std::string_view name) override {
    if (name.size() != kCore.size() + 7 || !name.starts_with(kCore) || !name.ends_with("|object")) return;
    const Object& object = current("object");
    for (const Triangle& t : object.mesh.triangles)
      if (std::ranges::max(t) >= object.mesh.positions.size())
        part_.fail("a triangle names vertex " + std::to_string(std::ranges::max(t)) + "; the object has " +
                   std::to_string(object.mesh.positions.size()) + ", counted from 0");
    object_ = nullptr;
  }

  Model model;
  bool isModel = false;

 private:
  void beginModel(const XmlAttributes& attributes) {
    static constexpr std::array<std::pair<std::string_view, double>, 6> kUnits{{{"micron", 0.001},
                                                                                {"millimeter", 1},
                                                                                {"centimeter", 10},
                                                                                {"inch", 25.4},
                                                                                {"foot", 304.8},
                                                                                {"meter", 1000}}};
    isModel = true;
    if (const char* unit = attributes.find("unit")) {
      const auto* found =
          std::ranges::find(kUnits, std::string_view(unit), &std::pair<std::string_view, double>::first);
      if (found == kUnits.end()) part_.fail("\"" + std::string(unit) + "\" is no unit of 3MF");
      model.unit = found->second;
    }
    std::istringstream prefixes(attributes.find("requiredextensions") ? attributes.find("requiredextensions")
                                                                      : "");
    for (std::string prefix; prefixes >> prefix;)
      if (const std::string uri = part_.namespaceOf(prefix); uri != kProduction && uri != kMaterials)
        part_.fail("it requires the extension \"" + (uri.empty() ? prefix : uri) +
                   "\" of 3MF, without which its shape is not what was meant; export it as plain triangles");
  }

  void beginObject(const XmlAttributes& attributes) {
    const std::int64_t id = integer(attributes, "id");
    const auto [entry, isNew] = model.objects.try_emplace(id);
    if (!isNew) part_.fail("there are two objects with the id " + std::to_string(id));
    object_ = &entry->second;
    const char* type = attributes.find("type");
    object_->isPrinted =
        type == nullptr || std::string_view(type) == "model" || std::string_view(type) == "surface";
  }

  void addVertex(const XmlAttributes& attributes) {
    TriangleMesh& mesh = current("vertex").mesh;
    mesh.positions.emplace_back(number(attributes, "x"), number(attributes, "y"), number(attributes, "z"));
    requireNameable(mesh.positions.size(), "vertices", file_);
  }

  void addTriangle(const XmlAttributes& attributes) {
    TriangleMesh& mesh = current("triangle").mesh;
    Triangle& t = mesh.triangles.emplace_back();
    constexpr std::array kCorners{"v1", "v2", "v3"};
    for (std::size_t k = 0; k < 3; ++k) {
      const std::int64_t index = integer(attributes, kCorners[k]);
      if (index < 0 || index >= 0xffffffff) part_.fail("there is no vertex " + std::to_string(index));
      t[k] = static_cast<VertexId>(index);
    }
  }

  Object& current(const char* element) {
    if (object_ == nullptr) part_.fail(std::string("a ") + element + " stands outside of any object");
    return *object_;
  }

  const char* required(const XmlAttributes& attributes, const char* name) {
    const char* value = attributes.find(name);
    if (value == nullptr) part_.fail(std::string("the attribute \"") + name + "\" is missing");
    return value;
  }

  double number(const XmlAttributes& attributes, const char* name) {
    const char* value = required(attributes, name);
    const auto found = toDouble(trimmed(value));
    if (!found) part_.fail(std::string("\"") + value + "\" is no number (" + name + ")");
    return *found;
  }

  std::int64_t integer(const XmlAttributes& attributes, const char* name) {
    const char* value = required(attributes, name);
    const auto found = toInteger(trimmed(value));
    if (!found) part_.fail(std::string("\"") + value + "\" is no whole number (" + name + ")");
    return *found;
  }

  Instance instance(const XmlAttributes& attributes) {
    Instance result;
    result.object = integer(attributes, "objectid");
    const char* path = attributes.find(kProductionPath);
    result.path = path ? partName(path) : path_;
    const char* transform = attributes.find("transform");
    if (transform == nullptr) return result;
    std::array<double, 12> values{};
    std::istringstream words(transform);
    std::string word;
    std::size_t count = 0;
    for (; words >> word; ++count)
      if (const auto value = toDouble(word); value && count < values.size())
        values[count] = *value;
      else
        part_.fail("a transform is no row of 12 numbers");
    if (count != values.size())
      part_.fail("a transform has " + std::to_string(count) + " numbers, and takes 12");
    // Points are rows in the file, and columns here.
    for (int row = 0; row < 4; ++row)
      for (int k = 0; k < 3; ++k)
        (row < 3 ? result.place.linear()(k, row) : result.place.translation()(k)) =
            values[static_cast<std::size_t>(3 * row + k)];
    result.isPlaced = !result.place.matrix().isIdentity(0);
    return result;
  }

  XmlPart& part_;
  std::string path_;
  const SourceFile& file_;
  Object* object_ = nullptr;
};

// The parts that have been read, and the mesh that is made of them.
class Builder {
 public:
  explicit Builder(const SourceFile& file) : file_(file), package_(file) {}

  TriangleMesh build() {
    const std::string root = modelPart();
    const Model& model = at(root);
    if (model.items.empty()) file_.fail("has nothing to build: the model names no objects for it");
    std::size_t supports = 0;
    for (const Instance& item : model.items)
      if (objectOf(item).isPrinted)
        add(item, Eigen::Affine3d::Identity(), false, 0);
      else
        ++supports;
    if (supports > 0)
      file_.passOver("has " + std::to_string(supports) + " objects that support others, which were left out");
    if (mesh_.triangles.empty()) file_.fail("has no triangles");
    if (model.unit != 1)
      for (Vec3& p : mesh_.positions) p *= model.unit;
    return std::move(mesh_);
  }

 private:
  std::string modelPart() {
    constexpr auto kRelationships = "_rels/.rels";
    if (!package_.has(kRelationships))
      file_.fail("is a zip archive, but no 3MF package: it has no part \"_rels/.rels\"");
    Relationships relationships;
    XmlPart(file_, kRelationships).read(package_, relationships);
    if (relationships.target.empty())
      file_.fail("is a package, but no 3MF file: its relationships name no 3D model");
    return relationships.target;
  }

  const Model& at(const std::string& path) {
    const auto found = models_.find(path);
    if (found != models_.end()) return found->second;
    if (!package_.has(path)) file_.fail("has no part \"" + path + "\", which it names as a model");
    XmlPart part(file_, path);
    ModelReader reader(part, path, file_);
    part.read(package_, reader);
    if (!reader.isModel) part.fail("it holds no 3MF model");
    return models_.emplace(path, std::move(reader.model)).first->second;
  }

  const Object& objectOf(const Instance& instance) {
    const Model& model = at(instance.path);
    const auto found = model.objects.find(instance.object);
    if (found == model.objects.end())
      file_.fail("names the object " + std::to_string(instance.object) + " of its part \"" + instance.path +
                 "\", which has none of that id");
    return found->second;
  }

  void add(const Instance& instance, const Eigen::Affine3d& around, bool isMoved, int depth) {
    if (depth > kDeepest) file_.fail("has objects that contain themselves, or are more than 32 deep");
    if (++instances_ > kMostInstances)
      file_.failTooLarge("builds more than a million objects of its components");
    const Object& object = objectOf(instance);
    const Eigen::Affine3d place = around * instance.place;
    isMoved = isMoved || instance.isPlaced;
    const std::size_t first = mesh_.positions.size();
    requireNameable(first + object.mesh.positions.size(), "vertices", file_);
    requireNameable(mesh_.triangles.size() + object.mesh.triangles.size(), "triangles", file_);
    for (const Vec3& p : object.mesh.positions) mesh_.positions.push_back(isMoved ? Vec3(place * p) : p);
    const bool isMirrored = place.linear().determinant() < 0;
    for (Triangle t : object.mesh.triangles) {
      for (VertexId& v : t) v += static_cast<VertexId>(first);
      if (isMirrored) std::swap(t[1], t[2]);
      mesh_.triangles.push_back(t);
    }
    for (const Instance& component : object.components) add(component, place, isMoved, depth + 1);
  }

  const SourceFile& file_;
  PackageReader package_;
  std::map<std::string, Model> models_;
  TriangleMesh mesh_;
  std::size_t instances_ = 0;
};

}  // namespace

TriangleMesh read3mf(const SourceFile& file) {
  if (!file.bytes().starts_with("PK")) {
    refuseForeign(file);
    file.fail("is no zip archive, as a 3MF file is");
  }
  return Builder(file).build();
}

}  // namespace thicken::io
