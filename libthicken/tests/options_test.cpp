// SPDX-License-Identifier: LGPL-2.1-or-later
#include "thicken/options.h"

#include <gtest/gtest.h>

namespace thicken {
namespace {

TEST(Options, NamesAreTheWordsOfTheCommandLine) {
  EXPECT_EQ(name(Side::kNegative), "negative");
  EXPECT_EQ(name(Side::kPositive), "positive");
  EXPECT_EQ(name(Side::kBoth), "both");
  EXPECT_EQ(name(Method::kAuto), "auto");
  EXPECT_EQ(name(Method::kSweep), "sweep");
  EXPECT_EQ(name(Method::kReconstruct), "reconstruct");
}

TEST(Options, DefaultsAskForNothingButAThickness) {
  const Options options;
  EXPECT_EQ(options.thickness, 0);
  EXPECT_EQ(options.side, Side::kNegative);
  EXPECT_EQ(options.method, Method::kAuto);
  EXPECT_FALSE(options.cell || options.resolution || options.tolerance || options.smooth || options.repair);
}

}  // namespace
}  // namespace thicken
