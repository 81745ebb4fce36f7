// SPDX-License-Identifier: LGPL-2.1-or-later
//
// PLY: text, and binary of both byte orders; numbers of any type; other elements and properties,
// lists too, are passed.
#include <algorithm>

#include "io/foreign_file.h"
#include "io/formats.h"
#include "io/ply_values.h"
#include "io/polygon_soup.h"

namespace thicken::io {
namespace {

const PlyElement* elementOf(const PlyHeader& header, std::string_view name) {
  const auto found = std::ranges::find(header.elements, name, &PlyElement::name);
  return found == header.elements.end() ? nullptr : &*found;
}

template <class Values>
class PlyReader {
 public:
  /// `property`: of the vertices, to be read besides; empty: none.
  PlyReader(Values values, const PlyHeader& header, const SourceFile& file, std::string property)
      : values_(std::move(values)), header_(header), file_(file), property_(std::move(property)) {}

  PolygonSoup read() {
    const PlyElement* vertex = elementOf(header_, "vertex");
    if (!vertex) file_.fail("the header has no element \"vertex\"; there is no mesh in the file");
    const PlyElement* strips = elementOf(header_, "tristrips");
    if (strips && strips->count > 0)
      file_.fail("holds triangle strips, which cannot be read; export it as triangles");
    vertices_ = vertex->count;
    for (const PlyElement& element : header_.elements) {
      if (element.properties.empty()) continue;  // takes no bytes, however many there are
      requireRoom(element);
      if (element.name == "vertex") {
        readVertices(element);
      } else if (element.name == "face") {
        readFaces(element);
      } else {
        for (std::size_t i = 0; i < element.count; ++i)
          readElement(element, [](std::size_t) { return false; });
      }
    }
    if (soup_.positions.size() != vertices_) file_.fail("the vertices have no properties");
    if (!values_.atEnd()) values_.fail("there is more in the file than its header announces; it is damaged");
    return std::move(soup_);
  }
  std::vector<double> readProperty() {
    (void)read();
    return std::move(numbers_);
  }

 private:
  // Before anything is allocated for the elements.
  void requireRoom(const PlyElement& element) const {
    std::size_t least = 0;
    for (const PlyProperty& property : element.properties) {
      least += Values::leastBytes(property.countType.value_or(property.type));
    }
    if (element.count > values_.bytesLeft() / least) {
      values_.fail("the header announces " + std::to_string(element.count) + " elements \"" + element.name +
                   "\" of " + std::to_string(least) + " bytes at least, but only " +
                   std::to_string(values_.bytesLeft()) + " bytes follow; the file is cut off or damaged");
    }
  }

  // Reads one element; take(i) reads its property i, or returns false to have it passed.
  template <class Take>
  void readElement(const PlyElement& element, Take take) {
    values_.beginElement();
    for (std::size_t i = 0; i < element.properties.size(); ++i) {
      if (take(i)) continue;
      const PlyProperty& property = element.properties[i];
      values_.pass(property.type, property.countType ? entries(property) : 1);
    }
    values_.endElement();
  }

  std::size_t entries(const PlyProperty& list) {
    const std::int64_t count = values_.integer(*list.countType);
    if (count < 0) values_.fail("a list announces " + std::to_string(count) + " entries");
    if (static_cast<std::uint64_t>(count) > values_.bytesLeft() / Values::leastBytes(list.type)) {
      values_.fail("a list announces " + std::to_string(count) + " entries, but only " +
                   std::to_string(values_.bytesLeft()) + " bytes follow; the file is cut off or damaged");
    }
    return static_cast<std::size_t>(count);
  }

  void readVertices(const PlyElement& element) {
    requireNameable(element.count, "vertices", file_);
    std::vector<int> axis(element.properties.size(), -1);
    const auto placeOf = [&](std::string_view name) {
      const auto found = std::ranges::find(element.properties, name, &PlyProperty::name);
      if (found == element.properties.end() || found->countType) {
        file_.fail("the vertices have no property \"" + std::string(name) + "\"");
      }
      return static_cast<std::size_t>(found - element.properties.begin());
    };
    for (int k = 0; k < 3; ++k)
      axis[placeOf(std::string_view("xyz").substr(static_cast<std::size_t>(k), 1))] = k;
    const std::size_t wanted = property_.empty() ? element.properties.size() : placeOf(property_);
    soup_.positions.reserve(element.count);
    Vec3 position = Vec3::Zero();
    const auto take = [&](std::size_t i) {
      if (axis[i] < 0 && i != wanted) return false;
      const double number = values_.number(element.properties[i].type);
      if (axis[i] >= 0) position[axis[i]] = number;
      if (i == wanted) numbers_.push_back(number);
      return true;
    };
    for (std::size_t v = 0; v < element.count; ++v) {
      readElement(element, take);
      soup_.positions.push_back(position);
    }
  }

  void readFaces(const PlyElement& element) {
    const auto corners = std::ranges::find_if(element.properties, [](const PlyProperty& p) {
      return p.countType && (p.name == "vertex_indices" || p.name == "vertex_index");
    });
    if (corners == element.properties.end()) {
      file_.fail("the faces have no list \"vertex_indices\" or \"vertex_index\"");
    }
    const auto which = static_cast<std::size_t>(corners - element.properties.begin());
    soup_.sizes.reserve(element.count);
    const auto take = [&](std::size_t i) {
      if (i == which) readCorners(*corners);
      return i == which;
    };
    for (std::size_t f = 0; f < element.count; ++f) readElement(element, take);
  }

  void readCorners(const PlyProperty& list) {
    const std::size_t count = entries(list);
    if (count < 3) {
      values_.fail("face " + std::to_string(soup_.sizes.size()) + " has " + std::to_string(count) +
                   " corners; it takes three at least");
    }
    for (std::size_t k = 0; k < count; ++k) {
      const std::int64_t index = values_.integer(list.type);
      if (index < 0 || static_cast<std::uint64_t>(index) >= vertices_) {
        values_.fail("face " + std::to_string(soup_.sizes.size()) + " names vertex " + std::to_string(index) +
                     "; the file has " + std::to_string(vertices_) + ", counted from 0");
      }
      soup_.corners.push_back(static_cast<VertexId>(index));
    }
    soup_.sizes.push_back(static_cast<std::uint32_t>(count));
  }

  Values values_;
  const PlyHeader& header_;
  const SourceFile& file_;
  std::string property_;
  std::vector<double> numbers_;  // of that property
  std::size_t vertices_ = 0;
  PolygonSoup soup_;
};

// use(reader)
template <class Use>
auto withReader(const SourceFile& file, const std::string& property, Use use) {
  refuseForeign(file);
  const PlyHeader header = readPlyHeader(file);
  if (header.encoding == PlyEncoding::kAscii)
    return use(PlyReader(PlyText(file, header), header, file, property));
  const std::endian order =
      header.encoding == PlyEncoding::kLittleEndian ? std::endian::little : std::endian::big;
  return use(PlyReader(PlyBytes(file, header, order), header, file, property));
}

}  // namespace

TriangleMesh readPly(const SourceFile& file) {
  return withReader(file, {}, [&](auto reader) { return triangulated(reader.read(), file); });
}

std::vector<double> readPlyProperty(const SourceFile& file, const std::string& name) {
  return withReader(file, name, [](auto reader) { return reader.readProperty(); });
}

}  // namespace thicken::io
