// SPDX-License-Identifier: LGPL-2.1-or-later
#include "program/files.h"

#include <system_error>

#include "io/target_file.h"
#include "platform/files.h"
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
  const fs::path place = io::linkedPlace(path);
  if (fs::is_directory(place, ignored)) refuse(path, "it is a folder; give the name of a file");
  const fs::path folder = place.parent_path();
  if (!fs::is_directory(folder, ignored))
    refuse(path, "there is no folder \"" + folder.string() + "\"; make it first");
  if (!platform::mayWriteInto(folder))
    refuse(path, "the folder \"" + folder.string() + "\" does not allow it; choose another");
}

void writeText(const fs::path& path, const std::string& text) {
  io::TargetFile file(path);
  file.write(text);
  file.commit();
}

}  // namespace thicken::program
