// SPDX-License-Identifier: LGPL-2.1-or-later
//
// The program's own dealings with files; meshes are the library's.
#pragma once

#include <filesystem>
#include <string>

namespace thicken::program {

/// Throws Error(kUnwritable) when no file can be made at `path`: found before the work, not after it.
void requireFolderFor(const std::filesystem::path& path);

/// Writes `text` whole or not at all. Throws Error(kUnwritable).
void writeText(const std::filesystem::path& path, const std::string& text);

}  // namespace thicken::program
