// SPDX-License-Identifier: Apache-2.0
// Forces and heat sources that a program registers and scenes name: [extension.NAME] with declared keys.
#pragma once
#include <functional>
#include <string>
#include <vector>

#include "core/domain/outside_forces.hpp"
#include "core/scene/scene.hpp"

namespace thaw {

/// A key of an extension's table: a number with a unit.
struct ExtensionKey {
  std::string name, unit;  ///< unit in SI, "" for none
  double standard = 0;     ///< value where the scene does not give the key
  double least = -never, most = never;
  std::string about;  ///< one line
};

/// A force or a source of heat with keys in scenes. Scenes that name it are refused by programs that have not
/// registered it, also at a restart.
struct Extension {
  std::string name;   ///< name of its table: letters, digits, _
  std::string about;  ///< one line
  std::vector<ExtensionKey> keys;
  /// Makes the source for the values of a scene.
  std::function<OutsideSource(const ExtensionSettings&)> load;
  /// Longest stable step (s) for these values; none: no limit.
  std::function<double(const ExtensionSettings&)> stepLimit = {};
};

/// Makes an extension known to all scenes that are read afterwards. Throws std::invalid_argument for a name
/// that is taken or malformed, and for an extension without a load.
void registerExtension(Extension extension);

/// Returns the extension of that name, or null.
const Extension* findExtension(const std::string& name);
/// Returns the names of all extensions.
std::vector<std::string> extensionNames();

}  // namespace thaw
