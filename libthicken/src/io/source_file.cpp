// SPDX-License-Identifier: LGPL-2.1-or-later
#include "io/source_file.h"

#include <cerrno>
#include <cstdio>
#include <system_error>

#include "platform/files.h"
#include "thicken/error.h"

namespace thicken::io {
namespace {

struct CloseFile {
  void operator()(std::FILE* file) const { std::fclose(file); }
};

}  // namespace

std::string quoted(const std::filesystem::path& path) {
  return '"' + path.string() + '"';
}

SourceFile::SourceFile(const std::filesystem::path& path) : path_(path) {
  namespace fs = std::filesystem;
  std::error_code problem;
  const fs::file_status status = fs::status(path, problem);
  if (status.type() == fs::file_type::not_found) fail("there is no such file");
  if (status.type() == fs::file_type::none) fail("cannot be read: " + problem.message());
  if (status.type() == fs::file_type::directory) fail("is a folder; name a mesh file in it");
  // A pipe or a device may block for ever and has no size to judge announced counts by.
  if (status.type() != fs::file_type::regular) fail("is not a regular file");

  const std::uintmax_t size = fs::file_size(path, problem);
  if (problem) fail("cannot be read: " + problem.message());
  if (size == 0) fail("is empty (0 bytes)");
  const std::unique_ptr<std::FILE, CloseFile> file(platform::openFile(path));
  if (!file) fail("cannot be opened: " + std::generic_category().message(errno));
  bytes_ = std::make_unique_for_overwrite<char[]>(size);
  size_ = std::fread(bytes_.get(), 1, size, file.get());
  if (std::ferror(file.get())) fail("cannot be read: " + std::generic_category().message(errno));
}

void SourceFile::passOver(const std::string& what) const {
  passedOver_.push_back(quoted(path_) + ": " + what);
}

void SourceFile::fail(const std::string& reason) const {
  throw Error(ErrorCode::kUnreadable, quoted(path_) + ": " + reason + ".");
}

void SourceFile::failAtLine(std::size_t line, const std::string& reason) const {
  throw Error(ErrorCode::kUnreadable, quoted(path_) + ", line " + std::to_string(line) + ": " + reason + ".");
}

void SourceFile::failAtByte(std::size_t offset, const std::string& reason) const {
  throw Error(ErrorCode::kUnreadable,
              quoted(path_) + ", byte " + std::to_string(offset) + ": " + reason + ".");
}

void SourceFile::failTooLarge(const std::string& reason) const {
  throw Error(ErrorCode::kTooLarge, quoted(path_) + ": " + reason + ".");
}

}  // namespace thicken::io
