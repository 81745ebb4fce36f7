// SPDX-License-Identifier: LGPL-2.1-or-later
//
// The bytes of a file that is being read, and the sentences that say what is wrong with it.
#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

namespace thicken::io {

/// `path` as it stands in sentences: "part.stl", quoted, in UTF-8.
[[nodiscard]] std::string quoted(const std::filesystem::path& path);

/// The whole file in memory. It is read rather than mapped, so that a file that shrinks meanwhile
/// is a truncated file and not a bus error.
class SourceFile {
 public:
  /// Throws Error(kUnreadable) with the reason of the operating system.
  explicit SourceFile(const std::filesystem::path& path);

  [[nodiscard]] std::string_view bytes() const { return {bytes_.get(), size_}; }

  /// Notes something that was passed over, for whoever asked for the file: the file, then `what` (a clause
  /// without the full stop).
  void passOver(const std::string& what) const;
  [[nodiscard]] const std::vector<std::string>& passedOver() const { return passedOver_; }

  /// Throw Error(kUnreadable): the file, the place, `reason` (a clause without the full stop).
  [[noreturn]] void fail(const std::string& reason) const;
  [[noreturn]] void failAtLine(std::size_t line, const std::string& reason) const;
  [[noreturn]] void failAtByte(std::size_t offset, const std::string& reason) const;
  /// Throws Error(kTooLarge): the file and `reason`.
  [[noreturn]] void failTooLarge(const std::string& reason) const;

 private:
  std::filesystem::path path_;
  std::unique_ptr<char[]> bytes_;
  std::size_t size_ = 0;
  mutable std::vector<std::string> passedOver_;  // notes about the file, which stays as it is
};

}  // namespace thicken::io
