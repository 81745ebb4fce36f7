// SPDX-License-Identifier: LGPL-2.1-or-later
//
// Shares of the progress of a run at which its stages end.
#pragma once

namespace thicken::pipeline::progress {

inline constexpr double kChecked = 0.12, kSwept = 0.4, kShaped = 0.7, kSimplified = 0.82, kAudited = 0.92,
                        kMeasured = 0.96;

}  // namespace thicken::pipeline::progress
