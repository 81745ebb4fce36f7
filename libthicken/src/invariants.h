// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <atomic>

namespace thicken::pipeline {

/// Whether a violated invariant (ErrorCode::kInternal) ends the run, as it does in tests. Else the sweep,
/// which is audited as all is, stands for what was to be made, and the report and a warning say so.
inline std::atomic<bool> violationsEndRuns{false};

}  // namespace thicken::pipeline
