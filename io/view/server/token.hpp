// SPDX-License-Identifier: Apache-2.0
// Secret in the address of `thaw view`. It keeps other users of a machine out.
#pragma once
#include <string>
#include <string_view>

namespace thaw {

/// Returns 128 random bits of the system as 32 hexadecimal digits. Throws IoError if there are none.
std::string newToken();

/// Compares in a time that depends on the length of `given` only.
bool sameToken(std::string_view given, std::string_view expected);

}  // namespace thaw
