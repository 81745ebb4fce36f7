// SPDX-License-Identifier: LGPL-2.1-or-later
//
// The parts of a package that is being read: a zip archive (ECMA-376 part 2).
#pragma once

#include <memory>
#include <string>
#include <string_view>

#include "io/source_file.h"

namespace thicken::io {

class PackageReader {
 public:
  /// `file` must outlive this. Throws Error(kUnreadable), as do all other functions.
  explicit PackageReader(const SourceFile& file);
  ~PackageReader();
  PackageReader(const PackageReader&) = delete;
  PackageReader& operator=(const PackageReader&) = delete;

  /// Whether there is a part of this name, "3D/3dmodel.model", whatever the case of its letters.
  [[nodiscard]] bool has(const std::string& name) const;

  /// Begins with a part that is there.
  void open(const std::string& name);
  /// Its next bytes, at most a block of them; empty: its end. They stay as they are until the next call.
  [[nodiscard]] std::string_view next();

 private:
  struct Impl;
  const SourceFile& file_;
  std::unique_ptr<Impl> impl_;
};

}  // namespace thicken::io
