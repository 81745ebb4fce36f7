// SPDX-License-Identifier: LGPL-2.1-or-later
//
// A file that appears whole or not at all: it is written under another name beside its place and
// renamed when it is complete.
#pragma once

#include <cstdio>
#include <filesystem>
#include <memory>
#include <string>
#include <string_view>

namespace thicken::io {

/// The place that is written to in the end for `path`: what it links to, over any number of links, whether or
/// not there is such a file yet. Throws Error(kUnwritable) where links go round.
[[nodiscard]] std::filesystem::path linkedPlace(const std::filesystem::path& path);

class TargetFile {
 public:
  /// Opens a new temporary file in the folder of `path` (of what it links to, when it is a link).
  /// Throws Error(kUnwritable), as do all other functions.
  explicit TargetFile(const std::filesystem::path& path);
  /// Removes the temporary file unless it was committed.
  ~TargetFile();
  TargetFile(const TargetFile&) = delete;
  TargetFile& operator=(const TargetFile&) = delete;

  void write(std::string_view bytes);
  /// Writes `bytes` and empties it, once it has become long enough to be worth it.
  void writeWhenLong(std::string& bytes);
  /// Closes the file and gives it its name, in place of what had it.
  void commit();

  /// Throws Error(kUnwritable): the file and `reason` (a clause without the full stop).
  [[noreturn]] void fail(const std::string& reason) const;

 private:
  void openTemporary();
  void removeTemporary() noexcept;

  std::filesystem::path path_;   // as the caller named it
  std::filesystem::path place_;  // what is replaced
  std::filesystem::path temporary_;
  std::FILE* file_ = nullptr;
  int slot_ = -1;  // in the list of files that abandonWrites() removes
};

}  // namespace thicken::io
