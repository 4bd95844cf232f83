// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <string>

namespace thaw {

/// Replaces default names by the paths of their tables: "heated region 'heated region 0'" becomes
/// "heated_region.0".
std::string withPaths(const std::string& message);

}  // namespace thaw
