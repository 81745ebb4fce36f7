// SPDX-License-Identifier: LGPL-2.1-or-later
//
// Faces of any number of corners in one array. Millions of small vectors would cost more than their contents.
#pragma once

#include <cstdint>
#include <initializer_list>
#include <span>
#include <vector>

#include "thicken/mesh.h"

namespace thicken::contour {

class FaceList {
 public:
  FaceList() = default;
  FaceList(std::initializer_list<std::initializer_list<VertexId>> faces) {
    for (const auto& f : faces) {
      corners_.insert(corners_.end(), f);
      offset_.push_back(static_cast<std::uint32_t>(corners_.size()));
    }
  }

  /// For faces with so many corners each, which are to be set.
  void resize(const std::vector<std::uint8_t>& corners) {
    offset_.resize(corners.size() + 1);
    for (std::size_t i = 0; i < corners.size(); ++i) offset_[i + 1] = offset_[i] + corners[i];
    corners_.resize(offset_.back());
  }

  [[nodiscard]] std::size_t size() const { return offset_.size() - 1; }
  [[nodiscard]] std::span<const VertexId> operator[](std::size_t i) const {
    return {corners_.data() + offset_[i], corners_.data() + offset_[i + 1]};
  }
  [[nodiscard]] std::span<VertexId> operator[](std::size_t i) {
    return {corners_.data() + offset_[i], corners_.data() + offset_[i + 1]};
  }

 private:
  std::vector<std::uint32_t> offset_{0};
  std::vector<VertexId> corners_;
};

}  // namespace thicken::contour
