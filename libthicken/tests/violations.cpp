// SPDX-License-Identifier: LGPL-2.1-or-later
#include <gtest/gtest.h>

#include "invariants.h"

namespace thicken {
namespace {

// In no test the sweep may stand for what a violated invariant kept from being made.
class ViolationsEndRuns : public ::testing::Environment {
 public:
  void SetUp() override { pipeline::violationsEndRuns = true; }
};
[[maybe_unused]] const auto* const kRegistered = ::testing::AddGlobalTestEnvironment(new ViolationsEndRuns);

}  // namespace
}  // namespace thicken
