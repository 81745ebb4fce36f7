// SPDX-License-Identifier: LGPL-2.1-or-later
//
// What is said where options do not fit a surface.
#pragma once

#include <gtest/gtest.h>

#include <string>

#include "thicken/error.h"
#include "thicken/thicken.h"

namespace thicken {

/// The sentence that thicken() refuses these options with, as an invalid argument; empty: it does not.
inline std::string refusalOf(const TriangleMesh& surface, const Options& options) {
  try {
    (void)thicken(surface, options);
  } catch (const Error& e) {
    EXPECT_EQ(e.code(), ErrorCode::kInvalidArgument);
    return e.what();
  }
  return {};
}

}  // namespace thicken
