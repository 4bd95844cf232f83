// SPDX-License-Identifier: Apache-2.0
// Start of the user's browser.
#pragma once
#include <string>

namespace thaw {

/// Returns whether there is a desktop: DISPLAY or WAYLAND_DISPLAY is set.
bool hasDesktop();

/// Starts xdg-open with an address and does not wait for it. Returns false if it cannot be started.
bool openBrowser(const std::string& address);

}  // namespace thaw
