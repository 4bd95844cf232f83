// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <string_view>

namespace thaw {

/// Returns the script io/plot/plot_run.py, which is embedded in the program.
std::string_view plotScript();

}  // namespace thaw
