// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <string_view>

namespace thaw {

/// Returns the script io/plot/plot_run.py, a part of the program.
std::string_view plotScript();

}  // namespace thaw
