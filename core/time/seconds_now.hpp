// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <chrono>

namespace thaw {

/// Returns the wall-clock time since an unknown start, s. It never runs back.
inline double secondsNow() {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

}  // namespace thaw
