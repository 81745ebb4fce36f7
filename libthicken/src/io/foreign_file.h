// SPDX-License-Identifier: LGPL-2.1-or-later
//
// Recognises files of another kind than their name says.
#pragma once

#include "io/source_file.h"

namespace thicken::io {

/// Throws Error(kUnreadable) for a file that begins as archives, texts in UTF-16 and other kinds of files do
/// that are taken for meshes: what it is, and what helps.
void refuseForeign(const SourceFile& file);

}  // namespace thicken::io
