// SPDX-License-Identifier: Apache-2.0
// Former names of scene keys, for the message that refuses them.
#pragma once
#include <set>
#include <string>

namespace thaw {

/// Returns the name among `known` of a key that had another name, or "" if there is none.
std::string renamedKey(const std::string& former, const std::set<std::string>& known);

}  // namespace thaw
