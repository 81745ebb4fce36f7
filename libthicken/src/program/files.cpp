// SPDX-License-Identifier: LGPL-2.1-or-later
#include "program/files.h"

#include <unistd.h>

#include <fstream>
#include <system_error>

#include "thicken/error.h"

namespace thicken::program {
namespace fs = std::filesystem;
namespace {

[[noreturn]] void refuse(const fs::path& path, const std::string& reason) {
  throw Error(ErrorCode::kUnwritable, "the file \"" + path.string() + "\" cannot be written: " + reason);
}

}  // namespace

void requireFolderFor(const fs::path& path) {
  std::error_code ignored;
  if (fs::is_directory(path, ignored)) refuse(path, "it is a folder; give the name of a file");
  const fs::path folder = path.has_parent_path() ? path.parent_path() : fs::path(".");
  if (!fs::is_directory(folder, ignored))
    refuse(path, "there is no folder \"" + folder.string() + "\"; make it first");
  if (access(folder.c_str(), W_OK | X_OK) != 0)
    refuse(path, "the folder \"" + folder.string() + "\" does not allow it; choose another");
}

void writeText(const fs::path& path, const std::string& text) {
  fs::path temporary = path;
  temporary += '.';
  temporary += std::to_string(getpid());
  temporary += ".part";
  std::error_code ignored;
  std::ofstream file(temporary, std::ios::binary | std::ios::trunc);
  file << text;
  file.close();
  if (!file) {
    fs::remove(temporary, ignored);
    refuse(path, "the disk may be full, or the folder may not allow it");
  }
  std::error_code failure;
  fs::rename(temporary, path, failure);
  if (failure) {
    fs::remove(temporary, ignored);
    refuse(path, "the finished file could not take its name (" + failure.message() + ")");
  }
}

}  // namespace thicken::program
